// SPDX-License-Identifier: MIT
// Nothing allocates once it is built.
#include "tests/limitcurve/shared.hpp"
#include "tests/real_time_guard.hpp"

#ifdef LIMITCURVE_GUARDS_REAL_TIME
namespace limitcurve::test {
namespace {

template <LimitCurve Curve>
void expect_no_allocation(const char* what, const Curve& curve) {
  static_assert(noexcept(curve.wrench(SlipTwist{}))&& noexcept(curve.point(SlipTwist{})));
  static_assert(noexcept(curve.along(UnitWrench{}))&& noexcept(curve.gauge(UnitWrench{})));
  double sum = 0.0;
  const int count = allocations_and_locks([&] {
    for (const double s : {0.0, 1e-200, 0.3, 1.0, 1.2, 5.0, 1e200}) {
      const SlipTwist twist = SlipTwist::about_cor(s);
      const UnitWrench wrench = curve.wrench(twist);
      sum += curve.point(twist).slope.moment + curve.along(wrench).normal.spin + curve.gauge(wrench);
    }
  });
  EXPECT_EQ(count, 0) << what;
  EXPECT_GT(sum, 0.0);
}

TEST(Allocation, NoCurveAllocates) {
  EXPECT_GT(allocations_and_locks([] { delete new volatile int(3); }), 0);
  expect_no_allocation("ellipse", Ellipse(1.0, 0.6));
  expect_no_allocation("box", box(1.0, 0.6));
  expect_no_allocation("diamond", diamond(1.0, 0.6));
  expect_no_allocation("table", Table::build(uniform(), 1e-6));
}

TEST(Allocation, NoLawAllocates) {
  for (const std::string_view name : law_examples()) {
    const Law law = parse_law(name);
    expect_no_allocation(name.data(), ExactCurve(law));
    for (const Method method : {Method::automatic, Method::closed, Method::ring, Method::punch}) {
      if (!law->allows(method)) continue;
      EXPECT_EQ(allocations_and_locks([&] { static_cast<void>(law->evaluate(0.7, method)); }), 0)
          << name << ' ' << to_string(method);
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
#endif
