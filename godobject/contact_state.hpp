// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limitcurve::godobject {

/// What a finger does.
enum class ContactState {
  free,     ///< not touching: depth ≤ 0
  stick,    ///< touching, the proxy rests on the surface
  slip,     ///< touching, the proxy slid in this step
  invalid,  ///< the input was not usable: the last good output is held
};

/// "free", "stick", "slip", "invalid".
constexpr std::string_view to_string(ContactState state) noexcept {
  switch (state) {
    case ContactState::free:
      return "free";
    case ContactState::stick:
      return "stick";
    case ContactState::slip:
      return "slip";
    case ContactState::invalid:
      break;
  }
  return "invalid";
}

}  // namespace limitcurve::godobject
