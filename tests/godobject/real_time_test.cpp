// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"
#include "tests/real_time_guard.hpp"

#include <mutex>

namespace limitcurve::godobject::test {
namespace {

#ifdef LIMITCURVE_GUARDS_REAL_TIME
using limitcurve::test::allocations_and_locks;
using limitcurve::test::runs_without_system_calls;

TEST(RealTime, TheGuardSeesAnAllocationAndALock) {
  EXPECT_GT(allocations_and_locks([] { delete new volatile int(3); }), 0);
  std::mutex mutex;
  EXPECT_GT(allocations_and_locks([&] { const std::lock_guard lock(mutex); }), 0);
}

TEST(RealTime, AStepNeitherAllocatesNorLocks) {
  for_each_curve_and_projection(uniform(), [&](const FingerCurve& curve, Projection projection) {
    FingerParameters with = parameters();
    with.radius_law = RadiusLaw::hertz(0.008, 2e5);
    with.damping = 1.0;
    SoftFinger finger(curve, with, projection);
    FingerParameters other = parameters(0.3);
    other.radius_law = RadiusLaw::sampled(std::array<LoadSample, 3>{{{0.5, 3e-3}, {1.0, 4e-3}, {4.0, 6e-3}}});
    const int count = allocations_and_locks([&] {
      for (int i = 0; i < 500; ++i) {
        finger.update(on_plane(i * 1e-4, i * 2e-5, 0.002 - i * 5e-6), i * 0.01, 1e-3);
        finger.update_under_load({i * 1e-4, 0.0, 0.0}, {std::sin(0.1 * i), 0.0, std::cos(0.1 * i)}, 2.0 - 0.01 * i,
                                 i * 0.01, 1e-3);
        static_cast<void>(finger.change(i % 4 == 0 ? other : with));
        static_cast<void>(finger.margin());
        static_cast<void>(finger.load_to_hold());
        static_cast<void>(finger.preview(on_plane(0.0, 0.0, 0.001), 0.0));
      }
      finger.update(on_plane(nan, 0.0, 0.0), 0.0);
    });
    EXPECT_EQ(count, 0);
  });
}

TEST(RealTime, TheCageHoldsWhatCallsTheSystem) {
  EXPECT_FALSE(runs_without_system_calls([] { syscall(SYS_getppid); }));
}

TEST(RealTime, AMillionStepsMakeNoSystemCall) {
  SoftFinger coupled(Ellipse::through_intercepts(hertz()->moment_ratio()), parameters(), Projection::radial);
  SoftFinger exact(Table::build(hertz(), 1e-8), parameters());
  EXPECT_TRUE(runs_without_system_calls([&] {
    for (int i = 0; i < 1'000'000; ++i) {
      const Contact contact = on_plane(1e-5 * (i % 1000), 2e-6 * (i % 777), 0.002 + 1e-6 * (i % 99));
      coupled.update(contact, 1e-3 * i);
      exact.update(contact, 1e-3 * i);
    }
  }));
}
#endif

TEST(RealTime, NothingInTheLoopThrows) {
  static_assert(noexcept(std::declval<SoftFinger&>().update(std::declval<const Contact&>(), 0.0)));
  const Vector3d up = Vector3d::UnitZ();
  const Orientation level = Orientation::Identity();
  static_assert(noexcept(std::declval<SoftFinger&>().update_under_load(up, up, 0.0, 0.0)));
  static_assert(noexcept(std::declval<SoftFinger&>().update_under_load(up, up, 0.0, level)));
  static_assert(noexcept(std::declval<SoftFinger&>().restore(std::declval<const FingerState&>())));
  static_assert(noexcept(std::declval<const SoftFinger&>().margin()));
}

}  // namespace
}  // namespace limitcurve::godobject::test
