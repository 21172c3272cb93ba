// SPDX-License-Identifier: MIT
#include "limitcurve/validate/validate.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace limitcurve::detail {

namespace {

constexpr std::size_t intervals = 1024;
/// Half of the documented error of the root mean square.
constexpr double rms_tolerance = 5e-7;
/// Closer to an axis than this the ratio of the CORs is not accurate enough if the model finds its normal by a search
/// in the spin fraction.
constexpr double innermost_part = 1e-6;
constexpr double inf = std::numeric_limits<double>::infinity();

/// The slip twist whose normal has the angle ½π·`part` in the normalised plane: 0 is pure spin, 1 pure sliding. Even
/// steps of `part` give rays at nearly even angles, and each exact point follows without a search.
SlipTwist twist_at(double part, UnitWrench intercepts) {
  if (part <= 0.0) return {0.0, 1.0};
  if (part >= 1.0) return {1.0, 0.0};
  const double angle = 0.5 * std::numbers::pi * part;
  return {std::sin(angle) / intercepts.force, std::cos(angle) / intercepts.moment};
}

double part_of(std::size_t i) {
  return static_cast<double>(i) / static_cast<double>(intervals);
}

/// The largest value of `function` over [0, 1], from its values on the grid: the largest one, refined between its
/// neighbours. The position is accurate to 1e-10; so the value at a kink is accurate to about that, and at a smooth
/// maximum to rounding.
template <class Function>
double refined_maximum(const std::vector<double>& on_grid, const Function& function) {
  const auto best = std::max_element(on_grid.begin(), on_grid.end());
  if (std::isinf(*best)) return *best;
  // The variable is the offset from the best point in grid steps, because the tolerance of the search is relative to
  // its variable.
  const auto centre = static_cast<double>(best - on_grid.begin());
  constexpr double count = static_cast<double>(intervals);
  constexpr int bits = 24;
  std::uintmax_t steps = 80;
  const auto refined =
      boost::math::tools::brent_find_minima([&](double offset) { return -function((centre + offset) / count); },
                                            centre == 0.0 ? 0.0 : -1.0, centre == count ? 0.0 : 1.0, bits, steps);
  return std::max(*best, -refined.second);
}

/// The comparison of both curves on one ray.
struct Comparison {
  double part;
  double angle;
  double square;  ///< of the radial error
};

/// ∫ square d(angle) from `left` to `right` by the trapezoid rule and Richardson's extrapolation; the interval is
/// halved if the two differ by more than `allowed`, a share of the whole error for this interval of `part`, and by more
/// than `density` times its angle: where the angle turns within a minute interval (a sharply peaked pressure) the first
/// share is less than rounding. `middle` is the comparison midway.
template <class Function>
double integral(const Function& at, const Comparison& left, const Comparison& middle, const Comparison& right,
                double allowed, double density, int depth) {
  const auto trapezoid = [](const Comparison& one, const Comparison& other) {
    return 0.5 * (one.square + other.square) * std::fabs(other.angle - one.angle);
  };
  const double coarse = trapezoid(left, right);
  const double fine = trapezoid(left, middle) + trapezoid(middle, right);
  const double correction = (fine - coarse) / 3.0;
  if (std::fabs(correction) <= std::max(allowed, density * std::fabs(right.angle - left.angle)) || depth == 0)
    return fine + correction;
  const auto half = [&](const Comparison& begin, const Comparison& end) {
    return integral(at, begin, at(0.5 * (begin.part + end.part)), end, 0.5 * allowed, density, depth - 1);
  };
  return half(left, middle) + half(middle, right);
}

}  // namespace

CurveError curve_error(const CompareRay& compare, UnitWrench intercepts, double near_spin, double near_slide) {
  const auto ray_at = [&](double part) { return compare(twist_at(part, intercepts)); };
  const auto comparison = [](double part, const RayComparison& ray) {
    const double radial = ray.radius_ratio - 1.0;
    return Comparison{part, ray.angle, radial * radial};
  };
  std::vector<double> radius(intervals + 1);
  std::vector<double> inverse_radius(intervals + 1);
  // On an axis both CORs are 0, or both infinite: their ratio is left out.
  std::vector<double> cor(intervals + 1, 0.0);
  std::vector<double> inverse_cor(intervals + 1, 0.0);
  std::vector<Comparison> compared(intervals + 1);
  double roughly = 0.0;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const RayComparison ray = ray_at(part_of(i));
    radius[i] = ray.radius_ratio;
    inverse_radius[i] = 1.0 / ray.radius_ratio;
    if (i > 0 && i < intervals) {
      cor[i] = ray.cor_ratio;
      inverse_cor[i] = 1.0 / ray.cor_ratio;
    }
    compared[i] = comparison(part_of(i), ray);
    if (i > 0) roughly += compared[i].square * std::fabs(compared[i].angle - compared[i - 1].angle);
  }
  if (std::isnan(roughly)) return {inf, inf, inf, inf, inf, 0.0, inf};  // a useless model: pade_model
  CurveError error;
  error.max_over_estimate =
      std::max(0.0, refined_maximum(radius, [&](double part) { return ray_at(part).radius_ratio; }) - 1.0);
  const double least =
      1.0 / refined_maximum(inverse_radius, [&](double part) { return 1.0 / ray_at(part).radius_ratio; });
  error.max_under_estimate = std::max(0.0, 1.0 - least);
  error.max_error = std::max(error.max_over_estimate, error.max_under_estimate);

  const double span = std::fabs(compared.back().angle - compared.front().angle);
  // The error of a root is the error of its square divided by twice the root.
  const double mean_error = rms_tolerance * std::max(std::sqrt(roughly / span), rms_tolerance);
  constexpr int most_halvings = 24;
  double squares = 0.0;
  for (std::size_t i = 0; i + 2 <= intervals; i += 2) {
    squares += integral([&](double part) { return comparison(part, ray_at(part)); }, compared[i], compared[i + 1],
                        compared[i + 2], mean_error * span / intervals, 0.1 * mean_error, most_halvings);
  }
  error.rms_error = std::sqrt(std::max(squares, 0.0) / span);

  // Between the outermost rays and the axes the ratio may still have an extremum: a pressure may have a small peak at
  // its centre.
  error.max_cor_ratio = std::max(near_spin, near_slide);
  error.min_cor_ratio = std::min(near_spin, near_slide);
  for (double part = 0.5 * part_of(1); part > innermost_part; part *= 0.5) {
    for (const double ratio : {ray_at(part).cor_ratio, ray_at(1.0 - part).cor_ratio}) {
      error.max_cor_ratio = std::max(error.max_cor_ratio, ratio);
      error.min_cor_ratio = std::min(error.min_cor_ratio, ratio);
    }
  }
  const auto cor_ratio = [&](double part) {
    return ray_at(std::clamp(part, part_of(1), part_of(intervals - 1))).cor_ratio;
  };
  error.max_cor_ratio = std::max(error.max_cor_ratio, refined_maximum(cor, cor_ratio));
  error.min_cor_ratio = std::min(
      error.min_cor_ratio, 1.0 / refined_maximum(inverse_cor, [&](double part) { return 1.0 / cor_ratio(part); }));
  error.max_cor_error = std::max(std::fabs(error.max_cor_ratio - 1.0), std::fabs(error.min_cor_ratio - 1.0));
  return error;
}

Ellipse inner_ellipse(const WrenchOfTwist& exact, UnitWrench intercepts) {
  // With α, β the inverse squares of the semi-axes in the normalised plane, the square of exact
  // radius/model radius is αx² + βy². The best ellipse has the least ratio of its largest to its
  // smallest value, a quotient of a convex and a concave function of the shape: there is one
  // minimum. Its size makes the smallest value 1.
  const auto square_at = [&](double part, double spin_share) {
    const UnitWrench wrench = exact(twist_at(part, intercepts));
    const double x = wrench.force / intercepts.force;
    const double y = wrench.moment / intercepts.moment;
    return (1.0 - spin_share) * x * x + spin_share * y * y;
  };
  std::vector<std::pair<double, double>> squares(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i) squares[i] = {square_at(part_of(i), 0.0), square_at(part_of(i), 1.0)};
  const auto square_of = [](const std::pair<double, double>& xy, double spin_share) {
    return std::lerp(xy.first, xy.second, spin_share);
  };
  const auto spread = [&](double spin_share) {
    double least = inf;
    double largest = 0.0;
    for (const auto& xy : squares) {
      const double square = square_of(xy, spin_share);
      least = std::min(least, square);
      largest = std::max(largest, square);
    }
    return least > 0.0 ? largest / least : inf;
  };
  constexpr int bits = 40;
  const double spin_share = boost::math::tools::brent_find_minima(spread, 0.0, 1.0, bits).first;
  std::vector<double> inverse(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i) inverse[i] = 1.0 / square_of(squares[i], spin_share);
  const double size = 1.0 / refined_maximum(inverse, [&](double part) { return 1.0 / square_at(part, spin_share); });
  return {intercepts.force * std::sqrt(size / (1.0 - spin_share)), intercepts.moment * std::sqrt(size / spin_share)};
}

}  // namespace limitcurve::detail
