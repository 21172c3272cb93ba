// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/did_you_mean.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve {

/// The names joined by "|", as in help and messages, or by another separator.
inline std::string joined(std::span<const std::string_view> names, std::string_view separator = "|") {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "" : separator).append(name);
  return text;
}

/// The value of an enumeration whose names, in its order from 0 on, are these; "_" counts as "-". Throws
/// std::invalid_argument, which has the noun, the text and the names, for a text that is none.
template <class Kind>
Kind parse_name(std::span<const std::string_view> names, std::string_view noun, std::string_view text) {
  std::string given(text);
  std::replace(given.begin(), given.end(), '_', '-');
  const auto found = std::find(names.begin(), names.end(), given);
  if (found == names.end()) {
    throw std::invalid_argument(std::string(noun) + " '" + std::string(text) + "': expected " + joined(names) +
                                did_you_mean(given, {names.begin(), names.end()}));
  }
  return static_cast<Kind>(found - names.begin());
}

}  // namespace limitcurve
