// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table_side.hpp"

namespace limitcurve {

enum class Side { inside, outside };

/// A side of a table with the bound of its error in f and m.
struct CertifiedSide {
  TableSide side;
  double error;
};

/// Builds one side of a table: nodes spaced so that every cell has the same share of the tolerance.
///
/// The error of a cubic Hermite cell of width h is h⁴/384 times the fourth derivative, so the best node density is
/// the fourth root of that derivative, which is integrable for every singularity of a limit curve: the node count
/// stays ∝ tolerance^(−1/4). The density is learnt by bisection, the nodes are laid, then every cell is compared with
/// the exact curve at `certificate_points` places (and, next to the rim, at places that crowd towards it) and, where
/// it fails, the density there is raised.
/// The bound returned is the largest error found, raised by `certificate_margin` for what lies between the places.
/// Throws std::runtime_error if `TableSide::most_nodes` do not suffice.
CertifiedSide build_side(const PressureLaw& law, Side side, double tolerance);

inline constexpr int certificate_points = 15;
inline constexpr double certificate_margin = 0.02;

}  // namespace limitcurve
