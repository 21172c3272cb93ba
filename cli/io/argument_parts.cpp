// SPDX-License-Identifier: MIT
#include "cli/io/argument_parts.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace limitcurve::cli {

std::vector<double> read_number_list(std::string_view text, const Range& range) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view item = text.substr(begin, end - begin);
    while (!item.empty() && item.front() == ' ') item.remove_prefix(1);
    while (!item.empty() && item.back() == ' ') item.remove_suffix(1);
    try {
      numbers.push_back(read_number(item, range));
    } catch (const std::invalid_argument& error) {
      const std::string place = "item " + std::to_string(numbers.size() + 1) + " of '" + std::string(text) + "': ";
      throw std::invalid_argument(place + (item.empty() ? "empty, expected " + std::string(range.text) : error.what()));
    }
    begin = end + 1;
  }
  return numbers;
}

KeyValue angle_key(std::string_view key, double& value, const Range& range, bool required) {
  const auto take = [&value, range](std::string_view text) {
    const std::string_view unit = text.size() > 3 ? text.substr(text.size() - 3) : std::string_view{};
    const bool has_unit = unit == "deg" || unit == "rad";
    const double number = read_number(has_unit ? text.substr(0, text.size() - 3) : text, range);
    const double angle = unit == "deg" ? number * std::numbers::pi / 180.0 : number;
    // The conversion to radians may overflow or leave the range.
    if (!range.contains(angle))
      throw std::invalid_argument("got '" + std::string(text) + "', expected " + std::string(range.text));
    value = angle;
  };
  return {key, take, required};
}

std::string split_file(std::string_view kind, std::string_view rest, std::string_view& items) {
  // From the end, because the name may contain commas.
  std::size_t end = rest.size();
  for (;;) {
    const std::size_t comma = rest.substr(0, end).rfind(',');
    if (comma == std::string_view::npos || rest.substr(comma, end - comma).find('=') == std::string_view::npos) break;
    end = comma;
  }
  items = end == rest.size() ? std::string_view{} : rest.substr(end + 1);
  if (end == 0) throw std::invalid_argument("no file name, expected " + std::string(kind) + ":FILE");
  return std::string(rest.substr(0, end));
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace limitcurve::cli
