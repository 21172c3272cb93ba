// SPDX-License-Identifier: MIT
// What packs step is what single numbers step, bit for bit; and a batch is what fingers are.
#include "godobject/batch/batch.hpp"
#include "godobject/batch/step.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace limitcurve::godobject::test::pack_test {
namespace {

using kernel::InstructionSet;

constexpr std::array all_sets{InstructionSet::single, InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

std::string name_of(InstructionSet set) {
  return std::array{"single", "baseline", "avx2", "avx512"}[static_cast<std::size_t>(set)];
}

/// The arrays of a batch that a step writes.
template <class Real>
std::array<std::span<Real>, 8> outputs(const BasicContactBatch<Real>& batch) {
  return {batch.proxy_x, batch.proxy_y, batch.proxy_angle, batch.search_start, batch.search_rate, batch.fx, batch.fy, batch.moment};
}

template <class Real>
void expect_same_bits(const BasicContactBatch<Real>& a, const BasicContactBatch<Real>& b, const std::string& where) {
  using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
  for (std::size_t k = 0; k < outputs(a).size(); ++k) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Real left = outputs(a)[k][i];
      const Real right = outputs(b)[k][i];
      ASSERT_EQ(std::bit_cast<Bits>(left), std::bit_cast<Bits>(right))
          << where << ": array " << k << ", contact " << i << ": " << left << " and " << right;
    }
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.state[i], b.state[i]) << where << ": contact " << i;
    ASSERT_EQ(a.force_slides[i], b.force_slides[i]) << where << ": contact " << i;
    ASSERT_EQ(a.moment_slides[i], b.moment_slides[i]) << where << ": contact " << i;
  }
}

/// Moves contacts at random: as a rule by little, some far; some free, a few faults of the device.
class Motion {
 public:
  template <class Real>
  void next(BasicContactArrays<Real>& arrays) {
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const double stride = std::pow(10.0, between(-8.0, -2.0));
      Real& x = arrays.x()[i];
      Real& y = arrays.y()[i];
      Real& angle = arrays.twist()[i];
      if (!(std::fabs(x) < Real(1))) x = 0;
      if (!(std::fabs(angle) < Real(10))) angle = 0;
      x += static_cast<Real>(between(-stride, stride));
      y += static_cast<Real>(between(-stride, stride));
      angle += static_cast<Real>(100.0 * between(-stride, stride));
      arrays.depth()[i] = static_cast<Real>(between(-0.0003, 0.003));
      const double chance = between(0.0, 1.0);
      if (chance < 0.01) x = std::numeric_limits<Real>::quiet_NaN();
      if (chance > 0.01 && chance < 0.02) angle = Real(1e7);
      if (chance > 0.02 && chance < 0.03) arrays.depth()[i] = std::numeric_limits<Real>::quiet_NaN();
      if (chance > 0.03 && chance < 0.04) arrays.depth()[i] = Real(1e9);
      if (chance > 0.04 && chance < 0.05) arrays.depth()[i] = std::numeric_limits<Real>::denorm_min();
      if (chance > 0.05 && chance < 0.06) x = Real(9e5);
    }
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  std::mt19937_64 engine_{5};
};

struct Finger {
  std::string name;
  FingerParameters parameters;
};

std::vector<Finger> fingers() {
  FingerParameters plain;
  plain.mu = 0.6;
  std::vector<Finger> result{{"plain", plain}};
  result.push_back({"mu_d < mu_s", plain});
  result.back().parameters.mu_dynamic = 0.4;
  result.push_back({"a(P)", plain});
  result.back().parameters.radius_law = RadiusLaw::power(0.00207, 0.259);
  result.back().parameters.mu_dynamic = 0.5;
  result.push_back({"two moment coefficients", plain});
  result.back().parameters.mu_r = 0.002;
  result.back().parameters.mu_r_dynamic = 0.001;
  result.push_back({"moment coefficients that grow with the load", result.back().parameters});
  result.back().parameters.gamma = 0.259;
  result.push_back({"no moment", plain});
  result.back().parameters.mu_r = 0.0;
  result.push_back({"no friction", plain});
  result.back().parameters.mu = 0.0;
  return result;
}

template <class Real>
struct Curve {
  std::string name;
  BasicFingerCurve<Real> curve;
  std::vector<Projection> projections;
};

template <class Real>
std::vector<Curve<Real>> curves() {
  constexpr bool is_double = std::is_same_v<Real, double>;
  const std::vector<Projection> all{Projection::radial, Projection::c_curve, Projection::closest_point};
  return {{"ellipse", Ellipse::through_intercepts(hertz()->moment_ratio()), all},
          {"box", limitcurve::box(1.0, hertz()->moment_ratio()), {Projection::closest_point}},
          {"hertz", BasicTable<Real>::build(hertz(), is_double ? 1e-8 : 1e-6), all},
          {"flat punch", BasicTable<Real>::build(flat_punch(), 1e-4), all}};
}

#if defined(LIMITCURVE_PACKS) && (defined(__x86_64__) || defined(__aarch64__))
TEST(PacksOfTheProcessor, AreUsed) {
  EXPECT_TRUE(kernel::is_supported(InstructionSet::baseline));
  EXPECT_NE(kernel::widest_set(), InstructionSet::single);
}
#endif

template <class Real>
class Packs : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Packs, Reals);

TYPED_TEST(Packs, GiveTheBitsOfSingleNumbers) {
  using Real = TypeParam;
  constexpr std::size_t count = 203;  // no multiple of any pack
  for (const Curve<Real>& curve : curves<Real>()) {
    for (const Projection projection : curve.projections) {
      for (const Finger& finger : fingers()) {
        const ContactLimits limits(finger.parameters, curve.curve.moment_max());
        const kernel::Shared<Real> shared{curve.curve.view(), projection, limits, static_cast<Real>(finger.parameters.stiffness),
                                          static_cast<Real>(finger.parameters.twist_stiffness)};
        Motion motion;
        std::vector<BasicContactArrays<Real>> arrays(all_sets.size(), BasicContactArrays<Real>(count));
        std::size_t slips = 0;
        std::size_t sticks = 0;
        for (int step = 0; step < repetitions(60, 6); ++step) {
          motion.next(arrays[0]);
          for (std::size_t k = 0; k < all_sets.size(); ++k) {
            if (!kernel::is_supported(all_sets[k])) continue;
            BasicContactBatch<Real> batch = arrays[k].batch();
            batch.x = arrays[0].x();
            batch.y = arrays[0].y();
            batch.twist = arrays[0].twist();
            batch.depth = arrays[0].depth();
            kernel::step_with(all_sets[k], shared, batch);
            const std::string where = curve.name + ", projection " + std::to_string(static_cast<int>(projection)) + ", " + finger.name +
                                      ", " + name_of(all_sets[k]);
            ASSERT_NO_FATAL_FAILURE(expect_same_bits(arrays[0].batch(), batch, where));
          }
          for (const ContactState state : arrays[0].batch().state) {
            slips += state == ContactState::slip;
            sticks += state == ContactState::stick;
          }
          for (const auto array : outputs(arrays[0].batch())) {
            for (const Real value : array) ASSERT_TRUE(std::isfinite(value)) << curve.name << ", " << finger.name;
          }
        }
        EXPECT_GT(slips, 0u);
        EXPECT_GT(sticks, 0u);
      }
    }
  }
}

TYPED_TEST(Packs, StepPartsOnTwoThreadsAsTheWhole) {
  using Real = TypeParam;
  constexpr std::size_t count = 1001;
  const BasicBatch<Real> batch(curves<Real>()[2].curve, {.mu = 0.6});
  BasicContactArrays<Real> whole(count);
  BasicContactArrays<Real> parts(count);
  Motion motion;
  Motion same;
  for (int step = 0; step < 10; ++step) {
    motion.next(whole);
    same.next(parts);
    batch.step(whole.batch());
    const auto step_part = [&](std::size_t from, std::size_t length) { batch.step(parts.batch().part(from, length)); };
    std::thread other(step_part, 0, 347);
    step_part(347, count - 347);
    other.join();
    ASSERT_NO_FATAL_FAILURE(expect_same_bits(whole.batch(), parts.batch(), "step " + std::to_string(step)));
  }
}

// A finger on the plane z = 0 beside every contact.
TEST(Packs, AreFingersOnAPlane) {
  constexpr std::size_t count = 64;
  for (const Curve<double>& curve : curves<double>()) {
    for (const Projection projection : curve.projections) {
      for (const Finger& parameters : fingers()) {
        const Batch batch(curve.curve, parameters.parameters, projection);
        std::vector<SoftFinger> beside(count, SoftFinger(curve.curve, parameters.parameters, projection));
        ContactArrays arrays(count);
        std::mt19937_64 engine{11};
        const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
        for (int step = 0; step < repetitions(50, 5); ++step) {
          for (std::size_t i = 0; i < count; ++i) {
            const double stride = std::pow(10.0, between(-6.0, -2.5));
            arrays.x()[i] += between(-stride, stride);
            arrays.y()[i] += between(-stride, stride);
            arrays.twist()[i] += 200.0 * between(-stride, stride);
            arrays.depth()[i] = between(-0.0003, 0.003);
          }
          const ContactBatch contacts = arrays.batch();
          batch.step(contacts);
          for (std::size_t i = 0; i < count; ++i) {
            const FingerOutput output =
                beside[i].update({{contacts.x[i], contacts.y[i], 0.0}, Eigen::Vector3d::UnitZ(), contacts.depth[i]}, contacts.twist[i]);
            const std::string where =
                curve.name + ", " + parameters.name + ", step " + std::to_string(step) + ", contact " + std::to_string(i);
            ASSERT_NEAR(contacts.fx[i], output.force.x(), 1e-12) << where;
            ASSERT_NEAR(contacts.fy[i], output.force.y(), 1e-12) << where;
            ASSERT_NEAR(contacts.moment[i], output.moment, 1e-12) << where;
            ASSERT_NEAR(contacts.proxy_x[i], output.proxy.x(), 1e-12) << where;
            ASSERT_NEAR(contacts.proxy_angle[i], output.angle, 1e-12) << where;
            ASSERT_EQ(contacts.state[i], output.state) << where;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::pack_test
