// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limitcurve {

/// The version of the library; the build reads it from here.
inline constexpr std::string_view version = "0.3.0";

}  // namespace limitcurve
