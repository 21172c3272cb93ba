// SPDX-License-Identifier: MIT
// Entry "geometry": defective meshes.
#include "geometry.hpp"
#include "godobject/mesh/mesh.hpp"

#include "../numerics/sampling.hpp"
#include "../random.hpp"
#include "limitcurve/internal/number.hpp"
#include "solids.hpp"
#include "tests/touch.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using Eigen::Vector3d;

/// Six defective lists of triangles, and the intended solid.
struct Broken {
  const char* name;
  TriangleList list;
  std::vector<Triangle> meant;
};

std::vector<Broken> broken() {
  const Vector3d half{0.06, 0.02, 0.02};
  const TriangleList box = box_triangles(half);
  const std::vector<Triangle> whole = triangles_of(box);
  TriangleList open = box;
  open.faces.pop_back();
  TriangleList turned = box;
  std::swap(turned.faces[3][0], turned.faces[3][1]);
  // Another box through its end: a self-intersection.
  const Vector3d beside{0.05, 0.0, 0.0};
  TriangleList tangled = box;
  const TriangleList other = box_triangles(half * 0.8, beside);
  for (const auto& face : other.faces) tangled.faces.push_back({face[0] + 8, face[1] + 8, face[2] + 8});
  tangled.vertices.insert(tangled.vertices.end(), other.vertices.begin(), other.vertices.end());
  std::vector<Triangle> both = whole;
  for (const Triangle& triangle : triangles_of(other)) both.push_back(triangle);
  // A second face with the reverse orientation at the same place.
  TriangleList twice = box;
  twice.faces.push_back({box.faces[0][0], box.faces[0][2], box.faces[0][1]});
  // A degenerate face: a vertex on an edge splits off a face without area.
  TriangleList needle = box;
  const Face face = needle.faces[0];
  needle.vertices.push_back(0.5 *
                            (needle.vertices[static_cast<std::size_t>(face[0])] + needle.vertices[static_cast<std::size_t>(face[1])]));
  needle.faces.insert(needle.faces.begin(), {face[0], face[1], 8});
  needle.faces[1] = {face[0], 8, face[2]};
  needle.faces.push_back({8, face[1], face[2]});
  TriangleList lost = box;
  lost.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  return {{"a face missing", open, whole},  {"a face turned", turned, whole},       {"tangled with another", tangled, both},
          {"a face doubled", twice, whole}, {"a face without area", needle, whole}, {"a corner that is NaN", lost, whole}};
}

/// Whether `inside` is right for all of 3000 points near a solid.
template <class Inside>
bool tells_every_side(const std::vector<Triangle>& solid, const Inside& inside) {
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    const Vector3d point(random.uniform(-0.1, 0.12), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03));
    if (inside(point) != (winding(solid, point) > 0.5)) return false;
  }
  return true;
}

/// Draws the slice y = 1.5 cm: 0 outside, 1 inside, 2 where the nearest face gives the wrong side; and whether ours refuses.
void draw_slice(Figure& figure, const Broken& mesh, bool refused) {
  const std::vector<Triangle> triangles = triangles_of(mesh.list);
  for (const double z : evenly(-0.0299, 0.0301, 21)) {
    for (const double x : evenly(-0.0999, 0.1201, 56)) {
      const Vector3d point(x, 0.0151, z);
      const bool inside = winding(mesh.meant, point) > 0.5;
      const bool right = beneath_nearest_face(triangles, point) == inside;
      figure.rows.push_back({mesh.name, format_number(1e3 * z), 1e3 * x, right ? (inside ? 1.0 : 0.0) : 2.0});
    }
  }
  figure.rows.push_back({mesh.name, "refused", 0.0, refused ? 1.0 : 0.0});
}

/// A box of 12 × 4 × 4 cm, askew, whose top has a vertex near an edge: a sliver of this height over its length. In single precision, as
/// STL has it. Faces 0 and 1 are the sliver and the rest of its triangle.
TriangleList with_sliver(double share, const Eigen::Quaterniond& turn) {
  TriangleList list = box_triangles({0.06, 0.02, 0.02});
  const Face face = list.faces[0];
  const auto corner = [&](int i) { return list.vertices[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])]; };
  const Vector3d edge = corner(2) - corner(0);
  // Beside the diagonal, which belongs to the face beyond; towards the face's third corner.
  const Vector3d across = (corner(1) - corner(0) - edge * (corner(1) - corner(0)).dot(edge) / edge.squaredNorm()).normalized();
  list.vertices.push_back(corner(0) + 0.4 * edge + across * (share * edge.norm()));
  list.faces[0] = {face[0], 8, face[2]};
  list.faces.insert(list.faces.begin() + 1, {{face[0], face[1], 8}, {face[1], face[2], 8}});
  for (Vector3d& vertex : list.vertices) vertex = (turn * vertex).cast<float>().cast<double>();
  return list;
}

/// Angle between the computed normal of a sliver and that of the side, and the same for ours; nothing if ours refuses.
std::pair<double, std::optional<double>> sliver_errors(double share, const Eigen::Quaterniond& turn) {
  const TriangleList list = with_sliver(share, turn);
  const Vector3d truth = turn * Vector3d(-1.0, 0.0, 0.0);
  const auto angle = [&](const Vector3d& normal) {
    return normal.norm() > 0.0 ? std::atan2(normal.cross(truth).norm(), normal.dot(truth)) : std::numbers::pi;
  };
  const auto [a, b, c] = triangles_of(list).front();
  const double customary = angle((b - a).cross(c - a).normalized());
  try {
    const MeshSurface surface{Mesh(list)};
    const Vector3d middle = (a + b + c) / 3.0;
    ContactMemory memory;
    static_cast<void>(touch(surface, middle + 1e-3 * truth, memory));
    return {customary, angle(touch(surface, middle - 1e-4 * truth, memory).normal)};
  } catch (const std::invalid_argument&) {
    return {customary, std::nullopt};
  }
}

}  // namespace

Hazard broken_meshes() {
  double customary = 0.0;
  double ours = 0.0;
  double refused = 0.0;
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"geometry_broken", {}});
  for (const Broken& mesh : broken()) {
    const std::vector<Triangle> triangles = triangles_of(mesh.list);
    bool taken = true;
    customary += !tells_every_side(mesh.meant, [&](const Vector3d& point) { return beneath_nearest_face(triangles, point); });
    try {
      const MeshSurface surface{Mesh(mesh.list)};
      ours += !tells_every_side(mesh.meant, [&](const Vector3d& point) { return is_inside(surface, point); });
    } catch (const std::invalid_argument&) {
      refused += 1.0;
      taken = false;
    }
    draw_slice(figure, mesh, !taken);
  }
  found.findings.push_back({"open, flipped, intersecting, doubled, degenerate, NaN", "side of the nearest face",
                            "of six meshes, those accepted that give a wrong side", customary, ours});
  found.findings.push_back({"open, flipped, intersecting, doubled, degenerate, NaN", "any triangles accepted",
                            "of six meshes, those refused with face and reason", 0.0, refused});
  return found;
}

Hazard slivers() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"geometry_slivers", {}});
  double worst = 0.0;
  double ours_worst = 0.0;
  for (const double share : in_ratios(1e-10, 0.1, 55)) {
    Random random(6);
    double of_normals = 0.0;
    double felt = 0.0;
    bool taken = true;
    for (int i = 0; i < 20; ++i) {
      const Eigen::Quaterniond turn =
          Eigen::Quaterniond(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0))
              .normalized();
      const auto [customary, ours] = sliver_errors(share, turn);
      of_normals = std::max(of_normals, customary);
      taken = taken && ours;
      if (ours) felt = std::max(felt, *ours);
    }
    worst = std::max(worst, of_normals);
    ours_worst = std::max(ours_worst, felt);
    figure.rows.push_back({"error", "normal of the face", share, of_normals});
    figure.rows.push_back({"error", "limitcurve", share, taken ? std::max(felt, 1e-9) : std::numeric_limits<double>::quiet_NaN()});
  }
  found.findings.push_back({"slivers, in single precision", "normal of the face",
                            "error of the normal [rad] (height 1e-10 to 0.1 of the length; ours: accepted faces)", worst, ours_worst});
  return found;
}

}  // namespace limitcurve::stability
