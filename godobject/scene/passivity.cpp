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

/// The largest k t_i/2 + |b|/2 (√(t_i+1/t_i) + √(t_i/t_i−1)), at an end at least that of even steps.
double largest_row(double stiffness, double damping, std::span<const double> steps) noexcept {
  double result = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double step = steps[i];
    if (std::isinf(step)) continue;
    const bool has_last = i > 0 && std::isfinite(steps[i - 1]);
    const bool has_next = i + 1 < steps.size() && std::isfinite(steps[i + 1]);
    const double held =
        0.5 * ((has_last ? std::sqrt(step / steps[i - 1]) : 0.0) + (has_next ? std::sqrt(steps[i + 1] / step) : 0.0));
    result = std::max(
        result, 0.5 * stiffness * step + std::fabs(damping) * (has_last && has_next ? held : std::max(held, 1.0)));
  }
  return result;
}

/// The shortest and the longest time step.
struct Steps {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;

  explicit Steps(std::span<const double> steps) noexcept {
    for (const double step : steps) {
      shortest = std::isnan(step) ? step : std::min(shortest, step);
      if (std::isfinite(step)) longest = std::max(longest, step);
    }
  }
  /// But for the rounding of time stamps.
  [[nodiscard]] bool are_even() const noexcept { return longest <= shortest * (1.0 + 1e-6); }
};

void check(const FingerParameters& finger, std::span<const double> steps, int delay) {
  const Steps all(steps);
  if (!(all.shortest > 0.0 && all.longest > 0.0))
    throw out_of_range("sample_time", all.shortest, "s", "> 0 and finite");
  if (!(delay >= 0 && delay <= most_delay))
    throw out_of_range("delay", delay, "samples", "0 <= delay <= " + std::to_string(most_delay));
  // The constructor checks the parameters; the moment ratio does not matter.
  static_cast<void>(ContactLimits(finger, 1.0));
}

void require(std::string_view channel, std::string_view units, double stiffness, double damping,
             std::span<const double> steps, double device, int delay) {
  const double needed = device_damping_needed(stiffness, damping, steps, delay);
  if (device > needed) return;
  const Steps all(steps);
  double bearable = 0.0;
  if (device > device_damping_needed(0.0, damping, steps, delay)) {
    for (double high = stiffness; high - bearable > 1e-7 * high;) {
      const double middle = 0.5 * (bearable + high);
      (device > device_damping_needed(middle, damping, steps, delay) ? bearable : high) = middle;
    }
  }
  const auto number = [](double value) { return format_number(value, 6); };
  std::string text = "not passive: ";
  text.append(channel).append(" stiffness ").append(number(stiffness)).append(" and damping ").append(number(damping));
  if (all.are_even()) {
    text.append(" at ").append(number(all.longest)).append(" s");
  } else {
    text.append(" in steps of ").append(number(all.shortest)).append(" to ").append(number(all.longest)).append(" s");
  }
  if (delay > 0)
    text.append(" and a delay of ").append(std::to_string(delay)).append(delay == 1 ? " sample" : " samples");
  text.append(" need a device damped by more than ").append(number(needed)).append(1, ' ').append(units);
  text.append(", got ").append(number(device)).append("; expected ");
  text.append(bearable > 0.0 ? "a stiffness below " + number(bearable) : "less damping and stiffness");
  // Of even steps each needs at least |b|, however short.
  if (!all.are_even() && device > device_damping_needed(stiffness, damping, all.longest, delay)) {
    text.append(", or time steps that differ less");
  } else if (device > std::fabs(damping)) {
    text.append(bearable > 0.0 || all.are_even() ? ", or a shorter sample time"
                                                 : ", or shorter time steps that differ less");
  }
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

double device_damping_needed(double stiffness, double damping, std::span<const double> steps, int delay) noexcept {
  if (delay == 0) return largest_row(stiffness, damping, steps);
  const Steps all(steps);
  if (all.are_even()) return device_damping_needed(stiffness, damping, all.longest, delay);
  return (delay + 0.5) * stiffness * all.longest + largest_row(0.0, damping, steps);
}

DeviceDamping device_damping_needed(const FingerParameters& finger, double sample_time, int delay) {
  return device_damping_needed(finger, std::span(&sample_time, 1), delay);
}

DeviceDamping device_damping_needed(const FingerParameters& finger, std::span<const double> steps, int delay) {
  check(finger, steps, delay);
  return {device_damping_needed(finger.stiffness, finger.damping, steps, delay),
          device_damping_needed(finger.twist_stiffness, finger.twist_damping, steps, delay)};
}

void require_passive(const FingerParameters& finger, double sample_time, const DeviceDamping& device, int delay) {
  require_passive(finger, std::span(&sample_time, 1), device, delay);
}

void require_passive(const FingerParameters& finger, std::span<const double> steps, const DeviceDamping& device,
                     int delay) {
  check(finger, steps, delay);
  if (!(device.sliding >= 0.0)) throw out_of_range("damping of the device", device.sliding, "N s/m", ">= 0");
  if (!(device.twist >= 0.0)) throw out_of_range("twist damping of the device", device.twist, "N m s/rad", ">= 0");
  require("sliding", "N s/m", finger.stiffness, finger.damping, steps, device.sliding, delay);
  require("twist", "N m s/rad", finger.twist_stiffness, finger.twist_damping, steps, device.twist, delay);
}

}  // namespace limitcurve::godobject
