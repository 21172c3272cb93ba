// SPDX-License-Identifier: MIT
#pragma once

#include "../table.hpp"

#include <string>
#include <string_view>

namespace limitcurve {

/// The table as a C99, C++17 and CUDA header that includes nothing. In C: `NAME_wrench(slide, spin)` returns a struct
/// of force and moment, as Table::wrench does; `NAME_gauge(force, moment)` is Table::gauge; `NAME_closest_point(force,
/// moment, chi)` is the closest-point step, within 2e-13 of the library's for chi = 1e-3 … 1e3. In C++ they are
/// constexpr. All names have internal linkage. The cell is found by bisection. NAME is `name`, or, if that is empty,
/// `limitcurve_table_<law>_<first 8 digits of the checksum>`, which no other table has. `name` must be a C identifier
/// that begins with a letter and has no double underscore. Otherwise this throws std::invalid_argument with the name.
/// With `is_single` everything is in float. Then checked_error is `single_precision_error`, for a ratio of speeds that
/// is a float, tolerance is at least that over max(1, m₀), and closest_point is within 5e-6.
std::string to_header(const Table& table, std::string_view name = {}, bool is_single = false);

/// Bound on the error in force and moment by a header in single precision: the error of the table and about
/// 4e-7·max(1, m₀) for roundings.
double single_precision_error(const Table& table);

}  // namespace limitcurve
