// SPDX-License-Identifier: MIT
#pragma once

#include "tests/repetitions.hpp"

#include <cstdlib>

namespace limitcurve::fit::synthetic {

/// How many seeded data sets a study fits: a tenth of `whole`, all where the environment says LIMITCURVE_WHOLE=1
/// (scripts/maintain/nightly does).
inline int data_sets(int whole) {
  const char* const text = std::getenv("LIMITCURVE_WHOLE");
  const bool all = text != nullptr && text[0] == '1';
  return repetitions(all ? whole : whole / 10, 10);
}

}  // namespace limitcurve::fit::synthetic
