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
    {"diamond", 1.8, 31.9, 26.9},
    {"box", 2.0, 33.3, 29.8},
    {"ellipse", 3.6, 17.6, 72.1},
    {"table", 4.5, 98.3, 37.3},
    {"quartic", 42.4, 48.7, 293.1},
    {"superellipse", 53.8, 84.7, 490.4},
    {"exact", 3.5, 276.3, 81.0},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
