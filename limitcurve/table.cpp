// SPDX-License-Identifier: MIT
#include "limitcurve/table.hpp"

#include "limitcurve/number.hpp"
#include "limitcurve/table_builder.hpp"

#include <stdexcept>

namespace limitcurve {

Table Table::build(const Law& law, double tolerance) {
  if (!(tolerance >= finest_tolerance && tolerance <= coarsest_tolerance)) {
    throw out_of_range("tolerance", tolerance, "1", "1e-12 <= tolerance <= 0.1");
  }
  CertifiedSide inside = build_side(*law, Side::inside, tolerance);
  CertifiedSide outside = build_side(*law, Side::outside, tolerance);
  const double error = std::max(inside.error, outside.error);
  return {{law->name(), tolerance, error}, std::move(inside.side), std::move(outside.side)};
}

Table::Table(Facts facts, TableSide inside, TableSide outside)
    : facts_(std::move(facts)),
      sides_{std::move(inside), std::move(outside)},
      rim_{sides_[0].nodes().back().primary, sides_[0].nodes().back().secondary},
      moment_ratio_(sides_[0].nodes().front().secondary),
      per_moment_ratio_(1.0 / moment_ratio_) {
  // It is a line of every text of the table.
  for (const char c : facts_.law_name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      throw std::invalid_argument("the name of the table's law has a control character");
  }
  TableSide::align(sides_[0], sides_[1]);
  const TableNode& from_inside = this->inside().nodes().back();
  const TableNode& from_outside = this->outside().nodes().back();
  if (from_inside.primary != from_outside.secondary || from_inside.secondary != from_outside.primary) {
    throw std::invalid_argument("the sides of the table do not meet at the rim");
  }
  if (this->outside().nodes().front().secondary != 1.0) throw std::invalid_argument("the table's force under pure sliding is not 1");
  // No pressure has such a one, and its square is to be finite.
  if (!(moment_ratio_ >= 1e-30 && moment_ratio_ <= 1e30))
    throw out_of_range("moment_ratio", moment_ratio_, "1", "1e-30 <= moment_ratio <= 1e30");
  if (!(facts_.certified_error >= 0.0 && facts_.certified_error <= facts_.tolerance)) {
    throw out_of_range("certified_error", facts_.certified_error, "1", "0 <= certified_error <= tolerance");
  }
  learn_places();
}

void Table::learn_places() {
  for (std::size_t i = 0; i <= place_cells; ++i) places_[i] = static_cast<float>(2 * i) / static_cast<float>(place_cells);
  std::array<float, place_cells + 1> learnt = places_;
  for (std::size_t i = 1; i < place_cells; ++i) {
    const SlipTwist twist = SlipTwist::at_place(2.0 * static_cast<double>(i) / place_cells);
    learnt[i] = static_cast<float>(along({twist.slide, twist.spin * moment_ratio() * moment_ratio()}).normal.place());
  }
  places_ = learnt;
}

}  // namespace limitcurve
