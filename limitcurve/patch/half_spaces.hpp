// SPDX-License-Identifier: MIT
#pragma once

#include "patch.hpp"

#include <cstddef>
#include <vector>

/// Friction for planners, as linear inequalities inside the limit surface that a quadratic programme can use.
namespace limitcurve {

/// The inequality fx F_x + fy F_y + moment M ≤ μN.
struct HalfSpace {
  double fx = 0.0;      ///< [1]
  double fy = 0.0;      ///< [1]
  double moment = 0.0;  ///< [1/m]
};

/// A polytope inside the limit surface. Rows do not depend on μ and N; after each row comes the opposite row.
struct HalfSpaces {
  std::vector<HalfSpace> rows;
  std::vector<PatchWrench>
      vertices;  ///< for μN = 1 [1, 1, m]; the wrenches that hold are Σ λᵢ vᵢ with λᵢ ≥ 0, Σ λᵢ ≤ μN
  double share = 0.0;  ///< radius of the polytope over that of the limit surface, in the worst direction
};

/// At most `rows` inequalities, the largest of 8, 14, 32, 62, 128 that fits, for wrenches [N, N m] about the origin of
/// the patch's coordinates. A wrench that satisfies all of them holds, because no vertex exceeds the limit surface
/// (the error of the patch included). `share` is 0.89 for a rectangle 2 : 1 and 32 rows, 0.96 for 128. A round contact
/// is the patch `Patch::ellipse(law, a, a)`. If a grows with the load (γ > 0), rows made at the smallest load are safe
/// at larger loads; other rows hold only for the pressure of the patch. Cost: three wrenches for each row and 200 for
/// each vertex, 1 ms for 32 rows on a rectangle; 128 rows compare 340 000 triples of planes. Throws
/// std::invalid_argument for fewer than 8 rows, and for a single point, which carries no moment.
HalfSpaces half_spaces(const Patch& patch, std::size_t rows = 32);

}  // namespace limitcurve
