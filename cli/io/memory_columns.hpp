// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// Columns of numbers in memory (Python's arrays), which a CsvReader reads by their path as it would a file.
class MemoryColumns {
 public:
  /// `name` stands for the file in messages: `trace['x'][17]: …`. The columns have one length, and stay where they are.
  /// What is not a column of numbers has none, and in `refused` the complaint for who reads it; else that is empty.
  MemoryColumns(std::string name, std::vector<std::string> columns, std::vector<std::span<const double>> numbers,
                std::vector<std::string> refused);
  virtual ~MemoryColumns();
  MemoryColumns(const MemoryColumns&) = delete;
  MemoryColumns& operator=(const MemoryColumns&) = delete;

  /// What no file has.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// A message with names instead of the paths of all there are.
  [[nodiscard]] static std::string named(std::string message);
  /// Null if there are none of that path.
  [[nodiscard]] static const MemoryColumns* find(const std::string& path);

 private:
  friend class CsvReader;

  void require_numbers(std::size_t column) const;

  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::span<const double>> numbers_;
  std::vector<std::string> refused_;
  std::size_t rows_ = 0;
  std::string path_;
};

}  // namespace limitcurve::cli
