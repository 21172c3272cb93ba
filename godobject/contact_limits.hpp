// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"

#include <concepts>
#include <optional>
#include <stdexcept>

namespace limitcurve::godobject {

/// a(P) [m], for a single number; packs have one of their own.
template <std::floating_point Real>
[[nodiscard]] Real radius_at(const RadiusLaw& law, Real load) noexcept;

/// Throws std::invalid_argument where a box is to go with another projection than the closest point, which clamps force and moment each on its
/// own.
template <class Real>
void check_projection(const BasicFingerCurve<Real>& curve, Projection projection) {
  if (curve.is_box() && projection != Projection::closest_point)
    throw std::invalid_argument("projection: a box goes with closest-point only, which clamps force and moment each on its own");
}

/// Within which share of the sliding limit a contact that slides comes to rest (FingerParameters::rest_margin), where sliding keeps
/// `sliding_share` ∈ [0, 1] of the limit at rest: 1 where both are one.
[[nodiscard]] double rest_share(double sliding_share, double rest_margin) noexcept;

/// The friction limits of a finger over its load: force in units of μP, moment in units of μPa. With a moment coefficient the radius is the
/// one that gives it, a = μ_r P^γ/(μ m₀). Immutable.
class ContactLimits {
 public:
  /// `moment_ratio` is the limit curve's m₀. Throws std::invalid_argument naming parameter, value, unit and range; the springs, dampers and
  /// fault parameters are checked too.
  ContactLimits(const FingerParameters& parameters, double moment_ratio);

  /// At a load P [N] ≥ 0 and a ratio of stiffnesses k_l/k_r [1/m²].
  template <class Real, class Number>
  [[nodiscard]] FrictionLimits<Number> at(Number load, Number stiffness_ratio) const noexcept {
    const auto number = [](double value) { return Number(static_cast<Real>(value)); };
    const bool varies = radius_law_.has_value();
    const Number radius = varies ? radius_at(*radius_law_, load) : number(0.0);
    return {{number(at_rest_.force) * load, varies ? radius : number(at_rest_.radius)},
            {number(sliding_.force) * load, varies ? number(sliding_share_) * radius : number(sliding_.radius)},
            stiffness_ratio,
            number(force_rest_share_),
            number(moment_rest_share_),
            has_torsion_,
            varies ? &*radius_law_ : nullptr,
            load};
  }
  /// How far a finger's wrench is from the limit that acts, as a fraction: 1 without friction, 0 on the limit and while it slips.
  [[nodiscard]] double margin(const FingerCurve& curve, const FingerParameters& parameters, const FingerState& state) const noexcept;
  /// The least load [N] under which a contact at rest bears a friction force [N] and moment [N m], both ≥ 0 and finite; ∞ where none does.
  [[nodiscard]] double load_to_hold(const FingerCurve& curve, double force, double moment) const noexcept;

 private:
  // Under a load of 1 N: μ in newtons, and the radius where it does not depend on the load.
  FrictionLimit<double> at_rest_;
  FrictionLimit<double> sliding_;
  std::optional<RadiusLaw> radius_law_;  // where the radius depends on the load
  double sliding_share_;                 // of that radius, while it slips
  double force_rest_share_;              // of the sliding limit, within which a contact comes to rest
  double moment_rest_share_;             // likewise
  bool has_torsion_;
};

}  // namespace limitcurve::godobject
