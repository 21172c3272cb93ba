// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limitcurve::godobject {

/// Where a finger touches a surface: the result of step a (paper, eq. 7).
struct Contact {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< x_g, the surface point nearest the finger [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward unit normal there
  double depth = 0.0;                                 ///< d [m], how far the finger is beneath the surface; ≤ 0 outside
};

}  // namespace limitcurve::godobject
