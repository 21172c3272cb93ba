// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace limitcurve::godobject::test {
namespace {

/// Points of a boundary from end to end: by twist, and for boundaries with faces the faces' points too.
template <class Boundary>
std::vector<UnitWrench> sample(const Boundary& boundary, int count) {
  std::vector<UnitWrench> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 0.5 * M_PI * i / count;
    points.push_back(boundary.along({std::cos(angle), boundary.moment_ratio() * std::sin(angle)}).wrench);
    points.push_back(boundary.wrench(SlipTwist::of_spin_fraction(double(i) / count)));
  }
  return points;
}

/// Trials outside a boundary: near it and far away, in all directions and on both axes, over six decades of stiffness.
template <class Body>
void for_random_trials(double moment_ratio, int count, Body&& body) {
  Random random(20240607);
  for (int i = 0; i < count; ++i) {
    const double angle = i % 10 == 0 ? 0.0 : i % 10 == 1 ? 0.5 * M_PI : random.uniform(0.0, 0.5 * M_PI);
    const double length = i % 3 == 0 ? 1.0 + random.logarithmic(1e-9, 1.0) : random.logarithmic(1.0, 1e6);
    Trial trial;
    trial.wrench = {i % 10 == 1 ? 0.0 : length * std::cos(angle), length * moment_ratio * std::sin(angle)};
    trial.compliance_ratio = random.logarithmic(1e-3, 1e3) / (moment_ratio * moment_ratio);
    const RadiusLaw soft = RadiusLaw::power(0.003, random.uniform(0.01, 1.0 / 3.0));
    if (i % 2 == 1) trial.radius_law = &soft;
    trial.load = random.logarithmic(0.1, 10.0);
    trial.start = i % 4 == 0 ? random.uniform(0.0, 1.0) : -1.0;
    body(trial);
  }
}

const Law laws[] = {hertz(), uniform(), flat_punch(), parabolic(), cone()};

TEST(Projection, EndsOnTheBoundary) {
  for (const Law& law : laws) {
    for_each_boundary(law, [&](const auto& boundary, std::string_view name) {
      for_random_trials(law->moment_ratio(), 400, [&](const Trial& trial) {
        if (boundary.gauge(trial.wrench) <= 1.0) return;
        for (const Projected& projected : {Radial{}(boundary, trial), CCurve{}(boundary, trial), ClosestPoint{}(boundary, trial)}) {
          EXPECT_NEAR(boundary.gauge(projected.wrench), 1.0, 2e-14) << law->name() << ' ' << name;
        }
      });
    });
  }
}

// The closest point of a convex set is the one from which no other point of it is seen at less than a right angle:
// an oracle that shares nothing with the search.
TEST(ClosestPoint, NoPointOfTheBoundaryIsCloser) {
  for (const Law& law : laws) {
    for_each_boundary(law, [&](const auto& boundary, std::string_view name) {
      const std::vector<UnitWrench> others = sample(boundary, 200);
      for_random_trials(law->moment_ratio(), 300, [&](const Trial& trial) {
        if (boundary.gauge(trial.wrench) <= 1.0) return;
        const UnitWrench at = ClosestPoint{}(boundary, trial).wrench;
        const double over_force = trial.wrench.force - at.force;
        const double over_moment = trial.compliance_ratio * (trial.wrench.moment - at.moment);
        for (const UnitWrench& other : others) {
          const double scalar = over_force * (other.force - at.force) + over_moment * (other.moment - at.moment);
          // The table is convex to its tolerance only; what is over is a difference of numbers near 1.
          const double slack = name == "table" ? 1e-8 : 1e-11;
          const double rounding = 1e-15 * (1.0 + trial.compliance_ratio);
          ASSERT_LE(scalar, slack * (over_force + over_moment) + rounding)
              << law->name() << ' ' << name << " trial " << trial.wrench.force << ' ' << trial.wrench.moment << " chi "
              << trial.compliance_ratio;
        }
      });
    });
  }
}

TEST(ClosestPoint, SlipIsNormalToTheBoundary) {
  for (const Law& law : laws) {
    const ExactCurve curve(law);
    for_random_trials(law->moment_ratio(), 400, [&](const Trial& trial) {
      if (curve.gauge(trial.wrench) <= 1.0 + 1e-6) return;
      const auto [outside, slips, wrench, slip, start, piece] = ClosestPoint{}(curve, trial);
      EXPECT_TRUE(outside);
      const double slide = trial.wrench.force - wrench.force;
      const double spin = trial.compliance_ratio * (trial.wrench.moment - wrench.moment);
      EXPECT_NEAR(spin / (slide + spin), slip.spin_fraction(), 1e-7) << law->name();
    });
  }
}

TEST(ClosestPoint, FindsTheSameFromEveryStart) {
  for (const Law& law : laws) {
    for_each_boundary(law, [&](const auto& boundary, std::string_view name) {
      for_random_trials(law->moment_ratio(), 100, [&](Trial trial) {
        if (boundary.gauge(trial.wrench) <= 1.0) return;
        trial.start = -1.0;
        const UnitWrench cold = ClosestPoint{}(boundary, trial).wrench;
        for (const double start : {1e-300, 1e-9, 0.1, 0.5, 0.9, 1.0 - 1e-16}) {
          trial.start = start;
          const UnitWrench warm = ClosestPoint{}(boundary, trial).wrench;
          EXPECT_NEAR(warm.force, cold.force, 1e-10) << law->name() << ' ' << name << " from " << start;
          EXPECT_NEAR(warm.moment, cold.moment, 1e-10) << law->name() << ' ' << name << " from " << start;
        }
      });
    });
  }
}

// Under springs so unlike, what is searched for a root first rises from a zero that rounding makes of it.
TEST(ClosestPoint, OfATrialFarBesideTheCurveIsThatOfItsMoment) {
  const Table table = Table::build(hertz(), 1e-6);
  for (const double chi : {1e220, 6.6e262}) {
    for (const double start : {-1.0, 1e-160, 2.6e-26, 1e-9, 0.3, 1.0, 1.7, 2.0}) {
      const Foot foot = table.closest({1e100, 0.43}, chi, 1.0 / chi, start);
      EXPECT_NEAR(foot.wrench.moment, 0.43, 1e-12) << chi << ' ' << start;
      EXPECT_GT(foot.normal.slide * 1e100, foot.wrench.force) << chi << ' ' << start;
    }
  }
}

// A contact that has no last slip begins its search from guesses for its own metric, another from that slip: to the same point. With a
// dynamic moment coefficient of its own the metric is not that of rest.
TEST(ClosestPoint, IsTheSameFromGuessesAndFromASlip) {
  const Table table = Table::build(hertz(), 1e-8);
  FingerParameters constant;
  FingerParameters two_limits;
  two_limits.mu_dynamic = 0.4;
  FingerParameters two_metrics = two_limits;
  two_metrics.moment_coefficient = 0.004;
  two_metrics.moment_coefficient_dynamic = 0.0008;
  FingerParameters grows;
  grows.radius_law = RadiusLaw::power(0.004, 1.0 / 3.0);
  for (const FingerParameters& parameters : {constant, two_limits, two_metrics, grows}) {
    const Friction friction(table, parameters, ClosestPoint{});
    for (const double load : {0.5, 2.0}) {
      for (int i = 1; i < 40; ++i) {
        const double r = 5e-4 * load * (0.1 + 0.05 * i);
        const double rho = 0.02 * load * (2.1 - 0.05 * i);
        const auto guessed = friction.resolve(r, rho, load, 0.0);
        ASSERT_EQ(guessed.slips, true);
        for (const double start : {0.2, 1.0, 1.7}) {
          const auto searched = friction.resolve(r, rho, load, start);
          ASSERT_NEAR(guessed.force, searched.force, 1e-9 * load) << i << " from " << start;
          ASSERT_NEAR(guessed.moment, searched.moment, 1e-11 * load) << i << " from " << start;
        }
      }
    }
  }
}

// The paper's §3.1 (eqs. 10–11): force and moment clamped each on its own, and what is not clamped untouched.
TEST(ClosestPoint, OnTheBoxClampsEachOnItsOwn) {
  const double moment_max = hertz()->moment_ratio();
  const Box limits = box(1.0, moment_max);
  for_random_trials(moment_max, 2000, [&](const Trial& trial) {
    if (limits.gauge(trial.wrench) <= 1.0) return;
    const UnitWrench at = ClosestPoint{}(limits, trial).wrench;
    EXPECT_EQ(at.force, std::min(trial.wrench.force, 1.0));
    EXPECT_EQ(at.moment, std::min(trial.wrench.moment, moment_max));
  });
}

TEST(Radial, KeepsTheRatioOfForceAndMoment) {
  for (const Law& law : laws) {
    for_each_boundary(law, [&](const auto& boundary, std::string_view name) {
      for_random_trials(law->moment_ratio(), 200, [&](const Trial& trial) {
        const UnitWrench at = Radial{}(boundary, trial).wrench;
        EXPECT_NEAR(at.force * trial.wrench.moment, at.moment * trial.wrench.force, 1e-14 * (trial.wrench.force + trial.wrench.moment))
            << law->name() << ' ' << name;
      });
    });
  }
}

TEST(Radial, IsTheClosestPointOfTheEllipseWhenTheStiffnessesMatch) {
  const double m0 = hertz()->moment_ratio();
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  for_random_trials(m0, 500, [&](Trial trial) {
    if (ellipse.gauge(trial.wrench) <= 1.0) return;
    trial.compliance_ratio = 1.0 / (m0 * m0);  // k_r/k_l = (m₀a)²
    const UnitWrench radial = Radial{}(ellipse, trial).wrench;
    const UnitWrench closest = ClosestPoint{}(ellipse, trial).wrench;
    EXPECT_NEAR(radial.force, closest.force, 1e-14);
    EXPECT_NEAR(radial.moment, closest.moment, 1e-14);
  });
}

TEST(CCurve, IsRadialWhenTheRadiusIsConstant) {
  for_each_boundary(uniform(), [&](const auto& boundary, std::string_view) {
    for_random_trials(uniform()->moment_ratio(), 200, [&](Trial trial) {
      if (boundary.gauge(trial.wrench) <= 1.0) return;
      trial.radius_law = nullptr;
      const Projected radial = Radial{}(boundary, trial);
      const Projected c_curve = CCurve{}(boundary, trial);
      EXPECT_EQ(c_curve.wrench, radial.wrench);
    });
  });
}

// Paper, Fig. 5: the load whose p-curve runs through the trial, found here by bisection, has the same centre of rotation.
TEST(CCurve, KeepsTheCentreOfRotation) {
  for (const Law& law : laws) {
    const ExactCurve curve(law);
    for_random_trials(law->moment_ratio(), 200, [&](const Trial& trial) {
      if (curve.gauge(trial.wrench) <= 1.0 || trial.wrench.force == 0.0 || trial.wrench.moment < 1e-9) return;
      const double gamma = trial.radius_law != nullptr ? trial.radius_law->exponent() : 0.0;
      double low = 1.0;
      double high = 1e8;
      for (int i = 0; i < 200; ++i) {
        const double load = std::sqrt(low * high);
        const UnitWrench at_load{trial.wrench.force / load, trial.wrench.moment / std::pow(load, 1.0 + gamma)};
        (curve.gauge(at_load) > 1.0 ? low : high) = load;
      }
      const double load = std::sqrt(low * high);
      const UnitWrench at_load{trial.wrench.force / load, trial.wrench.moment / std::pow(load, 1.0 + gamma)};
      const double cor = curve.along(at_load).normal.cor() * std::pow(load, gamma);  // c/a(P)
      const UnitWrench expected = curve.wrench(SlipTwist::about_cor(cor));
      const UnitWrench found = CCurve{}(curve, trial).wrench;
      EXPECT_NEAR(found.force, expected.force, 1e-9) << law->name() << " gamma " << gamma;
      EXPECT_NEAR(found.moment, expected.moment, 1e-9) << law->name() << " gamma " << gamma;
    });
  }
}

// The same for measured radii, a power law of another exponent from sample to sample, falling ones too: the way from the trial's
// load to the p-curve's crosses kinks, and the radius is the measured one at both ends.
TEST(CCurve, KeepsTheCentreOfRotationOfAMeasuredRadius) {
  const std::array<LoadSample, 6> samples{{{0.2, 0.0015}, {0.5, 0.0021}, {1.0, 0.0022}, {2.0, 0.0035}, {5.0, 0.0031}, {40.0, 0.0077}}};
  const RadiusLaw radius = RadiusLaw::sampled(samples);
  Random random(77);
  for (const Law& law : laws) {
    const ExactCurve curve(law);
    for (int i = 0; i < 500; ++i) {
      Trial trial;
      trial.load = random.logarithmic(0.05, 20.0);
      trial.radius_law = &radius;
      trial.compliance_ratio = random.logarithmic(0.01, 100.0);
      trial.wrench = {random.logarithmic(1e-3, 1e2), random.logarithmic(1e-3, 1e2)};
      if (curve.gauge(trial.wrench) <= 1.0 + 1e-9) continue;
      const auto at_load = [&](double ratio) {
        const double growth = radius.radius(ratio * trial.load) / radius.radius(trial.load);
        return std::pair(UnitWrench{trial.wrench.force / ratio, trial.wrench.moment / (ratio * growth)}, growth);
      };
      double low = 1.0;
      double high = 1e8;
      for (int halving = 0; halving < 200; ++halving) {
        const double middle = std::sqrt(low * high);
        (curve.gauge(at_load(middle).first) > 1.0 ? low : high) = middle;
      }
      const auto [foot, growth] = at_load(std::sqrt(low * high));
      const double s = curve.along(foot).normal.cor();
      UnitWrench expected = curve.wrench(SlipTwist::about_cor(s * growth));
      // Where the same c would add force or moment, the same c/a counts.
      if (expected.force > trial.wrench.force || expected.moment > trial.wrench.moment) expected = curve.wrench(SlipTwist::about_cor(s));
      const UnitWrench found = CCurve{}(curve, trial).wrench;
      EXPECT_NEAR(found.force, expected.force, 1e-9) << law->name() << " load " << trial.load;
      EXPECT_NEAR(found.moment, expected.moment, 1e-9) << law->name() << " load " << trial.load;
    }
  }
}

TEST(Projection, NeverCreatesEnergy) {
  for (const Law& law : laws) {
    for_each_boundary(law, [&](const auto& boundary, std::string_view name) {
      for_random_trials(law->moment_ratio(), 400, [&](const Trial& trial) {
        if (boundary.gauge(trial.wrench) <= 1.0 + 1e-12) return;
        for (const Projected& projected : {Radial{}(boundary, trial), CCurve{}(boundary, trial), ClosestPoint{}(boundary, trial)}) {
          const UnitWrench at = projected.wrench;
          const double work =
              at.force * (trial.wrench.force - at.force) + at.moment * trial.compliance_ratio * (trial.wrench.moment - at.moment);
          EXPECT_GE(work, 0.0) << law->name() << ' ' << name;
          EXPECT_GE(projected.slip.slide, 0.0);
          EXPECT_GE(projected.slip.spin, 0.0);
        }
      });
    });
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
