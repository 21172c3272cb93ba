// SPDX-License-Identifier: MIT
// The evaluators against one another: for random laws and CORs every two methods differ by no more than the sum of the
// errors they state.
#include "tests/function_law.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

class RandomCases {
 public:
  explicit RandomCases(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

  /// Any kind of law, with any parameter.
  Law law() {
    switch (random_() % 8) {
      case 0:
        return gaussian(log_uniform(0.01, 100.0));
      case 1:
        return cone();
      case 2:
        return power(-1.0 + log_uniform(1e-3, 0.5));
      case 3:
        return mixture(std::array<std::pair<double, Law>, 2>{
            {{uniform(0.1, 1.0), hertz()}, {uniform(0.1, 1.0), uniform_or_punch()}}});
      case 4:
        return std::array{hertz(), limitcurve::uniform(), parabolic(), flat_punch()}[random_() % 4];
      default:
        return power(-0.5 + log_uniform(1e-3, 40.0));
    }
  }

  /// A COR anywhere: all scales, and near the rim on either side.
  double cor() {
    switch (random_() % 3) {
      case 0:
        return log_uniform(1e-12, 1e12);
      case 1:
        return 1.0 + (random_() % 2 == 0 ? -1.0 : 1.0) * log_uniform(1e-15, 0.5);
      default:
        return uniform(0.0, 4.0);
    }
  }

 private:
  Law uniform_or_punch() { return random_() % 2 == 0 ? limitcurve::uniform() : flat_punch(); }

  std::mt19937_64 random_;
};

void expect_agreement(const Law& law, double s, Method one, Method other) {
  const WrenchEstimate a = law->evaluate(s, one);
  const WrenchEstimate b = law->evaluate(s, other);
  SCOPED_TRACE(testing::Message() << law->name() << " s = " << s << ' ' << to_string(one) << '/' << to_string(other));
  EXPECT_TRUE(are_near(a.wrench, b.wrench, {a.error.force + b.error.force, a.error.moment + b.error.moment}));
  EXPECT_NEAR(a.force_slope, b.force_slope, 1e-9 * a.force_slope + std::numeric_limits<double>::min());
}

/// The closed forms, either integral, and Boost's: 10⁴ laws and CORs, a study.
TEST(MethodAgreement, ClosedRingAndPunch) {
  RandomCases cases(1);
  int punches = 0;
  const int count = study_cases(10000, 500);
  for (int i = 0; i < count; ++i) {
    const Law law = cases.law();
    const double s = cases.cor();
    ASSERT_TRUE(law->allows(Method::closed)) << law->name();
    expect_agreement(law, s, Method::closed, Method::boost);
    if (i % 2 == 0 || !law->allows(Method::punch)) {
      expect_agreement(law, s, Method::closed, Method::ring);
    } else {
      expect_agreement(law, s, Method::closed, Method::punch);
      ++punches;
    }
  }
  EXPECT_GE(punches, count / 5);
}

/// Where there is no closed form, the rule and the elliptic integrals of a library, which share no integral with ours.
TEST(MethodAgreement, BoostAndRing) {
  RandomCases cases(4);
  const Law hollow =
      law_of_function("hollow", [](Extended rho) { return rho < 0.5L ? 1 + rho : 2 - 2 * rho; }, {0, 0.5L, 1});
  for (int i = 0; i < study_cases(3000, 300); ++i) {
    const Law law = i % 20 == 0 ? hollow : xydas_kao(cases.log_uniform(0.01, 1e6));
    const double s = i % 9 == 0 ? cases.log_uniform(1e-300, 1e300) : cases.cor();
    expect_agreement(law, s, Method::ring, Method::boost);
  }
  for (const double s : {0.0, inf}) expect_agreement(hertz(), s, Method::automatic, Method::boost);
  EXPECT_TRUE(std::isnan(hertz()->evaluate(nan, Method::boost).wrench.force));
}

/// Where there is no closed form, and where all three have one integral or two: the double integral of eq. (17).
TEST(MethodAgreement, DirectAndTheRest) {
  RandomCases cases(2);
  for (int i = 0; i < study_cases(36, 3); ++i) {
    const Law law = i % 3 == 0 ? xydas_kao(cases.log_uniform(0.01, 1e6)) : cases.law();
    const double s = cases.cor();
    expect_agreement(law, s, Method::direct, Method::ring);
    if (law->allows(Method::punch)) expect_agreement(law, s, Method::direct, Method::punch);
  }
}

/// Both sides of each switch between branches: the value does not jump by more than the curve moves.
TEST(MethodAgreement, BranchesMeet) {
  for (const Law& law :
       {hertz(), uniform(), parabolic(), flat_punch(), cone(), gaussian(0.4), power(2.3), power(-0.8)}) {
    // The rim; s² = 2, where the series takes over; and x² = (s/2σ)² = 40, where the Gaussian goes asymptotic.
    for (const double at : {1.0, std::sqrt(2.0), 0.8 * std::sqrt(40.0)}) {
      const double below = std::nextafter(at, 0.0);
      const double above = std::nextafter(at, 10.0);
      const UnitForces<double> low = law->forces(below);
      const UnitForces<double> high = law->forces(above);
      const double moved = high.force_slope * (above - below);
      EXPECT_LE(apart(high, UnitWrench{low.force + moved, low.moment - at * moved}), 1e-15) << law->name() << ' ' << at;
      // Below n = −½ the slope has a cusp at the rim.
      if (law->rim_exponent() < -0.5L) continue;
      EXPECT_NEAR(high.force_slope, low.force_slope, 1e-6 * low.force_slope) << law->name() << ' ' << at;
    }
  }
}

}  // namespace

}  // namespace limitcurve::test
