// SPDX-License-Identifier: MIT
// A finger pressed 3 mm through a plate of 1 mm is pushed back to the side it came from.
#include "godobject/godobject.hpp"
#include "godobject/mesh/mesh_file.hpp"
#include "limitcurve/limitcurve.hpp"

#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace limitcurve;
  if (argc != 2) return 2;
  const godobject::AnySurface plate(godobject::MeshSurface(godobject::read_mesh(argv[1])));
  const godobject::FingerParameters skin{.mu = 0.5, .stiffness = 1000.0, .twist_stiffness = 0.04};
  godobject::SoftFinger finger(Ellipse::through_intercepts(hertz()->moment_ratio()), skin);
  for (const double z : {0.002, 0.0, -0.0025}) finger.update(plate, {.position = {0.0, 0.0, z}});
  std::printf("load %.12g N, expected 3 N\n", finger.output().load);
  return std::abs(finger.output().load - 3.0) < 1e-9 ? 0 : 1;
}
