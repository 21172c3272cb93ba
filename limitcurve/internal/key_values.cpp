// SPDX-License-Identifier: MIT
#include "limitcurve/internal/key_values.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <stdexcept>

namespace limitcurve {

double read_number(std::string_view text, const std::optional<Range>& range) {
  const auto value = parse_number(text);
  if (value && (!range || range->contains(*value))) return *value;
  throw std::invalid_argument("got '" + std::string(text) + "', expected " +
                              (range ? std::string(range->text) : "a number"));
}

KeyValue number_key(std::string_view key, double& value, const std::optional<Range>& range, bool required) {
  return {key, [&value, range](std::string_view text) { value = read_number(text, range); }, required};
}

Description split_description(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {text, std::nullopt};
  return {text.substr(0, colon), text.substr(colon + 1)};
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
  while (!text.empty() && begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view item = text.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const KeyValue& key) { return key.key == item.substr(0, equals); });
    if (equals == std::string_view::npos || found == keys.end()) {
      throw std::invalid_argument("got '" + std::string(item) + "' in '" + std::string(text) + "', expected " +
                                  expected + did_you_mean(item.substr(0, equals), names));
    }
    const auto index = static_cast<std::size_t>(found - keys.begin());
    if (seen[index])
      throw std::invalid_argument("'" + std::string(found->key) + "' twice in '" + std::string(text) +
                                  "', expected once");
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
      throw std::invalid_argument("no '" + std::string(keys[i].key) + "' in '" + std::string(text) + "', expected " +
                                  expected);
    }
  }
}

}  // namespace limitcurve
