// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::godobject {

/// Texts one after the other.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) result += part;
  return result;
}

using Face = std::array<int, 3>;  ///< three vertices by number, anticlockwise seen from outside

/// Triangles as a file or a program has them, not yet known to bound a solid.
struct TriangleList {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<Face> faces;                ///< vertices are counted from 0
  std::vector<int> lines;                 ///< the line of the file on which each face stands, from 1; empty: it has no lines
  std::string name = "mesh";              ///< of the file, for complaints

  /// "name:line: face 3", or "name: face 3" without lines: where a face is, faces counted from 0.
  [[nodiscard]] std::string place(std::size_t face) const {
    const std::string line = face < lines.size() ? joined({":", std::to_string(lines[face])}) : std::string();
    return joined({name, line, ": face ", std::to_string(face)});
  }
};

}  // namespace limitcurve::godobject
