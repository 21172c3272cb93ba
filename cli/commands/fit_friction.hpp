// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/csv_reader.hpp"
#include "fit/friction_fit.hpp"

#include <optional>
#include <string>

namespace limitcurve::cli {

/// Fits the friction of a patch to the pushes of a CSV file, force_x,force_y,moment,dx,dy,dtheta. `load` in [N]; without it mu is mu P.
fit::FrictionFit fit_friction(const Patch& patch, const std::string& data, const std::optional<double>& load,
                              const FileColumns& columns = {});

}  // namespace limitcurve::cli
