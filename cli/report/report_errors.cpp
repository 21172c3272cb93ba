// SPDX-License-Identifier: MIT
#include "cli/report/report_files.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace limitcurve::cli {

namespace {

void write_ellipse_error(const std::filesystem::path& output) {
  constexpr int directions = 180;
  AtomicFile file(output / "ellipse_error.csv");
  Rows rows({file.output()}, {"law", "angle", "over_estimate", "cor_ratio"});
  for (const std::string_view name : law_examples()) {
    const ExactCurve exact(parse_law(name));
    const auto ellipse = Ellipse::through_intercepts(exact.moment_ratio());
    for (int i = 0; i <= directions; ++i) {
      const double angle = 0.5 * std::numbers::pi * i / directions;
      // On an axis both curves have the same point and the same COR, 0 or inf, whose ratio only a limit could tell.
      double over_estimate = 0.0;
      double cor_ratio = std::numeric_limits<double>::quiet_NaN();
      if (i > 0 && i < directions) {
        const RadialPoint point = exact.along({std::cos(angle), std::sin(angle) * exact.moment_ratio()});
        over_estimate = 1.0 / ellipse.gauge(point.wrench) - 1.0;
        cor_ratio = ellipse.along(point.wrench).normal.cor() / point.normal.cor();
      }
      rows.row(name, angle, over_estimate, cor_ratio);
    }
  }
  rows.finish();
  file.commit();
}

void write_table_error(const std::filesystem::path& output) {
  constexpr int places = 4000;
  constexpr double tolerance = 1e-8;
  AtomicFile file(output / "table_error.csv");
  Rows rows({file.output()}, {"law", "tolerance", "spin_fraction", "force_error", "moment_error"});
  for (const std::string_view name : {"hertz", "uniform"}) {
    const Law law = parse_law(name);
    const auto table = Table::build(law, tolerance);
    for (int i = 0; i <= places; ++i) {
      const double u = static_cast<double>(i) / places;
      const SlipTwist twist = SlipTwist::of_spin_fraction(u);
      const UnitWrench exact = law->evaluate(twist.cor()).wrench;
      const UnitWrench tabulated = table.wrench(twist);
      rows.row(name, tolerance, u, tabulated.force - exact.force, tabulated.moment - exact.moment);
    }
  }
  rows.finish();
  file.commit();
}

}  // namespace

void write_error_files(const std::filesystem::path& output) {
  GatheredRows validate(output / "validate.csv");
  validate.add({"validate"});
  validate.finish();
  write_ellipse_error(output);
  write_table_error(output);
}

}  // namespace limitcurve::cli
