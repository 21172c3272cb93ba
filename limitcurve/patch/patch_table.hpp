// SPDX-License-Identifier: MIT
#pragma once

#include "patch.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve {

/// What a table of a patch holds, and its file.
struct PatchTableContents {
  /// G, ∂G/∂i, ∂G/∂j and ∂²G/∂i∂j at a node of a face: the power, and its derivatives by the number of cells.
  using Node = std::array<double, 4>;

  std::string name;  ///< of the patch
  double tolerance = 0.0;
  double checked_error = 0.0;
  double own_error = 0.0;     ///< of the patch that the table was made from
  PatchPoint centre;          ///< of pressure [m]
  double radius = 0.0;        ///< [m]
  double moment_ratio = 0.0;  ///< [m]
  PatchPoint factors{1.0, 1.0};
  int cells = 0;  ///< along the side of a face, n
  /// Of the faces v_x = 1, v_y = 1 and m₀ω = 1 in turn, each (n + 1) × (n + 1) nodes (i, j), j fastest. They are at
  /// −1 + 2i/n and −1 + 2j/n of the next two of the components v_x, v_y, m₀ω, in cyclic order.
  std::vector<Node> nodes;
};

/// The facts that are numbers, with the names that files give them, in their order there.
template <class Contents>
auto numbers_of(Contents& of) {
  return std::array{std::pair("tolerance", &of.tolerance),
                    std::pair("checked_error", &of.checked_error),
                    std::pair("own_error", &of.own_error),
                    std::pair("centre_x", &of.centre.x),
                    std::pair("centre_y", &of.centre.y),
                    std::pair("radius", &of.radius),
                    std::pair("moment_ratio", &of.moment_ratio),
                    std::pair("mx", &of.factors.x),
                    std::pair("my", &of.factors.y)};
}

/// The limit surface of any patch as a table. A wrench costs about 40 ns whatever the shape of the patch, so that a
/// loop of 1 kHz can use a tactile image of any size, or an ellipse of a law without closed form. Everything that takes
/// a Patch takes a table. Copies share the table, and so may threads.
///
/// The error of the table is the largest of |ΔF|, in units of μP, and |ΔM|, in units of μP m₀ about the centre of
/// pressure, over all twists. Slides along x and y and a pure spin are exact. The wrench is a continuous function of
/// the twist, and the power a convex one wherever the search for the error looked. The mathematics is at the head of
/// patch_table.cpp.
class PatchTable : public Patch {
 public:
  /// The smallest table whose error is at most `tolerance`, in [1e-5, 0.1]. Throws std::invalid_argument if none of
  /// `most_bytes` is: where the load is at points, on a line or beside the corners of a slim pad, the wrench changes
  /// too fast. The message has the error of the finest, or says that the patch has kinks. Cost: 7 000 to 2 million
  /// wrenches of the patch. Calls `between_samples` (interruption.hpp). `name` is that of the patch, in files and
  /// messages.
  static PatchTable build(const Patch& patch, double tolerance = default_tolerance, std::string_view name = "patch");
  static constexpr double default_tolerance = 1e-3;
  static constexpr std::size_t most_bytes = std::size_t{2} << 20U;

  /// The table that has these contents. Throws std::invalid_argument if they cannot be those of a table.
  explicit PatchTable(PatchTableContents contents);

  [[nodiscard]] const std::string& name() const noexcept;
  [[nodiscard]] double tolerance() const noexcept;
  /// The largest error that a search in every cell found, plus 5 %. `PatchFriction::error` adds the patch's own.
  [[nodiscard]] double checked_error() const noexcept;
  /// Memory of the table.
  [[nodiscard]] std::size_t bytes() const noexcept;
  [[nodiscard]] PatchTableContents contents() const;

 private:
  struct Cube;
  explicit PatchTable(std::shared_ptr<const Cube> cube);

  std::shared_ptr<const Cube> cube_;
};

/// The table as CSV: comment lines `# name: value`, the header `face,i,j,power,di,dj,didj` and a row for each node. It
/// keeps every bit of every number, and has a checksum.
std::string to_csv(const PatchTable& table);
/// The same as one JSON object: {"format": "limitcurve patch table 1", the facts, "columns", "nodes": [[…], …]}.
std::string to_json(const PatchTable& table);
/// Reads a table that `to_csv` wrote. `source` is its name in messages. Throws std::invalid_argument:
/// `source:line:column: …` for a text that ends within a line or is not a table, `source: …` for a wrong checksum.
PatchTable read_patch_table_csv(std::string_view text, std::string_view source);
/// The table with these contents. Throws std::invalid_argument, whose message begins with `source`, if their checksum
/// is not `expected_checksum` or they are no table.
PatchTable patch_table_of(PatchTableContents contents, std::string_view expected_checksum, std::string_view source);

}  // namespace limitcurve
