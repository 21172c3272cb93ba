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
    {"diamond", 1.8, 34.3, 27.4},
    {"box", 2.1, 35.4, 29.7},
    {"ellipse", 3.7, 13.9, 71.6},
    {"table", 4.6, 97.5, 28.2},
    {"quartic", 42.8, 52.1, 284.4},
    {"superellipse", 53.9, 87.1, 485.8},
    {"exact", 3.5, 278.4, 80.0},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
