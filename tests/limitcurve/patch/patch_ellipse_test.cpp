// SPDX-License-Identifier: MIT
#include "patch_cases.hpp"
#include "tests/function_law.hpp"

#include <boost/math/special_functions/ellint_2.hpp>

namespace limitcurve::test {
namespace {

void expect_ellipse(const char* law_name, double bound) {
  const Law law = parse_law(law_name);
  for (const double aspect : {1.0, 3.0, 20.0}) {
    const Patch patch = Patch::ellipse(law, aspect, 1.0);
    std::vector<PatchTwist> cases = twists(1.0, 2, -2.0, 2.0);
    for (const PatchPoint cor : {PatchPoint{0, 0},
                                 {aspect, 0},
                                 {0, 1},
                                 {0.3, 0},
                                 {0, 1.0 + 1e-9},
                                 {-aspect * 0.6, -0.8},
                                 {0, -0.999},
                                 {0.99999 * aspect, 0},
                                 {1.01 * aspect * 0.8, 1.01 * 0.6},
                                 {aspect * 0.28 * 0.9, 0.96 * 0.9}}) {
      cases.push_back(about(cor));
    }
    // 0.1 s each: every 31st, other ones for the next law and aspect, except in the whole study.
    static std::size_t turn = 0;
    const std::size_t stride = studies_are_whole() ? 1 : 31;
    for (const PatchTwist& twist : cases) {
      if (turn++ % stride != 0) continue;
      SCOPED_TRACE(testing::Message() << law_name << ' ' << aspect);
      expect_exact(patch, twist, ellipse_by_rays(*law, aspect, 1.0, twist), bound);
    }
  }
}

TEST(PatchEllipse, SmoothLawsAreTheIntegralOverRays) {
  for (const char* law : {"hertz", "flat-punch", "uniform", "parabolic", "cone", "power:n=2.3", "power:n=-0.3",
                          "power:n=0.2", "power:n=-0.5", "power:n=0.5"}) {
    expect_ellipse(law, accuracy::patch_ellipse);
  }
}

TEST(PatchEllipse, OtherLawsAreTheIntegralOverRays) {
  for (const char* law : {"xydas-kao:k=3", "xydas-kao:k=1", "gaussian:sigma=0.4", "mix:0.7*hertz+0.3*uniform",
                          "power:n=-0.9", "uniform-wear"}) {
    // In double the rays end too far from this rim: they give ten digits, while the patch gives the same 17 as
    // elsewhere.
    if (!accuracy::has_extended && parse_law(law)->rim_exponent() <= -0.9L) continue;  // as in law_suite.cpp
    expect_ellipse(law, accuracy::patch_ellipse_other);
  }
}

/// A law of the user, whatever it is called: 2ρ², or 0.5 and then 1.5 beyond ρ² = 0.5, a jump.
Law own_law(const std::string& name, bool jumps) {
  if (jumps) {
    return std::make_shared<FunctionLaw>(
        name, [](Extended rho) { return rho * rho < Extended(0.5) ? Extended(0.5) : Extended(1.5); },
        std::vector<Extended>{0, std::sqrt(Extended(0.5)), 1});
  }
  return std::make_shared<FunctionLaw>(
      name, [](Extended rho) { return 2 * rho * rho; }, std::vector<Extended>{0, 1});
}

TEST(PatchEllipse, ALawIsItsNumbersNotItsName) {
  for (const bool jumps : {false, true}) {
    const Patch own = Patch::ellipse(own_law("own", jumps), 0.005, 0.004);
    for (const char* name : {"hertz", "flat-punch", "uniform", "cone", "power:mine"}) {
      const Patch named = Patch::ellipse(own_law(name, jumps), 0.005, 0.004);
      EXPECT_EQ(named.moment_ratio(), own.moment_ratio()) << name;
      for (const PatchTwist& twist : twists(0.005, 10, -1.0, 1.0)) {
        const PatchFriction friction = named.about_origin(twist);
        EXPECT_EQ(friction.power, own.about_origin(twist).power) << name;
        EXPECT_GE(friction.error, accuracy::patch_ellipse_other) << name;
      }
    }
    const auto law = own_law("hertz", jumps);
    EXPECT_NEAR(Patch::ellipse(law, 1.0, 1.0).moment_ratio(), law->moment_ratio(), 1e-12);
  }
}

TEST(PatchEllipse, EqualLawsHaveEqualBoundsUnderEitherName) {
  for (const auto& [one, other] : {std::pair{hertz(), power(0.5)}, std::pair{flat_punch(), power(-0.5)}}) {
    const Patch a = Patch::ellipse(one, 0.005, 0.004);
    const Patch b = Patch::ellipse(other, 0.005, 0.004);
    for (const PatchTwist& twist : twists(0.005, 50, -1.0, 1.0)) {
      // The same polynomial, and so the same bits, cost and bound.
      EXPECT_EQ(a.about_origin(twist).power, b.about_origin(twist).power) << other->name();
      EXPECT_EQ(a.about_origin(twist).error, b.about_origin(twist).error) << other->name();
    }
  }
}

TEST(PatchEllipse, OfEqualAxesIsTheDisc) {
  const auto expect_disc = [](const Law& law, double bound) {
    constexpr double radius = 0.004;
    const Patch patch = Patch::ellipse(law, radius, radius);
    for (const double s :
         {0.0, 1e-5, 1e-3, 0.003, 0.01, 0.03, 0.1, 0.3, 0.5, 0.8, 0.99, 1.0, 1.01, 2.0, 30.0, 1e3, 1e6}) {
      for (const double angle : {0.0, 0.7, 2.9}) {
        SCOPED_TRACE(testing::Message() << law->name() << ' ' << s);
        const PatchFriction friction =
            patch.about_origin(about({radius * s * std::cos(angle), radius * s * std::sin(angle)}, -2.0));
        const WrenchEstimate disc = law->evaluate(s);
        const double error = std::min(bound, friction.error);
        EXPECT_NEAR(std::hypot(friction.wrench.fx, friction.wrench.fy), disc.wrench.force, error);
        EXPECT_NEAR(friction.wrench.moment / patch.moment_ratio(), -disc.wrench.moment / law->moment_ratio(), error);
      }
    }
  };
  for (const std::string_view name : law_examples()) expect_disc(parse_law(name), 1e-12);
  // Sharp ones keep their stated error.
  for (const char* name : {"power:n=100", "power:n=500", "power:n=1000", "xydas-kao:k=0.05",
                           "mix:0.5*hertz+0.5*power:n=1000", "mix:0.999*uniform+0.001*power:n=1000"})
    expect_disc(parse_law(name), inf);
  // The rays resolve this one, too.
  const Law law = power(100.0);
  const Patch ellipse = Patch::ellipse(law, 2.0, 1.0);
  for (const PatchTwist& twist : {about({0.01, 0.02}), about({0.3, 0.1})})
    expect_exact(ellipse, twist, ellipse_by_rays(*law, 2.0, 1.0, twist), inf);
}

TEST(PatchEllipse, OfATooSharpLawIsRefusedByName) {
  for (const char* name : {"xydas-kao:k=0.01", "xydas-kao:k=0.03"}) {
    const std::string text = complaint([&] { return Patch::ellipse(parse_law(name), 0.004, 0.002); });
    expect_mention(text, name);
    expect_mention(text, "k >= 0.05");
  }
}

TEST(PatchEllipse, OfAMixtureIsTheMixture) {
  // The parts end at different radii, one with a pressure that is singular there.
  const Patch mixed = Patch::ellipse(parse_law("mix:1*power:n=-0.9+3*gaussian:sigma=2"), 0.004, 0.002);
  const Patch one = Patch::ellipse(power(-0.9), 0.004, 0.002);
  const Patch other = Patch::ellipse(gaussian(2.0), 0.004, 0.002);
  for (const PatchTwist& twist : twists(0.004, 50, -2.0, 2.0)) {
    const PatchFriction a = one.evaluate(twist);
    const PatchFriction b = other.evaluate(twist);
    const auto mean = [&](double first, double second) { return 0.25 * first + 0.75 * second; };
    const PatchFriction expected{
        mean(a.power, b.power),
        {mean(a.wrench.fx, b.wrench.fx), mean(a.wrench.fy, b.wrench.fy), mean(a.wrench.moment, b.wrench.moment)},
        0.0};
    EXPECT_LE(difference(mixed.evaluate(twist), expected, mixed.moment_ratio()), 1e-10);
  }
}

TEST(PatchEllipse, LargestMomentIsThatOfTheDiscOfEqualPerimeter) {
  for (const std::string_view name : law_examples()) {
    const Law law = parse_law(name);
    for (const double aspect : {1.0, 1.5, 2.0, 3.0, 5.0, 20.0}) {
      const double a_eff =
          2.0 / std::numbers::pi * aspect * boost::math::ellint_2(std::sqrt(1.0 - 1.0 / (aspect * aspect)));
      EXPECT_NEAR(Patch::ellipse(law, aspect, 1.0).moment_ratio() / (law->moment_ratio() * a_eff), 1.0, 1e-12)
          << name << ' ' << aspect;
      EXPECT_NEAR(Patch::ellipse(law, 0.1, 0.1 * aspect).moment_ratio() / (0.1 * law->moment_ratio() * a_eff), 1.0,
                  1e-12)
          << name;
    }
  }
}

TEST(PatchEllipse, BeyondAnAspectOfTwentyKeepsItsError) {
  for (const char* name : {"hertz", "uniform", "cone"}) {
    const Law law = parse_law(name);
    for (const double aspect : {50.0, 1000.0, 9999.0}) {
      const Patch patch = Patch::ellipse(law, 1.0, aspect);
      for (const PatchPoint cor : {PatchPoint{0, 0}, {0.3, 0.2 * aspect}, {1.2, 0.1}, {0.1, 1.1 * aspect}}) {
        SCOPED_TRACE(testing::Message() << name << aspect);
        expect_exact(patch, about(cor), ellipse_by_rays(*law, 1.0, aspect, about(cor)), inf);
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
