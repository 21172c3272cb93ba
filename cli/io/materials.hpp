// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limitcurve::cli {

/// Friction of a material under a fingertip.
struct Material {
  std::string_view name;
  double mu;    ///< μ_l [1]
  double mu_r;  ///< largest moment over load [m]
};

/// Finds a material of the paper's Table 1 by its name; throws std::invalid_argument with the list of names.
Material find_material(std::string_view name);

}  // namespace limitcurve::cli
