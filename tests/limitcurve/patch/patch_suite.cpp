// SPDX-License-Identifier: MIT
#include "limitcurve/patch/patch_table.hpp"
#include "patch_reference.hpp"
#include "tests/limitcurve/shared.hpp"

/// What holds for every kind of patch. A kind is made from a motion of the plane, so that symmetry can be tested.
namespace limitcurve {

namespace {

using test::inf;
using test::nan;

struct Kind {
  std::string name;
  Patch patch;
  double bound;  ///< of what rounding, or the kind's own error, leaves
};

std::vector<double> bump_image() {
  std::vector<double> pressures;
  for (int i = 0; i < 12 * 9; ++i) pressures.push_back(i % 5 == 0 ? 0.0 : 1.0 + i % 7);
  return pressures;
}

std::vector<Kind> kinds() {
  const std::vector<PatchLoad> loads{{-0.04, -0.04, 1}, {0.04, -0.02, 2}, {-0.04, 0.08, 1}};
  const std::vector<PatchPoint> concave{{0, 0}, {0.04, 0}, {0.04, 0.01}, {0.01, 0.01}, {0.01, 0.03}, {0, 0.03}};
  const Patch ellipse = Patch::ellipse(hertz(), 0.004, 0.002);
  return {{"points", Patch::points(loads), 1e-13},
          {"polygon", Patch::polygon(concave), 1e-13},
          {"rectangle", Patch::rectangle(0.02, 0.01), 1e-13},
          {"square", Patch::rectangle(0.02, 0.02), 1e-13},
          {"hertz ellipse", ellipse, 1e-13},
          {"uniform ellipse", Patch::ellipse(uniform(), 0.002, 0.009), 1e-12},
          {"gaussian ellipse", Patch::ellipse(gaussian(0.4), 0.002, 0.003), 1e-12},
          {"image", Patch::image(bump_image(), 12, 0.001), 2e-3},
          {"smoothed image", Patch::image(bump_image(), 12, 0.001).smoothed(1e-3), 1e-13},
          {"smoothed points", Patch::points(loads).smoothed(1e-3), 1e-13},
          {"orthotropic polygon", Patch::polygon(concave).orthotropic(0.5, 1.5), 1e-13},
          {"orthotropic ellipse", ellipse.orthotropic(1.2, 0.8), 1e-13},
          {"table of a rectangle", PatchTable::build(Patch::rectangle(0.02, 0.01), 1e-2), 1e-12},
          {"table of an orthotropic image",
           PatchTable::build(Patch::image(bump_image(), 12, 0.001).orthotropic(1.3, 0.9), 2e-3), 1e-12},
          {"orthotropic image", Patch::image(bump_image(), 12, 0.001).orthotropic(1.3, 0.9), 2e-3}};
}

std::vector<PatchTwist> random_twists(const Patch& patch, std::size_t count) {
  std::mt19937 bits(5);
  std::normal_distribution<double> normal;
  std::vector<PatchTwist> made;
  for (std::size_t i = 0; i < count; ++i) {
    made.push_back({normal(bits) * patch.moment_ratio(), normal(bits) * patch.moment_ratio(),
                    normal(bits) * std::pow(10.0, normal(bits))});
  }
  return made;
}

double size(const Patch& patch, const PatchTwist& twist) {
  return std::hypot(twist.vx, twist.vy) + patch.moment_ratio() * std::fabs(twist.omega);
}

double dot(const PatchTwist& twist, const PatchWrench& wrench) {
  return twist.vx * wrench.fx + twist.vy * wrench.fy + twist.omega * wrench.moment;
}

class EveryPatch : public ::testing::TestWithParam<Kind> {};

TEST_P(EveryPatch, PowerIsTwistTimesWrenchAndPositive) {
  const auto& [name, patch, bound] = GetParam();
  for (const PatchTwist& twist : random_twists(patch, 300)) {
    const PatchFriction friction = patch.evaluate(twist);
    EXPECT_GT(friction.power, 0.0);
    EXPECT_NEAR(friction.power, dot(twist, friction.wrench), 1e-13 * size(patch, twist)) << name;
  }
}

TEST_P(EveryPatch, FactorsOfFrictionMoveNoPoint) {
  const auto& [name, patch, bound] = GetParam();
  if (name.starts_with("table")) {
    EXPECT_THROW((void)patch.orthotropic(0.1, 3.0), std::invalid_argument);
    return;
  }
  const Patch slippery = patch.orthotropic(0.1, 3.0);
  EXPECT_EQ(slippery.radius(), patch.radius()) << name;
  EXPECT_EQ(slippery.centre().x, patch.centre().x) << name;
  EXPECT_EQ(slippery.centre().y, patch.centre().y) << name;
}

TEST_P(EveryPatch, PowerIsOfDegreeOneAndEven) {
  const auto& [name, patch, bound] = GetParam();
  for (const PatchTwist& twist : random_twists(patch, 50)) {
    const PatchFriction once = patch.evaluate(twist);
    for (const double factor : {-1.0, 3.0, -1e-9, 1e200, 1e-250}) {
      const PatchFriction other = patch.evaluate({factor * twist.vx, factor * twist.vy, factor * twist.omega});
      EXPECT_NEAR(other.power / (std::fabs(factor) * once.power), 1.0, 1e-12) << name << ' ' << factor;
      const double sense = factor > 0 ? 1.0 : -1.0;
      EXPECT_NEAR(other.wrench.fx, sense * once.wrench.fx, 1e-12) << name;
      EXPECT_NEAR(other.wrench.moment, sense * once.wrench.moment, 1e-12 * patch.moment_ratio()) << name;
    }
  }
}

TEST_P(EveryPatch, PowerIsConvexAndTheWrenchASubgradient) {
  const auto& [name, patch, bound] = GetParam();
  const std::vector<PatchTwist> all = random_twists(patch, 60);
  for (const PatchTwist& one : all) {
    const PatchWrench wrench = patch.wrench(one);
    for (const PatchTwist& other : all) {
      // H(t) >= W·t for every wrench of the set: convexity and gradient in one.
      EXPECT_GE(patch.power(other) - dot(other, wrench), -bound * size(patch, other)) << name;
    }
  }
}

TEST_P(EveryPatch, WrenchIsTheDifferenceOfPowers) {
  const auto& [name, patch, bound] = GetParam();
  if (bound > 1e-3) return;  // its power has steps of its own error
  for (const PatchTwist& twist : random_twists(patch, 50)) {
    const double step = 1e-6 * size(patch, twist);
    const auto slope = [&, &of = patch](double x, double y, double w) {
      const PatchTwist ahead{twist.vx + x * step, twist.vy + y * step, twist.omega + w * step};
      const PatchTwist behind{twist.vx - x * step, twist.vy - y * step, twist.omega - w * step};
      return (of.power(ahead) - of.power(behind)) / (2.0 * step);
    };
    const PatchWrench wrench = patch.wrench(twist);
    EXPECT_NEAR(wrench.fx, slope(1, 0, 0), 1e-5) << name;
    EXPECT_NEAR(wrench.fy, slope(0, 1, 0), 1e-5) << name;
    const double arm = patch.moment_ratio();
    EXPECT_NEAR(wrench.moment / arm, slope(0, 0, 1.0 / arm), 1e-5) << name;
  }
}

TEST_P(EveryPatch, GaugeOfAWrenchThatSlipsIsOne) {
  const auto& [name, patch, bound] = GetParam();
  const PatchPoint centre = patch.centre();
  for (const PatchTwist& twist : random_twists(patch, 200)) {
    const PatchWrench wrench = patch.wrench(twist);
    for (const double factor : {1.0, -0.25, 1e-200, 1e150}) {
      EXPECT_NEAR(patch.gauge({factor * wrench.fx, factor * wrench.fy, factor * wrench.moment}) / std::fabs(factor),
                  1.0, 1e-12 + bound)
          << name;
    }
    // The load of a wrench about the origin: mu P times what slips.
    const double mu = 0.4;
    const double load = 3.0;
    const double moment = wrench.moment + centre.x * wrench.fy - centre.y * wrench.fx;
    EXPECT_NEAR(load_to_hold(patch, mu, {mu * load * wrench.fx, mu * load * wrench.fy, mu * load * moment}), load,
                (1e-11 + bound) * load)
        << name;
  }
  EXPECT_EQ(patch.gauge({0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(load_to_hold(patch, 0.0, {0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(load_to_hold(patch, 0.0, {0.0, 0.0, 1.0}), inf);
  EXPECT_EQ(patch.gauge({inf, 0.0, 0.0}), inf);
  EXPECT_TRUE(std::isnan(patch.gauge({1.0, nan, 1.0})) && std::isnan(patch.gauge({inf, 1.0, nan})));
  EXPECT_THROW(load_to_hold(patch, -0.1, {1.0, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(load_to_hold(patch, 0.5, {1.0, nan, 0.0}), std::invalid_argument);
}

TEST_P(EveryPatch, SlipIsTheTwistThatNeedsTheWrench) {
  const auto& [name, patch, bound] = GetParam();
  for (const PatchTwist& twist : random_twists(patch, 100)) {
    const PatchFriction needed = patch.about_origin(twist);
    for (const double factor : {1.0, -0.25, 1e-200, 1e150}) {
      const PatchWrench wrench{factor * needed.wrench.fx, factor * needed.wrench.fy, factor * needed.wrench.moment};
      const auto [slip, gauge, error] = patch.slip(wrench);
      EXPECT_NEAR(gauge / std::fabs(factor), 1.0, 1e-12 + bound) << name;
      EXPECT_NEAR(dot(slip, wrench), 1.0, 1e-12) << name;
      const double scale = factor * needed.power;
      const PatchTwist apart{slip.vx * scale - twist.vx, slip.vy * scale - twist.vy, slip.omega * scale - twist.omega};
      EXPECT_LE(size(patch, apart), std::max(1e-8, 10.0 * bound) * size(patch, twist))
          << name << ' ' << twist.vx << ' ' << twist.omega;
      const PatchWrench again = patch.about_origin(slip).wrench;
      EXPECT_LE(
          test::difference(again, {wrench.fx / gauge, wrench.fy / gauge, wrench.moment / gauge}, patch.moment_ratio()),
          error)
          << name;
      EXPECT_LE(error, 1e-9 + 10.0 * bound + 2.0 * needed.error) << name;
    }
  }
  EXPECT_TRUE(std::isnan(patch.slip({0.0, 0.0, 0.0}).twist.vx));
  // Against a subnormal moment a twist of power 1 overflows.
  const PatchWrench spin{0.0, 0.0, 1.0};
  const PatchWrench subnormal{0.0, 0.0, std::ldexp(1.0, -1060)};
  EXPECT_NEAR(std::ldexp(patch.gauge(subnormal), 1060) / patch.gauge(spin), 1.0, 1e-3) << name;
  const PatchTwist usual = patch.slip(spin).twist;
  const auto [slip, gauge, error] = patch.slip(subnormal);
  const double scale = usual.omega / slip.omega;
  EXPECT_LE(size(patch, {scale * slip.vx - usual.vx, scale * slip.vy - usual.vy, 0.0}), 1e-12 * size(patch, usual))
      << name;
  EXPECT_LE(error, patch.slip(spin).error + 1e-15) << name;
}

// A push through the centre of pressure slides, whatever the shape; a wrench and its opposite slip in opposite ways.
TEST_P(EveryPatch, SlipsUnderWrenchesAlongTheAxes) {
  const auto& [name, patch, bound] = GetParam();
  const double m0 = patch.moment_ratio();
  const auto [mx, my] = patch.factors();
  for (const auto& [x, y, spin] : std::vector<std::array<double, 3>>{
           {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.6, 0.8, 0}}) {
    const auto [cx, cy] = patch.centre();
    const PatchWrench wrench{mx * x, my * y, m0 * spin + cx * my * y - cy * mx * x};
    const auto [slip, gauge, error] = patch.slip(wrench);
    const auto [back, same, also] = patch.slip({-wrench.fx, -wrench.fy, -wrench.moment});
    const double own = patch.about_origin(slip).error;  // the table's, of a table
    EXPECT_LE(std::max(error, also), 1e-9 + 10.0 * bound + 2.0 * own) << name << x << y << spin;
    EXPECT_NEAR(gauge, same, (1e-12 + bound) * gauge) << name << x << y << spin;
    EXPECT_NEAR(load_to_hold(patch, 1.0, wrench), gauge, (1e-12 + bound) * gauge) << name << x << y << spin;
    if (spin != 0.0) continue;
    // Slides along x and y are exact in tables, too.
    const double lost = x != 0.0 && y != 0.0 && name.starts_with("table") ? own : 0.0;
    EXPECT_NEAR(gauge, std::hypot(x, y), (1e-12 + lost) * gauge) << name << x << y;
    const PatchTwist slide{x / mx / (gauge * gauge), y / my / (gauge * gauge), 0.0};
    EXPECT_LE(size(patch, {slip.vx - slide.vx, slip.vy - slide.vy, slip.omega}),
              (1e-9 + 10.0 * lost) / std::min(mx, my))
        << name;
  }
}

TEST_P(EveryPatch, NothingIsUndefined) {
  const auto& [name, patch, bound] = GetParam();
  const PatchFriction rest = patch.evaluate({0, 0, 0});
  EXPECT_EQ(rest.power, 0.0);
  EXPECT_EQ(rest.wrench.fx, 0.0);
  EXPECT_EQ(rest.wrench.moment, 0.0);
  EXPECT_TRUE(std::isnan(patch.evaluate({nan, 0, 1}).power)) << name;
  EXPECT_TRUE(std::isnan(patch.evaluate({0, inf, 1}).power)) << name;
  for (const double v : {0.0, 1e-300, 1e-30, 1.0, 1e30, 1e300}) {
    for (const double omega : {0.0, 5e-324, 1e-300, 1e-12, 1.0, 1e18, 1e300}) {
      for (const double side : {-1.0, 0.0, 0.3}) {
        const PatchFriction friction = patch.about_origin({v, side * v, omega});
        EXPECT_TRUE(std::isfinite(friction.power) && std::isfinite(friction.wrench.fx) &&
                    std::isfinite(friction.wrench.fy) && std::isfinite(friction.wrench.moment) && friction.error >= 0.0)
            << name << ' ' << v << ' ' << omega;
      }
    }
  }
}

std::string test_name(const ::testing::TestParamInfo<Kind>& kind) {
  std::string name = kind.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Patches, EveryPatch, ::testing::ValuesIn(kinds()), test_name);

// Points on lines and at corners, where a wrench along an axis or across the line is a corner, an edge or the middle of
// a face of the limit surface; as found, and moved, turned, scaled and in another order.
TEST(PatchSymmetry, GaugesAtCornersAndInFacesOfTheLimitSurface) {
  std::vector<std::vector<PatchLoad>> shapes{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                                             {{2, -3, 1}, {-2, 0, 1}, {3, -2, 1}, {-3, -1, 1}},
                                             {{0.1, 0.4, 1}, {0.1, -0.4, 1}, {-0.7, 0.2, 1}, {-0.7, -0.2, 1}},
                                             {{-1, 0.3, 1}, {0.5, 0.2, 2}, {0.4, -0.9, 3}}};
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, 135.0}) {
    const double angle = degrees / 180.0 * std::numbers::pi;
    for (const double off : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
      shapes.push_back({});
      for (const double t : {-3.5, -1.0, 0.25, 2.0}) {
        const double across = off * std::cos(9.0 * t);
        shapes.back().push_back({t * std::cos(angle) - across * std::sin(angle),
                                 t * std::sin(angle) + across * std::cos(angle), t < 1.0 ? 1.0 : 3.0});
      }
    }
  }
  struct Motion {
    double turn, scale, x, y;
  };
  for (const std::vector<PatchLoad>& shape : shapes) {
    for (const Motion& motion :
         {Motion{0, 1, 0, 0}, {0, 1, 3, -2}, {0.7, 1, 0, 0}, {std::numbers::pi / 4, 1e-3, 0.01, 0}}) {
      const double c = motion.scale * std::cos(motion.turn);
      const double s = motion.scale * std::sin(motion.turn);
      std::vector<PatchLoad> loads;
      double total = 0.0;
      for (const auto& [x, y, load] : shape) {
        loads.insert(loads.begin(), {c * x - s * y + motion.x, s * x + c * y + motion.y, load});
        total += load;
      }
      const Patch patch = Patch::points(loads);
      const auto check = [&](const PatchWrench& wrench, double expected, const char* what) {
        const auto [slip, gauge, error] = patch.slip(wrench);
        EXPECT_NEAR(gauge, expected, 1e-11 * expected) << what << motion.turn << ' ' << shape[0].x << ' ' << shape[0].y;
        EXPECT_NEAR(load_to_hold(patch, 1.0, {-wrench.fx, -wrench.fy, -wrench.moment}), expected, 1e-11 * expected);
        EXPECT_LE(error, 1e-8) << what << motion.turn << ' ' << shape[0].x << ' ' << shape[0].y;
      };
      for (double angle = 0.0; angle < 3.1; angle += std::numbers::pi / 12.0) {
        const double fx = std::cos(angle);
        const double fy = std::sin(angle);
        check({fx, fy, patch.centre().x * fy - patch.centre().y * fx}, 1.0, "slide ");
      }
      for (const auto& [x, y, load] : loads) {
        const PatchWrench others = patch.about_origin({y, -x, 1.0}).wrench;
        for (const double part : {0.0, 0.3, 0.9}) {
          const double fx = part * load / total * std::cos(5.0 * part);
          const double fy = part * load / total * std::sin(5.0 * part);
          check({others.fx + fx, others.fy + fy, others.moment + x * fy - y * fx}, 1.0, "face ");
        }
      }
    }
  }
}

// Vertices and offsets are dyadic, so that nothing is rounded but by the library.
TEST(PatchOrigin, StatedErrorsHoldFarAwayAndForSlimPixels) {
  const auto expect_same = [](const PatchFriction& one, const PatchFriction& other, PatchPoint lever, double m0) {
    const double error = one.error + other.error;
    EXPECT_LE(std::fabs(one.power / other.power - 1.0), error);
    PatchWrench moved = other.wrench;
    moved.moment += lever.x * moved.fy - lever.y * moved.fx;
    EXPECT_LE(test::difference(one.wrench, moved, m0), error);
  };
  for (const double off : {0.0, 3.0, 1000.0, 65536.0}) {
    std::vector<PatchPoint> near{{0, 0}, {4, 0}, {4, 0.75}, {1, 1}, {1.25, 3}, {0, 3}};
    std::vector<PatchPoint> away = near;
    for (PatchPoint& vertex : away) vertex = {vertex.x + off, vertex.y - 0.5 * off};
    const Patch one = Patch::polygon(near).orthotropic(0.3, 1.7);
    const Patch other = Patch::polygon(away).orthotropic(0.3, 1.7);
    for (const double x : {-1.0, 0.5, 1.0, 6.25}) {
      for (const double y : {-2.0, 0.25, 1.0, 3.5}) {
        expect_same(other.about_origin({y - 0.5 * off, -(x + off), 1.0}), one.about_origin({y, -x, 1.0}),
                    {off, -0.5 * off}, one.moment_ratio());
      }
    }
  }
  for (const double slim : {0.5, 5e-3, 1e-4, 2e-6}) {
    const Patch pixel = Patch::image(std::vector<double>{1.0}, 1, slim, 1.0);
    const Patch rectangle = Patch::rectangle(slim, 1.0);
    for (const double y : {0.0, 0.1, 0.3, 0.49})
      expect_same(pixel.about_origin({y, -0.3 * slim, 1.0}), rectangle.about_origin({y, -0.3 * slim, 1.0}), {},
                  pixel.moment_ratio());
  }
}

}  // namespace

}  // namespace limitcurve
