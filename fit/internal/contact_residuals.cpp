// SPDX-License-Identifier: MIT
#include "fit/internal/contact_residuals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::fit::internal {

ContactResiduals::ContactResiduals(std::span<const WeightedSample> samples, UnitCurve& curve, ContactLayout layout)
    : samples_(samples), curve_(curve), layout_(layout), last_(samples.size(), -1.0), drift_(samples.size(), 0.0) {}

/// The t where (sample − q)·q′ changes sign, from ≥ 0 at the slide's end to ≤ 0 at the twist's: secant steps within a bracket.
/// The distance is stationary there, so an error of 1e-9 in t changes it by 1e-18.
double ContactResiduals::closest(PlanePoint sample, PlanePoint scale, double start) const noexcept {
  const auto slope_at = [&](double t) {
    const UnitCurve::Place place = curve_.at(t);
    const double tangent_x = scale.x * place.tangent.x;
    const double tangent_y = scale.y * place.tangent.y;
    const double length = std::sqrt(tangent_x * tangent_x + tangent_y * tangent_y);
    return ((sample.x - scale.x * place.point.x) * tangent_x + (sample.y - scale.y * place.point.y) * tangent_y) / length;
  };
  constexpr int step_limit = 60;
  constexpr double tolerance = 1e-10;
  double low = 0.0;
  double high = 1.0;
  double before = std::clamp(start, 0.0, 1.0);
  double slope_before = slope_at(before);
  (slope_before > 0.0 ? low : high) = before;
  double t = std::clamp(before + (slope_before > 0.0 ? 1e-3 : -1e-3), 0.0, 1.0);
  for (int i = 0; i < step_limit; ++i) {
    const double slope = slope_at(t);
    (slope > 0.0 ? low : high) = t;
    double next = t - slope * (t - before) / (slope - slope_before);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    before = t;
    slope_before = slope;
    t = next;
    if (std::fabs(t - before) <= tolerance) break;
  }
  return t;
}

PlanePoint ContactResiduals::scale_of(const WeightedSample& sample, std::span<const double> parameters) const noexcept {
  const double gamma = layout_.gamma ? parameters[layout_.gamma_place()] : layout_.fixed_gamma;
  return {std::exp(parameters[0]) * sample.load_force, std::exp(parameters[1] + gamma * sample.log_load) * sample.load_moment};
}

void ContactResiduals::expect_drift(std::span<const double> parameters, double variance) {
  if (layout_.shape) curve_.bend(parameters[2]);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    // Curvature by the circle through three points: 4·area/(product of the sides).
    constexpr double step = 0.01;
    const double t = std::clamp(last_[i], step, 1.0 - step);
    const PlanePoint scale = scale_of(samples_[i], parameters);
    std::array<PlanePoint, 3> points{};
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint point = curve_.at(t + step * (static_cast<double>(k) - 1.0)).point;
      points[k] = {scale.x * point.x, scale.y * point.y};
    }
    const auto side = [&](std::size_t a, std::size_t b) { return std::hypot(points[a].x - points[b].x, points[a].y - points[b].y); };
    const double twice_area =
        std::fabs((points[1].x - points[0].x) * (points[2].y - points[0].y) - (points[1].y - points[0].y) * (points[2].x - points[0].x));
    const double curvature = 2.0 * twice_area / (side(0, 1) * side(1, 2) * side(0, 2));
    drift_[i] = std::min(0.5 * curvature * variance, 0.25 * std::sqrt(variance));
  }
}

bool ContactResiduals::evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const {
  const WeightedSample& sample = samples_[i];
  if (layout_.shape) curve_.bend(parameters[2]);
  const PlanePoint scale = scale_of(sample, parameters);
  const PlanePoint at{sample.force, sample.moment};
  double& t = last_[i];
  t = closest(at, scale, t >= 0.0 ? t : curve_.guess({at.x / scale.x, at.y / scale.y}));
  if (!(t >= 0.0 && t <= 1.0)) {
    t = -1.0;
    return false;
  }
  const auto distance_at = [&](double there) {
    const PlanePoint point = curve_.at(there).point;
    return std::hypot(at.x - scale.x * point.x, at.y - scale.y * point.y);
  };
  // Well inside the curve the distance has two minima, one towards each end: a search finds the nearer of them only by chance.
  constexpr double well_inside = 0.05;
  const PlanePoint nearest = curve_.at(t).point;
  const double size = std::hypot(scale.x * nearest.x, scale.y * nearest.y);
  if (std::hypot(at.x, at.y) < (1.0 - well_inside) * size) {
    for (const double end : {0.0, 1.0}) {
      const double other = closest(at, scale, end);
      if (distance_at(other) < distance_at(t)) t = other;
    }
  }
  const UnitCurve::Place place = curve_.at(t);
  const PlanePoint on_curve{scale.x * place.point.x, scale.y * place.point.y};
  const double outward_x = scale.y * place.tangent.y;
  const double outward_y = -scale.x * place.tangent.x;
  const double length = std::sqrt(outward_x * outward_x + outward_y * outward_y);
  const PlanePoint normal{outward_x / length, outward_y / length};
  residual = (at.x - on_curve.x) * normal.x + (at.y - on_curve.y) * normal.y - drift_[i];
  if (gradient != nullptr) {
    gradient[0] = -normal.x * on_curve.x;
    gradient[1] = -normal.y * on_curve.y;
    if (layout_.shape) {
      const PlanePoint slope = curve_.shape_slope(t);
      gradient[2] = -(normal.x * scale.x * slope.x + normal.y * scale.y * slope.y);
    }
    if (layout_.gamma) gradient[layout_.gamma_place()] = gradient[1] * sample.log_load;
  }
  return true;
}

}  // namespace limitcurve::fit::internal
