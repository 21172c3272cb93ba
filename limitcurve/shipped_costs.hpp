// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

/// What models cost on one machine, mean nanoseconds: read them as ratios. Written by scripts/work_precision; do not edit.
namespace limitcurve::shipped_costs {

inline constexpr std::string_view measured = "2026-11-22, a virtual machine, x86_64, Intel(R) Xeon(R) Processor, 2 cores, GCC 12.2.0";

/// A wrench by its slip twist, and a step of the god-object that slips, by each projection.
struct Cost {
  std::string_view model;
  double wrench;
  double radial;
  double closest_point;
};

inline constexpr std::array<Cost, 7> models{{
    {"diamond", 1.8, 34.6, 27.4},
    {"box", 2.0, 35.5, 30.4},
    {"ellipse", 3.6, 14.0, 71.7},
    {"table", 4.5, 98.3, 28.4},
    {"quartic", 42.8, 51.6, 285.2},
    {"superellipse", 54.1, 88.1, 484.1},
    {"exact", 3.6, 277.6, 79.5},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
