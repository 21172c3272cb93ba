// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/contact_state.hpp"
#include "godobject/friction.hpp"

#include <Eigen/Core>

#include <numbers>
#include <utility>

namespace limitcurve::godobject {

/// What a step gives.
struct FingerOutput {
  ContactState state = ContactState::free;
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();        ///< x_p [m]; while free, the finger itself
  double angle = 0.0;                                     ///< α_p [rad] in the frame of the device's twist; while free, the twist
  double depth = 0.0;                                     ///< d [m]
  double load = 0.0;                                      ///< P = k_l d [N], 0 while free
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user, k_l (x_p − x_g) [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal, k_r (α_p − α_g) [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  double slip_work = 0.0;                                 ///< dissipated in this step [J], ≥ 0
};

/// All that a finger remembers from one step to the next. A plain value: copy, save and restore it.
struct FingerState {
  FingerOutput output;
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();     ///< x_g of the last good step [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward normal there
  Eigen::Vector3d seen = Eigen::Vector3d::Zero();     ///< where the finger was when last seen, refused or not [m]
  double goal_angle = 0.0;                            ///< α_g of the last good step [rad], unwrapped
  double device_angle = 0.0;                          ///< the device's twist as it was given [rad]
  double turn = 0.0;                                  ///< what unwrapping has added to it [rad], a multiple of 2π
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();   ///< x_p − x_g after the step, tangential [m]
  double lag = 0.0;                                   ///< α_p − α_g after the step [rad]
  double start = -1.0;                                ///< place of the last slip, or 0; < 0: it sticks
  double trend = 0.0;                                 ///< how far that has moved since the slip before
  bool touching = false;
  bool known = false;  ///< there was a step before
};

/// A soft-finger god-object on one surface: steps a–c of the paper, corrected (README, "Corrections to the paper").
/// The boundary decides how force and moment limit each other, the projection where a slipping proxy comes to lie.
template <LimitBoundary Boundary, class Projection>
class SoftFinger {
 public:
  /// A contact farther than this from the origin [m], or turned farther [rad], is taken for a fault of the device.
  static constexpr double farthest = 1e6;
  /// Dampers do not act in steps shorter than this [s].
  static constexpr double shortest_time_step = 1e-9;

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  SoftFinger(Boundary boundary, const FingerParameters& parameters, Projection projection = {})
      : friction_(std::move(boundary), parameters, projection) {}

  /// One step: the contact of the finger with the surface and the device's twist α_s [rad] about the normal. The twist may
  /// wrap around at any multiple of 2π: a jump of more than π between steps is taken for a turn of the other sense.
  /// Input that is not finite, or no contact (a normal that is not of unit length), gives the state `invalid`: the last
  /// good output is held (or let go of, see `hold_share`), and the proxy stays where it is.
  /// With a time step [s] > 0 since the last update the dampers act too, within the limit: the wrench that friction bounds
  /// is that of springs and dampers together, and so is what the user feels.
  const FingerOutput& update(const Contact& contact, double twist, double time_step = 0.0) noexcept {
    advance(state_, contact, twist, time_step);
    return state_.output;
  }

  /// What `update` would give, without remembering it.
  [[nodiscard]] FingerOutput preview(const Contact& contact, double twist, double time_step = 0.0) const noexcept {
    FingerState state = state_;
    advance(state, contact, twist, time_step);
    return state.output;
  }

  [[nodiscard]] const FingerOutput& output() const noexcept { return state_.output; }
  [[nodiscard]] const FingerState& state() const noexcept { return state_; }
  void restore(const FingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }

  [[nodiscard]] const Friction<Boundary, Projection>& friction() const noexcept { return friction_; }

  /// How far the finger is from slipping, as a fraction: 1 without friction, 0 on the limit; 0 while it slips, 1 while free.
  [[nodiscard]] double margin() const noexcept {
    const FingerOutput& output = state_.output;
    if (!state_.touching) return 1.0;
    if (output.state == ContactState::slip) return 0.0;
    const double r = output.force.norm() / friction_.law().stiffness();
    const double rho = std::fabs(output.moment) / friction_.law().twist_stiffness();
    return std::clamp(friction_.margin(r, rho, output.load, state_.start >= 0.0), 0.0, 1.0);
  }

  /// The least load [N] under which the contact would bear its present friction without slipping: the grip needed to hold.
  [[nodiscard]] double load_to_hold() const noexcept {
    return friction_.load_to_hold(state_.output.force.norm(), std::fabs(state_.output.moment));
  }

  /// Where the slip's centre of rotation is, in the surface's frame [m]; infinite for pure sliding, NaN unless it slips.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept {
    const FingerOutput& output = state_.output;
    // The finger slides along −force, and turns against the moment: v = ω n × (x_g − C).
    const double force = output.force.norm();
    if (!(output.cor > 0.0) || force == 0.0) return state_.goal + Eigen::Vector3d::Constant(0.0 * output.cor);
    return state_.goal - output.force.cross(state_.normal) * (std::copysign(output.cor, output.moment) / force);
  }

 private:
  [[nodiscard]] static bool usable(const Contact& contact, double twist) noexcept {
    // One comparison for all, which is false for NaN too.
    const double squares = contact.point.squaredNorm() + contact.depth * contact.depth + twist * twist;
    return squares <= farthest * farthest && std::fabs(contact.normal.squaredNorm() - 1.0) <= 1e-6;
  }

  /// Whether the finger has moved farther than a device can since it was last seen. It is then seen where it is: a
  /// fault of one sample costs one step, and a finger that stays there is believed.
  [[nodiscard]] bool jumped(FingerState& state, const Contact& contact) const noexcept {
    const double limit = friction_.law().jump_limit();
    if (limit == std::numeric_limits<double>::infinity()) return false;
    const Eigen::Vector3d finger = contact.point - contact.normal * contact.depth;
    const bool result = state.known && (finger - state.seen).squaredNorm() > limit * limit;
    state.seen = finger;
    state.known = true;
    return result;
  }

  void hold(FingerState& state) const noexcept {
    FingerOutput& output = state.output;
    const double share = friction_.law().hold_share();
    output.state = ContactState::invalid;
    output.slip_work = 0.0;
    output.load *= share;
    output.force *= share;
    output.moment *= share;
  }

  static void release(FingerState& state, const Contact& contact, double twist) noexcept {
    FingerOutput output;
    output.proxy = contact.point - contact.normal * contact.depth;
    output.angle = twist;
    output.depth = contact.depth;
    FingerState free;
    free.output = output;
    free.goal = contact.point;
    free.normal = contact.normal;
    free.seen = state.seen;
    free.known = state.known;
    free.goal_angle = twist;
    free.device_angle = twist;
    state = free;
  }

  /// α_g: the device's angle with its turns put back. Adds exactly 0 as long as the device does not jump.
  static double unwrap(FingerState& state, double twist) noexcept {
    const double jump = twist - state.device_angle;
    if (state.touching && std::fabs(jump) > std::numbers::pi) {
      state.turn -= 2.0 * std::numbers::pi * std::round(jump / (2.0 * std::numbers::pi));
    } else if (!state.touching) {
      state.turn = 0.0;
    }
    state.device_angle = twist;
    return twist + state.turn;
  }

  [[gnu::always_inline]] void advance(FingerState& state, const Contact& contact, double twist, double time_step) const noexcept {
    FingerOutput& output = state.output;
    if (!usable(contact, twist) || jumped(state, contact)) return hold(state);
    if (!(contact.depth > 0.0)) return release(state, contact, twist);
    const ContactLaw& law = friction_.law();
    const double goal_angle = unwrap(state, twist);
    const double last_depth = output.depth;
    if (!state.touching) {
      // Touch-down: no friction yet. (The paper's α_0 is the twist here; angles are kept absolute, and α_p − α_g is the same.)
      output.proxy = contact.point;
      output.angle = goal_angle;
      state.offset.setZero();
      state.lag = 0.0;
      state.touching = true;
      state.start = -1.0;
    }
    state.goal = contact.point;
    state.normal = contact.normal;
    state.goal_angle = goal_angle;
    output.depth = contact.depth;
    output.load = law.stiffness() * contact.depth;

    Eigen::Vector3d offset = output.proxy - contact.point;
    offset -= contact.normal * contact.normal.dot(offset);
    const double lag = output.angle - goal_angle;
    if (time_step >= shortest_time_step && (law.damping() > 0.0 || law.twist_damping() > 0.0)) {
      output.load = std::max(output.load + law.damping() / time_step * (contact.depth - last_depth), 0.0);
      return rub_damped(state, contact, offset, lag, time_step);
    }
    state.offset.setZero();
    state.lag = 0.0;
    rub(state, contact, offset, lag, law.springs());
  }

  /// Implicitly, k e + (b/Δt)(e − e_last) is a spring of k + b/Δt from a place nearer to the last offset.
  void rub_damped(FingerState& state, const Contact& contact, const Eigen::Vector3d& offset, double lag, double time_step) const noexcept {
    const ContactLaw& law = friction_.law();
    const double rate = law.damping() / time_step;
    const double twist_rate = law.twist_damping() / time_step;
    const Springs springs = Springs::of(law.stiffness() + rate, law.twist_stiffness() + twist_rate);
    state.offset *= rate * springs.compliance;
    state.lag *= twist_rate * springs.twist_compliance;
    rub(state, contact, offset - state.offset, lag - state.lag, springs);
  }

  /// Steps b and c. The springs rest where `state` has offset and lag, and are drawn from there by pull and turn;
  /// afterwards `state` has the new offset and lag.
  [[gnu::always_inline]] void rub(FingerState& state, const Contact& contact, const Eigen::Vector3d& pull, double turn,
                                  const Springs& springs) const noexcept {
    FingerOutput& output = state.output;
    if constexpr (Friction<Boundary, Projection>::shrinks) {
      const double square = pull.squaredNorm();
      const auto [known, share] = friction_.shrink(square, turn * turn, output.load, state.start >= 0.0, springs);
      if (known) {
        if (share == 1.0) return stick(state, pull, turn, springs);
        output.force = pull * (springs.stiffness * share);
        output.moment = springs.twist_stiffness * share * turn;
        output.slip_work = (1.0 - share) * share * (springs.stiffness * square + springs.twist_stiffness * turn * turn);
        output.cor = std::sqrt(square) / std::fabs(turn);
        state.offset += pull * share;
        state.lag += turn * share;
        return slip(state, contact, 0.0);
      }
    }
    const double r = pull.norm();
    const double rho = std::fabs(turn);
    const auto result = friction_.resolve(r, rho, output.load, ahead_of(state.start, state.trend), springs);
    if (!result.slips) {
      if (result.twist == rho) return stick(state, pull, turn, springs);
      // No torsional friction: the proxy turns with the finger.
      stick(state, pull, 0.0, springs);
      output.angle = state.goal_angle;
      state.lag = 0.0;
      return;
    }
    // r = 0 and ρ = 0 have no direction, and need none: eq. (23) without its 0/0.
    const double per_metre = r > 0.0 ? 1.0 / r : 0.0;
    output.force = pull * (result.force * per_metre);
    output.moment = std::copysign(result.moment, turn);
    output.cor = result.cor;
    output.slip_work = result.slip_work;
    state.offset += result.offset == r ? pull : Eigen::Vector3d(pull * (result.offset * per_metre));
    state.lag += std::copysign(result.twist, turn);
    slip(state, contact, result.start, result.offset != r, result.twist != rho);
  }

  static void stick(FingerState& state, const Eigen::Vector3d& pull, double turn, const Springs& springs) noexcept {
    FingerOutput& output = state.output;
    output.state = ContactState::stick;
    output.force = pull * springs.stiffness;
    output.moment = springs.twist_stiffness * turn;
    output.cor = std::numeric_limits<double>::quiet_NaN();
    output.slip_work = 0.0;
    state.offset += pull;
    state.lag += turn;
    state.start = -1.0;
  }

  /// Moves the proxy to where offset and lag now put it. What did not slide is not touched, not even by rounding.
  static void slip(FingerState& state, const Contact& contact, double start, bool slides = true, bool turns = true) noexcept {
    FingerOutput& output = state.output;
    const Eigen::Vector3d proxy = slides ? Eigen::Vector3d(contact.point + state.offset) : output.proxy;
    const double angle = turns ? state.goal_angle + state.lag : output.angle;
    // A slip that is lost in the rounding of the proxy is none.
    const bool moves = proxy != output.proxy || angle != output.angle;
    output.proxy = proxy;
    output.angle = angle;
    output.state = moves ? ContactState::slip : ContactState::stick;
    if (!moves) {
      output.cor = std::numeric_limits<double>::quiet_NaN();
      output.slip_work = 0.0;
      start = -1.0;
    }
    state.trend = start > 0.0 && state.start > 0.0 ? start - state.start : 0.0;
    state.start = start;
  }

  Friction<Boundary, Projection> friction_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
