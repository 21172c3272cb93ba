// SPDX-License-Identifier: MIT
#include "cli/commands/fit_friction.hpp"

#include <vector>

namespace limitcurve::cli {

namespace {

std::vector<fit::Push> read_pushes(const std::string& file, const FileColumns& columns) {
  std::vector<fit::Push> pushes;
  CsvReader reader(file, {"force_x", "force_y", "moment", "dx", "dy", "dtheta"}, {}, columns);
  while (reader.next()) {
    const auto number = [&reader](std::size_t column) { return reader.number(column, finite); };
    pushes.push_back({{number(0), number(1), number(2)}, {number(3), number(4), number(5)}});
    const PatchTwist& moved = pushes.back().displacement;
    if (moved.vx == 0.0 && moved.vy == 0.0 && moved.omega == 0.0) throw reader.complaint(3, "no displacement, expected a push that slides");
  }
  return pushes;
}

}  // namespace

fit::FrictionFit fit_friction(const Patch& patch, const std::string& data, const std::optional<double>& load, const FileColumns& columns) {
  const std::vector<fit::Push> pushes = read_pushes(data, columns);
  try {
    return fit::fit_friction(patch, pushes, load.value_or(1.0), load ? "1" : "N");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(data + ": " + error.what());
  }
}

}  // namespace limitcurve::cli
