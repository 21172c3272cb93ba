// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What the files of tables have in common: lines, facts `# name: value`, numbers, and a checksum.
namespace limitcurve::table {

/// FNV-1a (64 bits): "fnv1a:" and 16 hexadecimal digits.
inline std::string checksum_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  std::string sum = "fnv1a:";
  for (int shift = 60; shift >= 0; shift -= 4) sum += "0123456789abcdef"[(hash >> static_cast<unsigned>(shift)) & 15U];
  return sum;
}

/// Throws std::invalid_argument, whose message begins with `source`, unless the checksums are equal.
inline void require_checksum(std::string_view source, std::string_view expected, std::string_view actual) {
  if (actual == expected) return;
  throw std::invalid_argument(std::string(source) + ": the table was edited or damaged: its checksum is " +
                              std::string(expected) + ", its contents have " + std::string(actual));
}

/// `text` as a string of JSON. Only the name of a file can have a character that JSON escapes.
inline std::string json_string(std::string_view text) {
  std::string escaped(1, '"');
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped + '"';
}

/// Reads a text line by line, and throws std::invalid_argument with `source:line:column: `.
class Reader {
 public:
  Reader(std::string_view text, std::string_view source) : rest_(text), source_(source) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  std::string_view line() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) fail(rest_.size() + 1, "the text ends within a line: expected an end of line");
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    text.remove_suffix(text.size() - (text.find_last_not_of(padding_) + 1));
    return text;
  }

  /// Reads the first line, which must be `title`.
  void title(std::string_view title) {
    std::string_view first = rest_.starts_with('#') ? line() : rest_.substr(0, 0);
    // A spreadsheet appends blanks and commas to every line; otherwise a name may end in them.
    if (first.starts_with(title) && first.find_first_not_of("\t ,", title.size()) == std::string_view::npos) {
      if (first != title) padding_ = "\r\t ,";
      first = title;
    }
    if (first != title)
      fail(1, "not a table: expected the first line '" + std::string(title) + "'" +
                  (first.empty() ? "" : ", got '" + std::string(first.substr(0, 60)) + "'"));
  }

  /// Reads a line `# name: value`. Returns the value and its column.
  std::pair<std::string_view, std::size_t> fact(std::string_view name) {
    const std::string_view text = line();
    const std::string prefix = "# " + std::string(name) + ": ";
    if (!text.starts_with(prefix)) fail(1, "expected '# " + std::string(name) + ": …'");
    return {text.substr(prefix.size()), prefix.size() + 1};
  }

  /// Skips comments and reads the header, which must be `columns`.
  void header(std::string_view columns) {
    std::string_view text;
    do {
      text = line();
    } while (text.starts_with("#"));
    if (text != columns)
      fail(1, "expected the header " + std::string(columns) +
                  (text.find(';') != std::string_view::npos ? "; separate by commas, with decimal points" : ""));
  }

  double number(std::string_view text, std::size_t column) const {
    const std::optional<double> value = parse_number(text);
    if (!value) fail(column, "expected a number, got '" + std::string(text) + "'");
    return *value;
  }

  int whole_number(std::string_view text, std::size_t column) const {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      fail(column, "expected a whole number, got '" + std::string(text) + "'");
    return value;
  }

  /// Sets the numbers to those of a row after its first `skipped` fields; it must have the header's `columns`.
  template <class Numbers>
  void numbers(std::string_view row, std::string_view columns, std::size_t skipped, Numbers& values) const {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < skipped + values.size(); ++i) {
      const bool last = i + 1 == skipped + values.size();
      const std::size_t end = last ? row.size() : row.find(',', begin);
      if (begin > row.size() || end == std::string_view::npos)
        fail(row.size() + 1, "expected the columns " + std::string(columns));
      if (i >= skipped) values[i - skipped] = number(row.substr(begin, end - begin), begin + 1);
      begin = end + 1;
    }
  }

  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw std::invalid_argument(std::string(source_) + ":" + std::to_string(std::max<std::size_t>(line_, 1)) + ":" +
                                std::to_string(column) + ": " + what);
  }

 private:
  std::string_view rest_;
  std::string_view source_;
  std::string_view padding_ = "\r";  ///< what ends a line beside its text
  std::size_t line_ = 0;
};

}  // namespace limitcurve::table
