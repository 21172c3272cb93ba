// SPDX-License-Identifier: MIT
#include "cli/io/output_file.hpp"

#include "cli/io/descriptor.hpp"

#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <system_error>

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
  if (before_writing_ && !buffer_.empty()) before_writing_();
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const std::ptrdiff_t written = descriptor::write(descriptor_, rest.data(), rest.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      const bool closed = errno == EPIPE;
      const std::string complaint = system_complaint("write to", name_);
      buffer_.clear();
      if (closed) throw ClosedPipe(complaint);
      throw std::runtime_error(complaint);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

namespace {

std::filesystem::path temporary_name(const std::filesystem::path& path) {
  // The process id separates two runs that write the same file; the dot hides the file from listings and globs.
  std::string name(1, '.');
  name.append(path.filename().string()).append(".").append(std::to_string(descriptor::process_id())).append(".tmp");
  return path.parent_path() / name;
}

void discard(const std::filesystem::path& path) noexcept {
  std::error_code none;
  std::filesystem::remove(path, none);
}

int open_named(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  discard(temporary);  // left by a killed process that had our number
  const int file = descriptor::create(temporary);
  if (file < 0) throw std::runtime_error(system_complaint("write", path.string()));
  return file;
}

/// Opens a nameless file if possible, otherwise one with the temporary name; sets `named` accordingly.
int open_temporary(const std::filesystem::path& path, const std::filesystem::path& temporary, bool& named) {
  const int nameless_file = descriptor::create_nameless(path);
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
  if (descriptor_ >= 0) descriptor::close(descriptor_);
  if (named_) discard(temporary_);
}

void AtomicFile::commit() {
  output_.flush();
  // Flush the data before the rename: after a power cut the name must not belong to an empty file.
  if (descriptor::synchronise(descriptor_) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
  if (!named_) {
    // A link cannot replace a file, a rename can.
    discard(temporary_);
    if (descriptor::give_name(descriptor_, temporary_) != 0) throw std::runtime_error(system_complaint("write", path_.string()));
    named_ = true;
  }
  descriptor::close(descriptor_);  // Windows renames no open file
  descriptor_ = -1;
  std::error_code refused;
  std::filesystem::rename(temporary_, path_, refused);
  if (refused) throw std::runtime_error("cannot write '" + path_.string() + "': " + refused.message());
  named_ = false;
}

}  // namespace limitcurve::cli
