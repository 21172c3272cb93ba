// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <string>
#include <string_view>

namespace limitcurve::godobject {

/// The triangles of a Wavefront OBJ text: `v` and `f` lines; faces of more corners are cut into triangles from their first
/// corner on (so they should be convex); colours, texture, normals, groups, lines and materials are passed over, and no other file is
/// opened. `scale` is the text's unit [m]. Throws std::invalid_argument "name:line:column: …, expected …".
TriangleList read_obj(std::string_view text, std::string_view name, double scale = 1.0);

/// The triangles of an STL, ascii or binary (binary if the length is what its count of faces says). Its normals are passed
/// over: the order of the corners says which side is outside. Throws std::invalid_argument, naming line and column of an ascii
/// file, the face of a binary one.
TriangleList read_stl(std::string_view bytes, std::string_view name, double scale = 1.0);

/// The triangles of a file, by its extension: .obj or .stl, in any case. `scale` is the file's unit [m]: 0.001 for a drawing in
/// millimetres. Throws std::invalid_argument, also for a file that cannot be read.
TriangleList read_triangles(const std::string& path, double scale = 1.0);

/// The surface of the solid in a file: `read_triangles`, checked by `Mesh`.
MeshSurface read_mesh(const std::string& path, double scale = 1.0);

}  // namespace limitcurve::godobject
