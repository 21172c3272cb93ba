// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>

/// Reading and writing arrays, for a single number. pack.hpp has the same functions for packs; the last argument, which is not used, has the
/// type of the number or pack.
namespace limitcurve::godobject::kernel {

template <std::floating_point Number>
[[nodiscard]] Number load(const Number* from, Number) noexcept {
  return *from;
}
template <std::floating_point Number>
void store_where(bool condition, Number* to, Number value) noexcept {
  if (condition) *to = value;
}
template <class State, std::floating_point Number>
[[nodiscard]] bool has_state(const State* states, State wanted, Number) noexcept {
  return *states == wanted;
}
template <class State, std::floating_point Number>
void set_states_where(bool where, State* states, bool first, bool second, const std::array<State, 3>& values, Number) noexcept {
  if (where) *states = !first ? values[0] : !second ? values[1] : values[2];
}

}  // namespace limitcurve::godobject::kernel
