// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"
#include "cli/io/output_file.hpp"
#include "cli/io/text_table.hpp"

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve::cli {

enum class Format { table, csv, json };

/// A column of results as values instead of CSV text.
struct Column {
  enum class Kind { number, integer, truth, text };

  std::string name;
  Kind kind = Kind::text;            ///< of its last cell
  std::vector<double> numbers = {};  ///< of kind number, integer or truth
  std::vector<std::string> texts = {};
};

/// The help on columns: "Columns:" and a line for each name and its meaning, wrapped before column 120; "" without a
/// meaning joins the name to the next.
std::string help_of(const std::vector<std::pair<std::string_view, std::string_view>>& columns);

/// Destination and format of a subcommand's results.
struct Results {
  OutputFile& output;
  Format format = Format::csv;
  std::vector<Column>* columns = nullptr;  ///< collects the rows instead of `output`, unless null
  Messages* messages = nullptr;            ///< never null in `Subcommand::run`
  std::vector<std::string> given = {};     ///< the options of the command line, such as "--law"

  [[nodiscard]] bool has(std::string_view option) const;
  /// Warns of the options that were given although they are idle, which means without effect on `what`.
  void warn_idle(std::initializer_list<std::pair<std::string_view, bool>> idle, const std::string& what) const;
};

/// Writes rows of named columns one by one.
///
/// CSV: one header line; numbers in shortest round-trip form, `inf` and `nan` in lower case; a text with a comma, a
/// quote or a line break is quoted as in RFC 4180.
/// JSON: an array of objects, one a line, keyed by the column names; values without a JSON number are the strings
/// "inf", "-inf", "nan". Table: for a person; numbers have 4 digits, or 6 in a column whose numbers are typed into
/// something. A long text of several words is printed once, below the rows; its cells have a number in brackets.
class Rows {
 public:
  Rows(const Results& results, std::initializer_list<std::string_view> columns)
      : Rows(results, std::vector<std::string>(columns.begin(), columns.end())) {}
  /// For columns known only at run time.
  Rows(const Results& results, const std::vector<std::string>& columns);

  /// One row; as many cells as columns, numbers or texts.
  template <class... Cells>
  void row(const Cells&... cells) {
    begin_row();
    (cell(cells), ...);
    end_row();
  }

  /// The same for columns known only at run time: calls `write` with a function that takes one cell.
  template <class Write>
  void row_by(Write&& write) {
    begin_row();
    write([this](const auto& one) { this->cell(one); });
    end_row();
  }

  /// Ends the output and passes it to the operating system. Without this call the output may be incomplete.
  void finish();

 private:
  void begin_row();
  void end_row();
  void begin_cell();
  void cell(double number);
  /// No number: an empty cell, null in JSON, NaN where columns are collected.
  void cell(const std::optional<double>& number) {
    if (number || results_.columns != nullptr) return cell(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    literal(results_.format == Format::json ? "null" : "");
  }
  void cell(std::string_view text);
  void cell(const std::string& text) { cell(std::string_view(text)); }
  void cell(const char* text) { cell(std::string_view(text)); }
  template <std::unsigned_integral Integer>
  void cell(Integer number) {
    if (results_.columns != nullptr) return gather(Column::Kind::integer, static_cast<double>(number));
    literal(std::to_string(number), true);
  }
  void cell(bool truth) {
    if (results_.columns != nullptr) return gather(Column::Kind::truth, truth ? 1.0 : 0.0);
    literal(truth ? "true" : "false");
  }
  void gather(Column::Kind kind, double number);
  /// A cell with the same text in every format.
  void literal(std::string_view text, bool is_number = false);
  void write_table();

  const Results& results_;
  std::vector<std::string> columns_;
  std::vector<TableCell> cells_;  ///< of a table: of the rows that are not written yet
  std::vector<std::string> remarks_;
  std::size_t column_ = 0;
  bool first_row_ = true;
};

}  // namespace limitcurve::cli
