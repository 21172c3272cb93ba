// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/range.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

/// A key of a list such as `from=2,to=0,over=1.5`, and the function that reads its value.
struct KeyValue {
  std::string_view key;
  std::function<void(std::string_view)> take;
  bool required = true;
  std::string_view kind = "NUMBER";  ///< name of the value in error messages
};

/// A key whose value is a number within `range`.
KeyValue number_key(std::string_view key, double& value, const Range& range, bool required = true);
/// A key whose value is an angle: `30deg`, `0.5rad`, or a bare number of radians.
KeyValue angle_key(std::string_view key, double& value, const Range& range, bool required = true);

/// Reads a list; keys may be in any order. Throws std::invalid_argument with the wrong item and the expected ones.
void read_key_values(std::string_view text, const std::vector<KeyValue>& keys);

}  // namespace limitcurve::cli
