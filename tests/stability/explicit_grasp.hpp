// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/grasp.hpp"

#include <cstddef>
#include <span>
#include <utility>

namespace limitcurve::stability {

/// Ours, and the two that simulators use.
enum class Integrator {
  implicit_euler,    ///< Grasp's own
  symplectic_euler,  ///< loses the grip at kΔt²/m > 4, undamped
  explicit_euler,    ///< gains energy at every stiffness
};

/// A grasp whose body is moved by an integrator of choice.
class ExplicitGrasp {
 public:
  ExplicitGrasp(godobject::Grasp grasp, Integrator integrator) : grasp_(std::move(grasp)), integrator_(integrator), body_(grasp_.body()) {}

  void place(const godobject::BodyState& state, std::span<const godobject::DevicePose> devices) noexcept {
    grasp_.place(state, devices);
    body_ = state;
  }

  void step(std::span<const godobject::DevicePose> devices, double time_step) noexcept {
    if (integrator_ == Integrator::implicit_euler) {
      grasp_.step(devices, time_step);
      body_ = grasp_.body();
      return;
    }
    // Steps a–c where the body is, then step d with these forces.
    grasp_.carry(body_, devices, time_step);
    const godobject::BodyState before = body_;
    accelerate(time_step);
    const godobject::BodyState& moving = integrator_ == Integrator::symplectic_euler ? body_ : before;
    body_.position = before.position + moving.velocity * time_step;
    body_.orientation = godobject::turned(before.orientation, moving.angular_velocity, time_step);
  }

  [[nodiscard]] const godobject::BodyState& body() const noexcept { return body_; }

  /// Kinetic, gravity's and the springs' energy [J].
  [[nodiscard]] double energy() const noexcept {
    double sum = godobject::kinetic_energy(grasp_.parameters(), body_) + godobject::gravity_energy(grasp_.parameters(), body_);
    for (std::size_t i = 0; i < grasp_.finger_count(); ++i) sum += grasp_.finger(i).spring_energy();
    return sum;
  }

 private:
  /// The free velocities after a step under the fingers' forces and gravity.
  void accelerate(double time_step) noexcept {
    const godobject::BodyParameters& parameters = grasp_.parameters();
    Eigen::Vector3d force = parameters.mass * parameters.gravity;
    Eigen::Vector3d moment = -body_.angular_velocity.cross(godobject::angular_momentum(parameters, body_));
    for (std::size_t i = 0; i < grasp_.finger_count(); ++i) {
      // On the line through the finger, as Grasp has it.
      const godobject::FingerState& state = grasp_.finger(i).state();
      const Eigen::Vector3d finger = Eigen::Vector3d(state.goal.data()) - state.depth * Eigen::Vector3d(state.normal.data());
      force -= grasp_.force_on_user(i);
      moment -= (body_.orientation * finger).cross(grasp_.force_on_user(i)) + grasp_.moment_on_user(i);
    }
    const Eigen::Vector3d turning = (body_.orientation.conjugate() * moment).cwiseQuotient(parameters.inertia);
    const Eigen::Vector3d velocity = body_.velocity + force * (time_step / parameters.mass);
    const Eigen::Vector3d angular_velocity = body_.angular_velocity + body_.orientation * turning * time_step;
    for (int i = 0; i < 3; ++i) {
      if (parameters.free[static_cast<std::size_t>(i)]) body_.velocity[i] = velocity[i];
      if (parameters.free[static_cast<std::size_t>(i + 3)]) body_.angular_velocity[i] = angular_velocity[i];
    }
  }

  godobject::Grasp grasp_;
  Integrator integrator_;
  godobject::BodyState body_;
};

}  // namespace limitcurve::stability
