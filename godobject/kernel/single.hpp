// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <concepts>

/// Reading and writing the arrays of a batch, for a single number. pack.hpp has the same functions for packs; the last argument, which is
/// not used, has the type of the number or pack.
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
