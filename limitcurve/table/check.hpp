// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

namespace limitcurve::table {

/// Throws std::invalid_argument, with the fact or the cell, its value and what is expected, unless facts and cells make
/// a BasicTable<Real>: a convex curve that is continuous with its normal, and an index within its arrays.
template <class Real>
void check(const TableFacts& facts, const TableCells& cells);

extern template void check<double>(const TableFacts&, const TableCells&);
extern template void check<float>(const TableFacts&, const TableCells&);

}  // namespace limitcurve::table
