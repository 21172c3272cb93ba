// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"

namespace limitcurve::godobject {

/// The spin of a device about the normal of the surface that it moves over: ∫ω·n dt, the normal being the present one. This is the path
/// integral whose power is M·dα/dt for a moment M about the normal: moving without turning gives none, on any surface, and the angle that a
/// device has to begin with does not matter. A `SoftFinger` has one in it; give a batch its angle. Plain data.
struct Spin {
  double angle = 0.0;   ///< [rad] since the first sample, unwrapped
  Numbers normal{};     ///< of the last sample
  Numbers axis{};       ///< of the last orientation, a unit quaternion: its vector part …
  double scalar = 1.0;  ///< … and its scalar part
  bool started = false;

  /// After the next sample: the device's orientation and the outward normal, both of unit length and in the surface's frame. Between two samples
  /// the device turns about one axis by less than π, and the normal counts as the mean of both: the error of a path falls with the square of
  /// the time step, and is 0 where the normal stays or turns evenly about the axis.
  [[nodiscard]] Spin moved(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& present_normal) const noexcept;
};

}  // namespace limitcurve::godobject
