// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"

#include <Eigen/Core>

#include <bit>
#include <cstdint>
#include <cstring>

namespace limitcurve::godobject {

/// A place and an angle, or the difference of two: how far the springs between proxy and finger are drawn [m, rad]. Kept as two
/// pairs, (x, y) and (z, angle), so that a step takes half as many instructions; the bits are those of four numbers. Inlined by
/// force: a compiler that has many fingers in one file would rather call, through memory.
class Stretch {
 public:
  [[gnu::always_inline]] static Stretch at(const Eigen::Vector3d& place, double angle) noexcept {
    return {Pair{place.x(), place.y()}, Pair{place.z(), angle}};
  }
  /// Of four numbers in a row: a place, and the angle that follows it in memory. Two at a time by name, as `store` writes them: left to
  /// itself a compiler for wider registers writes all four at once, and the next step waits to read two of them.
  [[gnu::always_inline]] static Stretch load(const void* four) noexcept {
    Pair xy;
    Pair z_twist;
    std::memcpy(&xy, four, sizeof xy);
    std::memcpy(&z_twist, static_cast<const char*>(four) + sizeof xy, sizeof z_twist);
    return {xy, z_twist};
  }
  [[gnu::always_inline]] void store(void* four) const noexcept {
    std::memcpy(four, &xy_, sizeof xy_);
    std::memcpy(static_cast<char*>(four) + sizeof xy_, &z_twist_, sizeof z_twist_);
  }
  [[gnu::always_inline]] void get_place(Eigen::Vector3d& place) const noexcept { place = {xy_[0], xy_[1], z_twist_[0]}; }

  [[nodiscard]] double twist() const noexcept { return z_twist_[1]; }  ///< [rad]
  [[gnu::always_inline]] [[nodiscard]] Stretch with_twist(double twist) const noexcept { return {xy_, Pair{z_twist_[0], twist}}; }
  /// Of the length without the twist [m²].
  [[gnu::always_inline]] [[nodiscard]] double square() const noexcept {
    const Pair squares = xy_ * xy_;
    return (squares[0] + squares[1]) + z_twist_[0] * z_twist_[0];
  }

  /// Of all four numbers, metres as radians.
  [[gnu::always_inline]] [[nodiscard]] double square_of_all() const noexcept {
    const Pair squares = xy_ * xy_ + z_twist_ * z_twist_;
    return squares[0] + squares[1];
  }
  /// Whether none of its four numbers is larger, but for its sign, than those of `limits`. One that is not a number is.
  [[gnu::always_inline]] [[nodiscard]] bool is_within(const Stretch& limits) const noexcept {
    return are_within(xy_, limits.xy_, z_twist_, limits.z_twist_);
  }

  /// Its part along a surface with this unit normal, whose twist is 0.
  [[gnu::always_inline]] [[nodiscard]] Stretch along(const Stretch& normal) const noexcept {
    const double height = along_normal(normal);
    return {xy_ - normal.xy_ * height, z_twist_ - normal.z_twist_ * height};
  }
  /// A part of a stretch, and the square of its length without the twist [m²].
  struct Part;
  /// The same with the square of its length, by Pythagoras, which need not wait for the part itself; and where all of it is along the
  /// surface, as on a plane, or all but rounding, not for the normal's share either. The steps of one finger wait for it.
  [[gnu::always_inline]] [[nodiscard]] Part part_along(const Stretch& normal) const noexcept;

  [[gnu::always_inline]] friend Stretch operator+(const Stretch& one, const Stretch& other) noexcept {
    return {one.xy_ + other.xy_, one.z_twist_ + other.z_twist_};
  }
  [[gnu::always_inline]] friend Stretch operator-(const Stretch& one, const Stretch& other) noexcept {
    return {one.xy_ - other.xy_, one.z_twist_ - other.z_twist_};
  }
  /// Place and twist by a factor each.
  [[gnu::always_inline]] friend Stretch operator*(const Stretch& stretch, Pair factors) noexcept {
    return {stretch.xy_ * factors[0], stretch.z_twist_ * factors};
  }
  [[gnu::always_inline]] friend bool operator==(const Stretch& one, const Stretch& other) noexcept {
    // As a rule the first number tells.
    if (__builtin_islessgreater(one.xy_[0], other.xy_[0])) [[likely]]
      return false;
    return same(one.xy_, other.xy_, one.z_twist_, other.z_twist_);
  }

  /// This where the share of place, of twist is below 1; elsewhere the other.
  [[gnu::always_inline]] [[nodiscard]] Stretch where_less(Pair share, const Stretch& other) const noexcept {
    const PairMask less = share < 1.0;
    return {PairMask{less[0], less[0]} ? xy_ : other.xy_, less ? z_twist_ : other.z_twist_};
  }

 private:
  [[gnu::always_inline]] [[nodiscard]] double along_normal(const Stretch& normal) const noexcept {
    const Pair products = normal.xy_ * xy_ + normal.z_twist_ * z_twist_;
    return products[0] + products[1];
  }

  Stretch(Pair xy, Pair z_twist) noexcept : xy_(xy), z_twist_(z_twist) {}

  Pair xy_;
  Pair z_twist_;
};

struct Stretch::Part {
  Stretch stretch;
  double square;
};

inline Stretch::Part Stretch::part_along(const Stretch& normal) const noexcept {
  const double height = along_normal(normal);
  const double whole = square();
  // Pair by pair: GCC keeps a stretch that is assigned as one in memory.
  Pair xy = xy_;
  Pair z_twist = z_twist_;
  double part_square = whole;
  if (std::bit_cast<std::uint64_t>(height) << 1U != 0) [[unlikely]] {
    const Stretch part = along(normal);
    xy = part.xy_;
    z_twist = part.z_twist_;
    // |o − n h|² = |o|² − h²(2 − |n|²), and |n| may be a little off 1.
    const double lost = height * height * (2.0 - normal.square());
    // Less than half of the last digit: the difference is the whole. As long as it does not cancel.
    if (lost > 0x1p-55 * whole) part_square = lost > 0.0625 * whole ? part.square() : whole - lost;
  }
  return {Stretch(xy, z_twist), part_square};
}

}  // namespace limitcurve::godobject
