// SPDX-License-Identifier: MIT
#include "fit/internal/friction_fit.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::fit {

namespace {

struct Line {
  double mean = 0.0;
  double mean_error = 0.0;
  double drift = std::numeric_limits<double>::quiet_NaN();
  double drift_error = std::numeric_limits<double>::quiet_NaN();
};

/// Least squares of y = a + b x: mean of y and b/mean, with standard errors from the scatter.
Line regress(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0;
  Line line;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count;
    line.mean += y[i] / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - line.mean);
    yy += (y[i] - line.mean) * (y[i] - line.mean);
  }
  line.mean_error = std::sqrt(yy / (count - 1.0) / count);
  constexpr double rounding = 1e-24;
  if (xx > rounding * count) {
    const double slope = xy / xx;
    double residuals = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double residual = y[i] - line.mean - slope * (x[i] - mean_x);
      residuals += residual * residual;
    }
    line.drift = slope / line.mean;
    line.drift_error = std::sqrt(residuals / (count - 2.0) / xx) / std::fabs(line.mean);
  }
  return line;
}

}  // namespace

std::vector<PushFriction> push_friction(const Patch& patch, std::span<const Push> pushes, double load) {
  const double m0 = patch.moment_ratio();
  const PatchPoint centre = patch.centre();
  std::vector<PushFriction> found;
  for (const auto& [wrench, twist] : pushes) {
    const double vx = twist.vx - twist.omega * centre.y;
    const double vy = twist.vy + twist.omega * centre.x;
    const double power = (wrench.fx * twist.vx + wrench.fy * twist.vy + wrench.moment * twist.omega) / load;
    const double exact_power = patch.about_origin(twist).power;
    const double spin = m0 * twist.omega;
    const double ellipsoid_power = std::hypot(patch.factors().x * vx, patch.factors().y * vy, spin);
    if (!(exact_power > 0.0 && ellipsoid_power > 0.0)) {
      throw std::invalid_argument("push " + std::to_string(found.size() + 1) + ": no displacement, expected one that slides");
    }
    found.push_back({std::fabs(spin) / std::hypot(vx, vy, spin), power / exact_power, power / ellipsoid_power});
  }
  return found;
}

std::vector<Estimate> fit_friction(const Patch& patch, std::span<const Push> pushes, double load, const std::string& unit) {
  if (pushes.size() < 3) throw std::invalid_argument(std::to_string(pushes.size()) + " pushes, expected at least 3");
  std::vector<double> share;
  std::vector<double> exact;
  std::vector<double> ellipsoid;
  for (const PushFriction& push : push_friction(patch, pushes, load)) {
    share.push_back(push.share);
    exact.push_back(push.exact);
    ellipsoid.push_back(push.ellipsoid);
  }
  const Line of_exact = regress(share, exact);
  const Line of_ellipsoid = regress(share, ellipsoid);
  return {{"mu", of_exact.mean, of_exact.mean_error, unit},
          {"drift", of_exact.drift, of_exact.drift_error, "1"},
          {"mu_ellipsoid", of_ellipsoid.mean, of_ellipsoid.mean_error, unit},
          {"drift_ellipsoid", of_ellipsoid.drift, of_ellipsoid.drift_error, "1"}};
}

}  // namespace limitcurve::fit
