// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/output_file.hpp"
#include "cli/io/rows.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::cli {

/// One CSV file of the report, gathered from the rows of several subcommands. It appears whole, by `finish`, or not at all.
class GatheredRows {
 public:
  explicit GatheredRows(const std::filesystem::path& file) : file_(file) {}

  /// Adds the rows of `limitcurve ARGUMENTS…`, each with the `leading` cells before it.
  void add(const std::vector<std::string>& arguments, std::vector<std::pair<std::string, std::string>> leading = {});
  void finish() { file_.commit(); }

 private:
  AtomicFile file_;
  Messages silent_{Messages::Kind::none};  ///< what there is to say of them stands on the page
  bool first_ = true;
};

/// The CSV files from which the report is drawn; their columns are documented in scripts/figures/report.py.
/// `data` holds the materials and traces.
void write_curve_files(const std::filesystem::path& output);
void write_error_files(const std::filesystem::path& output);
void write_table_files(const std::filesystem::path& output, const std::filesystem::path& data);
void write_replay_files(const std::filesystem::path& output, const std::filesystem::path& data);
void write_steady_twist_file(const std::filesystem::path& output);
/// fits.csv: data,model and the columns of `fit`, for the measurements in data/fit. Of the fit to slips.csv, fit_band.csv:
/// force,moment,inner_force,inner_moment,outer_force,outer_moment, the fitted curve per newton and its 95 % band [1, m]; and
/// fit_residuals.csv: load,force,moment,sigma_force,sigma_moment,residual, in standard deviations.
void write_fit_files(const std::filesystem::path& output, const std::filesystem::path& data);
/// patch_pushes.csv: data,share,exact,ellipsoid, a push of data/measured a row: share of rotation, and power over P H and over the ellipsoid's;
/// patch_fits.csv: data,parameter,value,std_error,unit, by `fit friction`; patch_errors.csv: shape,aspect and the columns of `validate --patch`.
void write_patch_files(const std::filesystem::path& output, const std::filesystem::path& data);
/// pivot.csv: case,grip and the columns of `pivot`, grip being `release` or `operator`. pivot_map.csv:
/// case,offset,rate,angle: by how much the block has turned [rad] when it has slid 5 mm past the fingers or left them, over the
/// offset [m] of its centre of mass and the rate [N/s] at which the grip eases. pivot_materials.csv: material,case and the columns of `pivot`;
/// pivot_offsets.csv: material,case,offset,angle,grip_slip,reversals: what a slow operator achieves, with a hand's dampers. table_1.csv:
/// data/materials.csv. pivot_stiffness.csv: case,ratio,angle: by how much the block turns [rad] before it leaves the fingers, over
/// k_r/(k_l (mu_r/mu)^2). pinch.csv: friction (soft or point) and the columns of `replay` on pinch_trace.csv, data/scenes/pinch.csv.
void write_pivot_files(const std::filesystem::path& output, const std::filesystem::path& data);
/// work_precision_wrench.csv, …_step.csv and …_scaling.csv: what was measured for the figures in data/, as it stands there; its
/// columns are documented in data/README.md.
void write_work_precision_files(const std::filesystem::path& output, const std::filesystem::path& data);
/// translate.csv: law,radius_law,mu,load and the columns of `translate`.
void write_translate_file(const std::filesystem::path& output);

}  // namespace limitcurve::cli
