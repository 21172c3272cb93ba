// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/friction_fit.hpp"

#include <optional>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// The pushes of a CSV file, force_x,force_y,moment,dx,dy,dtheta.
std::vector<fit::Push> read_pushes(const std::string& file);

/// The friction of a patch from a CSV of pushes, force_x,force_y,moment,dx,dy,dtheta. `load` [N]; without it mu is mu P.
std::vector<fit::Estimate> fit_friction(const std::string& patch, const std::string& data, const std::optional<double>& load);

}  // namespace limitcurve::cli
