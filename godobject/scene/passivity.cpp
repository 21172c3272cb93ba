// SPDX-License-Identifier: MIT
#include "godobject/scene/passivity.hpp"

#include "godobject/contact_limits.hpp"
#include "limitcurve/internal/number.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

namespace {

constexpr double largest = std::numeric_limits<double>::max();

void require(std::string_view channel, std::string_view units, double stiffness, double damping, double sample_time,
             double device, int delay) {
  const double needed = device_damping_needed(stiffness, damping, sample_time, delay);
  if (device > needed) return;
  const double bearable = (device - std::fabs(damping)) / ((delay + 0.5) * sample_time);
  const auto number = [](double value) { return format_number(value, 6); };
  std::string text = "not passive: ";
  text.append(channel).append(" stiffness ").append(number(stiffness)).append(" and damping ").append(number(damping));
  text.append(" at ").append(number(sample_time)).append(" s");
  if (delay > 0)
    text.append(" and a delay of ").append(std::to_string(delay)).append(delay == 1 ? " sample" : " samples");
  text.append(" need a device damped by more than ").append(number(needed)).append(1, ' ').append(units);
  text.append(", got ").append(number(device)).append("; expected ");
  text.append(bearable > 0.0 ? "a stiffness below " + number(bearable) : "less damping and stiffness")
      .append(", or a shorter sample time");
  throw std::invalid_argument(text);
}

}  // namespace

double device_damping_needed(double stiffness, double damping, double sample_time, int delay) noexcept {
  const double most = (delay + 0.5) * stiffness * sample_time + std::fabs(damping);
  // Spring and damper have their maxima at one θ: at π without delay, at 0 with a damper < 0.
  if (delay == 0 || damping <= 0.0) return most;
  const auto negative = [&](double theta) {
    const double swing = theta > 0.0 ? std::sin((delay + 0.5) * theta) / std::sin(0.5 * theta) : 2.0 * delay + 1.0;
    return damping * std::cos((delay + 1) * theta) - 0.5 * stiffness * sample_time * swing;
  };
  // A cosine polynomial of degree N + 1: between two of these places it has one extremum at most, which a parabola
  // nearly is.
  const double step = std::numbers::pi / (32 * (delay + 1));
  double result = -negative(0.0);
  for (int i = 1; i <= 32 * (delay + 1); ++i) {
    const double before = negative((i - 1) * step);
    const double here = negative(i * step);
    const double after = negative((i + 1) * step);
    if (here > before || here > after) continue;
    result =
        std::max(result, -boost::math::tools::brent_find_minima(negative, (i - 1) * step, (i + 1) * step, 40).second);
  }
  return std::min(result, most);
}

DeviceDamping device_damping_needed(const FingerParameters& finger, double sample_time, int delay) {
  if (!(sample_time > 0.0 && sample_time <= largest))
    throw out_of_range("sample_time", sample_time, "s", "> 0 and finite");
  if (!(delay >= 0 && delay <= most_delay))
    throw out_of_range("delay", delay, "samples", "0 <= delay <= " + std::to_string(most_delay));
  // The constructor checks the parameters; the moment ratio does not matter.
  static_cast<void>(ContactLimits(finger, 1.0));
  return {device_damping_needed(finger.stiffness, finger.damping, sample_time, delay),
          device_damping_needed(finger.twist_stiffness, finger.twist_damping, sample_time, delay)};
}

void require_passive(const FingerParameters& finger, double sample_time, const DeviceDamping& device, int delay) {
  static_cast<void>(device_damping_needed(finger, sample_time, delay));
  if (!(device.sliding >= 0.0)) throw out_of_range("damping of the device", device.sliding, "N s/m", ">= 0");
  if (!(device.twist >= 0.0)) throw out_of_range("twist damping of the device", device.twist, "N m s/rad", ">= 0");
  require("sliding", "N s/m", finger.stiffness, finger.damping, sample_time, device.sliding, delay);
  require("twist", "N m s/rad", finger.twist_stiffness, finger.twist_damping, sample_time, device.twist, delay);
}

}  // namespace limitcurve::godobject
