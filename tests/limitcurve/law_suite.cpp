// SPDX-License-Identifier: MIT
// What every pressure law must satisfy, one test a requirement, instantiated for every kind of law.
#include "limitcurve/quadrature/evaluators.hpp"
#include "reference.hpp"
#include "tests/function_law.hpp"
#include "tests/limitcurve/shared.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace limitcurve::test {

namespace {

/// By what `evaluate` and the suite's own integrals may differ where long double is double.
constexpr double lost = accuracy::has_extended ? 0.0 : accuracy::evaluate_by_quadrature;

/// The law of a string, or one that no string names: a ring-shaped pressure as a function, with a kink.
Law law_of(const std::string& text) {
  if (text != "function") return parse_law(text);
  return law_of_function("function", [](Extended rho) { return rho < 0.6L ? 0.2L + rho * rho : 1.4L * (1 - rho); },
                         {0, 0.6L, 1});
}

class LawSuite : public testing::TestWithParam<std::string> {
 protected:
  const Law law_ = law_of(GetParam());

  /// In double the integral below begins too far from a rim where the pressure is nearly too steep to be integrated.
  bool has_witness() const { return accuracy::has_extended || law_->rim_exponent() > -0.9L; }
#define SKIP_WITHOUT_WITNESS() \
  if (!has_witness()) GTEST_SKIP() << "the reference has too few digits where long double is double"

  /// ∫ g(ρ)·weight(ρ) dρ by Boost's quadrature from the pressure alone: an independent reference for the evaluators.
  template <class Weight>
  long double integrate_pressure(Weight&& weight) const {
    static boost::math::quadrature::tanh_sinh<long double> quadrature(15);
    const std::vector<Extended>& breaks = law_->breaks();
    const long double outer = breaks.back();
    long double sum = 0.0L;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const long double left = breaks[i];
      const long double right = breaks[i + 1];
      sum += quadrature.integrate(
          [&](long double x, long double complement) {
            // Boost's complement is the distance from the nearer end, negative at the left one.
            const bool near_right = complement > 0.0L;
            const long double radius = near_right ? x : left - complement;
            const long double rim = near_right ? (outer - right) + complement : outer - radius;
            return law_->density(RadialPosition<Extended>{radius, rim}) * std::pow(rim, law_->rim_exponent()) *
                   weight(radius);
          },
          left, right, 1e-17L);
    }
    return sum;
  }

  /// Unit wrench in extended precision, for differences.
  UnitForces<Extended> extended(Extended s) const {
    if (const auto forces = law_->closed(s)) return *forces;
    return evaluators::ring(*law_, s).forces;
  }

  /// The length over which the law's curve changes: 1, but where the law has no rim.
  double scale() const {
    return static_cast<double>(law_->moment_ratio());
  }
};

TEST_P(LawSuite, NameParsesToAnEqualLaw) {
  const Law again = law_of(law_->name());
  EXPECT_EQ(again->name(), law_->name());
  for (const double s : {0.0, 0.3, 1.0, 2.0, inf}) EXPECT_EQ(again->evaluate(s).wrench, law_->evaluate(s).wrench) << s;
}

TEST_P(LawSuite, BreaksIncreaseFromTheCentre) {
  const auto& breaks = law_->breaks();
  ASSERT_GE(breaks.size(), 2U);
  EXPECT_EQ(breaks.front(), 0.0L);
  for (std::size_t i = 1; i < breaks.size(); ++i) EXPECT_GT(breaks[i], breaks[i - 1]);
}

TEST_P(LawSuite, CarriesUnitLoad) {
  SKIP_WITHOUT_WITNESS();
  EXPECT_NEAR(static_cast<double>(integrate_pressure([](long double rho) { return 2.0L * rho; }) - 1.0L), 0.0,
              1e-15 + lost);
}

TEST_P(LawSuite, PureTwistNeedsTheMeanRadius) {
  SKIP_WITHOUT_WITNESS();
  const auto mean_radius = static_cast<double>(integrate_pressure([](long double rho) { return 2.0L * rho * rho; }));
  EXPECT_NEAR(law_->moment_ratio() / mean_radius, 1.0, 1e-15 + lost);
  EXPECT_EQ(law_->evaluate(0.0).wrench.force, 0.0);
}

/// s → 0: f ≈ (V₀/2)s with V₀ = 2π(a/P)∫ p dr, that is V₀/2 = ∫ g dρ.
TEST_P(LawSuite, ForceStartsAsThePressureOnADiameter) {
  SKIP_WITHOUT_WITNESS();
  if (law_->name() == "uniform-wear") GTEST_SKIP() << "infinite at the centre: UniformWear.HasItsClosedForms";
  const auto slope = static_cast<double>(integrate_pressure([](long double) { return 1.0L; }));
  EXPECT_NEAR(law_->evaluate(0.0).force_slope / slope, 1.0, 1e-14 + lost);
  EXPECT_NEAR(law_->evaluate(1e-200).wrench.force / (1e-200 * slope), 1.0, 1e-14 + lost);
}

TEST_P(LawSuite, PureSlidingNeedsTheWholeForce) {
  const WrenchEstimate estimate = law_->evaluate(inf);
  EXPECT_EQ(estimate.wrench.force, 1.0);
  EXPECT_EQ(estimate.wrench.moment, 0.0);
  EXPECT_EQ(estimate.force_slope, 0.0);
}

/// s → ∞: m ≈ ⟨ρ²⟩/(2s), df/ds ≈ ⟨ρ²⟩/(2s³): in relative terms, where textbook forms have no digit left.
TEST_P(LawSuite, MomentFarFromTheContactIsThatOfTheMeanSquareRadius) {
  SKIP_WITHOUT_WITNESS();
  const auto mean_square =
      static_cast<double>(integrate_pressure([](long double rho) { return 2.0L * rho * rho * rho; }));
  for (const double far : {1e8, 1e100}) {
    const double s = far * scale();
    const WrenchEstimate estimate = law_->evaluate(s);
    EXPECT_NEAR(estimate.wrench.moment * s / (0.5 * mean_square), 1.0, 2e-15 + lost) << s;
    EXPECT_NEAR(estimate.force_slope * s * s * s / (0.5 * mean_square), 1.0, 2e-15 + lost) << s;
    EXPECT_NEAR(estimate.wrench.force, 1.0, 1.2e-16 + lost) << s;
  }
}

/// The curve is convex with the slip twist as its normal: between any two points of it the chord's slope lies between
/// the normals at its ends, s₁ ≤ −Δm/Δf ≤ s₂. No step size, no truncation: only rounding is forgiven.
TEST_P(LawSuite, ChordsLieBetweenTheNormalsAtTheirEnds) {
  const double step = law_->allows(Method::closed) ? 1.05 : 1.3;
  double last_s = 1e-4 * scale();
  UnitWrench last = law_->evaluate(last_s).wrench;
  for (double s = last_s * step; s < 1e4 * scale(); s *= step) {
    const UnitWrench here = law_->evaluate(s).wrench;
    const double rise = here.force - last.force;
    const double fall = last.moment - here.moment;
    const double rounding = 2.3e-16;
    const double forgiven = 2.0 * rounding * (last.moment + s * here.force);
    EXPECT_GE(rise, -rounding) << s;
    EXPECT_GE(fall, -rounding * last.moment) << s;
    EXPECT_GE(fall, last_s * rise - forgiven) << s;
    EXPECT_LE(fall, s * rise + forgiven) << s;
    last_s = s;
    last = here;
  }
}

/// df/ds and dm/ds = −s df/ds, against central differences of fourth order in extended precision.
TEST_P(LawSuite, SlopesAreThoseOfTheCurve) {
  int checked = 0;
  for (const double in_scale : {1e-2, 0.1, 0.5, 0.9, 1.1, 1.3, 2.5, 10.0}) {
    const double s = in_scale * scale();
    const Extended place = s;
    const Extended h = 1e-3L * place;
    // Not across points where the pressure is not analytic.
    const auto near = [&](Extended break_point) { return break_point > 0 && std::fabs(place - break_point) < 50 * h; };
    if (std::any_of(law_->breaks().begin(), law_->breaks().end(), near)) continue;
    const auto [f2, m2, d2] = extended(place + 2 * h);
    const auto [f1, m1, d1] = extended(place + h);
    const auto [g1, n1, e1] = extended(place - h);
    const auto [g2, n2, e2] = extended(place - 2 * h);
    const auto force_slope = static_cast<double>((8 * (f1 - g1) - (f2 - g2)) / (12 * h));
    const auto moment_slope = static_cast<double>((8 * (m1 - n1) - (m2 - n2)) / (12 * h));
    const double slope = law_->evaluate(s).force_slope;
    const auto rounding = [&](Extended value) { return static_cast<double>(1e-16L * value / h); };
    EXPECT_NEAR(force_slope, slope, 1e-7 * slope + rounding(f1)) << s;
    EXPECT_NEAR(moment_slope, -s * slope, 1e-7 * s * slope + rounding(m1)) << s;
    ++checked;
  }
  EXPECT_GE(checked, 6);
}

TEST_P(LawSuite, LoopsAndReferencesAgree) {
  for (const double s : {0.0, 1e-300, 1e-9, 0.2, 0.999999, 1.0, 1.000001, 1.3, 1.5, 7.0, 1e9, 1e300, inf}) {
    const UnitForces<double> fast = law_->forces(s);
    const WrenchEstimate slow = law_->evaluate(s);
    const LoopBounds bounds = loop_bounds(*law_, s);
    EXPECT_TRUE(are_near_in_relative_terms(fast, slow.wrench, bounds.wrench)) << s;
    EXPECT_NEAR(fast.force_slope, slow.force_slope, bounds.slope * slow.force_slope) << s;
  }
}

/// F and M are linear in the pressure.
TEST_P(LawSuite, MixturesMixTheirWrenches) {
  const std::array<std::pair<double, Law>, 2> parts{{{1.0, law_}, {3.0, parabolic()}}};
  const Law mixed = mixture(parts);
  for (const double s : {0.0, 0.4, 1.0, 2.0, 50.0, inf}) {
    const UnitWrench one = law_->evaluate(s).wrench;
    const UnitWrench other = parabolic()->evaluate(s).wrench;
    const UnitWrench both = mixed->evaluate(s).wrench;
    const UnitWrench mean{0.25 * one.force + 0.75 * other.force, 0.25 * one.moment + 0.75 * other.moment};
    EXPECT_TRUE(are_near(both, mean, {2.3e-16, 2.3e-16 * both.moment})) << s;
  }
  const auto density_at_half = [](const PressureLaw& law) {
    const Extended rim = law.breaks().back() - 0.5L;
    return law.density(RadialPosition<Extended>{0.5L, rim}) * std::pow(rim, law.rim_exponent());
  };
  const Extended expected = 0.25L * density_at_half(*law_) + 0.75L * density_at_half(*parabolic());
  EXPECT_NEAR(static_cast<double>(density_at_half(*mixed) - expected), 0.0, 1e-15);
}

/// Errors are bounds ≥ 0, wrenches finite and in range, wherever the COR is.
TEST_P(LawSuite, NothingIsNotANumber) {
  for (const double s : {0.0, 5e-324, 1e-308, 1e-30, 1.0 - 1e-16, 1.0, 1.0 + 3e-16, 1e30, 1e300, 1.7e308, inf}) {
    for (const Method method : {Method::automatic, Method::ring, Method::punch}) {
      if (!law_->allows(method)) continue;
      SCOPED_TRACE(testing::Message() << to_string(method) << ' ' << s);
      const auto [wrench, error, force_slope] = law_->evaluate(s, method);
      EXPECT_TRUE(wrench.force >= 0.0 && wrench.force <= 1.0 + 2.3e-16 + lost) << wrench.force;
      EXPECT_TRUE(wrench.moment >= 0.0 && wrench.moment <= law_->moment_ratio() * (1.0 + 2.3e-16 + lost))
          << wrench.moment;
      EXPECT_TRUE(error.force >= 0.0 && error.force < 1e-12 && error.moment >= 0.0 && error.moment < 1e-12);
      if (!accuracy::has_extended && s > 0.0 && s < std::numeric_limits<double>::min())
        continue;  // as pressure_law.hpp says
      EXPECT_TRUE(force_slope >= 0.0 && force_slope < inf) << force_slope;
    }
  }
}

/// The grammar's example of every kind of law, and parameters near the ends of their ranges.
std::vector<std::string> tested_laws() {
  std::vector<std::string> laws(law_examples().begin(), law_examples().end());
  laws.insert(laws.end(),
              {"power:n=-0.99", "power:n=-0.6", "power:n=0.25", "power:n=40", "power:n=1000", "xydas-kao:k=0.2",
               "xydas-kao:k=1", "xydas-kao:k=1000", "xydas-kao:k=1000000", "gaussian:sigma=0.001", "gaussian:sigma=5",
               "mix:1*cone+2*gaussian:sigma=0.4+0.1*xydas-kao:k=3", "function"});
  return laws;
}

INSTANTIATE_TEST_SUITE_P(EveryLaw, LawSuite, testing::ValuesIn(tested_laws()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace

}  // namespace limitcurve::test
