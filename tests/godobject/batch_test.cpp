// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"
#include "godobject/contact_arrays.hpp"

#include "tests/godobject/scene.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace limitcurve::godobject::test {
namespace {

/// The arrays of a batch of contacts.
struct Arrays {
  explicit Arrays(std::size_t count) {
    for (auto& array : values) array.assign(count, 0.0);
    values[7].assign(count, -2.0);
  }
  ContactBatch batch() {
    return {values[0], values[1], values[2], values[3], values[4],  values[5],
            values[6], values[7], values[8], values[9], values[10], values[11]};
  }
  std::array<std::vector<double>, 12> values;
};

// 1001 contacts (no multiple of a vector's length), some free, stepped together and one by one: the same bits.
template <class Boundary, class Projection>
void expect_the_same_bits(const Boundary& boundary, Projection projection, const FingerParameters& with, std::string_view name) {
  constexpr std::size_t count = 1001;
  const SoftFinger<Boundary, Projection> finger(boundary, with, projection);
  std::vector<SoftFinger<Boundary, Projection>> fingers(count, finger);
  Arrays arrays(count);
  Random random(17);
  auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays.values;
  for (int round = 0; round < repetitions(30, 5); ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      const double stride = random.logarithmic(1e-7, 1e-2);
      x[i] += random.uniform(-stride, stride);
      y[i] += random.uniform(-stride, stride);
      angle[i] += random.uniform(-1.0, 1.0) * random.logarithmic(1e-5, 1.0);
      depth[i] = random.uniform(-0.0005, 0.003);
    }
    step(finger.friction(), arrays.batch());
    for (std::size_t i = 0; i < count; ++i) {
      const FingerOutput& output = fingers[i].update(on_plane(x[i], y[i], depth[i]), angle[i]);
      ASSERT_EQ(force_x[i], output.force.x()) << name << ' ' << round << ' ' << i;
      ASSERT_EQ(force_y[i], output.force.y()) << name;
      ASSERT_EQ(moment[i], output.moment) << name;
      ASSERT_EQ(proxy_x[i], output.proxy.x()) << name;
      ASSERT_EQ(proxy_y[i], output.proxy.y()) << name;
      ASSERT_EQ(proxy_angle[i], output.angle) << name;
      ASSERT_EQ(start[i] >= 0.0, output.state == ContactState::slip) << name;
    }
  }
}

TEST(Batch, GivesTheBitsOfTheSingleStep) {
  FingerParameters plain = parameters();
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  soft.mu_dynamic = 0.5;
  for (const FingerParameters& with : {plain, soft}) {
    for (const ProjectionKind kind : {ProjectionKind::radial, ProjectionKind::closest_point}) {
      visit_projection(kind, [&](auto projection) {
        for_each_boundary(hertz(),
                          [&](const auto& boundary, std::string_view name) { expect_the_same_bits(boundary, projection, with, name); });
      });
    }
  }
}

// So little load that the friction counts as none: the single step lets go, and so does the batch, of all its neighbours no more.
TEST(Batch, GivesTheBitsOfTheSingleStepWhereFrictionVanishes) {
  constexpr std::size_t count = 9;
  const SoftFinger finger(Ellipse::through_intercepts(0.5), parameters(), Radial{});
  std::vector<double> depths{5e-324};
  for (int exponent = -160; exponent <= -100; ++exponent) depths.push_back(std::pow(10.0, exponent));
  for (const double shallow : depths) {
    std::vector<SoftFinger<Ellipse, Radial>> fingers(count, finger);
    Arrays arrays(count);
    auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays.values;
    for (int round = 0; round < 3; ++round) {
      for (std::size_t i = 0; i < count; ++i) {
        x[i] = 0.01 * round;
        angle[i] = -0.1 * round;
        depth[i] = i == 4 ? shallow : 0.001;
      }
      step(finger.friction(), arrays.batch());
      for (std::size_t i = 0; i < count; ++i) {
        const FingerOutput& output = fingers[i].update(on_plane(x[i], y[i], depth[i]), angle[i]);
        ASSERT_EQ(force_x[i], output.force.x()) << shallow << ' ' << round << ' ' << i;
        ASSERT_EQ(moment[i], output.moment) << shallow << ' ' << round << ' ' << i;
        ASSERT_EQ(proxy_x[i], output.proxy.x()) << shallow << ' ' << round << ' ' << i;
        ASSERT_EQ(proxy_angle[i], output.angle) << shallow << ' ' << round << ' ' << i;
        ASSERT_EQ(start[i] >= 0.0, output.state == ContactState::slip) << shallow << ' ' << round << ' ' << i;
      }
    }
  }
}

TEST(Batch, StepsAsManyAsTheShortestArray) {
  const SoftFinger finger(Ellipse::through_intercepts(0.5), parameters(), Radial{});
  Arrays arrays(10);
  for (double& x : arrays.values[0]) x = 0.01;
  for (double& depth : arrays.values[3]) depth = 0.002;
  arrays.values[9].resize(4);
  step(finger.friction(), arrays.batch());
  for (double& x : arrays.values[0]) x = 0.02;
  step(finger.friction(), arrays.batch());
  EXPECT_NEAR(arrays.values[4][3], 0.02 - 0.0012, 1e-12);
  EXPECT_EQ(arrays.values[4][4], 0.0);
}

// Where they lie decides how fast a step is, and no result.
TEST(ContactArrays, LieOnCacheLinesAndApartWithinAPage) {
  for (const std::size_t count : {0U, 1U, 8U, 511U, 512U, 513U, 100'000U}) {
    ContactArrays arrays(count);
    std::set<std::uintptr_t> places;
    for (const std::span<double> array : arrays.spans()) {
      ASSERT_EQ(array.size(), count);
      const auto address = reinterpret_cast<std::uintptr_t>(array.data());
      EXPECT_EQ(address % 64, 0U) << count;
      places.insert(address % 4096 / 64);
    }
    EXPECT_EQ(places.size(), 12U) << count;
    const std::vector<std::uintptr_t> lines(places.begin(), places.end());
    for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_GE(lines[i] - lines[i - 1], 4U) << count;
  }
}

TEST(ContactArrays, StepAsAnyOthersDo) {
  constexpr std::size_t count = 321;
  const SoftFinger finger(Table::build(hertz(), 1e-6), parameters(), ClosestPoint{});
  Arrays apart(count);
  ContactArrays together(count);
  Random random(5);
  for (int round = 0; round < 10; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      apart.values[0][i] = together.x()[i] = random.uniform(-0.01, 0.01);
      apart.values[1][i] = together.y()[i] = random.uniform(-0.01, 0.01);
      apart.values[2][i] = together.angle()[i] = random.uniform(-1.0, 1.0);
      apart.values[3][i] = together.depth()[i] = random.uniform(-0.0005, 0.003);
    }
    step(finger.friction(), apart.batch());
    step(finger.friction(), together.batch());
    // A copy goes on as its original would.
    together = ContactArrays(together);
    for (std::size_t array = 0; array < 12; ++array) {
      ASSERT_TRUE(std::ranges::equal(apart.values[array], together.spans()[array])) << round << ' ' << array;
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
