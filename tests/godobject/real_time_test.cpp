// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

// The sanitizers bring an allocator of their own. GCC tells by macros, Clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIMITCURVE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LIMITCURVE_SANITIZED 1
#endif
#endif
#if !defined(LIMITCURVE_SANITIZED)
#define LIMITCURVE_WATCHES_MALLOC 1

namespace {
thread_local bool watching = false;
thread_local int calls = 0;
void note() noexcept {
  calls += watching;
}
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
  note();
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  note();
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  note();
  return __libc_realloc(memory, size);
}
void free(void* memory) {
  note();
  __libc_free(memory);
}
}
#endif

namespace limitcurve::godobject::test {
namespace {

#ifdef LIMITCURVE_WATCHES_MALLOC
/// Calls of the allocator during `body`.
template <class Body>
int allocations(Body&& body) {
  calls = 0;
  watching = true;
  body();
  watching = false;
  return calls;
}

TEST(RealTime, TheGuardSeesAnAllocation) {
  EXPECT_GT(allocations([] { delete new volatile int(3); }), 0);
  EXPECT_GT(allocations([] {
              volatile std::size_t size = 100;
              std::vector<double> v(size);
              volatile double sink = v[0];
              static_cast<void>(sink);
            }),
            0);
}

TEST(RealTime, AStepAllocatesNothing) {
  for (const ProjectionKind kind : {ProjectionKind::radial, ProjectionKind::c_curve, ProjectionKind::closest_point}) {
    visit_projection(kind, [&](auto projection) {
      for_each_boundary(uniform(), [&](const auto& boundary, std::string_view name) {
        FingerParameters with = parameters();
        with.radius_law = RadiusLaw::hertz(0.008, 2e5);
        SoftFinger finger(boundary, with, projection);
        const int count = allocations([&] {
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
#endif

#if defined(__linux__) && defined(LIMITCURVE_WATCHES_MALLOC)
/// Whether `body` runs to its end in a process that is killed at any system call but read, write and exit.
template <class Body>
bool runs_without_system_calls(Body&& body) {
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT);
    body();
    syscall(SYS_exit, 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
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
