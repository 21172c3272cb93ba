// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

/// What models cost on one machine, mean nanoseconds: read them as ratios. Written by scripts/work_precision; do not edit.
namespace limitcurve::shipped_costs {

inline constexpr std::string_view measured = "2026-11-23, a virtual machine, x86_64, AMD EPYC, 2 cores, GCC 12.2.0";

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A wrench by its slip twist, and a step of the god-object that slips, by each projection; `none` where no finger takes it.
struct Cost {
  std::string_view model;
  double wrench;
  double radial;
  double closest_point;
};

inline constexpr std::array<Cost, 8> models{{
    {"diamond", 1.6, 35.8, 28.4},
    {"box", 1.8, 36.9, 31.3},
    {"ellipse", 3.9, 14.7, 72.2},
    {"table", 4.1, 97.0, 28.2},
    {"quartic", 36.4, 51.3, 282.2},
    {"superellipse", 46.1, 87.1, 437.0},
    {"exact", 40.0, 97.0, 28.2},
    {"exact by quadrature", 15000.0, 97.0, 28.2},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
