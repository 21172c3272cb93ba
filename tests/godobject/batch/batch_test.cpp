// SPDX-License-Identifier: MIT
// Batches of both precisions agree with single fingers and keep the same promises.
#include "tests/godobject/batch/batch_cases.hpp"

namespace limitcurve::godobject::test {
namespace {

/// Tolerance of a wrench relative to the limit, near the origin: the onset of slip, and rounding of the gauge in the
/// check.
template <class Real>
constexpr double most_gauge = double{slip_onset<Real>} + 8.0 * std::numeric_limits<Real>::epsilon();

TEST(Batch, DoesWhatSoftFingersDo) {
  constexpr std::size_t count = 201;
  for (const Case<double>& with : cases<double>()) {
    const Batch batch(with.curve, with.with, with.projection);
    std::vector<SoftFinger> fingers(count, SoftFinger(with.curve, with.with, with.projection));
    ContactArrays arrays(count);
    const ContactBatch result = arrays.batch();
    Random random(17);
    for (int round = 0; round < repetitions(60, 5); ++round) {
      move_all(arrays, random, 1e-2);
      batch.step(result);
      for (std::size_t i = 0; i < count; ++i) {
        const FingerOutput output =
            fingers[i].update(on_plane(result.x[i], result.y[i], result.depth[i]), result.twist[i]);
        SCOPED_TRACE(testing::Message() << with.name << ' ' << round << ' ' << i);
        ASSERT_EQ(result.state[i], output.state);
        const double limit = 1e-12 * with.with.mu * output.load;
        ASSERT_NEAR(result.fx[i], output.force.x(), limit);
        ASSERT_NEAR(result.fy[i], output.force.y(), limit);
        ASSERT_NEAR(result.moment[i], output.moment, limit * 0.005);
        ASSERT_NEAR(result.proxy_x[i], output.proxy.x(), 1e-15);
        ASSERT_NEAR(result.proxy_y[i], output.proxy.y(), 1e-15);
        ASSERT_NEAR(result.proxy_angle[i], output.angle, 1e-12);
      }
    }
  }
}

// On the same floats, near the origin: what the positions resolve of the springs' deflection, and a float's rounding.
TEST(Batch, InFloatGivesTheWrenchOfTheDoubleStep) {
  constexpr std::size_t count = 501;
  const FloatBatch single(FloatTable::build(hertz(), 1e-6), parameters());
  const Batch reference(exact_curve(hertz()), parameters());
  FloatContactArrays floats(count);
  ContactArrays doubles(count);
  Random random(5);
  double worst = 0.0;
  for (int round = 0; round < 200; ++round) {
    move_all(floats, random, 1e-3);
    copy_places(floats, doubles);
    const FloatContactBatch felt = floats.batch();
    const ContactBatch expected = doubles.batch();
    single.step(felt);
    reference.step(expected);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(expected.depth[i] > 1e-4)) continue;
      const double unit = 0.6 * 1000.0 * expected.depth[i];
      const auto differ = [&](float one, double other) { worst = std::max(worst, std::fabs(double{one} - other)); };
      differ(felt.fx[i] / static_cast<float>(unit), expected.fx[i] / unit);
      differ(felt.fy[i] / static_cast<float>(unit), expected.fy[i] / unit);
      differ(felt.moment[i] / static_cast<float>(unit * 0.005), expected.moment[i] / (unit * 0.005));
    }
  }
  EXPECT_LE(worst, 1e-5);
  EXPECT_GT(worst, 1e-9);
}

template <class Real>
class BatchOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(BatchOf, Reals);

// It sticks up to the curve, within the precision, and slips from the onset on, in all directions.
TYPED_TEST(BatchOf, SlipBeginsOnTheCurve) {
  using Real = TypeParam;
  constexpr double onset = double{slip_onset<Real>} - 1.0;
  for (const Case<Real>& with : cases<Real>()) {
    if (with.with.mu_r) continue;
    const BasicBatch<Real> batch(with.curve, with.with, with.projection);
    constexpr std::size_t count = 180;
    for (const double share : {1.0 - onset, 1.0 + 2.0 * onset}) {
      BasicContactArrays<Real> arrays(count);
      std::ranges::fill(arrays.depth(), Real(0.002));
      batch.step(arrays.batch());
      const double load = with.with.stiffness * double{arrays.depth()[0]};
      const double unit = share * with.with.mu * load;
      for (std::size_t i = 0; i < count; ++i) {
        const double angle = 0.5 * std::numbers::pi * (static_cast<double>(i) + 0.5) / count;
        const UnitWrench limit =
            with.curve.along({std::cos(angle), with.curve.moment_ratio() * std::sin(angle)}).wrench;
        arrays.y()[i] = static_cast<Real>(limit.force * unit / with.with.stiffness);
        arrays.twist()[i] =
            static_cast<Real>(limit.moment * unit * with.with.radius_law.radius(load) / with.with.twist_stiffness);
      }
      batch.step(arrays.batch());
      const ContactState expected = share < 1.0 ? ContactState::stick : ContactState::slip;
      EXPECT_EQ(std::ranges::count(arrays.batch().state, expected), static_cast<int>(count))
          << with.name << ' ' << share;
    }
  }
}

TYPED_TEST(BatchOf, SlipWorkIsNeverNegativeAndTheWrenchIsWithinTheLimit) {
  using Real = TypeParam;
  constexpr std::size_t count = 501;
  for (const Case<Real>& with : cases<Real>()) {
    if (with.with.mu_r.value_or(0.0) > 0.0) continue;  // its limits are in another unit
    const BasicBatch<Real> batch(with.curve, with.with, with.projection);
    BasicContactArrays<Real> arrays(count);
    const BasicContactBatch<Real> result = arrays.batch();
    Random random(17);
    double outmost = 0.0;
    int slips = 0;
    for (int round = 0; round < 40; ++round) {
      move_all(arrays, random, round % 2 == 0 ? 1e-2 : 1e-4);
      const std::vector<Real> before = written(result);
      batch.step(result);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(std::isfinite(result.fx[i]) && std::isfinite(result.fy[i]) && std::isfinite(result.moment[i]))
            << with.name;
        if (!(result.depth[i] > Real(0))) continue;
        const Real* const last = &before[i * numbers_per_contact];
        // Each component for itself: the proxy comes nearer, against the force on the user.
        if (last[8] != static_cast<Real>(ContactState::free)) {
          ASSERT_LE(result.fx[i] * (result.proxy_x[i] - last[0]), Real(0)) << with.name;
          ASSERT_LE(result.fy[i] * (result.proxy_y[i] - last[1]), Real(0)) << with.name;
          ASSERT_LE(result.moment[i] * (result.proxy_angle[i] - last[2]), Real(0)) << with.name;
        }
        const double load = with.with.stiffness * static_cast<double>(result.depth[i]);
        const double unit = with.with.mu * load;
        const double force = std::hypot(double{result.fx[i]}, double{result.fy[i]}) / unit;
        const double moment = std::fabs(double{result.moment[i]}) / (unit * with.with.radius_law.radius(load));
        const bool has_torsion = with.with.mu_r != 0.0;
        outmost = std::max(outmost, has_torsion ? with.curve.gauge({force, moment}) : std::max(force, moment));
        slips += result.state[i] == ContactState::slip;
      }
    }
    EXPECT_GT(slips, 500) << with.name;
    EXPECT_LE(outmost, most_gauge<Real>) << with.name;
    EXPECT_GT(outmost, 0.99) << with.name;
  }
}

// Dragged into slipping, then held where they are: from the next step on nothing moves. Far out too, where a float
// resolves a tenth of a micrometre, which is a large share of what slides there.
TYPED_TEST(BatchOf, AHeldContactKeepsEveryBit) {
  using Real = TypeParam;
  constexpr std::size_t count = 1001;
  for (const double far : {0.01, 2.0, 100.0}) {
    for (const Case<Real>& with : cases<Real>()) {
      const BasicBatch<Real> batch(with.curve, with.with, with.projection);
      BasicContactArrays<Real> arrays(count);
      const BasicContactBatch<Real> result = arrays.batch();
      Random random(11);
      for (std::size_t i = 0; i < count; ++i) {
        arrays.x()[i] = static_cast<Real>(random.uniform(-far, far));
        arrays.y()[i] = static_cast<Real>(random.uniform(-far, far));
        arrays.twist()[i] = static_cast<Real>(random.uniform(-10.0 * far, 10.0 * far));
        arrays.depth()[i] = static_cast<Real>(random.logarithmic(1e-5, 1e-2));
      }
      batch.step(result);
      for (std::size_t i = 0; i < count; ++i) {
        const double reach = random.logarithmic(1e-4, 1e-1);
        arrays.x()[i] += static_cast<Real>(random.uniform(-reach, reach));
        arrays.y()[i] += static_cast<Real>(random.uniform(-reach, reach));
        arrays.twist()[i] += static_cast<Real>(random.uniform(-100.0, 100.0) * reach);
      }
      batch.step(result);
      ASSERT_GT(std::ranges::count(result.state, ContactState::slip), 100) << with.name;
      batch.step(result);
      const std::vector<Real> held = written(result);
      ASSERT_EQ(std::ranges::count(result.state, ContactState::slip), 0) << with.name << ' ' << far;
      for (int hold = 0; hold < 8; ++hold) {
        batch.step(result);
        ASSERT_EQ(written(result), held) << with.name << ' ' << far << ' ' << hold;
      }
      if (with.with.mu_r) continue;  // its limits are in another unit
      // The closest point measures the excess beyond its tangent, which is the gauge's but for its square.
      for (std::size_t i = 0; i < count; ++i) {
        const double load = with.with.stiffness * double{result.depth[i]};
        const UnitWrench unit{with.with.mu * load, with.with.mu * load * with.with.radius_law.radius(load)};
        const double slide = std::fabs(double{result.proxy_x[i]}) + std::fabs(double{result.proxy_y[i]});
        const double rounding = 0.5 * double{std::numeric_limits<Real>::epsilon()} *
                                (with.with.stiffness * slide / unit.force +
                                 with.with.twist_stiffness * std::fabs(double{result.proxy_angle[i]}) /
                                     (unit.moment * with.curve.moment_ratio()));
        const double force = std::hypot(double{result.fx[i]}, double{result.fy[i]}) / unit.force;
        ASSERT_LE(with.curve.gauge({force, std::fabs(double{result.moment[i]}) / unit.moment}),
                  most_gauge<Real> + rounding * (1.0 + 4.0 * rounding))
            << with.name << ' ' << far;
      }
    }
  }
}

// The memory is the caller's: what he never wrote may be NaN.
TYPED_TEST(BatchOf, AProxyThatIsNaNIsAFaultUntilTheContactEnds) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  constexpr std::size_t count = 37;
  for (const Case<Real>& with : cases<Real>()) {
    const BasicBatch<Real> batch(with.curve, with.with, with.projection);
    Random random(29);
    BasicContactArrays<Real> arrays(count);
    const BasicContactBatch<Real> contacts = arrays.batch();
    const std::array memory{contacts.proxy_x, contacts.proxy_y, contacts.proxy_angle, contacts.search_start,
                            contacts.search_rate};
    const auto step = [&](double depth) {
      std::ranges::fill(arrays.depth(), static_cast<Real>(depth));
      for (Real& x : arrays.x()) x = static_cast<Real>(random.uniform(-2e-3, 2e-3));
      for (Real& twist : arrays.twist()) twist = static_cast<Real>(random.uniform(-0.3, 0.3));
      batch.step(contacts);
    };
    const auto is_number = [](Real number) { return std::isfinite(number) && std::fabs(number) < Real(1e6); };
    for (const Real odd :
         {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), (Limits::max)(), Limits::lowest()}) {
      for (std::size_t broken = 0; broken < memory.size(); ++broken) {
        step(0.002);
        for (std::size_t i = 0; i < count; i += 3) memory[broken][i] = odd;
        for (int again = 0; again < 2; ++again) {
          step(0.002);
          for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(contacts.state[i] == ContactState::invalid, broken < 3 && i % 3 == 0)
                << with.name << ' ' << broken << ' ' << odd;
            ASSERT_TRUE(is_number(contacts.fx[i]) && is_number(contacts.fy[i]) && is_number(contacts.moment[i]))
                << with.name;
          }
        }
        step(-0.002);
        EXPECT_EQ(std::ranges::count(contacts.state, ContactState::free), static_cast<int>(count)) << with.name;
        for (std::size_t proxy = 0; proxy < 3; ++proxy)
          EXPECT_TRUE(std::ranges::all_of(memory[proxy], is_number)) << with.name;
        std::ranges::fill(contacts.search_start, Real(0));
        std::ranges::fill(contacts.search_rate, Real(0));
      }
    }
  }
}

// Batches remember both slip states: contact by contact what a finger does.
TEST(FloatBatch, OfABoxRemembersBothSlips) {
  constexpr std::size_t count = 67;
  FingerParameters with = parameters(0.6, 0.005, 1000.0, 0.04);
  with.mu_dynamic = 0.3;
  const auto limits = box(1.0, hertz()->moment_ratio());
  const FloatBatch batch(limits, with);
  std::vector<SoftFinger> fingers(count, SoftFinger(limits, with));
  FloatContactArrays arrays(count);
  Random random(11);
  int only_one = 0;
  for (int step = 0; step < 300; ++step) {
    for (std::size_t i = 0; i < count; ++i) {
      // Even contacts slide and hold their twist near its sticking limit, odd ones turn and hold their position.
      const bool slides = i % 2 == 0;
      arrays.x()[i] = static_cast<float>(slides ? 1e-5 * step : 5e-4 * std::min(step / 10.0, 1.0));
      arrays.twist()[i] = static_cast<float>(slides ? 0.04 * std::min(step / 10.0, 1.0) : 1e-3 * step);
      arrays.depth()[i] = 0.001F;
    }
    const FloatContactBatch contacts = arrays.batch();
    batch.step(contacts);
    for (std::size_t i = 0; i < count; ++i) {
      const FingerOutput output =
          fingers[i].update(on_plane(double{contacts.x[i]}, 0.0, double{contacts.depth[i]}), double{contacts.twist[i]});
      SCOPED_TRACE(testing::Message() << step << ' ' << i);
      ASSERT_EQ(contacts.state[i], output.state);
      ASSERT_NEAR(double{contacts.fx[i]}, output.force.x(), 1e-5);
      ASSERT_NEAR(double{contacts.moment[i]}, output.moment, 5e-8);
      ASSERT_EQ(contacts.force_slides[i] == ContactState::slip, fingers[i].state().friction.force_slides);
      ASSERT_EQ(contacts.moment_slides[i] == ContactState::slip, fingers[i].state().friction.moment_slides);
      only_one += (contacts.force_slides[i] == ContactState::slip) != (contacts.moment_slides[i] == ContactState::slip);
    }
  }
  EXPECT_GT(only_one, 1000);
}

}  // namespace
}  // namespace limitcurve::godobject::test
