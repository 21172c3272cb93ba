// SPDX-License-Identifier: MIT
// Entry f, its part on shapes.
#include "geometry.hpp"

#include "godobject/closest_point_projection.hpp"
#include "godobject/mesh/mesh_file.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/soft_finger.hpp"
#include "godobject/surfaces.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/laws.hpp"
#include "random.hpp"
#include "sampling.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double stiffness = 1000.0;

TriangleList box_triangles(const Vector3d& half, const Vector3d& at = Vector3d::Zero()) {
  TriangleList list;
  for (int i = 0; i < 8; ++i) {
    list.vertices.push_back(at + half.cwiseProduct(Vector3d((i & 4) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 1) != 0 ? 1 : -1)));
  }
  for (const std::array<int, 4>& face : {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    list.faces.push_back({face[0], face[1], face[2]});
    list.faces.push_back({face[0], face[2], face[3]});
  }
  return list;
}

/// The surface point nearest a finger in a box, as one computes it: by the face that is nearest now.
Contact nearest_face(const Vector3d& half, const Vector3d& finger) {
  int axis = 0;
  const double depth = -(finger.cwiseAbs() - half).maxCoeff(&axis);
  Contact contact{finger, Vector3d::Zero(), depth};
  contact.normal[axis] = finger[axis] >= 0.0 ? 1.0 : -1.0;
  contact.point[axis] = contact.normal[axis] * half[axis];
  return contact;
}

using Triangle = std::array<Vector3d, 3>;

std::vector<Triangle> triangles_of(const TriangleList& list) {
  std::vector<Triangle> result;
  const auto vertex = [&](int i) { return list.vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : list.faces) result.push_back({vertex(a), vertex(b), vertex(c)});
  return result;
}

/// The place of a triangle nearest a point: over it, or on one of its edges.
Vector3d nearest_on(const Triangle& triangle, const Vector3d& point) {
  const auto& [a, b, c] = triangle;
  const Vector3d normal = (b - a).cross(c - a);
  bool over = true;
  Vector3d best = a;
  for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
    over = over && normal.dot((to - from).cross(point - from)) >= 0.0;
    const double along = std::clamp((point - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    const Vector3d place = from + along * (to - from);
    if ((point - place).squaredNorm() < (point - best).squaredNorm()) best = place;
  }
  return over ? Vector3d(point - normal * (normal.dot(point - a) / normal.squaredNorm())) : best;
}

/// Whether a point is inside, as one tells it: it is beneath the face that it is nearest to.
bool beneath_nearest_face(const std::vector<Triangle>& triangles, const Vector3d& point) {
  double least = infinity;
  double height = 0.0;
  for (const Triangle& triangle : triangles) {
    const double distance = (point - nearest_on(triangle, point)).norm();
    if (distance < least) {
      least = distance;
      height = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).dot(point - triangle[0]);
    }
  }
  return height < 0.0;
}

/// How often the surface goes round a point, by the solid angles of its faces (A. Van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng.
/// 30:125–126, 1983): 1 inside, 0 outside.
double winding(const std::vector<Triangle>& triangles, const Vector3d& point) {
  double angle = 0.0;
  for (const Triangle& triangle : triangles) {
    const Vector3d a = triangle[0] - point;
    const Vector3d b = triangle[1] - point;
    const Vector3d c = triangle[2] - point;
    const double above = a.dot(b.cross(c));
    const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
    angle += 2.0 * std::atan2(above, below);
  }
  return angle / (4.0 * std::numbers::pi);
}

/// Six lists of triangles that are not the surface of the solid they were meant to be, and that solid.
struct Broken {
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
  // One more box through its end: a tangle.
  const Vector3d beside{0.05, 0.0, 0.0};
  TriangleList tangled = box;
  const TriangleList other = box_triangles(half * 0.8, beside);
  for (const auto& face : other.faces) tangled.faces.push_back({face[0] + 8, face[1] + 8, face[2] + 8});
  tangled.vertices.insert(tangled.vertices.end(), other.vertices.begin(), other.vertices.end());
  std::vector<Triangle> both = whole;
  for (const Triangle& triangle : triangles_of(other)) both.push_back(triangle);
  // A face seen from behind as well: two faces at the same place.
  TriangleList twice = box;
  twice.faces.push_back({box.faces[0][0], box.faces[0][2], box.faces[0][1]});
  // A needle: a vertex on an edge, which parts the edge's face from a face of no area.
  TriangleList needle = box;
  const Face face = needle.faces[0];
  needle.vertices.push_back(0.5 *
                            (needle.vertices[static_cast<std::size_t>(face[0])] + needle.vertices[static_cast<std::size_t>(face[1])]));
  needle.faces.insert(needle.faces.begin(), {face[0], face[1], 8});
  needle.faces[1] = {face[0], 8, face[2]};
  needle.faces.push_back({8, face[1], face[2]});
  TriangleList lost = box;
  lost.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  return {{open, whole}, {turned, whole}, {tangled, both}, {twice, whole}, {needle, whole}, {lost, whole}};
}

/// Whether `inside` tells the side of every one of 3000 points about a solid.
template <class Inside>
bool tells_every_side(const std::vector<Triangle>& solid, const Inside& inside) {
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    const Vector3d point(random.uniform(-0.1, 0.12), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03));
    if (inside(point) != (winding(solid, point) > 0.5)) return false;
  }
  return true;
}

bool is_inside(const MeshSurface& surface, const Vector3d& point) {
  ContactMemory memory;
  return surface.contact(point, memory).depth > 0.0;
}

}  // namespace

Hazard thin_plate() {
  Hazard found;
  Figure figure{"geometry_plate", {}};
  const std::string test = "Geometry.ThinPlate";
  const Vector3d half{0.03, 0.02, 0.0005};
  const BoxSurface box(half);
  const MeshSurface mesh(Mesh(box_triangles(half)));
  ContactMemory on_box;
  ContactMemory on_mesh;
  const auto push = [](const Contact& contact) { return stiffness * std::max(contact.depth, 0.0) * contact.normal.z(); };
  std::array<double, 3> short_by{};
  for (int i = -20; i <= 300; ++i) {
    const double depth = 1e-5 * i;
    const Vector3d finger(0.003, 0.001, half.z() - depth);
    const std::array forces{push(nearest_face(half, finger)), push(box.contact(finger, on_box)), push(mesh.contact(finger, on_mesh))};
    constexpr std::array series{"nearest surface point", "limitcurve, box", "limitcurve"};
    for (std::size_t j = 0; j < forces.size(); ++j) {
      short_by[j] = std::max(short_by[j], std::max(stiffness * depth, 0.0) - forces[j]);
      if (i % 2 == 0 && j != 1) figure.rows.push_back({"force", series[j], 1e3 * depth, forces[j]});
    }
  }
  const std::string quantity = "what the force towards the finger's side lacks of k_l d [N], pressed 3 mm into 1 mm, 1000 N/m";
  found.findings.push_back({"thin plate", "nearest surface point (ours: box)", quantity, short_by[0], short_by[1], test});
  found.findings.push_back({"thin plate", "nearest surface point (ours: mesh)", quantity, short_by[0], short_by[2], test});
  found.figures.push_back(std::move(figure));
  return found;
}

Hazard side_at_a_vertex() {
  Hazard found;
  Figure figure{"geometry_vertex", {}};
  const std::string test = "Geometry.SideAtAVertex";
  // Pyramids on a square, blunt to sharp; points about the tip.
  Random random(8);
  double most = 0.0;
  double ours = 0.0;
  for (const double angle : evenly(10.0, 150.0, 15)) {
    const double height = 0.02;
    const double side = height * std::tan(0.5 * angle * std::numbers::pi / 180.0);
    TriangleList pyramid;
    // Its tip leans, as tips do.
    pyramid.vertices = {{side, side, 0.0}, {-side, side, 0.0}, {-side, -side, 0.0}, {side, -side, 0.0}, {1.8 * side, 0.2 * side, height}};
    pyramid.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
    const std::vector<Triangle> triangles = triangles_of(pyramid);
    const MeshSurface surface{Mesh(pyramid)};
    int wrong = 0;
    int our_wrong = 0;
    constexpr int points = 1500;
    for (int i = 0; i < points; ++i) {
      const Vector3d point =
          pyramid.vertices[4] + Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)) * 0.002;
      const bool inside = winding(triangles, point) > 0.5;
      wrong += beneath_nearest_face(triangles, point) != inside;
      our_wrong += is_inside(surface, point) != inside;
    }
    figure.rows.push_back({"share", "side of the nearest face", angle, static_cast<double>(wrong) / points});
    figure.rows.push_back({"share", "limitcurve", angle, static_cast<double>(our_wrong) / points});
    most = std::max(most, static_cast<double>(wrong) / points);
    ours = std::max(ours, static_cast<double>(our_wrong) / points);
  }
  found.findings.push_back({"nearest place a vertex or an edge", "side of the nearest face",
                            "share of points about a tip taken for the other side, worst of 15 pyramids", most, ours, test});
  found.figures.push_back(std::move(figure));
  return found;
}

Hazard broken_meshes() {
  const std::string test = "Geometry.BrokenMeshes";
  double customary = 0.0;
  double ours = 0.0;
  double refused = 0.0;
  for (const auto& [list, meant] : broken()) {
    const std::vector<Triangle> triangles = triangles_of(list);
    customary += !tells_every_side(meant, [&](const Vector3d& point) { return beneath_nearest_face(triangles, point); });
    try {
      const MeshSurface surface{Mesh(list)};
      ours += !tells_every_side(meant, [&](const Vector3d& point) { return is_inside(surface, point); });
    } catch (const std::invalid_argument&) {
      refused += 1.0;
    }
  }
  Hazard found;
  found.findings.push_back({"open, turned, tangled, doubled, needle, no number", "side of the nearest face",
                            "meshes of six that are taken and tell a wrong side", customary, ours, test});
  found.findings.push_back({"open, turned, tangled, doubled, needle, no number", "any triangles are taken",
                            "meshes of six refused, with the face and what is wrong", 0.0, refused, test});
  return found;
}

Hazard normals_that_jump() {
  const std::string test = "Geometry.NormalsThatJump";
  constexpr double mu = 0.8;
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  SoftFinger finger(Ellipse::through_intercepts(hertz()->moment_ratio()), with, ClosestPoint{});
  // Round a rod of eight edges, just beneath its surface.
  Vector3d proxy(0.0, 0.0, 0.0);
  bool touched = false;
  double customary = 0.0;
  double ours = 0.0;
  double work = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double angle = 0.002 * i;
    const double of_face = 0.25 * std::numbers::pi * std::round(angle / (0.25 * std::numbers::pi));
    const Vector3d normal(std::cos(of_face), std::sin(of_face), 0.0);
    const double inner = 0.02;
    const Vector3d place = 0.019 * Vector3d(std::cos(angle), std::sin(angle), 0.0);
    const double depth = inner - normal.dot(place);
    const Contact contact{place + normal * depth, normal, depth};
    // As one writes it: a spring from the finger's place on the surface to the proxy, cut to the limit.
    if (!touched) proxy = contact.point;
    touched = true;
    Vector3d pull = proxy - contact.point;
    const double most = mu * depth;
    if (pull.norm() > most) pull *= most / pull.norm();
    proxy = contact.point + pull;
    customary = std::max(customary, std::fabs(pull.dot(normal)) / most);
    const FingerOutput& output = finger.update(contact, 0.0);
    ours = std::max(ours, std::fabs(output.force.dot(normal)) / (mu * output.load));
    work = std::min(work, output.slip_work);
  }
  Hazard found;
  found.findings.push_back({"normals that jump", "spring to the proxy, cut to μP", "friction along the normal / μP, edges of 45°",
                            customary, std::max(ours, -work), test});
  return found;
}

}  // namespace limitcurve::stability
