// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Tables as text, format 2: CSV to read back or to plot in a spreadsheet, JSON for other programs, a header to compile into C or C++.
/// All hold every number to the last bit, and a checksum of facts and rows that a reader can verify.
namespace limitcurve {

/// FNV-1a (64 bits) over the facts and rows of the table as text, "fnv1a:" and 16 hexadecimal digits.
std::string checksum(const Table& table);

/// Comment lines `# name: value` (law, tolerance, certified_error, index_bits, octaves, linear_error, profile_error, version, checksum), what
/// the columns mean, then `side,x,force,moment,c0,…,c6`: one row a cell, and one of each side at the rim. TableContents has their meaning and order.
std::string to_csv(const Table& table);

/// The same as one object: {"format": "limitcurve table 2", "law", "tolerance", "certified_error", "index_bits", "octaves", "linear_error",
/// "profile_error", "version", "checksum", "columns", "inside", "outside"}, the sides as arrays of [x, force, moment, c0, …, c6].
std::string to_json(const Table& table);

/// A header that needs nothing but C99 or C++17. In C: `limitcurve_table_<law>_wrench(slide, spin)` returns a struct of force and moment.
/// In C++ also: namespace `limitcurve_table_<law>` with `constexpr wrench(slide, spin)`. A bisection finds the cell.
std::string to_header(const Table& table);

/// Reads what `to_csv` wrote. `source` names it in complaints: std::invalid_argument `source:line:column: …` for what is torn, foreign or out
/// of order, and for a checksum that does not fit the contents. A table of format 1 is refused with the command that makes it anew.
Table read_table_csv(std::string_view text, std::string_view source);

/// What a file of format 2 holds, in whatever syntax.
struct TableContents {
  /// x = c/a inside the rim, a/c outside; force and moment there; c₀ … c₆ of D(x') = Σ cᵢ (x' − x)ⁱ, which holds until the next larger x.
  /// Inside the force is D′ and the moment D − xD′, outside the moment is D′ and the force D − xD′.
  using Row = std::array<double, 10>;

  std::string law;
  double tolerance = 0.0;
  double certified_error = 0.0;
  int index_bits = 0;
  int octaves = 0;
  /// Largest error of force and moment if they are interpolated linearly in x between the rows, rounded up to two digits.
  double linear_error = 0.0;
  /// As TableFacts has it. Older files do not have it, and are read as if it were 0.
  double profile_error = 0.0;
  /// In the order of the curve, from pure spin to pure sliding. So x grows inside the rim and falls outside. The rim, x = 1, has a row of each
  /// side, which is no cell: c₀ = D and c₁ = D′ there, the others 0.
  std::vector<Row> inside;
  std::vector<Row> outside;
};

/// The table that the contents describe. Throws std::invalid_argument that begins with `source` if they have not the `expected_checksum`, or
/// describe no limit curve.
Table table_of(const TableContents& contents, std::string_view expected_checksum, std::string_view source);

/// The complaint about a table of format 1. `law` and `tolerance` are those of the file, empty where it has none.
std::invalid_argument format_1_complaint(std::string_view source, std::string_view law, std::string_view tolerance);

}  // namespace limitcurve
