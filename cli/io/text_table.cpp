// SPDX-License-Identifier: MIT
#include "cli/io/text_table.hpp"

#include <algorithm>
#include <string_view>

namespace limitcurve::cli {

namespace {

struct Width {
  std::size_t before_point = 0;
  std::size_t from_point = 0;
  std::size_t letters = 0;  ///< of texts

  [[nodiscard]] std::size_t total() const { return std::max(before_point + from_point, letters); }
};

/// Letters of UTF-8.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char one) { return (one & 0xc0) != 0x80; }));
}

std::size_t point_of(std::string_view number) {
  return std::min(number.find_first_of(".e"), number.size());
}

/// The lines of a name, no longer than `width` where its words allow it.
std::vector<std::string> broken(std::string_view name, std::size_t width) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find('_', begin), name.size() - 1) + 1;
    if (!lines.back().empty() && letters(lines.back()) + end - begin > width) lines.emplace_back();
    lines.back() += name.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

}  // namespace

std::string aligned(const std::vector<std::string>& names, const std::vector<TableCell>& cells, bool with_names) {
  constexpr std::size_t widest = 80;
  const std::size_t count = names.size();
  std::vector<Width> widths(count);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Width& width = widths[i % count];
    const std::size_t point = point_of(cells[i].text);
    if (!cells[i].is_number) {
      width.letters = std::max(width.letters, letters(cells[i].text));
    } else {
      width.before_point = std::max(width.before_point, point);
      width.from_point = std::max(width.from_point, cells[i].text.size() - point);
    }
  }
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i) total += std::max(widths[i].total(), letters(names[i])) + 2;
  const std::size_t gap = total > widest ? 1 : 2;
  std::vector<std::vector<std::string>> heads;
  std::size_t head_lines = 0;
  for (std::size_t i = 0; i < count; ++i) {
    heads.push_back(total > widest ? broken(names[i], widths[i].total()) : std::vector{names[i]});
    for (const std::string& line : heads[i]) widths[i].letters = std::max(widths[i].letters, letters(line));
    head_lines = std::max(head_lines, heads[i].size());
  }
  std::string text;
  const auto put = [&](std::size_t column, const std::string& cell, std::size_t indent) {
    text += std::string(indent, ' ') + cell + std::string(widths[column].total() + gap - indent - letters(cell), ' ');
    if (column + 1 == count) text.erase(text.find_last_not_of(' ') + 1) += '\n';
  };
  for (std::size_t line = 0; with_names && line < head_lines; ++line) {
    for (std::size_t i = 0; i < count; ++i) put(i, line < heads[i].size() ? heads[i][line] : "", 0);
  }
  std::size_t column = 0;
  for (const TableCell& cell : cells) {
    put(column, cell.text, cell.is_number ? widths[column].before_point - point_of(cell.text) : 0);
    if (++column == count) column = 0;
  }
  return text;
}

}  // namespace limitcurve::cli
