// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// Files by descriptors: the calls in which operating systems differ. Each gives a negative number where it fails, and errno says why.
namespace limitcurve::cli::descriptor {

inline constexpr int standard_input = 0;
inline constexpr int standard_output = 1;

int open_to_read(const std::string& file) noexcept;
/// A new file; fails if there is one.
int create(const std::filesystem::path& path) noexcept;
/// A new file without a name in the directory of `path`: nothing of it is left, whatever ends the process. Linux, and not every file system.
int create_nameless(const std::filesystem::path& path) noexcept;
/// Gives a file without a name its name.
int give_name(int file, const std::filesystem::path& path) noexcept;
/// At most `size` bytes; 0 at the end.
std::ptrdiff_t read(int file, char* to, std::size_t size) noexcept;
std::ptrdiff_t write(int file, const char* from, std::size_t size) noexcept;
/// Waits until all of the file is on the disk.
int synchronise(int file) noexcept;
void close(int file) noexcept;
/// Input and output are the bytes that they are, and a closed pipe is an error of `write`: called once, at first.
void prepare_standard_streams() noexcept;
int process_id() noexcept;

}  // namespace limitcurve::cli::descriptor
