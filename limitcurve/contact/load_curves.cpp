// SPDX-License-Identifier: MIT
#include "limitcurve/contact/load_curves.hpp"

#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace limitcurve {

namespace detail {

namespace {

void check_finite_magnitude(std::string_view name, double value, std::string_view unit) {
  if (!(value >= 0.0 && value <= std::numeric_limits<double>::max()))
    throw out_of_range(name, value, unit, ">= 0 and finite");
}

}  // namespace

void check_load(double load) {
  check_finite_magnitude("load", load, "N");
}

void check_cor(double cor) {
  if (!(cor >= 0.0)) throw out_of_range("cor", cor, "m", ">= 0");
}

void check_limits(double mu, double load, double radius) {
  // An infinite limit times a component of 0 would be NaN.
  if (std::isfinite(mu * load) && std::isfinite(mu * load * radius)) return;
  throw std::invalid_argument("mu = " + format_number(mu) + ", load = " + format_number(load) + " N, radius = " +
                              format_number(radius) + " m: their product is out of range: expected a finite number");
}

}  // namespace detail

std::vector<SlipTwist> slip_twists(std::size_t points) {
  if (points < 2) throw std::invalid_argument("points = " + std::to_string(points) + " is out of range: expected >= 2");
  std::vector<SlipTwist> twists(points);
  const double step = 0.5 * std::numbers::pi / static_cast<double>(points - 1);
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = step * static_cast<double>(i);
    twists[i] = {std::sin(angle), std::cos(angle)};
  }
  // The cosine of a rounded right angle is not quite 0.
  twists.back() = {1.0, 0.0};
  return twists;
}

double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load) {
  detail::check_finite_magnitude("mu", mu, "1");
  detail::check_load(load);
  if (!(moment_ratio >= 0.0 && moment_ratio <= std::numeric_limits<double>::max())) {
    throw out_of_range("moment_ratio", moment_ratio, "1", ">= 0 and finite");
  }
  const double radius = detail::radius_at(radius_law, load);
  detail::check_limits(mu, load, radius);
  return moment_ratio * mu * load * radius;
}

}  // namespace limitcurve
