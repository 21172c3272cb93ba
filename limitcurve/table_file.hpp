// SPDX-License-Identifier: MIT
#pragma once

#include "table.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Table files, format 2: CSV to read back or to plot in a spreadsheet, JSON for other programs, a header to compile
/// into C or C++. All keep every bit of every number, and have a checksum of facts and rows.
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

/// The table as a C99, C++17 and CUDA header that includes nothing. In C: `NAME_wrench(slide, spin)` returns a struct
/// of force and moment, as Table::wrench does; `NAME_gauge(force, moment)` is Table::gauge; `NAME_closest_point(force,
/// moment, chi)` is the closest-point step, within 2e-13 of the library's for chi = 1e-3 … 1e3. In C++ they are
/// constexpr. All names have internal linkage. The cell is found by bisection. NAME is `name`; if that is empty,
/// `limitcurve_table_<law>_<first 8 digits of the checksum>`, which no other table has. Throws std::invalid_argument,
/// with the name, unless it is a C identifier that begins with a letter and has no double underscore. With `is_single`
/// everything is in float. Then checked_error is `single_precision_error`, for a ratio of speeds that is a float, and
/// closest_point is within 5e-6.
std::string to_header(const Table& table, std::string_view name = {}, bool is_single = false);

/// Bound on the error in force and moment by a header in single precision: the table's own and roundings, about
/// 4e-7·max(1, m₀).
double single_precision_error(const Table& table);

/// Reads a table that `to_csv` wrote. `source` is its name in messages. Throws std::invalid_argument:
/// `source:line:column: …` for a text that is truncated, out of order or not a table; `source: …` for a wrong checksum
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

/// The key of the error before version 0.3.0, and what to say of a file that has it.
inline constexpr const char* old_error_key = "certified_error";
std::string old_key_message(std::string_view law, double tolerance);

/// The table with these contents. Throws std::invalid_argument, whose message begins with `source`, if their checksum
/// is not `expected_checksum` or they are not a limit curve.
Table table_of(const TableContents& contents, std::string_view expected_checksum, std::string_view source);

}  // namespace limitcurve
