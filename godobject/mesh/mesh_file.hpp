// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_surface.hpp"
#include "triangle_list.hpp"

#include <string>
#include <string_view>

namespace limitcurve::godobject {

/// The triangles of a Wavefront OBJ text: its `v` and `f` lines. Faces with more corners are divided into triangles from the first corner,
/// so they must be convex, or at least seen whole from there. Colours, texture, normals, groups, lines and materials are ignored; no other file is opened. `scale` is the
/// text's unit [m]. Throws std::invalid_argument "name:line:column: …, expected …".
TriangleList read_obj(std::string_view text, std::string_view name, double scale = 1.0);

/// The triangles of an STL file, ASCII, keywords in any case, or binary (if the length fits its number of faces). Normals are ignored: the order of the corners
/// determines the outside. `scale` is the file's unit [m]. Throws std::invalid_argument, with line and column of an ASCII file, or the face
/// of a binary one.
TriangleList read_stl(std::string_view bytes, std::string_view name, double scale = 1.0);

/// The triangles of a file, by its extension: .obj or .stl, in upper or lower case. `scale` is the file's unit [m]: 0.001 for a drawing in
/// millimetres. Throws std::invalid_argument, also for a file that cannot be read.
TriangleList read_triangles(const std::string& path, double scale = 1.0);

/// The surface of the solid in a file: `read_triangles`, then checked and repaired by `Mesh`.
/// `body`: only this one of its bodies, the connected parts of the surface, counted from 1 in the
/// order of their first faces; 0: all, which may not touch each other. Throws
/// std::invalid_argument.
MeshSurface read_mesh(const std::string& path, double scale = 1.0, int body = 0);

}  // namespace limitcurve::godobject
