// SPDX-License-Identifier: MIT
// Entry "tables": limit curves as lookup tables.
#include "../failures.hpp"

#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "sampling.hpp"
#include "truth.hpp"

#include <math.h>  // NOLINT: Boost 1.74's interpolators need it

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limitcurve::stability {

namespace {

using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

/// The usual table: `nodes` evenly spaced points on [0, last], values and exact slopes, a cubic between.
class EvenTable {
 public:
  EvenTable(const PressureLaw& law, double last, int nodes) : step_(last / (nodes - 1)) {
    for (const double s : evenly(0.0, last, nodes)) nodes_.push_back(law.forces(s));
  }

  /// Beyond the last node the last cubic extrapolated.
  [[nodiscard]] UnitWrench wrench(double s) const {
    const double place = std::min(std::floor(s / step_), static_cast<double>(nodes_.size() - 2));
    const auto i = static_cast<std::size_t>(place);
    const double left = step_ * place;
    const double t = (s - left) / step_;
    const UnitForces<double>& from = nodes_[i];
    const UnitForces<double>& to = nodes_[i + 1];
    return {
        hermite(t, from.force, to.force, step_ * from.force_slope, step_ * to.force_slope),
        hermite(t, from.moment, to.moment, -step_ * left * from.force_slope, -step_ * (left + step_) * to.force_slope)};
  }

 private:
  static double hermite(double t, double from, double to, double from_slope, double to_slope) {
    const double r = 1.0 - t;
    return r * r * ((1.0 + 2.0 * t) * from + t * from_slope) + t * t * ((1.0 + 2.0 * r) * to - r * to_slope);
  }

  double step_;
  std::vector<UnitForces<double>> nodes_;
};

/// Test points for an interpolant inside and just outside the rim: evenly spaced, and dense at the rim.
std::vector<std::pair<double, ExactWrench>> flat_punch_around_the_rim(double last) {
  std::vector<std::pair<double, ExactWrench>> places;
  for (const double s : evenly(0.0013, last, 1200)) places.emplace_back(s, exact_flat_punch(s));
  for (const double distance : in_ratios(1e-6, 0.2, 160)) {
    places.emplace_back(1.0 - distance, exact_flat_punch(1.0 - distance));
    places.emplace_back(1.0 + distance, exact_flat_punch(1.0 + distance));
  }
  std::sort(places.begin(), places.end(), [](const auto& one, const auto& other) { return one.first < other.first; });
  return places;
}

double absolute_error(UnitWrench wrench, const ExactWrench& exact) {
  return std::max({static_cast<double>(abs(Exact(wrench.force - exact.force))),
                   static_cast<double>(abs(Exact(wrench.moment - exact.moment))), 1e-17});
}

/// A value rounded to four decimals, as in a file.
double printed(double value) {
  return std::round(value * 1e4) / 1e4;
}

/// A curve from pure slide to pure spin, as closely spaced points.
using Polyline = std::vector<UnitWrench>;
constexpr int polyline_points = 8001;

/// A cubic spline of f and another of m over the spin fraction, through `nodes` even places, each value to four
/// decimals.
Polyline splined(const PressureLaw& law, int nodes) {
  std::vector<double> force;
  std::vector<double> moment;
  for (const double u : evenly(0.0, 1.0, nodes)) {
    const UnitForces<double> at = law.forces(SlipTwist::of_spin_fraction(u).cor());
    force.push_back(printed(at.force));
    moment.push_back(printed(at.moment));
  }
  const double step = 1.0 / (nodes - 1);
  const Spline f(force.begin(), force.end(), 0.0, step);
  const Spline m(moment.begin(), moment.end(), 0.0, step);
  Polyline points;
  for (const double u : evenly(0.0, 1.0, polyline_points)) points.push_back({f(u), m(u)});
  return points;
}

Polyline tabulated(const Table& table) {
  Polyline points;
  for (const double u : evenly(0.0, 1.0, polyline_points))
    points.push_back(table.wrench(SlipTwist::of_spin_fraction(u)));
  return points;
}

double power(UnitWrench wrench, double u) {
  return (1.0 - u) * wrench.force + u * wrench.moment;
}

/// Wrenches at which a finger can rest under one steady twist, if each step moves its wrench to the closest point of
/// the curve: local maxima of the dissipated power. The most, of 99 twists.
double rests(const Polyline& curve) {
  int most = 0;
  for (const double u : evenly(0.01, 0.99, 99)) {
    int count = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double here = power(curve[i], u);
      if ((i == 0 || here > power(curve[i - 1], u)) && (i + 1 == curve.size() || here >= power(curve[i + 1], u)))
        ++count;
    }
    most = std::max(most, count);
  }
  return most;
}

}  // namespace

Hazard even_spacing() {
  Hazard found;
  Figure& figure = found.draw("tables_spacing");
  const Law law = flat_punch();
  constexpr double last = 3.0;
  const auto places = flat_punch_around_the_rim(last);
  const auto worst_of = [&](const auto& wrench) {
    double worst = 0.0;
    for (const auto& [s, exact] : places) raise(worst, absolute_error(wrench(s), exact));
    return worst;
  };
  const auto even_error = [&](int nodes) {
    const EvenTable table(*law, last, nodes);
    return worst_of([&](double s) { return table.wrench(s); });
  };
  for (const double nodes : in_ratios(8.0, 1000.0, 30)) {
    const int even = 2 * static_cast<int>(nodes / 2.0);
    figure.add("numbers", "even nodes", 3.0 * even, even_error(even));
  }
  const TableOptions fewest{.preferred_bytes = 1};  // of the highest degree, which needs the fewest numbers
  for (const double tolerance : in_ratios(1e-2, 1e-11, 19)) {
    const Table table = Table::build(law, tolerance, fewest);
    const double error = worst_of([&](double s) { return table.wrench(SlipTwist::about_cor(s)); });
    figure.add("numbers", "limitcurve", 8.0 * static_cast<double>(table.cell_count()), error);
  }
  const Table table = Table::build(law, 1e-8, fewest);
  // The same count of numbers: a node is f, m and a slope; a cell of ours is an origin and seven coefficients.
  const auto nodes = static_cast<int>(8 * table.cell_count() / 3);
  const double ours = worst_of([&](double s) { return table.wrench(SlipTwist::about_cor(s)); });
  found.add("even spacing across the rim", "cubic Hermite, exact slopes, even nodes in s ≤ 3",
            "largest error of f and m (flat punch, as many numbers as our table of 1e-8)", even_error(nodes), ours);
  found.add("even spacing across the rim", "the same with 1000 nodes", "largest error of f and m (flat punch)",
            even_error(1000), ours);
  return found;
}

Hazard beyond_the_last_node() {
  Hazard found;
  const Law law = hertz();
  constexpr double last = 5.0;
  constexpr int nodes = 64;
  const EvenTable even(*law, last, nodes);
  std::vector<double> moments;
  for (const double s : evenly(0.0, last, nodes)) moments.push_back(law->forces(s).moment);
  const Spline spline(moments.begin(), moments.end(), 0.0, last / (nodes - 1));
  const Table table = Table::build(law, 1e-8);
  const auto errors = [&](double s) {
    const Exact truth = exact_hertz(s).moment;
    return std::array{relative_error(even.wrench(std::min(s, last)).moment, truth),
                      relative_error(even.wrench(s).moment, truth), relative_error(spline(s), truth),
                      relative_error(table.wrench(SlipTwist::about_cor(s)).moment, truth)};
  };
  constexpr std::array series{"last value held", "last cubic extrapolated", "Boost's cubic spline"};
  double ours = 0.0;
  for (const double s : in_ratios(1.0, 1e6, 110)) raise(ours, errors(s)[3]);
  const auto far = errors(1e4);
  for (std::size_t i = 0; i < series.size(); ++i) {
    found.add("COR beyond the last node", std::string(series[i]) + ", 64 nodes to s = 5",
              "relative error of m at s = 1e4 (ours: table of 1e-8, s ≤ 1e6)", far[i], ours);
  }
  return found;
}

Hazard false_equilibria() {
  double usual = 0.0;
  double ours = 0.0;
  for (const int nodes : {17, 33, 65, 129, 257, 513}) raise(usual, rests(splined(*hertz(), nodes)));
  for (const double tolerance : in_ratios(1e-2, 1e-10, 9))
    raise(ours, rests(tabulated(Table::build(hertz(), tolerance))));
  return {{{"interpolant not convex", "cubic splines of f and m through values of four decimals",
            "equilibrium wrenches of one steady twist", usual, ours}},
          {}};
}

}  // namespace limitcurve::stability
