// SPDX-License-Identifier: MIT
#include "godobject/patch/patch_projection.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve::godobject {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double step_of_differences = 1e-8;
constexpr int most_newton_steps = 60;
constexpr int most_halvings = 30;

/// Ĥ and its gradient in units of μP, as functions of the velocity and κω, κ = √(k_r/k).
struct Scaled {
  const Patch& patch;
  double kappa;
  int evaluations = 0;

  struct Value {
    double power;
    Vector3d wrench;
  };
  Value operator()(const Vector3d& q) noexcept {
    ++evaluations;
    const PatchFriction friction = patch.evaluate({q.x(), q.y(), q.z() / kappa});
    return {friction.power, {friction.wrench.fx, friction.wrench.fy, friction.wrench.moment / kappa}};
  }
};

/// Two unit vectors, orthogonal to a third and to each other.
struct Tangents {
  Vector3d first;
  Vector3d second;

  explicit Tangents(const Vector3d& normal) noexcept {
    const Vector3d aside = std::fabs(normal.x()) < 0.6 ? Vector3d::UnitX() : Vector3d::UnitY();
    first = (aside - normal * normal.dot(aside)).normalized();
    second = normal.cross(first);
  }
  /// The tangents at another normal that continue these.
  void carry(const Vector3d& normal) noexcept {
    first = (first - normal * normal.dot(first)).normalized();
    second = normal.cross(first);
  }
  [[nodiscard]] Vector2d of(const Vector3d& vector) const noexcept { return {first.dot(vector), second.dot(vector)}; }
  [[nodiscard]] Vector3d at(const Vector2d& pair) const noexcept { return first * pair.x() + second * pair.y(); }
};

/// ∇²Ĥ in the basis of the tangents, by differences of the wrench at |q| = 1; made symmetric and positive.
Matrix2d hessian(Scaled& friction, const Vector3d& q, const Vector3d& wrench, const Tangents& tangents) noexcept {
  Matrix2d result;
  const Vector3d along_first = friction(q + step_of_differences * tangents.first).wrench - wrench;
  const Vector3d along_second = friction(q + step_of_differences * tangents.second).wrench - wrench;
  result.col(0) = tangents.of(along_first) / step_of_differences;
  result.col(1) = tangents.of(along_second) / step_of_differences;
  const double mixed = 0.5 * (result(0, 1) + result(1, 0));
  result(0, 1) = result(1, 0) = mixed;
  return result;
}

/// Solves (A + shift) x = b. Raises the eigenvalues if the smallest is not positive, which can only be rounding.
Vector2d solve(Matrix2d a, double shift, const Vector2d& b) noexcept {
  const double trace = std::max(a(0, 0), 0.0) + std::max(a(1, 1), 0.0) + shift;
  a(0, 0) += shift;
  a(1, 1) += shift;
  const double least = 1e-9 * trace;
  const double half_gap = std::hypot(0.5 * (a(0, 0) - a(1, 1)), a(0, 1));
  const double smallest = 0.5 * (a(0, 0) + a(1, 1)) - half_gap;
  if (smallest < least) {
    a(0, 0) += least - smallest;
    a(1, 1) += least - smallest;
  }
  const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
  return {(a(1, 1) * b.x() - a(0, 1) * b.y()) / determinant, (a(0, 0) * b.y() - a(0, 1) * b.x()) / determinant};
}

/// Largest Newton step on the unit sphere; longer ones are not reliable.
Vector2d capped(const Vector2d& step) noexcept {
  constexpr double longest = 1.0;
  const double length = step.norm();
  return length > longest ? Vector2d(step * (longest / length)) : step;
}

/// Minimises Ĥ(q)/(ŵ·q), from a q with ŵ·q > 0. Returns the ratio, the inverse of the gauge. Stops when it is below
/// `enough`.
double least_ratio(Scaled& friction, const Vector3d& w, Vector3d& q, double enough) noexcept {
  const double size = w.norm();
  const Vector3d direction = w / size;
  const Tangents tangents(direction);
  q /= direction.dot(q);
  Scaled::Value value = friction(q);
  for (int i = 0; i < most_newton_steps && value.power / size >= enough; ++i) {
    const Vector2d slope = tangents.of(value.wrench);
    if (slope.norm() <= 1e-12 * value.wrench.norm()) break;
    // Differences in the plane; the step is relative to the size of q.
    const double far = q.norm();
    Matrix2d a;
    a.col(0) = tangents.of(friction(q + step_of_differences * far * tangents.first).wrench - value.wrench) /
               (step_of_differences * far);
    a.col(1) = tangents.of(friction(q + step_of_differences * far * tangents.second).wrench - value.wrench) /
               (step_of_differences * far);
    a(0, 1) = a(1, 0) = 0.5 * (a(0, 1) + a(1, 0));
    Vector2d step = solve(a, 0.0, -slope);
    if (step.norm() > 2.0 * far) step *= 2.0 * far / step.norm();
    bool better = false;
    for (int halving = 0; halving < most_halvings && friction.evaluations < PatchProjector::most_evaluations / 2;
         ++halving, step *= 0.5) {
      const Vector3d next = q + tangents.at(step);
      const Scaled::Value there = friction(next);
      // Near the minimum the decrease is below rounding: then require a smaller slope.
      const double fall = value.power - there.power;
      better = fall >= -1e-4 * slope.dot(step) && fall > 1e-14 * value.power;
      better =
          better || (std::fabs(fall) <= 1e-11 * value.power && tangents.of(there.wrench).norm() < 0.7 * slope.norm());
      if (!better) continue;
      q = next;
      value = there;
      break;
    }
    if (!better) break;
  }
  return value.power / size;
}

/// The point closest to `w` of the hull of up to four points, if `w` is outside it. Keeps the points that bear it, at
/// most three.
Vector3d closest_of_hull(std::array<Vector3d, 4>& points, int& count, const Vector3d& w) noexcept {
  double least = std::numeric_limits<double>::infinity();
  Vector3d closest = points[0];
  int bearing = 1;
  for (int subset = 1; subset < (1 << count); ++subset) {
    std::array<Vector3d, 4> of = points;
    int size = 0;
    for (int i = 0; i < count; ++i) {
      if ((subset >> i & 1) != 0) of[static_cast<std::size_t>(size++)] = points[static_cast<std::size_t>(i)];
    }
    if (size > 3) continue;
    // The projection of w on to the point, the line or the plane through them, and whether it lies between them.
    const Vector3d apart = w - of[0];
    const Vector3d e = size > 1 ? Vector3d(of[1] - of[0]) : Vector3d(Vector3d::Zero());
    const Vector3d g = size > 2 ? Vector3d(of[2] - of[0]) : Vector3d(Vector3d::Zero());
    const Vector3d normal = e.cross(g);
    const double s = size == 2   ? apart.dot(e) / e.squaredNorm()
                     : size == 3 ? apart.cross(g).dot(normal) / normal.squaredNorm()
                                 : 0.0;
    const double t = size == 3 ? e.cross(apart).dot(normal) / normal.squaredNorm() : 0.0;
    if (!(s >= 0.0 && t >= 0.0 && s + t <= 1.0)) continue;
    const Vector3d at = of[0] + s * e + t * g;
    if (const double far = (w - at).norm(); far < least) {
      least = far;
      closest = at;
      bearing = subset;
    }
  }
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    if ((bearing >> i & 1) != 0) points[static_cast<std::size_t>(kept++)] = points[static_cast<std::size_t>(i)];
  }
  count = kept;
  return closest;
}

/// The point of the limit surface closest to a `w` outside it, by hulls of points of the surface (Gilbert, Johnson and
/// Keerthi): without derivatives, so that kinks and flat faces do not matter. The surface's support in a direction is
/// the wrench of that twist. Returns the distance that may be missing.
double approach_by_hulls(Scaled& friction, const Vector3d& w, const Vector3d& start, Vector3d& nearest) noexcept {
  constexpr int most_hulls = 100;
  std::array<Vector3d, 4> points{friction(start).wrench};
  int count = 1;
  double missing = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_hulls && count < 4; ++i) {
    nearest = closest_of_hull(points, count, w);
    const Vector3d apart = w - nearest;
    const double distance = apart.norm();
    if (!(distance > 1e-14 * w.norm())) return 0.0;
    const Vector3d support = friction(apart / distance).wrench;
    missing = (apart / distance).dot(support - nearest);
    if (missing <= 1e-13 * (1.0 + w.norm())) break;
    points[static_cast<std::size_t>(count++)] = support;
    if (count == 4) nearest = closest_of_hull(points, count, w);
  }
  return missing;
}

}  // namespace

PatchProjector::PatchProjector(const Patch& patch) : patch_(patch), spin_(patch_.wrench({0.0, 0.0, 1.0})) {}

PatchProjection PatchProjector::project(const PatchWrench& trial, double limit, double stiffness,
                                        double compliance_radius, const PatchTwist& warm) const noexcept {
  const double m0 = patch_.moment_ratio();
  const auto [mx, my] = patch_.factors();
  PatchProjection result;
  result.wrench = trial;
  // Every limit surface is convex: a trial in the hull of pure slides (an ellipse) and the two pure spins sticks.
  const double spins = trial.moment / spin_.moment;
  if (std::hypot((trial.fx - spins * spin_.fx) / mx, (trial.fy - spins * spin_.fy) / my) + std::fabs(spins) <= limit)
    return result;
  const double inside = std::hypot(trial.fx / mx, trial.fy / my, trial.moment / m0);
  // A very small limit counts as 1e-12 of the trial, so that nothing overflows.
  const double safe_limit = std::max(limit, 1e-12 * inside);
  const double kappa = compliance_radius;
  const Vector3d w = Vector3d(trial.fx, trial.fy, trial.moment / kappa) / safe_limit;
  const double size = w.norm();

  Scaled friction{patch_, kappa};
  struct Place {
    Vector3d q;
    Scaled::Value value;
    double rho;
  };
  const auto at = [&](const Vector3d& direction) -> Place {
    const Vector3d q = direction.normalized();
    const Scaled::Value value = friction(q);
    return {q, value, w.dot(q) - value.power};
  };
  // First guess: the best of the ellipsoid's normal (good for a trial near the limit), the trial itself (for one far
  // away) and the last slip.
  Place here = at({w.x() / (mx * mx), w.y() / (my * my), w.z() * kappa * kappa / (m0 * m0)});
  const auto try_too = [&](const Vector3d& direction) {
    if (!(direction.norm() > 0.0)) return;
    const Place other = at(direction);
    if (other.rho > here.rho) here = other;
  };
  try_too(w);
  try_too({warm.vx, warm.vy, kappa * warm.omega});

  const double onset = 1e-12 * (1.0 + size);
  if (!(here.rho > onset)) {
    Vector3d q = here.q;
    if (!(w.dot(q) > 0.0)) q = w;
    const double ratio = least_ratio(friction, w, q, 1.0 - 1e-9);
    here = at(q);
    result.evaluations = friction.evaluations;
    if (!(ratio < 1.0) || !(here.rho > onset)) return result;
  }

  constexpr int most_of_newton = most_evaluations - 110;  // what is left is for hulls
  const double enough = 1e-12 * (1.0 + std::min(size, here.value.wrench.norm()));
  result.converged = false;
  // Near convergence reuse the last Hessian, which saves two evaluations.
  Tangents tangents(here.q);
  Matrix2d curvature;
  double last_slope = 0.0;
  for (int i = 0; i < most_newton_steps && friction.evaluations < most_of_newton; ++i) {
    tangents.carry(here.q);
    const Vector2d slope = tangents.of(w - here.value.wrench);
    // For a trial far outside, the slope contains the trial's rounding.
    if (slope.norm() <= enough + 4.0 * std::numeric_limits<double>::epsilon() * size) {
      result.converged = true;
      break;
    }
    constexpr double quick = 0.03;
    if (!(slope.norm() < quick * last_slope)) curvature = hessian(friction, here.q, here.value.wrench, tangents);
    last_slope = slope.norm();
    Vector2d step = capped(solve(curvature, here.rho, slope));
    bool better = false;
    for (int halving = 0; halving < most_halvings && friction.evaluations < most_of_newton; ++halving, step *= 0.5) {
      const Place next = at(here.q + tangents.at(step));
      const double rise = next.rho - here.rho;
      better = rise >= 1e-4 * slope.dot(step) && rise > 0.0;
      // Near the maximum the increase is below rounding: then require a smaller slope.
      if (!better && std::fabs(rise) <= 1e-11 * (1.0 + size)) {
        better = Tangents(next.q).of(w - next.value.wrench).norm() < 0.7 * slope.norm();
      }
      if (!better) continue;
      here = next;
      break;
    }
    if (!better) {
      // No better point, except by rounding.
      result.converged = slope.norm() <= 1e-9 * (1.0 + size);
      break;
    }
  }
  Vector3d unit = here.value.wrench;
  if (!result.converged) result.converged = approach_by_hulls(friction, w, here.q, unit) <= 1e-9 * (1.0 + size);
  result.slips = true;
  result.evaluations = friction.evaluations;
  const Vector3d wrench = unit * limit;
  result.wrench = {wrench.x(), wrench.y(), wrench.z() * kappa};
  const double twist_stiffness = stiffness * kappa * kappa;
  result.slip = {(trial.fx - result.wrench.fx) / stiffness, (trial.fy - result.wrench.fy) / stiffness,
                 (trial.moment - result.wrench.moment) / twist_stiffness};
  return result;
}

}  // namespace limitcurve::godobject
