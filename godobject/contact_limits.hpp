// SPDX-License-Identifier: MIT
#pragma once

// Internal: installed because other headers need it; it may change in every version.

#include "finger.hpp"
#include "finger_curve.hpp"

#include <algorithm>
#include <concepts>
#include <optional>
#include <string_view>

namespace limitcurve::godobject {

/// a(P) [m] for a single number. pack.hpp overloads it for packs.
template <std::floating_point Real>
[[nodiscard]] Real radius_at(const RadiusLaw& law, Real load) noexcept;

/// Throws std::invalid_argument for a box with a projection other than the closest point. On a box the closest point
/// clamps force and moment separately.
template <class Real>
void check_projection(const BasicFingerCurve<Real>& curve, Projection projection);

/// A sliding force of 0 (μ_d = 0), as a fraction of the sticking one: it has a direction, below rounding, and the
/// moment may keep a limit.
inline constexpr double min_sliding_fraction = 1e-15;

/// The fraction of the sliding limit within which a sliding contact comes to rest (FingerParameters::rest_margin).
/// `sliding_fraction` ∈ [0, 1] is the sliding limit divided by the sticking limit; the result is 1 if that is 1.
[[nodiscard]] double stick_fraction(double sliding_fraction, double rest_margin) noexcept;

/// A parameter out of range: name, value, unit and range are those of `out_of_range`.
struct BadParameter {
  std::string_view name;
  double value;
  std::string_view unit;
  std::string_view range;
};

/// The first bad parameter of a finger, springs, dampers and fault parameters too; none: all are good. `moment_max` [1]
/// is the limit curve's moment of a pure twist, M/(μPa); absent for a patch. Does not allocate.
[[nodiscard]] std::optional<BadParameter> first_bad(const FingerParameters& parameters,
                                                    std::optional<double> moment_max) noexcept;

/// The friction limits of a finger as a function of its load: μP and a(P). With a moment coefficient the radius follows
/// from it, a = μ_r P^γ/(μ m_max). Immutable.
class ContactLimits {
 public:
  /// Throws std::invalid_argument for the first bad parameter; of good ones it does not allocate.
  ContactLimits(const FingerParameters& parameters, std::optional<double> moment_max);

  /// The limits at a load P [N] ≥ 0, for springs of the ratio k_l/k_r [1/m²]. Numbers for every radius law, at P = 0
  /// too: a(P) counts as 1e100 m at most, and P as 1e-100 N at least where the c-curve divides by it (in float 1e30 and
  /// 1e-30).
  template <class Real, class Number>
  [[nodiscard]] FrictionLimits<Number> at(Number load, Number stiffness_ratio) const noexcept {
    using namespace arithmetic;
    const auto number = [](double value) { return Number(static_cast<Real>(value)); };
    constexpr double almost_none = sizeof(Real) == sizeof(double) ? 1e-100 : 1e-30;
    const bool varies = radius_law_.has_value();
    const auto length = [&](double value) { return number((std::min)(value, 1.0 / almost_none)); };
    const Number radius =
        varies ? smaller(radius_at(*radius_law_, load), length(1.0 / almost_none)) : length(sticking_.radius);
    return {
        {number(sticking_.force) * load, radius},
        {number(sliding_.force) * load, varies ? length(sliding_radius_fraction_) * radius : length(sliding_.radius)},
        stiffness_ratio,
        number(force_stick_fraction_),
        number(moment_stick_fraction_),
        has_torsion_,
        varies ? &*radius_law_ : nullptr,
        larger(load, number(almost_none))};
  }
  /// μ of a contact at rest, and while it slides.
  [[nodiscard]] double mu(bool slides) const noexcept { return slides ? sliding_.force : sticking_.force; }
  /// Whether the limit falls when a slip begins.
  [[nodiscard]] bool falls() const noexcept {
    return sliding_.force < sticking_.force || sliding_.radius != sticking_.radius;
  }
  /// The fraction of the sliding force limit within which a sliding contact comes to rest.
  [[nodiscard]] double force_stick_fraction() const noexcept { return force_stick_fraction_; }
  /// Margin to slip of a finger, as a fraction of the acting limit: 1 without friction, 0 on the limit and during slip.
  [[nodiscard]] double margin(const FingerCurve& curve, const FingerParameters& parameters,
                              const FingerState& state) const noexcept;
  /// The smallest load [N] under which a contact at rest carries a friction force [N] and moment [N m], both ≥ 0 and
  /// finite; ∞ if none does.
  [[nodiscard]] double load_to_hold(const FingerCurve& curve, double force, double moment) const noexcept;

 private:
  // At a load of 1 N: μ in newtons, and the radius if it does not depend on the load.
  FrictionLimit<double> sticking_;
  FrictionLimit<double> sliding_;
  std::optional<RadiusLaw> radius_law_;  // if the radius depends on the load
  double sliding_radius_fraction_;       // radius during slip divided by the radius at rest
  double force_stick_fraction_;          // fraction of the sliding limit within which a contact comes to rest
  double moment_stick_fraction_;         // the same for the moment
  bool has_torsion_;
};

}  // namespace limitcurve::godobject
