// SPDX-License-Identifier: MIT
#include "cli/commands/fit_friction.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/report/report_files.hpp"

namespace limitcurve::cli {

namespace {

/// Friction from each measured push, and from all of them. No row names a path: the report is the same wherever the data lie.
void write_pushes(const std::filesystem::path& output, const std::filesystem::path& data) {
  AtomicFile file(output / "patch_pushes.csv");
  Rows rows({file.output()}, {"data", "share", "exact", "ellipsoid"});
  AtomicFile fits_file(output / "patch_fits.csv");
  Rows fits({fits_file.output()}, {"data", "parameter", "value", "std_error", "unit"});
  for (const std::string name : {"tripod_hardboard_a", "tripod_plywood_a"}) {
    const std::string pushes = (data / "measured" / (name + ".csv")).string();
    const std::string patch = "points:" + (data / "measured" / (name + "_points.csv")).string();
    for (const fit::PushFriction& push : fit::push_friction(read_patch(patch), read_pushes(pushes), 1.0)) {
      rows.row(name, push.share, push.exact, push.ellipsoid);
    }
    for (const fit::Estimate& estimate : fit_friction(read_patch(patch), pushes, std::nullopt).estimates) {
      fits.row(name, estimate.name, estimate.value, estimate.std_error, estimate.unit);
    }
  }
  rows.finish();
  file.commit();
  fits.finish();
  fits_file.commit();
}

void write_errors(const std::filesystem::path& output) {
  GatheredRows errors(output / "patch_errors.csv");
  for (const std::string aspect : {"1", "1.25", "1.5", "2", "3", "4", "5"}) {
    errors.add({"validate", "--patch", "ellipse:law=hertz,b=1,a=" + aspect}, {{"shape", "hertz ellipse"}, {"aspect", aspect}});
    errors.add({"validate", "--patch", "rectangle:y=1,x=" + aspect}, {{"shape", "rectangle"}, {"aspect", aspect}});
  }
  errors.finish();
}

}  // namespace

void write_patch_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  write_pushes(output, data);
  write_errors(output);
}

}  // namespace limitcurve::cli
