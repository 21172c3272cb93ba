// SPDX-License-Identifier: MIT
#include "cli/commands/stiffness_check.hpp"

#include "godobject/finger/springs.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve::cli {

namespace {

/// μ_r/μ_l = Γ/(μP) [m].
double moment_arm(const godobject::FingerParameters& finger, double moment_ratio, double load) {
  if (finger.mu_r) return *finger.mu_r * std::pow(load, finger.gamma) / finger.mu;
  return moment_ratio * finger.radius_law.radius(load);
}

}  // namespace

void note_stiffnesses(Messages& messages, const std::string& subject, const godobject::FingerParameters& finger,
                      double time_step, double moment_ratio, std::span<const double> loads) {
  constexpr double far = 10.0;
  double farthest = far;
  double worst_load = 0.0;
  double worst_arm = 0.0;
  const godobject::Springs springs(finger, time_step);
  const bool is_damped = springs.relaxed_fraction > 0.0 || springs.twist_relaxed_fraction > 0.0;
  const double ratio = springs.twist_stiffness / springs.stiffness;
  for (const double load : loads) {
    const double arm = moment_arm(finger, moment_ratio, load);
    // Without torsion every projection limits the force alone.
    if (!(load > 0.0 && finger.mu > 0.0 && arm > 0.0)) continue;
    const double times = ratio / (arm * arm);
    if (std::max(times, 1.0 / times) <= farthest) continue;
    farthest = std::max(times, 1.0 / times);
    worst_load = load;
    worst_arm = arm;
  }
  if (worst_load == 0.0) return;
  const double times = ratio / (worst_arm * worst_arm);
  messages.say("limitcurve: note: with " + subject + " a finger that slides and twists has almost no friction " +
               (times > 1.0 ? "force" : "moment") + " here, because " +
               (is_damped ? "(k_r + b_r/dt)/(k_l + b_l/dt)" : "k_r/k_l") + " is " + format_number(times, 2) +
               " times (mu_r/mu_l)^2 (at " + format_number(worst_load, 2) + " N, mu_r/mu_l = " +
               format_number(worst_arm, 2) + " m" + (is_damped ? ", dt = " + format_number(time_step, 2) + " s" : "") +
               "). Use --projection closest-point, or --twist-stiffness " +
               format_number(worst_arm * worst_arm * finger.stiffness, 2) +
               (is_damped ? " --twist-damping " + format_number(worst_arm * worst_arm * finger.damping, 2) : ""));
}

}  // namespace limitcurve::cli
