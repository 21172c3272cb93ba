// SPDX-License-Identifier: MIT
// What a servo loop must not do: make its mesh in the step. check_reachable.cmake has to find it.
#include "godobject/mesh/mesh_surface.hpp"

using namespace limitcurve::godobject;

extern "C" double servo_step(const TriangleList& triangles, const Eigen::Vector3d& place, ContactMemory& memory) {
  const MeshSurface surface{Mesh(triangles)};
  return surface.contact(place, memory).depth;
}
