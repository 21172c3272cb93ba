// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace limitcurve;

/// Numbers: any double comes back through its text, and any text that is a number is the number that strtod sees.
static const fuzz::Target number_target("number", [](std::string_view text) {
  const double value = fuzz::Bytes(text).take<double>();
  const auto again = parse_number(format_number(value));
  fuzz::require(again && fuzz::same(*again, value), "a double does not come back through its text");

  const auto number = parse_number(text);
  if (!number) return;
  const auto back = parse_number(format_number(*number));
  fuzz::require(back && fuzz::same(*back, *number), "a number that was read does not come back through its text");
  const std::string terminated(text);
  char* end = nullptr;
  const double expected = std::strtod(terminated.c_str(), &end);
  fuzz::require(end == terminated.c_str() + terminated.size(), "a number that strtod does not know");
  fuzz::require(fuzz::same(*number, expected), "another number than strtod's");
});
