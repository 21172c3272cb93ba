// SPDX-License-Identifier: MIT
#include "cli/output_file.hpp"

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

int open_new(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  ::unlink(temporary.c_str());  // left by a killed process that had our number
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) throw std::runtime_error(system_complaint("write", path.string()));
  return descriptor;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)),
      temporary_(temporary_name(path_)),
      descriptor_(open_new(temporary_, path_)),
      output_(descriptor_, path_.string()) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  output_.flush();
  // Data before name: after a power cut the name must not stand for an empty file.
  if (::fsync(descriptor_) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
  ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace limitcurve::cli
