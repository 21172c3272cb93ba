// SPDX-License-Identifier: MIT
#include "limitcurve/patch/disc_models.hpp"
#include "patch_cases.hpp"

namespace limitcurve::test {
namespace {

// What docs/which_number.md advises for engines without a moment at a point. The limit is weakest where a ball does not
// move.
TEST(DiscModels, ThreeBallsAreUpTo13PercentTooWeak) {
  const ExactCurve hertz_curve(hertz());
  const double m0 = hertz_curve.moment_ratio();
  const double half = m0 * std::sqrt(3.0) / 2.0;
  const Patch balls =
      Patch::points(std::vector<PatchLoad>{{m0, 0.0, 1.0}, {-m0 / 2.0, half, 1.0}, {-m0 / 2.0, -half, 1.0}});
  const auto gauge = [&](const PatchTwist& twist) {
    const PatchWrench wrench = balls.wrench(twist);
    return hertz_curve.gauge({std::hypot(wrench.fx, wrench.fy), std::fabs(wrench.moment)});
  };
  EXPECT_NEAR(gauge(about({m0, 0.0})), 1.0 - 0.13, 0.005);
  for (const PatchTwist& twist : twists(m0, 20000, -1.0, 1.0)) {
    EXPECT_GT(gauge(twist), 1.0 - 0.135);
    EXPECT_LT(gauge(twist), 1.01);
  }
}

DiscModel model(const std::vector<DiscModel>& all, std::string_view name) {
  return *std::find_if(all.begin(), all.end(), [name](const DiscModel& one) { return one.name.starts_with(name); });
}

TEST(DiscModels, OfADiscAreTheDiscAndTheEllipse) {
  for (const std::string name : {"hertz", "uniform", "cone"}) {
    const Law law = parse_law(name);
    const std::vector<DiscModel> models = disc_models(Patch::ellipse(law, 0.004, 0.004));
    for (const char* kind : {"disc:", "disc-equal-area:"}) {
      const DiscModel disc = model(models, kind + name);
      EXPECT_NEAR(disc.parameter / 0.004, 1.0, 1e-9) << kind << name;
      EXPECT_LT(disc.error.max_error, 1e-9) << kind << name;
      EXPECT_LT(disc.error.max_cor_error, 1e-6) << kind << name;
    }
    const CurveError ellipse = curve_error(Ellipse::through_intercepts(law->moment_ratio()), ExactCurve(law));
    EXPECT_NEAR(model(models, "ellipsoid").error.max_over_estimate, ellipse.max_over_estimate, 1e-6) << name;
    EXPECT_NEAR(model(models, "ellipsoid").error.max_cor_error, ellipse.max_cor_error, 1e-4) << name;
  }
  EXPECT_NEAR(model(disc_models(Patch::ellipse(hertz(), 0.008, 0.004)), "ellipsoid").error.max_over_estimate, 0.1009,
              6e-5);
  EXPECT_NEAR(model(disc_models(Patch::ellipse(hertz(), 0.020, 0.004)), "ellipsoid").error.max_over_estimate, 0.1217,
              6e-5);
}

TEST(DiscModels, TheBestDiscIsBalancedAndBetterThanThatOfEqualArea) {
  const std::vector<std::pair<Patch, double>> cases{{Patch::rectangle(0.02, 0.01), std::sqrt(2e-4 / std::numbers::pi)},
                                                    {Patch::ellipse(hertz(), 0.02, 0.005), 0.01},
                                                    {Patch::rectangle(1.0, 1.0), std::sqrt(1.0 / std::numbers::pi)},
                                                    {Patch::rectangle(1e30, 1e30), std::sqrt(1e60 / std::numbers::pi)}};
  for (const auto& [patch, radius] : cases) {
    const std::vector<DiscModel> models = disc_models(patch);
    const CurveError best = model(models, "disc:").error;
    const DiscModel equal_area = model(models, "disc-equal-area:");
    EXPECT_NEAR(equal_area.parameter / radius, 1.0, 1e-9) << radius;
    EXPECT_LT(best.max_error, equal_area.error.max_error) << radius;
    EXPECT_NEAR(best.max_over_estimate / best.max_under_estimate, 1.0, 1e-3) << radius;
  }
  EXPECT_NEAR(
      model(disc_models(Patch::ellipse(cone(), 0.02, 0.005).orthotropic(2.0, 0.5)), "disc-equal-area:").parameter, 0.01,
      1e-11);
}

// The over-estimate has a sharp maximum where the COR is on a point that bears much of the load: there H lacks that
// point's term.
TEST(DiscModels, OfPointsAreTriedWithTheCorOnEachPoint) {
  std::mt19937 bits(7);
  const auto uniform = [&bits] { return std::generate_canonical<double, 53>(bits); };
  for (std::size_t set = 0; set < 3; ++set) {
    std::vector<PatchLoad> loads(3 + set);
    for (PatchLoad& point : loads) point = {uniform(), uniform(), 0.1 + uniform()};
    const auto [mx, my] = set % 2 == 0 ? std::pair{1.0, 1.0} : std::pair{1.7, 0.6};
    const Patch patch = Patch::points(loads).orthotropic(mx, my);
    const DiscModel ellipsoid = disc_models(patch).back();
    ASSERT_EQ(ellipsoid.name, "ellipsoid");
    for (const PatchLoad& point : loads) {
      const PatchPoint cor{point.x - patch.centre().x, point.y - patch.centre().y};
      const double there = std::hypot(mx * cor.y, my * cor.x, patch.moment_ratio()) / patch.power(about(cor)) - 1.0;
      EXPECT_GE(ellipsoid.error.max_over_estimate, there - 1e-9) << set;
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
