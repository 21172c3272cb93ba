// SPDX-License-Identifier: MIT
#include "cli/io/output_file.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace limitcurve::cli {

std::string system_complaint(std::string_view what, std::string_view name) {
  const int code = errno;
  return "cannot " + std::string(what) + " '" + std::string(name) + "': " + std::generic_category().message(code);
}

void OutputFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > capacity) flush();
  buffer_ += text;
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      const std::string complaint = system_complaint("write to", name_);
      buffer_.clear();
      throw std::runtime_error(complaint);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

namespace {

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  // The process id keeps two runs that write the same file apart; the dot keeps it out of sight and of globs.
  std::string name(1, '.');
  name.append(path.filename().string()).append(".").append(std::to_string(::getpid())).append(".tmp");
  return path.parent_path() / name;
}

/// The place in /proc by which a file without a name can be given one.
std::string nameless(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

/// A file without a name in the directory of `path`: nothing of it is left, whatever ends the process. Not every file system
/// has it: then -1.
int open_nameless(const std::filesystem::path& path) {
  if (::access("/proc/self/fd", F_OK) != 0) return -1;
  const std::filesystem::path directory = path.parent_path();
  return ::open(directory.empty() ? "." : directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

int open_named(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  ::unlink(temporary.c_str());  // left by a killed process that had our number
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) throw std::runtime_error(system_complaint("write", path.string()));
  return descriptor;
}

/// A nameless file if that is possible, else one under the temporary name; `named` tells which.
int open_temporary(const std::filesystem::path& path, const std::filesystem::path& temporary, bool& named) {
  const int nameless_file = open_nameless(path);
  named = nameless_file < 0;
  return named ? open_named(temporary, path) : nameless_file;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)),
      temporary_(temporary_name(path_)),
      descriptor_(open_temporary(path_, temporary_, named_)),
      output_(descriptor_, path_.string()) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (named_) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  output_.flush();
  // Data before name: after a power cut the name must not stand for an empty file.
  if (::fsync(descriptor_) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
  if (!named_) {
    // A link cannot replace a file, a rename can.
    ::unlink(temporary_.c_str());
    if (::linkat(AT_FDCWD, nameless(descriptor_).c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      throw std::runtime_error(system_complaint("write", path_.string()));
    }
    named_ = true;
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
  ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace limitcurve::cli
