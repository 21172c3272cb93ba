// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

/// What models cost on one machine, mean nanoseconds: read them as ratios. Written by scripts/work_precision; do not edit.
namespace limitcurve::shipped_costs {

inline constexpr std::string_view measured = "2026-11-20, a virtual machine, x86_64, AMD EPYC, 2 cores, GCC 12.2.0";

/// A wrench by its slip twist, and a step of the god-object that slips, by each projection.
struct Cost {
  std::string_view model;
  double wrench;
  double radial;
  double closest_point;
};

inline constexpr std::array<Cost, 7> models{{
    {"diamond", 1.6, 42.2, 38.8},
    {"box", 1.8, 45.3, 43.3},
    {"ellipse", 3.9, 32.3, 86.1},
    {"table", 4.4, 112.8, 56.0},
    {"quartic", 37.0, 58.9, 321.2},
    {"superellipse", 46.9, 91.3, 461.9},
    {"exact", 6.0, 316.0, 102.7},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
