// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"
#include "tests/real_time_guard.hpp"

#include <gtest/gtest.h>

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
  EXPECT_GT(allocations_and_locks([] {
              volatile std::size_t size = 100;
              std::vector<double> v(size);
              volatile double sink = v[0];
              static_cast<void>(sink);
            }),
            0);
}

TEST(RealTime, AStepNeitherAllocatesNorLocks) {
  for (const ProjectionKind kind : {ProjectionKind::radial, ProjectionKind::c_curve, ProjectionKind::closest_point}) {
    visit_projection(kind, [&](auto projection) {
      for_each_boundary(uniform(), [&](const auto& boundary, std::string_view name) {
        FingerParameters with = parameters();
        with.radius_law = RadiusLaw::hertz(0.008, 2e5);
        SoftFinger finger(boundary, with, projection);
        const int count = allocations_and_locks([&] {
          for (int i = 0; i < 500; ++i) {
            finger.update(on_plane(i * 1e-4, i * 2e-5, 0.002 - i * 5e-6), i * 0.01);
            static_cast<void>(finger.margin());
          }
          finger.update(on_plane(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), 0.0);
        });
        EXPECT_EQ(count, 0) << name << ' ' << to_string(kind);
      });
    });
  }
}

TEST(RealTime, ABatchOfFloatsNeitherAllocatesNorLocks) {
  const FloatTable table = FloatTable::build(uniform(), 1e-6);
  const Friction friction(table, parameters(), ClosestPoint{});
  constexpr std::size_t contacts = 300;
  std::array<std::vector<float>, 12> arrays;
  for (auto& array : arrays) array.assign(contacts, 0.0F);
  auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays;
  depth.assign(contacts, 0.002F);
  start.assign(contacts, -2.0F);
  const FloatContactBatch batch{x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment};
  EXPECT_EQ(allocations_and_locks([&] {
              for (int i = 0; i < 100; ++i) {
                for (std::size_t k = 0; k < contacts; ++k) x[k] += 1e-5F * static_cast<float>(k);
                angle[7] = i == 50 ? std::numeric_limits<float>::quiet_NaN() : 0.01F;
                step(friction, batch);
              }
            }),
            0);
  EXPECT_GT(start[200], 0.0F);
}

TEST(RealTime, TheCageHoldsWhatCallsTheSystem) {
  EXPECT_FALSE(runs_without_system_calls([] { syscall(SYS_getppid); }));
}

TEST(RealTime, AMillionStepsMakeNoSystemCall) {
  SoftFinger coupled(Ellipse::through_intercepts(hertz()->moment_ratio()), parameters(), Radial{});
  SoftFinger exact(Table::build(hertz(), 1e-8), parameters(), ClosestPoint{});
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
  using Finger = SoftFinger<Table, ClosestPoint>;
  static_assert(noexcept(std::declval<Finger&>().update(std::declval<const Contact&>(), 0.0)));
  static_assert(noexcept(std::declval<Finger&>().restore(std::declval<const FingerState&>())));
  static_assert(noexcept(std::declval<const Finger&>().margin()));
  static_assert(noexcept(std::declval<Replay&>().step(TraceSample{})));
}

}  // namespace
}  // namespace limitcurve::godobject::test
