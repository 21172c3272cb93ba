// SPDX-License-Identifier: MIT
#pragma once

#include "law.hpp"
#include "wrench.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {

/// How to evaluate eq. (17). limitcurve/README.md lists the laws for which each method works.
enum class Method {
  automatic,  ///< closed if the law has a closed form, else ring
  closed,     ///< the law's closed form
  ring,       ///< elliptic kernels, one integral over the radius
  punch,      ///< superposition of rigid flat punches, one integral over their radius
  direct,     ///< eq. (17) as printed: the double integral over the disc
  boost,      ///< as ring, by Boost.Math alone: Carlson's integrals and its tanh–sinh rule, in double
};

/// The methods' names, in their order: "auto", "closed", "ring", "punch", "direct", "boost".
std::span<const std::string_view> method_names();
std::string_view to_string(Method method);

/// Whether a function also computes the slope df/ds, which makes quadrature 50 % more expensive. If `unwanted`, df/ds
/// may be NaN.
enum class Slope { wanted, unwanted };

/// A position under the finger: its radius ρ = r/a and its distance from the rim. Use `rim` instead of 1 − ρ, which
/// loses digits near the rim.
template <class Real>
struct RadialPosition {
  Real radius;
  Real rim;
};

/// A pressure law: the shape of an axisymmetric pressure under a soft finger, g(ρ) = πa² p(ρa)/P, normalised to ∫ 2ρ g
/// dρ = 1. laws.hpp makes laws. `evaluate` gives reference values; for a control loop build a Table. Immutable: threads
/// may share a law.
///
/// To add a law: docs/extend.md. tests/limitcurve/law_suite.cpp has one test for each requirement.
class PressureLaw {
 public:
  PressureLaw();
  virtual ~PressureLaw() = default;

  /// The law's name in the grammar of laws.hpp. For a law of the grammar `parse_law(name())` gives an equal law.
  [[nodiscard]] virtual std::string name() const = 0;

  /// g(ρ) divided by rim^rim_exponent(). Relative error ≤ 1e-17, unless the law documents another.
  [[nodiscard]] virtual Extended density(RadialPosition<Extended> position) const noexcept = 0;
  /// The same in double, for `forces`: relative error ≤ 1e-15.
  [[nodiscard]] virtual double density(RadialPosition<double> position) const noexcept = 0;

  /// The exponent e ∈ (−1, 0] of the pressure at the rim, which grows like rim^e; 0 for a pressure that stays finite.
  [[nodiscard]] virtual Extended rim_exponent() const noexcept { return 0; }

  /// Increasing radii between which g is analytic, from 0 to the end of the pressure: 1, or more for a law without a
  /// rim.
  [[nodiscard]] virtual const std::vector<Extended>& breaks() const noexcept;

  /// The closed form of the unit wrench at s, if the law has one.
  [[nodiscard]] virtual std::optional<UnitForces<Extended>> closed(Extended, Slope = Slope::wanted) const noexcept {
    return std::nullopt;
  }

  /// q(t), if the law is a superposition of rigid flat punches of radii t: the fraction of the load on the punch of
  /// radius t (∫ q dt = 1), divided by (1−t)^punch_exponent().
  [[nodiscard]] virtual std::optional<Extended> punch_density(RadialPosition<Extended>) const noexcept {
    return std::nullopt;
  }
  [[nodiscard]] virtual Extended punch_exponent() const noexcept { return 0; }

  /// The unit wrench at s = c/a ∈ [0, ∞], without an error estimate. Uses the closed form if the law has one, else
  /// Method::ring, and computes in double wherever double is accurate enough. Returns NaN for NaN. Relative error ≤
  /// 1e-14 (df/ds: 1e-13) for elementary and elliptic closed forms and the Gaussian, ≤ 1e-13 (df/ds: 1e-12) for all
  /// other laws. If the pressure is steeper than rim^(−½), df/ds has a cusp at s = 1: there one rounding of s changes
  /// it by 1 % or more. Cost: nanoseconds for a closed form, up to 0.1 ms by quadrature; no exception, no allocation,
  /// no lock. In a control loop use a table.
  [[nodiscard]] virtual UnitForces<double> forces(double s, Slope slope = Slope::wanted) const noexcept;

  /// The unit wrench at |s| ∈ [0, ∞] in extended precision, with a bound on its absolute error. `allows(method)` must
  /// be true. The true error never exceeds the bound. Relative to the wrench, the bound is at most 1e-15 for a closed
  /// form, 1e-14 for ring and punch (more where long double is no wider than double: accuracy.hpp) and 1e-13 for boost;
  /// for direct there is only an absolute bound. For a law from samples, the bound includes the interpolation error.
  /// Cost: 1 µs to 0.5 ms; direct takes 10 to 100 ms.
  [[nodiscard]] virtual WrenchEstimate evaluate(double s, Method method = Method::automatic) const noexcept;

  /// The result of `evaluate` before rounding to double, by Method::automatic. Its error leaves out the interpolation
  /// error of samples (profile_error). Tables of a fine tolerance are built from it, because the error of `forces` is
  /// too large for them.
  [[nodiscard]] virtual Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept;

  /// Bound on the absolute error of f and m, at every s, that comes from a pressure known at samples only. `evaluate`
  /// includes it. 0 for a law given by a formula.
  [[nodiscard]] virtual double profile_error() const noexcept { return 0.0; }

  /// For a measured profile: which radius, in the unit of its samples, is the contact radius a. 0 for a law given by a
  /// formula.
  [[nodiscard]] virtual double rim() const noexcept { return 0.0; }

  /// What to tell the user about a measured profile, one message per line: "note: …" says what was done with the
  /// samples, "warning: …" that the last radius is probably not the rim.
  [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }

  /// The pressure projected on a line through the contact centre, at the distance t ≥ 0 [contact radii] from it: see
  /// evaluators::line_profile.
  [[nodiscard]] virtual Quadrature<double> line_profile(double t) const noexcept;

  /// Whether `evaluate` can use `method` for this law.
  [[nodiscard]] virtual bool allows(Method method) const noexcept;

  /// Moment ratio m₀ = m(0) = ⟨ρ⟩: the moment of a pure twist in units of μPa. Relative error: that of `evaluate`.
  [[nodiscard]] double moment_ratio() const noexcept { return evaluate(0.0).wrench.moment; }
};

/// Returns the law. Throws std::invalid_argument if the pointer is null, the breaks do not
/// increase from 0, or the quadrature at s = 1 misses 1e-3 of the force or of the moment.
Law checked(Law law);

/// The method of that name; throws std::invalid_argument, which lists those that the law has, for any other.
Method method_of(const PressureLaw& law, std::string_view name);

/// Base of laws: implements both densities by the derived law's template
/// `pressure<Real>(RadialPosition<Real>)`. With this and `name` a law is complete if
///  - its load is 1, ∫ 2ρ g dρ = 1, to 1e-17;
///  - `breaks` lists every kink, jump and singular ring: each radius where the pressure or one of
///    its derivatives jumps;
///  - the pressure grows towards the rim at most like rim^(−½), computed from `rim`, or has a
///    `rim_exponent`. A ring of infinite pressure within the rim costs digits: about 1e-9.
/// If a law breaks one of these rules, its quadrature misses a part of the load. `evaluate` and tables add this part to
/// their error, up to four times, and `checked` rejects the law if that exceeds 1e-3. Results cannot become NaN.
/// Method::boost, the independent reference, does not detect the missing part.
template <class Derived>
class PressureLawOf : public PressureLaw {
 public:
  [[nodiscard]] Extended density(RadialPosition<Extended> at) const noexcept override { return derived().pressure(at); }
  [[nodiscard]] double density(RadialPosition<double> at) const noexcept override { return derived().pressure(at); }

 private:
  [[nodiscard]] const Derived& derived() const noexcept { return static_cast<const Derived&>(*this); }
};

}  // namespace limitcurve
