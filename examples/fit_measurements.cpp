// SPDX-License-Identifier: MIT
// From slips measured by a force-torque sensor to the parameters of a finger, with standard errors.
#include "fit/contact_fit.hpp"
#include "limitcurve/laws.hpp"

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

int main() {
  // Slips of a finger with mu = 0.7 and a = 5 mm under a uniform pressure, at random centres of rotation, with 2 % of
  // noise.
  const limitcurve::Law law = limitcurve::uniform();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> load(1.0, 4.0), exponent(-1.5, 1.5);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::vector<limitcurve::fit::Sample> slips;
  for (int i = 0; i < 200; ++i) {
    const double at = load(random);
    const auto unit = law->evaluate(std::pow(10.0, exponent(random))).wrench;
    slips.push_back({at, 0.7 * at * (unit.force + noise(random)),
                     0.7 * at * 0.005 * (unit.moment + noise(random) * law->moment_ratio())});
  }

  const auto fit = limitcurve::fit::fit_contact(slips, limitcurve::fit::ContactModel::of(law));
  int right = 0;
  for (const auto& found : fit.report.estimates) {
    std::printf("%-8s %.5g +- %.2g %s\n", found.name.c_str(), found.value, found.std_error, found.unit.c_str());
    const double true_value = found.name == "mu" ? 0.7 : found.name == "radius" ? 0.005 : std::nan("");
    right += std::abs(found.value - true_value) < 4.0 * found.std_error ? 1 : 0;
  }
  return right == 2 ? 0 : 1;
}
