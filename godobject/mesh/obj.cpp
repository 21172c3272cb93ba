// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"

#include "godobject/mesh/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

namespace limitcurve::godobject {

namespace {

/// What a text may hold that is no part of its triangles.
constexpr std::array<std::string_view, 14> passed_over{"vn", "vt", "vp",     "o",      "g",   "s",     "l",
                                                       "p",  "mg", "usemtl", "mtllib", "lod", "bevel", "usemap"};

/// The vertex of "7", "7/1", "7//3", "7/1/3", or counted from the last vertex, "-1".
int vertex_of(const Words& words, std::string_view word, std::size_t count) {
  const std::string_view digits = word.substr(0, word.find('/'));
  for (const char character : word.substr(digits.size())) {
    if (character != '/' && character != '-' && (character < '0' || character > '9'))
      words.expected("a vertex as in 7, 7/1, 7//3 or 7/1/3");
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const auto last = static_cast<std::int64_t>(count);
  if (error != std::errc{} || end != digits.data() + digits.size()) words.expected("a vertex as in 7, 7/1, 7//3 or 7/1/3");
  if (value == 0 || value > last || value < -last) {
    words.expected(joined({"a vertex before this line: 1 to ", std::to_string(last), ", or from the last, -1 to -", std::to_string(last)}));
  }
  return static_cast<int>(value > 0 ? value - 1 : last + value);
}

}  // namespace

TriangleList read_obj(std::string_view text, std::string_view name, double scale) {
  TriangleList list;
  list.name = name;
  Words words(text, name);
  while (words.next_line()) {
    const std::string_view what = words.next();
    if (what.empty() || what.front() == '#') continue;
    if (what == "v") {
      if (list.vertices.size() >= static_cast<std::size_t>(std::numeric_limits<int>::max())) words.fail("too many vertices");
      list.vertices.push_back(words.place(scale));
      // A weight or a colour may follow.
      for (int i = 0; !words.next().empty(); ++i) {
        if (i == 4) words.expected("the line to end");
      }
    } else if (what == "f") {
      Face face{};
      int corners = 0;
      for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const int vertex = vertex_of(words, word, list.vertices.size());
        if (corners >= 3) face[1] = face[2];
        face[static_cast<std::size_t>(std::min(corners, 2))] = vertex;
        ++corners;
        if (corners < 3) continue;
        list.faces.push_back(face);
        list.lines.push_back(words.line());
      }
      if (corners < 3) words.expected("three vertices at least");
    } else if (std::find(passed_over.begin(), passed_over.end(), what) == passed_over.end()) {
      words.expected("v, f, or what a mesh does without (vn, vt, o, g, s, usemtl, mtllib, …)");
    }
  }
  return list;
}

}  // namespace limitcurve::godobject
