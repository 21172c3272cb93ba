// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch.hpp"
#include "godobject/contact_limits.hpp"
#include "godobject/kernel/single.hpp"

#include <cstddef>

namespace limitcurve::godobject::kernel {

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
  const Number x = read(contacts.x);
  const Number y = read(contacts.y);
  const Number angle = read(contacts.angle);
  const Number depth = read(contacts.depth);
  const Number farthest = Number(BasicContactBatch<Real>::farthest);
  const auto is_plausible = abs(x) <= farthest && abs(y) <= farthest && abs(angle) <= farthest && !(depth > farthest);
  const auto touches = is_plausible && depth > zero;
  const auto was_in_contact = !has_state(contacts.state.data() + i, ContactState::free, zero);
  const auto stays = touches && was_in_contact;

  // a. The trial deflection; 0 at touch-down.
  const Number proxy_x = select(stays, read(contacts.proxy_x), x);
  const Number proxy_y = select(stays, read(contacts.proxy_y), y);
  const Number proxy_angle = select(stays, read(contacts.proxy_angle), angle);
  const Number trial_x = proxy_x - x;
  const Number trial_y = proxy_y - y;
  const Number twist = proxy_angle - angle;

  // b. Friction: the part of the trial deflection that the limit curve allows.
  const Number stiffness = Number(shared.stiffness);
  const Number twist_stiffness = Number(shared.twist_stiffness);
  const Number normal_load = stiffness * select(touches, depth, zero);
  const FrictionLimits<Number> limits = shared.limits.template at<Real>(normal_load, stiffness / twist_stiffness);
  const Number r = sqrt(trial_x * trial_x + trial_y * trial_y);
  const Number rho = abs(twist);
  const Number rounding = Number(std::numeric_limits<Real>::epsilon() / 2);
  // Without torsion the angle has no friction, so its rounding does not count.
  const FrictionTrial<Number> trial{stiffness * r, twist_stiffness * rho, stiffness * rounding * (abs(proxy_x) + abs(proxy_y)),
                                    limits.has_torsion ? twist_stiffness * rounding * abs(proxy_angle) : zero};
  const auto was_sliding = stays && has_state(contacts.sliding.data() + i, ContactState::slip, zero);
  auto was_turning = was_sliding;
  if (shared.curve.is_box) was_turning = stays && has_state(contacts.turning.data() + i, ContactState::slip, zero);
  FrictionMemory<Number> memory{was_sliding, was_turning, read(contacts.parameter), read(contacts.rate)};
  const FrictionResult<Number> friction = apply_friction(shared.curve, shared.projection, limits, trial, memory);
  const Number kept_x = trial_x * friction.force_ratio;
  const Number kept_y = trial_y * friction.force_ratio;
  const Number kept_twist = twist * friction.moment_ratio;

  // The proxy follows. A component without slip keeps its bits; a slip below the rounding of the position counts as stick.
  const auto slides = friction.force_ratio < Number(Real(1));
  const auto turns = friction.moment_ratio < Number(Real(1));
  const Number new_x = select(slides, x + kept_x, proxy_x);
  const Number new_y = select(slides, y + kept_y, proxy_y);
  const Number new_angle = select(turns, angle + kept_twist, proxy_angle);
  const auto slid = new_x != proxy_x || new_y != proxy_y;
  const auto turned = new_angle != proxy_angle;
  const auto slips = friction.slips && (slid || turned);

  // c. Force and moment on the user. A fault changes nothing.
  const auto write = [&](auto array, Number value) { store_where(is_plausible, array.data() + i, value); };
  write(contacts.proxy_x, new_x);
  write(contacts.proxy_y, new_y);
  write(contacts.proxy_angle, new_angle);
  write(contacts.parameter, select(slips, memory.parameter, zero));
  write(contacts.rate, select(slips, memory.rate, zero));
  write(contacts.force_x, kept_x * stiffness);
  write(contacts.force_y, kept_y * stiffness);
  write(contacts.moment, kept_twist * twist_stiffness);
  set_states(contacts.state.data() + i, is_plausible, touches, slips, zero);
  if (shared.curve.is_box) {
    set_states(contacts.sliding.data() + i, is_plausible, touches, memory.slides && (slid || was_sliding), zero);
    set_states(contacts.turning.data() + i, is_plausible, touches, memory.turns && (turned || was_turning), zero);
  } else {
    set_states(contacts.sliding.data() + i, is_plausible, touches, memory.slides && (slips || was_sliding), zero);
  }
}

}  // namespace limitcurve::godobject::kernel
