// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <algorithm>
#include <cmath>

/// Springs and dampers between proxy and finger, and the motion of the proxy in a slip.
namespace limitcurve::godobject {

/// Springs and dampers of an implicit step as one spring: k d + b (d − d_last)/Δt = k′ (d − d_relaxed) with k′ = k +
/// b/Δt and d_relaxed = d_last (b/Δt)/k′.
struct Springs {
  double stiffness;                     ///< [N/m]
  double twist_stiffness;               ///< [N m/rad]
  double relaxed_fraction = 0.0;        ///< the deflection at which the springs are relaxed, divided by the last one
  double twist_relaxed_fraction = 0.0;  ///< the same for the twist

  /// `time_step` [s]; 0: no damper acts.
  Springs(const FingerParameters& finger, double time_step) noexcept
      : stiffness(finger.stiffness), twist_stiffness(finger.twist_stiffness) {
    if (!(time_step > 0.0) || (finger.damping == 0.0 && finger.twist_damping == 0.0)) return;
    const double damper = finger.damping / time_step;
    const double twist_damper = finger.twist_damping / time_step;
    stiffness += damper;
    twist_stiffness += twist_damper;
    relaxed_fraction = damper / stiffness;
    twist_relaxed_fraction = twist_damper / twist_stiffness;
  }
};

/// The deflection x_p − x_h of the spring between proxy and finger.
struct Deflection {
  Eigen::Vector3d tangential;  ///< along the surface [m]; r is its length
  double height;  ///< along the normal [m]: the depth, plus the rise of a curved surface from x_g to the proxy

  Deflection(const Eigen::Vector3d& proxy, const FingerSample& sample) noexcept {
    const Eigen::Vector3d apart = proxy - sample.goal;
    const double rise = sample.normal.dot(apart);
    tangential = apart - sample.normal * rise;
    height = sample.depth + rise;
  }
};

/// The tilt of the normal up to which a proxy under a given load stays where it is in space: 0.25 rad, by its cosine
/// and sine.
inline constexpr double held_tilt_cosine = 0.9689124217106447;
inline constexpr double held_tilt_sine = 0.24740395925452294;

/// Under a given load the proxy is a point in space, as under a depth: a stick's force follows from the pose, not from
/// the path. Only what the normal tilts beyond 0.25 rad from the one that holds the proxy turns both about the contact
/// point, so that the springs reach the limit on a ball smaller than their deflection, too. The turn keeps the length
/// of the springs, and so their energy.
inline void carry_with_normal(Eigen::Vector3d& proxy, Eigen::Vector3d& held, const FingerSample& sample) noexcept {
  const Eigen::Vector3d& n = sample.normal;
  const double cosine = held.dot(n);
  if (cosine >= held_tilt_cosine) return;
  const Eigen::Vector3d across = held - n * cosine;
  const double sine = across.norm();
  if (!(sine > 1e-6)) {  // turned over: no turn is the shortest
    held = n;
    return;
  }
  const Eigen::Vector3d turned = (n * held_tilt_cosine + across * (held_tilt_sine / sine)).normalized();
  const Eigen::Vector3d both = held + turned;
  const Eigen::Vector3d apart = proxy - sample.goal;
  proxy += turned * (2.0 * held.dot(apart)) - both * (both.dot(apart) / (1.0 + held.dot(turned)));
  held = turned;
}

/// Step a: springs and dampers if the proxy stays (eq. 7).
struct TrialDeflection {
  Springs springs;
  Deflection spring;                ///< deflection of the spring, before friction
  Eigen::Vector3d proxy;            ///< x_p [m]
  bool moves_along_normal = false;  ///< the proxy was beyond the finger, or higher than friction holds it
  Eigen::Vector3d relaxed_tangential =
      Eigen::Vector3d::Zero();  ///< where springs and dampers are relaxed: along the surface [m],
  double relaxed_height = 0.0;  ///< along the normal [m],
  double relaxed_twist;         ///< and in twist [rad]
  Eigen::Vector3d tangential;   ///< trial deflection along the surface from the relaxed one [m]
  double twist;                 ///< trial deflection in twist from the relaxed one [rad]
  double limit_load;            ///< P of the friction limit [N]

  /// For a proxy x_p, α_p: from the last sample to the present one. `time_step` [s]; 0: no damper acts. `load`: P [N],
  /// where it is given.
  TrialDeflection(const FingerParameters& parameters, const Eigen::Vector3d& before, double angle,
                  const FingerSample& last, const FingerSample& sample, double time_step,
                  const std::optional<double>& load) noexcept
      : springs(parameters, time_step), spring(before, sample), proxy(before) {
    const Eigen::Vector3d& n = sample.normal;
    if (springs.relaxed_fraction > 0.0) {
      const Deflection was(before, last);
      const Eigen::Vector3d relaxed = (was.tangential + last.normal * was.height) * springs.relaxed_fraction;
      relaxed_height = n.dot(relaxed);
      relaxed_tangential = relaxed - n * relaxed_height;
    }
    relaxed_twist = (angle - last.angle) * springs.twist_relaxed_fraction;
    const double damper = springs.stiffness - parameters.stiffness;
    // The depth alone sets the limit, as in the paper: what friction gives must not change it.
    limit_load =
        load ? *load : std::max(parameters.stiffness * sample.depth + damper * (sample.depth - last.depth), 0.0);
    if (!load) {
      // Springs do not pull a finger in: a proxy beyond it moves to its near side, not farther away than it was. Nor
      // does friction hold a proxy higher above the touched face than μ d: it was left on a face that the finger
      // dropped from.
      const double most = (1.0 + parameters.mu) * sample.depth;
      const bool is_too_high = spring.height > most && spring.height - most > 1e-15 * sample.goal.lpNorm<1>();
      moves_along_normal = spring.height < 0.0 || is_too_high;
      if (moves_along_normal) {
        spring.height = is_too_high ? most : std::min(-spring.height, sample.depth);
        proxy = sample.goal + spring.tangential + n * (spring.height - sample.depth);
      }
    }
    tangential = spring.tangential - relaxed_tangential;
    twist = (angle - sample.angle) - relaxed_twist;
  }

  /// The normal force on the user [N] for a height of the spring [m]. A damper does not pull.
  [[nodiscard]] double load(double height) const noexcept {
    const double force = springs.stiffness * (height - relaxed_height);
    return springs.relaxed_fraction > 0.0 ? std::max(force, 0.0) : force;
  }
};

/// What friction keeps of the trial deflection (step b).
struct KeptDeflection {
  Eigen::Vector3d tangential;  ///< [m]
  double twist;                ///< [rad]
  bool force_reduced;          ///< `tangential` is less than the trial's
  bool moment_reduced;         ///< `twist` is less than the trial's
  bool slips;                  ///< the trial was beyond the limit
  double cor;                  ///< distance of the slip's COR [m]; not defined without slip
  double trial_force;          ///< the trial wrench (eq. 7): force [N] …
  double trial_moment;         ///< … and moment [N m]
  bool converged = true;       ///< false: not the closest point of a patch
};

/// The proxy after a slip.
struct MovedProxy {
  Eigen::Vector3d proxy;     ///< x_p [m]
  double height;             ///< of the spring then [m]
  double along_slope = 1.0;  ///< work along the surface at the proxy divided by work along the tangent plane at x_g
};

/// The proxy after a slip that leaves `kept` [m] of the trial deflection. Models the surface as a paraboloid about x_g.
/// The proxy does not move away from the finger, so that a slip never adds energy.
[[nodiscard]] inline MovedProxy follow(const TrialDeflection& trial, const FingerSample& sample,
                                       const Eigen::Vector3d& kept) noexcept {
  const Eigen::Vector3d tangential = trial.relaxed_tangential + kept;
  double rise = trial.spring.height - sample.depth;
  if (rise == 0.0) return {sample.goal + tangential, sample.depth};
  const double before = trial.spring.tangential.squaredNorm();
  const double square = tangential.squaredNorm();
  if (square < before) {
    const double longest = std::sqrt(trial.spring.height * trial.spring.height + (before - square));
    rise = std::min(rise * (square / before), longest - sample.depth);
  }
  const double height = sample.depth + rise;
  // A deflection whose square is near underflow is none: the slope would be infinite.
  constexpr double none = 1e-200;
  const double along_slope = square > none ? std::max(1.0 + 2.0 * height * rise / square, 0.0) : 1.0;
  return {sample.goal + tangential + sample.normal * rise, height, along_slope};
}

}  // namespace limitcurve::godobject
