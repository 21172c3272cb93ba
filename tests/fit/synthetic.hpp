// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace limitcurve::fit {

/// Seeded, and the same on every standard library: std::normal_distribution is not.
class Random {
 public:
  template <std::integral Seed>
  explicit Random(Seed seed) : generator_(static_cast<std::uint64_t>(seed)) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
  }
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(6.283185307179586 * uniform(0.0, 1.0));
  }

 private:
  std::mt19937_64 generator_;
};

/// A unit wrench (f, m) of the curve at the normalised slip ratio s/m₀.
using Curve = std::function<UnitWrench(double)>;

/// By the law's extended-precision evaluator, which no fit uses.
inline Curve curve_of(const Law& law) {
  return [law, moment_ratio = law->moment_ratio()](double t) { return law->evaluate(t * moment_ratio).wrench; };
}

struct Truth {
  double mu;
  double radius;
  double gamma = 0.0;  ///< radius = radius(1 N)·P^gamma

  [[nodiscard]] double mu_r(const Law& law) const { return mu * radius * law->moment_ratio(); }
};

/// `count` samples spread over the curve from near pure twist to near pure slide, at random loads, without noise.
inline std::vector<Sample> clean(const Curve& curve, const Truth& truth, std::size_t count, Random& random) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double load = random.uniform(0.5, 10.0);
    const UnitWrench wrench = curve((1.0 - u) / u);
    samples.push_back({load, truth.mu * load * wrench.force,
                       truth.mu * load * truth.radius * std::pow(load, truth.gamma) * wrench.moment});
  }
  return samples;
}

inline std::vector<Sample> clean(const Law& law, const Truth& truth, std::size_t count, Random& random) {
  return clean(curve_of(law), truth, count, random);
}

/// Whether an estimate is within so many of its standard errors, 95 % of them as a rule, of the truth.
inline bool holds(const Estimate& estimate, double truth, double standard_errors = 1.959964) {
  return std::fabs(estimate.value - truth) <= standard_errors * estimate.std_error;
}

/// Whether one of its warnings has these words.
inline bool warns(const FitReport& report, const std::string& words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// Adds Gaussian errors of `relative` times the limits μP and μ_rP, and optionally sets the sigmas.
inline void disturb(std::vector<Sample>& samples, double relative, double mu, double mu_r, bool tell, Random& random) {
  for (Sample& sample : samples) {
    const double sigma_force = relative * mu * sample.load;
    const double sigma_moment = relative * mu_r * sample.load;
    sample.force += sigma_force * random.normal();
    sample.moment += sigma_moment * random.normal();
    if (tell) {
      sample.sigma_force = sigma_force;
      sample.sigma_moment = sigma_moment;
    }
  }
}

/// Samples of a law with such errors.
inline std::vector<Sample> noisy(const Law& law, const Truth& truth, std::size_t count, double relative, bool tell,
                                 Random& random) {
  std::vector<Sample> samples = clean(law, truth, count, random);
  disturb(samples, relative, truth.mu, truth.mu_r(law), tell, random);
  return samples;
}

}  // namespace limitcurve::fit
