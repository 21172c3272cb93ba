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
    {"diamond", 1.6, 54.3, 47.3},
    {"box", 1.8, 54.7, 49.5},
    {"ellipse", 3.9, 39.1, 133.2},
    {"table", 5.5, 121.0, 76.3},
    {"quartic", 38.4, 63.7, 325.1},
    {"superellipse", 48.0, 97.5, 464.3},
    {"exact", 6.2, 332.0, 115.6},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
