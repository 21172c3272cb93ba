// SPDX-License-Identifier: MIT
#include "limitcurve/patch/half_spaces.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

// Each row is a twist n: n·w ≤ s H(n), where H is the friction's power and s = 1/(largest gauge of the vertices of {n·w
// ≤ H(n)}).
//   Inside: the polytope is bounded, so it is the hull of its vertices; their gauge is ≤ 1 by the choice of s, and the
//   gauge is convex. Share: of the limit surface's inside K, sK satisfies all rows, and each row touches it. Every
//   load: H is proportional to μN.

namespace limitcurve {

namespace {

using Triple =
    std::array<double, 3>;  ///< a twist or a wrench about the centre of pressure, in units in which H is nearly |n|

double product(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple normal_to(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twists on rings: directions of the sliding, and latitudes [°] between sliding and spin. Of the polytopes (|F| in a
/// regular polygon) × (polygon about the curve of F and M) these have the largest share of a uniform disc: all their
/// edges have the same. Other laws and shapes lose little.
struct Rings {
  std::size_t rows;
  int directions;
  std::span<const double> latitudes;
};
constexpr std::array latitudes_8{35.264};
constexpr std::array latitudes_14{27.888, 90.0};
constexpr std::array latitudes_32{0.0, 40.322, 90.0};
constexpr std::array latitudes_62{0.0, 28.507, 50.387, 90.0};
constexpr std::array latitudes_128{0.0, 22.835, 39.714, 59.764, 90.0};
constexpr std::array all_rings{Rings{8, 4, latitudes_8}, Rings{14, 6, latitudes_14}, Rings{32, 10, latitudes_32},
                               Rings{62, 12, latitudes_62}, Rings{128, 18, latitudes_128}};

/// Unit vectors, each followed by its opposite.
std::vector<Triple> directions_of(const Rings& rings) {
  std::vector<Triple> result;
  for (const double latitude : rings.latitudes) {
    const double b = latitude * (std::numbers::pi / 180.0);
    const int count = latitude == 90.0 ? 1 : latitude == 0.0 ? rings.directions / 2 : rings.directions;
    for (int i = 0; i < count; ++i) {
      const double a = 2.0 * std::numbers::pi * i / rings.directions;
      const Triple one{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
      result.push_back(one);
      result.push_back({-one[0], -one[1], -one[2]});
    }
  }
  return result;
}

/// The vertices of {p·x ≤ 1 for all planes p}, which is bounded: the points of three planes that no other cuts off.
std::vector<Triple> vertices_of(const std::vector<Triple>& planes) {
  constexpr double parallel = 1e-12;
  constexpr double outside = 1.0 + 1e-9;  // a point too many makes the polytope smaller, no more
  constexpr double same = 1e-8;
  std::vector<Triple> found;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Triple first = normal_to(planes[i], planes[j]);
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const double volume = product(first, planes[k]);
        if (!(std::fabs(volume) > parallel)) continue;
        const Triple second = normal_to(planes[j], planes[k]);
        const Triple third = normal_to(planes[k], planes[i]);
        Triple point;
        for (std::size_t n = 0; n < 3; ++n) point[n] = (first[n] + second[n] + third[n]) / volume;
        const auto cuts = [&](const Triple& plane) { return product(plane, point) > outside; };
        const auto is_same = [&](const Triple& other) {
          return std::max({std::fabs(other[0] - point[0]), std::fabs(other[1] - point[1]),
                           std::fabs(other[2] - point[2])}) < same;
        };
        if (std::any_of(planes.begin(), planes.end(), cuts) || std::any_of(found.begin(), found.end(), is_same))
          continue;
        found.push_back(point);
      }
    }
  }
  return found;
}

}  // namespace

HalfSpaces half_spaces(const Patch& patch, std::size_t rows) {
  const auto above =
      std::find_if(all_rings.begin(), all_rings.end(), [&](const Rings& rings) { return rings.rows > rows; });
  if (above == all_rings.begin()) throw out_of_range("rows", static_cast<double>(rows), "1", ">= 8");
  if (!(patch.moment_ratio() > 0.0))
    throw std::invalid_argument("half_spaces: a single point bears no moment, expected a patch that does");
  const PatchPoint centre = patch.centre();
  // The powers of the slides along x and y and of the spin: 1, 1, m0 but for orthotropic friction.
  const Triple unit{patch.power({1.0, 0.0, 0.0}), patch.power({0.0, 1.0, 0.0}), patch.moment_ratio()};
  double error = 0.0;                                       // of the patch's own power: a fraction
  const auto see_error_at = [&](const PatchTwist& twist) {  // beside it: the force of a point under the COR has no
                                                            // direction, but no power either
    constexpr double near = 1e-6;
    error = std::max(error,
                     patch.about_origin({twist.vx + near * patch.radius() * twist.omega, twist.vy, twist.omega}).error);
  };
  HalfSpaces result;
  std::vector<Triple> planes;
  for (const Triple& direction : directions_of(*std::prev(above))) {
    const PatchTwist twist{direction[0] / unit[0], direction[1] / unit[1], direction[2] / unit[2]};
    const PatchTwist at_origin{twist.vx + twist.omega * centre.y, twist.vy - twist.omega * centre.x, twist.omega};
    const double power = patch.power(twist);
    see_error_at(at_origin);
    planes.push_back({direction[0] / power, direction[1] / power, direction[2] / power});
    result.rows.push_back({at_origin.vx / power, at_origin.vy / power, at_origin.omega / power});
  }
  double largest = 0.0;
  for (const Triple& vertex : vertices_of(planes)) {
    PatchWrench wrench{unit[0] * vertex[0], unit[1] * vertex[1], unit[2] * vertex[2]};
    wrench.moment += centre.x * wrench.fy - centre.y * wrench.fx;
    const PatchSlip slip = patch.slip(wrench);
    largest = std::max(largest, slip.gauge);
    see_error_at(slip.twist);
    result.vertices.push_back(wrench);
  }
  constexpr double rounding = 1e-11;  // of gauges and vertices
  const double size = (1.0 - rounding) / (largest * (1.0 + error));
  for (HalfSpace& row : result.rows) row = {row.fx / size, row.fy / size, row.moment / size};
  for (PatchWrench& vertex : result.vertices) vertex = {vertex.fx * size, vertex.fy * size, vertex.moment * size};
  result.share = size * (1.0 - error);
  return result;
}

}  // namespace limitcurve
