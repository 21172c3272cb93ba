// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <string>
#include <vector>

namespace limitcurve {

/// A limit boundary that might do, and what it is worth.
struct Candidate {
  std::string model;   ///< box, ellipse, superellipse, quartic, table, exact
  double parameter;    ///< as `limitcurve validate` prints it; of the table its tolerance; nan of the exact curve
  double error;        ///< largest radial error relative to the exact curve, either way (boundary_error.hpp)
  double nanoseconds;  ///< of a wrench by its slip twist
  bool chosen = false;
};

/// The cheapest boundary for `law` whose error is at most `tolerance`, among those it beat: dearer ones that would also
/// do, cheaper ones that would not. Sorted by cost; one is chosen, since the exact curve always does.
///
/// Costs of the models are shipped figures, means of `bench_limitcurve` on one machine: read them as ratios. That of the
/// exact curve is measured here, because it depends on the law by four powers of ten, and given in the shipped unit.
/// Throws std::invalid_argument for a tolerance out of [1e-10, 1]. Cost: a millisecond for a closed form, a second
/// by quadrature.
std::vector<Candidate> choose(const Law& law, double tolerance);

}  // namespace limitcurve
