// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

/// Solids of triangles for the atlas, and the usual queries on them.
namespace limitcurve::stability {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// A box with given half edges and centre: twelve faces.
[[nodiscard]] godobject::TriangleList box_triangles(const Eigen::Vector3d& half, const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

[[nodiscard]] std::vector<Triangle> triangles_of(const godobject::TriangleList& list);

/// The usual inside test: the point is below its nearest face.
[[nodiscard]] bool beneath_nearest_face(const std::vector<Triangle>& triangles, const Eigen::Vector3d& point);

/// The winding number of a surface about a point, by the solid angles of its faces (A. Van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng.
/// 30:125–126, 1983): 1 inside, 0 outside.
[[nodiscard]] double winding(const std::vector<Triangle>& triangles, const Eigen::Vector3d& point);

/// Ours, on its first call.
[[nodiscard]] bool is_inside(const godobject::MeshSurface& surface, const Eigen::Vector3d& point);

}  // namespace limitcurve::stability
