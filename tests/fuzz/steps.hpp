// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fuzz/motion.hpp"
#include "tests/fuzz/step_check.hpp"

#include <cmath>
#include <optional>

namespace limitcurve::fuzz {

inline bool same(const godobject::FingerOutput& one, const godobject::FingerOutput& other) {
  return one.state == other.state && one.proxy == other.proxy && one.force == other.force &&
         same(one.angle, other.angle) && same(one.depth, other.depth) && same(one.load, other.load) &&
         same(one.moment, other.moment) && same(one.cor, other.cor) && same(one.slip_work, other.slip_work);
}

/// Makes the finger that the input begins with, if its parameters are accepted, and the steps that the rest of it
/// stands for: `see(finger, sample, check)` for each, until one fails.
template <class See>
void run_steps(Bytes& bytes, See&& see) {
  const auto& choice = any_curve<double>(bytes);
  const godobject::FingerParameters parameters = any_parameters(bytes);
  std::optional<godobject::SoftFinger> made;
  if (complaint_of([&] { made.emplace(choice.curve, parameters, choice.projection); })) return;
  godobject::SoftFinger& finger = *made;
  Motion motion(bytes);
  test::StepCheck check;
  while (bytes.left() > 0 && check.fault.empty()) {
    const Sample sample = motion.next();
    const godobject::Contact& contact = sample.contact;
    const godobject::FingerState before = finger.state();
    const godobject::FingerOutput preview = finger.preview(contact, sample.twist, sample.time_step);
    finger.update(contact, sample.twist, sample.time_step);
    check = test::check_step(finger, before);
    const double squares = contact.point.squaredNorm() + contact.depth * contact.depth + sample.twist * sample.twist;
    const bool usable = squares <= 1e12 && std::fabs(contact.normal.norm() - 1.0) <= 1e-2 * (1.0 + 1e-9);
    const bool is_absent = contact.depth <= 0.0 && std::isfinite(contact.depth) && contact.normal.squaredNorm() == 0.0;
    const auto unusable_state = is_absent ? godobject::ContactState::free : godobject::ContactState::invalid;
    if (!usable && finger.output().state != unusable_state) check.fault = "unusable input is used";
    if (!same(preview, finger.output())) check.fault = "a preview shows another step";
    if (!(finger.margin() >= 0.0 && finger.margin() <= 1.0)) check.fault = "a margin outside 0 to 1";
    if (!(finger.load_to_hold() >= 0.0)) check.fault = "a load to hold below 0 or NaN";
    see(finger, sample, check);
  }
}

}  // namespace limitcurve::fuzz
