// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"

#include <concepts>

namespace limitcurve::godobject {

/// What a surface remembers of a finger between steps: which face it is on, so that a finger pressed deep into a thin
/// plate does not come out at the other side. A plain value, one for each finger.
struct ContactMemory {
  int face = -1;                                     ///< the face touched in the last step; < 0: none
  Eigen::Vector3d finger = Eigen::Vector3d::Zero();  ///< where the finger was then [m]
  bool known = false;                                ///< there was a last step
};

/// The surface of a solid in its body's frame. `contact` finds the surface point nearest the finger, with the outward normal
/// and the depth (≤ 0 outside), and updates the memory. The finger is finite. Bounded, without allocation or exceptions.
// clang-format off
template <class Shape>
concept Surface = requires(const Shape& shape, const Eigen::Vector3d& finger, ContactMemory& memory) {
  { shape.contact(finger, memory) } noexcept -> std::same_as<Contact>;
};
// clang-format on

}  // namespace limitcurve::godobject
