// SPDX-License-Identifier: MIT
#pragma once

#include "../contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace limitcurve::godobject {

/// Makes a single contact of all walls that a finger is in, for example two faces of a groove. The contacts must have
/// the same frame and finger position x = point − normal·depth. If you pass only the deepest wall, noise of the device
/// exchanges the walls, so the friction along the groove fades.
///
/// The surface point becomes the point nearest to x outside of all walls, the normal points from x to it, and the depth
/// is their distance, at most √3 times the deepest. At most three walls act. If two of them meet at less than 90° (0.6°
/// less counts as 90°), or if no point is outside of all, the result is the deepest contact. The result is that
/// contact, bit for bit, also if leaving that wall leaves all, so of two coplanar walls only the deeper counts.
/// `landed` is set if any contact has `landed`; `memory` is from the deepest contact. An empty range gives a contact
/// without depth and normal, in which a finger is free (`SoftFinger::update`). A wall of depth ≤ 0 needs no normal. Any
/// other contact that no finger accepts is returned, so that the finger can name the fault.
///
/// If the tip is round, you must pass contacts of the tip's centre: move each point outward by the radius, and keep
/// normal and depth. Otherwise x differs from wall to wall, and the springs pull the tip into the corner. Costs some 10
/// ns per contact, if there are few.
template <std::ranges::forward_range Contacts>
[[nodiscard]] Contact join(const Contacts& contacts) noexcept {
  if (contacts.begin() == contacts.end()) return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0};
  const auto normal_of = [](const Contact& wall) {
    Eigen::Vector3d normal = wall.normal;
    make_unit(normal);  // as a finger takes it: the depth is a length
    return normal;
  };
  Contact deepest = *contacts.begin();
  bool landed = false;
  for (const Contact& wall : contacts) {
    Eigen::Vector3d normal = wall.normal;
    const bool is_free = wall.depth <= 0.0 && std::isfinite(wall.depth);
    if (!is_free && !(make_unit(normal) && is_plausible<double>(wall.point.squaredNorm() + wall.depth * wall.depth)))
      return wall;
    landed = landed || wall.landed;
    if (wall.depth > deepest.depth) deepest = wall;
  }
  deepest.landed = landed;
  const double most = deepest.depth;
  Eigen::Vector3d way;  // from x
  const auto leave = [&](const Contact& wall) {
    const Eigen::Vector3d normal = normal_of(wall);
    way = normal * (wall.depth / normal.squaredNorm());
  };
  const auto missing = [&](const Contact& at) { return at.depth > 0.0 ? at.depth - normal_of(at).dot(way) : -most; };
  const auto is_inside = [&](const Contact& wall) { return missing(wall) > 1e-9 * most; };
  // Walls of one direction have no edge, and no point on all of them.
  const auto ratio = [](double length, double slope) {
    return slope != 0.0 ? length / slope : std::numeric_limits<double>::quiet_NaN();
  };
  leave(deepest);
  if (!(most > 0.0) || std::none_of(contacts.begin(), contacts.end(), is_inside)) return deepest;
  // One wall after the other: if x + way is inside of it, the nearest point is on it. Among the walls before it search
  // there in the same way, first in the plane, then on the edge of two.
  way.setZero();
  for (auto i = contacts.begin(); i != contacts.end(); ++i) {
    if (!is_inside(*i)) continue;
    leave(*i);
    for (auto j = contacts.begin(); j != i; ++j) {
      if (!is_inside(*j)) continue;
      leave(*i);
      const Eigen::Vector3d edge = normal_of(*i).cross(normal_of(*j));
      const Eigen::Vector3d across = edge.cross(normal_of(*i));
      way += across * ratio(missing(*j), across.dot(normal_of(*j)));
      for (auto k = contacts.begin(); k != j; ++k)
        if (is_inside(*k)) way += edge * ratio(missing(*k), edge.dot(normal_of(*k)));
    }
  }
  for (const Contact& a : contacts)
    for (const Contact& b : contacts)
      if (!(missing(a) <= 1e-6 * most &&
            (missing(b) < -1e-6 * most || missing(a) < -1e-6 * most || normal_of(a).dot(normal_of(b)) >= -0.01)))
        return deepest;
  return {deepest.point - normal_of(deepest) * most + way, way.normalized(), way.norm(), deepest.memory, landed};
}

}  // namespace limitcurve::godobject
