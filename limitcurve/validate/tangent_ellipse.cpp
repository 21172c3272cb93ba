// SPDX-License-Identifier: MIT
#include "limitcurve/validate/tangent_ellipse.hpp"

#include <cmath>
#include <limits>

namespace limitcurve {

namespace {

/// With (v, aω) = (x, 1) inside the rim, (1, x) outside, and H = fv + maω = D: p² = f H/v and q² = m H/(aω).
TangentEllipse touching_at(const Table& curve, bool outside, double x) noexcept {
  const Jet<double> jet = curve.view().table.jet(outside, x);
  // D′(0) = 0.
  const double per_x = x > std::numeric_limits<double>::min() ? jet.leading / x : jet.second;
  const double leading = std::sqrt(jet.value(x) * per_x);
  const double trailing = std::sqrt(jet.value(x) * jet.trailing);
  const auto [p, q] = Jet<double>{leading, trailing, 0.0, 0.0}.wrench(outside);
  return {p, q};
}

/// What a direction that has no length gives: the usual ellipse, or NaN.
TangentEllipse without_direction(const Table& curve, double length) noexcept {
  if (length == 0.0) return {curve.force_max(), curve.moment_ratio() * curve.force_max()};
  return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace

TangentEllipse tangent_ellipse(const Table& curve, SlipTwist slip) noexcept {
  const auto [slide, spin] = slip.magnitudes();
  const bool outside = slide > spin;
  const double larger = outside ? slide : spin;
  const double x = larger > 0.0 ? (outside ? spin : slide) / larger : std::numeric_limits<double>::quiet_NaN();
  return x >= 0.0 ? touching_at(curve, outside, x) : without_direction(curve, slide + spin);
}

TangentEllipse tangent_ellipse(const Table& curve, double force, double moment, double p, double q) noexcept {
  const double length = std::hypot(force / p, moment / q);
  if (!(length > 0.0 && length <= std::numeric_limits<double>::max())) return without_direction(curve, length);
  const double sliding = std::pow(force / p / length, 2);  // its share of the power
  const double turning = std::pow(moment / q / length, 2);
  const UnitWrench rim = curve.rim();
  const bool outside = sliding * rim.moment > turning * rim.force;
  const double share = outside ? turning : sliding;
  const Jet<double> end = curve.view().table.jet(outside, 0.0);
  // xD′/D = share.
  const Root<double> root = find_root<double>(
      [&](double x) noexcept -> Residual<double> {
        const Jet<double> jet = curve.view().table.jet(outside, x);
        const double up = share * jet.value(x);
        const double down = x * jet.leading;
        return {up - down, -(1.0 - share) * jet.leading - x * jet.second, -(2.0 - share) * jet.second - x * jet.third,
                4.0 * std::numeric_limits<double>::epsilon() * (up + down)};
      },
      std::fmin(1.0, std::sqrt(share * end.trailing / end.second)));
  return touching_at(curve, outside, root.x + root.step);
}

TangentEllipse tangent_ellipse(const Table& curve, double force, double moment) noexcept {
  const double length = std::hypot(force, moment);
  if (!(length > 0.0 && length <= std::numeric_limits<double>::max())) return without_direction(curve, length);
  return tangent_ellipse(curve, curve.along({std::fabs(force / length), std::fabs(moment / length)}).normal);
}

}  // namespace limitcurve
