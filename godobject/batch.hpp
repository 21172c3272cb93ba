// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/closest_point_projection.hpp"
#include "godobject/contact_batch.hpp"
#include "godobject/friction.hpp"
#include "godobject/radial_projection.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>

namespace limitcurve::godobject {

namespace detail {

/// What the vectorised loop needs to know of a finger.
struct EllipticStep {
  double stiffness;
  double twist_stiffness;
  double mu;
  double arm;             ///< by which ρ counts as a length [m]
  double reach_per_unit;  ///< r on the boundary without twist, over μP [m/N]
};

/// Whether no contact's friction is so little that it counts as none, nor a scale so large that a square may overflow: the
/// vectorised loop leaves those cases to the single step.
bool suits_elliptic_loop(const EllipticStep& law, double radius, std::size_t count, const double* depth) noexcept;

/// Ellipse and radial projection with one limit and a constant radius: a loop without branches. Bit for bit the single step.
void step_elliptic(const EllipticStep& law, std::size_t count, const double* x, const double* y, const double* angle, const double* depth,
                   double* proxy_x, double* proxy_y, double* proxy_angle, double* start, double* force_x, double* force_y,
                   double* moment) noexcept;

/// Closest point on a table with one limit and a constant radius: the vectorised loops take so many contacts at a time.
inline constexpr std::size_t table_block = 128;

/// What they need to know of a finger.
struct TableStep {
  double stiffness;
  double twist_stiffness;
  double compliance;
  double twist_compliance;
  double mu;
  double radius;
  double least_load;        ///< [N]
  double compliance_ratio;  ///< χ
  double per_compliance_ratio;
  double per_force_max;
  double per_moment_max;
  UnitWrench rim;
};

/// Steps the contacts of `block`, at most table_block: those that stick, and those that slip and slipped before, which are
/// nearly all of a scene in motion. Whether there are others; of these nothing is written, and `left` tells which. Bit for bit the
/// single step.
bool step_on_table(const Table& table, const TableStep& law, const ContactBatch& block, std::array<bool, table_block>& left) noexcept;

/// One contact of a batch by itself.
template <LimitBoundary Boundary, class Projection>
void step_one(const Friction<Boundary, Projection>& friction, const ContactBatch& batch, std::size_t i) noexcept;

}  // namespace detail

/// Steps b and c for a batch: the same results as `SoftFinger` on a plane gives, bit for bit. Input is the caller's to check:
/// nothing is refused. Allocates nothing; threads are the caller's too, who may give each a part of the arrays.
template <LimitBoundary Boundary, class Projection>
void step(const Friction<Boundary, Projection>& friction, const ContactBatch& batch) noexcept {
  const ContactLaw& law = friction.law();
  const std::size_t count = batch.size();
  const double k = law.stiffness();
  const double k_twist = law.twist_stiffness();
  const Springs& springs = law.springs();
  if constexpr (Friction<Boundary, Projection>::needs_squares_only) {
    if (law.radius_law() == nullptr && law.has_one_limit() && law.mu() * law.constant_radius() > 0.0) {
      const double arm = friction.arm_times_radius() * law.static_scale(1.0).per_radius;
      const detail::EllipticStep elliptic{k, k_twist, law.mu(), arm, friction.reach_per_unit()};
      if (detail::suits_elliptic_loop(elliptic, law.constant_radius(), count, batch.depth.data())) {
        detail::step_elliptic(elliptic, count, batch.x.data(), batch.y.data(), batch.angle.data(), batch.depth.data(), batch.proxy_x.data(),
                              batch.proxy_y.data(), batch.proxy_angle.data(), batch.start.data(), batch.force_x.data(),
                              batch.force_y.data(), batch.moment.data());
        return;
      }
    }
  }
  if constexpr (std::same_as<Boundary, Table> && std::same_as<Projection, ClosestPoint>) {
    if (law.radius_law() == nullptr && law.has_one_limit()) {
      const double radius = law.constant_radius();
      const double chi = radius * radius * springs.ratio;
      const detail::TableStep on_table{k,
                                       k_twist,
                                       springs.compliance[0],
                                       springs.compliance[1],
                                       law.mu(),
                                       radius,
                                       law.least_load(),
                                       chi,
                                       1.0 / chi,
                                       friction.per_force_max(),
                                       friction.per_moment_max(),
                                       friction.boundary().rim()};
      std::array<bool, detail::table_block> left;
      for (std::size_t from = 0; from < count; from += detail::table_block) {
        const ContactBatch block = batch.part(from, std::min(detail::table_block, count - from));
        if (!detail::step_on_table(friction.boundary(), on_table, block, left)) continue;
        const std::size_t length = block.size();
        for (std::size_t i = 0; i < length; ++i) {
          if (left[i]) detail::step_one(friction, block, i);
        }
      }
      return;
    }
  }
  for (std::size_t i = 0; i < count; ++i) detail::step_one(friction, batch, i);
}

namespace detail {

template <LimitBoundary Boundary, class Projection>
void step_one(const Friction<Boundary, Projection>& friction, const ContactBatch& batch, std::size_t i) noexcept {
  const ContactLaw& law = friction.law();
  const double k = law.stiffness();
  double& proxy_x = batch.proxy_x[i];
  double& proxy_y = batch.proxy_y[i];
  double& proxy_angle = batch.proxy_angle[i];
  if (!(batch.depth[i] > 0.0)) {
    proxy_x = batch.x[i];
    proxy_y = batch.y[i];
    proxy_angle = batch.angle[i];
    batch.start[i] = -2.0;
    batch.trend[i] = 0.0;
    batch.force_x[i] = batch.force_y[i] = batch.moment[i] = 0.0;
    return;
  }
  double& start = batch.start[i];
  if (start < -1.0) {
    proxy_x = batch.x[i];
    proxy_y = batch.y[i];
    proxy_angle = batch.angle[i];
    start = -1.0;
  }
  const double pull_x = proxy_x - batch.x[i];
  const double pull_y = proxy_y - batch.y[i];
  const double turn = proxy_angle - batch.angle[i];
  // As SoftFinger::touch.
  const Springs& springs = law.springs();
  const Pull pull{pull_x * pull_x + pull_y * pull_y, std::fabs(turn), k * batch.depth[i], start, batch.trend[i]};
  const auto holds = [&] {
    batch.force_x[i] = pull_x * springs.stiffness[0];
    batch.force_y[i] = pull_y * springs.stiffness[0];
    batch.moment[i] = turn * springs.stiffness[1];
    start = -1.0;
  };
  const auto yields = [&](const Grip& grip) {
    const double felt_x = pull_x * grip.share[0];
    const double felt_y = pull_y * grip.share[0];
    const double felt_turn = turn * grip.share[1];
    batch.force_x[i] = felt_x * springs.stiffness[0];
    batch.force_y[i] = felt_y * springs.stiffness[0];
    batch.moment[i] = felt_turn * springs.stiffness[1];
    if (!grip.slips) {
      start = -1.0;
      return;
    }
    const double new_x = grip.clamps_both || grip.share[0] < 1.0 ? batch.x[i] + felt_x : proxy_x;
    const double new_y = grip.clamps_both || grip.share[0] < 1.0 ? batch.y[i] + felt_y : proxy_y;
    const double new_angle = grip.clamps_both || grip.share[1] < 1.0 ? batch.angle[i] + felt_turn : proxy_angle;
    const bool moves = new_x != proxy_x || new_y != proxy_y || new_angle != proxy_angle;
    proxy_x = new_x;
    proxy_y = new_y;
    proxy_angle = new_angle;
    batch.trend[i] = moves ? grip.start - start : 0.0;
    start = moves ? grip.start : -1.0;
  };
  friction.grip(pull, holds, yields, [&] {
    const Grip grip = friction.grip_rarely(pull, springs);
    if (grip.share[1] == 0.0) proxy_angle = batch.angle[i];
    yields(grip);
  });
}

}  // namespace detail

}  // namespace limitcurve::godobject
