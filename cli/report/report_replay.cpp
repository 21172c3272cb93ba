// SPDX-License-Identifier: MIT
#include "cli/report/report_files.hpp"

#include "godobject/scene/replay.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/contact_radius.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <array>
#include <cmath>

namespace limitcurve::cli {

namespace {

// The finger that the traces are made for (data/README.md).
constexpr std::string_view law_name = "hertz";
constexpr std::string_view radius_law = "constant:a=0.006";
constexpr double friction = 0.6;
constexpr double stiffness = 1000.0;
constexpr double twist_stiffness = 0.036;

constexpr std::array<std::string_view, 3> traces{"press_drag_release", "press_twist_release", "slide_twist_load"};
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> methods{{{"ellipse", "radial"}, {"table", "closest-point"}}};

void write_replays(const std::filesystem::path& output, const std::filesystem::path& data) {
  GatheredRows replays(output / "replay.csv");
  for (const std::string_view trace : traces) {
    for (const auto& [curve, projection] : methods) {
      replays.add(
          {"replay", "--trace", (data / "traces" / (std::string(trace) + ".csv")).string(), "--law", std::string(law_name), "--radius-law",
           std::string(radius_law), "--mu", format_number(friction), "--stiffness", format_number(stiffness), "--twist-stiffness",
           format_number(twist_stiffness), "--curve", std::string(curve), "--projection", std::string(projection)},
          {{"trace", std::string(trace)}, {"boundary", std::string(curve)}, {"projection", std::string(projection)}});
    }
  }
  replays.finish();
}

void write_runs(const std::filesystem::path& output) {
  AtomicFile file(output / "replay_runs.csv");
  Rows rows({file.output()}, {"trace", "law", "radius_law", "mu", "stiffness", "twist_stiffness", "moment_ratio"});
  for (const std::string_view trace : traces) {
    rows.row(trace, law_name, radius_law, friction, stiffness, twist_stiffness, parse_law(law_name)->moment_ratio());
  }
  rows.finish();
  file.commit();
}

void write_limits(const std::filesystem::path& output) {
  constexpr std::array loads{0.5, 1.0, 1.5, 2.0, 3.0};
  constexpr std::size_t points = 91;
  const Law law = parse_law(law_name);
  const auto radius = RadiusLaw::parse(radius_law);
  AtomicFile file(output / "replay_limits.csv");
  Rows rows({file.output()}, {"trace", "boundary", "load", "force", "moment"});
  const auto add = [&](std::string_view name, const auto& curve) {
    for (const std::string_view trace : traces) {
      for (const double load : loads) {
        for (const LoadPoint& point : p_curve(curve, radius, friction, load, points)) {
          rows.row(trace, name, load, point.force, point.moment);
        }
      }
    }
  };
  add("ellipse", Ellipse::through_intercepts(law->moment_ratio()));
  add("table", Table::build(law, 1e-6));
  rows.finish();
  file.commit();
}

}  // namespace

void write_replay_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  write_replays(output, data);
  write_runs(output);
  write_limits(output);
}

void write_steady_twist_file(const std::filesystem::path& output) {
  using godobject::CurveKind;
  using godobject::Projection;
  // A contact of load 1 N, radius 1 m and friction 1: force and moment are unit wrenches.
  constexpr double pressing = 1000.0;  // N/m
  constexpr double cor = 1.0;          // on the rim
  constexpr int steps = 500;           // each as long as the springs' give: settled to rounding well before the end
  constexpr int ratios = 80;           // from 0.1 to 10
  const Law law = hertz();
  const double moment_ratio = law->moment_ratio();
  const UnitWrench exact = law->evaluate(cor).wrench;
  AtomicFile file(output / "steady_twist.csv");
  Rows rows({file.output()},
            {"law", "boundary", "projection", "cor", "stiffness_ratio", "force", "moment", "exact_force", "exact_moment", "error"});
  for (const CurveKind curve : {CurveKind::table, CurveKind::ellipse}) {
    for (const Projection projection : {Projection::closest_point, Projection::radial}) {
      for (int i = 0; i <= ratios; ++i) {
        const double ratio = std::pow(10.0, 2.0 * i / ratios - 1.0);
        godobject::ReplayOptions options;
        options.law = law;
        options.finger.radius_law = RadiusLaw::constant(1.0);
        options.finger.mu = 1.0;
        options.finger.stiffness = pressing;
        options.finger.twist_stiffness = ratio * pressing * moment_ratio * moment_ratio;
        options.curve = curve;
        options.projection = projection;
        options.tolerance = 1e-8;
        godobject::Replay replay(options);
        for (int step = 0; step <= steps; ++step) {
          const double x = step / pressing;
          godobject::DevicePose finger;
          finger.position = {x, 0.0, -1.0 / pressing};
          finger.twist = x / cor;
          replay.step(1e-3 * step, {&finger, 1});
        }
        const godobject::SceneContact& contact = replay.contacts().front();
        const UnitWrench settled{contact.force.norm(), std::abs(contact.moment)};
        const double error = std::hypot(settled.force - exact.force, (settled.moment - exact.moment) / moment_ratio);
        rows.row(law->name(), godobject::to_string(curve), godobject::to_string(projection), cor, ratio, settled.force, settled.moment,
                 exact.force, exact.moment, error);
      }
    }
  }
  rows.finish();
  file.commit();
}

}  // namespace limitcurve::cli
