// SPDX-License-Identifier: MIT
#include "c/handle.hpp"

#include "limitcurve/version.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <string>

#ifndef NDEBUG
#include <mutex>
#include <unordered_set>
#endif

namespace limitcurve::c {

namespace {

thread_local std::array<char, 1024> last_message{};

}  // namespace

limitcurve_status complain(limitcurve_status status, const char* message) noexcept {
  std::snprintf(last_message.data(), last_message.size(), "%s", message);
  return status;
}

limitcurve_status refuse(const char* name, const char* what) noexcept {
  std::snprintf(last_message.data(), last_message.size(), "%s: %s", name, what);
  return LIMITCURVE_INVALID;
}

limitcurve_status refuse(const char* name, std::size_t index, double value, const char* expected) noexcept {
  std::array<char, 32> number{};
  std::to_chars(number.data(), number.data() + number.size() - 1, value);
  std::snprintf(last_message.data(), last_message.size(), "%s[%zu]: got %s, expected %s", name, index, number.data(),
                expected);
  return LIMITCURVE_INVALID;
}

limitcurve_status refuse(std::string_view name, double value, std::string_view expected) noexcept {
  std::array<char, 32> number{};
  std::to_chars(number.data(), number.data() + number.size() - 1, value);
  std::snprintf(last_message.data(), last_message.size(), "%.*s: got %s, expected %.*s", static_cast<int>(name.size()),
                name.data(), number.data(), static_cast<int>(expected.size()), expected.data());
  return LIMITCURVE_INVALID;
}

#ifndef NDEBUG

namespace {

std::mutex mutex;
std::unordered_set<const void*>& living() {
  static auto* const handles = new std::unordered_set<const void*>;  // never destroyed: handles may be freed at exit
  return *handles;
}

}  // namespace

void remember(const void* handle) noexcept {
  const std::lock_guard lock(mutex);
  living().insert(handle);
}
void forget(const void* handle) noexcept {
  const std::lock_guard lock(mutex);
  living().erase(handle);
}
bool is_alive(const void* handle) noexcept {
  const std::lock_guard lock(mutex);
  return living().contains(handle);
}

#endif

}  // namespace limitcurve::c

const char* limitcurve_error(void) {
  return limitcurve::c::last_message.data();
}

const char* limitcurve_version(void) {
  static const std::string text(limitcurve::version);
  return text.c_str();
}
