// SPDX-License-Identifier: MIT
#include "cli/csv_reader.hpp"
#include "cli/subcommands.hpp"

#include "godobject/replay.hpp"
#include "godobject/rigid_body.hpp"
#include "limitcurve/number.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

using godobject::BoundaryKind;
using godobject::ProjectionKind;

constexpr std::array boundaries{BoundaryKind::exact,        BoundaryKind::table,   BoundaryKind::ellipse,
                                BoundaryKind::superellipse, BoundaryKind::quartic, BoundaryKind::box};
constexpr std::array projections{ProjectionKind::radial, ProjectionKind::c_curve, ProjectionKind::closest_point};

template <class Kinds>
std::vector<std::string> names(const Kinds& kinds) {
  std::vector<std::string> result;
  for (const auto kind : kinds) result.emplace_back(godobject::to_string(kind));
  return result;
}

/// A trace with the finger's twist about the plane's normal, or its orientation as a quaternion from which that follows.
class TraceReader {
 public:
  explicit TraceReader(const std::string& file) : reader_(file, {"time", "x", "y", "z"}, {"twist", "qw", "qx", "qy", "qz"}) {
    bool oriented = true;
    for (std::size_t column = first_of_orientation; column < first_of_orientation + 4; ++column) oriented = oriented && reader_.has(column);
    if (!oriented && !reader_.has(twist)) throw reader_.no_column("'twist', nor qw,qx,qy,qz");
  }

  /// The next sample; nothing after the last.
  std::optional<godobject::TraceSample> next() {
    if (!reader_.next()) return std::nullopt;
    return godobject::TraceSample{reader_.number(0, finite), reader_.number(1, finite), reader_.number(2, finite),
                                  reader_.number(3, finite), reader_.has(twist) ? reader_.number(twist, finite) : twist_of_orientation()};
  }

 private:
  static constexpr std::size_t twist = 4;
  static constexpr std::size_t first_of_orientation = 5;

  [[nodiscard]] double twist_of_orientation() const {
    const Eigen::Quaterniond orientation(number(0), number(1), number(2), number(3));
    // Devices round; what is off by more is no rotation.
    if (std::abs(orientation.norm() - 1.0) > 1e-3) {
      throw reader_.complaint(first_of_orientation, "the quaternion has length " + format_number(orientation.norm()) + ", expected 1");
    }
    return godobject::twist_about(orientation, Eigen::Vector3d::UnitZ());
  }
  [[nodiscard]] double number(std::size_t component) const { return reader_.number(first_of_orientation + component, finite); }

  CsvReader reader_;
};

class Replay final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"replay", "Runs the god-object over a recorded motion of a finger on the plane z = 0",
            "The trace has columns time,x,y,z,twist [s, m, m, m, rad], or qw,qx,qy,qz (a unit quaternion, finger to world) in\n"
            "place of twist; both may wrap around. The plane's outward normal is +z, the penetration -z.\n"
            "Columns: time; state free|stick|slip|invalid (a sample earlier than the one before it); px,py [m] and angle\n"
            "[rad] of the proxy; depth [m]; load [N]; fx,fy [N] and moment [N m], the friction that the user feels;\n"
            "cor [m], the distance of the slip's centre of rotation (nan unless it slips).",
            "limitcurve replay --trace data/traces/slide_twist_load.csv --law hertz --radius-law constant:a=0.006 --mu 0.6\n"
            "    --stiffness 1000 --twist-stiffness 0.036 --boundary table --projection closest-point"};
  }

  void declare(Options& options) override {
    options.text("--trace", trace_, "FILE", "CSV with columns time,x,y,z,twist, or - for standard input", Presence::required);
    options.law(settings_.law);
    options.radius_law(radius_law_, Presence::optional);
    options.number("--mu", settings_.mu, non_negative, "Friction coefficient mu [1]", Presence::required);
    options.number("--stiffness", settings_.stiffness, positive, "Contact stiffness k_l [N/m]; the load is P = k_l d", Presence::required);
    options.number("--twist-stiffness", settings_.twist_stiffness, positive, "Torsional stiffness k_r [N m/rad]", Presence::required);
    options.number("--mu-dynamic", settings_.mu_dynamic, non_negative, "Friction coefficient while slipping (mu if left out)");
    options.number("--moment-coefficient", settings_.moment_coefficient, non_negative,
                   "mu_r [m]: the largest moment is mu_r P, whatever the radius law");
    options.choice("--boundary", boundary_, names(boundaries), "Limit curve");
    options.choice("--projection", projection_, names(projections), "How the proxy is brought back on to it");
    options.number("--tolerance", settings_.tolerance, positive, "Error of the table, in unit wrenches");
  }

  void run(const Results& results) override {
    if (radius_law_) {
      settings_.radius_law = *radius_law_;
    } else if (!settings_.moment_coefficient) {
      throw std::invalid_argument("--radius-law is required, unless --moment-coefficient is given");
    }
    settings_.boundary = boundaries.at(boundary_);
    settings_.projection = projections.at(projection_);
    TraceReader trace(trace_);
    godobject::Replay replay(settings_);
    Rows rows(results, {"time", "state", "px", "py", "angle", "depth", "load", "fx", "fy", "moment", "cor"});
    while (const auto sample = trace.next()) {
      const godobject::ReplayRow row = replay.step(*sample);
      rows.row(row.time, godobject::to_string(row.state), row.px, row.py, row.angle, row.depth, row.load, row.fx, row.fy, row.moment,
               row.cor);
    }
    rows.finish();
  }

 private:
  std::string trace_;
  std::optional<RadiusLaw> radius_law_;
  std::size_t boundary_ = 1;
  std::size_t projection_ = 2;
  godobject::ReplayOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_replay() {
  return std::make_unique<Replay>();
}

}  // namespace limitcurve::cli
