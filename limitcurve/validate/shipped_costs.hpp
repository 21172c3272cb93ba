// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

/// What models cost on one machine, mean nanoseconds: read them as ratios. Written by studies/chart/measure; do not
/// edit.
namespace limitcurve::shipped_costs {

inline constexpr std::string_view measured =
    "2026-11-28, a virtual machine, x86_64, Intel(R) Xeon(R) Processor, 2 cores, GCC 12.2.0";

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A wrench by its slip twist, and a step of the god-object that slips, in the order of godobject::Projection; `none`
/// where no finger takes it, or `choose` does not ask.
struct Cost {
  std::string_view model;
  double wrench;
  std::array<double, 3> step;
};

inline constexpr std::array<Cost, 6> models{{
    {"diamond", 4.0, {none, none, none}},
    {"box", 4.2, {none, none, 46.5}},
    {"ellipse", 5.0, {59.0, none, 100.1}},
    {"table", 5.7, {108.0, none, 107.6}},
    {"exact", 42.3, {none, none, none}},
    {"exact by quadrature", 20710.0, {none, none, none}},
}};

/// The costs of a model of the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
