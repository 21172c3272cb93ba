// SPDX-License-Identifier: MIT
#pragma once

#include "../law.hpp"

#include <string>
#include <vector>

/// The cheapest limit curve that is accurate enough.
namespace limitcurve {

/// A limit curve that may replace the exact one: its error and its cost.
struct Candidate {
  std::string model;  ///< diamond, box, ellipse, table, exact
  double parameter;   ///< as `limitcurve validate` prints it; the tolerance of a table; nan for the exact curve
  double
      error;  ///< largest radial error relative to the exact curve, over or under; inf for a table that cannot be built
  double nanoseconds;  ///< cost of a wrench from its slip twist
  bool chosen = false;
  std::string reason =
      {};  ///< for people: the error if it is too large, "chosen", or the cost compared with the chosen candidate's
};

/// Costs that differ by less than this fraction count as equal, because measured costs scatter as much.
inline constexpr double cost_tie = 0.05;

/// Returns all candidates for `law`, sorted by cost. `chosen` marks the cheapest one whose error is at most
/// `tolerance`; of equally cheap candidates, the most accurate. There always is one, because the exact curve has error
/// 0. The errors do not include the profile_error() of a measured pressure. To choose the projection as well, for a
/// whole scene, see godobject/scene/choose_step.hpp.
///
/// Costs are constants measured on a single machine (shipped_costs.hpp), so that every machine chooses alike. Compare
/// costs with each other; your machine may need more or less. Takes a millisecond for a closed form, a second by
/// quadrature. Throws std::invalid_argument for a tolerance outside [1e-10, 1] or a law that `checked` rejects.
std::vector<Candidate> choose(const Law& law, double tolerance);

/// Sorts candidates by cost, marks the cheapest whose error is at most `tolerance` (in a tie, the most accurate), and
/// sets each reason. If no candidate is accurate enough, none is marked.
void choose_cheapest(std::vector<Candidate>& candidates, double tolerance);

/// A fraction as text: "6.4 %", "0.9 %"; below 0.01 % "1.0e-06".
std::string in_percent(double fraction);

}  // namespace limitcurve
