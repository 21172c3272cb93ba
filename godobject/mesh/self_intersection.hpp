// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/closed_triangles.hpp"

#include <optional>
#include <utility>

namespace limitcurve::godobject {

/// Two faces that meet where they share neither edge nor vertex, or fold on to each other; nothing if there are none. Exact on the grid.
/// Cost: finding all faces with overlapping boxes; around a vertex of many faces, all faces in overlapping directions from there.
std::optional<std::pair<int, int>> find_self_intersection(const ClosedTriangles& triangles);

}  // namespace limitcurve::godobject
