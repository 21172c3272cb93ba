// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <functional>
#include <iterator>

namespace limitcurve::fuzz {

/// What every law that was accepted must satisfy: finite, of the right sign, and no force above 1.
inline void require_honest_at(const PressureLaw& law, double s) {
  const WrenchEstimate at = law.evaluate(s);
  for (const double value : {at.wrench.force, at.wrench.moment, at.error.force, at.error.moment}) {
    require(is_finite(value), "a law evaluates to what is not finite");
    require(value >= 0.0, "a law evaluates to a negative value");
  }
  require(at.wrench.force <= 1.0 + at.error.force + 1e-12, "a law bears more force than the load allows");
  const UnitForces<double> quick = law.forces(s);
  require(is_finite(quick.force) && is_finite(quick.moment), "a law's forces are not finite");
  require(quick.force >= 0.0 && quick.moment >= 0.0, "a law's forces are negative");
}

/// The same at a few places; in a search at one of them, which the input chooses: the parser is what a search is for,
/// and most of the time would go into quadrature.
inline void require_honest(const PressureLaw& law, std::string_view input) {
  constexpr double places[] = {0.0, 1e-9, 0.4, 1.0, 3.0, 1e9, std::numeric_limits<double>::infinity()};
#ifdef LIMITCURVE_SEARCHES
  require_honest_at(law, places[std::hash<std::string_view>{}(input) % std::size(places)]);
#else
  static_cast<void>(input);
  for (const double s : places) require_honest_at(law, s);
#endif
}

}  // namespace limitcurve::fuzz
