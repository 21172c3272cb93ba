// SPDX-License-Identifier: MIT
#pragma once

#if !(__cplusplus >= 202002L || (defined(_MSVC_LANG) && _MSVC_LANG >= 202002L))
#error "limitcurve needs C++20; in C++11, 14 and 17 include limitcurve11.hpp of the C interface"
#include "limitcurve11.hpp instead"  // GCC and Clang go on after #error, but not without a file
#endif

#include <string_view>

namespace limitcurve {

/// The version of the library; the build reads it from here.
inline constexpr std::string_view version = "0.3.0";

}  // namespace limitcurve
