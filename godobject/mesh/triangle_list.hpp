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

/// The parts as one string.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) result += part;
  return result;
}

using Face = std::array<int, 3>;  ///< indices of three vertices, counter-clockwise seen from outside

/// Triangles from a file or a program, not yet checked.
struct TriangleList {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<Face> faces;                ///< vertices are counted from 0
  std::vector<int> lines;                 ///< the line of each face in the file, counted from 1; empty if there are no lines
  std::string name = "mesh";              ///< of the file, for messages

  /// The position of a face in messages, faces counted from 0: "name:line: face 3", or "name: face 3" without lines.
  [[nodiscard]] std::string place(std::size_t face) const {
    const std::string line = face < lines.size() ? joined({":", std::to_string(lines[face])}) : std::string();
    return joined({name, line, ": face ", std::to_string(face)});
  }
};

}  // namespace limitcurve::godobject
