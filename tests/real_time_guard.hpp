// SPDX-License-Identifier: MIT
// What a servo loop must not do, caught in the act: calls of the allocator and locks, counted, and calls of the system,
// caged. It defines malloc and its kin and pthread_mutex_lock for the whole executable. Where it cannot (no glibc, or a
// sanitizer, which brings an allocator of its own), LIMITCURVE_GUARDS_REAL_TIME is not defined, nor is anything else.
#pragma once

#include <cstddef>
#include <cstdlib>

// GCC has macros for this, Clang features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIMITCURVE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LIMITCURVE_SANITIZED 1
#endif
#endif

#if defined(__linux__) && defined(__GLIBC__) && !defined(LIMITCURVE_SANITIZED)
#define LIMITCURVE_GUARDS_REAL_TIME 1

#include <dlfcn.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limitcurve::test {

inline constinit thread_local bool thread_is_watched = false;
inline constinit thread_local int watched_calls = 0;

/// How often this thread allocates, frees or locks during `body`. What throws allocates.
template <class Body>
int allocations_and_locks(Body&& body) {
  watched_calls = 0;
  thread_is_watched = true;
  body();
  thread_is_watched = false;
  return watched_calls;
}

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

}  // namespace limitcurve::test

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void __libc_free(void* memory);

[[gnu::weak]] void* malloc(std::size_t size) {
  limitcurve::test::watched_calls += limitcurve::test::thread_is_watched;
  return __libc_malloc(size);
}
[[gnu::weak]] void* calloc(std::size_t count, std::size_t size) {
  limitcurve::test::watched_calls += limitcurve::test::thread_is_watched;
  return __libc_calloc(count, size);
}
[[gnu::weak]] void* realloc(void* memory, std::size_t size) {
  limitcurve::test::watched_calls += limitcurve::test::thread_is_watched;
  return __libc_realloc(memory, size);
}
[[gnu::weak]] void free(void* memory) {
  limitcurve::test::watched_calls += limitcurve::test::thread_is_watched;
  __libc_free(memory);
}
[[gnu::weak]] int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  limitcurve::test::watched_calls += limitcurve::test::thread_is_watched;
  static const auto lock = reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  return lock(mutex);
}
}
#endif
