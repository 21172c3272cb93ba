// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

/// From the device to a sample: the contact query, the check for faults, and the unwrapping of the twist.
namespace limitcurve::godobject {

/// What the device gives in a step.
struct StepInput {
  Contact contact;
  double twist;                     ///< α_s [rad] about the normal, as it was given
  double time_step;                 ///< [s]
  Spin spin;                        ///< of the device's orientation
  Fault fault = Fault::none;        ///< of the device's pose; then there is no contact
  bool may_begin = true;            ///< whether a slip of what rests begins: falls to the sliding limit
  std::optional<double> load = {};  ///< P [N] where a physics engine gives it: then there is no depth
  bool has_orientation = false;     ///< otherwise it has a twist only, and `spin` is that of the last orientation

  [[nodiscard]] bool touches() const noexcept { return load ? *load > 0.0 : contact.depth > 0.0; }
  /// Whether it says that there is no contact: a load ≤ 0, or a depth ≤ 0 without a normal. It then needs no place.
  [[nodiscard]] bool is_absent() const noexcept {
    const double pressed = load ? *load : contact.depth;
    return pressed <= 0.0 && std::isfinite(pressed) && (load || contact.normal.squaredNorm() == 0.0);
  }
  /// As `FingerOutput::depth` shows it [m].
  [[nodiscard]] double depth() const noexcept {
    return load ? std::numeric_limits<double>::quiet_NaN() : contact.depth;
  }
};

/// The contact of a device's pose, and its spin. If the pose is none, `fault` names the reason, and the contact is not
/// plausible; the surface is not called, because it requires a finite position.
[[nodiscard]] inline StepInput sense(const AnySurface& surface, const DevicePose& device, double time_step,
                                     const FingerState& last, bool may_begin = true) noexcept {
  Orientation orientation = device.orientation;
  const bool is_turn = make_unit(orientation);
  if (!is_plausible<double>(device.position.squaredNorm()) || !is_turn) {
    const bool is_finite = device.position.allFinite() && orientation.coeffs().allFinite();
    const Contact none{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN()};
    const Fault fault = !is_finite ? Fault::not_finite : is_turn ? Fault::too_far : Fault::orientation;
    return {none, device.twist, time_step, last.spin, fault, may_begin};
  }
  Contact contact = surface.contact(device.position, last.contact);
  make_unit(contact.normal);
  const Spin spin = last.spin.moved(orientation, contact.normal);
  return {contact, device.twist, time_step, spin, Fault::none, may_begin, {}, true};
}

/// The same with a contact that other code found, or of which it gives the load.
[[nodiscard]] inline StepInput sense(const Contact& contact, Orientation orientation, double time_step,
                                     const FingerState& last, std::optional<double> load = {}) noexcept {
  StepInput input{contact, 0.0, time_step, last.spin, Fault::none, true, load, true};
  make_unit(input.contact.normal);
  if (make_unit(orientation)) {
    input.spin = last.spin.moved(orientation, input.contact.normal);
  } else {
    input.contact.depth = std::numeric_limits<double>::quiet_NaN();
    input.fault = orientation.coeffs().allFinite() ? Fault::orientation : Fault::not_finite;
  }
  return input;
}

/// Whether a position [m] could be reached at `max_speed` since the last good sample, or since the refused one.
[[nodiscard]] inline bool is_in_reach(const FingerFaults& faults, const FingerSample& last,
                                      const Eigen::Vector3d& position, double elapsed, double max_speed) noexcept {
  const auto is_near = [&](const Eigen::Vector3d& from, double time) {
    const double reach = max_speed * std::max(time, 1e-3);
    return (position - from).squaredNorm() <= reach * reach;
  };
  return is_near(last.position(), elapsed) ||
         (faults.refused && is_near(faults.refused_at, elapsed - faults.refused_after));
}

/// Normalises the normal, and checks that what was sensed is plausible: finite, a direction, a time step ≥ 0, and no
/// faster than `max_speed` since the last good sample, or since the refused one. Returns what is not.
[[nodiscard]] inline Fault accept(FingerFaults& faults, StepInput& input, const FingerSample& last,
                                  double max_speed) noexcept {
  if (is_time_step(input.time_step)) faults.elapsed += input.time_step;
  const Contact& contact = input.contact;
  const double square = contact.point.squaredNorm() + contact.depth * contact.depth + input.twist * input.twist;
  const bool is_direction = make_unit(input.contact.normal);
  if (!is_plausible<double>(square) || !is_direction || !is_time_step(input.time_step)) {
    if (input.fault != Fault::none) return input.fault;
    const bool is_finite = contact.point.allFinite() && contact.normal.allFinite() && std::isfinite(contact.depth) &&
                           std::isfinite(input.twist);
    return !is_finite                      ? Fault::not_finite
           : !is_plausible<double>(square) ? Fault::too_far
           : !is_direction                 ? Fault::normal
                                           : Fault::time_step;
  }
  const Eigen::Vector3d position = contact.point - contact.normal * contact.depth;
  if (!faults.seen || contact.landed || is_in_reach(faults, last, position, faults.elapsed, max_speed)) {
    faults.refused = false;
    faults.seen = true;
    faults.elapsed = 0.0;
    return Fault::none;
  }
  faults.refused = true;
  faults.refused_at = position;
  faults.refused_after = faults.elapsed;
  return Fault::speed;
}

/// The next good sample. In a contact that continues, the twist is unwrapped; it is the device's bit for bit as long as
/// it does not wrap.
[[nodiscard]] inline FingerSample take_sample(const FingerSample& last, const StepInput& input,
                                              bool continues) noexcept {
  constexpr double turn = 2.0 * std::numbers::pi;
  const Contact& contact = input.contact;
  double unwrapped_by = 0.0;
  if (continues) {
    unwrapped_by = last.unwrapped_by;
    const double jump = input.twist - last.twist;
    if (std::fabs(jump) > std::numbers::pi) unwrapped_by -= turn * std::round(jump / turn);
  }
  return {contact.point, contact.normal, contact.depth, input.twist + unwrapped_by + input.spin.angle,
          input.twist,   unwrapped_by};
}

}  // namespace limitcurve::godobject
