// SPDX-License-Identifier: MIT
#include "fit/internal/chebyshev_curve.hpp"

#include "limitcurve/laws.hpp"

#include <algorithm>
#include <numbers>

namespace limitcurve::fit::internal {

namespace {

using std::numbers::pi;
constexpr std::size_t terms = ChebyshevCurve::terms;

/// Node i of count Chebyshev nodes of the first kind, in (−1, 1).
double node(std::size_t i, std::size_t count) {
  return std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
}

/// Weight of sample i in coefficient j of count.
double analysis(std::size_t i, std::size_t j, std::size_t count) {
  const auto n = static_cast<double>(count);
  return (j == 0 ? 1.0 : 2.0) / n * std::cos(pi * static_cast<double>(j) * (static_cast<double>(i) + 0.5) / n);
}

/// The position on one side of the rim, q = min(s, 1/s) ∈ [0, 1], as w ∈ [0, 1] with q = 1 − (1 − w²)⁴. The curve's
/// singularities, (1−q)^{n+2} at the rim and q^{k+1} at the centre, become high powers of w, so that the Chebyshev
/// series converges fast.
double place_of(double q) noexcept {
  return std::sqrt(1.0 - std::sqrt(std::sqrt(1.0 - q)));
}
double ratio_of(double w) noexcept {
  const double square = (1.0 - w * w) * (1.0 - w * w);
  return 1.0 - square * square;
}

/// Chebyshev series from samples of a law's curve at the nodes on both sides of s = split.
std::array<ChebyshevCurve::Series, 2> analyse(const PressureLaw& law, double moment_ratio, double split) {
  std::array<ChebyshevCurve::Series, 2> samples{};
  for (std::size_t i = 0; i < terms; ++i) {
    const double q = ratio_of(0.5 * (1.0 + node(i, terms)));
    for (std::size_t side = 0; side < 2; ++side) {
      const UnitForces<double> forces = law.forces(side == 0 ? split * q : split / q);
      samples[side][i] = {forces.force, forces.moment / moment_ratio};
    }
  }
  std::array<ChebyshevCurve::Series, 2> series{};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t j = 0; j < terms; ++j) {
      for (std::size_t i = 0; i < terms; ++i) {
        const double weight = analysis(i, j, terms);
        series[side][j] += samples[side][i] * weight;
      }
    }
  }
  return series;
}

/// The size of the last coefficients: about the error of the series.
double tail_of(const std::array<ChebyshevCurve::Series, 2>& sides) {
  double sum = 0.0;
  for (const ChebyshevCurve::Series& series : sides) {
    for (std::size_t j = terms - 4; j < terms; ++j) sum += std::fabs(series[j].x) + std::fabs(series[j].y);
  }
  return sum;
}

}  // namespace

ChebyshevCurve::ChebyshevCurve(const PressureLaw& law) : moment_ratio_(law.moment_ratio()) {
  // A law without a rim has no singularity to split at. 2.7 m₀ is best for the Gaussian and for any law whose pressure
  // vanishes long before the rim: the last coefficients show which split is better.
  const double faded = 2.7 * moment_ratio_;
  const bool has_rim = law.breaks().back() == 1;
  split_ = has_rim ? 1.0 : faded;
  value_ = analyse(law, moment_ratio_, split_);
  if (has_rim && faded < 1.0) {
    const std::array<Series, 2> other = analyse(law, moment_ratio_, faded);
    if (tail_of(other) < tail_of(value_)) {
      value_ = other;
      split_ = faded;
    }
  }
  trim();
}

void ChebyshevCurve::trim() noexcept {
  constexpr double negligible = 1e-14;
  for (std::size_t side = 0; side < 2; ++side) {
    double tail = 0.0;
    std::size_t used = terms;
    while (used > 2) {
      const PlanePoint& value = value_[side][used - 1];
      const PlanePoint& slope = slope_[side][used - 1];
      tail += std::fabs(value.x) + std::fabs(value.y) + std::fabs(slope.x) + std::fabs(slope.y);
      if (tail > negligible) break;
      --used;
    }
    used_[side] = used;
  }
}

PlanePoint ChebyshevCurve::sum(const std::array<Series, 2>& sides, double u) const noexcept {
  const double slide = 1.0 - u;
  const double spin = split_ * u;
  const bool inside = slide <= spin;
  const std::size_t side = inside ? 0 : 1;
  const Series& series = sides[side];
  const double z = 2.0 * place_of(inside ? slide / spin : spin / slide) - 1.0;
  // Clenshaw's recurrence for both components at once.
  PlanePoint first{0.0, 0.0};
  PlanePoint second{0.0, 0.0};
  for (std::size_t j = used_[side] - 1; j > 0; --j) {
    const PlanePoint next{2.0 * z * first.x - second.x + series[j].x, 2.0 * z * first.y - second.y + series[j].y};
    second = first;
    first = next;
  }
  return {z * first.x - second.x + series[0].x, z * first.y - second.y + series[0].y};
}

ShapeFamily::ShapeFamily(const std::function<Law(double)>& make, double shift, double lowest, double highest)
    : shift_(shift), low_(coordinate(lowest)), high_(coordinate(highest)) {
  for (std::size_t i = 0; i < shape_terms; ++i) {
    const Law law = make(parameter(0.5 * (low_ + high_) + 0.5 * (high_ - low_) * node(i, shape_terms)));
    const double moment_ratio = law->moment_ratio();
    const auto series = analyse(*law, moment_ratio, 1.0);
    for (std::size_t k = 0; k < shape_terms; ++k) {
      const double weight = analysis(i, k, shape_terms);
      moment_ratio_[k] += weight * moment_ratio;
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t j = 0; j < terms; ++j) {
          tensor_[k][side][j] += series[side][j] * weight;
        }
      }
    }
  }
}

const ShapeFamily& ShapeFamily::power() {
  static const ShapeFamily family([](double n) { return limitcurve::power(n); }, 1.5, -0.75, 6.0);
  return family;
}

const ShapeFamily& ShapeFamily::xydas_kao() {
  static const ShapeFamily family([](double k) { return limitcurve::xydas_kao(k); }, 0.0, 0.8, 12.0);
  return family;
}

double ShapeFamily::parameter(double coordinate) const noexcept {
  return std::exp(coordinate) - shift_;
}
double ShapeFamily::parameter_slope(double coordinate) const noexcept {
  return std::exp(coordinate);
}
double ShapeFamily::coordinate(double parameter) const noexcept {
  return std::log(parameter + shift_);
}

ChebyshevCurve ShapeFamily::member(double coordinate) const noexcept {
  const double scale = 2.0 / (high_ - low_);
  const double z = std::clamp((coordinate - 0.5 * (low_ + high_)) * scale, -1.0, 1.0);
  ChebyshevCurve curve;
  // T_k(z) and T_k′(z) by their recurrences.
  double value = 1.0;
  double next_value = z;
  double slope = 0.0;
  double next_slope = 1.0;
  for (std::size_t k = 0; k < shape_terms; ++k) {
    curve.moment_ratio_ += value * moment_ratio_[k];
    curve.moment_ratio_slope_ += scale * slope * moment_ratio_[k];
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t j = 0; j < terms; ++j) {
        const PlanePoint& coefficient = tensor_[k][side][j];
        curve.value_[side][j] += coefficient * value;
        curve.slope_[side][j] += coefficient * (scale * slope);
      }
    }
    const double after = 2.0 * z * next_value - value;
    const double slope_after = 2.0 * next_value + 2.0 * z * next_slope - slope;
    value = next_value;
    next_value = after;
    slope = next_slope;
    next_slope = slope_after;
  }
  curve.trim();
  return curve;
}

}  // namespace limitcurve::fit::internal
