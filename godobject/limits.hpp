// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "limitcurve/pair.hpp"

namespace limitcurve::godobject {

/// The limits of force and moment at one load: what a unit curve is scaled by.
struct Limits {
  Pair unit;                ///< μP [N], μPa [N m]
  double radius;            ///< a [m]
  double per_radius;        ///< 1/a [1/m]
  double compliance_ratio;  ///< χ
  double per_compliance_ratio;
  bool twists;  ///< there is torsional friction

  [[gnu::always_inline]] [[nodiscard]] static Limits of(ContactLaw::Scale scale) noexcept {
    const double moment_unit = scale.force * scale.radius;
    return {Pair{scale.force, moment_unit}, scale.radius, scale.per_radius, scale.compliance_ratio,
            scale.per_compliance_ratio,     scale.twists};
  }
  /// For springs that need not be the law's.
  [[nodiscard]] static Limits of(ContactLaw::Scale scale, const Springs& springs) noexcept {
    scale.compliance_ratio = scale.radius * scale.radius * springs.ratio;
    if (scale.twists) scale.per_compliance_ratio = 1.0 / scale.compliance_ratio;
    return of(scale);
  }
};

}  // namespace limitcurve::godobject
