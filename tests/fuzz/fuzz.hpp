// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <unistd.h>

/// What the fuzz targets share.
namespace limitcurve::fuzz {

/// A target: what the program does with an input if its first argument is `name`, which is also the folder of the
/// target's seeds.
struct Target {
  using Body = void (*)(std::string_view input);
  Target(std::string_view name, Body body) { all().emplace(name, body); }
  static std::map<std::string_view, Body>& all() {
    static std::map<std::string_view, Body> targets;
    return targets;
  }
};

/// Ends the program, which is how libFuzzer learns of a finding, unless `holds`.
inline void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "finding: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

/// The complaint of `body` about its input; nothing if it had none. Any exception but std::invalid_argument is a
/// finding, and so is a complaint that says nothing.
template <class Body>
std::optional<std::string> complaint_of(Body&& body) {
  try {
    body();
  } catch (const std::invalid_argument& error) {
    require(error.what()[0] != '\0', "an empty complaint");
    return error.what();
  }
  return std::nullopt;
}

/// Same bits, or both NaN.
inline bool same(double one, double other) {
  return std::memcmp(&one, &other, sizeof one) == 0 || (one != one && other != other);
}

inline bool is_finite(double value) {
  return value - value == 0.0;
}

/// Takes raw values off the front of an input.
class Bytes {
 public:
  explicit Bytes(std::string_view input) : rest_(input) {}

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  /// The next bytes as a value of any bit pattern; zero bits when the input is spent.
  template <class Value>
  Value take() {
    Value value{};
    const std::size_t count = rest_.size() < sizeof value ? rest_.size() : sizeof value;
    if (count > 0) std::memcpy(&value, rest_.data(), count);
    rest_.remove_prefix(count);
    return value;
  }

 private:
  std::string_view rest_;
};

/// A file whose contents can be replaced, for readers that open a file by its name.
class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() / "fuzz-XXXXXX"), descriptor_(::mkstemp(path_.data())) {
    require(descriptor_ >= 0, "no temporary file");
  }
  ~TemporaryFile() {
    ::close(descriptor_);
    ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void replace(std::string_view text) {
    const bool written = ::ftruncate(descriptor_, 0) == 0 &&
                         ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
    require(written, "cannot write to the temporary file");
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  int descriptor_;
};

}  // namespace limitcurve::fuzz
