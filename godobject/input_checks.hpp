// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/stretch.hpp"

#include <Eigen/Core>

#include <bit>
#include <cmath>
#include <cstdint>

/// What a step asks of its input.
namespace limitcurve::godobject {

/// How far a contact is from the origin, squared, its twist and depth with it, metres as radians; no number if one of them is none.
[[nodiscard]] inline double square_from_origin(const Contact& contact, double twist) noexcept {
  return Stretch::at(contact.point, twist).square_of_all() + contact.depth * contact.depth;
}

/// Whether a normal is of unit length, to 1e-6 of its square.
[[gnu::always_inline]] [[nodiscard]] inline bool is_unit(const Eigen::Vector3d& normal) noexcept {
  return std::fabs(normal.squaredNorm() - 1.0) <= 1e-6;
}

/// Whether a time step is 0 or more.
[[gnu::always_inline]] [[nodiscard]] inline bool is_time(double time_step) noexcept {
  return std::bit_cast<std::uint64_t>(time_step) << 1U == 0 || time_step > 0.0;
}

/// Where the finger itself is.
[[nodiscard]] inline Stretch finger_of(const Contact& contact) noexcept {
  return Stretch::at(contact.point, 0.0) - Stretch::at(contact.normal, 0.0) * Pair{contact.depth, contact.depth};
}

}  // namespace limitcurve::godobject
