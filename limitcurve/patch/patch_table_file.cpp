// SPDX-License-Identifier: MIT
#include "limitcurve/patch/patch_table.hpp"
#include "limitcurve/table/table_text.hpp"
#include "limitcurve/version.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve {

namespace {

constexpr std::string_view patch_title = "# limitcurve patch table, format 1";
constexpr std::string_view columns = "face,i,j,power,di,dj,didj";
constexpr std::string_view patch_legend =
    "# Power H(vx, vy, omega) of a twist about the centre of pressure, per mu P, before mx and my. On face 0 vx = 1, "
    "on\n"
    "# face 1 vy = 1, on face 2 moment_ratio*omega = 1; nodes are at -1 + 2 i/cells and -1 + 2 j/cells of the next two "
    "of\n"
    "# vx, vy, moment_ratio*omega, cyclic. di, dj, didj: derivatives by i, by j, by both. A cell is bicubic.\n";

/// Calls `row` with face, i, j and the node, for all in order.
template <class Row>
void for_each_node(const PatchTableContents& contents, const Row& row) {
  const int side = contents.cells + 1;
  for (std::size_t k = 0; k < contents.nodes.size(); ++k) {
    const int number = static_cast<int>(k);
    row(number / (side * side), number / side % side, number % side, contents.nodes[k]);
  }
}

std::string rows_of(const PatchTableContents& contents, std::string_view before, std::string_view after) {
  std::string text;
  for_each_node(contents, [&](int face, int i, int j, const PatchTableContents::Node& node) {
    text.append(before).append(std::to_string(face) + "," + std::to_string(i) + "," + std::to_string(j));
    for (const double number : node) text.append(",").append(format_number(number));
    text.append(after);
  });
  return text;
}

std::string checksum(const PatchTableContents& contents) {
  std::string text = contents.name + "\n" + std::to_string(contents.cells) + "\n";
  for (const auto& [name, number] : numbers_of(contents)) text += format_number(*number) + "\n";
  return table::checksum_of(text + rows_of(contents, "", "\n"));
}

}  // namespace

std::string to_csv(const PatchTable& table) {
  const PatchTableContents contents = table.contents();
  std::string text(patch_title);
  const auto add = [&](std::string_view name, std::string_view value) {
    text.append("\n# ").append(name).append(": ").append(value);
  };
  add("patch", contents.name);
  for (const auto& [name, number] : numbers_of(contents)) add(name, format_number(*number));
  add("cells", std::to_string(contents.cells));
  add("version", version);
  add("checksum", checksum(contents));
  return text.append("\n").append(patch_legend).append(columns).append("\n") + rows_of(contents, "", "\n");
}

std::string to_json(const PatchTable& table) {
  const PatchTableContents contents = table.contents();
  std::string text = "{\n  \"format\": \"limitcurve patch table 1\"";
  const auto add = [&](std::string_view name, const std::string& value) {
    text.append(",\n  ").append(table::json_string(name)).append(": ").append(value);
  };
  add("patch", table::json_string(contents.name));
  for (const auto& [name, number] : numbers_of(contents)) add(name, format_number(*number));
  add("cells", std::to_string(contents.cells));
  add("version", table::json_string(version));
  add("checksum", table::json_string(checksum(contents)));
  std::string names = table::json_string(columns);
  for (std::size_t comma = 0; (comma = names.find(',', comma)) != std::string::npos; comma += 4)
    names.replace(comma, 1, "\", \"");
  add("columns", "[" + names + "]");
  std::string rows = rows_of(contents, "    [", "],\n");
  rows.erase(rows.size() - 2, 1);
  add("nodes", "[\n" + rows + "  ]\n}\n");
  return text;
}

PatchTable patch_table_of(PatchTableContents contents, std::string_view expected_checksum, std::string_view source) {
  table::require_checksum(source, expected_checksum, checksum(contents));
  try {
    return PatchTable(std::move(contents));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(source) + ": " + error.what());
  }
}

PatchTable read_patch_table_csv(std::string_view text, std::string_view source) {
  table::Reader reader(text, source);
  reader.title(patch_title);
  PatchTableContents contents;
  contents.name = reader.fact("patch").first;
  for (const auto& [name, number] : numbers_of(contents)) {
    const auto [value, column] = reader.fact(name);
    *number = reader.number(value, column);
  }
  const auto [cells, column] = reader.fact("cells");
  contents.cells = reader.whole_number(cells, column);
  reader.fact("version");
  const std::string_view sum = reader.fact("checksum").first;
  reader.header(columns);
  while (!reader.at_end()) reader.numbers(reader.line(), columns, 3, contents.nodes.emplace_back());
  return patch_table_of(std::move(contents), sum, source);
}

}  // namespace limitcurve
