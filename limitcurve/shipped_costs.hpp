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
    {"diamond", 1.8, 29.4, 24.7},
    {"box", 2.0, 30.7, 26.8},
    {"ellipse", 3.6, 14.4, 69.8},
    {"table", 4.5, 92.8, 29.5},
    {"quartic", 42.9, 46.9, 288.6},
    {"superellipse", 54.1, 83.0, 490.6},
    {"exact", 3.5, 277.3, 81.1},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
