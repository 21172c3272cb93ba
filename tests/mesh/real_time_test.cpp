// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh.hpp"
#include "tests/mesh/shapes.hpp"
#include "tests/real_time_guard.hpp"
#include "tests/touch.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

/// Where a finger is that goes about the star: near it, through it, far away, at its vertices.
std::vector<Vector3d> moves(const Mesh& mesh, int count) {
  Random random(9);
  std::vector<Vector3d> result;
  Vector3d finger(0.1, 0.0, 0.0);
  for (int i = 0; i < count; ++i) {
    finger += 0.01 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (i % 50 == 0) finger = mesh.vertices()[static_cast<std::size_t>(random.bits() % mesh.vertices().size())];
    if (i % 77 == 0) finger *= -1.0;
    if (finger.norm() > 0.15) finger *= 0.1;
    result.push_back(finger);
    if (i % 111 == 0) result.push_back(1e7 * finger);
    if (i % 112 == 0) result.push_back(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    if (i % 113 == 0) result.push_back(Vector3d::Constant(-std::numeric_limits<double>::max()));
  }
  return result;
}

#ifdef LIMITCURVE_GUARDS_REAL_TIME
using limitcurve::test::allocations_and_locks;
using limitcurve::test::runs_without_system_calls;

TEST(MeshRealTime, AStepNeitherAllocatesNorLocks) {
  const MeshSurface star = read_mesh(data_mesh("star.obj"));
  const std::vector<Vector3d> path = moves(star.mesh(), 20000);
  SoftFinger finger = hertz_finger();
  ContactMemory memory;
  int touching = 0;
  const int count = allocations_and_locks([&] {
    for (const Vector3d& place : path) {
      const FingerOutput output = finger.update(touch(star, place, memory), 0.0);
      touching += output.state == ContactState::slip || output.state == ContactState::stick;
    }
    const MeshSurface shared = star;
    static_cast<void>(touch(shared, path[0], memory));
  });
  EXPECT_EQ(count, 0);
  EXPECT_GT(touching, 2000);
}

TEST(MeshRealTime, StepsMakeNoSystemCall) {
  EXPECT_FALSE(runs_without_system_calls([] { syscall(SYS_getppid); }));
  const MeshSurface star = read_mesh(data_mesh("star.obj"));
  const std::vector<Vector3d> path = moves(star.mesh(), 100000);
  SoftFinger finger = hertz_finger();
  EXPECT_TRUE(runs_without_system_calls([&] {
    ContactMemory memory;
    for (const Vector3d& place : path) finger.update(touch(star, place, memory), 0.0);
  }));
}
#endif

// Four threads, a finger each, one mesh: each gets the same bits as alone.
TEST(MeshRealTime, FingersOfFourThreadsShareAMesh) {
  const MeshSurface star = read_mesh(data_mesh("star.obj"));
  const std::vector<Vector3d> path = moves(star.mesh(), 20000);
  const auto felt = [&] {
    const MeshSurface own = star;
    ContactMemory memory;
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& place : path) {
      const Contact contact = touch(own, place, memory);
      if (contact.depth > 0.0) sum += contact.depth * contact.normal;
    }
    return sum;
  };
  const Vector3d alone = felt();
  std::array<Vector3d, 4> together;
  std::vector<std::thread> threads;
  for (Vector3d& one : together) threads.emplace_back([&] { one = felt(); });
  for (std::thread& thread : threads) thread.join();
  for (const Vector3d& one : together) EXPECT_TRUE(same_bits(one, alone));
}

TEST(MeshRealTime, NothingInTheLoopThrows) {
  static_assert(noexcept(std::declval<const MeshSurface&>().contact(std::declval<const Vector3d&>(), std::declval<ContactMemory&>())));
  static_assert(noexcept(std::declval<const Mesh&>().settle(0, std::declval<const Vector3d&>(), std::declval<const Vector3d&>())));
}

}  // namespace
}  // namespace limitcurve::godobject::test
