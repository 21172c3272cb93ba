// SPDX-License-Identifier: MIT
#include "godobject/body/grasp.hpp"
#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "tests/mesh/shapes.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

const Vector3d edges{0.12, 0.04, 0.04};

template <class Shape>
Grasp hold(const Shape& shape, const BodyParameters& body, const std::array<DevicePose, 2>& devices) {
  FingerParameters with = parameters(1.67, 0.01, 1000.0, 0.0366);
  with.damping = 10.0;
  with.twist_damping = 0.001;
  const SoftFinger finger = hertz_finger(with);
  Grasp grasp(body, BodyState{}, AnySurface(shape), {finger, finger});
  grasp.place(BodyState{}, devices);
  return grasp;
}

/// Two opposite fingers, 2 mm deep, on the block's faces ±z, beside its centre of mass.
const std::array<DevicePose, 2> pinch{DevicePose{{0.005, 0.0, 0.018}}, DevicePose{{0.005, 0.0, -0.018}}};

// Ten minutes of a block at rest between two fingers: 600,000 steps, and so a test of seconds (in a short build six seconds at rest).
// The fingers touch where two triangles of a face meet, because the diagonals of block.obj run through the middle.
TEST(MeshGrasp, RestsForTenMinutesWithoutCreeping) {
  for (const double beside : {0.005, 0.0}) {
    auto devices = pinch;
    for (DevicePose& device : devices) device.position.x() = beside;
    auto grasp = hold(read_mesh(data_mesh("block.obj")), BodyParameters::planar_block(0.1, edges, 9.81), devices);
    const std::array<Vector3d, 2> proxies{grasp.finger(0).output().proxy, grasp.finger(1).output().proxy};
    const std::array<double, 2> angles{grasp.finger(0).output().angle, grasp.finger(1).output().angle};
    for (int i = 0; i < 5000; ++i) grasp.step(devices, 1e-3);
    const BodyState settled = grasp.body();
    const int steps = beside == 0.005 ? repetitions(600'000) : repetitions(20'000, 5'000);
    for (int i = 0; i < steps; ++i) {
      grasp.step(devices, 1e-3);
      for (std::size_t finger : {0U, 1U}) {
        ASSERT_TRUE(same_bits(grasp.finger(finger).output().proxy, proxies[finger]) &&
                    grasp.finger(finger).output().angle == angles[finger]);
      }
      ASSERT_LT((grasp.body().position - settled.position).norm(), 1e-12);
    }
    EXPECT_LT(grasp.body().orientation.angularDistance(settled.orientation), 1e-12);
    EXPECT_EQ(grasp.finger(0).output().state, ContactState::stick);
    EXPECT_EQ(grasp.unsolved(), 0U);
    // Held above its centre of mass it hangs at the static deflection of the springs.
    if (beside == 0.0) {
      EXPECT_NEAR(settled.position.y(), -0.1 * 9.81 / 2000.0, 1e-9);
    }
  }
}

// Where a finger passes from face to face, the normal at the end of the step acts on the whole of it: the energy rises, by no more than the
// load times the way and the change of the normal, beside what the turn of the step may add (godobject/README.md, "Bodies").
TEST(MeshGrasp, ARidgeAddsNoMoreThanItsBound) {
  Random random(6);
  double largest = 0.0;
  for (int round = 0; round < repetitions(240, 12); ++round) {
    BodyParameters body = BodyParameters::block(0.1, {0.06, 0.04, 0.04});
    body.gravity.setZero();
    if (round % 2 == 0) body.free = {true, true, false, false, false, true};
    const AnySurface ball{MeshSurface(Mesh(ball_triangles(0.02, 1 + round % 3)))};
    const double stiffness = 1000.0;
    const SoftFinger finger = hertz_finger(parameters(round / 6 % 4 == 3 ? 0.6 : 0.0, 0.005, stiffness));
    Grasp grasp(body, BodyState{}, ball, {finger, finger});
    const auto any = [&](double size) {
      return Vector3d(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    const Vector3d at = (0.017 - random.uniform(0.0005, 0.004)) * any(1.0).normalized();
    const std::array<DevicePose, 2> devices{DevicePose{at}, DevicePose{-at}};
    BodyState knocked;
    knocked.velocity = any(0.3);
    knocked.angular_velocity = any(5.0);
    if (round % 2 == 0) {
      knocked.velocity.z() = 0.0;
      knocked.angular_velocity.head<2>().setZero();
    }
    grasp.place(knocked, devices);
    const double first = grasp.energy();
    const double time_step = random.logarithmic(1e-5, 3e-3);
    for (int i = 0; i < 300; ++i) {
      const Grasp before = grasp;
      grasp.step(devices, time_step);
      const double turned = std::max(before.body().angular_velocity.norm(), grasp.body().angular_velocity.norm()) * time_step;
      double moments = first;
      double ridge = 0.0;
      for (std::size_t k = 0; k < 2; ++k) {
        const FingerOutput& was = before.finger(k).output();
        const FingerOutput& now = grasp.finger(k).output();
        moments += grasp.force_on_user(k).norm() * now.proxy.norm() + std::fabs(now.moment);
        const double way = (before.body().to_body(devices[k].position) - grasp.body().to_body(devices[k].position)).norm();
        const double bend = (now.normal - was.normal).norm();
        ridge += (was.load + 0.5 * stiffness * way * bend) * way * bend;
      }
      const double rise = grasp.energy() - before.energy();
      ASSERT_LE(rise, 1e-12 * first + turned * turned * moments + ridge) << round << ' ' << i;
      largest = std::max(largest, rise / first);
    }
  }
  EXPECT_GT(largest, tests_are_short ? 0.0 : 1e-5) << "the energy does rise";
}

}  // namespace
}  // namespace limitcurve::godobject::test
