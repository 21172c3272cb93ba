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
    {"diamond", 1.6, 52.9, 46.0},
    {"box", 1.8, 55.6, 49.5},
    {"ellipse", 3.9, 38.9, 133.2},
    {"table", 4.6, 122.3, 84.4},
    {"quartic", 38.2, 63.0, 324.5},
    {"superellipse", 47.8, 97.8, 460.9},
    {"exact", 7.0, 329.7, 117.3},
}};

/// Of a model that is in the table.
constexpr const Cost& of(std::string_view model) {
  std::size_t i = 0;
  while (models.at(i).model != model) ++i;  // does not compile, or throws, for a model that is not there
  return models.at(i);
}

}  // namespace limitcurve::shipped_costs
