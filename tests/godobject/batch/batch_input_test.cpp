// SPDX-License-Identifier: MIT
// What a batch makes of any input.
#include "tests/godobject/batch/batch_cases.hpp"

#include <span>

namespace limitcurve::godobject::test {
namespace {

template <class Real>
class BatchInput : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(BatchInput, Reals);

TYPED_TEST(BatchInput, WhatIsNotUsableTouchesNothingAndItsNeighboursNeither) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  constexpr std::array<Real, 4> nonsense{Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Real(1e7)};
  constexpr std::size_t count = 130;
  for (const Case<Real>& with : cases<Real>()) {
    const BasicBatch<Real> batch(with.curve, with.with, with.projection);
    BasicContactArrays<Real> arrays(count);
    Random random(29);
    for (int round = 0; round < 5; ++round) {
      move_all(arrays, random, 1e-2);
      batch.step(arrays.batch());
    }
    const std::vector<Real> before = written(arrays.batch());
    move_all(arrays, random, 1e-3);
    BasicContactArrays<Real> sound = arrays;
    for (std::size_t i = 0; i < 16; ++i)
      std::array{arrays.x(), arrays.y(), arrays.twist(), arrays.depth()}[i % 4][8 * i] = nonsense[i / 4];
    batch.step(arrays.batch());
    batch.step(sound.batch());
    const std::vector<Real> spoilt = written(arrays.batch());
    const std::vector<Real> expected = written(sound.batch());
    for (std::size_t k = 0; k < spoilt.size(); ++k) {
      const std::size_t i = k / numbers_per_contact;
      const bool is_fault = i % 8 == 0 && i < 128;
      const bool is_state = k % numbers_per_contact == numbers_per_contact - 1;
      const Real held = is_state ? static_cast<Real>(ContactState::invalid) : before[k];
      ASSERT_EQ(spoilt[k], is_fault ? held : expected[k]) << with.name << ' ' << i;
    }
  }
}

// A fault does not let go: the grip is there again with the next good sample, as a finger's is.
TYPED_TEST(BatchInput, AFaultHoldsTheGrip) {
  using Real = TypeParam;
  for (const Case<Real>& with : cases<Real>()) {
    const BasicBatch<Real> batch(with.curve, with.with, with.projection);
    BasicContactArrays<Real> arrays(40);
    BasicContactArrays<Real> undisturbed = arrays;
    Random random(37);
    const auto step = [&](BasicContactArrays<Real>& one) { batch.step(one.batch()); };
    for (int round = 0; round < 20; ++round) {
      move_all(arrays, random, 1e-3);
      copy_places(arrays, undisturbed);
      step(arrays);
      step(undisturbed);
      ASSERT_EQ(written(arrays.batch()), written(undisturbed.batch())) << with.name << ' ' << round;
      std::ranges::fill(arrays.depth(), std::numeric_limits<Real>::quiet_NaN());
      step(arrays);
      for (const ContactState state : arrays.batch().state)
        ASSERT_EQ(state, ContactState::invalid) << with.name << ' ' << round;
    }
  }
}

// Fingers with numbers whose squares overflow a float work, too.
TYPED_TEST(BatchInput, StepsFingersOfAnyScale) {
  using Real = TypeParam;
  const BasicFingerCurve<Real> table = BasicTable<Real>::build(hertz(), 1e-6);
  for (const double scale : {1e-13, 1e-10, 1.0, 1e10, 1e12}) {
    const BasicBatch<Real> batch(table, parameters(0.6, 0.005, 1000.0 * scale, 0.04 * scale));
    BasicContactArrays<Real> arrays(3);
    std::ranges::fill(arrays.depth(), Real(0.002));
    batch.step(arrays.batch());
    std::ranges::fill(arrays.x(), Real(0.01));
    std::ranges::fill(arrays.twist(), Real(1));
    batch.step(arrays.batch());
    const double unit = 1.2 * scale;
    const BasicContactBatch<Real> result = arrays.batch();
    const double gauge =
        table.gauge({std::fabs(double{result.fx[2]}) / unit, std::fabs(double{result.moment[2]}) / (0.005 * unit)});
    EXPECT_NEAR(gauge, 1.0, sizeof(Real) == sizeof(double) ? 1e-14 : 1e-6) << scale;
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
