// SPDX-License-Identifier: MIT
// Notation:
//   (x, y)(t)  the unit curve and its parameter t, 0 at pure sliding, 1 at pure spin
//   scale      (μ P/σ_F, μ_r P (P/P₀)^γ/σ_M): the curve of a sample in the plane of its errors is q = scale·(x, y)
//   at         the sample in that plane, (|F|/σ_F, |M|/σ_M)
//   N          outward unit normal at the closest point of q; the residual is (at − q)·N
//   drift      the residual that errors cause on average where q is curved
//   parameters log μ, log μ_r, the shape if it is fitted, γ if it is fitted
#include "fit/internal/contact_residuals.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::fit::internal {

ContactResiduals::ContactResiduals(std::span<const WeightedSample> samples, UnitCurve& curve, ContactLayout layout)
    : samples_(samples), curve_(curve), layout_(layout), last_(samples.size(), -1.0), drift_(samples.size(), 0.0) {}

/// The t where (sample − q)·q′ changes sign, from ≥ 0 at the slide's end to ≤ 0 at the twist's: secant steps within a
/// bracket. The distance is stationary there, so an error of 1e-9 in t changes it by 1e-18.
double ContactResiduals::closest(PlanePoint sample, PlanePoint scale, double start) const noexcept {
  const auto slope_at = [&](double t) {
    const UnitCurve::Place place = curve_.at(t);
    const PlanePoint tangent = scale * place.tangent;
    const PlanePoint off = sample - scale * place.point;
    return (off.x * tangent.x + off.y * tangent.y) / std::sqrt(tangent.x * tangent.x + tangent.y * tangent.y);
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
  return {std::exp(parameters[0]) * sample.load_force,
          std::exp(parameters[1] + gamma * sample.log_load) * sample.load_moment};
}

void ContactResiduals::expect_drift(std::span<const double> parameters, double variance) {
  if (layout_.shape) curve_.bend(parameters[2]);
  const double noise = std::sqrt(variance);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const PlanePoint scale = scale_of(samples_[i], parameters);
    // The distance from the curve of q(t) with an error of ±σ along the tangent; its closest points.
    const auto strayed = [&](double t, std::array<double, 2>& closest_to) {
      const UnitCurve::Place place = curve_.at(t);
      const PlanePoint tangent = scale * place.tangent;
      const double step = noise / tangent.length();
      double distance = 0.0;
      for (const double sign : {-1.0, 1.0}) {
        // The curve is symmetric about both axes.
        const PlanePoint at{std::fabs(scale.x * place.point.x + sign * step * tangent.x),
                            std::fabs(scale.y * place.point.y + sign * step * tangent.y)};
        double& nearest = closest_to.at(sign > 0.0 ? 1 : 0);
        nearest = closest(at, scale, t);
        distance += 0.5 * (at - scale * curve_.at(nearest).point).length();
      }
      return distance;
    };
    std::array<double, 2> around{};
    std::array<double, 2> beyond{};
    drift_[i] = 2.0 * strayed(last_[i], around);
    // The closest point of a sample strays along the curve, too: take out what that smooths.
    for (const double t : around) drift_[i] -= 0.5 * strayed(t, beyond);
  }
}

ContactResiduals::Ray ContactResiduals::common_ray(std::span<const double> parameters) const {
  const double gamma = layout_.gamma ? parameters[layout_.gamma_place()] : layout_.fixed_gamma;
  const auto count = static_cast<double>(samples_.size());
  const auto per_load = [&](const WeightedSample& sample) {
    return PlanePoint{sample.force / sample.load_force,
                      sample.moment / (sample.load_moment * std::exp(gamma * sample.log_load))};
  };
  PlanePoint mean{0.0, 0.0};
  for (const WeightedSample& sample : samples_) {
    mean.x += per_load(sample).x / count;
    mean.y += per_load(sample).y / count;
  }
  Ray ray{0.0, 0.0, 0.0, std::vector<double>(samples_.size())};
  PlanePoint squares{0.0, 0.0};
  for (const WeightedSample& sample : samples_) {
    const PlanePoint off = per_load(sample) - mean;
    squares += off * off;
    ray.correlation += off.x * off.y;
  }
  ray.correlation /= std::sqrt(squares.x * squares.y);
  const auto at = [&](double angle) {
    double sum = 0.0;
    double known = 0.0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const WeightedSample& sample = samples_[i];
      const double x = std::cos(angle) * mean.x * sample.load_force;
      const double y = std::sin(angle) * mean.y * sample.load_moment * std::exp(gamma * sample.log_load);
      const double length = std::hypot(x, y);
      ray.distances[i] = (sample.moment * x - sample.force * y) / length;
      sum += ray.distances[i] * ray.distances[i];
      known += std::pow((sample.force * x + sample.moment * y) * x * y / (length * length * length), 2);
    }
    ray.ratio = mean.y / mean.x * std::tan(angle);
    ray.relative_error = 1.0 / std::sqrt(known);
    return sum;
  };
  constexpr double quarter_turn = 1.5707963267948966;
  constexpr int bits = 26;
  at(boost::math::tools::brent_find_minima(at, 0.0, quarter_turn, bits).first);
  return ray;
}

bool ContactResiduals::evaluate(std::size_t i, std::span<const double> parameters, double& residual,
                                double* gradient) const {
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
  const auto distance_at = [&](double there) { return (at - scale * curve_.at(there).point).length(); };
  // Well inside the curve the distance has two minima, one towards each end: a search finds the nearer of them only by
  // chance.
  constexpr double well_inside = 0.05;
  if (at.length() < (1.0 - well_inside) * (scale * curve_.at(t).point).length()) {
    for (const double end : {0.0, 1.0}) {
      const double other = closest(at, scale, end);
      if (distance_at(other) < distance_at(t)) t = other;
    }
  }
  const UnitCurve::Place place = curve_.at(t);
  const PlanePoint on_curve = scale * place.point;
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
