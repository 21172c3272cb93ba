// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// File descriptors: the calls that differ between operating systems. On failure each returns a negative number and
/// sets errno.
namespace limitcurve::cli::descriptor {

inline constexpr int standard_input = 0;
inline constexpr int standard_output = 1;
inline constexpr int standard_error = 2;

/// The path of a name from the command line. On Windows the name is UTF-8, and one that is not throws
/// std::filesystem::filesystem_error; a path of the std::string itself would be another file, for GCC's run time takes
/// its bytes for Latin-1. Elsewhere bytes stay as they are.
inline std::filesystem::path path_of(const std::string& name) {
  return std::u8string(name.begin(), name.end());
}

int open_to_read(const std::string& file) noexcept;
/// Opens a file that exists; waits for the reader of a named pipe.
int open_to_write(const std::filesystem::path& path) noexcept;
/// Creates a new file, fails if it exists. Its permissions are `mode` but for the process's mask.
int create(const std::filesystem::path& path, int mode) noexcept;
/// Creates a file without a name in the directory of `path`. It disappears if the process ends before `give_name`.
/// Linux only, and not on every file system.
int create_nameless(const std::filesystem::path& path, int mode) noexcept;
/// Gives a file without a name its name; fails if that exists.
int give_name(int file, const std::filesystem::path& path) noexcept;
/// Reads at most `size` bytes; 0 at the end of the file.
std::ptrdiff_t read(int file, char* to, std::size_t size) noexcept;
std::ptrdiff_t write(int file, const char* from, std::size_t size) noexcept;
/// Waits until the whole file is on the disk.
int synchronise(int file) noexcept;
void close(int file) noexcept;
/// Sets binary mode for the standard streams, and makes a closed pipe an error of `write`. Call it once, at the start.
void prepare_standard_streams() noexcept;
bool is_terminal(int file) noexcept;
/// Whether it is a terminal on which a line can be written over.
bool draws(int file) noexcept;
/// Whether it is such a terminal and the user does not mind colours (https://no-color.org).
bool takes_colours(int file) noexcept;

}  // namespace limitcurve::cli::descriptor
