// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"

#include <Eigen/Core>

namespace limitcurve::godobject {

/// A place and an angle, or the difference of two: how far the springs between proxy and finger are drawn [m, rad]. Kept as two
/// pairs, (x, y) and (z, angle), so that a step takes half as many instructions; the bits are those of four numbers. Inlined by
/// force: a compiler that has many fingers in one file would rather call, through memory.
class Stretch {
 public:
  [[gnu::always_inline]] static Stretch at(const Eigen::Vector3d& place, double angle) noexcept {
    return {Pair{place.x(), place.y()}, Pair{place.z(), angle}};
  }
  [[gnu::always_inline]] void get(Eigen::Vector3d& place, double& angle) const noexcept {
    place = {xy_[0], xy_[1], z_twist_[0]};
    angle = z_twist_[1];
  }
  [[gnu::always_inline]] void get_place(Eigen::Vector3d& place) const noexcept { place = {xy_[0], xy_[1], z_twist_[0]}; }

  [[nodiscard]] double twist() const noexcept { return z_twist_[1]; }  ///< [rad]
  /// Of the length without the twist [m²].
  [[gnu::always_inline]] [[nodiscard]] double square() const noexcept {
    const Pair squares = xy_ * xy_;
    return (squares[0] + squares[1]) + z_twist_[0] * z_twist_[0];
  }

  /// Of all four numbers, for two at once.
  [[gnu::always_inline]] [[nodiscard]] static Pair squares(const Stretch& one, const Stretch& other) noexcept {
    const Pair first = one.xy_ * one.xy_ + one.z_twist_ * one.z_twist_;
    const Pair second = other.xy_ * other.xy_ + other.z_twist_ * other.z_twist_;
    return Pair{first[0], second[0]} + Pair{first[1], second[1]};
  }

  /// Its part along a surface with this unit normal.
  [[gnu::always_inline]] [[nodiscard]] Stretch along(const Eigen::Vector3d& normal) const noexcept {
    const double height = along_normal(normal);
    return {xy_ - Pair{normal.x(), normal.y()} * height, z_twist_ - Pair{normal.z(), 0.0} * height};
  }
  /// Of that part's length [m²], given the normal's own square, which may be a little off 1. By Pythagoras, which need not wait for the
  /// part itself; and where all of it is along the surface but for rounding, as on a plane, not for the normal's share either. The steps
  /// of one finger wait for it.
  [[gnu::always_inline]] [[nodiscard]] double square_along(const Eigen::Vector3d& normal, double normal_square) const noexcept {
    const double height = along_normal(normal);
    const double whole = square();
    // |o − n h|² = |o|² − h²(2 − |n|²).
    const double lost = height * height * (2.0 - normal_square);
    // Less than half of the last digit: the difference is the whole.
    if (lost <= 0x1p-55 * whole) [[likely]]
      return whole;
    // As long as it does not cancel.
    if (lost > 0.0625 * whole) [[unlikely]]
      return along(normal).square();
    return whole - lost;
  }

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
    return same(one.xy_, other.xy_, one.z_twist_, other.z_twist_);
  }

  /// This where the share of place, of twist is below 1; elsewhere the other.
  [[gnu::always_inline]] [[nodiscard]] Stretch where_less(Pair share, const Stretch& other) const noexcept {
    const PairMask less = share < 1.0;
    return {PairMask{less[0], less[0]} ? xy_ : other.xy_, less ? z_twist_ : other.z_twist_};
  }

 private:
  [[gnu::always_inline]] [[nodiscard]] double along_normal(const Eigen::Vector3d& normal) const noexcept {
    const Pair products = Pair{normal.x(), normal.y()} * xy_ + Pair{normal.z(), 0.0} * z_twist_;
    return products[0] + products[1];
  }

  Stretch(Pair xy, Pair z_twist) noexcept : xy_(xy), z_twist_(z_twist) {}

  Pair xy_;
  Pair z_twist_;
};

}  // namespace limitcurve::godobject
