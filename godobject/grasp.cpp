// SPDX-License-Identifier: MIT
#include "godobject/grasp.hpp"

#include "limitcurve/number.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve::godobject {

namespace {

BodyState moved(const BodyState& from, const Eigen::Vector3d& velocity, const Eigen::Vector3d& angular_velocity,
                double time_step) noexcept {
  return {from.position + velocity * time_step, turned(from.orientation, angular_velocity, time_step), velocity, angular_velocity};
}

}  // namespace

Grasp::Grasp(const BodyParameters& parameters, const BodyState& state, AnySurface surface, std::vector<SoftFinger> fingers)
    : parameters_(parameters), state_(state), surface_(std::move(surface)) {
  parameters_.validate();
  holds_.reserve(fingers.size());
  for (SoftFinger& finger : fingers) holds_.push_back({std::move(finger), {}, Eigen::Vector3d::Zero()});
  if (const double norm = state.orientation.norm(); !(std::fabs(norm - 1.0) <= 1e-9)) {
    throw out_of_range("norm of the orientation", norm, "1", "1");
  }
}

void Grasp::step(std::span<const DevicePose> devices, double time_step, const Eigen::Vector3d& force,
                 const Eigen::Vector3d& moment) noexcept {
  state_ = solve(devices, time_step, {force + parameters_.mass * parameters_.gravity, moment});
  commit(devices, time_step);
  account();
}

void Grasp::carry(const BodyState& state, std::span<const DevicePose> devices, double time_step) noexcept {
  state_ = state;
  commit(devices, time_step);
  account();
}

void Grasp::place(const BodyState& state, std::span<const DevicePose> devices) noexcept {
  state_ = state;
  commit(devices, 0.0);
}

Eigen::Vector3d Grasp::force_on_user(std::size_t index) const noexcept {
  const Hold& hold = holds_[index];
  const FingerOutput output = hold.finger.output();
  return state_.orientation * Eigen::Vector3d(output.force + hold.normal * output.load);
}

Eigen::Vector3d Grasp::moment_on_user(std::size_t index) const noexcept {
  const Hold& hold = holds_[index];
  return state_.orientation * Eigen::Vector3d(hold.normal * hold.finger.state().moment);
}

double Grasp::energy() const noexcept {
  double sum = kinetic_energy(parameters_, state_) + gravity_energy(parameters_, state_);
  for (const Hold& hold : holds_) sum += hold.finger.spring_energy();
  return sum;
}

void Grasp::account() noexcept {
  for (const Hold& hold : holds_) dissipated_ += hold.finger.state().slip_work;
}

/// Step a in the body's frame.
Grasp::Touch Grasp::touch(const BodyState& state, const DevicePose& device, ContactMemory& memory) const noexcept {
  const Eigen::Vector3d finger = state.to_body(device.position);
  // A surface is asked about finite places only; what is not is left to the finger to refuse.
  if (!finger.allFinite() || !device.orientation.coeffs().allFinite()) {
    return {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN()}, 0.0};
  }
  const Contact contact = surface_.contact(finger, memory);
  return {contact, twist_about(state.orientation.conjugate() * device.orientation, contact.normal) + device.twist};
}

/// What a finger does to the body: the opposite of what its user feels, on the line through the finger, so that both ends agree on
/// the moment and the springs' energy is accounted for. (It runs through the proxy too, where no damper acts. Through x_g it would
/// be off by the depth times the friction force.)
void Grasp::act(const BodyState& state, const Contact& contact, const FingerOutput& output, Load& load) noexcept {
  const Eigen::Vector3d force = state.orientation * Eigen::Vector3d(-output.force - contact.normal * output.load);
  const Eigen::Vector3d finger = contact.point - contact.normal * contact.depth;
  load.force += force;
  load.moment += (state.orientation * finger).cross(force) - state.orientation * Eigen::Vector3d(contact.normal * output.moment);
}

/// The last good contact of a finger, in the body's frame.
Contact Grasp::last_contact(const SoftFinger& finger) noexcept {
  const FingerState& state = finger.state();
  return {vector(state.goal), vector(state.normal), state.depth};
}

/// The fingers' load on the body in this state, if it were the next. Remembers nothing.
Grasp::Load Grasp::preview(const BodyState& state, std::span<const DevicePose> devices, double time_step) const noexcept {
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
void Grasp::commit(std::span<const DevicePose> devices, double time_step) noexcept {
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    Hold& hold = holds_[i];
    if (i >= devices.size()) {
      hold.finger.reset();
      hold.memory = {};
      continue;
    }
    // A sample that the finger refuses leaves no trace in what the surface remembers either.
    ContactMemory memory = hold.memory;
    const auto [contact, twist] = touch(state_, devices[i], memory);
    if (hold.finger.update(contact, twist, time_step).state == ContactState::invalid) continue;
    hold.memory = memory;
    hold.normal = contact.normal;
  }
}

/// What is wrong with the velocities ξ at the end of the step: the change of momentum less the impulse that the loads
/// at the end of the step give, each in units of velocity.
Grasp::Vector6 Grasp::residual(const Vector6& velocities, std::span<const DevicePose> devices, double time_step, const Load& external,
                               const Eigen::Vector3d& momentum) const noexcept {
  const BodyState next = moved(state_, velocities.head<3>(), velocities.tail<3>(), time_step);
  Load load = preview(next, devices, time_step);
  load.force += external.force;
  load.moment += external.moment;
  const Eigen::Vector3d turning = angular_momentum(parameters_, next) - momentum - load.moment * time_step;
  Vector6 result;
  result.head<3>() = velocities.head<3>() - state_.velocity - load.force * (time_step / parameters_.mass);
  result.tail<3>() = turning / parameters_.inertia.mean();
  for (int i = 0; i < 6; ++i) {
    if (!parameters_.free[static_cast<std::size_t>(i)]) result[i] = 0.0;
  }
  return result;
}

/// Newton's method, its Jacobian by differences, halving steps that do not reduce the residual (where a finger begins to
/// slip the load has a kink).
template <class Try>
Grasp::Attempt Grasp::improve(Attempt now, double unit, double gyration, double time_step, const Try& attempt) const noexcept {
  for (int i = 0; i < iteration_limit && now.size > 1e-15 * unit; ++i) {
    Eigen::Matrix<double, 6, 6> jacobian = Eigen::Matrix<double, 6, 6>::Identity();
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

/// Implicit Euler: from the present velocities or from rest, whichever is nearer to solving it; if that does not lead to the end,
/// from the other.
BodyState Grasp::solve(std::span<const DevicePose> devices, double time_step, const Load& external) noexcept {
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
  for (const Hold& hold : holds_) force += hold.finger.state().load;
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
  return moved(state_, best.velocities.head<3>(), best.velocities.tail<3>(), time_step);
}

}  // namespace limitcurve::godobject
