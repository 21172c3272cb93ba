// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/rows.hpp"

#include "limitcurve/patch/half_spaces.hpp"

namespace limitcurve::cli {

/// The rows and vertices of `half_spaces`, one a line.
inline void write_half_spaces(const Results& results, const HalfSpaces& found) {
  Rows rows(results, {"kind", "fx", "fy", "moment", "share"});
  for (const auto& [fx, fy, moment] : found.rows) rows.row("row", fx, fy, moment, found.share);
  for (const auto& [fx, fy, moment] : found.vertices) rows.row("vertex", fx, fy, moment, found.share);
  rows.finish();
}

}  // namespace limitcurve::cli
