// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <version>

#ifdef _LIBCPP_VERSION
#include <locale.h>
#include <cstdlib>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

namespace limitcurve {

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("nan");
}

std::string format_number(double value, int digits) {
  if (!std::isfinite(value)) return format_number(value);
  std::array<char, 32> buffer{};
  return {buffer.data(),
          std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr};
}

#ifndef _LIBCPP_VERSION
std::optional<double> parse_number(std::string_view text) {
  // from_chars rejects a leading plus, but spreadsheets write it.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small or too large for a double: return the nearest double. (strtod would depend on the locale.)
    long double wide = 0.0L;
    if (std::from_chars(text.data(), end, wide).ec == std::errc{}) return static_cast<double>(wide);
    const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    value = std::copysign(tiny ? 0.0 : HUGE_VAL, text[0] == '-' ? -1.0 : 1.0);
  } else if (error != std::errc{}) {
    return std::nullopt;
  }
  return value;
}
#else
// Clang's libc++ has no from_chars of numbers, or none of long double.
std::optional<double> parse_number(std::string_view text) {
  // strtod also takes blanks before a number, and hexadecimal digits.
  if (text.empty() || text.find_first_of("xX \t\n\v\f\r") != std::string_view::npos) return std::nullopt;
  static const locale_t c_locale = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string copy(text);
  char* stop = nullptr;
  const double value = strtod_l(copy.c_str(), &stop, c_locale);
  return stop == copy.c_str() + copy.size() ? std::optional(value) : std::nullopt;
}
#endif

std::invalid_argument out_of_range(std::string_view name, double value, std::string_view unit, std::string_view range) {
  std::string message(name);
  message += " = " + format_number(value);
  if (unit != "1") message.append(" ").append(unit);
  message.append(" is out of range: expected ").append(range);
  return std::invalid_argument(message);
}

}  // namespace limitcurve
