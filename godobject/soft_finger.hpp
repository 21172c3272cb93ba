// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/contact_state.hpp"
#include "godobject/finger_state.hpp"
#include "godobject/friction.hpp"
#include "godobject/grip.hpp"
#include "godobject/input_checks.hpp"
#include "godobject/stretch.hpp"

#include <Eigen/Core>

#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

namespace limitcurve::godobject {

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
  /// Input that is not finite, no contact (a normal that is not of unit length), a leap (`jump_limit`) or a time step < 0 gives the
  /// state `invalid`: the last good output is held, let go of softly if that lasts (`hold_share`), and the proxy stays where it is.
  /// With a time step [s] > 0 since the last update the dampers act too, within the limit: the wrench that friction bounds
  /// is that of springs and dampers together, and so is what the user feels.
  const FingerOutput& update(const Contact& contact, double twist, double time_step) noexcept {
    return advance(state_, contact, twist, time_step);
  }
  /// The same in no time.
  const FingerOutput& update(const Contact& contact, double twist) noexcept { return advance(state_, contact, twist, 0.0); }

  /// What `update` would give, without remembering it.
  [[nodiscard]] FingerOutput preview(const Contact& contact, double twist, double time_step = 0.0) const noexcept {
    FingerState state = state_;
    advance(state, contact, twist, time_step);
    return state.output;
  }

  [[nodiscard]] const FingerOutput& output() const noexcept { return state_.output; }
  [[nodiscard]] const FingerState& state() const noexcept { return state_; }
  void restore(const FingerState& state) noexcept {
    state_ = state;
    // It may be another finger's.
    state_.leave_home();
  }
  void reset() noexcept { state_ = {}; }
  /// Forgets where the last slip was, but not that it slipped: the next search begins from nothing, as a finger's first does.
  void forget_place() noexcept {
    if (state_.start > 0.0) state_.start = 0.0;
    state_.piece = 0;
  }

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
  static constexpr bool has_guesses = Friction<Boundary, Projection>::has_guesses;

  /// Whether a finger that is not near where it was last seen is to be refused; it is then seen where it is. Believed is one that
  /// stays there, one that is back where it last was good, and the first of all.
  [[nodiscard, gnu::noinline]] bool leaps(FingerState& state, const Stretch& finger) const noexcept {
    const Stretch last = finger_of({state.goal, state.normal, state.output.depth});
    state.leave_home();
    const bool known = std::isfinite(state.seen.x());
    finger.get_place(state.seen);
    return known && (finger - last).square() > friction_.law().jump_limit_square();
  }

  [[gnu::noinline, gnu::cold]] const FingerOutput& hold(FingerState& state) const noexcept {
    FingerOutput& output = state.output;
    // A sample that is lost is nothing that a finger should feel.
    const double share = output.state == ContactState::invalid ? friction_.law().hold_share() : 1.0;
    output.state = ContactState::invalid;
    output.slip_work = 0.0;
    output.load *= share;
    output.force *= share;
    output.moment *= share;
    return output;
  }

  [[gnu::noinline]] static const FingerOutput& release(FingerState& state, const Contact& contact, double twist) noexcept {
    FingerOutput output;
    output.proxy = contact.point - contact.normal * contact.depth;
    output.angle = twist;
    output.depth = contact.depth;
    FingerState free;
    free.output = output;
    free.goal = contact.point;
    free.normal = contact.normal;
    free.seen = state.seen;
    free.goal_angle = twist;
    free.device_angle = twist;
    state = free;
    return state.output;
  }

  /// Puts the device's turns back: α_g is its angle and the turn, which is exactly 0 as long as the device does not jump.
  [[gnu::noinline, gnu::cold]] static void unwrap(FingerState& state, double twist) noexcept {
    const double jump = twist - state.device_angle;
    state.turn -= 2.0 * std::numbers::pi * std::round(jump / (2.0 * std::numbers::pi));
  }

  /// A step. What is usual, a contact at home, is told by two comparisons (Home). It calls nothing: a function that calls has registers to save
  /// for others, and to keep in memory what it needs thereafter.
  [[gnu::always_inline]] const FingerOutput& advance(FingerState& state, const Contact& contact, double twist,
                                                     double time_step) const noexcept {
    if (!is_time(time_step)) return advance_seldom(state, contact, twist, time_step);
    if constexpr (has_guesses) {
      // Apart: a search from a guess, and one from the last slip, have registers of their own.
      if (std::bit_cast<std::int64_t>(anew(state.start)) <= 0) return advance_from_rest(state, contact, twist, time_step);
      return advance_at_home<Known::slipping>(state, contact, twist, time_step);
    } else {
      return advance_at_home<Known::home>(state, contact, twist, time_step);
    }
  }

  [[gnu::noinline]] const FingerOutput& advance_from_rest(FingerState& state, const Contact& contact, double twist,
                                                          double time_step) const noexcept {
    return advance_at_home<Known::resting>(state, contact, twist, time_step);
  }

  template <Known known>
  [[gnu::always_inline]] const FingerOutput& advance_at_home(FingerState& state, const Contact& contact, double twist,
                                                             double time_step) const noexcept {
    // Not from the contact again once something is written, which for all a compiler knows might be that.
    const Stretch point = Stretch::at(contact.point, twist);
    const Stretch normal = Stretch::at(contact.normal, 0.0);
    const double depth = contact.depth;
    if (!friction_.home().holds(point - Stretch::load(&state.home), depth)) return advance_seldom(state, contact, twist, time_step);
    if (std::memcmp(&contact.normal, &state.normal, sizeof contact.normal) != 0) {
      if (!is_unit(contact.normal)) return advance_seldom(state, contact, twist, time_step);
      normal.get_place(state.normal);
    }
    return touch<known>(state, point, normal, depth, twist);
  }

  /// The same for what is not usual: whatever may be wrong with the input, a finger in the air or just down, one that is far from where it
  /// was, dampers, a radius that depends on the load.
  [[gnu::noinline]] const FingerOutput& advance_seldom(FingerState& state, const Contact& contact, double twist,
                                                       double time_step) const noexcept {
    const double square = square_from_origin(contact, twist);
    if (!(square <= farthest * farthest) || !is_unit(contact.normal) || !is_time(time_step)) return hold(state);
    const Stretch finger = finger_of(contact);
    const Stretch seen = state.has_home() ? finger_of({state.goal, state.normal, state.output.depth}) : Stretch::at(state.seen, 0.0);
    const bool near = (finger - seen).square() <= friction_.law().jump_limit_square();
    if (!near && leaps(state, finger)) return hold(state);
    finger.get_place(state.seen);
    if (!(contact.depth > 0.0)) return release(state, contact, twist);
    if (!state.touching) {
      touch_down(state, contact, twist);
    } else if (std::fabs(twist - state.device_angle) > std::numbers::pi) {
      unwrap(state, twist);
    }
    if (friction_.law().has_dampers() && time_step >= shortest_time_step) return rub_damped(state, contact, twist, time_step);
    const Stretch point = Stretch::at(contact.point, twist);
    // With a margin, so that nothing near it is too far.
    const bool settles = friction_.home().takes(contact.depth) && square <= (farthest - 10.0) * (farthest - 10.0);
    point.with_twist(settles ? twist : std::numeric_limits<double>::quiet_NaN()).store(&state.home);
    state.normal = contact.normal;
    return touch<Known::nothing>(state, point, Stretch::at(contact.normal, 0.0), contact.depth, twist);
  }

  /// Steps b and c of the paper, without dampers.
  template <Known known>
  [[gnu::always_inline]] const FingerOutput& touch(FingerState& state, const Stretch& point, const Stretch& normal, double depth,
                                                   double twist) const noexcept {
    state.device_angle = twist;
    const ContactLaw& law = friction_.law();
    FingerOutput& output = state.output;
    const Stretch goal = point.with_twist(twist + state.turn);
    const Stretch apart = Stretch::load(&output) - goal;
    output.load = law.stiffness() * depth;
    output.depth = depth;
    goal.store(&state.goal);
    return rub_usually<known>(state, goal, apart, normal);
  }

  /// The same once the load and the goal are known, with the proxy that far apart from it.
  template <Known known>
  [[gnu::always_inline]] const FingerOutput& rub_usually(FingerState& state, const Stretch& goal, const Stretch& apart,
                                                         const Stretch& normal) const noexcept {
    const Springs& springs = friction_.law().springs();
    FingerOutput& output = state.output;
    const Stretch::Part part = apart.part_along(normal);
    const Stretch drawn = part.stretch;
    const FingerOutput* result = &output;
    // By force: where a compiler has many fingers it would rather call, with the grip in memory.
    friction_.template grip<known>(
        {part.square, std::fabs(apart.twist()), output.load, state.start, state.trend, state.piece},
        [&, drawn ]() __attribute__((always_inline)) {
          (drawn * springs.stiffness).store(&output.force);
          stick(state);
        },
        [&, drawn ](const Grip& grip) __attribute__((always_inline)) {
          // A search leaves no registers for what is in memory too, the proxy and its goal: they are read again.
          if constexpr (has_guesses) std::atomic_signal_fence(std::memory_order_seq_cst);
          yield<known>(state, has_guesses ? Stretch::load(&state.goal) : goal, drawn, springs, grip);
        },
        [&]() __attribute__((always_inline)) { result = &rub_rarely(state); },
        [&]() __attribute__((always_inline)) { result = &rub_lost(state); });
    return *result;
  }

  /// The same where a search takes more than one step; from the state, as rub_rarely.
  [[gnu::noinline]] const FingerOutput& rub_lost(FingerState& state) const noexcept {
    const Stretch goal = Stretch::load(&state.goal);
    return rub_usually<Known::lost>(state, goal, Stretch::load(&state.output) - goal, Stretch::at(state.normal, 0.0));
  }

  /// No friction yet. (The paper's α_0 is the twist here; angles are kept absolute, and α_p − α_g is the same.)
  [[gnu::noinline, gnu::cold]] static void touch_down(FingerState& state, const Contact& contact, double twist) noexcept {
    state.output.proxy = state.goal = contact.point;
    state.output.angle = state.goal_angle = twist;
    state.turn = 0.0;
    state.touching = true;
    state.start = -1.0;
  }

  /// Steps b and c where they take what seldom happens; from the state, so that nothing of the usual case is kept in memory for it.
  [[gnu::noinline]] const FingerOutput& rub_rarely(FingerState& state) const noexcept {
    rub(state, Stretch::load(&state.goal), state.stretch(), friction_.law().springs());
    return state.output;
  }

  /// Implicitly, k e + (b/Δt)(e − e_last) is a spring of k + b/Δt from a place nearer to the last offset.
  [[gnu::noinline]] const FingerOutput& rub_damped(FingerState& state, const Contact& contact, double twist,
                                                   double time_step) const noexcept {
    state.device_angle = twist;
    const ContactLaw& law = friction_.law();
    FingerOutput& output = state.output;
    const Pair rate = Pair{law.damping(), law.twist_damping()} / time_step;
    const Pair stiffness = law.springs().stiffness + rate;
    const Springs springs = Springs::of(stiffness[0], stiffness[1]);
    const Stretch rest = state.stretch() * (rate * springs.compliance);
    output.load = std::max(law.stiffness() * contact.depth + rate[0] * (contact.depth - output.depth), 0.0);
    const Stretch goal = Stretch::at(contact.point, twist + state.turn);
    output.depth = contact.depth;
    goal.store(&state.goal);
    state.normal = contact.normal;
    rub(state, goal + rest, state.stretch() - rest, springs);
    return state.output;
  }

  /// Steps b and c: springs that rest with the proxy at `from` are drawn from there.
  void rub(FingerState& state, const Stretch& from, const Stretch& drawn, const Springs& springs) const noexcept {
    const Grip grip = friction_.grip_rarely(
        {drawn.square(), std::fabs(drawn.twist()), state.output.load, state.start, state.trend, state.piece}, springs);
    // No torsional friction: the proxy turns with the finger.
    if (grip.share[1] == 0.0) state.output.angle = state.goal_angle;
    yield(state, from, drawn, springs, grip);
  }

  template <Known known = Known::nothing>
  [[gnu::always_inline]] static void yield(FingerState& state, const Stretch& from, const Stretch& drawn, const Springs& springs,
                                           const Grip& grip) noexcept {
    const Stretch felt = drawn * grip.share;
    (felt * springs.stiffness).store(&state.output.force);
    if (!grip.slips) return stick(state);
    slip<known>(state, from + felt, grip);
  }

  [[gnu::always_inline]] static void stick(FingerState& state) noexcept {
    FingerOutput& output = state.output;
    output.state = ContactState::stick;
    output.cor = std::numeric_limits<double>::quiet_NaN();
    output.slip_work = 0.0;
    state.start = -1.0;
  }

  /// Moves the proxy to where the springs now put it. What did not slide is not touched, not even by rounding.
  template <Known known>
  [[gnu::always_inline]] static void slip(FingerState& state, const Stretch& to, const Grip& grip) noexcept {
    FingerOutput& output = state.output;
    const Stretch last = Stretch::load(&output);
    const Stretch proxy = grip.clamps_both ? to : to.where_less(grip.share, last);
    if (proxy == last) {
      // A slip that is lost in the rounding of the proxy is none.
      state.trend = 0.0;
      return stick(state);
    }
    proxy.store(&output);
    output.state = ContactState::slip;
    output.cor = grip.cor;
    output.slip_work = grip.slip_work;
    // Where the last slip was is nothing that a step by squares asks.
    if constexpr (!Friction<Boundary, Projection>::needs_squares_only) {
      state.trend = known == Known::resting || (known != Known::slipping && !(state.start > 0.0)) ? 0.0 : grip.start - state.start;
      state.piece = grip.piece;
    }
    state.start = grip.start;
  }

  Friction<Boundary, Projection> friction_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
