// SPDX-License-Identifier: MIT
#include "godobject/mesh/grid.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>

namespace limitcurve::godobject {

namespace {

__extension__ using Wide = __int128;  // 128 bits: three factors of 40 bits, summed

struct Steps {
  std::int64_t x, y, z;
};

Steps in_steps(const Eigen::Vector3d& value, double per_step) noexcept {
  return {static_cast<std::int64_t>(value.x() * per_step), static_cast<std::int64_t>(value.y() * per_step),
          static_cast<std::int64_t>(value.z() * per_step)};
}

Wide minor(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) noexcept {
  return static_cast<Wide>(a) * d - static_cast<Wide>(b) * c;
}

/// u · (v × w) in steps³.
Wide determinant(const Steps& u, const Steps& v, const Steps& w) noexcept {
  return u.x * minor(v.y, v.z, w.y, w.z) + u.y * minor(v.z, v.x, w.z, w.x) + u.z * minor(v.x, v.y, w.x, w.y);
}

}  // namespace

Grid::Grid(double largest) noexcept {
  int exponent = 0;
  static_cast<void>(std::frexp(largest, &exponent));
  reach_ = std::ldexp(1.0, exponent);
  step_ = std::ldexp(1.0, exponent - 38);
  per_step_ = std::ldexp(1.0, 38 - exponent);
}

Eigen::Vector3d Grid::snap(const Eigen::Vector3d& place) const noexcept {
  return {std::nearbyint(place.x() * per_step_) * step_, std::nearbyint(place.y() * per_step_) * step_,
          std::nearbyint(place.z() * per_step_) * step_};
}

int Grid::sign(const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) const noexcept {
  const double rounded = u.dot(v.cross(w));
  const Eigen::Vector3d a = v.cwiseAbs();
  const Eigen::Vector3d b = w.cwiseAbs();
  const double size = std::fabs(u.x()) * (a.y() * b.z() + a.z() * b.y()) + std::fabs(u.y()) * (a.z() * b.x() + a.x() * b.z()) +
                      std::fabs(u.z()) * (a.x() * b.y() + a.y() * b.x());
  // At most seven roundings of 1.1e-16 each: a larger value has the right sign.
  if (std::fabs(rounded) > 1e-15 * size) return rounded > 0.0 ? 1 : -1;
  const Wide exact = determinant(in_steps(u, per_step_), in_steps(v, per_step_), in_steps(w, per_step_));
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

Eigen::Vector3d Grid::cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) const noexcept {
  const Steps i = in_steps(u, per_step_);
  const Steps j = in_steps(v, per_step_);
  const double unit = step_ * step_;
  return {static_cast<double>(minor(i.y, i.z, j.y, j.z)) * unit, static_cast<double>(minor(i.z, i.x, j.z, j.x)) * unit,
          static_cast<double>(minor(i.x, i.y, j.x, j.y)) * unit};
}

void Volume::add(const Grid& grid, const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) noexcept {
  const double per_step = 1.0 / grid.step();
  // Each term is below 2^123, so that a sum of many may need more than 128 bits.
  const Wide sum = determinant(in_steps(u, per_step), in_steps(v, per_step), in_steps(w, per_step)) + low_;
  low_ = static_cast<std::uint64_t>(sum);
  high_ += static_cast<std::int64_t>(sum >> 64);
}

double Volume::value(const Grid& grid) const noexcept {
  // The sum is the volume of a solid within the reach: below 2^120.
  const Wide sum = (static_cast<Wide>(high_) << 64) + low_;
  return static_cast<double>(sum) / 6.0 * grid.step() * grid.step() * grid.step();
}

int first_sign(const Eigen::Vector3d& value) noexcept {
  for (const double component : value) {
    if (component != 0.0) return component > 0.0 ? 1 : -1;
  }
  return 0;
}

int crossing(const Grid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c) noexcept {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const auto side = [&](const Eigen::Vector3d& place) {
    const int result = grid.sign(place - a, ab, ac);
    return result != 0 ? result : first_sign(grid.cross(ab, ac));
  };
  const int before = side(from);
  if (before == side(to)) return 0;
  const Eigen::Vector3d way = to - from;
  const auto left = [&](const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    const int result = grid.sign(way, start - from, end - from);
    return result != 0 ? result : first_sign(grid.cross(way, end - start));
  };
  // A segment inward has every edge on its left, where the determinant is negative.
  const int passes = -before;
  if (left(a, b) != passes || left(b, c) != passes || left(c, a) != passes) return 0;
  return before;
}

}  // namespace limitcurve::godobject
