// SPDX-License-Identifier: MIT
// Entry "fits": curves with few parameters, fitted to the exact one and to measurements.
#include "../failures.hpp"

#include "../../../tests/fit/synthetic.hpp"
#include "fit/fit.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "sampling.hpp"
#include "truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace limitcurve::stability {

namespace {

/// The quantile `share` of the numbers.
double quantile(std::vector<double> numbers, double share) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1))];
}

}  // namespace

Hazard cor_near_the_axes() {
  const Ellipse ellipse = Ellipse::through_intercepts(flat_punch()->moment_ratio());
  const Table table = Table::build(flat_punch(), 1e-8);
  double usual = 0.0;
  double ours = 0.0;
  for (const double s : in_ratios(1e-3, 1e3, 121)) {
    const ExactWrench exact = exact_flat_punch(s);
    const UnitWrench wrench{static_cast<double>(exact.force), static_cast<double>(exact.moment)};
    // A factor in either direction.
    const auto off = [s](double cor) { return std::max(cor / s, s / cor) - 1.0; };
    raise(usual, off(ellipse.along(wrench).normal.cor()));
    raise(ours, off(table.along(wrench).normal.cor()));
  }
  return {{{"COR implied by a fitted curve", "ellipse",
            "factor to the true COR minus 1 (flat punch, 1e-3 ≤ s ≤ 1e3; ours: table of 1e-8)", usual, ours}},
          {}};
}

Hazard shape_and_radius() {
  Hazard found;
  using fit::Random;
  constexpr double mu = 0.8;
  constexpr double radius = 0.005;
  constexpr double noise = 0.01;
  constexpr std::size_t samples_a_set = 100;
  constexpr int sets = 120;
  const auto measured = [&](const Law& law, Random& random) {
    return fit::noisy(law, {mu, radius}, samples_a_set, noise, true, random);
  };
  const auto off_by = [](double value, double truth) { return std::fabs(value / truth - 1.0); };

  // Shape and radius both free, the truth is Hertz: what changes, and what does not.
  Random random(20061);
  const Law truth = hertz();
  std::vector<double> radius_error;
  std::vector<double> ratio_error;
  for (int i = 0; i < sets; ++i) {
    const auto fitted = fit::fit_contact(measured(truth, random), {fit::ContactModel::Kind::power}).report;
    radius_error.push_back(off_by(fitted.at("radius").value, radius));
    ratio_error.push_back(off_by(fitted.at("mu_r").value, mu * truth->moment_ratio() * radius));
  }

  // An assumed law: Hertz assumed, the truth is uniform.
  const Law pad = uniform();
  std::vector<double> assumed_in_errors;
  std::vector<double> free_in_errors;
  for (int i = 0; i < sets; ++i) {
    const auto samples = measured(pad, random);
    const auto in_errors = [&](const fit::Estimate& estimate) {
      return std::fabs(estimate.value - radius) / estimate.std_error;
    };
    assumed_in_errors.push_back(in_errors(fit::fit_contact(samples, fit::ContactModel::of(truth)).report.at("radius")));
    const fit::Estimate free = fit::fit_contact(samples, {fit::ContactModel::Kind::power}).report.at("radius");
    // A radius hidden by noise is reported as nan ± inf, which claims nothing.
    free_in_errors.push_back(std::isfinite(free.value) && std::isfinite(free.std_error) ? in_errors(free) : 0.0);
  }
  const std::string data = " (95th percentile of 120 data sets of 100 slips, 1 % noise)";
  found.add("shape and radius not identifiable", "radius a reported, from a fit of n and a (ours: μ_r)",
            "relative error of the length reported" + data, quantile(radius_error, 0.95), quantile(ratio_error, 0.95));
  found.add("shape and radius not identifiable", "Hertz assumed for a uniform pressure (ours: n free)",
            "error of the radius in standard errors stated" + data, quantile(assumed_in_errors, 0.95),
            quantile(free_in_errors, 0.95));
  return found;
}

}  // namespace limitcurve::stability
