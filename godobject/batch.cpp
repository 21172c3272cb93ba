// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"

#include "godobject/internal/clones.hpp"

#include <cmath>

namespace limitcurve::godobject::detail {

namespace {

// Restrict counts on parameters only. Selections instead of branches, and no fused operations (-ffp-contract=off): the
// bits are those of the single step on every machine.
LIMITCURVE_CLONES
void elliptic_loop(double k, double k_twist, double mu, double radius, double per_force_max, double per_moment_max, std::size_t count,
                   const double* __restrict x, const double* __restrict y, const double* __restrict angle, const double* __restrict depth,
                   double* __restrict proxy_x, double* __restrict proxy_y, double* __restrict proxy_angle, double* __restrict start,
                   double* __restrict force_x, double* __restrict force_y, double* __restrict moment) noexcept {
  // The same order of operations as in Friction::shrink and SoftFinger::rub.
  const double force_scale = k * radius * per_force_max;
  const double moment_scale = k_twist * per_moment_max;
  const double force_scale_square = force_scale * force_scale;
  const double moment_scale_square = moment_scale * moment_scale;
  for (std::size_t i = 0; i < count; ++i) {
    const bool touches = depth[i] > 0.0;
    const bool held = touches && start[i] >= -1.0;  // not free now, nor before
    const double old_x = held ? proxy_x[i] : x[i];
    const double old_y = held ? proxy_y[i] : y[i];
    const double old_angle = held ? proxy_angle[i] : angle[i];
    const double pull_x = old_x - x[i];
    const double pull_y = old_y - y[i];
    const double turn = old_angle - angle[i];
    const double square = force_scale_square * (pull_x * pull_x + pull_y * pull_y) + moment_scale_square * (turn * turn);
    const double unit = mu * (k * depth[i]) * radius;
    const double limit = unit * (1.0 + slip_guard);
    const bool slips = touches && square > limit * limit;
    const double share = slips ? unit / std::sqrt(slips ? square : 1.0) : 1.0;
    const double force = slips ? k * share : k;
    const double twist = slips ? k_twist * share : k_twist;
    force_x[i] = pull_x * force;
    force_y[i] = pull_y * force;
    moment[i] = twist * turn;
    const double new_x = x[i] + pull_x * share;
    const double new_y = y[i] + pull_y * share;
    const double new_angle = angle[i] + turn * share;
    const bool moves = slips && (new_x != old_x || new_y != old_y || new_angle != old_angle);
    proxy_x[i] = slips ? new_x : old_x;
    proxy_y[i] = slips ? new_y : old_y;
    proxy_angle[i] = slips ? new_angle : old_angle;
    start[i] = moves ? 0.0 : (touches ? -1.0 : -2.0);
  }
}

LIMITCURVE_CLONES
int any_shallow(double least, std::size_t count, const double* __restrict depth) noexcept {
  int shallow = 0;
  for (std::size_t i = 0; i < count; ++i) shallow |= static_cast<int>(depth[i] > 0.0) & static_cast<int>(depth[i] < least);
  return shallow;
}

}  // namespace

bool suits_elliptic_loop(const EllipticStep& law, std::size_t count, const double* depth) noexcept {
  // Far within the bounds that Friction sets, so that rounding decides nothing.
  constexpr double largest = 1e40;
  constexpr double least = 1e-140;
  if (!(law.stiffness * law.radius * law.per_force_max < largest && law.twist_stiffness * law.per_moment_max < largest)) return false;
  const double per_depth = law.mu * law.stiffness;
  return any_shallow(least / per_depth + least / (per_depth * law.radius), count, depth) == 0;
}

void step_elliptic(const EllipticStep& law, std::size_t count, const double* x, const double* y, const double* angle, const double* depth,
                   double* proxy_x, double* proxy_y, double* proxy_angle, double* start, double* force_x, double* force_y,
                   double* moment) noexcept {
  elliptic_loop(law.stiffness, law.twist_stiffness, law.mu, law.radius, law.per_force_max, law.per_moment_max, count, x, y, angle, depth,
                proxy_x, proxy_y, proxy_angle, start, force_x, force_y, moment);
}

}  // namespace limitcurve::godobject::detail
