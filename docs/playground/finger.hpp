// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/friction.hpp"

#include <cmath>
#include <limits>

/// A soft finger on a plane in plain numbers: the samples, springs and dampers of `SoftFinger` around the library's own step b. The page
/// compiles it to WebAssembly, without Eigen and exceptions; tests/site compares it with `limitcurve replay`.
namespace limitcurve::playground {

using godobject::FrictionLimits;
using godobject::FrictionMemory;
using godobject::FrictionResult;
using godobject::FrictionTrial;

/// Parameters of a finger. Static and dynamic friction are equal; springs and dampers as in FingerParameters.
struct FingerSettings {
  double mu = 0.6;
  RadiusLaw radius_law;  ///< a(P)
  double stiffness = 1000.0;
  double twist_stiffness = 0.036;
  double damping = 0.0;
  double twist_damping = 0.0;
  godobject::Projection projection = godobject::Projection::closest_point;
};

/// Position of the finger.
struct Sample {
  double x;      ///< x_g [m]
  double y;      ///< [m]
  double twist;  ///< α_g [rad]; jumps by whole turns are ignored
  double depth;  ///< d [m]; ≤ 0: free
};

/// With the values of ContactState.
enum class State { free, stick, slip };

/// A finger with its state. Trivially copyable, so that a body's integrator can try a step.
struct Finger {
  State state = State::free;
  double proxy_x = 0.0;  ///< x_p [m]; while free, the finger itself
  double proxy_y = 0.0;
  double angle = 0.0;    ///< α_p [rad]
  double depth = 0.0;    ///< d [m]
  double load = 0.0;     ///< normal force on the user [N]
  double force_x = 0.0;  ///< friction on the user [N]
  double force_y = 0.0;
  double moment = 0.0;                                    ///< [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]
  double trial_force = 0.0;                               ///< spring force before slip [N] …
  double trial_moment = 0.0;                              ///< … [N m] (eq. 7)
  double limit_force = 0.0;                               ///< μP [N] of the limit that acted
  double radius = 0.0;                                    ///< a(P) [m] of the same
  double x = 0.0;                                         ///< of the last sample [m]
  double y = 0.0;
  double goal_angle = 0.0;    ///< α_g, unwrapped [rad]
  double device_twist = 0.0;  ///< as reported
  double turns = 0.0;         ///< added by unwrapping
  bool seen = false;          ///< there was a sample
  FrictionMemory<double> memory = {};

  /// Steps a to c. `time_step` [s]: dampers act where it is > 0.
  void update(const CurveView<double>& curve, const FingerSettings& settings, const Sample& sample, double time_step) noexcept {
    const bool timed = seen && time_step > 0.0;
    seen = true;
    if (!(sample.depth > 0.0)) return release(sample);
    if (state == State::free) touch_down(sample);

    // a. The trial deflection: an implicit damper b is an additional spring b/Δt that rests at the last deflection (eq. 7).
    const double damper = timed ? settings.damping / time_step : 0.0;
    const double twist_damper = timed ? settings.twist_damping / time_step : 0.0;
    const double stiffness = settings.stiffness + damper;
    const double twist_stiffness = settings.twist_stiffness + twist_damper;
    const double share = damper / stiffness;
    const double rest_x = (proxy_x - x) * share;
    const double rest_y = (proxy_y - y) * share;
    const double twist_rest = (angle - goal_angle) * (twist_damper / twist_stiffness);
    const double load_and_damper = settings.stiffness * sample.depth + damper * (sample.depth - depth);
    load = load_and_damper > 0.0 ? load_and_damper : 0.0;
    depth = sample.depth;
    x = sample.x;
    y = sample.y;
    goal_angle = unwrap(sample.twist);
    const double trial_x = proxy_x - x - rest_x;
    const double trial_y = proxy_y - y - rest_y;
    const double twist = (angle - goal_angle) - twist_rest;

    // b. The fraction of it within the limit curve (eqs. 21–23).
    trial_force = stiffness * std::sqrt(trial_x * trial_x + trial_y * trial_y);
    trial_moment = twist_stiffness * std::fabs(twist);
    radius = settings.radius_law.radius(load);
    limit_force = settings.mu * load;
    const bool varies = settings.radius_law.exponent() != 0.0;
    FrictionLimits<double> limits{{limit_force, radius}, {limit_force, radius}, stiffness / twist_stiffness};
    limits.radius_law = varies ? &settings.radius_law : nullptr;
    limits.load = load;
    const FrictionResult<double> friction = apply_friction(curve, settings.projection, limits, {trial_force, trial_moment}, memory);
    const double kept_x = trial_x * friction.force_ratio;
    const double kept_y = trial_y * friction.force_ratio;
    const double kept_twist = twist * friction.moment_ratio;

    // The proxy follows; a component that did not slide is unchanged, to the last bit.
    const double old_x = proxy_x;
    const double old_y = proxy_y;
    const double old_angle = angle;
    if (friction.force_ratio < 1.0) {
      proxy_x = x + rest_x + kept_x;
      proxy_y = y + rest_y + kept_y;
    }
    if (friction.moment_ratio < 1.0) angle = goal_angle + twist_rest + kept_twist;
    const bool slips = friction.slips && (proxy_x != old_x || proxy_y != old_y || angle != old_angle);

    // c. Force and moment on the user.
    state = slips ? State::slip : State::stick;
    force_x = kept_x * stiffness;
    force_y = kept_y * stiffness;
    moment = kept_twist * twist_stiffness;
    cor = slips ? friction.cor : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  void release(const Sample& sample) noexcept {
    *this = {};
    seen = true;
    x = proxy_x = sample.x;
    y = proxy_y = sample.y;
    angle = goal_angle = device_twist = sample.twist;
    depth = sample.depth;
  }

  void touch_down(const Sample& sample) noexcept {
    x = proxy_x = sample.x;
    y = proxy_y = sample.y;
    angle = goal_angle = device_twist = sample.twist;
    depth = turns = 0.0;
    memory = {};
  }

  double unwrap(double twist) noexcept {
    constexpr double turn = 6.283185307179586;
    const double jump = twist - device_twist;
    if (std::fabs(jump) > 0.5 * turn) turns -= turn * std::round(jump / turn);
    device_twist = twist;
    return twist + turns;
  }
};

}  // namespace limitcurve::playground
