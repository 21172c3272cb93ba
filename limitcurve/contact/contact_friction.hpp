// SPDX-License-Identifier: MIT
#pragma once

#include "../limit_curve.hpp"
#include "radius_law.hpp"

#include <optional>

namespace limitcurve {

/// The friction of a round contact. You must give the coefficient of friction, and either the contact radius or the
/// moment coefficient.
struct ContactFriction {
  double mu = 0.0;                           ///< coefficient of friction μ ≥ 0
  std::optional<RadiusLaw> radius_law = {};  ///< contact radius a(P); or
  std::optional<double> mu_r =
      {};              ///< moment coefficient μ_r [m/N^γ] ≥ 0, as measured: Γ = μ_r P^(1+γ), whatever the radius
  double gamma = 0.0;  ///< γ ∈ [−0.5, 1] of μ_r

  /// a(P): `radius_law`, or `RadiusLaw::of_mu_r` for a curve with the unit moment `moment_ratio` of a pure twist.
  /// Throws std::invalid_argument, with the name, for a number out of range, and unless exactly one of `radius_law` and
  /// `mu_r` is given.
  [[nodiscard]] RadiusLaw radius(double moment_ratio) const;
};

namespace detail {
/// The radius law of a contact on this curve.
template <class Curve>
[[nodiscard]] RadiusLaw radius_law_of(const Curve& curve, const ContactFriction& contact) {
  return contact.radius(contact.mu_r ? curve.wrench({0.0, 1.0}).moment : 1.0);
}
}  // namespace detail

}  // namespace limitcurve
