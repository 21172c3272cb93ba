// SPDX-License-Identifier: MIT
// Walls touched at once: the contact that `join` makes of them, and what a finger then feels in grooves, at seams
// (180°) and with a round tip, with numbers as devices and engines give them.
#include "godobject/surfaces/join.hpp"
#include "tests/godobject/random_scene.hpp"

#include <Eigen/Dense>

namespace limitcurve::godobject::test::join_test {
namespace {

Vector3d in_single_precision(const Vector3d& v) {
  return v.cast<float>().cast<double>();
}

/// A finger at x in a wall of this depth.
Contact wall(const Vector3d& x, const Vector3d& normal, double depth) {
  return {x + normal * depth, normal, depth};
}

/// The reference: of the points nearest to x on every one, two and three walls, the nearest outside of all.
std::optional<Vector3d> nearest_outside(const std::vector<Contact>& walls) {
  std::optional<Vector3d> best;
  const std::size_t n = walls.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j)
      for (std::size_t k = j; k < n; ++k) {
        Eigen::Matrix3d normals;
        normals << walls[i].normal.transpose(), walls[j].normal.transpose(), walls[k].normal.transpose();
        const Vector3d depths(walls[i].depth, walls[j].depth, walls[k].depth);
        const Vector3d way = normals.completeOrthogonalDecomposition().solve(depths);
        bool is_outside = true;
        for (const Contact& each : walls) is_outside = is_outside && each.normal.dot(way) >= each.depth * (1.0 - 2e-9);
        if (is_outside && (!best || way.norm() < best->norm())) best = way;
      }
  return best;
}

TEST(Join, IsTheNearestPointOutsideAllWalls) {
  Random random(3);
  int joined = 0;
  for (int round = 0; round < 20'000; ++round) {
    const Vector3d x = random.vector(0.1);
    const bool is_rounded = random.below(2) == 0;
    std::vector<Contact> walls;
    const std::size_t count = 1 + random.below(6);
    while (walls.size() < count) {
      Vector3d normal = random.below(3) == 0 ? Vector3d(Vector3d::Unit(static_cast<Eigen::Index>(random.below(3))))
                        : !walls.empty() && random.below(4) == 0  // the next triangle of a wall
                            ? (walls.back().normal + random.vector(random.logarithmic(1e-16, 1e-3))).normalized()
                            : random_direction(random);
      if (is_rounded) normal = in_single_precision(normal);
      walls.push_back(wall(x, normal, random.below(4) == 0 ? 0.002 : random.uniform(-0.001, 0.003)));
    }
    const Contact result = join(walls);
    const Contact* deepest = &walls[0];
    double least_cosine = 1.0;
    std::vector<Contact> touched;
    for (const Contact& each : walls) {
      if (each.depth > deepest->depth) deepest = &each;
      if (each.depth <= 0.0) continue;
      for (const Contact& other : touched) least_cosine = std::min(least_cosine, each.normal.dot(other.normal));
      touched.push_back(each);
    }
    SCOPED_TRACE(round);
    ASSERT_LT((result.point - result.normal * result.depth - x).norm(), 1e-9);
    if (same_bits(result.point, deepest->point) && (touched.empty() || least_cosine < -0.01)) continue;
    const std::optional<Vector3d> way = nearest_outside(touched);
    ASSERT_TRUE(way);
    ASSERT_LT((result.point - x - *way).norm(), 1e-4 * way->norm());
    ASSERT_LE(result.depth, 1.02 * std::sqrt(3.0) * deepest->depth);
    joined += result.depth > 1.001 * deepest->depth;
  }
  EXPECT_GT(joined, 500);
}

TEST(Join, KeepsTheDeepestWhereWallsFaceEachOtherAndWhatIsMarked) {
  const Vector3d x(0.01, 0.02, 0.03);
  std::vector<Contact> walls{wall(x, Vector3d::UnitX(), 0.001), wall(x, -Vector3d::UnitX(), 0.002),
                             wall(x, {0.0, 0.6, 0.8}, 0.0015)};
  walls[0].landed = true;
  walls[1].memory.face = 5;
  const Contact slot = join(walls);
  EXPECT_TRUE(same_bits(slot.point, walls[1].point) && same_bits(slot.normal, walls[1].normal) && slot.landed);
  EXPECT_EQ(slot.memory.face, 5);
  const auto groove = [&](double degrees) {  // the normals of its walls: 180° less
    const double turn = std::numbers::pi * (1.0 - degrees / 180.0);
    return join(std::array{wall(x, Vector3d::UnitZ(), 0.002), wall(x, {std::sin(turn), 0.0, std::cos(turn)}, 0.002)})
               .depth /
           0.002;
  };
  EXPECT_NEAR(groove(180.0), 1.0, 1e-15);
  EXPECT_NEAR(groove(120.0), 2.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(groove(90.0), std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(groove(89.9), 1.0 / std::sin(89.9 * std::numbers::pi / 360.0), 1e-12) << "as rounded normals have it";
  EXPECT_EQ(groove(80.0), 1.0);
  EXPECT_EQ(groove(0.0), 1.0);
  // Normals as engines round them are unit vectors, and the depth is a length: as a finger takes both.
  for (const double length : {0.9901, 0.991, 1.009, 1.00998}) {
    std::array pair{wall(x, Vector3d::UnitZ(), 0.001), wall(x, Vector3d::UnitX(), 0.001)};
    pair[0].normal *= length;
    EXPECT_NEAR(join(pair).depth, 0.001 * std::numbers::sqrt2, 1e-15) << length;
    pair[1].normal *= length;
    EXPECT_NEAR(join(pair).depth, 0.001 * std::numbers::sqrt2, 1e-15) << length;
    EXPECT_LT((join(pair).point - x - Vector3d(0.001, 0.0, 0.001)).norm(), 1e-15) << length;
  }
  // A wall that the finger is not in need not have a normal, and does not free it.
  for (const double length : {0.0, 1.00998, 2.0})
    EXPECT_EQ(join(std::array{wall(x, length * Vector3d::UnitX(), -0.005), walls[1]}).depth, 0.002);
  FingerParameters guarded = parameters();
  guarded.max_speed = FingerParameters().max_speed;
  SoftFinger freed = hertz_finger(guarded);
  for (const Vector3d& at : {x, Vector3d(x + Vector3d::UnitX())}) {  // where it comes down, too
    freed.update(join(std::array{wall(at, Vector3d::UnitZ(), 0.002)}), 0.0, 1e-3);
    ASSERT_EQ(freed.output().load, 2.0);
    for (int i = 0; i < 300; ++i)
      ASSERT_EQ(freed.update(join(std::vector<Contact>()), 0.0, 1e-3).state, ContactState::free);
  }
  // What no finger accepts is not hidden behind a good wall.
  for (const Contact& bad : {wall(x, {0.0, 0.0, 2.0}, 0.001), wall(x, Vector3d::UnitY(), nan),
                             wall(Vector3d::Constant(infinity), Vector3d::UnitY(), 0.001)}) {
    SoftFinger finger = hertz_finger();
    EXPECT_EQ(finger.update(join(std::array{walls[1], bad}), 0.0, 1e-3).state, ContactState::invalid);
  }
}

/// What is left of the friction [N] along y after a finger, `depth` in each wall, was dragged 5 mm and held for a
/// second by a device with noise [m].
double left_in_groove(double degrees, double mu, double depth, double noise) {
  const double half = degrees * std::numbers::pi / 360.0;
  const Vector3d left(std::cos(half), 0.0, std::sin(half));
  const Vector3d right(-std::cos(half), 0.0, std::sin(half));
  SoftFinger finger = exact_hertz_finger(parameters(mu));
  Random random(7);
  double sum = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d x = Vector3d(0.0, -1e-5 * std::min(i, 500), -depth / std::sin(half)) + random.vector(noise);
    const Contact contact = join(std::array{wall(x, left, -left.dot(x)), wall(x, right, -right.dot(x))});
    const FingerOutput output = finger.update(contact, 0.0, 1e-3);
    EXPECT_NEAR(output.load, 1000.0 * depth / std::sin(half), 5000.0 * noise + 1e-12);
    if (i >= 1000) sum += output.force.y();
  }
  return sum / 1000;
}

TEST(Join, AlongAGrooveAsMuchFrictionIsLeftAsOnAPlane) {
  for (const double mu : {0.3, 0.6, 1.0}) {
    for (const double noise : {0.0, 1e-9, 1e-7, 1e-6, 1e-5}) {
      const double plane = left_in_groove(180.0, mu, 0.002, noise);
      EXPECT_GT(std::fabs(plane), 0.7 * mu * 2.0);
      for (const double degrees : {90.0, 91.0, 100.0, 120.0, 150.0, 170.0, 178.0, 179.9})
        EXPECT_GE(left_in_groove(degrees, mu, 0.002, noise) / plane, 0.97) << mu << ' ' << noise << ' ' << degrees;
    }
  }
}

// A ball of 5 mm slides along a floor into a wall and rests there: contacts as an engine gives them, moved to its
// centre. Both walls push, and no sample jumps.
TEST(Join, ACornerPushesARoundTipOut) {
  constexpr double radius = 0.005;
  for (const double degrees : {90.0, 91.0, 100.0, 120.0, 150.0}) {
    for (const double mu : {0.3, 0.6, 1.0}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      const std::array normals{Vector3d(0.0, 0.0, 1.0), Vector3d(-std::sin(angle), 0.0, -std::cos(angle))};
      SoftFinger finger = exact_hertz_finger(parameters(mu));
      Random random(9);
      Vector3d last = Vector3d::Zero();
      for (int i = 0; i < 3000; ++i) {
        // At rest 2 mm deep in the floor and 2.5 mm in the wall.
        const double along = (0.0025 + std::cos(angle) * 0.003) / -std::sin(angle) - 1e-5 * std::max(2000 - i, 0);
        const Vector3d centre = Vector3d(along, 0.0, 0.003) + random.vector(1e-6);
        std::vector<Contact> touched;
        for (const Vector3d& normal : normals) {
          const double distance = normal.dot(centre);
          if (distance >= radius) continue;
          const Vector3d foot = in_single_precision(centre - normal * distance);
          touched.push_back({foot + radius * normal, in_single_precision(normal), radius - distance});
        }
        const Vector3d force = finger.update(join(touched), 0.0, 1e-3).whole_force();
        for (const Contact& each : touched) ASSERT_GE(force.dot(each.normal), 0.0) << degrees << ' ' << mu << ' ' << i;
        ASSERT_LT((force - last).norm(), i == 0 ? 3.0 : 0.03) << degrees << ' ' << mu << ' ' << i;
        last = force;
      }
      EXPECT_NEAR(last.z(), 2.0, 0.1) << degrees << ' ' << mu;
      EXPECT_GT(last.dot(normals[1]), 2.4) << degrees << ' ' << mu;
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::join_test
