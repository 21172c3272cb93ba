// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limitcurve::cli {

/// A buffered output whose every failure is noticed: a closed pipe or a full disk throws std::runtime_error that names
/// the output. What was not flushed when it is destroyed is dropped: after an error, nothing more should be said.
class OutputFile {
 public:
  /// Standard output; not closed by this object.
  static OutputFile standard_output() { return {1, "standard output"}; }

  OutputFile(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) { buffer_.reserve(capacity); }

  void write(std::string_view text);
  /// Hands everything written so far to the operating system.
  void flush();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  static constexpr std::size_t capacity = 1 << 16;

  int descriptor_;
  std::string name_;
  std::string buffer_;
};

/// A file that appears under its name whole or not at all: written without a name (where the file system cannot, under a
/// hidden one) in the same directory, then named by `commit`. Destroyed without commit, it leaves nothing behind. Failures
/// throw std::runtime_error that names file and cause.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  OutputFile& output() { return output_; }

  /// Writes through to the disk, then renames over `path`.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool named_ = false;  ///< whether `temporary_` exists
  int descriptor_;
  OutputFile output_;
};

/// The message "cannot WHAT 'NAME': why the operating system refused", from errno.
std::string system_complaint(std::string_view what, std::string_view name);

}  // namespace limitcurve::cli
