// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/range.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {

/// Reads a number within `range`, or any number; otherwise throws std::invalid_argument "got '…', expected …".
double read_number(std::string_view text, const std::optional<Range>& range);

/// A key of a list such as `from=2,to=0,over=1.5`, and the function that reads its value.
struct KeyValue {
  std::string_view key;
  std::function<void(std::string_view)> take;
  bool required = true;
  std::string_view kind = "NUMBER";  ///< name of the value in error messages
};

/// A key whose value is a number within `range`; any number without it.
KeyValue number_key(std::string_view key, double& value, const std::optional<Range>& range = std::nullopt,
                    bool required = true);

/// A description `KIND[:FILE][,key=value…]` of a law, a patch, a surface, a body: its kind, and what follows the first
/// colon.
struct Description {
  std::string_view kind;
  std::optional<std::string_view> rest;
};
Description split_description(std::string_view text);

/// Reads a list; keys may be in any order. An empty text is an empty list. Throws std::invalid_argument with the wrong
/// item and the expected ones.
void read_key_values(std::string_view text, const std::vector<KeyValue>& keys);

}  // namespace limitcurve
