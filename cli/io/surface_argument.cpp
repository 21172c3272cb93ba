// SPDX-License-Identifier: MIT
#include "cli/io/surface_argument.hpp"

#include "limitcurve/internal/range.hpp"

#include "godobject/surfaces/surfaces.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/key_values.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

using namespace ranges;

namespace {

using godobject::AnySurface;
using godobject::BodyParameters;

/// A warning of a surface that is probably in millimetres.
std::vector<std::string> size_warning(const std::string& what, double size) {
  constexpr double largest = 5.0;
  if (!(size > largest)) return {};
  return {"warning: " + what + ": " + format_number(size, 3) + " m across: lengths must be in metres"};
}

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
          [=](double mass) { return BodyParameters::capsule(mass, radius, length); },
          size_warning("capsule", length + 2.0 * radius)};
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
  read_key_values(text, {number_key("x", edges.x(), positive), number_key("y", edges.y(), positive),
                         number_key("z", edges.z(), positive)});
  return {AnySurface(godobject::BoxSurface(0.5 * edges)),
          [=](double mass) { return BodyParameters::block(mass, edges); }, size_warning("box", edges.maxCoeff())};
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
  if (kind == "mesh") {
    throw std::invalid_argument("got '" + text +
                                "': meshes are left to other software: let CHAI3D (haptics) or Bullet (bodies under "
                                "load; neither rejects an open "
                                "solid) find the contact, and give it to a SoftFinger as a Contact, or to replay over "
                                "the plane, as columns x, y, "
                                "z = -depth, twist");
  }
  throw std::invalid_argument(
      "got '" + text +
      "', expected plane, sphere:radius=0.05, capsule:radius=0.01,length=0.1, cylinder:radius=0.02,length=0.1, "
      "or box:x=0.12,y=0.04,z=0.04" +
      did_you_mean(kind, {"plane", "sphere", "capsule", "cylinder", "box"},
                   std::string_view(text).substr(kind.size())));
}

}  // namespace limitcurve::cli
