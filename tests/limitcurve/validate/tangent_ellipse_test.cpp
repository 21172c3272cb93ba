// SPDX-License-Identifier: MIT
#include "limitcurve/validate/tangent_ellipse.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve {
namespace {

std::vector<std::string> laws_and_sharp_peaks() {
  std::vector<std::string> laws(law_examples().begin(), law_examples().end());
  for (const char* law : {"power:n=-0.9", "xydas-kao:k=0.05", "gaussian:sigma=50",
                          "mix:0.5*gaussian:sigma=0.05+0.5*uniform", "mix:0.2*power:n=-0.9+0.8*xydas-kao:k=0.1"}) {
    laws.emplace_back(law);
  }
  return laws;
}

class TangentEllipseOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Laws, TangentEllipseOf, testing::ValuesIn(laws_and_sharp_peaks()),
                         [](const auto& law) { return "law" + std::to_string(law.index); });

TEST_P(TangentEllipseOf, HasTheCurvesWrenchAndNormalAndIsAFixedPoint) {
  const Table table = Table::build(parse_law(GetParam()), 1e-8);
  const ExactCurve exact(parse_law(GetParam()));
  const double m0 = std::fmax(1.0, table.moment_ratio());
  const auto examples = law_examples();
  const double stated_error = std::find(examples.begin(), examples.end(), GetParam()) != examples.end() ? 2e-6 : 3e-4;
  for (double log_c = -9.0; log_c <= 9.0; log_c += 0.37) {
    const SlipTwist slip = SlipTwist::about_cor(std::pow(10.0, log_c));
    const TangentEllipse axes = tangent_ellipse(table, slip);
    const UnitWrench curve = table.wrench(slip);
    // What an engine with an elliptic cone finds for a slip: maximum dissipation.
    const UnitWrench engine = Ellipse(axes.p, axes.q).wrench(slip);
    const auto [f, m] = exact.wrench(slip);
    const double power = f * slip.slide + m * slip.spin;
    EXPECT_NEAR(axes.p / std::sqrt(f * power / slip.slide), 1.0,
                stated_error + (GetParam() == "uniform-wear" ? 1e-8 / f : 0.0))
        << log_c;
    EXPECT_NEAR(axes.q / std::sqrt(m * power / slip.spin), 1.0, stated_error) << log_c;
    EXPECT_TRUE(test::are_near(engine, curve, {1e-14, 1e-14 * m0})) << log_c;
    for (const TangentEllipse again : {tangent_ellipse(table, -engine.force, engine.moment, axes.p, axes.q),
                                       tangent_ellipse(table, curve.force, -curve.moment)}) {
      // Where the curve is steep or flat, a rounding of the wrench moves the place.
      EXPECT_NEAR(again.p / axes.p, 1.0, 1e-7) << log_c;
      EXPECT_NEAR(again.q / axes.q, 1.0, 1e-7) << log_c;
    }
  }
}

TEST_P(TangentEllipseOf, ConvergesToTheExactWrenchWhateverTheSceneImposes) {
  const Table table = Table::build(parse_law(GetParam()), 1e-8);
  const ExactCurve exact(parse_law(GetParam()));
  for (const bool is_slip_imposed : {true, false}) {
    for (const double c : {1e-3, 0.01, 0.1, 0.5, 1.0, 2.0, 10.0}) {
      const SlipTwist slip = SlipTwist::about_cor(c);
      const UnitWrench goal = exact.wrench(slip);
      TangentEllipse axes = tangent_ellipse(table, 0.0, 0.0);
      for (int updates = 0;; ++updates) {
        ASSERT_LT(updates, 60) << c << (is_slip_imposed ? " slip" : " wrench");
        const Ellipse engine(axes.p, axes.q);
        const UnitWrench found = is_slip_imposed ? engine.wrench(slip) : engine.along(goal).wrench;
        const double cor = found.force / (axes.p * axes.p) / (found.moment / (axes.q * axes.q));
        if (test::apart(found, goal) < 1e-6 && std::fabs(cor / c - 1.0) < 1e-3) break;
        axes = tangent_ellipse(table, found.force, found.moment, axes.p, axes.q);
      }
    }
  }
}

TEST_P(TangentEllipseOf, EndsAreTheirLimits) {
  const Table table = Table::build(parse_law(GetParam()), 1e-8);
  for (const bool slides : {false, true}) {
    const auto at = [&](double x) { return tangent_ellipse(table, slides ? SlipTwist{1.0, x} : SlipTwist{x, 1.0}); };
    const TangentEllipse end = at(0.0);
    for (const double x : {1e-160, 1e-307, 5e-324}) {
      EXPECT_NEAR(at(x).p / end.p, 1.0, 1e-9) << x;
      EXPECT_NEAR(at(x).q / end.q, 1.0, 1e-9) << x;
      const TangentEllipse split = tangent_ellipse(table, slides ? 1.0 : x, slides ? x : 1.0, 1.0, 1.0);
      EXPECT_NEAR(split.p / end.p, 1.0, 1e-9) << x;
      EXPECT_NEAR(split.q / end.q, 1.0, 1e-9) << x;
    }
    EXPECT_NEAR(slides ? end.p : end.q, slides ? 1.0 : table.moment_ratio(), 1e-15);
  }
}

TEST(TangentEllipse, AtRestIsTheUsualOneAndOfNaNIsNaN) {
  const Table table = Table::build(parse_law("hertz"), 1e-8);
  for (const TangentEllipse axes : {tangent_ellipse(table, 0.0, -0.0), tangent_ellipse(table, 0.0, 0.0, 1.0, 0.5),
                                    tangent_ellipse(table, SlipTwist{0.0, 0.0})}) {
    EXPECT_EQ(axes.p, 1.0);
    EXPECT_EQ(axes.q, table.moment_ratio());
  }
  for (const double bad : {test::nan, test::inf}) {
    for (const TangentEllipse axes :
         {tangent_ellipse(table, bad, 0.1), tangent_ellipse(table, 0.1, bad),
          tangent_ellipse(table, bad, 0.1, 1.0, 0.5), tangent_ellipse(table, 0.1, bad, 1.0, 0.5),
          tangent_ellipse(table, SlipTwist{bad, bad})}) {
      EXPECT_TRUE(std::isnan(axes.p) && std::isnan(axes.q)) << bad;
    }
  }
  EXPECT_TRUE(std::isnan(tangent_ellipse(table, 0.1, 0.1, test::nan, 0.5).p));
  EXPECT_TRUE(std::isnan(tangent_ellipse(table, SlipTwist{0.0, test::nan}).p));
  EXPECT_EQ(tangent_ellipse(table, SlipTwist{-0.3, 0.2}).p, tangent_ellipse(table, SlipTwist{0.3, -0.2}).p);
}

}  // namespace
}  // namespace limitcurve
