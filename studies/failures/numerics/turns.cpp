// SPDX-License-Identifier: MIT
// Entry "geometry": angles.
#include "../failures.hpp"

#include "godobject/godobject.hpp"
#include "limitcurve/approximations.hpp"
#include "sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitcurve::stability {

namespace {

constexpr long double turn = 2.0L * std::numbers::pi_v<long double>;

/// The angle that a device reports for `angle`: rounded once.
double told(long double angle) {
  return static_cast<double>(std::remainder(angle, turn));
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// A finger pressed on a plane under 1 N, whose moment is bounded by 2 mN m.
struct Twisting {
  double twist_stiffness;  ///< [N m/rad]

  static constexpr double limit = 0.002;
  static constexpr double depth = 0.001;

  [[nodiscard]] godobject::SoftFinger finger() const {
    const godobject::FingerParameters parameters{
        .mu = 1.0, .radius_law = RadiusLaw::constant(0.005), .mu_r = limit, .stiffness = 1000.0, .twist_stiffness = twist_stiffness};
    return {Ellipse::through_intercepts(0.5), parameters};
  }

  static godobject::Contact contact() { return {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, depth}; }
};

/// The usual torsional friction: a spring from the proxy's angle to the device's, clamped.
class CustomaryTwist {
 public:
  CustomaryTwist(double twist_stiffness, bool wraps) : twist_stiffness_(twist_stiffness), wraps_(wraps) {}

  /// The moment on the user [N m].
  double update(double device) {
    double lag = proxy_ - device;
    if (wraps_) lag = wrapped(lag);
    const double held = std::clamp(lag, -Twisting::limit / twist_stiffness_, Twisting::limit / twist_stiffness_);
    if (held != lag) proxy_ = device + held;
    return twist_stiffness_ * held;
  }

 private:
  double twist_stiffness_;
  bool wraps_;
  double proxy_ = 0.0;
};

}  // namespace

Hazard half_a_turn() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"turns_half", {}});
  // A stiff and a soft spring: the one slips after a tenth of a radian, the other after four.
  for (const double largest_lag : {0.1, 4.0}) {
    const Twisting twisting{Twisting::limit / largest_lag};
    CustomaryTwist as_told(twisting.twist_stiffness, false);
    CustomaryTwist wrapping(twisting.twist_stiffness, true);
    auto finger = twisting.finger();
    finger.update(Twisting::contact(), 0.0);
    double worst_told = 0.0;
    double worst_wrapping = 0.0;
    double worst_ours = 0.0;
    const std::string panel = largest_lag < 1.0 ? "stiff" : "soft";
    constexpr int steps = 800;
    for (int i = 1; i <= steps; ++i) {
      const long double angle = 12.0L * i / steps;
      const double device = told(angle);
      // Right friction: against the rotation, growing to the limit and staying there.
      const double truth = -std::min(static_cast<double>(angle) / largest_lag, 1.0);
      const double by_told = as_told.update(device) / Twisting::limit;
      const double by_wrapping = wrapping.update(device) / Twisting::limit;
      const double ours = finger.update(Twisting::contact(), device).moment / Twisting::limit;
      worst_told = std::max(worst_told, std::fabs(by_told - truth));
      worst_wrapping = std::max(worst_wrapping, std::fabs(by_wrapping - truth));
      worst_ours = std::max(worst_ours, std::fabs(ours - truth));
      if (i % 5 != 0) continue;
      figure.rows.push_back({panel, "angle as told", static_cast<double>(angle), by_told});
      figure.rows.push_back({panel, "difference wrapped", static_cast<double>(angle), by_wrapping});
      figure.rows.push_back({panel, "limitcurve", static_cast<double>(angle), ours});
    }
    const std::string quantity = std::string("error of the moment / limit (slips after ") + (largest_lag < 1.0 ? "0.1" : "4") + " rad)";
    found.findings.push_back({"twist passes ±π", "spring to the raw angle", quantity, worst_told, worst_ours});
    // Wrapping the difference is right if the finger slips before half a turn.
    if (largest_lag < std::numbers::pi) continue;
    found.findings.push_back({"twist passes ±π", "difference wrapped into ±π", quantity, worst_wrapping, worst_ours});
  }
  return found;
}

Hazard ten_thousand_turns() {
  Hazard found;
  constexpr long turns = 10000;
  constexpr long steps_a_turn = 100;
  auto finger = Twisting{0.02}.finger();
  finger.update(Twisting::contact(), 0.0);
  double summed = 0.0;
  double last = 0.0;
  double ours = 0.0;
  const auto error = [](double value, long double angle) { return std::max(static_cast<double>(std::fabs(value - angle)), 1e-16); };
  for (long i = 1; i <= turns * steps_a_turn; ++i) {
    const long double angle = turn * static_cast<long double>(i) / steps_a_turn;
    const double device = told(angle);
    summed += wrapped(device - last);
    last = device;
    finger.update(Twisting::contact(), device);
    ours = std::max(ours, error(finger.state().sample.angle, angle));
  }
  const long double end = turn * turns;
  found.findings.push_back(
      {"10⁴ turns", "steps summed in double", "error of the angle [rad] (100 steps a turn)", error(summed, end), ours});
  return found;
}

}  // namespace limitcurve::stability
