// SPDX-License-Identifier: MIT
#include "limitcurve/foot_guesses.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve {

namespace {

UnitWrench intercepts(const Table& table) {
  return {table.wrench({1.0, 0.0}).force, table.wrench({0.0, 1.0}).moment};
}

/// ŷ/x̂ of trials of which the moment's square has one share.
double odds(UnitWrench intercepts, double share) {
  return std::sqrt(share / (1.0 - share)) * (intercepts.moment / intercepts.force);
}

SideGuesses::Corners inverse(const SideGuesses::Corners& of) {
  SideGuesses::Corners result;
  std::transform(of.begin(), of.end(), result.begin(), [](double number) { return 1.0 / number; });
  return result;
}

/// By what multiple the feet's c/a exceeds x̂/ŷ for trials of one share, by one over the sum of squares.
class Column {
 public:
  Column(const Table& table, double chi, double share)
      : table_(table),
        chi_(chi),
        trial_{std::sqrt(1.0 - share) * intercepts(table).force, std::sqrt(share) * intercepts(table).moment},
        odds_(trial_.moment / trial_.force),
        on_curve_(table.gauge(trial_) * table.gauge(trial_)) {}

  /// Where the curve is: trials are at distances from 0 to this.
  [[nodiscard]] double on_curve() const { return on_curve_; }

  [[nodiscard]] double at(double distance) const {
    const double scale = 1.0 / std::sqrt(distance);
    const UnitWrench trial{trial_.force * scale, trial_.moment * scale};
    return SlipTwist::at_place(table_.closest(trial, chi_, 1.0 / chi_, -1.0).place).cor() * odds_;
  }

 private:
  const Table& table_;
  double chi_;
  UnitWrench trial_;  // at a distance of 1, on the ellipse of the intercepts
  double odds_;
  double on_curve_;
};

}  // namespace

FootGuesses::FootGuesses(const Table& table, double chi) : FootGuesses(table, chi, multiples(table, chi)) {}

FootGuesses::FootGuesses(const Table& table, double chi, const SideGuesses::Corners& multiples)
    : inside_(table.inside(), chi, multiples, [&](double share) { return 1.0 / odds(intercepts(table), share); }),
      outside_(table.outside(), 1.0 / chi, inverse(multiples), [&](double share) { return odds(intercepts(table), share); }),
      chi_(chi),
      per_chi_(1.0 / chi) {}

SideGuesses::Corners FootGuesses::multiples(const Table& table, double chi) {
  constexpr double width = 1.0 / static_cast<double>(SideGuesses::shares);
  constexpr double height = 1.0 / static_cast<double>(SideGuesses::distances);
  SideGuesses::Corners result;
  // What no place of the grid asks for is a guess too.
  result.fill(1.0);
  for (std::size_t i = 0; i < SideGuesses::shares + 2; ++i) {
    // Corners beyond an axis by half a cell are as within by a quarter.
    const Column column(table, chi, std::clamp((static_cast<double>(i) - 0.5) * width, 0.25 * width, 1.0 - 0.25 * width));
    double last = 1.0;
    for (std::size_t j = SideGuesses::first_distance; j < SideGuesses::last_distance + 2; ++j) {
      // A cell beyond the curve has corners within it, where the normals still do not meet as a rule. No trial needs corners farther in.
      const double distance = (static_cast<double>(j) - 0.5) * height;
      if (distance < column.on_curve() + 1.5 * height) {
        const double multiple = column.at(distance);
        if (multiple > 1e-30 && multiple < 1e30) last = multiple;  // Elsewhere any guess will do.
      }
      result[i * SideGuesses::stride + j] = last;
    }
  }
  return result;
}

}  // namespace limitcurve
