// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace limitcurve::godobject {

/// Where a device holds its finger, in the world.
struct DevicePose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< x_h [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of unit length
  double twist = 0.0;  ///< turned beside that about the contact normal [rad]: of a device that tells an angle only
};

/// Where a body is that somebody else moves.
struct BodyPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< of the centre of mass [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, of unit length
};

}  // namespace limitcurve::godobject
