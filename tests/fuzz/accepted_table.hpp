// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/export/header.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <algorithm>

namespace limitcurve::fuzz {

/// A table that was accepted comes back through its text and gives finite wrenches within its intercepts.
inline void require_usable(const Table& table) {
  const std::string text = to_csv(table);
  require(to_csv(read_table_csv(text, "written")) == text, "a table does not come back through its text");
  require(!to_header(table).empty() && !to_json(table).empty(), "a table without text");
  // A table rounds in units of the larger intercept.
  const double slack = 1e-12 * std::max({1.0, table.force_max(), table.moment_ratio()});
  for (const double u : {0.0, 1e-300, 1e-9, 0.3, 0.5, 0.7, 1.0 - 1e-9, 1.0}) {
    const SlipTwist twist = SlipTwist::of_spin_fraction(u);
    const UnitWrench wrench = table.wrench(twist);
    require(is_finite(wrench.force) && is_finite(wrench.moment), "a table's wrench is not finite");
    require(wrench.force >= -slack && wrench.force <= table.force_max() + slack,
            "a table's force is outside its intercepts");
    require(wrench.moment >= -slack && wrench.moment <= table.force_max() * table.moment_ratio() + slack,
            "a table's moment is outside its intercepts");
    const RadialPoint along = table.along({u, (1.0 - u) * table.moment_ratio()});
    require(is_finite(along.wrench.force) && is_finite(along.wrench.moment), "a table's radial point is not finite");
    require(table.gauge({u, (1.0 - u) * table.moment_ratio()}) >= 0.0, "a table's gauge is negative or none");
  }
}

/// Reads the text by `read`; what fails by its checksum alone is read again with the right one, which the complaint
/// tells: the checksum keeps accidents out, not the rest of the checks idle.
template <class Read>
void read_despite_checksum(std::string text, Read&& read) {
  std::optional<Table> table;
  auto complaint = complaint_of([&] { table = read(text); });
  constexpr std::string_view expected = "its checksum is ";
  constexpr std::string_view actual = ", its contents have ";
  if (complaint && complaint->find(actual) != std::string::npos) {
    const std::size_t end = complaint->rfind(actual);
    const std::size_t begin = complaint->rfind(expected, end) + expected.size();
    const std::string given = complaint->substr(begin, end - begin);
    const std::size_t place = given.empty() ? std::string::npos : text.find(given);
    if (place == std::string::npos) return;
    text.replace(place, given.size(), complaint->substr(end + actual.size()));
    complaint = complaint_of([&] { table = read(text); });
  }
  if (!complaint) require_usable(*table);
}

}  // namespace limitcurve::fuzz
