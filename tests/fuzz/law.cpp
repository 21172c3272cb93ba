// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "tests/fuzz/honest_law.hpp"

using namespace limitcurve;

/// The grammar of the pressure laws: what it accepts has a name that makes the same law, and evaluates honestly.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Law law;
  if (fuzz::complaint_of([&] { law = parse_law(fuzz::as_text(data, size)); })) return 0;
  Law again;
  fuzz::require(!fuzz::complaint_of([&] { again = parse_law(law->name()); }), "a law's own name is refused");
  fuzz::require(again->name() == law->name(), "a law's own name makes another law");
  fuzz::require_honest(*law);
  const WrenchEstimate one = law->evaluate(0.7);
  const WrenchEstimate other = again->evaluate(0.7);
  fuzz::require(one.wrench == other.wrench, "a law's own name makes another wrench");
  return 0;
}
