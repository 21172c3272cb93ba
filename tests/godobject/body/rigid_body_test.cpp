// SPDX-License-Identifier: MIT
#include "godobject/body/rigid_body.hpp"
#include "godobject/surfaces/surfaces.hpp"

#include "godobject/body/grasp.hpp"

#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

TEST(RigidBody, TwistIsUnwrappedOverManyTurns) {
  // A device that turns by 40 turns about the normal of a plane, given as an orientation.
  const AnySurface plane(PlaneSurface{});
  SoftFinger finger = hertz_finger();
  for (int i = 0; i <= 40 * 628; ++i) {
    const double angle = 0.01 * i;
    Quaterniond orientation(AngleAxisd(angle, Vector3d::UnitZ()));
    if (i % 3 == 1) orientation.coeffs() *= -1.0;  // the same orientation
    finger.update(plane, {{0.0, 0.0, -0.002}, orientation});
    ASSERT_NEAR(finger.state().sample.angle, angle, 1e-9);
  }
}

/// Euler's equations of a free body by Runge–Kutta steps of fourth order: orientation after `time`.
Quaterniond tumbled(const Vector3d& inertia, const Vector3d& rate, double time, int steps) {
  Eigen::Matrix<double, 7, 1> state;
  state << 1.0, 0.0, 0.0, 0.0, rate;
  const auto slope = [&](const Eigen::Matrix<double, 7, 1>& at) {
    const Quaterniond q(at[0], at[1], at[2], at[3]);
    const Vector3d w = at.tail<3>();
    const Quaterniond turn = q * Quaterniond(0.0, w.x(), w.y(), w.z());
    Eigen::Matrix<double, 7, 1> result;
    result << 0.5 * turn.w(), 0.5 * turn.vec(), inertia.cwiseProduct(w).cross(w).cwiseQuotient(inertia);
    return result;
  };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const auto a = slope(state);
    const auto b = slope(state + 0.5 * h * a);
    const auto c = slope(state + 0.5 * h * b);
    const auto d = slope(state + h * c);
    state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return Quaterniond(state[0], state[1], state[2], state[3]).normalized();
}

TEST(RigidBody, FallsAndSpinsFreely) {
  const Vector3d edges(0.12, 0.04, 0.04);
  const BodyParameters body = BodyParameters::block(0.3, edges);
  Grasp grasp(body, BodyState{}, AnySurface(BoxSurface(0.5 * edges)), {});
  BodyState start;
  start.velocity = {1.0, -2.0, 0.5};
  start.angular_velocity = {3.0, -1.0, 20.0};
  grasp.place(start, {});
  const Vector3d momentum = angular_momentum(body, grasp.body());
  const double step = 1e-4;
  for (int i = 1; i <= 10000; ++i) grasp.step({}, step);
  EXPECT_NEAR(grasp.body().velocity.z(), 0.5 - 9.81, 1e-9);
  // Implicit Euler's fall is ½gtΔt too far.
  EXPECT_NEAR(grasp.body().position.z(), 0.5 - 0.5 * 9.81 * (1.0 + step), 1e-9);
  EXPECT_NEAR(grasp.body().position.x(), 1.0, 1e-12);
  // Angular momentum is kept exactly, by construction.
  EXPECT_LT((angular_momentum(body, grasp.body()) - momentum).norm(), 1e-12 * momentum.norm());
  EXPECT_NEAR(grasp.body().orientation.norm(), 1.0, 1e-15);
}

// A block thrown about its middle axis, which is unstable: energy and momentum stay, and where it turns to is right to
// second order.
TEST(RigidBody, TumblesWithoutLoss) {
  BodyParameters body = BodyParameters::block(0.1, {0.12, 0.06, 0.03});
  body.gravity.setZero();
  BodyState thrown;
  thrown.angular_velocity = {1.0, 50.0, 2.0};
  const Quaterniond expected = tumbled(body.inertia, thrown.angular_velocity, 1.0, 20000);
  const double energy = kinetic_energy(body, thrown);
  const Vector3d momentum = angular_momentum(body, thrown);
  std::array<double, 2> errors{};
  for (const int part : {1, 4}) {
    Grasp grasp(body, thrown, AnySurface(PlaneSurface{}), {});
    for (int i = 0; i < 1000 * part; ++i) {
      grasp.step({}, 1e-3 / part);
      ASSERT_NEAR(kinetic_energy(body, grasp.body()), energy, 1e-9 * energy) << i;
      ASSERT_LT((angular_momentum(body, grasp.body()) - momentum).norm(), 1e-9 * momentum.norm()) << i;
    }
    EXPECT_EQ(grasp.unsolved(), 0U);
    errors[part == 1 ? 0 : 1] = Quaterniond(grasp.body().orientation).angularDistance(expected);
  }
  EXPECT_LT(errors[1], 0.02);
  EXPECT_NEAR(errors[1], errors[0] / 16.0, 0.1 * errors[0] / 16.0);
}

// A spin of several turns in a step, about the axis of the largest inertia, is done in parts: it arrives where it
// should, and does not look like a slow turn the other way.
TEST(RigidBody, SpinsByTurnsInAStep) {
  BodyParameters body = BodyParameters::block(0.1, {0.12, 0.06, 0.03});
  body.gravity.setZero();
  BodyState spinning;
  spinning.angular_velocity = {0.0, 0.0, 300.0};
  Grasp grasp(body, spinning, AnySurface(PlaneSurface{}), {});
  for (int i = 1; i <= 5; ++i) {
    grasp.step({}, 0.05);
    const Quaterniond expected(AngleAxisd(15.0 * i, Vector3d::UnitZ()));
    // The angle of a part is right to third order, which is 0.01 here.
    ASSERT_LT(Quaterniond(grasp.body().orientation).angularDistance(expected), 0.09 * i);
    ASSERT_LT((grasp.body().angular_velocity - spinning.angular_velocity).norm(), 1e-9);
  }
  EXPECT_EQ(grasp.divided(), 5U);
  EXPECT_EQ(grasp.unsolved(), 0U);
}

/// Moments of inertia of an evenly filled solid per mass, by counting cells of a grid: nothing but its outline.
template <class Inside>
Vector3d counted_inertia(const Vector3d& half_edges, const Inside& inside) {
  constexpr int cells = repetitions(120, 30);
  Vector3d sum = Vector3d::Zero();
  double count = 0.0;
  for (int i = 0; i < cells * cells * cells; ++i) {
    const Vector3d place(i % cells, i / cells % cells, i / cells / cells);
    const Vector3d at = ((2.0 * place + Vector3d::Ones()) / cells - Vector3d::Ones()).cwiseProduct(half_edges);
    if (!inside(at)) continue;
    const Vector3d squares = at.cwiseProduct(at);
    sum += Vector3d::Constant(squares.sum()) - squares;
    count += 1.0;
  }
  return sum / count;
}

TEST(BodyParameters, EvenlyFilledBodiesHaveTheInertiaOfTheirOutline) {
  const double r = 0.02;
  const double length = 0.07;
  const auto is_near = [](const BodyParameters& body, const Vector3d& expected) {
    // What the cells of a short build do not resolve is ten times as much.
    constexpr double resolved = tests_are_short ? 2e-2 : 2e-3;
    EXPECT_LT((body.inertia / body.mass - expected).norm(), resolved * expected.norm()) << body.inertia.transpose();
  };
  const Vector3d slim{r, r, 0.5 * length};
  is_near(BodyParameters::ball(0.3, r),
          counted_inertia(Vector3d::Constant(r), [&](const Vector3d& at) { return at.norm() <= r; }));
  is_near(BodyParameters::cylinder(0.3, r, length),
          counted_inertia(slim, [&](const Vector3d& at) { return at.head<2>().norm() <= r; }));
  is_near(BodyParameters::capsule(0.3, r, length),
          counted_inertia(slim + Vector3d(0.0, 0.0, r), [&](const Vector3d& at) {
            return (at - Vector3d(0.0, 0.0, std::clamp(at.z(), -0.5 * length, 0.5 * length))).norm() <= r;
          }));
  is_near(BodyParameters::block(0.3, 2.0 * slim), counted_inertia(slim, [](const Vector3d&) { return true; }));
  EXPECT_THROW((void)BodyParameters::ball(0.1, 0.0), std::invalid_argument);
  EXPECT_THROW((void)BodyParameters::cylinder(0.1, 0.1, 0.0), std::invalid_argument);
  EXPECT_THROW((void)BodyParameters::capsule(-0.1, 0.1, 0.0), std::invalid_argument);
}

TEST(BodyParameters, AndShapesOfNoSizeAreRefused) {
  EXPECT_THROW((void)BodyParameters::block(0.0, {0.12, 0.04, 0.04}), std::invalid_argument);
  EXPECT_THROW((void)BodyParameters::block(0.1, {0.1, -0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(SphereSurface(0.0), std::invalid_argument);
  EXPECT_THROW(BoxSurface({0.1, 0.1, nan}), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::godobject::test
