// SPDX-License-Identifier: MIT
#include "cli/io/surface_argument.hpp"

#include "cli/io/range.hpp"

#include "godobject/surface.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/key_values.hpp"
#include "limitcurve/internal/number.hpp"
#ifdef LIMITCURVE_HAS_MESH
#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_file.hpp"
#endif

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

namespace {

using godobject::AnySurface;
using godobject::BodyParameters;

/// A warning of a surface that is probably in millimetres; `remedy` ends it.
std::vector<std::string> size_warning(const std::string& what, double size, const std::string& remedy = "") {
  constexpr double largest = 5.0;
  if (!(size > largest)) return {};
  return {"warning: " + what + ": " + format_number(size, 3) + " m across: is it in metres?" + remedy};
}

#ifdef LIMITCURVE_HAS_MESH
constexpr Range counted{1.0, 1e9, "a whole number from 1", true};

SurfaceArgument read_mesh(std::string_view text) {
  std::string_view items;
  const std::string file = split_file("mesh", text, items);
  double scale = 1.0;
  double body = 0.0;
  read_key_values(items, {number_key("scale", scale, positive, false), number_key("body", body, counted, false)});
  const godobject::MeshSurface surface = godobject::read_mesh(file, scale, static_cast<int>(body));
  const int faces = static_cast<int>(surface.mesh().faces().size());
  const auto& repairs = surface.mesh().repairs();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : surface.mesh().vertices()) box.extend(vertex);
  std::vector<std::string> notes = size_warning(file, box.sizes().maxCoeff(), " If it is in millimetres append ,scale=0.001");
  if (repairs.turned > 0) {
    notes.push_back("note: " + file + ": " + std::to_string(repairs.turned) + " of " + std::to_string(faces) +
                    " faces looked inward and were turned outward; the surface bounds a solid, not a room");
  }
  if (repairs.slivers > 0) {
    notes.push_back("note: " + file + ": slivers taken out, none higher than two spacings of a float: " + std::to_string(repairs.slivers));
  }
  return {AnySurface(surface), {}, notes};
}
#else
SurfaceArgument read_mesh(std::string_view file) {
  throw std::invalid_argument("'mesh:" + std::string(file) + "': this program was built without meshes, expected another surface");
}
#endif

SurfaceArgument read_sphere(std::string_view text) {
  double radius = 0.0;
  read_key_values(text, {number_key("radius", radius, positive)});
  return {AnySurface(godobject::SphereSurface(radius)), [=](double mass) { return BodyParameters::ball(mass, radius); },
          size_warning("sphere", 2.0 * radius)};
}

SurfaceArgument read_capsule(std::string_view text) {
  double radius = 0.0;
  double length = 0.0;
  read_key_values(text, {number_key("radius", radius, positive), number_key("length", length, non_negative)});
  return {AnySurface(godobject::CapsuleSurface(radius, 0.5 * length)),
          [=](double mass) { return BodyParameters::capsule(mass, radius, length); }, size_warning("capsule", length + 2.0 * radius)};
}

SurfaceArgument read_cylinder(std::string_view text) {
  double radius = 0.0;
  double length = 0.0;
  read_key_values(text, {number_key("radius", radius, positive), number_key("length", length, positive)});
  return {AnySurface(godobject::CylinderSurface(radius, 0.5 * length)),
          [=](double mass) { return BodyParameters::cylinder(mass, radius, length); },
          size_warning("cylinder", std::max(length, 2.0 * radius))};
}

SurfaceArgument read_box(std::string_view text) {
  Eigen::Vector3d edges = Eigen::Vector3d::Zero();
  read_key_values(text, {number_key("x", edges.x(), positive), number_key("y", edges.y(), positive), number_key("z", edges.z(), positive)});
  return {AnySurface(godobject::BoxSurface(0.5 * edges)), [=](double mass) { return BodyParameters::block(mass, edges); },
          size_warning("box", edges.maxCoeff())};
}

}  // namespace

SurfaceArgument read_surface(const std::string& text) {
  if (text == "plane") return {AnySurface(godobject::PlaneSurface{}), {}};
  const auto [kind, given] = split_description(text);
  const std::string_view rest = given.value_or("");
  if (kind == "sphere") return read_sphere(rest);
  if (kind == "capsule") return read_capsule(rest);
  if (kind == "cylinder") return read_cylinder(rest);
  if (kind == "box") return read_box(rest);
  if (kind == "mesh") return read_mesh(rest);
  throw std::invalid_argument(
      "got '" + text +
      "', expected plane, sphere:radius=0.05, capsule:radius=0.01,length=0.1, cylinder:radius=0.02,length=0.1, "
      "box:x=0.12,y=0.04,z=0.04 or mesh:FILE.obj" +
      did_you_mean(kind, {"plane", "sphere", "capsule", "cylinder", "box", "mesh"}, std::string_view(text).substr(kind.size())));
}

}  // namespace limitcurve::cli
