// SPDX-License-Identifier: MIT
#pragma once

#include "docs/playground/finger.hpp"

#include <array>

namespace limitcurve::playground {

/// The paper's experiment (§6), as in `limitcurve pivot`: a block in the vertical plane between two opposite fingers that stay at the
/// origin while their load changes. Both fingers do the same, so one is computed. x points right and y up; at the start the block lies
/// level and its centre of mass at (−offset, 0).
struct Block {
  double length = 0.12;   ///< along x at the start [m]
  double height = 0.04;   ///< [m]
  double mass = 0.1;      ///< [kg]
  double offset = 0.005;  ///< of the centre of mass from the grip point [m]
  double gravity = 9.81;  ///< [m/s²]

  double x = 0.0;  ///< of the centre of mass [m]
  double y = 0.0;
  double angle = 0.0;  ///< counter-clockwise [rad]
  double velocity_x = 0.0;
  double velocity_y = 0.0;
  double spin = 0.0;   ///< [rad/s]
  Finger finger = {};  ///< its positions and forces, in the block's frame

  /// Level and at rest, held by fingers of that load [N] whose springs carry the weight.
  void take(const CurveView<double>& curve, const FingerSettings& settings, double load) noexcept {
    velocity_x = velocity_y = spin = 0.0;
    finger = {};
    const double depth = load / settings.stiffness;
    const double sag = 0.5 * mass * gravity / settings.stiffness;
    const double give = 0.5 * mass * gravity * offset / settings.twist_stiffness;
    place(-(std::cos(give) * offset - std::sin(give) * sag), std::sin(give) * offset + std::cos(give) * sag, -give);
    finger.update(curve, settings, seen_from(*this, depth), 0.0);
    place(-offset, 0.0, 0.0);
    finger.update(curve, settings, seen_from(*this, depth), 0.0);
  }

  /// One time step [s] under a load of each finger [N]: implicit Euler, with the stiffness of springs and dampers without slip as the
  /// slope of the residual. A slip is softer than that, so each step of the search reduces the error of the velocities.
  void step(const CurveView<double>& curve, const FingerSettings& settings, double load, double time_step) noexcept {
    const double rate = settings.damping / time_step;
    const double depth = load > 0.0 ? (load + rate * finger.depth) / (settings.stiffness + rate) : 0.0;
    const double inertia = mass / 12.0 * (length * length + height * height);
    const double give = 2.0 * (settings.stiffness + rate) * time_step * time_step;
    const double twist_give = 2.0 * (settings.twist_stiffness + settings.twist_damping / time_step) * time_step * time_step;
    std::array<double, 3> velocity{velocity_x, velocity_y, spin};
    Block next = *this;
    for (int i = 0; i < most_iterations; ++i) {
      next = moved(velocity, time_step);
      next.finger.update(curve, settings, seen_from(next, depth), time_step);
      const std::array<double, 2> force = next.force();
      const double moment = next.moment(force);
      const double lack_x = mass * (velocity[0] - velocity_x) - force[0] * time_step;
      const double lack_y = mass * (velocity[1] - velocity_y) - (force[1] - mass * gravity) * time_step;
      const double lack_spin = inertia * (velocity[2] - spin) - moment * time_step;
      // From the centre of mass to the grip.
      const double arm_x = -next.x;
      const double arm_y = -next.y;
      const double m = mass + give;
      const double turn = inertia + twist_give + give * (arm_x * arm_x + arm_y * arm_y);
      const double schur = turn - give * give * (arm_x * arm_x + arm_y * arm_y) / m;
      const double d_spin = (lack_spin - give * (arm_x * lack_y - arm_y * lack_x) / m) / schur;
      const double d_x = (lack_x + give * arm_y * d_spin) / m;
      const double d_y = (lack_y - give * arm_x * d_spin) / m;
      velocity = {velocity[0] - d_x, velocity[1] - d_y, velocity[2] - d_spin};
      if (std::fabs(d_x) + std::fabs(d_y) + length * std::fabs(d_spin) < 1e-14) break;
    }
    next = moved(velocity, time_step);
    next.finger.update(curve, settings, seen_from(next, depth), time_step);
    *this = next;
  }

 private:
  static constexpr int most_iterations = 100;

  void place(double new_x, double new_y, double new_angle) noexcept {
    x = new_x;
    y = new_y;
    angle = new_angle;
  }

  [[nodiscard]] Block moved(const std::array<double, 3>& velocity, double time_step) const noexcept {
    Block result = *this;
    result.velocity_x = velocity[0];
    result.velocity_y = velocity[1];
    result.spin = velocity[2];
    result.place(x + velocity[0] * time_step, y + velocity[1] * time_step, angle + velocity[2] * time_step);
    return result;
  }

  /// The fingers in the frame of a block; outside its faces they hold nothing.
  [[nodiscard]] static Sample seen_from(const Block& block, double depth) noexcept {
    const double c = std::cos(block.angle);
    const double s = std::sin(block.angle);
    const double finger_x = -c * block.x - s * block.y;
    const double finger_y = s * block.x - c * block.y;
    const bool on_face = std::fabs(finger_x) <= 0.5 * block.length && std::fabs(finger_y) <= 0.5 * block.height;
    return {finger_x, finger_y, -block.angle, on_face ? depth : 0.0};
  }

  /// Force of both fingers on the block, in the world [N].
  [[nodiscard]] std::array<double, 2> force() const noexcept {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {-2.0 * (c * finger.force_x - s * finger.force_y), -2.0 * (s * finger.force_x + c * finger.force_y)};
  }

  /// Moment about the centre of mass [N m].
  [[nodiscard]] double moment(const std::array<double, 2>& force) const noexcept {
    return -x * force[1] + y * force[0] - 2.0 * finger.moment;
  }
};

}  // namespace limitcurve::playground
