// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/rows.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace limitcurve::cli {

/// A cell of results; a number that is absent is an empty one.
using Cell = std::variant<double, std::optional<double>, bool, std::string_view>;

/// A column of a subcommand's results: its name, its cell in a row, and its meaning in --help.
template <class Row>
struct ListedColumn {
  std::string_view name;
  Cell (*of)(const Row&);
  std::string_view text = {};
};

/// The cell that is a member, or a member of a member: `of<&Row::error, &CurveError::max_error>`.
template <auto... path, class Row>
Cell of(const Row& row) {
  return (row.*....*path);
}

/// Columns that header, cells and help read.
template <class Row>
class ColumnList {
 public:
  template <std::size_t size>
  explicit ColumnList(const std::array<ListedColumn<Row>, size>& columns) : columns_(columns.begin(), columns.end()) {}

  /// Columns that only some results have.
  ColumnList& add(std::span<const ListedColumn<Row>> columns) {
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    return *this;
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& column : columns_) names.emplace_back(column.name);
    return names;
  }

  template <class Write>
  void cells(const Row& row, const Write& cell) const {
    for (const auto& column : columns_) std::visit(cell, column.of(row));
  }

  void write(Rows& rows, const Row& row) const {
    rows.row_by([&](const auto& cell) { cells(row, cell); });
  }

  /// A line for each column: its name and its meaning.
  [[nodiscard]] std::string help() const {
    std::vector<std::pair<std::string_view, std::string_view>> lines;
    for (const auto& column : columns_) lines.emplace_back(column.name, column.text);
    return help_of(lines);
  }

 private:
  std::vector<ListedColumn<Row>> columns_;
};

}  // namespace limitcurve::cli
