// SPDX-License-Identifier: MIT
#include "limitcurve/table_file.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/table/table_text.hpp"
#include "limitcurve/version.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace limitcurve {

namespace {

using Row = TableContents::Row;

constexpr std::string_view title = "# limitcurve table, format 2";
constexpr std::string_view cell_columns = "x,force,moment,c0,c1,c2,c3,c4,c5,c6";
constexpr std::size_t coefficients_from = 3;
constexpr std::string_view legend =
    "# One row for each cell, in the order of the curve from pure spin to pure sliding; and one at x = 1 for each "
    "side, "
    "the rim.\n"
    "# c: distance of the centre of rotation, a: contact radius. x = c/a inside the rim, a/c outside. force = F/(mu "
    "P),\n"
    "# moment = M/(mu P a). D(x) = c0 + c1 t + ... + c6 t^6 from the x of the row to the next larger one, t = x - that "
    "of the row.\n"
    "# Inside the rim force = D' and moment = D - x D'; outside moment = D' and force = D - x D': to checked_error. A "
    "straight\n"
    "# line between two rows: to linear_error.\n";

/// The rows of one side in order of x.
std::vector<Row> rows_of(const Table& table, const std::vector<TableCell>& cells, bool outside) {
  std::vector<Row> rows;
  const auto add = [&](double x, const std::array<double, 7>& c) {
    const auto [force, moment] = table.view().table.jet(outside, x).wrench(outside);
    rows.push_back({x, force, moment, c[0], c[1], c[2], c[3], c[4], c[5], c[6]});
  };
  for (const TableCell& cell : cells) add(cell.x, cell.coefficients);
  const Jet<double> rim = table.view().table.jet(outside, 1.0);
  add(1.0, {rim.value(1.0), rim.leading});
  return rows;
}

/// The largest error of linear interpolation between rows (in order of x), against the table.
double error_of_chords(const Table& table, const std::vector<Row>& rows, bool outside) {
  constexpr int parts = 32;
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    for (int part = 1; part < parts; ++part) {
      const auto chord = [&](std::size_t column) {
        return std::lerp(rows[i][column], rows[i + 1][column], part / double{parts});
      };
      const auto [force, moment] = table.view().table.jet(outside, chord(0)).wrench(outside);
      worst = std::max({worst, std::fabs(chord(1) - force), std::fabs(chord(2) - moment)});
    }
  }
  return worst;
}

/// `value` rounded up to two digits.
double rounded_up(double value) {
  std::array<char, 16> text{};
  // Rounding to two digits reduces a number by at most 1/21, so 1.05 times it is not reduced below `value`.
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value * 1.05, std::chars_format::scientific, 1).ptr;
  return parse_number({text.data(), end}).value();
}

TableContents contents_of(const Table& table) {
  const TableCells& cells = table.cells();
  TableContents contents{.law = table.law_name(),
                         .tolerance = table.tolerance(),
                         .checked_error = table.checked_error(),
                         .index_bits = cells.index_bits,
                         .octaves = cells.octaves,
                         .profile_error = table.profile_error(),
                         .inside = rows_of(table, cells.inside, false),
                         .outside = rows_of(table, cells.outside, true)};
  // The largest error at 31 points of a cell is within 1 % of the true maximum.
  const double chords =
      1.01 * std::max(error_of_chords(table, contents.inside, false), error_of_chords(table, contents.outside, true));
  contents.linear_error = rounded_up(chords + table.checked_error());
  std::reverse(contents.outside.begin(), contents.outside.end());
  return contents;
}

std::string joined(const Row& row, std::string_view separator) {
  std::string text;
  for (const double value : row) text.append(text.empty() ? "" : separator).append(format_number(value));
  return text;
}

std::string csv_rows(const TableContents& contents) {
  std::string text;
  for (const Row& row : contents.inside) text += "inside," + joined(row, ",") + "\n";
  for (const Row& row : contents.outside) text += "outside," + joined(row, ",") + "\n";
  return text;
}

constexpr std::array<std::string_view, 9> fact_names{"law",           "tolerance", "checked_error",
                                                     "index_bits",    "octaves",   "linear_error",
                                                     "profile_error", "version",   "checksum"};

/// The facts that belong to the contents: those before the version.
std::array<std::string, 7> facts_of(const TableContents& contents) {
  return {contents.law,
          format_number(contents.tolerance),
          format_number(contents.checked_error),
          std::to_string(contents.index_bits),
          std::to_string(contents.octaves),
          format_number(contents.linear_error),
          format_number(contents.profile_error)};
}

std::string checksum(const TableContents& contents) {
  std::string text;
  for (const std::string& one : facts_of(contents)) text += one + "\n";
  return table::checksum_of(text + csv_rows(contents));
}

std::vector<TableCell> cells_of(const std::vector<Row>& rows, std::string_view side) {
  if (rows.size() < 2 || rows.back()[0] != 1.0) {
    throw std::invalid_argument("the rows " + std::string(side) +
                                " do not reach the rim: expected rows from x = 0 to x = 1");
  }
  std::vector<TableCell> cells(rows.size() - 1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].x = rows[i][0];
    std::copy(rows[i].begin() + coefficients_from, rows[i].end(), cells[i].coefficients.begin());
  }
  return cells;
}

}  // namespace

std::string checksum(const Table& table) {
  return checksum(contents_of(table));
}

std::string to_csv(const Table& table) {
  const TableContents contents = contents_of(table);
  std::string text = std::string(title) + "\n";
  const auto add = [&](std::size_t i, std::string_view value) {
    text.append("# ").append(fact_names[i]).append(": ").append(value) += '\n';
  };
  const auto facts = facts_of(contents);
  for (std::size_t i = 0; i < facts.size(); ++i) add(i, facts[i]);
  add(facts.size(), version);
  add(facts.size() + 1, checksum(contents));
  return text.append(legend).append("side,").append(cell_columns) + "\n" + csv_rows(contents);
}

Table read_table_csv(std::string_view text, std::string_view source) {
  table::Reader reader(text, source);
  reader.title(title);
  TableContents contents;
  std::string_view sum;
  for (const std::string_view name : fact_names) {
    const auto [value, column] = reader.fact(name);
    if (name == "law") contents.law = value;
    if (name == "tolerance") contents.tolerance = reader.number(value, column);
    if (name == "checked_error") contents.checked_error = reader.number(value, column);
    if (name == "index_bits") contents.index_bits = reader.whole_number(value, column);
    if (name == "octaves") contents.octaves = reader.whole_number(value, column);
    if (name == "linear_error") contents.linear_error = reader.number(value, column);
    if (name == "profile_error") contents.profile_error = reader.number(value, column);
    if (name == "checksum") sum = value;
  }
  const std::string columns = "side," + std::string(cell_columns);
  reader.header(columns);
  while (!reader.at_end()) {
    const std::string_view line = reader.line();
    const std::string_view side = line.substr(0, line.find(','));
    if (side != "inside" && side != "outside")
      reader.fail(1, "expected inside or outside, got '" + std::string(side) + "'");
    const bool inside = side == "inside";
    if (inside && !contents.outside.empty())
      reader.fail(1, "a row inside the rim after rows outside: expected all rows inside first");
    reader.numbers(line, columns, 1, (inside ? contents.inside : contents.outside).emplace_back());
  }
  return table_of(contents, sum, source);
}

Table table_of(const TableContents& contents, std::string_view expected_checksum, std::string_view source) {
  table::require_checksum(source, expected_checksum, checksum(contents));
  try {
    return Table({contents.law, contents.tolerance, contents.checked_error, contents.profile_error},
                 {.index_bits = contents.index_bits,
                  .octaves = contents.octaves,
                  .inside = cells_of(contents.inside, "inside"),
                  .outside = cells_of({contents.outside.rbegin(), contents.outside.rend()}, "outside")});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(source) + ": " + error.what());
  }
}

std::string to_json(const Table& table) {
  const TableContents contents = contents_of(table);
  using table::json_string;
  std::string text = "{\n  \"format\": \"limitcurve table 2\"";
  const auto add = [&](std::string_view name, const std::string& value) {
    text.append(",\n  ").append(json_string(name)).append(": ").append(value);
  };
  const auto facts = facts_of(contents);
  add("law", json_string(contents.law));
  for (std::size_t i = 1; i < facts.size(); ++i) add(fact_names[i], facts[i]);
  add("version", json_string(version));
  add("checksum", json_string(checksum(contents)));
  std::string names = json_string(cell_columns);
  for (std::size_t comma = 0; (comma = names.find(',', comma)) != std::string::npos; comma += 4)
    names.replace(comma, 1, "\", \"");
  add("columns", "[" + names + "]");
  const auto side = [](const std::vector<Row>& rows) {
    std::string lines;
    for (const Row& row : rows) lines += (lines.empty() ? "\n    [" : ",\n    [") + joined(row, ", ") + "]";
    return "[" + lines + "\n  ]";
  };
  add("inside", side(contents.inside));
  add("outside", side(contents.outside));
  return text + "\n}\n";
}

}  // namespace limitcurve
