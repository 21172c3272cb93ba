// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <string>
#include <string_view>

/// Tables as text: CSV to read back or open in a spreadsheet, JSON for other programs, a C++17 header to compile in.
/// All three hold every number to the last bit, and a checksum of facts and nodes that whoever reads can verify.
namespace limitcurve {

/// FNV-1a (64 bits) over law, tolerance, certified error and nodes as text, "fnv1a:" and 16 hexadecimal digits.
std::string checksum(const Table& table);

/// Comment lines `# name: value` (law, tolerance, certified_error, version, checksum), then
/// `side,coordinate,force,moment,slope`. Inside the rim coordinate = c/a and slope = d force/d coordinate; outside
/// coordinate = a/c and slope = d moment/d coordinate; the other component's slope is −coordinate·slope.
std::string to_csv(const Table& table);

/// The same as one object: {"format", "law", "tolerance", "certified_error", "version", "checksum", "inside", "outside"},
/// the sides as arrays of [coordinate, force, moment, slope].
std::string to_json(const Table& table);

/// A header that needs nothing but C++17: namespace `limitcurve_table_<law>` with `constexpr wrench(slide, spin)`.
std::string to_header(const Table& table);

/// Reads what `to_csv` wrote. `source` names it in complaints: std::invalid_argument `source:line:column: …` for what
/// is torn, foreign or out of order, and for a checksum that does not fit the contents.
Table read_table_csv(std::string_view text, std::string_view source);

/// Refuses a table whose contents do not have the `expected` checksum. Throws std::invalid_argument naming `source`.
void verify_checksum(const Table& table, std::string_view expected, std::string_view source);

}  // namespace limitcurve
