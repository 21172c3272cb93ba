// SPDX-License-Identifier: MIT
#include "godobject/batch/batch.hpp"
#include "tests/godobject/scene.hpp"
#include "tests/real_time_guard.hpp"

namespace limitcurve::godobject::test {
namespace {

static_assert(noexcept(std::declval<const Batch&>().step(std::declval<const ContactBatch&>())));

#ifdef LIMITCURVE_GUARDS_REAL_TIME
using limitcurve::test::allocations_and_locks;

template <class Real>
void expect_batch_neither_allocates_nor_locks() {
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::hertz(0.008, 2e5);
  constexpr std::size_t contacts = 300;
  for (const Projection projection : projections) {
    const BasicBatch<Real> batch(BasicTable<Real>::build(uniform(), 1e-6), soft, projection);
    BasicContactArrays<Real> arrays(contacts);
    for (Real& depth : arrays.depth()) depth = Real(0.002);
    const int count = allocations_and_locks([&] {
      for (int i = 0; i < 100; ++i) {
        for (std::size_t k = 0; k < contacts; ++k) arrays.x()[k] += Real(1e-5) * static_cast<Real>(k);
        arrays.twist()[7] = i == 50 ? std::numeric_limits<Real>::quiet_NaN() : Real(0.01);
        batch.step(arrays.batch());
      }
    });
    EXPECT_EQ(count, 0) << to_string(projection);
    EXPECT_EQ(arrays.batch().state[200], ContactState::slip);
  }
}

TEST(BatchRealTime, NeitherAllocatesNorLocks) {
  expect_batch_neither_allocates_nor_locks<double>();
  expect_batch_neither_allocates_nor_locks<float>();
}
#endif

}  // namespace
}  // namespace limitcurve::godobject::test
