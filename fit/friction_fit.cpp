// SPDX-License-Identifier: MIT
#include "fit/friction_fit.hpp"

#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace limitcurve::fit {

using namespace internal;

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

/// Warnings of displacements and moments that no contact of metres, radians and N m is likely to have.
std::vector<std::string> suspicious_units(const Patch& patch, std::span<const Push> pushes) {
  constexpr double longest = 1.0;
  double distance = 0.0;
  double turn = 0.0;
  std::vector<double> arms;  // moment over force, as a multiple of that of the patch
  for (const auto& [wrench, moved, row] : pushes) {
    distance = std::max(distance, std::hypot(moved.vx, moved.vy));
    turn = std::max(turn, std::fabs(moved.omega));
    const PatchWrench expected = patch.about_origin(moved).wrench;
    const double force = std::hypot(expected.fx, expected.fy);
    if (force > 0.1 && std::fabs(expected.moment) > 0.1 * patch.moment_ratio()) {
      arms.push_back(std::fabs(wrench.moment / expected.moment) * force / std::hypot(wrench.fx, wrench.fy));
    }
  }
  std::vector<std::string> warnings;
  if (distance > longest)
    warnings.push_back("a push of " + format_number(distance, 3) + " m: are dx and dy in metres?");
  if (turn > std::numbers::pi)
    warnings.push_back("a push turns by " + format_number(turn, 3) + " rad: is dtheta in radians?");
  if (!arms.empty()) {
    const double middle = median_of(std::move(arms));
    constexpr double least = 30.0;
    if (middle > least) {
      warnings.push_back(
          "moments are " + format_number(middle, 3) +
          " times those that the patch has beside these forces: are they in N m, and is the patch in metres?");
    }
  }
  return warnings;
}

}  // namespace

std::vector<PushFriction> push_friction(const Patch& patch, std::span<const Push> pushes, double load) {
  if (!(load > 0.0) || std::isinf(load)) throw out_of_range("load", load, "N", "> 0 and finite");
  const double m0 = patch.moment_ratio();
  const PatchPoint centre = patch.centre();
  std::vector<PushFriction> found;
  for (const auto& [wrench, twist, row] : pushes) {
    const double vx = twist.vx - twist.omega * centre.y;
    const double vy = twist.vy + twist.omega * centre.x;
    const double power = (wrench.fx * twist.vx + wrench.fy * twist.vy + wrench.moment * twist.omega) / load;
    const double exact_power = patch.about_origin(twist).power;
    const double spin = m0 * twist.omega;
    const double ellipsoid_power = std::hypot(patch.factors().x * vx, patch.factors().y * vy, spin);
    const auto refuse = [&, number = row > 0 ? row : found.size() + 1](const char* what) {
      throw std::invalid_argument("push " + std::to_string(number) + ": " + what);
    };
    if (!std::isfinite(power) || !std::isfinite(ellipsoid_power)) refuse("expected finite numbers");
    if (!(exact_power > 0.0 && ellipsoid_power > 0.0)) refuse("no displacement, expected one that slides");
    found.push_back({std::fabs(spin) / std::hypot(vx, vy, spin), power / exact_power, power / ellipsoid_power});
  }
  return found;
}

FrictionFit fit_friction(const Patch& patch, std::span<const Push> pushes, double load, const std::string& unit) {
  std::vector<double> share;
  std::vector<double> exact;
  std::vector<double> ellipsoid;
  std::vector<std::size_t> against;
  const std::vector<PushFriction> found = push_friction(patch, pushes, load);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].exact < 0.0) {
      against.push_back(i);
      continue;
    }
    share.push_back(found[i].share);
    exact.push_back(found[i].exact);
    ellipsoid.push_back(found[i].ellipsoid);
  }
  if (2 * against.size() > found.size()) {
    throw std::invalid_argument("push " + std::to_string(names_of(pushes, against).front()) +
                                ": negative power, as in " + std::to_string(against.size()) + " of " +
                                std::to_string(found.size()) +
                                " pushes; expected the wrench on the patch, which points along the motion: is this the "
                                "reaction, with the other "
                                "sign?");
  }
  if (share.size() < 3) throw std::invalid_argument(std::to_string(share.size()) + " pushes, expected at least 3");
  const Line of_exact = regress(share, exact);
  const Line of_ellipsoid = regress(share, ellipsoid);
  FrictionFit fit{{}, suspicious_units(patch, pushes), note_of_few_rows(share.size() - 1)};
  const auto add = [&](const std::string& which, const Line& line) {
    Estimate drift{"drift" + which, line.drift, line.drift_error, "1"};
    if (std::fabs(drift.value) > 1.0) {
      fit.warnings.push_back(drift.name + ": no estimate, for " + format_number(drift.value, 3) + " +- " +
                             format_number(drift.std_error, 3) +
                             " is more than mu itself: the shares of rotation hardly differ");
      drift.value = drift.std_error = std::numeric_limits<double>::quiet_NaN();
    }
    fit.estimates.insert(fit.estimates.end(), {{"mu" + which, line.mean, line.mean_error, unit}, drift});
  };
  add("", of_exact);
  add("_ellipsoid", of_ellipsoid);
  if (!against.empty()) {
    fit.warnings.insert(fit.warnings.begin(), listed("push", "pushes", names_of(pushes, against)) +
                                                  " (the first is 1): negative power, left out; did they slide?");
  }
  return fit;
}

}  // namespace limitcurve::fit
