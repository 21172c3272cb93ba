// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"
#include "limitcurve/wrench.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {

namespace evaluators {
template <class Real>
struct Quadrature;
}

/// Ways to evaluate eq. (17). README, "Evaluators", has each one's domain and cost.
enum class Method {
  automatic,  ///< closed where the law has one, else ring
  closed,     ///< the law's closed form
  ring,       ///< elliptic kernels, one integral over the radius
  punch,      ///< superposition of rigid flat punches, one integral over their radius
  direct,     ///< eq. (17) as printed: the double integral over the disc
};

/// The method's name on the command line ("auto", "closed", "ring", "punch", "direct").
std::string_view to_string(Method method);

/// Whether df/ds is wanted beside the wrench. By quadrature it costs half as much again; where it is not wanted and is not at hand it is NaN.
enum class Slope { wanted, unwanted };

/// A place under the finger: ρ = r/a, and its distance from the rim, which keeps its digits where ρ → outer radius.
template <class Real>
struct RadialPosition {
  Real radius;
  Real rim;
};

/// The shape of an axisymmetric pressure under a soft finger: g(ρ) = πa² p(ρa)/P, normalised so that ∫ 2ρ g dρ = 1.
/// Laws are immutable and may be shared between threads.
///
/// A new law derives from this, in a file of its own, and gets a factory in laws.hpp and a line in law_grammar.cpp.
/// What it must satisfy is listed and tested by name in tests/limitcurve/law_suite.cpp.
class PressureLaw {
 public:
  PressureLaw();
  virtual ~PressureLaw() = default;

  /// The law in the grammar of laws.hpp; `parse_law(name())` makes an equal law.
  [[nodiscard]] virtual std::string name() const = 0;

  /// g(ρ) divided by rim^rim_exponent(). Relative error ≤ 1e-17, or the law's own documented one.
  [[nodiscard]] virtual Extended density(RadialPosition<Extended> position) const noexcept = 0;
  /// The same in double arithmetic, for `forces`: relative error ≤ 1e-15.
  [[nodiscard]] virtual double density(RadialPosition<double> position) const noexcept = 0;

  /// −1 < e ≤ 0 where the pressure at the rim grows like rim^e; 0 where it stays finite.
  [[nodiscard]] virtual Extended rim_exponent() const noexcept { return 0; }

  /// Increasing radii between which g is analytic, from where the pressure begins (0) to where it ends (1 unless the
  /// law has no rim).
  [[nodiscard]] virtual const std::vector<Extended>& breaks() const noexcept;

  /// Whether g is a polynomial between its breaks: a piece away from the COR is then integrated by a Gauss rule.
  [[nodiscard]] virtual bool has_polynomial_pieces() const noexcept { return false; }

  /// The closed form at s, if the law has one.
  [[nodiscard]] virtual std::optional<UnitForces<Extended>> closed(Extended, Slope = Slope::wanted) const noexcept { return std::nullopt; }

  /// q(t): load share of the flat punches of radius t that superpose to the law (∫ q dt = 1), divided by
  /// (1−t)^punch_exponent(); if the law has such a superposition.
  [[nodiscard]] virtual std::optional<Extended> punch_density(RadialPosition<Extended>) const noexcept { return std::nullopt; }
  [[nodiscard]] virtual Extended punch_exponent() const noexcept { return 0; }

  /// Unit wrench at s = c/a ∈ [0, ∞] without an error estimate: the closed form where the law has one, else `ring`, in double arithmetic
  /// where that keeps the promise. Relative error ≤ 1e-14 for an elementary or elliptic closed form and the Gaussian, ≤ 1e-13 for all
  /// others (in df/ds 1e-13, 1e-12; a pressure steeper than rim^(−½) gives df/ds a cusp at s = 1, where one rounding
  /// of s moves it by 1 % and more). NaN for a NaN. Never throws, allocates or locks. A loop reads a table instead.
  [[nodiscard]] virtual UnitForces<double> forces(double s, Slope slope = Slope::wanted) const noexcept;

  /// Unit wrench at s with its error, computed in extended precision. `method` must be one that `allows` grants.
  /// Relative error ≤ 1e-15 for a closed form, ≤ 1e-14 for the others, and in every case ≤ the error returned.
  [[nodiscard]] virtual WrenchEstimate evaluate(double s, Method method = Method::automatic) const noexcept;

  /// The same by Method::automatic, before it is rounded to double; its error leaves out what a law does not know of its own pressure
  /// (between samples). For tables whose tolerance the errors of `forces` come near.
  [[nodiscard]] virtual evaluators::Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept;

  /// By how much f and m may be off at any s because the pressure itself is known at samples only; part of what `evaluate` states. 0 for a law
  /// that is given by a formula.
  [[nodiscard]] virtual double profile_error() const noexcept { return 0.0; }

  /// The pressure projected on a line through the contact's centre, at the place t ≥ 0 [contact radii]: see evaluators::projection.
  [[nodiscard]] virtual evaluators::Quadrature<double> projection(double t) const noexcept;

  /// Whether the law can be evaluated by `method`.
  [[nodiscard]] virtual bool allows(Method method) const noexcept;

  /// m₀ = m(0) = ⟨ρ⟩: the moment of a pure twist in units of μPa. Closed where known; relative error ≤ 1e-15.
  [[nodiscard]] double moment_ratio() const noexcept { return evaluate(0.0).wrench.moment; }
};

/// Writes both densities of a law from one template, `pressure<Real>(RadialPosition<Real>)`.
template <class Derived>
class PressureLawOf : public PressureLaw {
 public:
  [[nodiscard]] Extended density(RadialPosition<Extended> at) const noexcept override { return derived().pressure(at); }
  [[nodiscard]] double density(RadialPosition<double> at) const noexcept override { return derived().pressure(at); }

 private:
  [[nodiscard]] const Derived& derived() const noexcept { return static_cast<const Derived&>(*this); }
};

}  // namespace limitcurve
