// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/csv_reader.hpp"

#include "fit/friction_fit.hpp"
#include "fit/measurements.hpp"
#include "fit/ratio_fit.hpp"

#include <string>
#include <variant>
#include <vector>

namespace limitcurve::cli {

/// Of all of these: `columns` are the names and units of the file.

/// Reads slips from a CSV of load,force,moment[,sigma_force,sigma_moment]. Throws std::invalid_argument with the place
/// of the error.
std::vector<fit::Sample> read_slip_samples(const std::string& file, const FileColumns& columns = {});

/// Reads the data of `fit ratio`: slips as above, or, from a CSV without load, one published ratio,ratio_sd[,n] of a
/// material a row. Throws likewise.
std::variant<std::vector<fit::Sample>, std::vector<fit::RatioSample>> read_ratio_data(const std::string& file,
                                                                                      const FileColumns& columns = {});

/// Reads radii or moments from a CSV of load,radius[,sigma_radius] or load,moment[,sigma_moment]; throws likewise.
fit::LoadSamples read_load_samples(const std::string& file, const FileColumns& columns = {});

/// Reads pushes of a patch that slid from a CSV of force_x,force_y,moment,dx,dy,dtheta; throws likewise.
std::vector<fit::Push> read_pushes(const std::string& file, const FileColumns& columns = {});

}  // namespace limitcurve::cli
