// SPDX-License-Identifier: MIT
#include "cli/io/rows.hpp"

#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

std::string quoted_for_csv(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char character : text) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted + '"';
}

/// Digits of a column's numbers in a table.
int digits_of(std::string_view column) {
  constexpr std::array<std::string_view, 7> typed{"hold_load", "high", "low", "parameter", "radius", "time", "value"};
  return std::find(typed.begin(), typed.end(), column) == typed.end() ? 4 : 6;
}

std::string quoted_for_json(std::string_view text) {
  // A file name need not be valid UTF-8; JSON must.
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string help_of(const std::vector<std::pair<std::string_view, std::string_view>>& columns) {
  constexpr std::size_t indent = 22;
  constexpr std::size_t width = 118;
  std::string text = "Columns:";
  std::string line = "\n ";
  for (const auto& [name, meaning] : columns) {
    line.append(" ").append(name).append(meaning.empty() ? "," : "");
    if (meaning.empty()) continue;
    line.resize(std::max(line.size() + 1, indent), ' ');
    for (std::size_t begin = 0; begin < meaning.size();) {
      const std::size_t end = std::min(meaning.find(' ', begin), meaning.size());
      if (line.size() + end - begin > width) {
        text += line;
        line = '\n' + std::string(indent, ' ');
      }
      line.append(" ").append(meaning.substr(begin, end - begin));
      begin = end + 1;
    }
    text += std::exchange(line, "\n ");
  }
  return text + '\n';
}

bool Results::has(std::string_view option) const {
  return std::find(given.begin(), given.end(), option) != given.end();
}

void Results::warn_idle(std::initializer_list<std::pair<std::string_view, bool>> idle, const std::string& what) const {
  std::string names;
  bool several = false;
  for (const auto& [option, is_idle] : idle) {
    if (!is_idle || !has(option)) continue;
    several = !names.empty();
    names.append(several ? ", " : "").append(option);
  }
  if (!names.empty()) {
    messages->say("limitcurve: warning: " + names + (several ? " have" : " has") + " no effect on " + what +
                  (several ? ": leave them out" : ": leave it out"));
  }
}

Rows::Rows(const Results& results, const std::vector<std::string>& columns) : results_(results) {
  if (results_.columns != nullptr) {
    results_.columns->clear();
    for (const std::string& name : columns) results_.columns->push_back({name});
  }
  if (results_.columns != nullptr || results_.format == Format::table) {
    columns_ = columns;
    return;
  }
  for (const std::string& name : columns) {
    columns_.push_back(results_.format == Format::csv ? quoted_for_csv(name) : quoted_for_json(name));
  }
  if (results_.format == Format::json) {
    results_.output.write("[");
    return;
  }
  std::string header;
  for (const std::string& name : columns_) header += name + ',';
  header.back() = '\n';
  results_.output.write(header);
}

void Rows::begin_row() {
  let_interrupt();
  column_ = 0;
  if (results_.columns != nullptr || results_.format == Format::table) return;
  if (results_.format == Format::json) results_.output.write(first_row_ ? "\n{" : ",\n{");
  first_row_ = false;
}

void Rows::end_row() {
  if (column_ != columns_.size()) throw std::logic_error("a row of other length than its header");
  if (results_.columns != nullptr) return;
  if (results_.format != Format::table) return results_.output.write(results_.format == Format::csv ? "\n" : "}");
  constexpr std::size_t block = 1000;  // a long table is not kept in memory
  if (cells_.size() == block * columns_.size()) write_table();
}

void Rows::write_table() {
  results_.output.write(aligned(columns_, cells_, first_row_));
  cells_.clear();
  first_row_ = false;
}

void Rows::begin_cell() {
  if (column_ > 0) results_.output.write(",");
  if (results_.format == Format::json) {
    results_.output.write(columns_.at(column_));
    results_.output.write(":");
  }
  ++column_;
}

void Rows::gather(Column::Kind kind, double number) {
  Column& column = results_.columns->at(column_++);
  column.kind = kind;
  column.numbers.push_back(number);
}

void Rows::cell(double number) {
  if (results_.columns != nullptr) return gather(Column::Kind::number, number);
  if (results_.format == Format::table)
    return literal(format_number(number, digits_of(columns_.at(column_))), std::isfinite(number));
  begin_cell();
  const std::string text = format_number(number);
  results_.output.write(results_.format == Format::json && !std::isfinite(number) ? '"' + text + '"' : text);
}

void Rows::literal(std::string_view text, bool is_number) {
  if (results_.format == Format::table) {
    ++column_;
    cells_.push_back({std::string(text), is_number});
    return;
  }
  begin_cell();
  results_.output.write(text);
}

void Rows::cell(std::string_view text) {
  if (results_.columns != nullptr) {
    results_.columns->at(column_++).texts.emplace_back(text);
    return;
  }
  constexpr std::size_t longest_in_a_cell = 16;
  if (results_.format == Format::table && text.size() > longest_in_a_cell && text.find(' ') != std::string_view::npos) {
    const auto known = std::find(remarks_.begin(), remarks_.end(), text);
    const auto number = std::to_string(known - remarks_.begin() + 1);
    if (known == remarks_.end()) remarks_.emplace_back(text);
    return literal("[" + number + "]");
  }
  if (results_.format == Format::table) return literal(text);
  begin_cell();
  results_.output.write(results_.format == Format::csv ? quoted_for_csv(text) : quoted_for_json(text));
}

void Rows::finish() {
  if (results_.columns != nullptr) return;
  if (results_.format == Format::table) {
    write_table();
    for (std::size_t i = 0; i < remarks_.size(); ++i) {
      constexpr std::size_t width = 118;
      std::string line = '[' + std::to_string(i + 1) + "] " + remarks_[i];
      for (std::size_t end = 0; line.size() > width && (end = line.rfind(' ', width)) > 4; line.replace(0, end, "   "))
        results_.output.write(line.substr(0, end) + '\n');
      results_.output.write(line + '\n');
    }
  }
  if (results_.format == Format::json) results_.output.write(first_row_ ? "]\n" : "\n]\n");
  results_.output.flush();
}

}  // namespace limitcurve::cli
