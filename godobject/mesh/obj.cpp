// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"

#include "godobject/mesh/tokenizer.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace limitcurve::godobject {

namespace {

/// Statements that do not belong to the triangles.
constexpr std::array<std::string_view, 14> passed_over{"vn", "vt", "vp",     "o",      "g",   "s",     "l",
                                                       "p",  "mg", "usemtl", "mtllib", "lod", "bevel", "usemap"};

/// The vertex of "7", "7/1", "7//3", "7/1/3", or counted from the last vertex, "-1".
int vertex_of(const Tokenizer& tokens, std::string_view word, std::size_t count) {
  const std::string_view digits = word.substr(0, word.find('/'));
  for (const char character : word.substr(digits.size())) {
    if (character != '/' && character != '-' && (character < '0' || character > '9'))
      tokens.expected("a vertex as in 7, 7/1, 7//3 or 7/1/3");
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const auto last = static_cast<std::int64_t>(count);
  if (error != std::errc{} || end != digits.data() + digits.size()) tokens.expected("a vertex as in 7, 7/1, 7//3 or 7/1/3");
  if (value == 0 || value > last || value < -last) {
    tokens.expected(
        joined({"a vertex before this line: 1 to ", std::to_string(last), ", or from the last, -1 to -", std::to_string(last)}));
  }
  return static_cast<int>(value > 0 ? value - 1 : last + value);
}

/// Whether the triangles from `first` on, of one polygon, look the same way. Those of a polygon that is not convex may overlap.
bool same_side(const TriangleList& list, std::size_t first) {
  const auto area = [&](const Face& face) -> Eigen::Vector3d {
    const auto at = [&](std::size_t corner) -> const Eigen::Vector3d& { return list.vertices[static_cast<std::size_t>(face[corner])]; };
    return (at(1) - at(0)).cross(at(2) - at(0));
  };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i < list.faces.size(); ++i) sum += area(list.faces[i]);
  // Corners on one line make triangles without area, of either sign by rounding.
  return std::all_of(list.faces.begin() + static_cast<std::ptrdiff_t>(first), list.faces.end(),
                     [&](const Face& face) { return area(face).dot(sum) >= -1e-9 * sum.squaredNorm(); });
}

}  // namespace

TriangleList read_obj(std::string_view text, std::string_view name, double scale) {
  TriangleList list;
  list.name = name;
  Tokenizer tokens(text, name);
  while (tokens.next_line()) {
    const std::string_view what = tokens.next();
    if (what.empty() || what.front() == '#') continue;
    if (what == "v") {
      if (list.vertices.size() >= static_cast<std::size_t>(std::numeric_limits<int>::max())) tokens.fail("too many vertices");
      list.vertices.push_back(tokens.place(scale));
      // A weight or a colour may follow.
      for (int i = 0; !tokens.next().empty(); ++i) {
        if (i == 4) tokens.expected("the line to end");
      }
    } else if (what == "f") {
      Face face{};
      int corners = 0;
      const std::size_t first = list.faces.size();
      for (std::string_view word = tokens.next(); !word.empty(); word = tokens.next()) {
        const int vertex = vertex_of(tokens, word, list.vertices.size());
        if (corners >= 3) face[1] = face[2];
        face[static_cast<std::size_t>(std::min(corners, 2))] = vertex;
        ++corners;
        if (corners < 3) continue;
        list.faces.push_back(face);
        list.lines.push_back(tokens.line());
      }
      if (corners < 3) tokens.expected("three vertices at least");
      if (corners > 3 && !same_side(list, first))
        tokens.fail("a polygon that is not convex, expected triangles or convex polygons: triangulate it");
    } else if (std::find(passed_over.begin(), passed_over.end(), what) == passed_over.end()) {
      tokens.expected("v, f, or what a mesh does without (vn, vt, o, g, s, usemtl, mtllib, …)");
    }
  }
  return list;
}

}  // namespace limitcurve::godobject
