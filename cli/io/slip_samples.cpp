// SPDX-License-Identifier: MIT
#include "cli/io/slip_samples.hpp"

#include <map>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

const std::vector<std::string> sample_columns{"load", "force", "moment", "sigma_force", "sigma_moment", "grip"};

/// Of a file whose first columns are those of slips.
std::vector<fit::Sample> slips(CsvReader& reader) {
  if (reader.has(3) != reader.has(4)) {
    throw reader.complaint_at(0, "one of the columns sigma_force and sigma_moment is missing: give both, or none");
  }
  std::vector<fit::Sample> samples;
  std::map<double, std::size_t> grips;
  while (reader.next()) {
    fit::Sample sample{reader.number(0, positive), reader.number(1, finite), reader.number(2, finite)};
    if (reader.has(3)) {
      sample.sigma_force = reader.number(3, positive);
      sample.sigma_moment = reader.number(4, positive);
    } else if (reader.has_sigmas()) {
      sample.sigma_force = reader.sigma(1);
      sample.sigma_moment = reader.sigma(2);
    }
    sample.row = reader.row();
    sample.grip =
        reader.has(5) ? grips.try_emplace(reader.number(5, finite), grips.size() + 1).first->second : reader.grip();
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace

std::vector<fit::Sample> read_slip_samples(const std::string& file, const FileColumns& columns) {
  CsvReader reader(file, {sample_columns.begin(), sample_columns.begin() + 3},
                   {sample_columns.begin() + 3, sample_columns.end()}, columns);
  return slips(reader);
}

std::variant<std::vector<fit::Sample>, std::vector<fit::RatioSample>> read_ratio_data(const std::string& file,
                                                                                      const FileColumns& file_columns) {
  std::vector<std::string> columns = sample_columns;
  columns.insert(columns.end(), {"ratio", "ratio_sd", "n"});
  const std::size_t ratio = sample_columns.size();
  CsvReader reader(file, {}, columns, file_columns, "load,force,moment or ratio,ratio_sd");
  const auto require = [&](std::size_t column) {
    if (!reader.has(column)) throw reader.no_column(columns[column]);
  };
  if (reader.has(0) || !reader.has(ratio)) {
    for (const std::size_t column : {0U, 1U, 2U}) require(column);
    return slips(reader);
  }
  require(ratio + 1);
  constexpr Range counted{1.0, largest, "a finite number >= 1; if it is not known, leave out the column"};
  std::vector<fit::RatioSample> ratios;
  while (reader.next()) {
    ratios.push_back({reader.number(ratio, positive), reader.number(ratio + 1, positive),
                      reader.has(ratio + 2) ? reader.number(ratio + 2, counted) : 0.0});
  }
  return ratios;
}

fit::LoadSamples read_load_samples(const std::string& file, const FileColumns& columns) {
  CsvReader reader(file, {"load"}, {"radius", "moment", "sigma_radius", "sigma_moment"}, columns,
                   "load,radius or load,moment");
  if (reader.has(1) == reader.has(2))
    throw reader.complaint_at(
        0, std::string("got ") + (reader.has(1) ? "both" : "none") + " of the columns radius and moment, expected one");
  const std::size_t value = reader.has(1) ? 1 : 2;
  const std::size_t sigma = value + 2;
  fit::LoadSamples samples{value == 1 ? fit::LoadSamples::Quantity::radius : fit::LoadSamples::Quantity::moment, {}};
  while (reader.next()) {
    samples.samples.push_back({reader.number(0, positive), reader.number(value, positive),
                               reader.has(sigma) ? reader.number(sigma, positive) : 0.0, reader.row()});
  }
  return samples;
}

std::vector<fit::Push> read_pushes(const std::string& file, const FileColumns& columns) {
  std::vector<fit::Push> pushes;
  CsvReader reader(file, {"force_x", "force_y", "moment", "dx", "dy", "dtheta"}, {}, columns);
  while (reader.next()) {
    const auto number = [&reader](std::size_t column) { return reader.number(column, finite); };
    pushes.push_back({{number(0), number(1), number(2)}, {number(3), number(4), number(5)}, reader.row()});
    const PatchTwist& moved = pushes.back().displacement;
    if (moved.vx == 0.0 && moved.vy == 0.0 && moved.omega == 0.0)
      throw reader.complaint(3, "no displacement, expected a push that slides");
  }
  return pushes;
}

}  // namespace limitcurve::cli
