// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch/batch.hpp"
#include "godobject/contact_limits.hpp"
#include "limitcurve/kernel/instruction_set.hpp"

#include <array>
#include <concepts>
#include <cstddef>

namespace limitcurve::godobject::kernel {

using namespace limitcurve::kernel;

// Reading and writing arrays, for a single number. pack.hpp has the same functions for packs; the last argument, which
// is not used, has the type of the number or pack.

template <std::floating_point Number>
[[nodiscard]] Number load(const Number* from, Number) noexcept {
  return *from;
}
template <std::floating_point Number>
void store_where(bool condition, Number* to, Number value) noexcept {
  if (condition) *to = value;
}
template <class State, std::floating_point Number>
[[nodiscard]] bool has_state(const State* states, State wanted, Number) noexcept {
  return *states == wanted;
}
template <class State, std::floating_point Number>
void set_states_where(bool where, State* states, bool first, bool second, const std::array<State, 3>& values,
                      Number) noexcept {
  if (where) *states = !first ? values[0] : !second ? values[1] : values[2];
}

/// Data that all contacts of a batch share.
template <class Real>
struct Shared {
  const CurveView<Real>& curve;
  Projection projection;
  const ContactLimits& limits;
  Real stiffness;
  Real twist_stiffness;
};

/// Steps as many contacts as a Number has lanes, from index `i` on. Written once for a single number and for packs.
template <class Real, class Number>
void step_contacts(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts, std::size_t i) noexcept {
  using namespace arithmetic;
  const Number zero = Number(Real(0));
  const auto read = [i, zero](auto array) { return load(array.data() + i, zero); };
  const auto is_at = [i, zero](auto states, ContactState wanted) { return has_state(states.data() + i, wanted, zero); };
  Number x = read(contacts.x);
  Number y = read(contacts.y);
  Number goal_angle = read(contacts.twist);
  Number depth = read(contacts.depth);
  const auto is_usable = is_plausible<Real>(x * x + y * y + depth * depth + goal_angle * goal_angle);
  if (any(!is_usable)) {
    // What is not usable is stepped at 0, so that no NaN enters friction, and not written.
    for (Number* const number : {&x, &y, &goal_angle, &depth}) *number = select(is_usable, *number, zero);
  }
  const auto touches = is_usable && depth > zero;
  auto was_in_contact = !is_at(contacts.state, ContactState::free);
  // After a fault the memory knows.
  if (const auto was_fault = is_at(contacts.state, ContactState::invalid); any(was_fault)) {
    was_in_contact = was_in_contact && !(was_fault && is_at(contacts.force_slides, ContactState::free));
  }
  const auto stays = touches && was_in_contact;

  // a. The trial deflection; 0 at touch-down.
  const Number proxy_x = select(stays, read(contacts.proxy_x), x);
  const Number proxy_y = select(stays, read(contacts.proxy_y), y);
  const Number proxy_angle = select(stays, read(contacts.proxy_angle), goal_angle);
  const Number trial_x = proxy_x - x;
  const Number trial_y = proxy_y - y;
  const Number twist = proxy_angle - goal_angle;

  // b. Friction: the part of the trial deflection that the limit curve allows.
  const Number stiffness = Number(shared.stiffness);
  const Number twist_stiffness = Number(shared.twist_stiffness);
  const Number normal_load = stiffness * select(touches, depth, zero);
  const FrictionLimits<Number> limits = shared.limits.template at<Real>(normal_load, stiffness / twist_stiffness);
  const Number r = sqrt(trial_x * trial_x + trial_y * trial_y);
  const Number rho = abs(twist);
  // A proxy farther than two samples can be, or NaN, is memory that the caller never wrote: a fault until the contact
  // ends.
  const auto is_known = is_usable && r + rho <= Number(static_cast<Real>(4.0 * farthest));
  const Number rounding = Number(std::numeric_limits<Real>::epsilon() / 2);
  // Without torsion the angle has no friction, so its rounding does not matter.
  const FrictionTrial<Number> trial{stiffness * r, twist_stiffness * rho,
                                    stiffness * rounding * (abs(proxy_x) + abs(proxy_y)),
                                    limits.has_torsion ? twist_stiffness * rounding * abs(proxy_angle) : zero};
  const auto was_sliding = stays && is_at(contacts.force_slides, ContactState::slip);
  auto was_turning = was_sliding;
  if (shared.curve.is_box) was_turning = stays && is_at(contacts.moment_slides, ContactState::slip);
  const FrictionMemory<Number> before{was_sliding, was_turning, read(contacts.search_start),
                                      read(contacts.search_rate)};
  FrictionMemory<Number> memory = before;
  const FrictionResult<Number> friction = apply_friction(shared.curve, shared.projection, limits, trial, memory);
  const Number kept_x = trial_x * friction.force_fraction;
  const Number kept_y = trial_y * friction.force_fraction;
  const Number kept_twist = twist * friction.moment_fraction;

  // The proxy follows. A component without slip keeps its bits; a slip below the rounding of the position counts as
  // stick.
  const auto force_slides = friction.force_fraction < Number(Real(1));
  const auto moment_slides = friction.moment_fraction < Number(Real(1));
  const Number new_x = select(force_slides, x + kept_x, proxy_x);
  const Number new_y = select(force_slides, y + kept_y, proxy_y);
  const Number new_angle = select(moment_slides, goal_angle + kept_twist, proxy_angle);
  const auto slid = new_x != proxy_x || new_y != proxy_y;
  const auto turned = new_angle != proxy_angle;
  const auto slips = friction.slips && (slid || turned);
  memory = settled(before, memory, shared.curve.is_box, slips, slid, turned);

  // c. Force and moment on the user. A fault changes nothing but the state.
  const auto write = [&](auto array, Number value) { store_where(is_known, array.data() + i, value); };
  write(contacts.proxy_x, new_x);
  write(contacts.proxy_y, new_y);
  write(contacts.proxy_angle, new_angle);
  write(contacts.search_start, memory.search_start);
  write(contacts.search_rate, memory.search_rate);
  write(contacts.fx, kept_x * stiffness);
  write(contacts.fy, kept_y * stiffness);
  write(contacts.moment, kept_twist * twist_stiffness);
  using States = std::array<ContactState, 3>;
  constexpr States states{ContactState::free, ContactState::stick, ContactState::slip};
  set_states_where(is_known, contacts.state.data() + i, touches, slips, states, zero);
  set_states_where(is_known, contacts.force_slides.data() + i, touches, memory.force_slides, states, zero);
  if (shared.curve.is_box)
    set_states_where(is_known, contacts.moment_slides.data() + i, touches, memory.moment_slides, states, zero);
  if (any(!is_known)) {
    constexpr States invalid{ContactState::invalid, ContactState::invalid, ContactState::invalid};
    set_states_where(!is_known, contacts.state.data() + i, touches, slips, invalid, zero);
  }
}

/// Steps all contacts: those that fill packs with the set, which must be supported, the others with single numbers. All
/// sets give the same bits.
template <class Real>
void step_with(InstructionSet set, const Shared<Real>& shared, const BasicContactBatch<Real>& contacts) noexcept;

/// Steps the first contacts, as many as fill packs, and returns their number. Each instruction set has its own source
/// file.
template <class Isa, class Real>
std::size_t step_packs(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts, std::size_t count) noexcept;

}  // namespace limitcurve::godobject::kernel
