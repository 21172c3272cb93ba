// SPDX-License-Identifier: MIT
#include "godobject/surfaces/surfaces.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve::godobject {

namespace {

double positive(std::string_view name, double value) {
  if (!(value > 0.0 && value <= 1e6)) throw out_of_range(name, value, "m", "> 0, up to 1e6");
  return value;
}

/// For a shorter vector [m] the square underflows, and the direction is lost.
constexpr double nothing = 1e-150;

/// The contact with a sphere about `centre`; if the finger is at the centre, `side` is the normal.
Contact on_ball(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& finger,
                const Eigen::Vector3d& side) noexcept {
  const Eigen::Vector3d away = finger - centre;
  const double distance = away.norm();
  const Eigen::Vector3d normal = distance > nothing ? Eigen::Vector3d(away / distance) : side;
  return {centre + normal * radius,
          normal,
          radius - distance,
          {distance < radius ? 0 : -1, plain::numbers(centre + normal), true}};
}

/// The unit vector along `way`, or along `otherwise` if it has no length.
Eigen::Vector3d direction(const Eigen::Vector3d& way, const Eigen::Vector3d& otherwise) noexcept {
  const double length = way.norm();
  return length > nothing ? Eigen::Vector3d(way / length) : otherwise;
}

/// The part of a vector across the axis of a capsule or cylinder.
Eigen::Vector3d radial_part(const Eigen::Vector3d& way) noexcept {
  return {way.x(), way.y(), 0.0};
}

}  // namespace

SphereSurface::SphereSurface(double radius) : radius_(positive("radius", radius)) {}

Contact SphereSurface::contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept {
  // At the centre the finger keeps its side.
  return on_ball(Eigen::Vector3d::Zero(), radius_, finger,
                 direction(plain::vector(memory.finger), Eigen::Vector3d::UnitZ()));
}

CapsuleSurface::CapsuleSurface(double radius, double half_length)
    : radius_(positive("radius", radius)), half_length_(half_length) {
  if (!(half_length >= 0.0 && half_length <= 1e6))
    throw out_of_range("half_length", half_length, "m", ">= 0, up to 1e6");
}

Contact CapsuleSurface::contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept {
  const auto nearest_on_axis = [this](double z) {
    return Eigen::Vector3d(0.0, 0.0, std::clamp(z, -half_length_, half_length_));
  };
  const Eigen::Vector3d last = plain::vector(memory.finger);
  const bool is_end = std::fabs(finger.z()) >= half_length_;
  // On the axis the finger keeps its side; between the ends that is across the axis.
  const Eigen::Vector3d side =
      is_end ? direction(last - nearest_on_axis(last.z()), {0.0, 0.0, std::copysign(1.0, finger.z())})
             : direction(radial_part(last), Eigen::Vector3d::UnitX());
  return on_ball(nearest_on_axis(finger.z()), radius_, finger, side);
}

CylinderSurface::CylinderSurface(double radius, double half_length)
    : radius_(positive("radius", radius)), half_length_(positive("half_length", half_length)) {}

/// The face through which the segment enters the cylinder: 0 the side, 1 the upper end, 2 the lower; −1 if it does not
/// enter.
int CylinderSurface::entered(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept {
  int face = -1;
  double enter = 0.0;  // as fractions of the segment
  double leave = 1.0;
  for (const int end : {1, 2}) {
    const double side = end == 1 ? 1.0 : -1.0;
    const double before = side * from.z() - half_length_;  // > 0: beyond the end
    const double now = side * to.z() - half_length_;
    if (before >= 0.0 && now >= 0.0) return -1;
    if (before >= 0.0) {
      face = end;
      enter = before / (before - now);
    } else if (now >= 0.0) {
      leave = std::min(leave, before / (before - now));
    }
  }
  // |from + t·way|² = R² across the axis.
  const Eigen::Vector3d way = radial_part(to - from);
  const double a = way.squaredNorm();
  const double b = way.dot(radial_part(from));
  const double c = radial_part(from).squaredNorm() - radius_ * radius_;
  const double discriminant = b * b - a * c;
  if (c >= 0.0) {
    if (!(b < 0.0 && discriminant > 0.0)) return -1;
    const double when = c / (std::sqrt(discriminant) - b);
    if (when > 1.0) return -1;
    if (face < 0 || when > enter) face = 0;
    enter = std::max(enter, when);
  }
  if (a > 0.0) leave = std::min(leave, (std::sqrt(discriminant) - b) / a);
  return enter <= leave ? face : -1;
}

Contact CylinderSurface::contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept {
  const Eigen::Vector3d last = plain::vector(memory.finger);
  const double distance = radial_part(finger).norm();
  const double beyond_side = distance - radius_;
  const double beyond_end = std::fabs(finger.z()) - half_length_;
  // On the axis the finger keeps its side.
  const Eigen::Vector3d radial = direction(radial_part(finger), direction(radial_part(last), Eigen::Vector3d::UnitX()));
  const Eigen::Vector3d axial = {0.0, 0.0, finger.z() >= 0.0 ? 1.0 : -1.0};

  // The finger stays on the face of the last step as long as it is beneath it.
  const auto is_beneath = [&](int face) {
    if (face == 0) return beyond_side < 0.0 && beyond_end <= 0.0;
    return (face == 2 ? -finger.z() : finger.z()) < half_length_ && beyond_side <= 0.0;
  };
  int face = memory.face;
  if (face >= 0 && !is_beneath(face)) face = -1;
  if (memory.face < 0 && memory.known) {
    face = entered(last, finger);
    // It left through another face: the finger has passed the rim.
    if (face >= 0 && !is_beneath(face)) face = -1;
  }
  if (face < 0 && beyond_side < 0.0 && beyond_end < 0.0)
    face = beyond_side > beyond_end ? 0 : finger.z() >= 0.0 ? 1 : 2;
  ContactMemory next{face, plain::numbers(finger), true};
  if (face == 0) {
    if (!(distance > nothing)) next.finger = plain::numbers(radial + Eigen::Vector3d(0.0, 0.0, finger.z()));
    return {radial * radius_ + Eigen::Vector3d(0.0, 0.0, finger.z()), radial, -beyond_side, next};
  }
  if (face > 0) {
    const double side = face == 1 ? 1.0 : -1.0;
    return {{finger.x(), finger.y(), side * half_length_}, {0.0, 0.0, side}, half_length_ - side * finger.z(), next};
  }
  // Outside: the nearest point, with the normal from it to the finger.
  const Eigen::Vector3d nearest =
      radial * std::min(distance, radius_) + axial * std::min(std::fabs(finger.z()), half_length_);
  const Eigen::Vector3d way = finger - nearest;
  return {nearest, direction(way, beyond_side >= beyond_end ? radial : axial), -way.norm(), next};
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

/// The face through which the segment enters the box; −1 if it does not touch it.
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

Contact BoxSurface::contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept {
  // The normal of face 2·axis is +axis, of face 2·axis + 1 it is −axis.
  const auto depth_under = [&](int face) {
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    return half_edges_[face / 2] - side * finger[face / 2];
  };
  int face = memory.face;
  if (face >= 0 && (depth_under(face) <= 0.0 || beside(finger, face / 2))) face = -1;
  const bool inside = (finger.cwiseAbs() - half_edges_).maxCoeff() < 0.0;
  if (face < 0 && memory.face < 0 && memory.known) {
    face = crossed(plain::vector(memory.finger), finger);
    // It left through another side: the finger has passed a corner.
    if (face >= 0 && beside(finger, face / 2)) face = -1;
  }
  if (face < 0 && inside) face = nearest_face(finger);
  const ContactMemory next{face, plain::numbers(finger), true};
  if (face >= 0) {
    const int axis = face / 2;
    const double side = face % 2 == 0 ? 1.0 : -1.0;
    Contact contact{finger, Eigen::Vector3d::Zero(), depth_under(face), next};
    contact.point[axis] = side * half_edges_[axis];
    contact.normal[axis] = side;
    return contact;
  }
  const Eigen::Vector3d nearest = finger.cwiseMax(-half_edges_).cwiseMin(half_edges_);
  const Eigen::Vector3d way = finger - nearest;
  const double gap = way.norm();
  if (gap > nothing) return {nearest, way / gap, -gap, next};
  // Exactly on the surface.
  const int on = nearest_face(finger);
  Contact contact{nearest, Eigen::Vector3d::Zero(), 0.0, next};
  contact.normal[on / 2] = on % 2 == 0 ? 1.0 : -1.0;
  return contact;
}

}  // namespace limitcurve::godobject
