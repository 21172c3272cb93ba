// SPDX-License-Identifier: MIT
#include "godobject/scene/passivity.hpp"

#include "godobject/contact_limits.hpp"
#include "limitcurve/internal/number.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

void require(std::string_view channel, std::string_view units, double stiffness, double damping, double sample_time, double device) {
  const double needed = device_damping_needed(stiffness, damping, sample_time);
  if (device > needed) return;
  const double bearable = 2.0 * (device - damping) / sample_time;
  std::string text = "not passive: ";
  text.append(channel).append(" stiffness ").append(format_number(stiffness)).append(" and damping ").append(format_number(damping));
  text.append(" at ").append(format_number(sample_time)).append(" s need a device damped by more than ").append(format_number(needed));
  text.append(1, ' ').append(units).append(", got ").append(format_number(device)).append("; expected ");
  text.append(bearable > 0.0 ? "a stiffness below " + format_number(bearable) : "less damping and stiffness")
      .append(", or a shorter sample time");
  throw std::invalid_argument(text);
}

}  // namespace

DeviceDamping device_damping_needed(const FingerParameters& finger, double sample_time) {
  if (!(sample_time > 0.0 && sample_time <= largest)) throw out_of_range("sample_time", sample_time, "s", "> 0 and finite");
  // The constructor checks the parameters; the moment ratio does not matter.
  static_cast<void>(ContactLimits(finger, 1.0));
  return {device_damping_needed(finger.stiffness, finger.damping, sample_time),
          device_damping_needed(finger.twist_stiffness, finger.twist_damping, sample_time)};
}

void require_passive(const FingerParameters& finger, double sample_time, const DeviceDamping& device) {
  static_cast<void>(device_damping_needed(finger, sample_time));
  if (!(device.sliding >= 0.0)) throw out_of_range("damping of the device", device.sliding, "N s/m", ">= 0");
  if (!(device.twist >= 0.0)) throw out_of_range("twist damping of the device", device.twist, "N m s/rad", ">= 0");
  require("sliding", "N s/m", finger.stiffness, finger.damping, sample_time, device.sliding);
  require("twist", "N m s/rad", finger.twist_stiffness, finger.twist_damping, sample_time, device.twist);
}

}  // namespace limitcurve::godobject
