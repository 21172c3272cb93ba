// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <concepts>

/// How a single number is read from and written to the arrays of a batch. Packs have the same names (pack.hpp); a last argument that is not
/// used says of how many lanes.
namespace limitcurve::godobject::kernel {

template <std::floating_point Number>
[[nodiscard]] Number load(const Number* from, Number) noexcept {
  return *from;
}
template <std::floating_point Number>
void store_where(bool condition, Number* to, Number value) noexcept {
  if (condition) *to = value;
}
template <std::floating_point Number>
[[nodiscard]] bool has_state(const ContactState* states, ContactState wanted, Number) noexcept {
  return *states == wanted;
}
template <std::floating_point Number>
void set_states(ContactState* states, bool is_plausible, bool touches, bool slips, Number) noexcept {
  if (is_plausible) *states = !touches ? ContactState::free : slips ? ContactState::slip : ContactState::stick;
}

}  // namespace limitcurve::godobject::kernel
