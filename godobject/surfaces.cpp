// SPDX-License-Identifier: MIT
#include "godobject/surfaces.hpp"

#include "limitcurve/number.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve::godobject {

namespace {

double positive(std::string_view name, double value) {
  if (!(value > 0.0 && value <= 1e6)) throw out_of_range(name, value, "m", "> 0, up to 1e6");
  return value;
}

/// The ball's surface about `centre`; the normal where the finger is at the centre is the one it had before.
Contact on_ball(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& finger, ContactMemory& memory) noexcept {
  const Eigen::Vector3d away = finger - centre;
  const double distance = away.norm();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  if (distance > 0.0) {
    normal = away / distance;
  } else if (memory.finger.squaredNorm() > 0.0) {
    normal = memory.finger.normalized();
  }
  memory.face = distance < radius ? 0 : -1;
  // At the centre the side last known stays in memory.
  if (distance > 0.0) memory.finger = finger;
  memory.known = true;
  return {centre + normal * radius, normal, radius - distance};
}

}  // namespace

SphereSurface::SphereSurface(double radius) : radius_(positive("radius", radius)) {}

Contact SphereSurface::contact(const Eigen::Vector3d& finger, ContactMemory& memory) const noexcept {
  return on_ball(Eigen::Vector3d::Zero(), radius_, finger, memory);
}

CapsuleSurface::CapsuleSurface(double radius, double half_length) : radius_(positive("radius", radius)), half_length_(half_length) {
  if (!(half_length >= 0.0 && half_length <= 1e6)) throw out_of_range("half_length", half_length, "m", ">= 0, up to 1e6");
}

Contact CapsuleSurface::contact(const Eigen::Vector3d& finger, ContactMemory& memory) const noexcept {
  return on_ball({0.0, 0.0, std::clamp(finger.z(), -half_length_, half_length_)}, radius_, finger, memory);
}

CylinderSurface::CylinderSurface(double radius, double half_length)
    : radius_(positive("radius", radius)), half_length_(positive("half_length", half_length)) {}

Contact CylinderSurface::contact(const Eigen::Vector3d& finger, ContactMemory& memory) const noexcept {
  // Faces: 0 the side, 1 the upper end, 2 the lower.
  const double distance = std::hypot(finger.x(), finger.y());
  const double beyond_side = distance - radius_;
  const double beyond_end = std::fabs(finger.z()) - half_length_;
  const Eigen::Vector3d radial =
      distance > 0.0 ? Eigen::Vector3d(finger.x() / distance, finger.y() / distance, 0.0) : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d axial = {0.0, 0.0, finger.z() >= 0.0 ? 1.0 : -1.0};

  // On the face of the last step as long as the finger is beneath it.
  int face = memory.face;
  if (face == 0 && (beyond_side >= 0.0 || beyond_end > 0.0)) face = -1;
  const double height = face == 2 ? -finger.z() : finger.z();
  if (face > 0 && (height >= half_length_ || beyond_side > 0.0)) face = -1;

  if (face < 0 && beyond_side < 0.0 && beyond_end < 0.0) {
    // It came in: by an end if it was beyond that before, else by what is nearer.
    const bool from_above = memory.finger.z() >= half_length_;
    const bool from_below = memory.finger.z() <= -half_length_;
    if (from_above || from_below) {
      face = from_above ? 1 : 2;
    } else if (std::hypot(memory.finger.x(), memory.finger.y()) >= radius_) {
      face = 0;
    } else {
      face = beyond_side > beyond_end ? 0 : finger.z() >= 0.0 ? 1 : 2;
    }
  }
  memory = {face, finger, true};
  if (face == 0) return {radial * radius_ + Eigen::Vector3d(0.0, 0.0, finger.z()), radial, -beyond_side};
  if (face > 0) {
    const double side = face == 1 ? 1.0 : -1.0;
    return {{finger.x(), finger.y(), side * half_length_}, {0.0, 0.0, side}, half_length_ - side * finger.z()};
  }
  // Outside: the nearest point, with the way to it for a normal.
  const Eigen::Vector3d nearest = radial * std::min(distance, radius_) + axial * std::min(std::fabs(finger.z()), half_length_);
  const Eigen::Vector3d way = finger - nearest;
  const double gap = way.norm();
  return {nearest, gap > 0.0 ? Eigen::Vector3d(way / gap) : (beyond_side >= beyond_end ? radial : axial), -gap};
}

BoxSurface::BoxSurface(const Eigen::Vector3d& half_edges) : half_edges_(half_edges) {
  for (const double edge : half_edges) positive("half edge", edge);
}

/// Whether the finger is past an edge of the faces on `axis`.
bool BoxSurface::beside(const Eigen::Vector3d& finger, int axis) const noexcept {
  for (int other = 0; other < 3; ++other) {
    if (other != axis && std::fabs(finger[other]) > half_edges_[other]) return true;
  }
  return false;
}

/// The face by which the way between two places enters the box; −1 if it does not touch it.
int BoxSurface::crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept {
  int face = -1;
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      const double before = side * from[axis] - half_edges_[axis];  // > 0: beyond the face
      const double now = side * to[axis] - half_edges_[axis];
      if (before >= 0.0 && now >= 0.0) return -1;
      if (before < 0.0 && now < 0.0) continue;
      const double when = before / (before - now);
      if (before >= 0.0) {
        if (face < 0 || when > enter) face = 2 * axis + (side > 0.0 ? 0 : 1);
        enter = std::max(enter, when);
      } else {
        leave = std::min(leave, when);
      }
    }
  }
  return enter <= leave ? face : -1;
}

int BoxSurface::nearest_face(const Eigen::Vector3d& finger) const noexcept {
  int axis = 0;
  (finger.cwiseAbs() - half_edges_).maxCoeff(&axis);
  return 2 * axis + (finger[axis] >= 0.0 ? 0 : 1);
}

Contact BoxSurface::contact(const Eigen::Vector3d& finger, ContactMemory& memory) const noexcept {
  // Face 2·axis looks along +axis, 2·axis + 1 along −axis.
  const auto depth_under = [&](int face) {
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    return half_edges_[face / 2] - side * finger[face / 2];
  };
  int face = memory.face;
  if (face >= 0 && (depth_under(face) <= 0.0 || beside(finger, face / 2))) face = -1;
  const bool inside = (finger.cwiseAbs() - half_edges_).maxCoeff() < 0.0;
  if (face < 0 && memory.face < 0 && memory.known) {
    face = crossed(memory.finger, finger);
    // Through the box and out again at a side: the finger has passed a corner.
    if (face >= 0 && beside(finger, face / 2)) face = -1;
  }
  if (face < 0 && inside) face = nearest_face(finger);
  memory = {face, finger, true};
  if (face >= 0) {
    const int axis = face / 2;
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    Contact contact{finger, Eigen::Vector3d::Zero(), depth_under(face)};
    contact.point[axis] = side * half_edges_[axis];
    contact.normal[axis] = side;
    return contact;
  }
  const Eigen::Vector3d nearest = finger.cwiseMax(-half_edges_).cwiseMin(half_edges_);
  const Eigen::Vector3d way = finger - nearest;
  const double gap = way.norm();
  if (gap > 0.0) return {nearest, way / gap, -gap};
  // Exactly on the surface.
  const int on = nearest_face(finger);
  Contact contact{nearest, Eigen::Vector3d::Zero(), 0.0};
  contact.normal[on / 2] = on % 2 == 0 ? 1.0 : -1.0;
  return contact;
}

}  // namespace limitcurve::godobject
