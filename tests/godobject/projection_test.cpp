// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::projection_test {
namespace {

/// A trial outside a curve, and what a projection is given with it.
struct Outside {
  UnitTrial<double> trial;
  double last = 0.0;                      ///< curve parameter of the last slip
  const RadiusLaw* radius_law = nullptr;  ///< where the radius depends on the load
  double load = 1.0;
};

/// Where a projection ends.
struct End {
  UnitWrench wrench;
  SlipTwist slip;
  double parameter;
};

UnitWrench wrench_of(const UnitTrial<double>& trial) {
  return {trial.force, trial.moment};
}

End projected(const FingerCurve& curve, Projection projection, const Outside& outside) {
  FrictionLimits<double> limits{};
  limits.radius_law = outside.radius_law;
  limits.load = outside.load;
  if (curve.is_box()) {
    limits = {{1.0, 1.0}, {1.0, 1.0}, outside.trial.compliance_ratio};
    FrictionMemory<double> memory;
    const auto kept =
        apply_friction(curve.view(), projection, limits, {outside.trial.force, outside.trial.moment}, memory);
    EXPECT_TRUE(kept.slips) << outside.trial.force << ' ' << outside.trial.moment;
    return {{outside.trial.force * kept.force_fraction, outside.trial.moment * kept.moment_fraction},
            SlipTwist::about_cor(kept.cor),
            0.0};
  }
  const Projected<double> result = project(curve.view(), projection, limits, outside.trial, outside.last);
  EXPECT_TRUE(result.exceeds) << outside.trial.force << ' ' << outside.trial.moment;
  const auto kept = [](double ratio, double trial) { return trial > 0.0 ? ratio * trial : 0.0; };
  return {{kept(result.force_fraction, outside.trial.force), kept(result.moment_fraction, outside.trial.moment)},
          {result.slide, result.spin},
          result.parameter};
}

/// Points of a curve from end to end.
std::vector<UnitWrench> sample(const FingerCurve& curve, int count) {
  std::vector<UnitWrench> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / count;
    points.push_back(curve.along({std::cos(angle), curve.moment_ratio() * std::sin(angle)}).wrench);
    points.push_back(curve.wrench(SlipTwist::of_spin_fraction(double(i) / count)));
  }
  return points;
}

/// Trials outside a curve, by more than the onset of slip: near it and far away, in all directions and on both axes,
/// over six decades of stiffness.
template <class Body>
void for_random_trials(const FingerCurve& curve, int count, Body&& body) {
  Random random(20240607);
  const double moment_ratio = curve.moment_ratio();
  for (int i = 0; i < count; ++i) {
    const double angle = i % 10 == 0   ? 0.0
                         : i % 10 == 1 ? 0.5 * std::numbers::pi
                                       : random.uniform(0.0, 0.5 * std::numbers::pi);
    const double length = i % 3 == 0 ? 1.0 + random.logarithmic(1e-9, 1.0) : random.logarithmic(1.0, 1e6);
    Outside outside;
    outside.trial.force = i % 10 == 1 ? 0.0 : length * std::cos(angle);
    outside.trial.moment = length * moment_ratio * std::sin(angle);
    outside.trial.compliance_ratio = random.logarithmic(1e-3, 1e3) / (moment_ratio * moment_ratio);
    outside.trial.slip_from = slip_onset<double>;
    const RadiusLaw soft = RadiusLaw::power(0.003, random.uniform(0.01, 1.0 / 3.0));
    if (i % 2 == 1) outside.radius_law = &soft;
    outside.load = random.logarithmic(0.1, 10.0);
    outside.last = i % 4 == 0 ? random.uniform(0.0, 2.0) : 0.0;
    if (curve.gauge(wrench_of(outside.trial)) > 1.0 + 1e-11) body(outside);
  }
}

const Law laws[] = {hertz(), uniform(), flat_punch(), parabolic(), cone()};

/// Every kind of curve of every law.
template <class Body>
void for_each_curve_of_laws(Body&& body) {
  for (const Law& law : laws) for_each_curve(law, body);
}

// The closest point of a convex set is the one from which no other point of it is seen at less than a right angle:
// an oracle that shares nothing with the search.
TEST(ClosestPoint, NoPointOfTheCurveIsCloser) {
  for_each_curve_of_laws([](const FingerCurve& curve) {
    const std::vector<UnitWrench> others = sample(curve, 200);
    for_random_trials(curve, 300, [&](const Outside& outside) {
      const UnitTrial<double>& trial = outside.trial;
      const UnitWrench at = projected(curve, Projection::closest_point, outside).wrench;
      const double over_force = trial.force - at.force;
      const double over_moment = trial.compliance_ratio * (trial.moment - at.moment);
      for (const UnitWrench& other : others) {
        const double scalar = over_force * (other.force - at.force) + over_moment * (other.moment - at.moment);
        // What is over is a difference of numbers near 1.
        const double rounding = 1e-15 * (1.0 + trial.compliance_ratio);
        ASSERT_LE(scalar, 1e-11 * (over_force + over_moment) + rounding)
            << " trial " << trial.force << ' ' << trial.moment << " chi " << trial.compliance_ratio;
      }
    });
  });
}

TEST(ClosestPoint, SlipIsNormalToTheCurve) {
  for (const Law& law : laws) {
    const FingerCurve curve = exact_curve(law);
    for_random_trials(curve, 400, [&](const Outside& outside) {
      const UnitTrial<double>& trial = outside.trial;
      if (curve.gauge(wrench_of(trial)) <= 1.0 + 1e-6) return;
      const End end = projected(curve, Projection::closest_point, outside);
      const double slide = trial.force - end.wrench.force;
      const double spin = trial.compliance_ratio * (trial.moment - end.wrench.moment);
      EXPECT_NEAR(spin / (slide + spin), end.slip.spin_fraction(), 1e-7) << law->name();
    });
  }
}

TEST(ClosestPoint, FindsTheSameFromEveryStart) {
  for_each_curve_of_laws([](const FingerCurve& curve) {
    for_random_trials(curve, 100, [&](Outside outside) {
      outside.last = 0.0;
      const UnitWrench cold = projected(curve, Projection::closest_point, outside).wrench;
      for (const double last : {1e-300, 1e-9, 0.1, 0.9, 1.0, 1.1, 1.9, 2.0 - 1e-15}) {
        outside.last = last;
        EXPECT_LE(apart(projected(curve, Projection::closest_point, outside).wrench, cold), 1e-10) << " from " << last;
      }
    });
  });
}

TEST(Radial, KeepsTheDirection) {
  for_each_curve_of_laws([](const FingerCurve& curve) {
    if (curve.is_box()) return;
    for_random_trials(curve, 200, [&](const Outside& outside) {
      const UnitTrial<double>& trial = outside.trial;
      const UnitWrench at = projected(curve, Projection::radial, outside).wrench;
      EXPECT_NEAR(at.force * trial.moment, at.moment * trial.force, 1e-14 * (trial.force + trial.moment));
    });
  });
}

TEST(CCurve, IsRadialWhenTheRadiusIsConstant) {
  for_each_curve(uniform(), [&](const FingerCurve& curve) {
    if (curve.is_box()) return;
    for_random_trials(curve, 200, [&](Outside outside) {
      outside.radius_law = nullptr;
      EXPECT_EQ(projected(curve, Projection::c_curve, outside).wrench,
                projected(curve, Projection::radial, outside).wrench);
    });
  });
}

// Paper, Fig. 5: the load whose p-curve passes through the trial (here by bisection) has the same
// centre of rotation; for measured radii, a power law of another exponent from sample to sample.
TEST(CCurve, KeepsTheCentreOfRotation) {
  const std::array<LoadSample, 6> samples{
      {{0.2, 0.0015}, {0.5, 0.0021}, {1.0, 0.0022}, {2.0, 0.0035}, {5.0, 0.0031}, {40.0, 0.0077}}};
  const RadiusLaw radius = RadiusLaw::sampled(samples);
  Random random(77);
  for (const Law& law : laws) {
    const ExactCurve curve(law);
    const FingerCurve table = exact_curve(law);
    for (int i = 0; i < 500; ++i) {
      Outside outside;
      outside.load = random.logarithmic(0.05, 20.0);
      outside.radius_law = &radius;
      outside.trial.compliance_ratio = random.logarithmic(0.01, 100.0);
      outside.trial.force = random.logarithmic(1e-3, 1e2);
      outside.trial.moment = random.logarithmic(1e-3, 1e2);
      outside.trial.slip_from = slip_onset<double>;
      const UnitTrial<double>& trial = outside.trial;
      if (curve.gauge(wrench_of(trial)) <= 1.0 + 1e-9) continue;
      const auto at_load = [&](double ratio) {
        const double growth = radius.radius(ratio * outside.load) / radius.radius(outside.load);
        return std::pair(UnitWrench{trial.force / ratio, trial.moment / (ratio * growth)}, growth);
      };
      double low = 1.0;
      double high = 1e8;
      for (int halving = 0; halving < 200; ++halving) {
        const double middle = std::sqrt(low * high);
        (curve.gauge(at_load(middle).first) > 1.0 ? low : high) = middle;
      }
      const auto [foot, growth] = at_load(std::sqrt(low * high));
      const double s = curve.along(foot).normal.cor();
      const UnitWrench expected = curve.wrench(SlipTwist::about_cor(s * growth));
      EXPECT_LE(apart(projected(table, Projection::c_curve, outside).wrench, expected), 1e-9)
          << law->name() << " load " << outside.load;
    }
  }
}

// Along an arc of trials the result has no jump, however fast the radius grows with the load: the largest change on the
// arc, halved forty times, vanishes. Where the same c would add force, as for pressures heaped at the rim, the force
// stays, and the end is on the curve.
TEST(CCurve, IsContinuousInTheTrial) {
  int kept = 0;
  for (const char* const name : {"hertz", "uniform", "flat-punch", "power:n=-0.7"}) {
    const ExactCurve curve(parse_law(name));
    const FingerCurve table = exact_curve(parse_law(name));
    for (const double gamma : {-0.3, 1.0 / 3.0, 0.7, 0.9, 1.0}) {
      const RadiusLaw radius =
          RadiusLaw::sampled(std::array<LoadSample, 2>{{{1.0, 0.005}, {2.0, 0.005 * std::exp2(gamma)}}});
      for (const double length : {1.2, 2.0, 5.0, 100.0}) {
        const auto at = [&](double angle) {
          Outside outside;
          outside.trial = {length * std::sin(angle), length * table.moment_ratio() * std::cos(angle), 1.0,
                           slip_onset<double>};
          outside.radius_law = &radius;
          const UnitWrench end = projected(table, Projection::c_curve, outside).wrench;
          if (end.force > outside.trial.force * (1.0 - 1e-13) && angle > 0.0) {
            EXPECT_NEAR(curve.gauge(end), 1.0, 1e-9) << name << ' ' << gamma << ' ' << angle;
            ++kept;
          }
          return end;
        };
        constexpr int parts = repetitions(400, 40);
        for (int i = 0; i < parts; ++i) {
          double low = 0.5 * std::numbers::pi * i / parts;
          double high = 0.5 * std::numbers::pi * (i + 1) / parts;
          UnitWrench from = at(low);
          UnitWrench to = at(high);
          if (apart(from, to) < 0.02) continue;
          for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (low + high);
            const UnitWrench between = at(middle);
            const bool first = apart(from, between) > apart(between, to);
            (first ? high : low) = middle;
            (first ? to : from) = between;
          }
          ASSERT_LT(apart(from, to), 1e-9) << name << " gamma " << gamma << " length " << length << " angle " << low;
        }
      }
    }
  }
  EXPECT_GT(kept, 100);
}

TEST(Projection, EndsOnTheCurveAndNeverCreatesEnergy) {
  for (const Law& law : laws) {
    for_each_curve_and_projection(law, [&](const FingerCurve& curve, Projection projection) {
      for_random_trials(curve, 400, [&](const Outside& outside) {
        const UnitTrial<double>& trial = outside.trial;
        const auto [at, slip, parameter] = projected(curve, projection, outside);
        const double work =
            at.force * (trial.force - at.force) + at.moment * trial.compliance_ratio * (trial.moment - at.moment);
        EXPECT_NEAR(curve.gauge(at), 1.0, 2e-14);
        EXPECT_GE(work, 0.0);
        EXPECT_GE(slip.slide, 0.0);
        EXPECT_GE(slip.spin, 0.0);
        EXPECT_GE(parameter, 0.0);
        EXPECT_LE(parameter, 2.0);
      });
    });
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::projection_test
