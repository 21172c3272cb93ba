// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limitcurve::cli {

struct TableCell {
  std::string text;
  bool is_number = false;
};

/// Rows for a person to read: columns are aligned, numbers at their points. Of a wide table names are broken at
/// underscores.
std::string aligned(const std::vector<std::string>& names, const std::vector<TableCell>& cells, bool with_names);

}  // namespace limitcurve::cli
