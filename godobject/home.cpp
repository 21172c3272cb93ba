// SPDX-License-Identifier: MIT
#include "godobject/home.hpp"

#include <algorithm>
#include <limits>

namespace limitcurve::godobject {

namespace {

/// No limit at home reaches less far than this [m, N m/N, 1] …
constexpr double least_reach = 1e-50;
/// … and none farther, nor is any pull longer: a pull over a limit squared is within 1e±200.
constexpr double farthest_reach = 1e49;

/// The depth [m] beyond which the limits are large enough; ∞ where they are too large.
double least_depth_of(const ContactLaw& law, double reach_per_unit, double arm_times_radius) {
  double least = 0.0;
  for (const ContactLaw::Scale& of_one_newton : {law.static_scale(1.0), law.dynamic_scale(1.0)}) {
    const double force_per_depth = of_one_newton.force * law.stiffness();
    // After a step a pull is no longer than the limit, and before the next by as much more as two contacts at home are apart.
    const double longest = force_per_depth * Home::farthest * reach_per_unit + 4.0 * Home::farthest +
                           2.0 * Home::farthest_twist * arm_times_radius * of_one_newton.per_radius;
    const double reach_per_depth = force_per_depth * std::min({1.0, of_one_newton.radius, reach_per_unit});
    if (!(longest <= farthest_reach && reach_per_depth > 0.0)) return std::numeric_limits<double>::infinity();
    least = std::max(least, least_reach / reach_per_depth);
  }
  return least;
}

}  // namespace

Home::Home(const ContactLaw& law, double jump_limit, double reach_per_unit, double arm_times_radius) noexcept
    : reach_(Stretch::at(Eigen::Vector3d::Zero(), 0.0)) {
  if (law.has_dampers() || law.radius_law() != nullptr) return;
  const double deepest = std::min(0.2 * jump_limit, farthest);
  const double least_depth = least_depth_of(law, reach_per_unit, arm_times_radius);
  if (!(least_depth < deepest)) return;
  // Two in a cube are 2√3 times half its side apart at most, and two depths, along whatever normals, twice the deepest: 0.75 of a leap.
  reach_ = Stretch::at(Eigen::Vector3d::Constant(0.5 * deepest), farthest_twist);
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  first_depth_ = bits(least_depth) + 1;
  depths_ = bits(deepest) - bits(least_depth);
}

}  // namespace limitcurve::godobject
