// SPDX-License-Identifier: MIT
// The servo loop's object code, and nothing else: what it leaves undefined is what it may call (see check_symbols.cmake).
#include "godobject/closest_point_projection.hpp"
#include "godobject/radial_projection.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/table.hpp"

using namespace limitcurve;
using namespace limitcurve::godobject;

double servo_step(SoftFinger<Ellipse, Radial>& finger, const Contact& contact, double twist) noexcept {
  return finger.update(contact, twist, 1e-3).moment;
}

double servo_step(SoftFinger<Table, ClosestPoint>& finger, const Contact& contact, double twist) noexcept {
  return finger.update(contact, twist, 1e-3).moment;
}

double servo_step(SoftFinger<Box, ClosestPoint>& finger, const Contact& contact, double twist) noexcept {
  return finger.update(contact, twist, 1e-3).moment;
}
