// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/device_pose.hpp"
#include "godobject/rigid_body.hpp"
#include "godobject/soft_finger.hpp"
#include "godobject/surface.hpp"
#include "limitcurve/number.hpp"

#include <Eigen/LU>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace limitcurve::godobject {

/// How the springs of the fingers and the body's inertia are integrated together (README, "Bodies").
enum class Integrator {
  implicit_euler,    ///< stable at every stiffness, damps what the time step cannot resolve: the default
  symplectic_euler,  ///< loses the grip at kΔt²/m > 4, undamped
  explicit_euler,    ///< gains energy at every stiffness: for comparison
};

/// One body and the fingers on it: steps a–e of the paper. The proxies are kept in the body's frame, so that step e,
/// carrying them with the body, is exact and keeps the sign of the rotation (eq. 13 takes its absolute value).
///
/// Bodies meet fingers only, not each other: a scene of several bodies has a Grasp for each, and a finger that may touch
/// several is in each of them. Allocates at construction only.
template <Surface Shape, LimitBoundary Boundary, class Projection>
class Grasp {
 public:
  using Finger = SoftFinger<Boundary, Projection>;

  /// Newton steps of the implicit integrator at most, from each of two starts; 2 to 4 as a rule, each seven evaluations of all fingers.
  static constexpr int iteration_limit = 20;
  /// Halvings of a Newton step at most; 0 as a rule.
  static constexpr int halving_limit = 24;
  /// Equations count as solved when what is left of them is this share of the velocities, and those that the loads give in a step.
  static constexpr double solved_share = 1e-9;

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  Grasp(const BodyParameters& parameters, const BodyState& state, Shape shape, std::vector<Finger> fingers,
        Integrator integrator = Integrator::implicit_euler)
      : parameters_(parameters), state_(state), shape_(std::move(shape)), integrator_(integrator) {
    parameters_.validate();
    holds_.reserve(fingers.size());
    for (Finger& finger : fingers) holds_.push_back({std::move(finger), {}, Eigen::Vector3d::Zero()});
    if (const double norm = state.orientation.norm(); !(std::fabs(norm - 1.0) <= 1e-9)) {
      throw out_of_range("norm of the orientation", norm, "1", "1");
    }
  }

  /// One time step [s] > 0 with a device for each finger; a missing one counts as far away. `force` and `moment` about the
  /// centre of mass, world axes, act on the body beside gravity and fingers. Poses that are not finite make their finger
  /// `invalid`; it then acts with its last force.
  void step(std::span<const DevicePose> devices, double time_step, const Eigen::Vector3d& force = Eigen::Vector3d::Zero(),
            const Eigen::Vector3d& moment = Eigen::Vector3d::Zero()) noexcept {
    const Load external{force + parameters_.mass * parameters_.gravity, moment};
    switch (integrator_) {
      case Integrator::implicit_euler: {
        const BodyState next = solve(devices, time_step, external);
        state_ = next;
        commit(devices, time_step);
        break;
      }
      case Integrator::symplectic_euler: {
        const Load load = total(external, commit(devices, time_step));
        accelerate(load, time_step);
        state_ = moved(state_, state_.velocity, state_.angular_velocity, time_step);
        break;
      }
      case Integrator::explicit_euler: {
        const Load load = total(external, commit(devices, time_step));
        const BodyState moved_on = moved(state_, state_.velocity, state_.angular_velocity, time_step);
        accelerate(load, time_step);
        state_.position = moved_on.position;
        state_.orientation = moved_on.orientation;
        break;
      }
    }
    account();
  }

  /// Steps a–c and e with the body moved by somebody else, to a state, in a time [s] ≥ 0 (0: no dampers).
  void carry(const BodyState& state, std::span<const DevicePose> devices, double time_step) noexcept {
    state_ = state;
    commit(devices, time_step);
    account();
  }

  /// Steps a–c with the body held in a state: where fingers touch down, and where a scene starts.
  void place(const BodyState& state, std::span<const DevicePose> devices) noexcept {
    state_ = state;
    commit(devices, 0.0);
  }

  [[nodiscard]] const BodyParameters& parameters() const noexcept { return parameters_; }
  [[nodiscard]] const BodyState& body() const noexcept { return state_; }
  [[nodiscard]] std::size_t finger_count() const noexcept { return holds_.size(); }
  /// A finger; its proxy, force and so on are in the body's frame.
  [[nodiscard]] const Finger& finger(std::size_t index) const noexcept { return holds_[index].finger; }

  /// What finger `index` exerts on its user, in the world: normal load and friction together [N].
  [[nodiscard]] Eigen::Vector3d force_on_user(std::size_t index) const noexcept {
    const Hold& hold = holds_[index];
    const FingerOutput& output = hold.finger.output();
    return state_.orientation * Eigen::Vector3d(output.force + hold.normal * output.load);
  }
  /// The friction moment on the user about the contact normal, in the world [N m].
  [[nodiscard]] Eigen::Vector3d moment_on_user(std::size_t index) const noexcept {
    const Hold& hold = holds_[index];
    return state_.orientation * Eigen::Vector3d(hold.normal * hold.finger.output().moment);
  }

  /// Kinetic, gravity's and the springs' energy [J].
  [[nodiscard]] double energy() const noexcept {
    double sum = kinetic_energy(parameters_, state_) + gravity_energy(parameters_, state_);
    for (const Hold& hold : holds_) {
      const FingerState& state = hold.finger.state();
      const Springs& springs = hold.finger.friction().law().springs();
      if (!state.touching) continue;
      const Stretch drawn = state.stretch();
      sum += 0.5 * springs.stiffness[0] * (state.output.depth * state.output.depth + drawn.square()) +
             0.5 * springs.stiffness[1] * drawn.twist() * drawn.twist();
    }
    return sum;
  }
  /// What the slip of all fingers has dissipated since the beginning [J].
  [[nodiscard]] double dissipated() const noexcept { return dissipated_; }
  /// Steps of the implicit integrator whose equations were not solved to rounding within the limit.
  [[nodiscard]] std::size_t unsolved() const noexcept { return unsolved_; }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  struct Hold {
    Finger finger;
    ContactMemory memory;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // in the body's frame
  };

  /// Force and moment about the centre of mass, world axes.
  struct Load {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  };

  struct Touch {
    Contact contact;
    double twist;
  };

  void account() noexcept {
    for (const Hold& hold : holds_) dissipated_ += hold.finger.output().slip_work;
  }

  static Load total(const Load& a, const Load& b) noexcept { return {a.force + b.force, a.moment + b.moment}; }

  /// Step a in the body's frame.
  [[nodiscard]] Touch touch(const BodyState& state, const DevicePose& device, ContactMemory& memory) const noexcept {
    const Eigen::Vector3d finger = state.to_body(device.position);
    // A surface is asked about finite places only; what is not is left to the finger to refuse.
    if (!finger.allFinite() || !device.orientation.coeffs().allFinite()) {
      return {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN()}, 0.0};
    }
    const Contact contact = shape_.contact(finger, memory);
    return {contact, twist_about(state.orientation.conjugate() * device.orientation, contact.normal) + device.twist};
  }

  /// What a finger does to the body: the opposite of what its user feels, on the line through the finger, so that both ends agree on
  /// the moment and the springs' energy is accounted for. (It runs through the proxy too, where no damper acts. Through x_g it would
  /// be off by the depth times the friction force.)
  static void act(const BodyState& state, const Contact& contact, const FingerOutput& output, Load& load) noexcept {
    const Eigen::Vector3d force = state.orientation * Eigen::Vector3d(-output.force - contact.normal * output.load);
    const Eigen::Vector3d finger = contact.point - contact.normal * contact.depth;
    load.force += force;
    load.moment += (state.orientation * finger).cross(force) - state.orientation * Eigen::Vector3d(contact.normal * output.moment);
  }

  /// The last good contact of a finger, in the body's frame.
  [[nodiscard]] static Contact last_contact(const Finger& finger) noexcept {
    return {finger.state().goal, finger.state().normal, finger.output().depth};
  }

  /// The fingers' load on the body in this state, if it were the next. Remembers nothing.
  [[nodiscard]] Load preview(const BodyState& state, std::span<const DevicePose> devices, double time_step) const noexcept {
    Load load;
    for (std::size_t i = 0; i < holds_.size() && i < devices.size(); ++i) {
      ContactMemory memory = holds_[i].memory;
      const auto [contact, twist] = touch(state, devices[i], memory);
      const FingerOutput output = holds_[i].finger.preview(contact, twist, time_step);
      act(state, output.state != ContactState::invalid ? contact : last_contact(holds_[i].finger), output, load);
    }
    return load;
  }

  /// The same, remembered: steps a–c of all fingers.
  Load commit(std::span<const DevicePose> devices, double time_step) noexcept {
    Load load;
    for (std::size_t i = 0; i < holds_.size(); ++i) {
      Hold& hold = holds_[i];
      if (i >= devices.size()) {
        hold.finger.reset();
        hold.memory = {};
        continue;
      }
      const auto [contact, twist] = touch(state_, devices[i], hold.memory);
      const FingerOutput& output = hold.finger.update(contact, twist, time_step);
      if (output.state != ContactState::invalid) hold.normal = contact.normal;
      act(state_, last_contact(hold.finger), output, load);
    }
    return load;
  }

  [[nodiscard]] static BodyState moved(const BodyState& from, const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity,
                                       double time_step) noexcept {
    return {from.position + velocity * time_step, turned(from.orientation, angular_velocity, time_step), velocity, angular_velocity};
  }

  /// The explicit part of step d: velocities from a load, the free ones only.
  void accelerate(const Load& load, double time_step) noexcept {
    const Eigen::Vector3d velocity = state_.velocity + load.force * (time_step / parameters_.mass);
    const Eigen::Vector3d moment = load.moment - state_.angular_velocity.cross(angular_momentum(parameters_, state_));
    const Eigen::Vector3d in_body = (state_.orientation.conjugate() * moment).cwiseQuotient(parameters_.inertia);
    const Eigen::Vector3d angular_velocity = state_.angular_velocity + state_.orientation * in_body * time_step;
    for (int i = 0; i < 3; ++i) {
      if (parameters_.free[static_cast<std::size_t>(i)]) state_.velocity[i] = velocity[i];
      if (parameters_.free[static_cast<std::size_t>(i + 3)]) state_.angular_velocity[i] = angular_velocity[i];
    }
  }

  /// What is wrong with the velocities ξ at the end of the step: the change of momentum less the impulse that the loads
  /// at the end of the step give, each in units of velocity.
  [[nodiscard]] Vector6 residual(const Vector6& velocities, std::span<const DevicePose> devices, double time_step, const Load& external,
                                 const Eigen::Vector3d& momentum) const noexcept {
    const BodyState next = moved(state_, velocities.head<3>(), velocities.tail<3>(), time_step);
    const Load load = total(external, preview(next, devices, time_step));
    const Eigen::Vector3d turning = angular_momentum(parameters_, next) - momentum - load.moment * time_step;
    Vector6 result;
    result.head<3>() = velocities.head<3>() - state_.velocity - load.force * (time_step / parameters_.mass);
    result.tail<3>() = turning / parameters_.inertia.mean();
    for (int i = 0; i < 6; ++i) {
      if (!parameters_.free[static_cast<std::size_t>(i)]) result[i] = 0.0;
    }
    return result;
  }

  /// Velocities at the end of the step, what is wrong with them, and its size in a common unit: the speed of a point a radius of
  /// gyration away.
  struct Attempt {
    Vector6 velocities;
    Vector6 error;
    double size;
  };

  /// Implicit Euler: from the present velocities or from rest, whichever is nearer to solving it; if that does not lead to the end,
  /// from the other.
  [[nodiscard]] BodyState solve(std::span<const DevicePose> devices, double time_step, const Load& external) noexcept {
    const Eigen::Vector3d momentum = angular_momentum(parameters_, state_);
    const double gyration = std::sqrt(parameters_.inertia.mean() / parameters_.mass);
    const auto size = [&](const Vector6& value) { return value.head<3>().norm() + gyration * value.tail<3>().norm(); };
    const auto attempt = [&](const Vector6& velocities) {
      const Vector6 error = residual(velocities, devices, time_step, external, momentum);
      return Attempt{velocities, error, size(error)};
    };
    Vector6 present;
    present << state_.velocity, state_.angular_velocity;
    Vector6 still = present;
    for (int i = 0; i < 6; ++i) {
      if (parameters_.free[static_cast<std::size_t>(i)]) still[i] = 0.0;
    }
    double force = external.force.norm();
    for (const Hold& hold : holds_) force += hold.finger.output().load;
    const double unit = size(present) + force * time_step / parameters_.mass;

    Attempt first = attempt(present);
    Attempt second = attempt(still);
    if (second.size < first.size) std::swap(first, second);
    Attempt best = improve(first, unit, gyration, time_step, attempt);
    if (!(best.size <= solved_share * unit)) {
      const Attempt other = improve(second, unit, gyration, time_step, attempt);
      if (other.size < best.size) best = other;
      if (!(best.size <= solved_share * unit)) ++unsolved_;
    }
    return moved(state_, best.velocities.template head<3>(), best.velocities.template tail<3>(), time_step);
  }

  /// Newton's method, its Jacobian by differences, halving steps that do not reduce the residual (where a finger begins to
  /// slip the load has a kink).
  template <class Try>
  [[nodiscard]] Attempt improve(Attempt now, double unit, double gyration, double time_step, const Try& attempt) const noexcept {
    for (int i = 0; i < iteration_limit && now.size > 1e-15 * unit; ++i) {
      Matrix6 jacobian = Matrix6::Identity();
      for (int column = 0; column < 6; ++column) {
        if (!parameters_.free[static_cast<std::size_t>(column)]) continue;
        // Large against rounding of the proxies' places, small against the give of the springs.
        const double change = (column < 3 ? 1.0 : 1.0 / gyration) * 1e-9 / time_step;
        Vector6 beside = now.velocities;
        beside[column] += change;
        jacobian.col(column) = (attempt(beside).error - now.error) / change;
      }
      const Vector6 step = jacobian.partialPivLu().solve(now.error);
      if (!step.allFinite()) break;
      double share = 1.0;
      Attempt next = attempt(now.velocities - step);
      for (int halving = 0; halving < halving_limit && !(next.size < now.size); ++halving) {
        share *= 0.5;
        next = attempt(now.velocities - share * step);
      }
      // No better: what is left is rounding, or a kink that the next time step will pass.
      if (!(next.size < now.size)) break;
      now = next;
    }
    return now;
  }

  BodyParameters parameters_;
  BodyState state_;
  Shape shape_;
  Integrator integrator_;
  std::vector<Hold> holds_;
  double dissipated_ = 0.0;
  std::size_t unsolved_ = 0;
};

}  // namespace limitcurve::godobject
