// SPDX-License-Identifier: MIT
// Nothing allocates once it is built: every `new` of this executable is counted.
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace {

thread_local long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The pairs that the standard library's others fall back on; the one that does not throw too, which a sanitizer brings
// itself.
void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace limitcurve::test {

namespace {

/// Allocations while `call` runs.
template <class Call>
long allocations_in(Call&& call) {
  const long before = allocations;
  call();
  return allocations - before;
}

TEST(Allocation, IsNoticedByTheGuard) {
  EXPECT_EQ(allocations_in([] {}), 0);
  EXPECT_GE(allocations_in([] { std::make_unique<int>(1); }), 1);
  EXPECT_GE(allocations_in([] { std::vector<double> values(100, 1.0); }), 1);
}

template <LimitCurve Curve>
void expect_no_allocation(const char* what, const Curve& curve) {
  static_assert(noexcept(curve.wrench(SlipTwist{}))&& noexcept(curve.point(SlipTwist{})));
  static_assert(noexcept(curve.along(UnitWrench{}))&& noexcept(curve.gauge(UnitWrench{})));
  double sum = 0.0;
  const long count = allocations_in([&] {
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
      EXPECT_EQ(allocations_in([&] { static_cast<void>(law->evaluate(0.7, method)); }), 0)
          << name << ' ' << to_string(method);
    }
  }
}

}  // namespace

}  // namespace limitcurve::test
