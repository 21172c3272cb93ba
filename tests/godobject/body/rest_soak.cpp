// SPDX-License-Identifier: MIT
// A block hangs in a two-finger grip: its proxies stay where they are in the block, bit for bit, and the block within 1e-12 m and
// rad of where it settled.
//     rest_soak [MINUTES]
// Simulated minutes, at 1 kHz. Exits with 1 if anything moves.
#include "tests/godobject/scene.hpp"

#include "godobject/body/grasp.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

int rest(double minutes) {
  const Vector3d edges{0.12, 0.04, 0.04};
  BodyParameters body = BodyParameters::block(0.1, edges);
  body.gravity = {0.0, -9.81, 0.0};
  FingerParameters with = parameters(1.67, 0.01, 1000.0, 0.0366);
  with.damping = 10.0;
  with.twist_damping = 1e-3;
  const SoftFinger finger(Table::build(hertz(), 1e-8), with);
  Grasp grasp(body, BodyState{}, AnySurface(BoxSurface(0.5 * edges)), {finger, finger});
  // 5 mm beside the centre of mass, so that force and moment carry the weight.
  const std::array devices{DevicePose{{0.005, 0.0, 0.018}}, DevicePose{{0.005, 0.0, -0.018}}};
  grasp.place(BodyState{}, devices);
  const std::array proxies{grasp.finger(0).output().proxy, grasp.finger(1).output().proxy};
  const std::array angles{grasp.finger(0).output().angle, grasp.finger(1).output().angle};
  for (int i = 0; i < 10'000; ++i) grasp.step(devices, 1e-3);
  const BodyState settled = grasp.body();
  double strayed = 0.0;
  double turned_by = 0.0;
  long moved = 0;
  const long steps = std::lround(60'000.0 * minutes);
  for (long i = 0; i < steps; ++i) {
    grasp.step(devices, 1e-3);
    strayed = std::max(strayed, (grasp.body().position - settled.position).norm());
    turned_by = std::max(turned_by, 2.0 * (grasp.body().orientation.coeffs() - settled.orientation.coeffs()).norm());
    for (std::size_t k = 0; k < 2; ++k) {
      const FingerOutput output = grasp.finger(k).output();
      moved += !same_bits(output.proxy, proxies[k]) || output.angle != angles[k] || output.state != ContactState::stick;
    }
  }
  std::printf("%ld steps (%g min): proxies moved in %ld, the block strayed by %.1e m and %.1e rad; unsolved %zu\n", steps, minutes, moved,
              strayed, turned_by, grasp.unsolved());
  return moved == 0 && strayed <= 1e-12 && turned_by <= 1e-12 ? 0 : 1;
}

}  // namespace
}  // namespace limitcurve::godobject::test

int main(int argc, char** argv) {
  return limitcurve::godobject::test::rest(argc > 1 ? std::strtod(argv[1], nullptr) : 10.0);
}
