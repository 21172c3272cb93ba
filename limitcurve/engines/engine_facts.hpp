// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limitcurve::engines {

/// data/engines/engines.csv and coefficients.csv: the facts about engines, of which this is the only home.
extern const std::string_view engines_csv;
extern const std::string_view coefficients_csv;

}  // namespace limitcurve::engines
