// SPDX-License-Identifier: MIT
#include "limitcurve/table/user_curve.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace limitcurve::table {

namespace {

/// A twist, by its spin fraction u, and its wrench.
struct Place {
  double u;
  UnitWrench wrench;

  [[nodiscard]] SlipTwist twist() const { return SlipTwist::of_spin_fraction(u); }
  [[nodiscard]] double work(const UnitWrench& other) const {
    return twist().slide * other.force + twist().spin * other.moment;
  }
  [[nodiscard]] std::string text() const { return "at c/a = " + format_number(twist().cor(), 3); }
};

double distance(const UnitWrench& one, const UnitWrench& other) {
  return std::max(std::fabs(one.force - other.force), std::fabs(one.moment - other.moment));
}

}  // namespace

void require_limit_curve(const std::function<UnitWrench(SlipTwist)>& curve, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    return std::invalid_argument("limit curve " + name + ": " + what);
  };
  const auto at = [&](double u) { return Place{u, curve(SlipTwist::of_spin_fraction(u))}; };
  constexpr std::size_t count = 129;
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) {
    const Place here = at(static_cast<double>(i) / (count - 1));
    const auto is_component = [](double value) { return value >= 0.0 && std::isfinite(value); };
    if (!is_component(here.wrench.force) || !is_component(here.wrench.moment)) {
      throw refuse("the wrench (" + format_number(here.wrench.force, 6) + ", " + format_number(here.wrench.moment, 6) +
                   ") " + here.text() + " has a component that is not a finite number >= 0");
    }
    places.push_back(here);
  }
  const double size = std::max(places.front().wrench.force, places.back().wrench.moment);
  // Rounding of the wrench: 1e-15 is asked for; what is forgiven is clearly more.
  const double rounding = 1e-12 * size;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Place& here = places[i];
    for (const Place& other : places) {
      if (here.work(other.wrench) <= here.work(here.wrench) + rounding) continue;
      throw refuse("the twist " + here.text() + " does more work on the wrench of the twist " + other.text() +
                   " than on its own: the curve is not convex there, or its wrench is not the point whose outward "
                   "normal is the twist");
    }
    Place low = here;
    Place high = places[i + 1];
    // On an axis the curvature may be infinite.
    const bool is_inside = std::min(here.wrench.force, here.wrench.moment) > 1e-6 * size;
    if (is_inside && distance(low.wrench, high.wrench) <= 1e-14 * size)
      throw refuse("a corner " + here.text() + ": the wrench does not depend on the twist");
    // A jump keeps its height however near the twists are.
    const double wide = distance(low.wrench, high.wrench);
    while (high.u - low.u > 1e-13) {
      const Place middle = at(0.5 * (low.u + high.u));
      (distance(low.wrench, middle.wrench) > distance(middle.wrench, high.wrench) ? high : low) = middle;
      if (distance(low.wrench, high.wrench) < 0.1 * wide) break;
    }
    if (high.u - low.u <= 1e-13)
      throw refuse("a flat face " + low.text() + ": the wrench jumps where the twist hardly changes");
  }
}

}  // namespace limitcurve::table
