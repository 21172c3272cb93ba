// SPDX-License-Identifier: MIT
#pragma once

#include "fit/measurements.hpp"

#include <string>
#include <vector>

namespace limitcurve::cli {

/// The slips in a CSV of load,force,moment[,sigma_force,sigma_moment]. Throws std::invalid_argument that names the place.
std::vector<fit::Sample> read_slip_samples(const std::string& file);

/// The radii or moments in a CSV of load,radius[,sigma_radius] or load,moment[,sigma_moment]; throws likewise.
fit::LoadSamples read_load_samples(const std::string& file);

}  // namespace limitcurve::cli
