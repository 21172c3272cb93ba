// SPDX-License-Identifier: MIT
// A patch that is fixed to the finger: what a yaw of the device's zero or of the body's frame, lifting and any path
// must not change, on every surface.
#include "tests/godobject/scene/metamorphic/metamorphic.hpp"

#include "limitcurve/patch/patch.hpp"

namespace limitcurve::godobject::test::metamorphic {
namespace {

constexpr double quarter = 1.5707963267948966;

/// Four times as rough along its x axis as across.
Patch grooved() {
  return Patch::rectangle(0.01, 0.01).orthotropic(1.0, 0.25);
}

Quaterniond about(const Vector3d& axis, double angle) {
  return Quaterniond(AngleAxisd(angle, axis));
}

/// The patch's x axis by its definition: the tangent part of the device's x axis, turned about the normal by α_p − α_g
/// and the added twist.
Vector3d defined_axis(const DevicePose& device, const Vector3d& normal, double angle) {
  const Vector3d x = device.orientation * Vector3d::UnitX();
  const Vector3d tangent = (x - normal * normal.dot(x)).normalized();
  return about(normal, angle) * tangent;
}

/// The friction force of a drag from a device's pose by 2 mm (or `far`) along `way`, divided by μP.
double dragged(SoftFinger finger, const AnySurface& surface, const DevicePose& from, const Vector3d& way,
               double far = 2e-3) {
  FingerOutput output;
  DevicePose device = from;
  for (int i = 0; i <= 200; ++i) {
    device.position = from.position + 0.005 * far * i * way;
    output = finger.update(surface, device);
  }
  EXPECT_EQ(to_string(output.state), "slip");
  return output.force.norm() / (finger.parameters().mu * finger.state().limit_load);
}

TEST(MetamorphicPatch, AxesAreTheFingersWhateverThePath) {
  int slips = 0;
  int compared = 0;
  const std::vector<std::pair<std::string, Patch>> patches{{"grooved", grooved()},
                                                           {"slim", Patch::ellipse(hertz(), 0.008, 0.002)}};
  for (const auto& [name, patch] : patches) {
    for (const NamedSurface& surface : all_surfaces()) {
      for (const double damping : {0.0, 1.0}) {
        SCOPED_TRACE(name + ", " + surface.name);
        Random random(51);
        FingerParameters with = parameters(0.6, 0.005, 1000.0, 0.04);
        with.damping = damping;
        with.mu_dynamic = 0.5;
        SoftFinger finger(patch, with);
        const RandomDevice devices(surface.surface, random);
        for (int i = 0; i < 400; ++i) {
          const DevicePose device = devices.at(i * time_step);
          const FingerOutput before = finger.output();
          const FingerOutput output = finger.update(surface.surface, device, time_step);
          if (output.state == ContactState::free) continue;
          if (std::fabs((device.orientation * Vector3d::UnitX()).dot(output.normal)) > 0.999) continue;
          // The axis in which friction acted: that of the proxy's angle before its slip. At touch-down the proxy has
          // the finger's angle.
          const double angle = before.state == ContactState::free ? finger.state().sample.angle : before.angle;
          const Vector3d expected =
              defined_axis(device, output.normal, angle - finger.state().sample.angle + device.twist);
          ASSERT_LE((finger.state().patch.axis - expected).norm(), 1e-9) << i;
          ASSERT_TRUE(output.converged);
          ++compared;
          slips += output.state == ContactState::slip;
        }
      }
    }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(slips, 500);
}

// Yawed by 90° before the first sample, the finger is rough across x.
TEST(MetamorphicPatch, AYawOfTheDeviceTurnsThePatchBeforeAndAfterTouchDown) {
  const AnySurface plane{PlaneSurface{}};
  const SoftFinger fresh(grooved(), parameters());
  const Quaterniond yawed = about(Vector3d::UnitZ(), quarter);
  EXPECT_NEAR(dragged(fresh, plane, {{0.0, 0.0, -2e-3}}, Vector3d::UnitX()), 1.0, 1e-9);
  EXPECT_NEAR(dragged(fresh, plane, {{0.0, 0.0, -2e-3}, yawed}, Vector3d::UnitX()), 0.25, 1e-9);
  EXPECT_NEAR(dragged(fresh, plane, {{0.0, 0.0, -2e-3}, yawed}, Vector3d::UnitY()), 1.0, 1e-9);
  EXPECT_NEAR(dragged(fresh, plane, {{0.0, 0.0, -2e-3}, Orientation::Identity(), quarter}, Vector3d::UnitY()), 1.0,
              1e-9);
  // Lifted, turned in the air and put down again it is as a fresh one is.
  SoftFinger used = fresh;
  for (int i = 0; i < 50; ++i) used.update(plane, {{1e-4 * i, 0.0, -2e-3}, about(Vector3d::UnitZ(), 0.1 * i)});
  used.update(plane, {{0.0, 0.0, 1e-3}, about(Vector3d::UnitX(), 1.0)});
  EXPECT_NEAR(dragged(used, plane, {{0.0, 0.0, -2e-3}, yawed}, Vector3d::UnitX()), 0.25, 1e-9);
}

// The finger's orientation relative to the body counts: a frame that is yawed turns the patch in it.
TEST(MetamorphicPatch, AYawedBodyFrameTurnsNothingInTheWorld) {
  Random random(52);
  for (const NamedSurface& surface : all_surfaces()) {
    SCOPED_TRACE(surface.name);
    ReplayOptions options;
    options.patch = grooved();
    options.finger = parameters(0.5);
    options.surface = surface.surface;
    options.fingers = 2;
    options.motion = BodyMotion::prescribed;
    const Scene scene{options.finger, Replay(options), {}, surface.name == "plane"};
    const std::array devices{RandomDevice(options.surface, random), RandomDevice(options.surface, random)};
    std::vector<Row> here;
    std::vector<Row> there;
    const BodyPose by{0.1 * random_direction(random), random_orientation(random)};
    for (int i = 0; i < rows; ++i) {
      here.push_back({i * time_step, {devices[0].at(i * time_step), devices[1].at(i * time_step)}, {}});
      there.push_back(moved(here.back(), by));
    }
    Map map;
    map.place = [&](const Vector3d& at) { return Vector3d(by.position + by.orientation * at); };
    map.vector = [&](const Vector3d& way) { return Vector3d(by.orientation * way); };
    // The search for a closest point stops at 1e-12 of the limit.
    Tolerance within = rounding(scene);
    within.length += 1e-10;
    within.angle += 1e-8;
    within.force += 1e-7;
    within.moment += 1e-9;
    expect_alike(scene, replay(scene, here), replay(scene, there), map, within);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// The first touch beside the bottom of a ball, where the normal is −z and the shortest rotation from z has no axis.
TEST(MetamorphicPatch, TheFirstTouchNearTheBottomOfABallDoesNotMatter) {
  const AnySurface ball{SphereSurface(0.05)};
  const SoftFinger finger(grooved(), parameters());
  double least = 1.0;
  double most = 0.0;
  for (int i = 0; i < 12; ++i) {
    const Vector3d beside(1e-5 * std::cos(0.5 * i), 1e-5 * std::sin(0.5 * i), -0.048);
    const double force = dragged(finger, ball, {beside}, Vector3d::UnitX());
    least = std::min(least, force);
    most = std::max(most, force);
  }
  EXPECT_NEAR(least, 1.0, 1e-3);
  EXPECT_NEAR(most, least, 1e-3);
}

// With the finger's x axis along the normal (the faces ±x of a box) the axis is transported: a number, and across a
// quarter of it.
TEST(MetamorphicPatch, AnAxisNormalToTheSurfaceIsTransported) {
  const AnySurface box{BoxSurface{Vector3d::Constant(0.02)}};
  const SoftFinger finger(grooved(), parameters());
  for (const double side : {-1.0, 1.0}) {
    const Vector3d from(side * 0.018, 0.0, 0.0);
    const double one = dragged(finger, box, {from}, Vector3d::UnitY());
    const double other = dragged(finger, box, {from}, Vector3d::UnitZ());
    EXPECT_NEAR(std::max(one, other), 1.0, 1e-9);
    EXPECT_NEAR(std::min(one, other), 0.25, 1e-9);
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::metamorphic
