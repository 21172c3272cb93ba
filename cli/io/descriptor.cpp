// SPDX-License-Identifier: MIT
#include "cli/io/descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>

#ifdef _WIN32
#include <climits>

#include <io.h>
#include <sys/stat.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <unistd.h>
#endif

namespace limitcurve::cli::descriptor {

#ifdef _WIN32

int open_to_read(const std::string& file) noexcept {
  return ::_open(file.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int open_to_write(const std::filesystem::path& path) noexcept {
  return ::_wopen(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

int create(const std::filesystem::path& path, int) noexcept {
  return ::_wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

std::ptrdiff_t read(int file, char* to, std::size_t size) noexcept {
  return ::_read(file, to, static_cast<unsigned>(std::min<std::size_t>(size, INT_MAX)));
}

std::ptrdiff_t write(int file, const char* from, std::size_t size) noexcept {
  const int written = ::_write(file, from, static_cast<unsigned>(std::min<std::size_t>(size, INT_MAX)));
  // The run time calls a pipe whose reader is gone an invalid argument.
  if (written < 0 && (_doserrno == ERROR_NO_DATA || _doserrno == ERROR_PIPE_NOT_CONNECTED)) errno = EPIPE;
  return written;
}

int synchronise(int file) noexcept {
  return ::_commit(file);
}

void close(int file) noexcept {
  ::_close(file);
}

void prepare_standard_streams() noexcept {
  ::_setmode(standard_input, _O_BINARY);
  ::_setmode(standard_output, _O_BINARY);
}

/// A console that understands colours; it is asked to.
bool is_terminal(int file) noexcept {
  const auto console = reinterpret_cast<HANDLE>(::_get_osfhandle(file));
  DWORD mode = 0;
  return ::GetConsoleMode(console, &mode) != 0 &&
         ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

#else

int open_to_read(const std::string& file) noexcept {
  return ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
}

int open_to_write(const std::filesystem::path& path) noexcept {
  return ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
}

int create(const std::filesystem::path& path, int mode) noexcept {
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

std::ptrdiff_t read(int file, char* to, std::size_t size) noexcept {
  return ::read(file, to, size);
}

std::ptrdiff_t write(int file, const char* from, std::size_t size) noexcept {
  return ::write(file, from, size);
}

int synchronise(int file) noexcept {
  return ::fsync(file);
}

void close(int file) noexcept {
  ::close(file);
}

void prepare_standard_streams() noexcept {
  std::signal(SIGPIPE, SIG_IGN);
}

bool is_terminal(int file) noexcept {
  return ::isatty(file) == 1;
}

#endif

#ifdef O_TMPFILE

int create_nameless(const std::filesystem::path& path, int mode) noexcept {
  if (::access("/proc/self/fd", F_OK) != 0) return -1;
  const std::filesystem::path directory = path.parent_path();
  return ::open(directory.empty() ? "." : directory.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
}

int give_name(int file, const std::filesystem::path& path) noexcept {
  const std::string place = "/proc/self/fd/" + std::to_string(file);
  return ::linkat(AT_FDCWD, place.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW);
}

#else

int create_nameless(const std::filesystem::path&, int) noexcept {
  errno = ENOSYS;
  return -1;
}

int give_name(int, const std::filesystem::path&) noexcept {
  errno = ENOSYS;
  return -1;
}

#endif

bool draws(int file) noexcept {
  const char* const kind = std::getenv("TERM");
  return is_terminal(file) && (kind == nullptr || std::string_view(kind) != "dumb");
}

bool takes_colours(int file) noexcept {
  const char* const unwanted = std::getenv("NO_COLOR");
  return draws(file) && (unwanted == nullptr || *unwanted == '\0');
}

}  // namespace limitcurve::cli::descriptor
