// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/contact/radius_law.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

/// Asks whether numbers are in metres, newtons and radians, and whether two columns are swapped: they are far outside
/// what a fingertip has.
class UnitChecks {
 public:
  /// Normal loads [N]: above 1000 N.
  void load(double load);
  /// A friction force [N] and moment [N m]: more than 0.2 N m, and than 0.2 m times the force.
  void wrench(double force, double moment);
  /// A force under a load [N]: the larger of both in more than half of the calls.
  void force_under(double load, double force);
  /// The twist [rad] of a sample: more than 1 rad from `before`, unless both are within a turn and it wraps around.
  /// NaN: no sample before.
  void twist(double before, double now, double time);
  /// The time [s] since the sample before: above 1 s in more than half of the calls.
  void time_step(double step);
  /// An angle [rad] read from `text`: more than a turn without a unit.
  void angle(const std::string& what, double angle, std::string_view text);
  /// The radii [m] of a law at loads > 0: above 0.1 m, or beyond the law's samples.
  void radii(const RadiusLaw& law, std::span<const double> loads);
  /// The longest side [m] of `what`: above 0.5 m.
  void length(const std::string& what, double across);

  /// What the loads and wrenches are from, and its units, if it is not forces in a file.
  std::string source = {};

  /// "warning: …", one line each.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  /// Of the first number that is out of place.
  struct First {
    std::string text = {};
    std::size_t count = 0;
  };
  template <class Text>
  static void note(First& first, const Text& text);

  std::size_t loaded_ = 0;  ///< calls of `force_under`
  std::size_t swapped_ = 0;
  std::size_t steps_ = 0;  ///< calls of `time_step`
  std::size_t long_steps_ = 0;
  First loads_;
  First wrenches_;
  First twists_;
  std::vector<std::string> others_;
};

/// Those about radii and their loads.
std::vector<std::string> radius_warnings(const RadiusLaw& law, std::span<const double> loads);

}  // namespace limitcurve::cli
