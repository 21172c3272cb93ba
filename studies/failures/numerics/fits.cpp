// SPDX-License-Identifier: MIT
// Entry "fits": curves with few parameters, fitted to the exact one and to measurements.
#include "../failures.hpp"

#include "../../../tests/fit/synthetic.hpp"
#include "fit/fit.hpp"
#include "gaussian_sum.hpp"
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
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"fits_cor", {}});
  struct Model {
    std::string name;
    std::function<SlipTwist(UnitWrench)> normal;
    double worst = 0.0;
  };
  const ExactCurve curve(flat_punch());
  const auto model = [](std::string name, auto approximation) {
    return Model{std::move(name), [approximation](UnitWrench wrench) { return approximation.along(wrench).normal; }};
  };
  const double m0 = curve.moment_ratio();
  std::vector<Model> models{model("ellipse", Ellipse::through_intercepts(m0)), model("limitcurve", Table::build(flat_punch(), 1e-8))};
  for (const double s : in_ratios(1e-3, 1e3, 121)) {
    const ExactWrench exact = exact_flat_punch(s);
    const UnitWrench wrench{static_cast<double>(exact.force), static_cast<double>(exact.moment)};
    for (Model& each : models) {
      const double ratio = each.normal(wrench).cor() / s;
      figure.rows.push_back({"cor", each.name, s, ratio});
      // A factor in either direction.
      each.worst = std::max(each.worst, std::max(ratio, 1.0 / ratio) - 1.0);
    }
  }
  found.findings.push_back({"COR implied by a fitted curve", "ellipse",
                            "factor to the true COR minus 1 (flat punch, 1e-3 ≤ s ≤ 1e3; ours: table of 1e-8)", models[0].worst,
                            models[1].worst});
  return found;
}

Hazard dying_tails() {
  Hazard found;
  constexpr double last = 5.0;
  const customary::GaussianSum moment([](double s) { return static_cast<double>(exact_hertz(s).moment); }, last);
  const customary::GaussianSum lack_of_force([](double s) { return 1.0 - static_cast<double>(exact_hertz(s).force); }, last);
  const Table table = Table::build(hertz(), 1e-4);
  struct Errors {
    double moment;
    double cor;
  };
  const auto of_sums = [&](double s) -> Errors {
    // The normal of the curve of the two sums: s = −dm/df.
    return {relative_error(moment.value(s), exact_hertz(s).moment), std::fabs(moment.slope(s) / lack_of_force.slope(s) / s - 1.0)};
  };
  const auto of_table = [&](double s) -> Errors {
    const ExactWrench exact = exact_hertz(s);
    const RadialPoint met = table.along({static_cast<double>(exact.force), static_cast<double>(exact.moment)});
    return {relative_error(table.wrench(SlipTwist::about_cor(s)).moment, exact.moment), std::fabs(met.normal.cor() / s - 1.0)};
  };
  const std::string method = "three Gaussians each for f and m, least squares on s ≤ 5";
  double within = 0.0;
  double ours_within = 0.0;
  for (const double s : evenly(0.0, last, 201)) {
    const double truth = static_cast<double>(exact_hertz(s).moment);
    within = std::max(within, std::fabs(moment.value(s) - truth));
    ours_within = std::max(ours_within, std::fabs(table.wrench(SlipTwist::about_cor(s)).moment - truth));
  }
  const double far = 20.0;
  found.findings.push_back({"vanishing tails", method, "error of m in the fitted range (Hertz; ours: table of 1e-4)", within, ours_within});
  found.findings.push_back({"vanishing tails", method, "relative error of m at s = 20", of_sums(far).moment, of_table(far).moment});
  found.findings.push_back({"vanishing tails", method, "relative error of the COR implied at s = 20", of_sums(far).cor, of_table(far).cor});
  return found;
}

Hazard shape_and_radius() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"fits_shape", {}});
  using fit::synthetic::Random;
  constexpr double mu = 0.8;
  constexpr double radius = 0.005;
  constexpr double noise = 0.01;
  constexpr std::size_t samples_a_set = 100;
  constexpr int sets = 120;
  const auto measured = [&](const Law& law, Random& random) {
    auto samples = fit::synthetic::clean(fit::synthetic::curve_of(law), {mu, radius}, samples_a_set, random);
    fit::synthetic::disturb(samples, noise, mu, mu * law->moment_ratio() * radius, true, random);
    return samples;
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
    const double n = fitted.at("n").value;
    if (std::isfinite(n)) figure.rows.push_back({"cloud", "a fit", n, 1e3 * fitted.at("radius").value});
  }
  for (const double n : evenly(-0.7, 6.0, 40)) {
    figure.rows.push_back({"cloud", "same moment", n, 1e3 * radius * truth->moment_ratio() / power(n)->moment_ratio()});
  }

  // An assumed law: Hertz assumed, the truth is uniform.
  const Law pad = uniform();
  std::vector<double> assumed_in_errors;
  std::vector<double> free_in_errors;
  for (int i = 0; i < sets; ++i) {
    const auto samples = measured(pad, random);
    const auto in_errors = [&](const fit::Estimate& estimate) { return std::fabs(estimate.value - radius) / estimate.std_error; };
    const double assumed = in_errors(fit::fit_contact(samples, fit::ContactModel::of(truth)).report.at("radius"));
    const fit::Estimate free = fit::fit_contact(samples, {fit::ContactModel::Kind::power}).report.at("radius");
    assumed_in_errors.push_back(assumed);
    // A radius hidden by noise is reported as nan ± inf, which claims nothing.
    free_in_errors.push_back(std::isfinite(free.value) && std::isfinite(free.std_error) ? in_errors(free) : 0.0);
    figure.rows.push_back({"errors", "Hertz assumed", static_cast<double>(i), assumed_in_errors.back()});
    figure.rows.push_back({"errors", "limitcurve", static_cast<double>(i), free_in_errors.back()});
  }
  const std::string data = " (95th percentile of 120 data sets of 100 slips, 1 % noise)";
  found.findings.push_back({"shape and radius not identifiable", "radius a reported, from a fit of n and a (ours: μ_r)",
                            "relative error of the length reported" + data, quantile(radius_error, 0.95), quantile(ratio_error, 0.95)});
  found.findings.push_back({"shape and radius not identifiable", "Hertz assumed for a uniform pressure (ours: n free)",
                            "error of the radius in standard errors stated" + data, quantile(assumed_in_errors, 0.95),
                            quantile(free_in_errors, 0.95)});
  return found;
}

}  // namespace limitcurve::stability
