// SPDX-License-Identifier: MIT
// Limits from a log without marks: rows on the way to the limit, holds, slips; of each contact by one grip.

#include "tests/complaint.hpp"
#include "tests/fit/synthetic.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit {
namespace {

constexpr double true_mu = 0.7;
constexpr double true_radius = 0.005;

/// `grips` contacts of 60 rows: a wrench grows along a ray to `reach` times the limit, where it stays. Every second is
/// a hold, which ends at half of the limit at most. Noise of 1 % of the limit at 3 N, gamma of the radius.
std::vector<Sample> log_of(int grips, double gamma, bool holds_only, Random& random) {
  const Curve curve = curve_of(hertz());
  const double sigma_force = 0.01 * true_mu * 3.0;
  const double sigma_moment = sigma_force * true_radius * hertz()->moment_ratio();
  std::vector<Sample> samples;
  for (int grip = 0; grip < grips; ++grip) {
    const double load = random.uniform(1.5, 6.0);
    const double spin = grip % 3 == 0 ? 0.01 : grip % 3 == 1 ? 0.99 : random.uniform(0.2, 0.8);
    const UnitWrench wrench = curve((1.0 - spin) / spin);
    const double reach = holds_only || grip % 2 == 1 ? random.uniform(0.1, 0.5) : 1.0;
    for (int i = 0; i < 60; ++i) {
      const double size = std::fmin(1.0, i / 30.0) * reach * true_mu * load;
      samples.push_back({load, size * wrench.force + sigma_force * random.normal(),
                         size * true_radius * std::pow(load, gamma) * wrench.moment + sigma_moment * random.normal(),
                         sigma_force, sigma_moment, 0, static_cast<std::size_t>(grip + 1)});
    }
  }
  return samples;
}

ContactFitOptions edge(bool fit_gamma = false) {
  ContactFitOptions options;
  options.loss = Loss::edge();
  options.fit_gamma = fit_gamma;
  return options;
}

TEST(Edge, FindsTheLimitsAmongHoldsAndLoadingWithoutMarks) {
  const double mu_r = true_mu * true_radius * hertz()->moment_ratio();
  for (const double gamma : {0.0, 0.25}) {
    for (int seed = 0; seed < 4; ++seed) {
      Random random(60 + seed);
      const std::vector<Sample> samples = log_of(48, gamma, false, random);
      const ContactFit fit = fit_contact(samples, ContactModel::of(hertz()), edge(gamma > 0.0));
      const Estimate& force = fit.report.at("mu");
      const Estimate& moment = fit.report.at("mu_r");
      EXPECT_NEAR(force.value, true_mu, 2.5 * force.std_error);
      EXPECT_NEAR(moment.value, mu_r, 2.5 * moment.std_error);
      EXPECT_LT(force.std_error, 0.02 * true_mu);
      EXPECT_TRUE(fit.report.warnings.empty()) << fit.report.warnings.front();
      test::expect_mention(fit.report.note, "24 of 48 grips reach the limit");
      EXPECT_EQ(fit.residuals.size(), samples.size());
      if (gamma > 0.0) {
        EXPECT_NEAR(fit.report.at("gamma").value, gamma, 3.0 * fit.report.at("gamma").std_error);
        EXPECT_TRUE(fit_contact(samples, ContactModel::of(hertz()), edge()).report.gamma_refused);
      }
    }
  }
}

TEST(Edge, HoldsAloneAreWarnedOfOrRefused) {
  // A sharp edge by chance stays unnoticed in few logs.
  int silent = 0;
  for (int seed = 0; seed < 8; ++seed) {
    Random random(80 + seed);
    const std::vector<Sample> samples = log_of(24, 0.0, true, random);
    try {
      silent += fit_contact(samples, ContactModel::of(hertz()), edge()).report.warnings.empty() ? 1 : 0;
    } catch (const std::invalid_argument& refusal) {
      test::expect_mention(refusal.what(), "outside any edge");
    }
  }
  EXPECT_LE(silent, 2);
}

TEST(Edge, SaysWhatItNeeds) {
  Random random(3);
  const std::vector<Sample> good = log_of(8, 0.0, false, random);
  const auto refusal = [&](auto change, ContactModel model) {
    std::vector<Sample> samples = good;
    for (Sample& sample : samples) change(sample);
    return test::complaint([&] { fit_contact(samples, model, edge()); });
  };
  const auto nothing = [](Sample&) {};
  const ContactModel law = ContactModel::of(hertz());
  test::expect_mention(refusal([](Sample& s) { s.sigma_force = s.sigma_moment = 0.0; }, law), "--zero");
  test::expect_mention(refusal([](Sample& s) { s.grip = 0; }, law), "column grip");
  test::expect_mention(refusal([](Sample& s) { s.grip = 1; }, law), "at least 4 grips");
  test::expect_mention(refusal(nothing, {ContactModel::Kind::ellipse}), "only for the curve of a law");
}

}  // namespace
}  // namespace limitcurve::fit
