// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fit/synthetic.hpp"

#include <map>

namespace limitcurve::fit {

/// How honest the estimates of one quantity are, over many noisy copies of the same truth.
struct Honesty {
  double bias = 0.0;       ///< mean error over mean standard error
  double coverage = 0.0;   ///< share of the 95 % intervals that hold the truth
  double std_error = 0.0;  ///< mean standard error over the truth
  double scatter = 0.0;    ///< root mean square error over the truth
};

/// Which samples of a study are spoilt: one in ten, taken while the finger held (inside the curve by factors of 0.2 to
/// 0.6), or every second of those in an impact (outside, 1.5 to 3).
enum class Outliers { none, inside, both_sides };

/// Fits `model` to `seeds` noisy copies of 100 samples of the contact that `law` (shape parameter `shape`) makes with
/// μ = 0.8, a = 5 mm. `noise` is the relative error of force, and `moment_noise` times it that of moment; `tell` gives
/// the sigmas to the fit. Fits that declare the shape unknown (infinite standard error) are left out and counted in
/// `blanks`.
inline std::map<std::string, Honesty> study(const ContactModel& model, const Law& law, double shape, double noise,
                                            bool tell, int seeds, int& blanks, const Loss& loss = {},
                                            Outliers outliers = Outliers::none, double moment_noise = 1.0) {
  const Truth truth{0.8, 0.005};
  const double mu_r = truth.mu_r(law);
  const std::map<std::string, double> truths{{"mu", truth.mu},         {"mu_r", mu_r},      {"ratio", mu_r / truth.mu},
                                             {"radius", truth.radius}, {"n", shape},        {"k", shape},
                                             {"force_max", truth.mu},  {"moment_max", mu_r}};
  Random loads(5);
  const std::vector<Sample> exact = clean(law, truth, 100, loads);
  std::map<std::string, Honesty> result;
  blanks = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(1000 + seed);
    std::vector<Sample> samples = exact;
    disturb(samples, noise, truth.mu, moment_noise * mu_r, tell, random);
    for (std::size_t i = 3; outliers != Outliers::none && i < samples.size(); i += 10) {
      const double factor =
          outliers == Outliers::both_sides && i % 20 == 3 ? random.uniform(1.5, 3.0) : random.uniform(0.2, 0.6);
      samples[i].force *= factor;
      samples[i].moment *= factor;
    }
    const FitReport report = fit_contact(samples, model, {.loss = loss}).report;
    bool blank = false;
    for (const Estimate& estimate : report.estimates) blank = blank || !std::isfinite(estimate.std_error);
    if (blank) {
      ++blanks;
      continue;
    }
    for (const Estimate& estimate : report.estimates) {
      const double error = estimate.value - truths.at(estimate.name);
      Honesty& honesty = result[estimate.name];
      honesty.bias += error;
      honesty.coverage += holds(estimate, truths.at(estimate.name)) ? 1.0 : 0.0;
      honesty.std_error += estimate.std_error;
      honesty.scatter += error * error;
    }
  }
  for (auto& [name, honesty] : result) {
    const auto counted = static_cast<double>(seeds - blanks);
    honesty.bias /= honesty.std_error;
    honesty.coverage /= counted;
    honesty.std_error /= counted * truths.at(name);
    honesty.scatter = std::sqrt(honesty.scatter / counted) / truths.at(name);
  }
  return result;
}

}  // namespace limitcurve::fit
