// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

/// Solids of triangles for the atlas, and what one commonly asks of them.
namespace limitcurve::stability {

using Triangle = std::array<Eigen::Vector3d, 3>;

/// A box by half its edges, about a place: twelve faces.
[[nodiscard]] godobject::TriangleList box_triangles(const Eigen::Vector3d& half, const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

[[nodiscard]] std::vector<Triangle> triangles_of(const godobject::TriangleList& list);

/// Whether a point is inside, as one tells it: it is beneath the face that it is nearest to.
[[nodiscard]] bool beneath_nearest_face(const std::vector<Triangle>& triangles, const Eigen::Vector3d& point);

/// How often the surface goes round a point, by the solid angles of its faces (A. Van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng.
/// 30:125–126, 1983): 1 inside, 0 outside.
[[nodiscard]] double winding(const std::vector<Triangle>& triangles, const Eigen::Vector3d& point);

/// Ours, asked for the first time.
[[nodiscard]] bool is_inside(const godobject::MeshSurface& surface, const Eigen::Vector3d& point);

}  // namespace limitcurve::stability
