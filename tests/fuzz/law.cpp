// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "tests/fuzz/honest_law.hpp"

using namespace limitcurve;

/// The grammar of the pressure laws: what it accepts has a name that makes the same law, and evaluates honestly.
static const fuzz::Target law_target("law", [](std::string_view text) {
  Law law;
  if (fuzz::complaint_of([&] { law = parse_law(text); })) return;
  Law again;
  fuzz::require(!fuzz::complaint_of([&] { again = parse_law(law->name()); }), "a law's own name is refused");
  fuzz::require(again->name() == law->name(), "a law's own name makes another law");
  fuzz::require_honest(*law, text);
  const UnitForces<double> one = law->forces(0.7);
  const UnitForces<double> other = again->forces(0.7);
  fuzz::require(one.force == other.force && one.moment == other.moment, "a law's own name makes another wrench");
});
