// SPDX-License-Identifier: MIT
#include "cli/io/argument_parts.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/internal/range.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace limitcurve;
using namespace limitcurve::cli;

namespace {

struct Grip {
  double from = -1.0;
  double to = -1.0;
  double target = 0.0;
};

std::optional<std::string> read(std::string_view text, Grip& grip) {
  return fuzz::complaint_of([&] {
    read_key_values(
        text, {number_key("from", grip.from, ranges::positive), number_key("to", grip.to, ranges::non_negative, false),
               angle_key("target", grip.target, ranges::finite, false)});
  });
}

}  // namespace

/// The lists of the command line, `from=2,to=0,target=30deg` and `0.25,0.5,1`: values within their ranges, or a
/// complaint.
static const fuzz::Target key_values_target("key_values", [](std::string_view text) {
  Grip grip;
  if (!read(text, grip)) {
    fuzz::require(grip.from > 0.0 && fuzz::is_finite(grip.from), "a key out of its range");
    fuzz::require(fuzz::is_finite(grip.to) && fuzz::is_finite(grip.target), "a key that is not finite");
    Grip again;
    std::string written = "target=" + format_number(grip.target) + "rad,from=" + format_number(grip.from);
    if (grip.to >= 0.0) written += ",to=" + format_number(grip.to);
    fuzz::require(!read(written, again), "the values that were read are refused");
    fuzz::require(
        fuzz::same(again.from, grip.from) && fuzz::same(again.to, grip.to) && fuzz::same(again.target, grip.target),
        "the values that were read do not come back");
  }

  std::vector<double> numbers;
  if (fuzz::complaint_of([&] { numbers = read_number_list(text, ranges::distance); })) return;
  std::string written;
  for (const double number : numbers) {
    fuzz::require(number >= 0.0, "an item out of its range");
    if (!written.empty()) written += ',';
    written += format_number(number);
  }
  fuzz::require(read_number_list(written, ranges::distance) == numbers, "a list does not come back");
});
