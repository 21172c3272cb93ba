// SPDX-License-Identifier: MIT
#include "cli/io/table_reader.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/table_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace limitcurve::cli {

namespace {

using nlohmann::json;

std::string quoted(std::string_view name) {
  std::string text(1, '"');
  return text.append(name).append(1, '"');
}

[[noreturn]] void fail(const std::string& source, const std::string& what) {
  throw std::invalid_argument(source + ": " + what);
}

/// Reports a JSON syntax error with line and column, like other errors.
[[noreturn]] void fail_at(const std::string& source, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string what =
      before.size() >= text.size() ? "the file ends within the table, expected more" : "not JSON from here on";
  fail(source + ':' + std::to_string(line) + ':' + std::to_string(before.size() - line_start + 1), what);
}

const json& member(const json& whole, const char* name, bool (json::*is_kind)() const noexcept,
                   const std::string& source, const std::string& kind) {
  const auto found = whole.find(name);
  if (found == whole.end()) fail(source, "no member " + quoted(name) + ", expected " + kind);
  if (!((*found).*is_kind)()) fail(source, quoted(name) + " is not " + kind);
  return *found;
}

/// The beginning of a wrong row, for an error message. A nested value is only named: its depth is limited by the file
/// alone.
std::string shown(const json& row) {
  const auto is_flat = [](const json& item) { return item.is_primitive(); };
  if (!std::all_of(row.begin(), row.end(), is_flat)) return std::string("a nested ") + row.type_name();
  return row.dump().substr(0, 60);
}

std::vector<TableContents::Row> side(const json& whole, const char* name, const std::string& source) {
  std::vector<TableContents::Row> rows;
  for (const json& row : member(whole, name, &json::is_array, source, "an array of rows")) {
    const bool fits = row.is_array() && row.size() == std::tuple_size_v<TableContents::Row> &&
                      std::all_of(row.begin(), row.end(), [](const json& x) { return x.is_number(); });
    if (!fits) {
      fail(source, quoted(name) + ", row " + std::to_string(rows.size() + 1) + ": got " + shown(row) +
                       ", expected [x, force, moment, c0, c1, c2, c3, c4, c5, c6]");
    }
    rows.push_back(row.get<TableContents::Row>());
  }
  return rows;
}

int whole_number(const json& whole, const char* name, const std::string& source) {
  const auto value = member(whole, name, &json::is_number_integer, source, "a whole number").get<std::int64_t>();
  if (value != static_cast<int>(value)) fail(source, quoted(name) + " is " + std::to_string(value) + ", out of range");
  return static_cast<int>(value);
}

/// The object of that format.
json parsed(std::string_view text, const std::string& source, const char* expected_format) {
  json whole;
  try {
    whole = json::parse(text);
  } catch (const json::parse_error& error) {
    fail_at(source, text, error.byte);
  } catch (const json::out_of_range&) {
    fail(source, "a number that no double can hold");
  }
  const json format = whole.is_object() ? whole.value("format", json()) : json();
  if (format != expected_format)
    fail(source, "not a table: expected an object with \"format\": " + quoted(expected_format));
  return whole;
}

}  // namespace

PatchTable read_patch_table_json(std::string_view text, const std::string& source) {
  const json whole = parsed(text, source, "limitcurve patch table 1");
  const auto text_of = [&](const char* name) {
    return member(whole, name, &json::is_string, source, "a text").get<std::string>();
  };
  PatchTableContents contents;
  contents.name = text_of("patch");
  for (const auto& [name, number] : numbers_of(contents))
    *number = member(whole, name, &json::is_number, source, "a number").get<double>();
  contents.cells = whole_number(whole, "cells", source);
  for (const json& row : member(whole, "nodes", &json::is_array, source, "an array of rows")) {
    const bool fits = row.is_array() && row.size() == 7 &&
                      std::all_of(row.begin(), row.end(), [](const json& x) { return x.is_number(); });
    if (!fits)
      fail(source, "\"nodes\", row " + std::to_string(contents.nodes.size() + 1) + ": got " + shown(row) +
                       ", expected [face, i, j, power, di, dj, didj]");
    const auto numbers = row.get<std::array<double, 7>>();
    contents.nodes.push_back({numbers[3], numbers[4], numbers[5], numbers[6]});
  }
  return patch_table_of(std::move(contents), text_of("checksum"), source);
}

limitcurve::Table read_table_json(std::string_view text, const std::string& source) {
  const json whole = parsed(text, source, "limitcurve table 2");
  const auto text_of = [&](const char* name) {
    return member(whole, name, &json::is_string, source, "a text").get<std::string>();
  };
  const auto number = [&](const char* name) {
    return member(whole, name, &json::is_number, source, "a number").get<double>();
  };
  const TableContents contents{.law = text_of("law"),
                               .tolerance = number("tolerance"),
                               .checked_error = number("checked_error"),
                               .index_bits = whole_number(whole, "index_bits", source),
                               .octaves = whole_number(whole, "octaves", source),
                               .linear_error = number("linear_error"),
                               .profile_error = number("profile_error"),
                               .inside = side(whole, "inside", source),
                               .outside = side(whole, "outside", source)};
  const json row_columns = json::array({"x", "force", "moment", "c0", "c1", "c2", "c3", "c4", "c5", "c6"});
  if (const json& columns = member(whole, "columns", &json::is_array, source, "an array of names");
      columns != row_columns) {
    fail(source, "\"columns\" is " + shown(columns) + ", expected " + row_columns.dump());
  }
  return table_of(contents, text_of("checksum"), source);
}

}  // namespace limitcurve::cli
