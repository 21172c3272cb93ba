// SPDX-License-Identifier: MIT
// What packs step is what single numbers step, bit for bit.
#include "godobject/batch/step.hpp"
#include "tests/godobject/batch/batch_cases.hpp"

#include <thread>
#include <type_traits>

namespace limitcurve::godobject::test::pack_test {
namespace {

using kernel::InstructionSet;

constexpr std::array all_sets{InstructionSet::single, InstructionSet::baseline, InstructionSet::avx2,
                              InstructionSet::avx512};

std::string name_of(InstructionSet set) {
  return std::array{"single", "baseline", "avx2", "avx512"}[static_cast<std::size_t>(set)];
}

/// The arrays of a batch that a step writes.
template <class Real>
std::array<std::span<Real>, 8> outputs(const BasicContactBatch<Real>& batch) {
  return {batch.proxy_x,     batch.proxy_y, batch.proxy_angle, batch.search_start,
          batch.search_rate, batch.fx,      batch.fy,          batch.moment};
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

/// Numbers of every kind.
template <class Real, class Limits = std::numeric_limits<Real>>
constexpr std::array<Real, 22> odd{0,
                                   -Real(0),
                                   Limits::denorm_min(),
                                   Limits::min(),
                                   Real(-1e-30),
                                   Real(1e-20),
                                   Real(1e-12),
                                   Real(-1e-6),
                                   Real(1e-3),
                                   Real(0.002),
                                   Real(0.003),
                                   Real(-0.01),
                                   1,
                                   Real(1e3),
                                   Real(9e5),
                                   Real(-1e6),
                                   Real(1e7),
                                   Real(1e9),
                                   Limits::max(),
                                   Limits::quiet_NaN(),
                                   Limits::infinity(),
                                   -Limits::infinity()};

/// Moves contacts at random: as a rule by little, some far; some free; some numbers are odd.
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
      if (!(std::fabs(y) < Real(1))) y = 0;
      if (!(std::fabs(angle) < Real(10))) angle = 0;
      x += static_cast<Real>(between(-stride, stride));
      y += static_cast<Real>(between(-stride, stride));
      angle += static_cast<Real>(100.0 * between(-stride, stride));
      arrays.depth()[i] = static_cast<Real>(between(-0.0003, 0.003));
      for (Real* const number : {&x, &y, &angle, &arrays.depth()[i]}) {
        if (between(0.0, 1.0) < 0.05) *number = odd<Real>[engine_() % odd<Real>.size()];
      }
    }
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  std::mt19937_64 engine_{5};
};

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
  std::vector<Case<Real>> all = cases<Real>();
  all.push_back({"no friction", all.back().curve, parameters(0.0)});
  for (const Case<Real>& with : all) {
    const ContactLimits limits(with.with, with.curve.moment_max());
    const kernel::Shared<Real> shared{with.curve.view(), with.projection, limits,
                                      static_cast<Real>(with.with.stiffness),
                                      static_cast<Real>(with.with.twist_stiffness)};
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
        ASSERT_NO_FATAL_FAILURE(expect_same_bits(arrays[0].batch(), batch, with.name + ", " + name_of(all_sets[k])));
      }
      for (const ContactState state : arrays[0].batch().state) {
        slips += state == ContactState::slip;
        sticks += state == ContactState::stick;
      }
      for (const auto array : outputs(arrays[0].batch())) {
        for (const Real value : array) ASSERT_TRUE(std::isfinite(value)) << with.name;
      }
    }
    EXPECT_GT(slips, 0u) << with.name;
    EXPECT_GT(sticks, 0u) << with.name;
  }
}

TYPED_TEST(Packs, StepPartsOnTwoThreadsAsTheWhole) {
  using Real = TypeParam;
  constexpr std::size_t count = 1001;
  const BasicBatch<Real> batch(BasicTable<Real>::build(hertz(), 1e-6), {.mu = 0.6});
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

}  // namespace
}  // namespace limitcurve::godobject::test::pack_test
