// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/surface.hpp"

namespace limitcurve::godobject {

/// A surface's contact with the next position of a finger; the test keeps the memory.
template <Surface Shape>
[[nodiscard]] Contact touch(const Shape& surface, const Eigen::Vector3d& finger, ContactMemory& memory) {
  const Contact contact = surface.contact(finger, memory);
  memory = contact.memory;
  return contact;
}

}  // namespace limitcurve::godobject
