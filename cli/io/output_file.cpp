// SPDX-License-Identifier: MIT
#include "cli/io/output_file.hpp"

#include "cli/io/descriptor.hpp"

#include <cerrno>
#include <cstddef>
#include <random>
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

/// A name that no other run, thread or machine has; the dot hides it from listings and globs. It is short: the file's
/// own may be as long as a name can be.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
  std::random_device random;
  std::string name = ".limitcurve";
  for (int i = 0; i < 4; ++i) name.append(1, '-').append(std::to_string(random()));
  return target.parent_path() / (name + ".tmp");
}

/// Where the links of a name lead, even to a file that is not there yet.
std::filesystem::path target_of(std::filesystem::path path) {
  std::error_code ignored;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored));
       ++links)
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  return path;
}

}  // namespace

void AtomicFile::write(const std::string& name, std::string_view text) {
  AtomicFile file(name);
  file.output().write(text);
  file.commit();
}

AtomicFile::AtomicFile(std::string name)
    : name_(std::move(name)), target_(descriptor::path_of(name_)), descriptor_(open()), output_(descriptor_, name_) {}

int AtomicFile::open() {
  const int existing = descriptor::open_to_write(target_);
  if (existing < 0 && errno != ENOENT) throw std::runtime_error(system_complaint("write", name_));
  if (existing >= 0) {
    const std::filesystem::file_status status = std::filesystem::status(target_);
    if (!std::filesystem::is_regular_file(status)) return existing;
    descriptor::close(existing);
    mode_ = status.permissions();
  }
  replaces_ = true;
  target_ = target_of(target_);
  const int mode = static_cast<int>(mode_.value_or(std::filesystem::perms(0666)));
  int file = descriptor::create_nameless(target_, mode);
  while (file < 0) {
    temporary_ = temporary_name(target_);
    file = descriptor::create(temporary_, mode);
    named_ = file >= 0;
    if (!named_ && errno != EEXIST) throw std::runtime_error(system_complaint("write", name_));
  }
  return file;
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (descriptor_ >= 0) descriptor::close(descriptor_);
  if (named_) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  output_.flush();
  if (!replaces_) return;
  // Flush the data before the rename: after a power cut the name must not belong to an empty file.
  if (descriptor::synchronise(descriptor_) != 0) throw std::runtime_error(system_complaint("write", name_));
  // A link cannot replace a file, a rename can.
  while (!named_) {
    temporary_ = temporary_name(target_);
    named_ = descriptor::give_name(descriptor_, temporary_) == 0;
    if (!named_ && errno != EEXIST) throw std::runtime_error(system_complaint("write", name_));
  }
  descriptor::close(descriptor_);  // Windows renames no open file
  descriptor_ = -1;
  std::error_code refused;
  if (mode_) std::filesystem::permissions(temporary_, *mode_, refused);  // a file system without permissions refuses
  std::filesystem::rename(temporary_, target_, refused);
  if (refused) throw std::runtime_error("cannot write '" + name_ + "': " + refused.message());
  named_ = false;
}

}  // namespace limitcurve::cli
