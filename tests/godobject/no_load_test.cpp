// SPDX-License-Identifier: MIT
// Without a load there is no friction: with dampers every fast lift-off has steps in contact under P = 0.
#include "godobject/friction.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::no_load_test {

/// A number that counts the cells of a table which it looks up: the evaluations of a search.
struct Counting {
  double value = 0.0;
  inline static int evaluations = 0;

  Counting() = default;
  Counting(double number) : value(number) {}
  friend Counting operator+(Counting a, Counting b) { return a.value + b.value; }
  friend Counting operator-(Counting a, Counting b) { return a.value - b.value; }
  friend Counting operator*(Counting a, Counting b) { return a.value * b.value; }
  friend Counting operator/(Counting a, Counting b) { return a.value / b.value; }
  friend Counting operator-(Counting a) { return -a.value; }
  friend auto operator<=>(Counting a, Counting b) = default;
  friend Counting abs(Counting a) { return std::fabs(a.value); }
  friend Counting sqrt(Counting a) { return std::sqrt(a.value); }
  friend Counting larger(Counting a, Counting b) { return a < b ? b : a; }
  friend Counting smaller(Counting a, Counting b) { return b < a ? b : a; }
  friend std::int64_t leading_bits(Counting a, int dropped) {
    ++evaluations;
    return arithmetic::leading_bits(a.value, dropped);
  }
  friend Projected<Counting> project_along_c_curve(const CurveView<double>&, const UnitTrial<Counting>&, Counting,
                                                   const RadiusLaw&, Counting) {
    return {};
  }
};

namespace {

/// Fingers whose radius is constant, or a power of the load or an interpolation that is 0 or infinite without a load.
std::vector<std::pair<std::string, FingerParameters>> fingers() {
  std::vector<std::pair<std::string, FingerParameters>> result{{"constant", parameters()}};
  const auto add = [&](const char* name, const RadiusLaw& law) {
    result.emplace_back(name, parameters());
    result.back().second.radius_law = law;
  };
  add("growing", RadiusLaw::power(0.005, 1.0 / 3.0));
  add("sampled, growing", RadiusLaw::sampled(std::vector<LoadSample>{{1.0, 0.004}, {2.0, 0.005}, {5.0, 0.007}}));
  add("sampled, falling", RadiusLaw::sampled(std::vector<LoadSample>{{1.0, 0.007}, {2.0, 0.005}, {5.0, 0.004}}));
  for (const double gamma : {-0.5, -0.1, 0.3, 1.0}) {
    result.emplace_back("gamma " + std::to_string(gamma), parameters());
    result.back().second.mu_r = 0.003;
    result.back().second.gamma = gamma;
  }
  return result;
}

TEST(NoLoad, LimitsAreNumbersAtEveryLoad) {
  for (const auto& [name, with] : fingers()) {
    const ContactLimits limits(with, 0.6);
    for (const double load : {0.0, std::numeric_limits<double>::denorm_min(), 1e-300, 1e-100, 1e-30, 1.0}) {
      const FrictionLimits<double> at = limits.at<double>(load, 25000.0);
      const double moment = at.sticking.force * at.sticking.radius;
      EXPECT_TRUE(std::isfinite(moment) && moment >= 0.0 && std::isfinite(at.sliding.force * at.sliding.radius))
          << name << ' ' << load;
      EXPECT_TRUE(at.load > 0.0 && at.sticking.radius <= 1e100) << name << ' ' << load;
      const FrictionLimits<float> single = limits.at<float>(static_cast<float>(load), 25000.0F);
      EXPECT_TRUE(std::isfinite(single.sticking.force * single.sticking.radius)) << name << ' ' << load;
    }
  }
}

// From one slip to the next the load falls to nothing, or to almost nothing, and comes back.
TEST(NoLoad, ASearchIsShortAtEveryLoad) {
  const FingerCurve curve = make_finger_curve(CurveKind::table, hertz(), 1e-8);
  for (const Projection projection : {Projection::closest_point, Projection::radial}) {
    for (const double growth : {1.0 / 3.0, 1.0, -0.2}) {
      Random random(1);
      FrictionMemory<Counting> memory;
      int worst = 0;
      for (int i = 0; i < 30'000; ++i) {
        const double load = i % 3 == 0   ? random.uniform(0.1, 3.0)
                            : i % 3 == 1 ? random.logarithmic(1e-300, 1e3)
                                         : std::max(random.uniform(-3.0, 3.0), 0.0);
        const FrictionLimit<Counting> limit{0.6 * load, std::min(0.005 * std::pow(load, growth), 1e100)};
        const FrictionTrial<Counting> trial{random.logarithmic(1e-3, 10.0), random.logarithmic(1e-6, 0.1)};
        Counting::evaluations = 0;
        const auto result = apply_friction(curve.view(), projection, {limit, limit, 1000.0 / 0.036}, trial, memory);
        ASSERT_FALSE(load == 0.0 && !result.slips) << i;
        worst = std::max(worst, Counting::evaluations);
      }
      EXPECT_GE(worst, 5) << "it counts";
      EXPECT_LE(worst, 16) << static_cast<int>(projection) << ' ' << growth;
    }
  }
}

// A slip and a twist under load, then a lift-off so fast that the damper takes all load, still in contact: nothing is
// kept, and the slip turns about r/rho, for the springs relax.
TEST(NoLoad, NoFrictionAndTheCentreOfTheWholeDeflection) {
  for (const auto& [name, plain] : fingers()) {
    FingerParameters with = plain;
    with.damping = 10.0;
    for_each_curve_and_projection(hertz(), [&, &name = name](const FingerCurve& curve, Projection projection) {
      SCOPED_TRACE(name);
      SoftFinger finger(curve, with, projection);
      finger.update(on_plane(0.0, 0.0, 2e-3), 0.0, 1e-3);
      for (int i = 1; i <= 20; ++i) finger.update(on_plane(2e-5 * i, 0.0, 2e-3), 4e-3 * i, 1e-3);
      const FingerState before = finger.state();
      ASSERT_GT(before.output.force.norm() + std::fabs(before.output.moment), 0.0);
      const FingerOutput output = finger.update(on_plane(4e-4, 0.0, 1e-3), 0.08, 1e-3);
      EXPECT_EQ(finger.state().limit_load, 0.0);
      EXPECT_LE(output.force.norm(), 1e-30);
      EXPECT_LE(std::fabs(output.moment), 1e-30);
      EXPECT_EQ(to_string(output.state), "slip");
      // Springs and dampers of the step: trial wrench over their stiffness.
      const double stiffness = with.stiffness + with.damping / 1e-3;
      const double slide = finger.state().trial_force / stiffness;
      const double turn = finger.state().trial_moment / with.twist_stiffness;
      EXPECT_NEAR(output.cor / (slide / turn), 1.0, 1e-9);
    });
  }
}

// A moment so small that it is 0 in units of its limit is no trial: it keeps its own, and no NaN.
TEST(NoLoad, AComponentBelowTheSmallestNumberIsNone) {
  for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
    const FrictionLimits<double> limits{{1e10, 0.005}, {1e10, 0.005}, 1e25};
    for (const FrictionTrial<double> trial :
         {FrictionTrial<double>{3e13, 2e-320}, FrictionTrial<double>{2e-320, 3e13}}) {
      FrictionMemory<double> memory;
      const FrictionResult<double> result = apply_friction(curve.view(), projection, limits, trial, memory);
      EXPECT_TRUE(result.slips && result.force_fraction >= 0.0 && result.force_fraction <= 1.0);
      EXPECT_TRUE(result.moment_fraction >= 0.0 && result.moment_fraction <= 1.0);
    }
  });
}

// From afar only the trial's direction counts: what friction keeps is on the limit, at every magnitude, with and
// without torsion.
TEST(NoLoad, ATrialFromAfarKeepsWhatANearerOneDoes) {
  for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
    for (const bool has_torsion : {true, false}) {
      FrictionLimits<double> limits{{2.0, 0.005}, {1.0, 0.005}, 25000.0};
      limits.has_torsion = has_torsion;
      const auto kept = [&](double scale, double lever) {
        FrictionMemory<double> memory;
        const FrictionTrial<double> trial{scale, -lever * scale};
        const FrictionResult<double> result = apply_friction(curve.view(), projection, limits, trial, memory);
        EXPECT_TRUE(result.slips);
        return Eigen::Vector2d(trial.force * result.force_fraction, trial.moment * result.moment_fraction / 0.005);
      };
      for (const double lever : {0.0, 1e-3, 4e-3, 1.0}) {
        const Eigen::Vector2d near = kept(1e30, lever);
        EXPECT_TRUE((lever > 0.0 && has_torsion) || std::fabs(near.x() - 1.0) <= 1e-12) << lever;
        for (const double scale : {1e59, 1e60, 1e61, 1e100, 1e200, 1e300}) {
          EXPECT_LE((kept(scale, lever) - near).norm(), 1e-7) << lever << ' ' << scale << ' ' << has_torsion;
        }
      }
    }
  });
}

// A limit that is NaN keeps no friction, whatever the curve.
TEST(NoLoad, ANaNKeepsNothing) {
#ifdef NDEBUG
  for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
    const FrictionLimits<double> limits{{nan, 0.005}, {nan, 0.005}, 25000.0};
    FrictionMemory<double> memory;
    const FrictionResult<double> result =
        apply_friction(curve.view(), projection, limits, FrictionTrial<double>{1.0, 0.01}, memory);
    EXPECT_LE(result.force_fraction + result.moment_fraction, 1e-30);
  });
#endif
}

}  // namespace
}  // namespace limitcurve::godobject::test::no_load_test
