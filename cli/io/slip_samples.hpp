// SPDX-License-Identifier: MIT
#pragma once

#include "fit/measurements.hpp"
#include "fit/ratio_fit.hpp"

#include <string>
#include <variant>
#include <vector>

namespace limitcurve::cli {

/// The slips in a CSV of load,force,moment[,sigma_force,sigma_moment]. Throws std::invalid_argument that names the place.
std::vector<fit::Sample> read_slip_samples(const std::string& file);

/// What `fit ratio` takes: slips as above, or, in a CSV without load, the published ratio,ratio_sd of a material a row; throws likewise.
std::variant<std::vector<fit::Sample>, std::vector<fit::RatioSample>> read_ratio_data(const std::string& file);

/// The radii or moments in a CSV of load,radius[,sigma_radius] or load,moment[,sigma_moment]; throws likewise.
fit::LoadSamples read_load_samples(const std::string& file);

}  // namespace limitcurve::cli
