// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"

#include "godobject/internal/clones.hpp"

#include <cmath>

namespace limitcurve::godobject::detail {

namespace {

// Restrict counts on parameters only. Selections instead of branches, and no fused operations (-ffp-contract=off): the
// bits are those of the single step on every machine.
LIMITCURVE_CLONES
void elliptic_loop(double k, double k_twist, double mu, double arm, double reach_per_unit, std::size_t count, const double* __restrict x,
                   const double* __restrict y, const double* __restrict angle, const double* __restrict depth, double* __restrict proxy_x,
                   double* __restrict proxy_y, double* __restrict proxy_angle, double* __restrict start, double* __restrict force_x,
                   double* __restrict force_y, double* __restrict moment) noexcept {
  // The same order of operations as in Friction::grip, EllipticPull::shrink and SoftFinger::yield.
  for (std::size_t i = 0; i < count; ++i) {
    const bool touches = depth[i] > 0.0;
    const bool held = touches & (start[i] >= -1.0);  // not free now, nor before
    const double old_x = held ? proxy_x[i] : x[i];
    const double old_y = held ? proxy_y[i] : y[i];
    const double old_angle = held ? proxy_angle[i] : angle[i];
    const double pull_x = old_x - x[i];
    const double pull_y = old_y - y[i];
    const double twist = old_angle - angle[i];
    const double turn = arm * twist;
    const double square = (pull_x * pull_x + pull_y * pull_y) + turn * turn;
    const double reach = mu * (k * depth[i]) * reach_per_unit;
    const bool beyond = touches & (square > reach * reach);
    const double limit = reach * (1.0 + slip_guard);
    const bool slips = touches & (square > limit * limit);
    const double divisor = beyond ? square : 1.0;
    const double shrunk = std::sqrt(divisor) * (reach / divisor);
    const double share = beyond ? shrunk : 1.0;
    const double felt_x = pull_x * share;
    const double felt_y = pull_y * share;
    const double felt_twist = twist * share;
    force_x[i] = felt_x * k;
    force_y[i] = felt_y * k;
    moment[i] = felt_twist * k_twist;
    const double new_x = x[i] + felt_x;
    const double new_y = y[i] + felt_y;
    const double new_angle = angle[i] + felt_twist;
    // A slip that is lost in the rounding of the proxy is none.
    const bool stays = (new_x == old_x) & (new_y == old_y) & (new_angle == old_angle);
    const double slipped = stays ? -1.0 : 0.0;
    const double rests = touches ? -1.0 : -2.0;
    proxy_x[i] = slips ? new_x : old_x;
    proxy_y[i] = slips ? new_y : old_y;
    proxy_angle[i] = slips ? new_angle : old_angle;
    start[i] = slips ? slipped : rests;
  }
}

LIMITCURVE_CLONES
int any_shallow(double least, std::size_t count, const double* __restrict depth) noexcept {
  int shallow = 0;
  for (std::size_t i = 0; i < count; ++i) shallow |= static_cast<int>(depth[i] > 0.0) & static_cast<int>(depth[i] < least);
  return shallow;
}

}  // namespace

bool suits_elliptic_loop(const EllipticStep& law, double radius, std::size_t count, const double* depth) noexcept {
  // Far within the bounds that Friction sets, so that rounding decides nothing.
  constexpr double longest_arm = 1e40;
  constexpr double least = 1e5 * ContactLaw::least_unit;
  if (!(law.arm < longest_arm && law.reach_per_unit < longest_arm)) return false;
  const double per_depth = law.mu * law.stiffness;
  const double shallowest = least / per_depth + least / (per_depth * radius) + least / (per_depth * law.reach_per_unit);
  return any_shallow(shallowest, count, depth) == 0;
}

void step_elliptic(const EllipticStep& law, std::size_t count, const double* x, const double* y, const double* angle, const double* depth,
                   double* proxy_x, double* proxy_y, double* proxy_angle, double* start, double* force_x, double* force_y,
                   double* moment) noexcept {
  elliptic_loop(law.stiffness, law.twist_stiffness, law.mu, law.arm, law.reach_per_unit, count, x, y, angle, depth, proxy_x, proxy_y,
                proxy_angle, start, force_x, force_y, moment);
}

}  // namespace limitcurve::godobject::detail
