// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limitcurve {

namespace {

/// A wrench or a twist in units in which the moment of a pure spin is 1.
struct Vector {
  double x;
  double y;
  double z;

  friend Vector operator-(const Vector& a, const Vector& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator*(const Vector& a, double scale) noexcept { return {a.x * scale, a.y * scale, a.z * scale}; }
};

double dot(const Vector& a, const Vector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three points of the limit surface, and the plane T·p = 1 through them. Differences of the points keep their digits when the points come
/// close to each other.
struct Facet {
  std::array<Vector, 3> points;
  Vector first;
  Vector second;
  Vector normal;
  Vector twist;  ///< T

  explicit Facet(const std::array<Vector, 3>& of) noexcept
      : points(of), first(of[1] - of[0]), second(of[2] - of[0]), normal(cross(first, second)), twist(normal * (1.0 / dot(normal, of[0]))) {}

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

}  // namespace

// The smallest Σ λᵢ with Σ λᵢ pᵢ = W over points pᵢ of the surface and λᵢ ≥ 0: a linear programme of which the surface's support in the
// direction T of a facet, the wrench of the twist T, is the column to add. Its H(T) ≥ 1 bounds what is missing: the gauge is at least
// Σ λᵢ/H(T). No derivative is needed, so that kinks, flat faces and points do not matter.
double Patch::gauge(const PatchWrench& wrench) const noexcept {
  constexpr int most_columns = 400;
  constexpr int most_stalls = 10;
  constexpr double enough = 1e-13;
  const double m0 = moment_ratio_;
  if (std::isnan(wrench.fx) || std::isnan(wrench.fy) || std::isnan(wrench.moment)) return std::numeric_limits<double>::quiet_NaN();
  if (m0 == 0.0) {
    return wrench.moment != 0.0 ? std::numeric_limits<double>::infinity() : std::hypot(wrench.fx / mx_, wrench.fy / my_);
  }
  const double size = std::hypot(std::hypot(wrench.fx, wrench.fy), wrench.moment / m0);
  if (!(size > 0.0 && std::isfinite(size))) return size;
  const Vector w = Vector{wrench.fx, wrench.fy, wrench.moment / m0} * (1.0 / size);
  const auto support = [&](const Vector& twist) -> Vector {
    const PatchWrench there = this->wrench({twist.x, twist.y, twist.z / m0});
    return {there.fx, there.fy, there.moment / m0};
  };
  // The first facet: pure slides along the axes and a pure spin, with the signs of W.
  const Vector spin = support({0.0, 0.0, 1.0});
  const auto with_sign = [](const Vector& point, double share) { return share < 0.0 ? point * -1.0 : point; };
  const Vector slides = w - spin * w.z;
  Facet facet({with_sign({mx_, 0.0, 0.0}, slides.x), with_sign({0.0, my_, 0.0}, slides.y), with_sign(spin, w.z)});
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
  return size * std::min(least, dot(facet.twist, w));
}

double load_to_hold(const Patch& patch, double mu, const PatchWrench& wrench) {
  if (!(mu >= 0.0 && std::isfinite(mu))) throw out_of_range("mu", mu, "1", "a finite number >= 0");
  if (!std::isfinite(wrench.fx)) throw out_of_range("fx", wrench.fx, "N", "a finite number");
  if (!std::isfinite(wrench.fy)) throw out_of_range("fy", wrench.fy, "N", "a finite number");
  if (!std::isfinite(wrench.moment)) throw out_of_range("moment", wrench.moment, "N m", "a finite number");
  const PatchPoint centre = patch.centre();
  const double gauge = patch.gauge({wrench.fx, wrench.fy, wrench.moment - (centre.x * wrench.fy - centre.y * wrench.fx)});
  if (!(gauge > 0.0)) return 0.0;
  return mu > 0.0 ? gauge / mu : std::numeric_limits<double>::infinity();
}

}  // namespace limitcurve
