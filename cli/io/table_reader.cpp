// SPDX-License-Identifier: MIT
#include "cli/io/table_reader.hpp"

#include "cli/io/descriptor.hpp"
#include "cli/io/output_file.hpp"

#include "limitcurve/table_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace limitcurve::cli {

namespace {

/// A table has at most a hundredth of this length: a longer file is none, and is not read.
constexpr std::size_t longest_file = 32U << 20U;

std::string read_whole(const std::string& file) {
  const std::filesystem::path path = descriptor::path_of(file);
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown))
    throw std::invalid_argument("cannot read '" + file + "': a directory, expected a table");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::invalid_argument(system_complaint("read", file));
  std::string text;
  std::string chunk(1U << 16U, '\0');
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), stream.gcount() > 0) {
    text.append(chunk, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > longest_file)
      throw std::invalid_argument(file + ":1:1: not a table: longer than any that 'limitcurve table' writes");
  }
  if (stream.bad()) throw std::runtime_error(system_complaint("read", file));
  return text;
}

/// Calls `of_csv` or `of_json`, as the name of the file says, with its text.
template <class Csv, class Json>
auto read_as(const std::string& file, const Csv& of_csv, const Json& of_json) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".csv" && extension != ".json") {
    throw std::invalid_argument("got '" + file + "', expected a name that ends in .csv or .json");
  }
  const std::string whole = read_whole(file);
  // Some spreadsheets and editors write a byte order mark.
  const std::string_view text = std::string_view(whole).substr(whole.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  return extension == ".csv" ? of_csv(text, file) : of_json(text, file);
}

}  // namespace

limitcurve::Table read_table(const std::string& file) {
  return read_as(file, read_table_csv, read_table_json);
}

PatchTable read_patch_table(const std::string& file) {
  return read_as(file, read_patch_table_csv, read_patch_table_json);
}

}  // namespace limitcurve::cli
