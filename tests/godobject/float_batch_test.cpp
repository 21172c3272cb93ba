// SPDX-License-Identifier: MIT
#include "godobject/float_batch.hpp"

#include "godobject/batch.hpp"
#include "tests/godobject/scene.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace limitcurve::godobject::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr double epsilon = 0x1p-23;

/// The arrays of a batch of contacts.
template <class Real, class Batch>
struct ArraysOf {
  explicit ArraysOf(std::size_t count) {
    for (auto& array : values) array.assign(count, Real(0));
    values[7].assign(count, Real(-2));
  }
  Batch batch() {
    return {values[0], values[1], values[2], values[3], values[4],  values[5],
            values[6], values[7], values[8], values[9], values[10], values[11]};
  }
  std::array<std::vector<Real>, 12> values;
};
using Arrays = ArraysOf<float, FloatContactBatch>;

std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
  std::vector<std::uint32_t> bits;
  for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return bits;
}

/// Both vectorised pairs, and others that are stepped one by one; with static friction above the dynamic and a radius that grows, too.
template <class Body>
void for_each_friction(Body&& body) {
  const double m0 = hertz()->moment_ratio();
  const FloatTable table = FloatTable::build(hertz(), 1e-6);
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  soft.mu_dynamic = 0.5;
  body(Friction(Ellipse::through_intercepts(m0), parameters(), Radial{}), "ellipse, radial");
  body(Friction(table, parameters(), ClosestPoint{}), "float table, closest point");
  body(Friction(table, parameters(0.6, 0.005, 1000.0, 0.4), ClosestPoint{}), "float table, closest point, stiff twist");
  body(Friction(table, parameters(0.6, 0.005, 1000.0, 0.001), ClosestPoint{}), "float table, closest point, soft twist");
  body(Friction(table, parameters(), Radial{}), "float table, radial");
  body(Friction(table, soft, ClosestPoint{}), "float table, closest point, soft finger");
  body(Friction(Ellipse::through_intercepts(m0), soft, Radial{}), "ellipse, radial, soft finger");
  body(Friction(ExactCurve(hertz()), parameters(), CCurve{}), "exact, c-curve");
  body(Friction(box(1.0, m0), parameters(), ClosestPoint{}), "box, closest point");
}

/// Moves every finger by a random stride, presses it by random depths, now and then lifts it.
void wander(Arrays& arrays, Random& random, double longest) {
  for (std::size_t i = 0; i < arrays.values[0].size(); ++i) {
    const double stride = random.logarithmic(1e-7, longest);
    arrays.values[0][i] += static_cast<float>(random.uniform(-stride, stride));
    arrays.values[1][i] += static_cast<float>(random.uniform(-stride, stride));
    arrays.values[2][i] += static_cast<float>(random.uniform(-200.0, 200.0) * stride);
    arrays.values[3][i] = static_cast<float>(random.uniform(-0.0002, 0.003));
  }
}

// Near the origin, where positions resolve nanometres: the wrench is that of the double step on the same floats, to what the positions resolve of
// the springs' draw, and a float's rounding.
template <class Boundary, class Projection>
void expect_the_double_step(const Friction<Boundary, Projection>& friction, double bound, std::string_view name) {
  constexpr std::size_t count = 501;
  Arrays arrays(count);
  ArraysOf<double, ContactBatch> doubles(count);
  Random random(5);
  double worst = 0.0;
  for (int round = 0; round < 200; ++round) {
    wander(arrays, random, 1e-3);
    for (std::size_t i = 0; i < 4; ++i) doubles.values[i].assign(arrays.values[i].begin(), arrays.values[i].end());
    step(friction, arrays.batch());
    step(friction, doubles.batch());
    for (std::size_t i = 0; i < count; ++i) {
      if (!(doubles.values[3][i] > 1e-4)) continue;
      const double unit = friction.law().mu() * friction.law().stiffness() * doubles.values[3][i];
      const double radius = friction.law().static_scale(friction.law().stiffness() * doubles.values[3][i]).radius;
      for (const std::size_t component : {9U, 10U, 11U}) {
        const double difference = static_cast<double>(arrays.values[component][i]) - doubles.values[component][i];
        worst = std::max(worst, std::fabs(difference) / (component == 11 ? unit * radius : unit));
      }
    }
  }
  EXPECT_LE(worst, bound) << name;
  EXPECT_GT(worst, 1e-9) << name;
}

TEST(FloatBatch, GivesTheWrenchOfTheDoubleStep) {
  const double m0 = hertz()->moment_ratio();
  expect_the_double_step(Friction(Ellipse::through_intercepts(m0), parameters(), Radial{}), 1e-5, "ellipse");
  expect_the_double_step(Friction(FloatTable::build(hertz(), 1e-6), parameters(), ClosestPoint{}), 1e-5, "table");
}

TEST(FloatBatch, SlipWorkIsNeverNegativeAndTheWrenchIsWithinTheLimit) {
  constexpr std::size_t count = 1001;
  for_each_friction([&](const auto& friction, std::string_view name) {
    Arrays arrays(count);
    Random random(17);
    auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays.values;
    double outmost = 0.0;
    int slips = 0;
    for (int round = 0; round < 40; ++round) {
      wander(arrays, random, round % 2 == 0 ? 1e-2 : 1e-4);
      const auto before = arrays.values;
      step(friction, arrays.batch());
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(std::isfinite(force_x[i]) && std::isfinite(force_y[i]) && std::isfinite(moment[i])) << name;
        if (!(depth[i] > 0.0F)) continue;
        // Each component for itself: the proxy comes nearer, against the force on the user.
        if (before[7][i] >= -1.0F) {
          ASSERT_LE(force_x[i] * (proxy_x[i] - before[4][i]), 0.0F) << name;
          ASSERT_LE(force_y[i] * (proxy_y[i] - before[5][i]), 0.0F) << name;
          ASSERT_LE(moment[i] * (proxy_angle[i] - before[6][i]), 0.0F) << name;
        }
        const double load = friction.law().stiffness() * static_cast<double>(depth[i]);
        const auto scale = friction.law().static_scale(load);
        const UnitWrench wrench{std::hypot(static_cast<double>(force_x[i]), static_cast<double>(force_y[i])) / scale.force,
                                std::fabs(static_cast<double>(moment[i])) / (scale.force * scale.radius)};
        outmost = std::max(outmost, friction.boundary().gauge(wrench));
        slips += static_cast<int>(start[i] >= 0.0F);
      }
    }
    EXPECT_GT(slips, 1000) << name;
    EXPECT_LE(outmost, 1.0 + 4.0 * epsilon) << name;
    // On it, where one that begins to slip does not fall to a lower one.
    EXPECT_GT(outmost, friction.law().has_one_limit() ? 1.0 - 4.0 * epsilon : 0.99) << name;
  });
}

// Dragged into slipping, then held where they are: from the next step on nothing moves. Far out too, where a float resolves a tenth of
// a micrometre, which is a large share of what slides there.
TEST(FloatBatch, AHeldContactKeepsEveryBit) {
  constexpr std::size_t count = 2001;
  for (const double far : {0.01, 2.0, 100.0}) {
    for_each_friction([&](const auto& friction, std::string_view name) {
      Arrays arrays(count);
      Random random(11);
      for (std::size_t i = 0; i < count; ++i) {
        arrays.values[0][i] = static_cast<float>(random.uniform(-far, far));
        arrays.values[1][i] = static_cast<float>(random.uniform(-far, far));
        arrays.values[2][i] = static_cast<float>(random.uniform(-10.0 * far, 10.0 * far));
        arrays.values[3][i] = static_cast<float>(random.logarithmic(1e-5, 1e-2));
      }
      step(friction, arrays.batch());
      for (std::size_t i = 0; i < count; ++i) {
        const double reach = random.logarithmic(1e-4, 1e-1);
        arrays.values[0][i] += static_cast<float>(random.uniform(-reach, reach));
        arrays.values[1][i] += static_cast<float>(random.uniform(-reach, reach));
        arrays.values[2][i] += static_cast<float>(random.uniform(-100.0, 100.0) * reach);
      }
      step(friction, arrays.batch());
      const auto slid = arrays.values;
      for (int hold = 0; hold < 8; ++hold) {
        step(friction, arrays.batch());
        for (const std::size_t component : {4U, 5U, 6U}) {
          ASSERT_EQ(bits_of(arrays.values[component]), bits_of(slid[component])) << name << ' ' << far << ' ' << hold << ' ' << component;
        }
        for (const float start : arrays.values[7]) ASSERT_EQ(start, -1.0F) << name;
      }
    });
  }
}

TEST(FloatBatch, ATremblingFingerNeverCreeps) {
  constexpr std::size_t count = 1000;
  const Friction friction(FloatTable::build(hertz(), 1e-6), parameters(), ClosestPoint{});
  Arrays arrays(count);
  Random random(3);
  arrays.values[3].assign(count, 0.002F);
  arrays.values[0].assign(count, 0.1F);
  step(friction, arrays.batch());
  const auto rest = arrays.values;
  for (int round = 0; round < 1000; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      // Up to 0.8 of the limit.
      arrays.values[0][i] = 0.1F + static_cast<float>(random.uniform(-0.00045, 0.00045));
      arrays.values[1][i] = static_cast<float>(random.uniform(-0.00045, 0.00045));
      arrays.values[2][i] = static_cast<float>(random.uniform(-0.025, 0.025));
    }
    step(friction, arrays.batch());
    for (const std::size_t component : {4U, 5U, 6U, 7U}) ASSERT_EQ(bits_of(arrays.values[component]), bits_of(rest[component]));
  }
}

// Driven at a constant twist it settles at eq. (17)'s wrench: the closest point does, whatever the stiffnesses.
TEST(FloatBatch, SettlesAtEquation17) {
  const FloatTable table = FloatTable::build(hertz(), 1e-6);
  for (const double twist_stiffness : {0.004, 0.04, 0.4}) {
    const Friction friction(table, parameters(0.6, 0.005, 1000.0, twist_stiffness), ClosestPoint{});
    std::vector<double> cors{0.01, 0.1, 0.3, 0.7, 1.0, 1.5, 3.0, 10.0, 100.0};
    Arrays arrays(cors.size());
    arrays.values[3].assign(cors.size(), 0.002F);
    step(friction, arrays.batch());
    for (int i = 1; i <= 2000; ++i) {
      for (std::size_t k = 0; k < cors.size(); ++k) {
        const SlipTwist twist = SlipTwist::about_cor(cors[k]);
        arrays.values[0][k] = static_cast<float>(1e-4 * i * twist.slide);
        arrays.values[2][k] = static_cast<float>(1e-4 * i * twist.spin / 0.005);
      }
      step(friction, arrays.batch());
    }
    for (std::size_t k = 0; k < cors.size(); ++k) {
      const UnitForces<double> exact = hertz()->forces(cors[k]);
      // What 0.2 m and 40 rad resolve of the finger's stride of 0.1 mm and 0.02 rad turns the slip by so much.
      EXPECT_NEAR(static_cast<double>(arrays.values[9][k]), -1.2 * exact.force, 2e-4) << cors[k];
      EXPECT_NEAR(static_cast<double>(arrays.values[11][k]), -1.2 * 0.005 * exact.moment, 1e-6) << cors[k];
    }
  }
}

TEST(FloatBatch, DoesNotDependOnNeighbours) {
  constexpr std::size_t count = 517;
  for_each_friction([&](const auto& friction, std::string_view name) {
    Arrays together(count);
    Arrays alone(count);
    Random random(23);
    for (int round = 0; round < 20; ++round) {
      wander(together, random, 1e-2);
      for (std::size_t i = 0; i < 4; ++i) alone.values[i] = together.values[i];
      step(friction, together.batch());
      for (std::size_t i = 0; i < count; ++i) step(friction, alone.batch().part(i, 1));
      for (std::size_t component = 4; component < 12; ++component) {
        ASSERT_EQ(bits_of(alone.values[component]), bits_of(together.values[component])) << name << ' ' << round << ' ' << component;
      }
    }
  });
}

TEST(FloatBatch, WhatIsNotUsableTouchesNothingAndItsNeighboursNeither) {
  for_each_friction([&](const auto& friction, std::string_view name) {
    constexpr std::size_t count = 130;
    Arrays arrays(count);
    Random random(29);
    for (int round = 0; round < 5; ++round) {
      wander(arrays, random, 1e-2);
      step(friction, arrays.batch());
    }
    Arrays sound = arrays;
    wander(arrays, random, 1e-3);
    for (std::size_t i = 0; i < 4; ++i) sound.values[i] = arrays.values[i];
    const auto before = arrays.values;
    constexpr std::array<float, 4> nonsense{not_a_number, infinity, -infinity, 1e7F};
    for (std::size_t i = 0; i < 12; ++i) arrays.values[i % 3][10 * i] = nonsense[i % 4];
    arrays.values[3][125] = infinity;
    step(friction, arrays.batch());
    step(friction, sound.batch());
    for (std::size_t i = 0; i < count; ++i) {
      const bool spoilt = (i % 10 == 0 && i < 120) || i == 125;
      for (std::size_t component = 4; component < 12; ++component) {
        const float expected = spoilt ? before[component][i] : sound.values[component][i];
        ASSERT_EQ(std::bit_cast<std::uint32_t>(arrays.values[component][i]), std::bit_cast<std::uint32_t>(expected)) << name << ' ' << i;
      }
    }
  });
}

// All that a float can be in every place, for hundreds of steps.
TEST(FloatBatch, NoNaNComesOutWhateverComesIn) {
  constexpr std::array<float, 20> odd{0.0F,   -0.0F,  1e-45F, 1e-38F, -1e-30F, 1e-20F, 1e-12F, -1e-6F,       1e-3F,    0.002F,
                                      0.003F, -0.01F, 1.0F,   1e3F,   -1e6F,   1e7F,   3e38F,  not_a_number, infinity, -infinity};
  for_each_friction([&](const auto& friction, std::string_view name) {
    constexpr std::size_t count = 999;
    Arrays arrays(count);
    Random random(31);
    for (int round = 0; round < repetitions(200, 40); ++round) {
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
          const std::uint64_t bits = random.bits();
          arrays.values[k][i] = bits % 3 == 0   ? odd[(bits >> 8) % odd.size()]
                                : bits % 3 == 1 ? static_cast<float>(random.logarithmic(1e-30, 1e6))
                                                : static_cast<float>(random.uniform(-0.005, 0.005));
        }
      }
      step(friction, arrays.batch());
      for (std::size_t component = 4; component < 12; ++component) {
        for (const float value : arrays.values[component]) ASSERT_TRUE(std::isfinite(value)) << name << ' ' << component;
      }
    }
  });
}

// In double arithmetic a float table is a boundary for a finger like any other, by every projection. Its cells miss each other by a
// rounding of a float, so that a finger dragged to where two meet may move once more, inwards.
TEST(FloatTableInAFinger, StepsByEveryProjection) {
  const FloatTable table = FloatTable::build(hertz(), 1e-6);
  for (const ProjectionKind kind : {ProjectionKind::radial, ProjectionKind::c_curve, ProjectionKind::closest_point}) {
    visit_projection(kind, [&](auto projection) {
      Random random(37);
      SoftFinger finger(table, parameters(), projection);
      int slips = 0;
      for (int i = 0; i < 20'000; ++i) {
        const double reach = random.logarithmic(1e-7, 1e-2);
        const Contact contact = on_plane(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-0.0001, 0.003));
        const double twist = random.uniform(-100.0, 100.0) * reach;
        const FingerOutput output = finger.update(contact, twist);
        ASSERT_NE(output.state, ContactState::invalid);
        ASSERT_GE(output.slip_work, 0.0);
        if (output.state == ContactState::free) continue;
        const double unit = 0.6 * output.load;
        ASSERT_LE(table.gauge({output.force.norm() / unit, std::fabs(output.moment) / (0.005 * unit)}), 1.0 + 4.0 * epsilon);
        if (output.state != ContactState::slip) continue;
        ++slips;
        SoftFinger held = finger;
        for (int hold = 0; hold < 2; ++hold) held.update(contact, twist);
        const FingerOutput at_rest = held.output();
        for (int hold = 0; hold < 3; ++hold) held.update(contact, twist);
        ASSERT_EQ(held.output().state, ContactState::stick);
        ASSERT_TRUE(same_bits(held.output().proxy, at_rest.proxy) && held.output().angle == at_rest.angle);
      }
      EXPECT_GT(slips, 5000);
    });
  }
}

// Fingers whose numbers a float's squares cannot hold are stepped all the same.
TEST(FloatBatch, StepsFingersOfAnyScale) {
  const FloatTable table = FloatTable::build(hertz(), 1e-6);
  for (const double scale : {1e-13, 1e-10, 1.0, 1e10, 1e12}) {
    const Friction friction(table, parameters(0.6, 0.005, 1000.0 * scale, 0.04 * scale), ClosestPoint{});
    Arrays arrays(3);
    arrays.values[3].assign(3, 0.002F);
    step(friction, arrays.batch());
    arrays.values[0].assign(3, 0.01F);
    arrays.values[2].assign(3, 1.0F);
    step(friction, arrays.batch());
    const double unit = 1.2 * scale;
    const UnitWrench wrench{std::fabs(static_cast<double>(arrays.values[9][2])) / unit,
                            std::fabs(static_cast<double>(arrays.values[11][2])) / (0.005 * unit)};
    EXPECT_NEAR(table.gauge(wrench), 1.0, 1e-6) << scale;
  }
}

TEST(FloatBatch, StepsAsManyAsTheShortestArray) {
  const Friction friction(Ellipse::through_intercepts(0.5), parameters(), Radial{});
  Arrays arrays(10);
  arrays.values[3].assign(10, 0.002F);
  arrays.values[9].resize(4);
  step(friction, arrays.batch());
  arrays.values[0].assign(10, 0.02F);
  step(friction, arrays.batch());
  EXPECT_NEAR(arrays.values[4][3], 0.02F - 0.0012F, 1e-8F);
  EXPECT_EQ(arrays.values[4][4], 0.0F);
}

}  // namespace
}  // namespace limitcurve::godobject::test
