// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limitcurve {

/// The text as one word of a POSIX shell, for every line that is printed to be typed: as it is where a shell leaves it
/// alone, else quoted.
inline std::string shell_word(std::string_view text) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace limitcurve
