// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/radial_projection.hpp"
#include "limitcurve/pair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace limitcurve::godobject {

/// A boundary of straight faces: its corners in order, from (f_max, 0) to (0, m_max).
// clang-format off
template <class Boundary>
concept PolygonalBoundary = LimitBoundary<Boundary> && requires(const Boundary& boundary) {
  { boundary.vertices() } noexcept -> std::convertible_to<std::span<const UnitWrench>>;
};
// clang-format on

/// A boundary that finds the closest point itself, by what it knows of its own make-up.
// clang-format off
template <class Boundary>
concept FindsClosest = LimitBoundary<Boundary> && requires(const Boundary& boundary, UnitWrench trial, double chi, double start) {
  { boundary.closest(trial, chi, chi, start, std::uint32_t{}) } noexcept -> std::same_as<Foot>;
};
// clang-format on

/// Maximum dissipation (implicit Euler of the sliding law): the slip is normal to the limit curve at the wrench it
/// leaves. With the springs as metric that is the point of the curve closest to the trial, and a finger that keeps
/// sliding about one centre of rotation settles at eq. (17)'s wrench for it, whatever the stiffnesses. On the box of
/// uncoupled limits force and moment are clamped each on its own: the paper's §3.1.
struct ClosestPoint {
  /// Steps of the search at most; 2 to 4 as a rule, each one evaluation of the boundary.
  static constexpr int iteration_limit = 64;
  /// A Newton step this small, relative to u(1−u), is the last: what it leaves is its square.
  static constexpr double last_step = 1e-6;

  template <LimitBoundary Boundary>
  [[gnu::always_inline]] Projected operator()(const Boundary& boundary, const Trial& trial) const noexcept {
    if constexpr (PolygonalBoundary<Boundary>) {
      const double gauge = boundary.gauge(trial.wrench);
      if (!(gauge > 1.0 + slip_guard)) return Radial::onto(trial, gauge);
      return onto_polygon(boundary.vertices(), trial);
    } else {
      return onto_curve(boundary, trial);
    }
  }

  /// Where the projection of a trial with both components > 0 leads if the trial is outside: what the step of a finger asks for. Of such
  /// a trial neither component is kept. `per_chi` is one over its compliance ratio.
  template <FindsClosest Boundary>
  [[gnu::always_inline]] Foot foot(const Boundary& boundary, const Trial& trial, double per_chi) const noexcept {
    return boundary.closest(trial.wrench, trial.compliance_ratio, per_chi, trial.start, trial.piece);
  }

  /// The same if one step leads there from the last slip; else its piece is TableSide::none.
  template <class Boundary>
  [[gnu::always_inline]] Foot near_foot(const Boundary& boundary, const Trial& trial, double per_chi) const noexcept {
    return boundary.closest_in_one_step(trial.wrench, trial.compliance_ratio, per_chi, trial.start, trial.piece);
  }

  /// The same where one step does not.
  template <class Boundary>
  [[gnu::always_inline]] Foot far_foot(const Boundary& boundary, const Trial& trial, double per_chi) const noexcept {
    return boundary.search_closest(trial.wrench, trial.compliance_ratio, per_chi, trial.start);
  }

  /// Whether it is.
  [[gnu::always_inline]] static Projected onto(const Foot& found, const Trial& trial) noexcept {
    const auto [foot, normal, place, piece] = found;
    // Beyond the tangent at its foot it is outside; and if it is outside at all, it is beyond that one.
    const Pair direction{normal.slide, normal.spin};
    const Pair along_foot = direction * Pair{foot.force, foot.moment};
    const Pair along_trial = direction * Pair{trial.wrench.force, trial.wrench.moment};
    const double limit = along_foot[0] + along_foot[1];
    const double height = along_trial[0] + along_trial[1];
    // Number by number: GCC copies a pair of numbers through memory.
    return {height > limit, height > limit * (1.0 + slip_guard), {foot.force, foot.moment}, {normal.slide, normal.spin}, place, piece};
  }

 private:
  /// Newton's method in the spin fraction u for G(u) = u(x̂ − f(u)) − (1−u)χ(ŷ − m(u)), kept within a bracket. G has one
  /// root, for only one point of the curve has the trial on its outward normal; G(0) = −χŷ ≤ 0 and G(1) = x̂ ≥ 0.
  template <class Boundary>
  Projected onto_curve(const Boundary& boundary, const Trial& trial) const noexcept {
    const auto [x, y] = trial.wrench;
    const double chi = trial.compliance_ratio;
    // On an axis the root is the end itself, which no bracket closes in on.
    if (x == 0.0 || y == 0.0) {
      const SlipTwist end = x == 0.0 ? SlipTwist{0.0, 1.0} : SlipTwist{1.0, 0.0};
      const UnitWrench wrench = boundary.wrench(end);
      const double limit = wrench.force + wrench.moment;
      return {x + y > limit, x + y > limit * (1.0 + slip_guard), wrench, end};
    }
    if constexpr (FindsClosest<Boundary>) return onto(foot(boundary, trial, 1.0 / chi), trial);
    const double from = trial.start > 0.0 && trial.start < 2.0 ? trial.start : start(boundary, trial);
    double u = SlipTwist::at_place(from).spin_fraction();
    BoundaryPoint here = boundary.point(SlipTwist::of_spin_fraction(u));
    // Beyond the tangent at u it is outside for sure, and the gauge, a search of its own, is not needed.
    const double reach = (1.0 - u) * here.wrench.force + u * here.wrench.moment;
    if (!((1.0 - u) * x + u * y > reach * (1.0 + 2.0 * slip_guard))) {
      const double gauge = boundary.gauge(trial.wrench);
      if (!(gauge > 1.0 + slip_guard)) return Radial::onto(trial, gauge);
    }
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < iteration_limit; ++i) {
      const double over_force = x - here.wrench.force;
      const double over_moment = chi * (y - here.wrench.moment);
      const double residual = u * over_force - (1.0 - u) * over_moment;
      (residual > 0.0 ? high : low) = u;
      const double slope = over_force + over_moment - u * here.slope.force + (1.0 - u) * chi * here.slope.moment;
      const double step = residual / slope;
      // A step within rounding: the wrench at hand is the one.
      if (std::fabs(step) <= 2.0 * std::numeric_limits<double>::epsilon() * u * (1.0 - u)) {
        const SlipTwist slip = SlipTwist::of_spin_fraction(u);
        return {true, true, here.wrench, slip, slip.place()};
      }
      // A last step counts even where rounding leads it out of the bracket.
      const bool converged = std::fabs(step) <= std::max(last_step * u * (1.0 - u), std::numeric_limits<double>::epsilon());
      double next = u - step;
      // Now and then halve the bracket, so that it closes whatever the curve does.
      if (!converged && (!(next > low && next < high) || i % 8 == 7)) next = 0.5 * (low + high);
      u = std::clamp(next, 0.0, 1.0);
      if (converged || high - low <= std::numeric_limits<double>::epsilon() * u) break;
      here = boundary.point(SlipTwist::of_spin_fraction(u));
    }
    const SlipTwist slip = SlipTwist::of_spin_fraction(u);
    return {true, true, boundary.wrench(slip), slip, slip.place()};
  }

  /// A first guess, as a place: the slip at the closest point of the ellipse with the same intercepts, by one Newton step for
  /// the multiplier λ of f = x̂/(1+λ), m = ŷ/(1+λη) from λ = 0, taken on 1/√(f² + m²): that is straight in λ where η = 1, and
  /// nearly so elsewhere.
  template <class Boundary>
  static double start(const Boundary& boundary, const Trial& trial) noexcept {
    const double moment_ratio = boundary.moment_ratio();
    const double x = trial.wrench.force;
    const double y = trial.wrench.moment / moment_ratio;
    const double eta = 1.0 / (trial.compliance_ratio * moment_ratio * moment_ratio);
    const double square = x * x + y * y;
    // Within the ellipse, which bulges beyond most curves, the trial itself is near enough.
    const double lambda = square > 1.0 ? square * (std::sqrt(square) - 1.0) / (x * x + eta * y * y) : 0.0;
    const double slide = x * (1.0 + lambda * eta) * moment_ratio;
    const double spin = y * (1.0 + lambda);
    double place = SlipTwist{slide, spin}.place();
    return place > 0.0 && place < 2.0 ? place : 1.0;
  }

  /// Exactly, face by face: the closest of the feet. Cost: one division a slanted face.
  static Projected onto_polygon(std::span<const UnitWrench> corners, const Trial& trial) noexcept {
    const double chi = trial.compliance_ratio;
    UnitWrench best = corners.front();
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const UnitWrench foot = foot_on_face(corners[i], corners[i + 1], trial);
      const double force = trial.wrench.force - foot.force;
      const double moment = trial.wrench.moment - foot.moment;
      const double distance = force * force + chi * moment * moment;
      if (distance < best_distance) {
        best_distance = distance;
        best = foot;
      }
    }
    return {true, true, best, slip_between(trial, best)};
  }

  static UnitWrench foot_on_face(UnitWrench from, UnitWrench to, const Trial& trial) noexcept {
    const double chi = trial.compliance_ratio;
    const double along_force = to.force - from.force;     // ≤ 0
    const double along_moment = to.moment - from.moment;  // ≥ 0
    // Faces parallel to an axis leave the other component bit for bit alone.
    if (along_force == 0.0) return {from.force, std::clamp(trial.wrench.moment, from.moment, to.moment)};
    if (along_moment == 0.0) return {std::clamp(trial.wrench.force, to.force, from.force), from.moment};
    const double t = ((trial.wrench.force - from.force) * along_force + chi * (trial.wrench.moment - from.moment) * along_moment) /
                     (along_force * along_force + chi * along_moment * along_moment);
    if (t <= 0.0) return from;
    if (t >= 1.0) return to;
    return {from.force + t * along_force, from.moment + t * along_moment};
  }
};

}  // namespace limitcurve::godobject
