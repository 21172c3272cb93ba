// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <string>
#include <vector>

namespace limitcurve {

/// A limit boundary that might do, and what it is worth.
struct Candidate {
  std::string model;   ///< diamond, box, ellipse, superellipse, quartic, table, exact
  double parameter;    ///< as `limitcurve validate` prints it; of the table its tolerance; nan of the exact curve
  double error;        ///< largest radial error relative to the exact curve, either way (boundary_error.hpp); inf of a table that cannot be
                       ///< built to what the tolerance needs
  double nanoseconds;  ///< of a wrench by its slip twist
  bool chosen = false;
  std::string reason = {};  ///< in words: what it is too wrong by, "chosen", or what it costs more than the chosen one
};

/// The cheapest boundary for `law` whose error is at most `tolerance`, among those it beat: dearer ones that would also
/// do, cheaper ones that would not. Sorted by cost; one is chosen, since the exact curve always does.
///
/// Costs are shipped figures (shipped_costs.hpp), measured on one machine: read them as ratios. The same input gives the same choice everywhere.
/// Throws std::invalid_argument for a tolerance out of [1e-10, 1]. Cost: a millisecond for a closed form, a second
/// by quadrature. For what a whole scene needs, projection included: godobject/choose_step.hpp.
std::vector<Candidate> choose(const Law& law, double tolerance);

/// Sorts candidates by cost, and chooses the cheapest whose error is at most `tolerance`, or, where none is, that of the least error; gives each
/// its reason.
void choose_cheapest(std::vector<Candidate>& candidates, double tolerance);

/// A fraction as people read it: "6.4 %", "0.9 %", and below 0.01 % as "1e-6".
std::string in_percent(double fraction);

}  // namespace limitcurve
