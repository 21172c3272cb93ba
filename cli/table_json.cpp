// SPDX-License-Identifier: MIT
#include "cli/table_reader.hpp"

#include "limitcurve/table_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

using nlohmann::json;

constexpr const char* expected_format = "limitcurve table 1";

std::string quoted(std::string_view name) {
  std::string text(1, '"');
  return text.append(name).append(1, '"');
}

[[noreturn]] void fail(const std::string& source, const std::string& what) {
  throw std::invalid_argument(source + ": " + what);
}

/// What a JSON parser stumbles over, as line and column like everywhere else.
[[noreturn]] void fail_at(const std::string& source, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string what = before.size() >= text.size() ? "the file ends within the table, expected more" : "not JSON from here on";
  fail(source + ':' + std::to_string(line) + ':' + std::to_string(before.size() - line_start + 1), what);
}

const json& member(const json& whole, const char* name, bool (json::*is_kind)() const noexcept, const std::string& source,
                   const std::string& kind) {
  const auto found = whole.find(name);
  if (found == whole.end()) fail(source, "no member " + quoted(name) + ", expected " + kind);
  if (!((*found).*is_kind)()) fail(source, quoted(name) + " is not " + kind);
  return *found;
}

/// What stands in place of a node: its beginning, unless it holds arrays itself, which may lie in each other as deep as the file is long.
std::string shown(const json& node) {
  const auto is_flat = [](const json& item) { return item.is_primitive(); };
  if (!std::all_of(node.begin(), node.end(), is_flat)) return std::string("a nested ") + node.type_name();
  return node.dump().substr(0, 60);
}

TableSide side(const json& whole, const char* name, bool inside, const std::string& source) {
  std::vector<TableNode> nodes;
  for (const json& node : member(whole, name, &json::is_array, source, "an array of nodes")) {
    const bool fits =
        node.is_array() && node.size() == 4 && std::all_of(node.begin(), node.end(), [](const json& x) { return x.is_number(); });
    if (!fits) {
      fail(source, quoted(name) + ", node " + std::to_string(nodes.size() + 1) + ": got " + shown(node) +
                       ", expected [coordinate, force, moment, slope]");
    }
    const double force = node[1].get<double>();
    const double moment = node[2].get<double>();
    nodes.push_back({node[0].get<double>(), inside ? force : moment, inside ? moment : force, node[3].get<double>()});
  }
  return TableSide(std::move(nodes));
}

}  // namespace

limitcurve::Table read_table_json(std::string_view text, const std::string& source) {
  json whole;
  try {
    whole = json::parse(text);
  } catch (const json::parse_error& error) {
    fail_at(source, text, error.byte);
  } catch (const json::out_of_range&) {
    fail(source, "a number that no double can hold");
  }
  if (!whole.is_object() || whole.value("format", json()) != expected_format) {
    fail(source, "not a table: expected an object with \"format\": " + quoted(expected_format));
  }
  const std::string law = member(whole, "law", &json::is_string, source, "a text").get<std::string>();
  const double tolerance = member(whole, "tolerance", &json::is_number, source, "a number").get<double>();
  const double error_bound = member(whole, "certified_error", &json::is_number, source, "a number").get<double>();
  const std::string sum = member(whole, "checksum", &json::is_string, source, "a text").get<std::string>();
  try {
    limitcurve::Table table({law, tolerance, error_bound}, side(whole, "inside", true, source), side(whole, "outside", false, source));
    verify_checksum(table, sum, source);
    return table;
  } catch (const std::invalid_argument& error) {
    // What the library finds wrong with the nodes does not name the file yet.
    if (std::string_view(error.what()).substr(0, source.size()) == source) throw;
    fail(source, error.what());
  }
}

}  // namespace limitcurve::cli
