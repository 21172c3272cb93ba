// SPDX-License-Identifier: MIT
#include "cli/io/key_values.hpp"

#include "cli/io/number_list.hpp"

#include "limitcurve/internal/did_you_mean.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace limitcurve::cli {

KeyValue number_key(std::string_view key, double& value, const Range& range, bool required) {
  return {key, [&value, range](std::string_view text) { value = read_number(text, range); }, required};
}

KeyValue angle_key(std::string_view key, double& value, const Range& range, bool required) {
  const auto take = [&value, range](std::string_view text) {
    const std::string_view unit = text.size() > 3 ? text.substr(text.size() - 3) : std::string_view{};
    const bool has_unit = unit == "deg" || unit == "rad";
    const double number = read_number(has_unit ? text.substr(0, text.size() - 3) : text, range);
    const double angle = unit == "deg" ? number * std::numbers::pi / 180.0 : number;
    // The conversion to radians may overflow or leave the range.
    if (!range.contains(angle)) throw std::invalid_argument("got '" + std::string(text) + "', expected " + std::string(range.text));
    value = angle;
  };
  return {key, take, required};
}

void read_key_values(std::string_view text, const std::vector<KeyValue>& keys) {
  std::string expected;
  std::vector<std::string_view> names;
  for (const KeyValue& key : keys) {
    names.push_back(key.key);
    const std::string item = std::string(key.key).append("=").append(key.kind);
    expected += expected.empty() ? item : key.required ? "," + item : "[," + item + "]";
  }
  std::vector<bool> seen(keys.size());
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view item = text.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyValue& key) { return key.key == item.substr(0, equals); });
    if (equals == std::string_view::npos || found == keys.end()) {
      throw std::invalid_argument("got '" + std::string(item) + "' in '" + std::string(text) + "', expected " + expected +
                                  did_you_mean(item.substr(0, equals), names));
    }
    const auto index = static_cast<std::size_t>(found - keys.begin());
    if (seen[index]) throw std::invalid_argument("'" + std::string(found->key) + "' twice in '" + std::string(text) + "', expected once");
    seen[index] = true;
    try {
      found->take(item.substr(equals + 1));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("'" + std::string(found->key) + "' in '" + std::string(text) + "': " + error.what());
    }
    begin = end + 1;
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].required && !seen[i]) {
      throw std::invalid_argument("no '" + std::string(keys[i].key) + "' in '" + std::string(text) + "', expected " + expected);
    }
  }
}

}  // namespace limitcurve::cli
