// SPDX-License-Identifier: MIT
// Entry d: how a step finds the wrench that friction allows, where the curve has corners.
#include "godobject/closest_point_projection.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/polygon.hpp"
#include "projection.hpp"
#include "random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

constexpr double infinity = std::numeric_limits<double>::infinity();

double normalised_distance(UnitWrench one, UnitWrench other, double moment_ratio) {
  return std::hypot(one.force - other.force, (one.moment - other.moment) / moment_ratio);
}

/// A polygon that does not tell its corners: all that a search for smooth curves sees.
template <class Polygon>
struct Unpolygonal {
  Polygon polygon;
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept { return polygon.wrench(twist); }
  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept { return polygon.point(twist); }
  [[nodiscard]] RadialPoint along(UnitWrench wrench) const noexcept { return polygon.along(wrench); }
  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept { return polygon.gauge(wrench); }
  [[nodiscard]] double moment_ratio() const noexcept { return polygon.moment_ratio(); }
};

/// The closest point of a polygon, by cutting an interval of each face to two thirds until it is rounding; in long double, for what
/// is left is its root.
template <class Polygon>
UnitWrench by_thirds(const Polygon& polygon, const Trial& trial) {
  UnitWrench best{};
  long double least = infinity;
  const auto& corners = polygon.vertices();
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const auto force = [&](long double t) { return corners[i].force + t * (corners[i + 1].force - corners[i].force); };
    const auto moment = [&](long double t) { return corners[i].moment + t * (corners[i + 1].moment - corners[i].moment); };
    const auto distance = [&](long double t) {
      const long double over_force = trial.wrench.force - force(t);
      const long double over_moment = trial.wrench.moment - moment(t);
      return over_force * over_force + trial.compliance_ratio * over_moment * over_moment;
    };
    long double low = 0.0L;
    long double high = 1.0L;
    for (int j = 0; j < 200; ++j) {
      const long double third = (high - low) / 3.0L;
      if (distance(low + third) < distance(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    if (distance(low) < least) {
      least = distance(low);
      best = {static_cast<double>(force(low)), static_cast<double>(moment(low))};
    }
  }
  return best;
}

struct CornerErrors {
  double distance = 0.0;  // of the wrench from the closest point
  double work = 0.0;      // the least slip work, in units of the limits
};

template <class Polygon>
std::array<CornerErrors, 2> corner_errors(const Polygon& polygon) {
  std::array<CornerErrors, 2> worst;
  const Unpolygonal<Polygon> hidden{polygon};
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    Trial trial;
    trial.compliance_ratio = random.logarithmic(0.1, 10.0);
    trial.wrench = {random.uniform(0.0, 3.0), random.uniform(0.0, 3.0) * polygon.moment_ratio()};
    if (!(polygon.gauge(trial.wrench) > 1.0 + 1e-6)) continue;
    const UnitWrench truth = by_thirds(polygon, trial);
    const std::array found{ClosestPoint{}(hidden, trial).wrench, ClosestPoint{}(polygon, trial).wrench};
    for (std::size_t j = 0; j < found.size(); ++j) {
      const auto [force, moment] = found[j];
      // Nearer than 1e-8 the search by thirds cannot tell.
      const double distance = normalised_distance(found[j], truth, polygon.moment_ratio());
      if (distance > 1e-8) worst[j].distance = std::max(worst[j].distance, distance);
      worst[j].work =
          std::min(worst[j].work, force * (trial.wrench.force - force) + trial.compliance_ratio * moment * (trial.wrench.moment - moment));
    }
  }
  return worst;
}

/// Ways from trials to the wrenches found for them, in the normalised plane; equal springs there.
template <class Polygon>
void draw(Figure& figure, const std::string& panel, const Polygon& polygon) {
  const Unpolygonal<Polygon> hidden{polygon};
  const double m0 = polygon.moment_ratio();
  int number = 0;
  for (const double x : {0.3, 0.7, 1.2, 1.6}) {
    for (const double y : {0.4, 0.8, 1.2, 1.6}) {
      Trial trial;
      trial.wrench = {x, y * m0};
      trial.compliance_ratio = 1.0 / (m0 * m0);
      if (!(polygon.gauge(trial.wrench) > 1.0)) continue;
      const auto add = [&](const std::string& series, UnitWrench wrench) {
        figure.rows.push_back({panel, series + std::to_string(number), x, y});
        figure.rows.push_back({panel, series + std::to_string(number), wrench.force, wrench.moment / m0});
      };
      add("search ", ClosestPoint{}(hidden, trial).wrench);
      add("ours ", ClosestPoint{}(polygon, trial).wrench);
      ++number;
    }
  }
}

}  // namespace

Hazard corners() {
  Hazard found;
  Figure figure{"projection_corners", {}};
  const std::string test = "Projection.Corners";
  const double m0 = hertz()->moment_ratio();
  const auto of_box = corner_errors(box(1.0, m0));
  const auto of_diamond = corner_errors(diamond(1.0, m0));
  const std::string hazard = "corners and faces";
  const std::string method = "search for the normal's wrench, ";
  draw(figure, "box", box(1.0, m0));
  draw(figure, "pyramid", diamond(1.0, m0));
  found.findings.push_back(
      {hazard, method + "box", "distance from the closest point, in the normalised plane", of_box[0].distance, of_box[1].distance, test});
  found.findings.push_back({hazard, method + "pyramid", "distance from the closest point, in the normalised plane", of_diamond[0].distance,
                            of_diamond[1].distance, test});
  found.findings.push_back({hazard, method + "box", "least slip work, in (μP)²/k_l (must be ≥ 0)", of_box[0].work, of_box[1].work, test});
  found.figures.push_back(std::move(figure));
  return found;
}

}  // namespace limitcurve::stability
