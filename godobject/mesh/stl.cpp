// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_file.hpp"

#include "godobject/mesh/tokenizer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace limitcurve::godobject {

namespace {

// Binary format: a header, the number of faces; then for each face a normal and three corners as floats, and two bytes.
constexpr std::size_t header_size = 80;
constexpr std::size_t count_size = 4;
constexpr std::size_t face_size = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

std::size_t binary_size(std::string_view bytes) {
  if (bytes.size() < header_size + count_size) return 0;
  return header_size + count_size + face_size * std::size_t{little_endian(bytes, header_size)};
}

TriangleList read_binary(std::string_view bytes, std::string_view name, double scale) {
  TriangleList list;
  list.name = name;
  const std::size_t count = (bytes.size() - header_size - count_size) / face_size;
  if (count > 100'000'000) throw std::invalid_argument(joined({name, ": ", std::to_string(count), " faces, expected up to 1e8"}));
  list.vertices.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = header_size + count_size + face_size * i;
    const int first = static_cast<int>(list.vertices.size());
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Eigen::Vector3d vertex;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto value = std::bit_cast<float>(little_endian(bytes, at + 12 * corner + 4 * axis));
        if (!std::isfinite(value)) throw std::invalid_argument(joined({list.place(i), " has a coordinate that is not a finite number"}));
        vertex[static_cast<Eigen::Index>(axis)] = static_cast<double>(value) * scale;
      }
      list.vertices.push_back(vertex);
    }
    list.faces.push_back({first, first + 1, first + 2});
  }
  return list;
}

/// Whether a word is this keyword, in upper or lower case.
bool is(std::string_view word, std::string_view keyword) {
  const auto same = [](char one, char other) { return (one >= 'A' && one <= 'Z' ? one - 'A' + 'a' : one) == other; };
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), same);
}

/// Goes to the next line that is not blank, and returns its first word.
std::string_view next_statement(Tokenizer& tokens) {
  while (tokens.next_line()) {
    const std::string_view word = tokens.next();
    if (!word.empty()) return word;
  }
  return {};
}

void require(Tokenizer& tokens, std::string_view word, std::string_view wanted) {
  if (!is(word, wanted)) tokens.expected(wanted);
}

void require_end(Tokenizer& tokens) {
  if (!tokens.next().empty()) tokens.expected("the line to end");
}

TriangleList read_ascii(std::string_view text, std::string_view name, double scale) {
  TriangleList list;
  list.name = name;
  Tokenizer tokens(text, name);
  bool in_solid = false;
  while (true) {
    const std::string_view word = next_statement(tokens);
    if (!in_solid) {
      if (word.empty() && !list.faces.empty()) return list;
      if (!is(word, "solid")) tokens.expected("solid");
      in_solid = true;
      continue;
    }
    if (is(word, "endsolid")) {
      in_solid = false;
      continue;
    }
    if (!is(word, "facet")) tokens.expected("facet or endsolid");
    const int line = tokens.line();
    require(tokens, tokens.next(), "normal");
    for (int i = 0; i < 3; ++i) {
      // Some programs write a normal of nan for a face without area.
      if (!parse_number(tokens.next())) tokens.expected("a number");
    }
    require_end(tokens);
    require(tokens, next_statement(tokens), "outer");
    require(tokens, tokens.next(), "loop");
    require_end(tokens);
    const int first = static_cast<int>(list.vertices.size());
    if (first > 1'000'000'000) tokens.fail("too many faces");
    for (int corner = 0; corner < 3; ++corner) {
      require(tokens, next_statement(tokens), "vertex");
      list.vertices.push_back(tokens.place(scale));
      require_end(tokens);
    }
    for (const std::string_view end : {"endloop", "endfacet"}) {
      require(tokens, next_statement(tokens), end);
      require_end(tokens);
    }
    list.faces.push_back({first, first + 1, first + 2});
    list.lines.push_back(line);
  }
}

}  // namespace

TriangleList read_stl(std::string_view bytes, std::string_view name, double scale) {
  if (binary_size(bytes) == bytes.size()) return read_binary(bytes, name, scale);
  // A binary file may begin with "solid", too; a text has no byte 0.
  const std::string_view text = Tokenizer::without_mark(bytes);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const bool is_text = text.find('\0') == std::string_view::npos;
  if (is_text && is(text.substr(start, 5), "solid")) return read_ascii(bytes, name, scale);
  if (is_text) throw std::invalid_argument(joined({name, ": neither a text that begins with solid nor a binary file of 84 bytes or more"}));
  const std::size_t expected = binary_size(bytes);
  throw std::invalid_argument(
      joined({name, ": ", std::to_string(bytes.size()), " bytes, expected ",
              expected > 0 ? joined({std::to_string(expected), " of a binary file with its count of faces: it is damaged"})
                           : std::string("84 or more of a binary file")}));
}

}  // namespace limitcurve::godobject
