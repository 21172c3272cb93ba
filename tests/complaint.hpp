// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace limitcurve::test {

/// What `make` complains about its input; "none" if it accepts.
template <class Error = std::invalid_argument, class Make>
std::string complaint(const Make& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

inline void expect_mention(const std::string& text, const std::string& what) {
  EXPECT_NE(text.find(what), std::string::npos) << text;
}

}  // namespace limitcurve::test
