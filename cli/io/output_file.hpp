// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace limitcurve::cli {

/// The reader of a pipe left, as `head` does after the lines that it wants.
struct ClosedPipe : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A buffered output that reports every failure: a full disk throws std::runtime_error with the output's name, a closed
/// pipe ClosedPipe. The destructor drops text that was not flushed, so that nothing follows an error.
class OutputFile {
 public:
  /// Standard output; not closed by this object.
  static OutputFile standard_output() { return {1, "standard output"}; }

  OutputFile(int descriptor, std::string name) : descriptor_(descriptor), name_(std::move(name)) {
    buffer_.reserve(capacity);
  }

  /// What is to be done before anything is handed to the operating system.
  void before_writing(std::function<void()> action) { before_writing_ = std::move(action); }
  void write(std::string_view text);
  /// Passes everything written so far to the operating system.
  void flush();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  static constexpr std::size_t capacity = 1 << 16;

  int descriptor_;
  std::string name_;
  std::string buffer_;
  std::function<void()> before_writing_;
};

/// A file that appears under its name complete or not at all. It is written without a name in the same directory (under
/// a hidden name if the file system needs one); `commit` gives it its name. Without `commit` the destructor removes it.
/// A file that it replaces must be writable, and its permissions stay; behind a link, the file that the link leads to.
/// A pipe or a device is not replaced but written. Failures throw std::runtime_error with file and cause.
class AtomicFile {
 public:
  /// The whole file.
  static void write(const std::string& name, std::string_view text);

  explicit AtomicFile(std::string name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  OutputFile& output() { return output_; }

  /// Flushes to the disk, then renames.
  void commit();

 private:
  int open();

  std::string name_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::optional<std::filesystem::perms> mode_;  ///< of the file that is replaced
  bool replaces_ = false;                       ///< a pipe or a device is written
  bool named_ = false;                          ///< whether `temporary_` exists
  int descriptor_;
  OutputFile output_;
};

/// The message "cannot WHAT 'NAME': CAUSE", the cause from errno.
std::string system_complaint(std::string_view what, std::string_view name);

}  // namespace limitcurve::cli
