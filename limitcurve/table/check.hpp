// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

namespace limitcurve::table {

/// Refuses what is no table of BasicTable<Real>: throws std::invalid_argument that names the fact or the cell, its value and what is
/// expected. What passes is a convex curve, continuous with its normal, whose every index is within its arrays.
template <class Real>
void check(const TableFacts& facts, const TableCells& cells);

extern template void check<double>(const TableFacts&, const TableCells&);
extern template void check<float>(const TableFacts&, const TableCells&);

}  // namespace limitcurve::table
