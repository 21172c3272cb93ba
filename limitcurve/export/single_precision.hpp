// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

namespace limitcurve::table {

/// The cells for float: none wider than 1/8, about origins that are floats, with coefficients that are floats. Of cells
/// whose origins round to one float the last remains.
TableCells in_single_precision(const TableCells& cells);

/// Bound on the rounding errors of force and moment where such cells are evaluated in float as an exported header does,
/// at an x that is a float: a running error analysis of Horner's scheme, with absolute values. To first order in the
/// unit roundoff 2⁻²⁴.
double rounding_in_single_precision(const TableCells& cells);

}  // namespace limitcurve::table
