// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/triangle_list.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

/// Reads a text word by word and line by line, and throws with line and column.
class Tokenizer {
 public:
  Tokenizer(std::string_view text, std::string_view name) : rest_(without_mark(text)), name_(name) {
    if (text.find('\0') != std::string_view::npos) throw std::invalid_argument(joined({name, ": a byte 0, expected a text in UTF-8"}));
  }
  /// A text without the byte order mark that some programs write.
  static std::string_view without_mark(std::string_view text) { return text.substr(text.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0); }

  /// Goes to the next line; false at the end of the text.
  bool next_line() {
    if (rest_.empty()) {
      word_ = here_.substr(here_.size());
      ended_ = true;
      return false;
    }
    if (line_ == std::numeric_limits<int>::max()) fail("too many lines");
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    here_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    begin_ = here_.data();
    word_ = here_.substr(0, 0);
    return true;
  }

  /// The next word of this line; empty at its end.
  std::string_view next() {
    constexpr std::string_view blank = " \t\r\v\f";
    here_.remove_prefix(std::min(here_.find_first_not_of(blank), here_.size()));
    word_ = here_.substr(0, here_.find_first_of(blank));
    here_.remove_prefix(word_.size());
    return word_;
  }

  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::string_view name() const { return name_; }

  /// Throws std::invalid_argument "name:line:column: what", at the last word.
  [[noreturn]] void fail(std::string_view what) const {
    const auto column = word_.data() == nullptr ? 1 : word_.data() - begin_ + 1;
    throw std::invalid_argument(joined({name_, ":", std::to_string(line_), ":", std::to_string(column), ": ", what}));
  }
  /// Throws like `fail`, with the last word (quoted and shortened) and what was expected.
  [[noreturn]] void expected(std::string_view what) const {
    std::string found(word_.substr(0, 40));
    for (char& character : found) {
      if (character < ' ' || character > '~') character = '?';
    }
    fail(word_.empty() ? joined({ended_ ? "the text ends, expected " : "the line ends, expected ", what})
                       : joined({"'", found, word_.size() > 40 ? "...', expected " : "', expected ", what}));
  }

  /// The next three words as coordinates in the unit `scale` [m].
  Eigen::Vector3d place(double scale) {
    Eigen::Vector3d result;
    for (double& coordinate : result) coordinate = number() * scale;
    return result;
  }

  double number() {
    const auto value = parse_number(next());
    if (!value || !std::isfinite(*value)) expected("a finite number");
    return *value;
  }

 private:
  std::string_view rest_;
  std::string_view name_;
  std::string_view here_;
  std::string_view word_;
  const char* begin_ = nullptr;
  int line_ = 0;
  bool ended_ = false;
};

}  // namespace limitcurve::godobject
