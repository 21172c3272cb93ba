// SPDX-License-Identifier: MIT
// Limits from a log without marks: rows on the way to the limit, holds, slips; of each contact by one grip.

#include "tests/complaint.hpp"
#include "tests/fit/synthetic.hpp"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace limitcurve::fit {
namespace {

constexpr double true_mu = 0.7;
constexpr double true_radius = 0.005;

struct Log {
  double gamma = 0.0;  ///< of the radius
  bool holds_only = false;
  std::vector<double> loads{};  ///< in turn; random if empty
  double spin = 0.0;            ///< of all grips; varied if 0
  double fall = 0.0;            ///< mu ∝ P^-fall
  bool in_turn = false;         ///< a grip slides, and then twists
  double tilt = 0.0;            ///< of the sensor, about its y; each grip slides another way
};

/// `grips` contacts of 60 rows of a Hertz brush: its bristles bend by 1 and then slide. If the loads are random, every
/// second contact is a hold, in which they bend by half at most. Noise of 1 % of the limit at 3 N, 0.3 % of the load.
std::vector<Sample> log_of(std::size_t grips, const Log& log, Random& random) {
  constexpr int bristles = 200;
  const double sigma_force = 0.01 * true_mu * 3.0;
  const double sigma_moment = sigma_force * true_radius * hertz()->moment_ratio();
  const auto noise = [&](double sigma) { return sigma * random.normal(); };
  std::vector<Sample> samples;
  for (std::size_t grip = 0; grip < grips; ++grip) {
    const bool is_given = !log.loads.empty();
    const double load = is_given ? log.loads[grip % log.loads.size()] : random.uniform(1.5, 6.0);
    const double spin = log.spin > 0.0 ? log.spin : std::array{0.01, 0.99, random.uniform(0.2, 0.8)}.at(grip % 3);
    const double bend = log.holds_only || (grip % 2 == 1 && !is_given) ? random.uniform(0.1, 0.5) : 40.0;
    const double limit = true_mu * std::pow(load, 1.0 - log.fall);
    const double way = log.tilt > 0.0 ? random.uniform(0.0, 6.3) : 0.0;
    for (int i = 0; i < 60; ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int j = 0; j < bristles; ++j) {
        const double rho = std::sqrt(1.0 - std::pow(1.0 - (j + 0.5) / bristles, 2.0 / 3.0));
        const Eigen::Vector3d place = rho * Eigen::Vector3d(std::cos(2.4 * j), std::sin(2.4 * j), 0.0);
        const double turn = !log.in_turn ? spin : i < 30 ? 0.01 : 0.99;
        Eigen::Vector3d pull(1.0 - turn * (1.0 + place.y()), turn * place.x(), 0.0);
        pull *= std::fmin(1.0, i / 30.0) * bend;
        pull /= std::fmax(1.0, pull.norm()) * bristles;
        sum += pull + place.cross(pull);
      }
      const double along = limit * sum.head<2>().norm();
      const Eigen::Vector3d seen = Eigen::AngleAxisd(log.tilt, Eigen::Vector3d::UnitY()) *
                                   Eigen::Vector3d(along * std::cos(way), along * std::sin(way), load);
      const double moment = limit * true_radius * std::pow(load, log.gamma) * sum.z() * load / seen.z();
      samples.push_back({seen.z() + noise(0.003 * load), seen.head<2>().norm() + noise(sigma_force),
                         moment + noise(sigma_moment), sigma_force, sigma_moment, 0, grip + 1});
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
  for (const double gamma : {0.0, 0.25, 0.9}) {
    for (int seed = 0; seed < 4; ++seed) {
      Random random(60 + seed);
      const std::vector<Sample> samples = log_of(48, {.gamma = gamma}, random);
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
    const std::vector<Sample> samples = log_of(24, {.holds_only = true}, random);
    try {
      silent += fit_contact(samples, ContactModel::of(hertz()), edge()).report.warnings.empty() ? 1 : 0;
    } catch (const std::invalid_argument& refusal) {
      test::expect_mention(refusal.what(), "slip");
    }
  }
  EXPECT_LE(silent, 2);
}

// Each way has another edge then, of which the farthest is that of a friction angle greater by the tilt.
TEST(Edge, ATiltedSensorCostsItsTiltOrIsRefused) {
  for (const double tilt : {0.02, 0.1}) {
    for (int seed = 70; seed < 72; ++seed) {
      Random random(seed);
      try {
        const FitReport report =
            fit_contact(log_of(48, {.tilt = tilt}, random), ContactModel::of(hertz()), edge()).report;
        const Estimate& mu = report.at("mu");
        EXPECT_LT(mu.value, std::tan(std::atan(true_mu) + tilt) + 2.5 * mu.std_error) << tilt;
      } catch (const std::invalid_argument& refusal) {
        test::expect_mention(refusal.what(), "normal");
      }
    }
  }
}

TEST(Edge, OneLoadOrCentreDoesNotTellAll) {
  const ContactModel law = ContactModel::of(hertz());
  for (int seed = 90; seed < 93; ++seed) {
    Random random(seed);
    // Slides at another load say nothing of gamma.
    for (const std::vector<double>& loads : {std::vector{3.0}, {2.0, 4.0, 4.0}}) {
      const std::vector<Sample> one_load = log_of(18, {.loads = loads}, random);
      const FitReport report = fit_contact(one_load, law, edge()).report;
      EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
      EXPECT_TRUE(holds(report.at("mu"), true_mu, 2.5));
      ContactFitOptions small = edge();
      small.largest_radius = 0.8 * true_radius;
      EXPECT_TRUE(warns(fit_contact(one_load, law, small).report, "more than the finger's"));
      test::expect_mention(test::complaint([&] { fit_contact(one_load, law, edge(true)); }), "only twists tell gamma");
    }
    for (const double spin : {0.3, 0.999}) {
      const std::vector<Sample> one_centre = log_of(18, {.loads = {2.0, 4.0}, .spin = spin}, random);
      test::expect_mention(test::complaint([&] { fit_contact(one_centre, law, edge()); }), "one centre");
    }
    const std::vector<Sample> falling = log_of(36, {.loads = {2.0, 4.0}, .fall = 0.3}, random);
    for (const bool fit_gamma : {false, true}) {
      const FitReport fallen = fit_contact(falling, law, edge(fit_gamma)).report;
      EXPECT_TRUE(warns(fallen, "mu falls with the load"));
      EXPECT_FALSE(fallen.gamma_refused);
    }
  }
}

TEST(Edge, CountsEachWayOfAGripInAllRows) {
  const ContactModel law = ContactModel::of(hertz());
  Random random(95);
  const FitReport turned = fit_contact(log_of(16, {.loads = {2.0, 4.0}, .in_turn = true}, random), law, edge()).report;
  test::expect_mention(turned.note, "16 of 16 grips reach the limit: 16 slides, 16 twists, 0 both");
  EXPECT_TRUE(turned.warnings.empty()) << turned.warnings.front();
  EXPECT_TRUE(holds(turned.at("mu_r"), true_mu * true_radius * hertz()->moment_ratio(), 2.5));
  // Of so many rows every second is fitted: three of the six slips of a grip, and noise hides some.
  std::vector<Sample> brief = log_of(200, {.loads = {3.0}}, random);
  for (std::size_t i = 0; i < brief.size(); ++i) {
    const double held = i % 60 / 6 == 5 ? 1.0 : random.uniform(0.1, 0.7);
    brief[i].force *= held;
    brief[i].moment *= held;
  }
  const std::string note = fit_contact(brief, law, edge()).report.note;
  EXPECT_GE(std::stoi(note.substr(note.rfind("; ") + 2)), 190) << note;
}

TEST(Edge, SaysWhatItNeeds) {
  Random random(3);
  const std::vector<Sample> good = log_of(8, {}, random);
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
