// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/closest_point_projection.hpp"
#include "godobject/contact_batch.hpp"
#include "godobject/friction.hpp"
#include "godobject/radial_projection.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/float_table.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

namespace limitcurve::godobject {

namespace detail {

/// What the loops need to know of a finger. Loads and moments are divided by k_l and k_l a: all that is compared are lengths.
struct FloatStep {
  float stiffness;        ///< k_l [N/m]
  float twist_stiffness;  ///< k_r [N m/rad]
  float mu;
  float arm;               ///< k_r/(k_l a) [m]: what a turn of one radian counts
  float compliance_ratio;  ///< χ = a²k_l/k_r
  float per_force_max;     ///< one over the intercepts of the curve, in unit wrenches
  float per_moment_max;
};

/// The same of a finger whose numbers leave floats room for their squares and quotients; else `usable` is false.
struct CheckedFloatStep {
  bool usable;
  FloatStep step;
};
CheckedFloatStep float_step(const ContactLaw& law, double force_max, double moment_max) noexcept;

/// Ellipse and radial projection, and closest point on a table, with one limit and a constant radius.
void step_floats(const FloatStep& law, const FloatContactBatch& batch) noexcept;
void step_floats(const FloatStep& law, const FloatTable& table, const FloatContactBatch& batch) noexcept;

/// What the rounding of the proxy's position adds to its distance from the finger at most [m], [rad].
inline constexpr double float_resolution = 0x1p-24;

/// One contact, its numbers floats, the arithmetic in double.
template <LimitBoundary Boundary, class Projection>
void step_floats_of(const Friction<Boundary, Projection>& friction, const FloatContactBatch& batch, std::size_t i) noexcept;

}  // namespace detail

/// Steps b and c for a batch of floats. Ellipse with the radial projection and FloatTable with the closest point, with one
/// limit and a constant radius, are stepped in single precision by vectorised loops; every other boundary and projection one
/// by one, in double arithmetic on the floats given. Allocates nothing; threads are the caller's.
///
/// The wrench lies within a few roundings of the boundary, however far the trial is out of it; a proxy moves only towards its
/// finger (so slip work ≥ 0), and only if the trial is out by more than its position's rounding explains: a held
/// contact keeps every bit from the first step on. No NaN comes out whatever comes in. A contact's result does not depend on its
/// neighbours.
template <LimitBoundary Boundary, class Projection>
void step(const Friction<Boundary, Projection>& friction, const FloatContactBatch& batch) noexcept {
  constexpr bool elliptic = std::same_as<Boundary, Ellipse> && std::same_as<Projection, Radial>;
  constexpr bool on_table = std::same_as<Boundary, FloatTable> && std::same_as<Projection, ClosestPoint>;
  if constexpr (elliptic || on_table) {
    const Boundary& boundary = friction.boundary();
    const auto [usable, law] =
        detail::float_step(friction.law(), boundary.wrench(SlipTwist{1.0, 0.0}).force, boundary.wrench(SlipTwist{0.0, 1.0}).moment);
    if (usable) {
      if constexpr (elliptic) {
        detail::step_floats(law, batch);
      } else {
        detail::step_floats(law, boundary, batch);
      }
      return;
    }
  }
  const std::size_t count = batch.size();
  for (std::size_t i = 0; i < count; ++i) detail::step_floats_of(friction, batch, i);
}

namespace detail {

template <LimitBoundary Boundary, class Projection>
void step_floats_of(const Friction<Boundary, Projection>& friction, const FloatContactBatch& batch, std::size_t i) noexcept {
  const ContactLaw& law = friction.law();
  const float x = batch.x[i];
  const float y = batch.y[i];
  const float angle = batch.angle[i];
  const double depth = static_cast<double>(batch.depth[i]);
  float& proxy_x = batch.proxy_x[i];
  float& proxy_y = batch.proxy_y[i];
  float& proxy_angle = batch.proxy_angle[i];
  float& start = batch.start[i];
  constexpr float farthest = FloatContactBatch::farthest;
  if (!(std::fabs(x) <= farthest && std::fabs(y) <= farthest && std::fabs(angle) <= farthest && !(depth > double{farthest}))) return;
  const bool touches = depth > 0.0;
  if (!touches || !(start >= -1.0F)) {
    proxy_x = x;
    proxy_y = y;
    proxy_angle = angle;
    start = touches ? -1.0F : -2.0F;
    batch.trend[i] = 0.0F;
    batch.force_x[i] = batch.force_y[i] = batch.moment[i] = 0.0F;
    return;
  }
  const double pull_x = double{proxy_x} - double{x};
  const double pull_y = double{proxy_y} - double{y};
  const double turn = double{proxy_angle} - double{angle};
  const double r = std::sqrt(pull_x * pull_x + pull_y * pull_y);
  const double rho = std::fabs(turn);
  const double load = law.stiffness() * depth;
  const auto result = friction.resolve(r, rho, load, double{start});
  const double per_metre = r > 0.0 ? 1.0 / r : 0.0;
  const double force = result.slips ? result.force * per_metre : law.stiffness();
  batch.force_x[i] = static_cast<float>(pull_x * force);
  batch.force_y[i] = static_cast<float>(pull_y * force);
  batch.moment[i] = static_cast<float>(std::copysign(result.moment, turn));
  // A trial that would hold but for the rounding of the proxy's position leaves it where it is.
  const double r_rounding = float_resolution * (std::fabs(double{proxy_x}) + std::fabs(double{proxy_y}));
  const double rho_rounding = float_resolution * std::fabs(double{proxy_angle});
  const bool slips =
      result.slips && friction.resolve(std::max(r - r_rounding, 0.0), std::max(rho - rho_rounding, 0.0), load, double{start}).slips;
  const auto towards = [](float from, float to, double distance, bool moves) {
    const auto there = static_cast<float>(double{to} + distance);
    return !moves ? from : from > to ? std::clamp(there, to, from) : std::clamp(there, from, to);
  };
  const float new_x = towards(proxy_x, x, pull_x * (result.offset * per_metre), slips && result.offset != r);
  const float new_y = towards(proxy_y, y, pull_y * (result.offset * per_metre), slips && result.offset != r);
  const float new_angle = towards(proxy_angle, angle, std::copysign(result.twist, turn), (slips || !result.slips) && result.twist != rho);
  const bool moves = slips && (new_x != proxy_x || new_y != proxy_y || new_angle != proxy_angle);
  proxy_x = new_x;
  proxy_y = new_y;
  proxy_angle = new_angle;
  const float next = moves ? static_cast<float>(result.start) : -1.0F;
  batch.trend[i] = next > 0.0F && start > 0.0F ? next - start : 0.0F;
  start = next;
}

}  // namespace detail

}  // namespace limitcurve::godobject
