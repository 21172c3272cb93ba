// SPDX-License-Identifier: MIT
#include "limitcurve/foot_guesses.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limitcurve {

namespace {

/// (place's c/a)·(ŷ/m_max)/(x̂/f_max) at the feet of trials that have one share of the moment, by their distance.
class Column {
 public:
  Column(const Table& table, double chi, UnitWrench intercepts, double share)
      : table_(table),
        chi_(chi),
        trial_{(1.0 - share) * intercepts.force, share * intercepts.moment},
        odds_(share / (1.0 - share)),
        on_curve_(table.gauge(trial_)) {}

  /// Where the curve is: trials are at distances from 0 to this.
  [[nodiscard]] double on_curve() const { return on_curve_; }

  [[nodiscard]] double at(double distance) const {
    const UnitWrench trial{trial_.force / distance, trial_.moment / distance};
    return SlipTwist::at_place(table_.closest(trial, chi_, 1.0 / chi_, -1.0).place).cor() * odds_;
  }

 private:
  const Table& table_;
  double chi_;
  UnitWrench trial_;  // at a distance of 1, on the chord
  double odds_;
  double on_curve_;
};

}  // namespace

FootGuesses::FootGuesses(const Table& table, double chi) : chi_(chi), per_chi_(1.0 / chi) {
  const UnitWrench intercepts{table.wrench({1.0, 0.0}).force, table.wrench({0.0, 1.0}).moment};
  constexpr double width = 1.0 / static_cast<double>(shares);
  constexpr double height = 1.0 / static_cast<double>(distances);
  constexpr std::size_t columns = shares + 2;
  constexpr std::size_t rows = distances - first_distance + 2;
  // Of the patches' corners. Those beyond an axis by half a patch are as within by a quarter.
  std::vector<double> corners;
  for (std::size_t i = 0; i < columns; ++i) {
    const Column column(table, chi, intercepts, std::clamp((static_cast<double>(i) - 0.5) * width, 0.25 * width, 1.0 - 0.25 * width));
    double last = 1.0;
    for (std::size_t j = 0; j < rows; ++j) {
      // A patch beyond the curve has corners within it, where the normals still do not meet as a rule. No trial needs corners farther in.
      const double distance = (static_cast<double>(first_distance + j) - 0.5) * height;
      if (distance < column.on_curve() + 1.5 * height) {
        const double multiple = column.at(distance);
        if (multiple > 1e-30 && multiple < 1e30) last = multiple;  // A float holds it: elsewhere any guess will do.
      }
      corners.push_back(last);
    }
  }
  for (const bool outside : {false, true}) {
    auto patch = patches_[outside].begin();
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      for (std::size_t j = 0; j + 1 < rows; ++j) {
        const auto corner = [&](std::size_t right, std::size_t up) {
          const double multiple = corners[(i + right) * rows + j + up];
          return outside ? 1.0 / multiple : multiple;
        };
        const double sum = (corner(0, 0) + corner(1, 1)) + (corner(0, 1) + corner(1, 0));
        const double rightwards = (corner(1, 0) + corner(1, 1)) - (corner(0, 0) + corner(0, 1));
        const double upwards = (corner(0, 1) + corner(1, 1)) - (corner(0, 0) + corner(1, 0));
        const double twist = (corner(0, 0) + corner(1, 1)) - (corner(0, 1) + corner(1, 0));
        *patch++ = {static_cast<float>(0.25 * sum), static_cast<float>(0.5 * rightwards), static_cast<float>(0.5 * upwards),
                    static_cast<float>(twist)};
      }
    }
  }
}

}  // namespace limitcurve
