// SPDX-License-Identifier: MIT
#pragma once

#include "table.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Table files, format 2. You can read a CSV file back or plot it in a spreadsheet; JSON is for other programs. The two
/// forms keep every bit of every number, and have a checksum of facts and rows, so that an edited file is rejected.
namespace limitcurve {

/// FNV-1a (64 bits) of the facts and rows of the table as text: "fnv1a:" and 16 hexadecimal digits.
std::string checksum(const Table& table);

/// The table as CSV: comment lines `# name: value` (law, tolerance, checked_error, index_bits, octaves, linear_error,
/// profile_error, version, checksum), the meaning of the columns, the header `side,x,force,moment,c0,…,c6`, one row for
/// each cell, and one row of each side at the rim. TableContents has the meaning and order of rows.
std::string to_csv(const Table& table);

/// The table as one JSON object: {"format": "limitcurve table 2", "law", "tolerance", "checked_error", "index_bits",
/// "octaves", "linear_error", "profile_error", "version", "checksum", "columns", "inside", "outside"}, the sides as
/// arrays of [x, force, moment, c0, …, c6].
std::string to_json(const Table& table);

/// Reads a table that `to_csv` wrote. `source` is its name in messages. Throws std::invalid_argument:
/// `source:line:column: …` for a text that ends within a line or is not a table; `source: …` for a wrong checksum
/// and for cells that do not make a table.
Table read_table_csv(std::string_view text, std::string_view source);

/// The contents of a table file of format 2, CSV or JSON.
struct TableContents {
  /// x = c/a inside the rim, a/c outside; force and moment there; c₀ … c₆ of D(x') = Σ cᵢ (x' − x)ⁱ, valid from x to
  /// the next larger x. Inside, force = D′ and moment = D − xD′; outside, moment = D′ and force = D − xD′.
  using Row = std::array<double, 10>;

  std::string law;
  double tolerance = 0.0;
  double checked_error = 0.0;
  int index_bits = 0;
  int octaves = 0;
  /// Largest error of force and moment under linear interpolation in x between rows, rounded up to two digits.
  double linear_error = 0.0;
  /// As in TableFacts.
  double profile_error = 0.0;
  /// Rows in the order of the curve, from pure spin to pure sliding: x grows inside the rim and falls outside. Each
  /// side has a row at the rim, x = 1, which is not a cell: c₀ = D and c₁ = D′ there, the other coefficients are 0.
  std::vector<Row> inside;
  std::vector<Row> outside;
};

/// The table with these contents. Throws std::invalid_argument, whose message begins with `source`, if their checksum
/// is not `expected_checksum` or they are not a limit curve.
Table table_of(const TableContents& contents, std::string_view expected_checksum, std::string_view source);

}  // namespace limitcurve
