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
    {"diamond", 1.6, 43.4, 40.7},
    {"box", 1.8, 46.6, 44.2},
    {"ellipse", 4.0, 32.3, 88.7},
    {"table", 4.3, 114.3, 56.0},
    {"quartic", 37.8, 60.1, 323.9},
    {"superellipse", 47.4, 94.0, 480.9},
    {"exact", 6.2, 321.9, 105.2},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
