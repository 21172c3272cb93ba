// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/patch/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limitcurve {

namespace patch {

/// A wrench or a twist in units in which the forces of pure slides along x and y and the moment of a pure spin are 1.
struct Vector {
  double x;
  double y;
  double z;

  friend Vector operator+(const Vector& a, const Vector& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator-(const Vector& a, const Vector& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Vector& a, double scale) noexcept { return {a.x * scale, a.y * scale, a.z * scale}; }
};

}  // namespace patch

namespace {

using patch::Vector;

double dot(const Vector& a, const Vector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three points of the limit surface, and the plane T·p = 1 through them. Differences of the points keep their digits
/// when the points come close to each other.
struct Facet {
  std::array<Vector, 3> points;
  Vector first;
  Vector second;
  Vector normal;
  Vector twist;  ///< T

  explicit Facet(const std::array<Vector, 3>& of) noexcept
      : points(of),
        first(of[1] - of[0]),
        second(of[2] - of[0]),
        normal(cross(first, second)),
        twist(normal * (1.0 / dot(normal, of[0]))) {}

  /// λ of p = Σ λᵢ pᵢ.
  [[nodiscard]] std::array<double, 3> shares(const Vector& p) const noexcept {
    const double sum = dot(twist, p);
    const Vector inside = p * (1.0 / sum) - points[0];
    const double size = dot(normal, normal);
    const double b = dot(cross(inside, second), normal) / size;
    const double c = dot(cross(first, inside), normal) / size;
    return {sum * (1.0 - b - c), sum * b, sum * c};
  }
};

/// The gauge of W, and the twist of power 1 against W with the least H, which is 1/gauge.
struct Slip {
  Vector twist;
  double gauge;
};

// The smallest Σ λᵢ with Σ λᵢ pᵢ = W over points pᵢ of the surface and λᵢ ≥ 0: a linear programme of which the
// surface's support in the direction T of a facet, the wrench of the twist T, is the column to add. Its H(T) ≥ 1 bounds
// what is missing: the gauge is at least Σ λᵢ/H(T). No derivative is needed, so that kinks, flat faces and points do
// not matter.
template <class Support>
Slip slip_by_columns(const Vector& w, const Support& support) noexcept {
  constexpr int most_columns = 400;
  constexpr int most_stalls = 10;
  constexpr double enough = 1e-13;
  // The first facet: pure slides along the axes and a pure spin, with the signs of W.
  const Vector spin = support({0.0, 0.0, 1.0});
  const auto with_sign = [](const Vector& point, double share) { return share < 0.0 ? point * -1.0 : point; };
  const Vector slides = w - spin * w.z;
  Facet facet({with_sign({1.0, 0.0, 0.0}, slides.x), with_sign({0.0, 1.0, 0.0}, slides.y), with_sign(spin, w.z)});
  double least = std::numeric_limits<double>::infinity();
  int stalls = 0;
  for (int i = 0; i < most_columns; ++i) {
    const double sum = dot(facet.twist, w);
    const Vector column = support(facet.twist);
    const double power = dot(facet.twist, column);
    // A column may leave the sum as it is, where W lies on an edge of the facet; several in a row are rounding.
    stalls = sum < least ? 0 : stalls + 1;
    least = std::min(least, sum);
    if (!(power > 1.0 + enough) || stalls > most_stalls) break;
    const std::array<double, 3> now = facet.shares(w);
    const std::array<double, 3> change = facet.shares(column);
    std::size_t leaves = 3;
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(change[k] > 0.0) || !(std::max(now[k], 0.0) / change[k] < step)) continue;
      step = std::max(now[k], 0.0) / change[k];
      leaves = k;
    }
    if (leaves == 3) break;
    std::array<Vector, 3> points = facet.points;
    points[leaves] = column;
    const Facet next(points);
    if (!(dot(next.twist, w) > 0.0)) break;  // three points of one line
    facet = next;
  }
  const double sum = dot(facet.twist, w);
  return {facet.twist * (1.0 / sum), std::min(least, sum)};
}

/// Improves a twist of unit power against W, |W| = 1, until the wrench that it needs is parallel to W: Newton's method
/// for the part across W, with differences of wrenches as slopes. Near a kink of H the steps of the differences shrink;
/// on one nothing improves.
template <class Support>
Vector polished(Vector twist, const Vector& w, const Support& support) noexcept {
  constexpr double enough = 1e-14;
  constexpr double power_rounding = 1e-13;
  const Vector axis = std::fabs(w.z) < 0.5 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0};
  Vector one = cross(w, axis);
  one = one * (1.0 / std::sqrt(dot(one, one)));
  const Vector other = cross(w, one);
  /// The parts of the wrench across W, and its power.
  const auto across = [&](const Vector& at) -> Vector {
    const Vector needed = support(at);
    return {dot(needed, one), dot(needed, other), dot(needed, at)};
  };
  Vector now = across(twist);
  double miss = std::hypot(now.x, now.y);
  for (double step = 1e-6; step > 1e-15 && miss > enough;) {
    const double size = step * std::sqrt(dot(twist, twist));
    const auto slope = [&](const Vector& along) -> PatchPoint {
      const Vector ahead = across(twist + along * size);
      const Vector behind = across(twist - along * size);
      return {(ahead.x - behind.x) / (2.0 * size), (ahead.y - behind.y) / (2.0 * size)};
    };
    const PatchPoint a = slope(one);
    const PatchPoint b = slope(other);
    const double area = a.x * b.y - a.y * b.x;
    const Vector next =
        twist + one * ((now.y * b.x - now.x * b.y) / area) + other * ((now.x * a.y - now.y * a.x) / area);
    const Vector there = across(next);
    const double left = std::hypot(there.x, there.y);
    // Beside a kink less may be left than on it, but H is larger.
    if (left < 0.5 * miss && there.z <= now.z * (1.0 + power_rounding)) {
      twist = next;
      now = there;
      miss = left;
    } else {
      step /= 32.0;
    }
  }
  return twist;
}

/// The wrench about `centre` of one about the origin. A moment within its rounding is 0: a single point bears no other.
PatchWrench about(const PatchPoint& centre, const PatchWrench& wrench) noexcept {
  const double x = centre.x * wrench.fy;
  const double y = centre.y * wrench.fx;
  const double moment = wrench.moment - (x - y);
  const bool is_rounding = std::fabs(moment) <= 2.0 * patch::epsilon * (std::fabs(x) + std::fabs(y));
  return {wrench.fx, wrench.fy, is_rounding ? 0.0 : moment};
}

}  // namespace

/// The direction of a wrench about the centre of pressure, and what twists need, in the units of `Vector`.
struct Patch::Direction {
  Patch isotropic;
  double size = std::numeric_limits<double>::quiet_NaN();
  patch::Vector w{};  ///< of length 1, if size > 0 is finite

  Direction(const Patch& patch, const PatchWrench& wrench) noexcept : isotropic(patch.shape_) {
    if (std::isnan(wrench.fx) || std::isnan(wrench.fy) || std::isnan(wrench.moment)) return;
    w = {wrench.fx / patch.mx_, wrench.fy / patch.my_,
         wrench.moment == 0.0 ? 0.0 : wrench.moment / patch.moment_ratio_};
    size = std::hypot(std::hypot(w.x, w.y), w.z);
    w = w * (1.0 / size);
  }
  /// The wrench that a twist needs.
  [[nodiscard]] Vector operator()(const Vector& twist) const noexcept {
    const PatchWrench needed = isotropic.wrench({twist.x, twist.y, twist.z / isotropic.moment_ratio_});
    return {needed.fx, needed.fy, needed.moment / isotropic.moment_ratio_};
  }
  /// For size > 0 that is finite. A single point bears no moment, and its spin is free: it does not spin.
  [[nodiscard]] Slip slip() const noexcept {
    return isotropic.moment_ratio_ > 0.0 ? slip_by_columns(w, *this) : Slip{w, 1.0};
  }
};

double Patch::gauge(const PatchWrench& wrench) const noexcept {
  const Direction direction(*this, wrench);
  return direction.size > 0.0 && std::isfinite(direction.size) ? direction.size * direction.slip().gauge
                                                               : direction.size;
}

PatchSlip Patch::slip(const PatchWrench& wrench) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kink = 1e-9;  // more than Newton's method leaves where H is smooth
  constexpr double near = 1e-6;  // of the radius: beside a point, whose own force has no direction
  const PatchPoint middle = centre();
  const Direction direction(*this, about(middle, wrench));
  const double size = direction.size;
  if (!(size > 0.0 && std::isfinite(size))) return {{nan, nan, nan}, size, nan};
  const auto [first, gauge] = direction.slip();
  const bool spins = moment_ratio_ > 0.0;
  const Vector twist = spins ? polished(first, direction.w, direction) : first;
  const PatchTwist slip{twist.x / mx_ / size, twist.y / my_ / size, spins ? twist.z / moment_ratio_ / size : 0.0};
  const PatchPoint velocity = patch::velocity_at(slip, -middle.x, -middle.y);
  PatchSlip found{{velocity.x, velocity.y, slip.omega}, size * gauge, nan};
  /// A twist's error, but for the force, up to its load, of the point that `bears` under the COR.
  const auto error_of = [&](const PatchTwist& at, const PatchLoad* bears) {
    const PatchFriction needed = about_origin(at);
    const double fx = needed.wrench.fx - wrench.fx / found.gauge;
    const double fy = needed.wrench.fy - wrench.fy / found.gauge;
    const double moment = needed.wrench.moment - wrench.moment / found.gauge;
    if (bears == nullptr)
      return needed.error + std::max(std::hypot(fx, fy), spins ? std::fabs(moment) / moment_ratio_ : 0.0);
    const double more = std::max(mx_, my_) * std::max(std::hypot(fx / mx_, fy / my_) - bears->load, 0.0);
    return about_origin({at.vx + near * radius_ * at.omega, at.vy, at.omega}).error + more +
           (std::fabs(moment - (bears->x * fy - bears->y * fx)) + more * std::hypot(bears->x, bears->y)) /
               moment_ratio_;
  };
  found.error = error_of(found.twist, nullptr);
  if (found.error > kink && slip.omega != 0.0) {
    // With the COR on a point H has a kink: a whole face of wrenches slips about that very point, and beside it the
    // point's force is lost.
    const PatchPoint cor{middle.x - slip.vy / slip.omega, middle.y + slip.vx / slip.omega};
    PatchLoad nearest{};
    double distance = std::numeric_limits<double>::infinity();
    for (const auto& [x, y, load] : round_measures().concentrations) {
      const double far = std::hypot(x - cor.x, y - cor.y);
      if (far == distance) nearest.load += load;
      if (far < distance) nearest = {x, y, load}, distance = far;
    }
    const double moment = about({nearest.x, nearest.y}, wrench).moment;
    if (std::isinf(distance) || moment == 0.0) return found;  // no point, or none about which the wrench has power
    const double rate = 1.0 / moment;
    const PatchTwist about_nearest{rate * nearest.y, -rate * nearest.x, rate};
    const double error = error_of(about_nearest, &nearest);
    if (error < found.error) found = {about_nearest, found.gauge, error};
  }
  return found;
}

double load_to_hold(const Patch& patch, double mu, const PatchWrench& wrench) {
  if (!(mu >= 0.0 && std::isfinite(mu))) throw out_of_range("mu", mu, "1", "a finite number >= 0");
  if (!std::isfinite(wrench.fx)) throw out_of_range("fx", wrench.fx, "N", "a finite number");
  if (!std::isfinite(wrench.fy)) throw out_of_range("fy", wrench.fy, "N", "a finite number");
  if (!std::isfinite(wrench.moment)) throw out_of_range("moment", wrench.moment, "N m", "a finite number");
  const double gauge = patch.gauge(about(patch.centre(), wrench));
  if (!(gauge > 0.0)) return 0.0;
  return mu > 0.0 ? gauge / mu : std::numeric_limits<double>::infinity();
}

}  // namespace limitcurve
