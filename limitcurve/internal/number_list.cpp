// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number_list.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace limitcurve {

double read_number(std::string_view text, const std::optional<Range>& range) {
  const auto value = parse_number(text);
  if (value && (!range || range->contains(*value))) return *value;
  throw std::invalid_argument("got '" + std::string(text) + "', expected " +
                              (range ? std::string(range->text) : "a number"));
}

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

}  // namespace limitcurve
