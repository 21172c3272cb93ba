// SPDX-License-Identifier: MIT
#include "patch_cases.hpp"

#include <numeric>

namespace limitcurve::test {
namespace {

TEST(PatchPoints, AreTheExactSum) {
  const std::vector<PatchLoad> loads{{-0.04, -0.04, 1}, {0.04, -0.02, 2}, {-0.04, 0.08, 1}, {0.01, 0.02, 0}};
  const Patch patch = Patch::points(loads);
  EXPECT_NEAR(patch.centre().x, 0.0, 1e-17);
  for (const PatchTwist& twist : twists(0.05, 2000)) {
    const PatchFriction exact = points_by_sum(loads, twist, patch.centre());
    EXPECT_LE(difference(patch.evaluate(twist), exact, patch.moment_ratio()), 1e-13);
    const PatchFriction about_origin = points_by_sum(loads, twist, {0, 0});
    EXPECT_LE(difference(patch.about_origin(twist), about_origin, patch.moment_ratio()),
              patch.about_origin(twist).error);
  }
}

TEST(PatchPoints, OneUnderTheCorBearsNoForce) {
  const std::vector<PatchLoad> loads{{0.1, 0.2, 1}, {0.4, 0.2, 1}, {0.1, 0.7, 2}};
  const Patch patch = Patch::points(loads);
  // 3 * 0.1 and 3 * 0.2 are rounded: the COR is on the point within that rounding.
  for (const double omega : {1.0, -1.0, 3.0, 1e-3, 7e5}) {
    const PatchFriction friction = patch.about_origin({omega * 0.2, -omega * 0.1, omega});
    const double sense = omega > 0 ? 1.0 : -1.0;
    EXPECT_NEAR(friction.wrench.fx, -sense * 0.5, 1e-15) << omega;
    EXPECT_NEAR(friction.wrench.fy, sense * 0.25, 1e-15) << omega;
    EXPECT_NEAR(friction.power, std::fabs(omega) * (0.25 * 0.3 + 0.5 * 0.5), 1e-15 * std::fabs(omega)) << omega;
  }
  EXPECT_LT(patch.about_origin({0.2, -0.1, 1.0}).error, 1e-13);
}

TEST(PatchPoints, ASinglePointHasForceAndNoMoment) {
  const Patch patch = Patch::points(std::vector<PatchLoad>{{3, 4, 7}});
  const PatchFriction friction = patch.evaluate({3e-3, 4e-3, 1e9});
  EXPECT_NEAR(friction.wrench.fx, 0.6, 1e-15);
  EXPECT_NEAR(friction.wrench.fy, 0.8, 1e-15);
  EXPECT_EQ(friction.wrench.moment, 0.0);
  EXPECT_EQ(patch.evaluate({0, 0, 1}).power, 0.0);
}

// Goyal, Ruina, Papadopoulos, Wear 143:307, 1991: of two equal points ("dumbbell") the section of
// the limit surface along their line is an ellipse, the one across it a diamond.
TEST(PatchPoints, ADumbbellHasAnEllipseAndADiamond) {
  const Patch dumbbell = Patch::points(std::vector<PatchLoad>{{-1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}});
  for (const double slide : {0.3, 1.0, 4.0}) {
    const PatchWrench along = dumbbell.wrench({slide, 0.0, 1.0});
    EXPECT_NEAR(std::hypot(along.fx, along.moment), 1.0, 1e-15);
    const PatchWrench across = dumbbell.wrench({0.0, slide + 0.1, 1.0});
    EXPECT_NEAR(std::fabs(across.fy) + std::fabs(across.moment), 1.0, 1e-15);
  }
}

TEST(PatchPoints, TwoHoldWhatEachBearsOfIt) {
  // Along y each bears its part of force and moment; along x the two may share as they like. The least load by
  // bisection of one unknown.
  std::mt19937 bits(11);
  std::normal_distribution<double> normal;
  const double d = 0.01;
  const Patch patch = Patch::points(std::vector<PatchLoad>{{-d, 0.0, 1.0}, {d, 0.0, 1.0}});
  for (int i = 0; i < 300; ++i) {
    const double part = i % 3 == 0 ? 0.0 : 1.0;  // with and without a force along the points
    const PatchWrench wrench{part * normal(bits), normal(bits), 0.02 * normal(bits)};
    const double left = 0.5 * (wrench.fy - wrench.moment / d);
    const double right = 0.5 * (wrench.fy + wrench.moment / d);
    double low = 2.0 * std::max(std::fabs(left), std::fabs(right));
    double high = 2.0 * (low + std::fabs(wrench.fx));
    const auto holds = [&](double load) {
      return std::sqrt(load * load / 4.0 - left * left) + std::sqrt(load * load / 4.0 - right * right) >=
             std::fabs(wrench.fx);
    };
    for (int k = 0; k < 100 && !holds(low); ++k) (holds(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    EXPECT_NEAR(load_to_hold(patch, 0.5, wrench) * 0.5 / low, 1.0, 1e-11) << i;
  }
}

// A point at the COR bears any part of its load in any direction: there the limit surface is flat, and has one normal.
TEST(PatchPoints, WhatOneBearsInPartSlipsAboutIt) {
  std::mt19937 bits(29);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (std::size_t i = 0; i < 2000; ++i) {
    std::vector<PatchLoad> loads(3 + bits() % 6);
    for (PatchLoad& one : loads)
      one = {0.01 * std::floor(10.0 * number(bits)), 0.1 * number(bits), 0.125 + number(bits)};
    const double sum = std::accumulate(loads.begin(), loads.end(), 0.0,
                                       [](double before, const PatchLoad& one) { return before + one.load; });
    for (PatchLoad& one : loads) one.load /= sum;
    const double mx = i % 3 == 0 ? 0.1 + number(bits) : 1.0;
    const Patch patch = Patch::points(loads).orthotropic(mx, 1.0);
    const PatchLoad& at = loads[i % loads.size()];
    const auto [power, others, unknown] = points_by_sum(loads, about({at.x, at.y}), {0, 0}, mx);
    for (const double part : {0.0, 1e-15, number(bits), 1.0 - 1e-12, 1.0, 1.0 + 1e-6}) {
      const double angle = 6.3 * number(bits);
      const double fx = part * at.load * mx * std::cos(angle);
      const double fy = part * at.load * std::sin(angle);
      const auto [slip, gauge, error] =
          patch.slip({others.fx + fx, others.fy + fy, others.moment + at.x * fy - at.y * fx});
      const double off = std::hypot(slip.vx - slip.omega * at.y, slip.vy + slip.omega * at.x);
      const bool is_about_it = off <= (mx == 1.0 ? 0.0 : 1e-15 * slip.omega);
      EXPECT_NEAR(gauge, 1.0, part > 1.0 ? 1e-6 : 1e-12) << i << ' ' << part;
      if (part < 0.999) {
        EXPECT_TRUE(is_about_it) << i << ' ' << part;
        EXPECT_NEAR(slip.omega * power, 1.0, 1e-11) << i << ' ' << part;
      }
      EXPECT_LT(error, part > 1.0 ? 1e-4 : part < 0.999 ? 1e-11 : 2e-9) << i << ' ' << part;
    }
  }
}

// Near a point the direction of its force changes fast. What is missing from the slip's own forces to the wrench, each
// by the law of friction, is no more than stated; a point about which it slips may bear any force up to its load.
TEST(PatchPoints, BesideOneTheErrorOfASlipIsHonest) {
  std::mt19937 bits(31);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    std::vector<PatchLoad> loads(3 + bits() % 6);
    for (PatchLoad& one : loads)
      one = {0.1 * number(bits), 0.1 * number(bits), 1.0 / static_cast<double>(loads.size())};
    const Patch patch = Patch::points(loads);
    const double away = std::pow(10.0, -16.0 * number(bits)), angle = 6.3 * number(bits);
    const double x = loads[0].x + 0.01 * away * std::cos(angle);
    const double y = loads[0].y + 0.01 * away * std::sin(angle);
    const auto [slip, gauge, error] = patch.slip(patch.about_origin({y, -x, 1.0}).wrench);
    PatchWrench left = patch.about_origin({y, -x, 1.0}).wrench;
    left = {left.fx / gauge, left.fy / gauge, left.moment / gauge};
    const auto take = [&](const PatchLoad& one, double fx, double fy) {
      left = {left.fx - fx, left.fy - fy, left.moment - (one.x * fy - one.y * fx)};
    };
    const PatchLoad* bears = nullptr;
    for (const PatchLoad& one : loads) {
      const auto ux = static_cast<double>(std::fma(-Extended{slip.omega}, Extended{one.y}, Extended{slip.vx}));
      const auto uy = static_cast<double>(std::fma(Extended{slip.omega}, Extended{one.x}, Extended{slip.vy}));
      const double speed = std::hypot(ux, uy);
      if (speed <= 1e-16 * std::fabs(slip.omega)) {  // within the rounding of the slip
        bears = &one;
      } else {
        take(one, one.load * ux / speed, one.load * uy / speed);
      }
    }
    if (bears != nullptr) {
      const double part = bears->load / std::max(bears->load, std::hypot(left.fx, left.fy));
      take(*bears, part * left.fx, part * left.fy);
    }
    EXPECT_LE(std::max(std::hypot(left.fx, left.fy), std::fabs(left.moment) / patch.moment_ratio()), error + 1e-14)
        << i << ' ' << away;
    EXPECT_LT(error, 1e-5) << i << ' ' << away;
  }
}

/// By the law of friction itself: a force through the point, and no other wrench. Loads at one place are one point.
TEST(PatchPoints, OneHoldsForcesThroughItself) {
  std::mt19937 bits(71);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const double length = std::pow(10.0, 9.0 * number(bits));
    const double newton = std::pow(10.0, 9.0 * number(bits));
    const double x = length * number(bits);
    const double y = length * number(bits);
    const double mx = std::pow(10.0, 6.0 * number(bits));
    const double my = std::pow(10.0, 6.0 * number(bits));
    std::vector<PatchLoad> at_one_place;
    for (int k = 0; k <= i % 4; ++k) at_one_place.push_back({x, y, 1.1 + number(bits)});
    const Patch patch = i % 2 == 0 ? Patch::points(at_one_place).orthotropic(mx, my)
                                   : Patch::points(at_one_place).orthotropic(mx, 1.0).orthotropic(1.0, my);
    const double fx = newton * number(bits);
    const double fy = newton * number(bits);
    const double moment = x * fy - y * fx;
    const double load = std::hypot(fx / mx, fy / my) / 0.5;
    EXPECT_NEAR(load_to_hold(patch, 0.5, {fx, fy, moment}), load, 1e-14 * load)
        << x << ' ' << y << ' ' << mx << ' ' << my;
    EXPECT_NEAR(patch.slip({fx, fy, moment}).gauge, 0.5 * load, 1e-14 * load);
    const double more = 1e-14 * (std::fabs(x * fy) + std::fabs(y * fx));
    EXPECT_EQ(load_to_hold(patch, 0.5, {fx, fy, moment + more}), inf);
  }
}

TEST(PatchOrthotropic, PointsBesideTheCorKeepTheirStatedError) {
  const std::vector<PatchLoad> loads{{0.31, 0.13, 1}, {-0.23, 0.51, 2}, {0.11, -0.47, 1.5}};
  for (const auto& [mx, my] : {std::pair{0.7, 1.6}, {1.3, 0.9}, {3.3e5, 1.7e-4}}) {
    const Patch points = Patch::points(loads).orthotropic(mx, my);
    for (const double near : {1.0, 1e-2, 1e-5, 1e-8, 1e-11, 3e-14, 2e-15}) {
      for (const PatchLoad& point : loads) {
        for (const double angle : {0.1, 1.0, 2.5, 4.0}) {
          const double omega = 0.9;
          const PatchTwist twist = about({point.x + near * std::cos(angle), point.y + near * std::sin(angle)}, omega);
          const PatchFriction exact = points_by_sum(loads, twist, {0, 0}, mx, my);
          const PatchFriction friction = points.about_origin(twist);
          EXPECT_LE(difference(friction, exact, points.moment_ratio()), friction.error + witness_error)
              << mx << ' ' << my << ' ' << near << ' ' << angle;
          EXPECT_LE(friction.error, 1e-13 * std::max(1.0, mx)) << near;
        }
      }
    }
  }
}

TEST(PatchOrthotropic, TwistsOfAnySizeGiveTheSameWrench) {
  const std::vector<PatchLoad> loads{{0.31, 0.13, 1}, {-0.23, 0.51, 2}, {11.0, -0.47, 1.5}};
  for (const auto& [mx, my] : {std::pair{1.0, 1.0}, {7.3, 1.6}, {0.03, 0.9}}) {
    const Patch patch = Patch::points(loads).orthotropic(mx, my);
    for (const double size : {1e-318, 3e-308, 1e-200, 1e200, 4e307, 0.85e308}) {
      for (const PatchTwist& twist :
           {PatchTwist{size, -2.0 * size, 0.0}, {0.3 * size, size, 2.0 * size}, {0.0, 0.0, -size}}) {
        // The same twist times a power of two: no digit of it changes.
        const int exponent = -std::ilogb(size);
        const PatchTwist usual{std::ldexp(twist.vx, exponent), std::ldexp(twist.vy, exponent),
                               std::ldexp(twist.omega, exponent)};
        const PatchFriction exact = points_by_sum(loads, usual, {0, 0}, mx, my);
        const PatchFriction friction = patch.about_origin(twist);
        EXPECT_LE(difference(friction.wrench, exact.wrench, patch.moment_ratio()), friction.error) << size;
        EXPECT_EQ(friction.power, static_cast<double>(std::ldexp(patch.about_origin(usual).power, -exponent))) << size;
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
