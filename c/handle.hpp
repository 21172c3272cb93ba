// SPDX-License-Identifier: MIT
#pragma once

#include "c/limitcurve.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

/// Errors and handles, for every function of the C interface.
namespace limitcurve::c {

// What bears LIMITCURVE_API is for liblimitcurve-c-fit, whose errors and handles are those of liblimitcurve-c.

/// Stores the message for limitcurve_error(), truncated to the thread's fixed buffer. No allocation.
LIMITCURVE_API limitcurve_status complain(limitcurve_status status, const char* message) noexcept;
/// "NAME: WHAT", "NAME[INDEX]: got VALUE, expected EXPECTED", "NAME: got VALUE, expected EXPECTED". No allocation.
LIMITCURVE_API limitcurve_status refuse(const char* name, const char* what) noexcept;
LIMITCURVE_API limitcurve_status refuse(const char* name, std::size_t index, double value,
                                        const char* expected) noexcept;
LIMITCURVE_API limitcurve_status refuse(std::string_view name, double value, std::string_view expected) noexcept;

/// Whether one of the caller's numbers is not finite; refuses it.
inline bool refuse_numbers(const char* name, const double* numbers, std::size_t count) noexcept {
  const double* const bad =
      std::find_if(numbers, numbers + count, [](double number) { return !std::isfinite(number); });
  if (bad == numbers + count) return false;
  refuse(name, static_cast<std::size_t>(bad - numbers), *bad, "a finite number");
  return true;
}

/// The floating-point unit's defaults in place of the host's: Mono and Visual C++ let long double count 53 bits only,
/// others trap or round elsewhere, and stated errors would not hold.
class DefaultArithmetic {
 public:
  DefaultArithmetic() noexcept {
    std::fegetenv(&host_);
#ifdef FE_PC64_ENV  // MinGW's default may have 53 bits
    std::fesetenv(FE_PC64_ENV);
#else
    std::fesetenv(FE_DFL_ENV);
#endif
  }
  ~DefaultArithmetic() {
    std::fesetenv(&host_);
  }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t host_;
};

/// Runs `work` in default arithmetic; turns exceptions into a status and a message.
template <class Work>
limitcurve_status guarded(const Work& work) noexcept {
  const DefaultArithmetic arithmetic;
  try {
    work();
    return LIMITCURVE_OK;
  } catch (const std::invalid_argument& error) {
    return complain(LIMITCURVE_INVALID, error.what());
  } catch (const std::bad_alloc&) {
    return complain(LIMITCURVE_FAILED, "no memory");
  } catch (const std::exception& error) {
    return complain(LIMITCURVE_FAILED, error.what());
  } catch (...) {
    return complain(LIMITCURVE_FAILED, "unknown failure");
  }
}

#ifdef NDEBUG
inline void remember(const void*) noexcept {}
inline void forget(const void*) noexcept {}
inline bool is_alive(const void*) noexcept {
  return true;
}
#else
/// The set of live handles; only without NDEBUG, because it takes a lock.
LIMITCURVE_API void remember(const void* handle) noexcept;
LIMITCURVE_API void forget(const void* handle) noexcept;
LIMITCURVE_API bool is_alive(const void* handle) noexcept;
#endif

/// Returns true, and stores a message for limitcurve_error(), if the caller's pointer for `name` is bad.
inline bool is_missing(const char* name, const void* pointer) noexcept {
  if (pointer != nullptr) return false;
  refuse(name, "got NULL");
  return true;
}
/// Whether one of several is.
inline bool any_missing(std::initializer_list<std::pair<const char*, const void*>> pointers) noexcept {
  return std::any_of(pointers.begin(), pointers.end(),
                     [](const auto& one) { return is_missing(one.first, one.second); });
}
inline bool is_no_handle(const char* name, const void* handle) noexcept {
  if (is_missing(name, handle)) return true;
  if (is_alive(handle)) return false;
  refuse(name, "the handle was freed");
  return true;
}

/// Creates a handle for the caller. `make` returns the handle's contents.
template <class Handle, class Make>
limitcurve_status make_handle(Handle** handle, const Make& make) noexcept {
  if (is_missing("result", handle)) return LIMITCURVE_INVALID;
  return guarded([&] {
    auto made = std::make_unique<Handle>(make());
    remember(made.get());
    *handle = made.release();
  });
}

template <class Handle>
void free_handle(Handle* handle) noexcept {
  if (handle == nullptr || !is_alive(handle)) return;
  forget(handle);
  delete handle;
}

}  // namespace limitcurve::c
