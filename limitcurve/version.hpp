// SPDX-License-Identifier: MIT
#pragma once

#if !(__cplusplus >= 202002L || (defined(_MSVC_LANG) && _MSVC_LANG >= 202002L))
#error "limitcurve needs C++20"
#endif

#include <string_view>

namespace limitcurve {

/// The version of the library; the build reads it from here.
inline constexpr std::string_view version = "0.3.0";

}  // namespace limitcurve
