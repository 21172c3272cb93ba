// SPDX-License-Identifier: MIT
#include "godobject/body/grasp.hpp"

#include "godobject/finger/sample.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace limitcurve::godobject {

namespace {

// Not aligned, so that no user's LU of a 6×6 matrix, compiled for another processor (-march=native), stands in for
// ours.
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// Whether a body's state is valid: finite, no number beyond `farthest`, an orientation, which it normalises.
bool make_plausible(BodyState& state) noexcept {
  const double square =
      state.position.squaredNorm() + state.velocity.squaredNorm() + state.angular_velocity.squaredNorm();
  return is_plausible<double>(square) && make_unit(state.orientation);
}

/// The end of a step.
struct Motion {
  BodyState state;
  Eigen::Vector3d angular_momentum;
};

/// The end of a step with the velocities ξ. In space the rotation ω Δt of the step is that of a free body, after a
/// moment at the beginning has given it its momentum: then ω is the mean of the angular velocities before and after the
/// turn, in the body's axes, and the turn changes neither the momentum nor the energy. With t the axis times the
/// tangent of half the angle and J the inertia, these angular velocities are ω ± J⁻¹(t × Jω).
Motion moved(const BodyParameters& body, const BodyState& from, const Eigen::Vector3d& velocity,
             const Eigen::Vector3d& angular_velocity, double time_step) noexcept {
  BodyState next{{from.position + velocity * time_step, turned(from.orientation, angular_velocity, time_step)},
                 velocity,
                 angular_velocity};
  if (!(body.free[3] && body.free[4] && body.free[5])) return {next, angular_momentum(body, next)};
  const Eigen::Vector3d rate = from.orientation.conjugate() * angular_velocity;
  const Eigen::Vector3d quarter = quarter_turn(rate, time_step);
  const Eigen::Vector3d momentum = body.inertia.cwiseProduct(rate);
  // A search may try more than half a turn.
  const Eigen::Vector3d swing = quarter.cross(momentum) * (2.0 / std::max(1.0 - quarter.squaredNorm(), 0.1));
  next.angular_velocity = next.orientation * Eigen::Vector3d(rate - swing.cwiseQuotient(body.inertia));
  return {next, from.orientation * Eigen::Vector3d(momentum + swing)};
}

/// The change of the angular velocity by an angular impulse about the free axes [N m s], whose other components are 0.
Eigen::Vector3d turn_by(const BodyParameters& body, const Orientation& orientation,
                        const Eigen::Vector3d& impulse) noexcept {
  const Eigen::Matrix3d axes = orientation.toRotationMatrix();
  Eigen::Matrix3d inertia = axes * body.inertia.asDiagonal() * axes.transpose();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (body.free[static_cast<std::size_t>(i) + 3]) continue;
    inertia.row(i).setZero();
    inertia.col(i).setZero();
    inertia(i, i) = 1.0;
  }
  return inertia.inverse() * impulse;
}

}  // namespace

Grasp::Grasp(const BodyParameters& parameters, const BodyState& state, AnySurface surface,
             std::vector<SoftFinger> fingers)
    : parameters_(parameters),
      state_(state),
      surface_(std::move(surface)),
      fingers_(std::move(fingers)),
      last_devices_(fingers_.size()),
      between_(fingers_.size()),
      friction_(fingers_.size()),
      elapsed_(fingers_.size()),
      gyration_(std::sqrt(parameters.inertia.mean() / parameters.mass)) {
  parameters_.validate();
  if (!make_unit(state_.orientation))
    throw out_of_range("norm of the orientation", state.orientation.norm(), "1", "within 1e-2 of 1");
  if (!make_plausible(state_))
    throw std::invalid_argument("state of the body: expected positions and velocities within 1e6 m, m/s and rad/s");
}

void Grasp::step(std::span<const DevicePose> devices, double time_step, const Eigen::Vector3d& force,
                 const Eigen::Vector3d& moment) noexcept {
  if (!(time_step > 0.0 && is_time_step(time_step))) return mark_invalid(Fault::time_step, 0.0);
  Load external;
  external.add(force + parameters_.mass * parameters_.gravity, moment, gyration_);
  // The speeds that the forces alone would give.
  BodyState pushed{
      {}, external.force * (time_step / parameters_.mass), moment * (time_step / parameters_.inertia.minCoeff())};
  if (!make_plausible(pushed)) return mark_invalid(Fault::force, time_step);
  // In whole, or in parts, counted in the smallest.
  bool all_solved = true;
  int size = max_parts;
  compare_places(devices, time_step);
  for (int done = 0; done < max_parts;) {
    const int end = done + size;
    const double part = time_step * size / max_parts;
    const std::span<const DevicePose> poses =
        end == max_parts ? devices : between(devices, static_cast<double>(end) / max_parts);
    bool solved = false;
    const Attempt attempt = solve(poses, part, external, solved);
    if (!solved && size > 1 && (size < max_parts || may_divide(devices, time_step))) {
      size /= 2;
      continue;
    }
    all_solved = all_solved && solved;
    BodyState next = end_of(attempt, part);
    if (!make_plausible(next)) return mark_invalid(Fault::body, time_step);
    state_ = next;
    commit(poses, part, done > 0);
    if (end < max_parts) compare_places(poses, part);
    divided_ += done == 0 && size < max_parts;
    done = end;
    if (size < max_parts && done % (2 * size) == 0) size *= 2;
  }
  if (!all_solved) ++unsolved_;
  remember(devices);
}

void Grasp::carry(BodyState state, std::span<const DevicePose> devices, double time_step) noexcept {
  if (!is_time_step(time_step)) return mark_invalid(Fault::time_step, 0.0);
  if (!make_plausible(state)) return mark_invalid(Fault::body, time_step);
  state_ = state;
  commit(devices, time_step, false);
  remember(devices);
}

void Grasp::place(BodyState state, std::span<const DevicePose> devices) noexcept {
  if (!make_plausible(state)) return mark_invalid(Fault::body, 0.0);
  state_ = state;
  slope_time_step_ = 0.0;
  for (SoftFinger& finger : fingers_) finger.state_.faults = {};
  const double dissipated = dissipated_;
  commit(devices, 0.0, false);
  dissipated_ = dissipated;
  remember(devices);
}

Eigen::Vector3d Grasp::force_on_user(std::size_t index) const noexcept {
  return state_.orientation * fingers_[index].output().whole_force();
}

Eigen::Vector3d Grasp::moment_on_user(std::size_t index) const noexcept {
  return state_.orientation * fingers_[index].output().moment_vector();
}

double Grasp::energy() const noexcept {
  double sum = kinetic_energy(parameters_, state_) + gravity_energy(parameters_, state_);
  for (const SoftFinger& finger : fingers_) sum += finger.spring_energy();
  return sum;
}

void Grasp::reset() noexcept {
  for (SoftFinger& finger : fingers_) finger.reset();
  last_count_ = 0;
  dissipated_ = 0.0;
  unsolved_ = 0;
  divided_ = 0;
  slope_time_step_ = 0.0;
}

void Grasp::remember(std::span<const DevicePose> devices) noexcept {
  last_count_ = std::min(devices.size(), fingers_.size());
  std::copy_n(devices.begin(), last_count_, last_devices_.begin());
}

/// The devices' poses at a fraction of the way from the last step to the present one.
std::span<const DevicePose> Grasp::between(std::span<const DevicePose> devices, double fraction) noexcept {
  for (std::size_t i = 0; i < last_count_; ++i) {
    const DevicePose& from = last_devices_[i];
    const double turn = std::remainder(devices[i].twist - from.twist, 2.0 * std::numbers::pi);
    between_[i] = {from.position + fraction * (devices[i].position - from.position),
                   from.orientation.normalized().slerp(fraction, devices[i].orientation.normalized()),
                   from.twist + fraction * turn};
  }
  return {between_.data(), last_count_};
}

/// The fingers' load on the body if `state` were its next state: the opposite of the users' forces, on the lines
/// through finger and proxy, so that both ends have the same moment. What rests keeps the sticking limit. Does not
/// change the fingers.
Grasp::Load Grasp::preview(const BodyState& state, std::span<const DevicePose> devices,
                           double time_step) const noexcept {
  Load load;
  for (std::size_t i = 0; i < fingers_.size() && i < devices.size(); ++i) {
    const DevicePose device = to_body(state, devices[i]);
    const FingerState next = fingers_[i].try_step(surface_, device, time_step);
    const FingerOutput& output = next.output;
    // After a refused sample the force acts at the last good position.
    const Eigen::Vector3d finger = output.state != ContactState::invalid ? device.position : next.sample.position();
    const Eigen::Vector3d force = state.orientation * Eigen::Vector3d(-output.whole_force());
    load.add(force, (state.orientation * finger).cross(force) - state.orientation * output.moment_vector(), gyration_);
  }
  return load;
}

/// Steps a–c of all fingers; changes them, and adds what their slip dissipates. If it `continues` a step, the output is
/// that of the step: it slips if a part of it did.
void Grasp::commit(std::span<const DevicePose> devices, double time_step, bool continues) noexcept {
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    SoftFinger& finger = fingers_[i];
    if (i >= devices.size()) {
      finger.reset();
      continue;
    }
    const FingerOutput before = finger.output();
    dissipated_ += finger.update(surface_, to_body(state_, devices[i]), time_step).slip_work;
    if (double& elapsed = finger.state_.faults.elapsed; std::isinf(elapsed)) elapsed = elapsed_[i] + time_step;
    if (!continues) continue;
    FingerOutput& now = finger.state_.output;
    now.slip_work += before.slip_work;
    now.converged = now.converged && before.converged;
    if (now.state != ContactState::stick || before.state != ContactState::slip) continue;
    now.state = ContactState::slip;
    now.cor = before.cor;
  }
}

/// A refused step: nothing moves, and every finger holds its last output.
void Grasp::mark_invalid(Fault fault, double time_step) noexcept {
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    if (double& elapsed = fingers_[i].state_.faults.elapsed; std::isinf(elapsed)) elapsed = elapsed_[i];
    fingers_[i].mark_invalid(fault, time_step);
  }
}

/// A body may leave a device behind at any speed: so its own motion tells a jump, in the frame of the body before the
/// step. Other samples pass at any speed, which an infinite time allows; one that is bad for another reason gets its
/// time back.
void Grasp::compare_places(std::span<const DevicePose> devices, double time_step) noexcept {
  for (std::size_t i = 0; i < fingers_.size() && i < devices.size(); ++i) {
    const DevicePose device = to_body(state_, devices[i]);
    FingerState& state = fingers_[i].state_;
    elapsed_[i] = state.faults.elapsed;
    // After a bad sample the body has moved on since the last good one.
    const double body_speed = state.faults.elapsed > 0.0
                                  ? state_.velocity.norm() + state_.angular_velocity.norm() * device.position.norm()
                                  : 0.0;
    if (is_in_reach(state.faults, state.sample, device.position, state.faults.elapsed + time_step,
                    fingers_[i].parameters().max_speed + body_speed))
      state.faults.elapsed = std::numeric_limits<double>::infinity();
  }
}

/// A try with the velocities ξ: its residual is the change of momentum minus the impulse of the loads at the end of the
/// step, in units of velocity.
Grasp::Attempt Grasp::attempt(const Vector6& velocities, std::span<const DevicePose> devices, double time_step,
                              const Load& external) const noexcept {
  const Motion next = moved(parameters_, state_, velocities.head<3>(), velocities.tail<3>(), time_step);
  Load load = preview(next.state, devices, time_step);
  load.add(external.force, external.moment, gyration_);
  const Eigen::Vector3d turning =
      next.angular_momentum - angular_momentum(parameters_, state_) - load.moment * time_step;
  Vector6 error;
  error.head<3>() = velocities.head<3>() - state_.velocity - load.force * (time_step / parameters_.mass);
  error.tail<3>() = turning / parameters_.inertia.mean();
  for (int i = 0; i < 6; ++i) {
    if (!parameters_.free[static_cast<std::size_t>(i)]) error[i] = 0.0;
  }
  const auto speed = [&](const auto& sliding, const auto& turn) { return sliding.norm() + gyration_ * turn.norm(); };
  return {velocities, error, speed(error.head<3>(), error.tail<3>()),
          speed(state_.velocity, state_.angular_velocity) + load.size * time_step / parameters_.mass};
}

/// Newton's method with a Jacobian by differences, which costs six attempts, and so serves, in later steps too, as long
/// as each step by it reduces the residual tenfold. A step that does not reduce the residual is halved: the load has
/// kinks where a finger slips or touches. At a kink the differences of one side may not lead down: then those of the
/// other are tried.
Grasp::Attempt Grasp::improve(Attempt now, std::span<const DevicePose> devices, double time_step,
                              const Load& external) noexcept {
  const auto at = [&](const Vector6& velocities) { return attempt(velocities, devices, time_step, external); };
  // Large compared with the rounding of positions, small compared with the deflection of the springs.
  double change = 1e-9 / time_step;
  bool turned_back = false;
  for (int i = 0; i < iteration_limit && now.size > 1e-15 * now.unit; ++i) {
    if (slope_time_step_ == time_step) {
      const Attempt next = at(now.velocities - inverse_slope_ * now.error);
      const bool is_solved = now.size <= solved_fraction * now.unit;
      if (next.size < (is_solved ? 1.0 : 0.1) * now.size) {
        now = next;
        turned_back = false;
        continue;
      }
      if (is_solved) break;
    }
    Matrix6 jacobian = Matrix6::Identity();
    for (int column = 0; column < 6; ++column) {
      if (!parameters_.free[static_cast<std::size_t>(column)]) continue;
      const double by = column < 3 ? change : change / gyration_;
      Vector6 beside = now.velocities;
      beside[column] += by;
      jacobian.col(column) = (at(beside).error - now.error) / by;
    }
    inverse_slope_ = Eigen::PartialPivLU<Matrix6>(jacobian).inverse();
    const Vector6 step = inverse_slope_ * now.error;
    slope_time_step_ = step.allFinite() ? time_step : 0.0;
    if (slope_time_step_ == 0.0) break;
    double fraction = 1.0;
    Attempt next = at(now.velocities - step);
    // What a whole step does not reduce there is rounding, of which stiff dampers have much.
    if (!(next.size < now.size) && now.size <= solved_fraction * now.unit) break;
    for (int halving = 0; halving < halving_limit && !(next.size < now.size); ++halving) {
      fraction *= 0.5;
      next = at(now.velocities - fraction * step);
    }
    if (next.size < now.size) {
      now = next;
      turned_back = false;
      continue;
    }
    // No improvement: there is a kink.
    if (turned_back) break;
    turned_back = true;
    change = -change;
  }
  return now;
}

/// The velocities of an implicit Euler step, from a start or from rest, whichever has the smaller residual; if that
/// does not converge, from the other.
Grasp::Attempt Grasp::search(std::span<const DevicePose> devices, double time_step, const Load& external,
                             const Vector6& start, bool& solved) noexcept {
  Vector6 still = start;
  for (int i = 0; i < 6; ++i) {
    if (parameters_.free[static_cast<std::size_t>(i)]) still[i] = 0.0;
  }
  Attempt first = attempt(start, devices, time_step, external);
  Attempt second = attempt(still, devices, time_step, external);
  if (second.size < first.size) std::swap(first, second);
  // A turn by more than about half a circle looks like one in the other direction, where a moment that slows it down
  // drives it.
  const auto is_solved = [&](const Attempt& found) {
    return found.size <= solved_fraction * found.unit && found.velocities.tail<3>().norm() * time_step <= largest_turn;
  };
  Attempt best = improve(first, devices, time_step, external);
  if (!is_solved(best)) {
    const Attempt other = improve(second, devices, time_step, external);
    if (is_solved(other) || other.size < best.size) best = other;
  }
  solved = is_solved(best);
  return best;
}

/// Marks the fingers that begin to slip at the end of a step: from then on their sliding limit acts. Whether there are
/// new ones.
bool Grasp::begin_slips(const Attempt& at, std::span<const DevicePose> devices, double time_step) noexcept {
  const BodyState end = moved(parameters_, state_, at.velocities.head<3>(), at.velocities.tail<3>(), time_step).state;
  bool begins = false;
  for (std::size_t i = 0; i < fingers_.size() && i < devices.size(); ++i) {
    SoftFinger& finger = fingers_[i];
    if (!finger.limits_.falls()) continue;
    FrictionMemory<double>& memory = finger.state_.friction;
    const FrictionMemory<double> next = finger.try_step(surface_, to_body(end, devices[i]), time_step).friction;
    begins = begins || (next.force_slides && !memory.force_slides) || (next.moment_slides && !memory.moment_slides);
    memory.force_slides = memory.force_slides || next.force_slides;
    memory.moment_slides = memory.moment_slides || next.moment_slides;
  }
  return begins;
}

/// The velocities of a step, and which fingers begin to slip in it. Where the sticking limit falls to a sliding one,
/// the force jumps when slip begins, and the equations may have no root: so solve them with the sticking limit, mark
/// what slips, and solve again, until nothing new slips. If that fails, the fingers stay as they were.
Grasp::Attempt Grasp::solve(std::span<const DevicePose> devices, double time_step, const Load& external,
                            bool& solved) noexcept {
  for (std::size_t i = 0; i < fingers_.size(); ++i) friction_[i] = fingers_[i].state_.friction;
  Vector6 present;
  present << state_.velocity, state_.angular_velocity;
  Attempt best = search(devices, time_step, external, present, solved);
  while (solved && begin_slips(best, devices, time_step))
    best = search(devices, time_step, external, best.velocities, solved);
  for (std::size_t i = 0; i < fingers_.size() && !solved; ++i) fingers_[i].state_.friction = friction_[i];
  return best;
}

/// The body at the end of a step. What the equations leave goes to the velocities: momentum changes by the impulse of
/// the forces as they are rendered.
BodyState Grasp::end_of(const Attempt& attempt, double time_step) const noexcept {
  auto [next, momentum] =
      moved(parameters_, state_, attempt.velocities.head<3>(), attempt.velocities.tail<3>(), time_step);
  momentum -= attempt.error.tail<3>() * parameters_.inertia.mean();
  next.velocity -= attempt.error.head<3>();
  next.angular_velocity += turn_by(parameters_, next.orientation, momentum - angular_momentum(parameters_, next));
  return next;
}

/// Whether a step may be done in parts: the devices' last poses are known, and no sample is refused. A jump that is
/// refused must not become a motion.
bool Grasp::may_divide(std::span<const DevicePose> devices, double time_step) const noexcept {
  if (std::min(devices.size(), fingers_.size()) != last_count_) return false;
  for (std::size_t i = 0; i < last_count_; ++i) {
    if (fingers_[i].output().state == ContactState::invalid) return false;
    if (fingers_[i].try_step(surface_, to_body(state_, devices[i]), time_step).output.state == ContactState::invalid)
      return false;
  }
  return true;
}

}  // namespace limitcurve::godobject
