// SPDX-License-Identifier: MIT
#include "limitcurve/patch/line_profile.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace limitcurve::patch {

namespace {

double clenshaw(const auto& series, double x) noexcept {
  double b1 = 0.0;
  double b2 = 0.0;
  for (std::size_t i = series.size() - 1; i > 0; --i) {
    const double b = 2.0 * x * b1 - b2 + series[i];
    b2 = b1;
    b1 = b;
  }
  return x * b1 - b2 + series[0];
}

}  // namespace

LineProfile::LineProfile(Law law) : law_(std::move(law)), outer_(static_cast<double>(law_->breaks().back())) {
  // By its numbers, not its name: Hertz is also power:n=0.5, and an own law may have any name.
  const bool has_unit_disc = outer_ == 1.0 && law_->breaks().size() == 2;
  for (const std::array<double, 3>& series :
       {std::array{3.0 / 8.0, 3.0 / 4.0, -1.0 / 8.0}, std::array{0.5, 0.5, 0.0}}) {  // Hertz, flat punch
    polynomial_ = series;
    is_polynomial_ = has_unit_disc && is_its_polynomial();
    if (is_polynomial_) return;
  }
  is_smooth_ = has_unit_disc && law_->rim_exponent() >= -0.3L && law_->closed(1, Slope::unwanted).has_value();
  for (const Extended place : law_->breaks()) kinks_.push_back(static_cast<double>(place));
  kinks_.pop_back();
  if (kinks_.empty() || kinks_.front() > 0.0) kinks_.insert(kinks_.begin(), 0.0);
  mean_distance_ = law_->line_profile(0.0).forces.moment;
  constexpr double sharpest = 1e-4;
  if (!(mean_distance_ >= sharpest * outer_)) {
    throw std::invalid_argument("law " + law_->name() + ": its mean distance from a diameter is " +
                                format_number(mean_distance_ / outer_) +
                                " of its radius, too sharp for an ellipse, expected >= 1e-4 (xydas-kao: k >= 0.05)");
  }
  // Where the slope is far from proportional to t, a sharp part of the pressure is narrower than t: divide there as if
  // it had kinks.
  const auto rise = [&](double t) { return law_->line_profile(t).forces.force / t; };
  for (double place = 0.25 * outer_; place > 1e-12 * outer_; place *= 0.25) {
    if (rise(0.25 * place) > 1.5 * rise(place)) kinks_.push_back(place);
  }
  std::sort(kinks_.begin(), kinks_.end());
  // The law's own error (samples): take the largest that the wrench of a round contact has.
  for (const double s : {0.0, 0.25, 0.5, 1.0, 2.0}) {
    const WrenchEstimate estimate = law_->evaluate(s);
    error_ = std::max({error_, estimate.error.force, estimate.error.moment / law_->moment_ratio()});
  }
  constexpr double rounding = 1e-14;
  tabulate(std::max(rounding, 0.01 * error_));
}

bool LineProfile::is_its_polynomial() const noexcept {
  constexpr int places = 16;
  constexpr double rounding = 1e-13;
  for (int i = 0; i < places; ++i) {
    const double t = static_cast<double>(i) / places;
    const UnitForces<double> exact = law_->line_profile(t).forces;
    const Value value = at_polynomial(t);
    if (!(std::fabs(exact.force - value.slope) <= rounding && std::fabs(exact.moment - value.remainder) <= rounding))
      return false;
  }
  return law_->profile_error() == 0.0;
}

void LineProfile::tabulate(double tolerance) {
  double left = 0.0;
  for (std::size_t i = 0; i < kinks_.size(); ++i)
    left = std::max(left, add_cells(kinks_[i], i + 1 < kinks_.size() ? kinks_[i + 1] : outer_, tolerance, 1.0));
  error_ += 4.0 * std::max(tolerance, left);
}

double LineProfile::add_cells(double begin, double end, double tolerance, double before) {
  double rounding = 0.0;
  const auto exact = [&](double t) -> Value {
    const auto [forces, error] = law_->line_profile(t);
    rounding = std::max({rounding, error.force, error.moment / mean_distance_});
    return {forces.force, forces.moment};
  };
  Cell cell{begin, 0.5 * (end - begin), {}, {}};
  std::array<Value, order> values;
  for (std::size_t j = 0; j < order; ++j) {
    const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(order);
    values[j] = exact(begin + cell.half * (1.0 + std::cos(angle)));
  }
  for (std::size_t k = 0; k < order; ++k) {
    for (std::size_t j = 0; j < order; ++j) {
      const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(order);
      const double weight =
          (k == 0 ? 1.0 : 2.0) / static_cast<double>(order) * std::cos(static_cast<double>(k) * angle);
      cell.slope[k] += weight * values[j].slope;
      cell.remainder[k] += weight * values[j].remainder;
    }
  }
  // A polynomial is worst next to the ends, where singularities are: check there.
  double off = 0.0;
  for (const double x : {-0.999, -0.4, 0.6, 0.999}) {
    const double t = begin + cell.half * (1.0 + x);
    const Value true_value = exact(t);
    const Value value = at(cell, t);
    off = std::max({off, std::fabs(value.slope - true_value.slope),
                    std::fabs(value.remainder - true_value.remainder) / mean_distance_});
  }
  // Halving does not help below the rounding error of the integrals, nor where places are no longer resolved.
  const double narrowest = std::max(1e-11 * begin, 1e-15 * mean_distance_);
  constexpr double small = 1e-9;
  const bool rounded = (off < small && off > 0.7 * before) || off < 2.0 * rounding;
  if (off <= tolerance || rounded || cell.half < narrowest) {
    cells_.push_back(cell);
    return off;
  }
  const double middle = begin + cell.half;
  const double left = add_cells(begin, middle, tolerance, off);
  return std::max(left, add_cells(middle, end, tolerance, off));
}

LineProfile::Value LineProfile::at(const Cell& cell, double t) noexcept {
  const double x = std::clamp((t - cell.begin) / cell.half - 1.0, -1.0, 1.0);
  return {clenshaw(cell.slope, x), clenshaw(cell.remainder, x)};
}

LineProfile::Value LineProfile::at_polynomial(double t) const noexcept {
  const double square = std::min(std::fabs(t), 1.0) * std::min(std::fabs(t), 1.0);
  const auto& [g0, g2, g4] = polynomial_;
  return {std::clamp(t, -1.0, 1.0) * (2.0 * g2 + 4.0 * g4 * square), g0 - g2 * square - 3.0 * g4 * square * square};
}

LineProfile::Value LineProfile::operator()(double t) const noexcept {
  const double place = std::fabs(t);
  if (is_polynomial_) return at_polynomial(t);
  if (!(place < outer_)) return {std::copysign(1.0, t), 0.0};
  const auto after = std::upper_bound(cells_.begin() + 1, cells_.end(), place,
                                      [](double p, const Cell& cell) { return p < cell.begin; });
  const Value value = at(*(after - 1), place);
  return {place > 0.0 ? std::copysign(value.slope, t) : 0.0, value.remainder};
}

}  // namespace limitcurve::patch
