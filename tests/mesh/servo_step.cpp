// SPDX-License-Identifier: MIT
// A finger on a mesh in the servo loop, and nothing else: what it can reach is what it may call (see check_reachable.cmake).
#include "godobject/closest_point_projection.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/table.hpp"

using namespace limitcurve;
using namespace limitcurve::godobject;

/// The only way in from outside.
extern "C" double servo_step(const MeshSurface& surface, SoftFinger<Table, ClosestPoint>& finger, const Eigen::Vector3d& place,
                             double twist, ContactMemory& memory) noexcept {
  return finger.update(surface.contact(place, memory), twist, 1e-3).moment;
}
