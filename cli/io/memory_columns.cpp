// SPDX-License-Identifier: MIT
#include "cli/io/memory_columns.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace limitcurve::cli {

namespace {

/// All there are, by path.
struct InMemory {
  std::mutex mutex;
  std::size_t made = 0;
  std::map<std::string, const MemoryColumns*> columns;
};

InMemory& in_memory() {
  static InMemory all;
  return all;
}

}  // namespace

MemoryColumns::MemoryColumns(std::string name, std::vector<std::string> columns,
                             std::vector<std::span<const double>> numbers, std::vector<std::string> refused)
    : name_(std::move(name)), columns_(std::move(columns)), numbers_(std::move(numbers)), refused_(std::move(refused)) {
  for (const std::span<const double> column : numbers_) rows_ = std::max(rows_, column.size());
  const std::lock_guard lock(in_memory().mutex);
  path_ = "/dev/null/" + std::to_string(++in_memory().made) + "/";  // the slash: none begins like another
  in_memory().columns.emplace(path_, this);
}

MemoryColumns::~MemoryColumns() {
  const std::lock_guard lock(in_memory().mutex);
  in_memory().columns.erase(path_);
}

void MemoryColumns::require_numbers(std::size_t column) const {
  if (!refused_[column].empty()) throw std::invalid_argument(refused_[column]);
}

std::string MemoryColumns::named(std::string message) {
  const std::lock_guard lock(in_memory().mutex);
  for (const auto& [path, one] : in_memory().columns) {
    for (std::size_t at = 0; (at = message.find(path, at)) != std::string::npos; at += one->name_.size())
      message.replace(at, path.size(), one->name_);
  }
  return message;
}

const MemoryColumns* MemoryColumns::find(const std::string& path) {
  const std::lock_guard lock(in_memory().mutex);
  const auto found = in_memory().columns.find(path);
  return found == in_memory().columns.end() ? nullptr : found->second;
}

}  // namespace limitcurve::cli
