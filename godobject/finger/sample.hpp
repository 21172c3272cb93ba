// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/surface.hpp"

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

  [[nodiscard]] bool touches() const noexcept { return load ? *load > 0.0 : contact.depth > 0.0; }
  /// As `FingerOutput::depth` shows it [m].
  [[nodiscard]] double depth() const noexcept {
    return load ? std::numeric_limits<double>::quiet_NaN() : contact.depth;
  }
};

/// Whether a vector or a quaternion is of unit length; a NaN is not.
template <class Vector>
[[nodiscard]] bool is_unit(const Vector& vector) noexcept {
  return std::fabs(vector.squaredNorm() - 1.0) <= 1e-6;
}

/// The contact of a device's pose, and its spin. If the pose is none, `fault` names the reason, and the contact is not
/// plausible; the surface is not called, because it requires a finite position.
[[nodiscard]] inline StepInput sense(const AnySurface& surface, const DevicePose& device, double time_step,
                                     const FingerState& last, bool may_begin = true) noexcept {
  if (!is_plausible<double>(device.position.squaredNorm()) || !is_unit(device.orientation)) {
    const bool is_finite = device.position.allFinite() && device.orientation.coeffs().allFinite();
    const Contact none{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN()};
    const Fault fault = !is_finite                    ? Fault::not_finite
                        : is_unit(device.orientation) ? Fault::too_far
                                                      : Fault::orientation;
    return {none, device.twist, time_step, last.spin, fault, may_begin};
  }
  const Contact contact = surface.contact(device.position, last.contact);
  return {contact,     device.twist, time_step, last.spin.moved(device.orientation, contact.normal),
          Fault::none, may_begin};
}

/// The same with a contact that other code found, or of which it gives the load.
[[nodiscard]] inline StepInput sense(const Contact& contact, const Orientation& orientation, double time_step,
                                     const FingerState& last, std::optional<double> load = {}) noexcept {
  StepInput input{contact, 0.0, time_step, last.spin, Fault::none, true, load};
  if (is_unit(orientation)) {
    input.spin = last.spin.moved(orientation, contact.normal);
  } else {
    input.contact.depth = std::numeric_limits<double>::quiet_NaN();
    input.fault = orientation.coeffs().allFinite() ? Fault::orientation : Fault::not_finite;
  }
  return input;
}

/// Checks that what was sensed is plausible: finite, a normal of unit length, a time step ≥ 0, and within
/// `max_displacement` of the last good position, or of the last refused one. Returns what is not.
[[nodiscard]] inline Fault accept(FingerFaults& faults, const StepInput& input, const FingerSample& last,
                                  double max_displacement) noexcept {
  const Contact& contact = input.contact;
  const double square = contact.point.squaredNorm() + contact.depth * contact.depth + input.twist * input.twist;
  if (!is_plausible<double>(square) || !is_unit(contact.normal) || !is_time_step(input.time_step)) {
    if (input.fault != Fault::none) return input.fault;
    const bool is_finite = contact.point.allFinite() && contact.normal.allFinite() && std::isfinite(contact.depth) &&
                           std::isfinite(input.twist);
    return !is_finite                      ? Fault::not_finite
           : !is_plausible<double>(square) ? Fault::too_far
           : !is_unit(contact.normal)      ? Fault::normal
                                           : Fault::time_step;
  }
  const Eigen::Vector3d position = contact.point - contact.normal * contact.depth;
  const double limit = max_displacement * max_displacement;
  if (!faults.seen || (position - last.position()).squaredNorm() <= limit) {
    faults.refused = false;
    faults.seen = true;
    return Fault::none;
  }
  const bool is_there_again = faults.refused && (position - faults.refused_at).squaredNorm() <= limit;
  faults.refused = !is_there_again;
  faults.refused_at = position;
  return is_there_again ? Fault::none : Fault::displacement;
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
