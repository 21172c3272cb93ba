// SPDX-License-Identifier: MIT
// The god-object over recorded motions on surfaces that rest, are moved, or are free.
#include "godobject/scene/replay.hpp"

#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::replay_test {
namespace {

static_assert(noexcept(std::declval<Replay&>().step(0.0, std::declval<std::span<const DevicePose>>(),
                                                    std::declval<const BodyPose&>())));

constexpr double mu = 0.6;
constexpr double radius = 0.005;

ReplayOptions options(CurveKind curve = CurveKind::exact, Projection projection = Projection::closest_point) {
  ReplayOptions result;
  result.law = hertz();
  result.finger = parameters(mu, radius);
  result.curve = curve;
  result.projection = projection;
  result.tolerance = 1e-8;
  return result;
}

DevicePose pose(const Vector3d& position, double twist = 0.0) {
  return {position, Quaterniond::Identity(), twist};
}

SceneContact moved(Replay& replay, double time, const DevicePose& finger, const BodyPose& body = {}) {
  replay.step(time, std::array{finger}, body);
  return replay.contacts().front();
}

// On the plane at rest a replay is the finger itself, with every curve and projection.
TEST(Replay, OnThePlaneAtRestIsTheFinger) {
  for (const CurveChoice& choice : all_curves()) {
    {
      const std::string name = choice.name();
      const ReplayOptions with = options(choice.kind, choice.projection);
      Replay replay(with);
      SoftFinger finger(make_finger_curve(choice.kind, with.law, with.tolerance), with.finger, choice.projection);
      int slips = 0;
      double dissipated = 0.0;
      for (int i = 0; i <= 1000; ++i) {
        const double t = i * 1e-3;
        const double z = 0.0005 - 0.004 * t * (1.0 - t) * 4.0;
        const FingerOutput output = finger.update(on_plane(0.01 * t, 0.02 * t * t, -z), 2.0 * t, 1e-3);
        const SceneContact contact = moved(replay, t, pose({0.01 * t, 0.02 * t * t, z}, 2.0 * t));
        dissipated += output.slip_work;
        ASSERT_EQ(contact.state, output.state) << name << ' ' << i;
        ASSERT_LT((contact.proxy - output.proxy).norm(), 1e-15) << name << ' ' << i;
        ASSERT_LT((contact.force - output.force).norm(), 1e-12) << name << ' ' << i;
        ASSERT_NEAR(contact.angle, output.angle, 1e-13) << name << ' ' << i;
        ASSERT_NEAR(contact.moment, output.moment, 1e-14) << name << ' ' << i;
        ASSERT_EQ(contact.load, output.load) << name << ' ' << i;
        ASSERT_NEAR(contact.margin, finger.margin(), 1e-12) << name << ' ' << i;
        slips += output.state == ContactState::slip;
      }
      EXPECT_GT(slips, 100) << name;
      EXPECT_NEAR(replay.contacts().front().dissipated, dissipated, 1e-12) << name;
      EXPECT_EQ(replay.contacts().front().state, ContactState::free) << name;
      EXPECT_TRUE(std::isnan(replay.contacts().front().cor)) << name;
    }
  }
}

// While a sample is invalid the wrench is held in the body's frame: force and normal turn together. The position is the
// last good one.
TEST(Replay, HeldForceAndNormalTurnWithTheBody) {
  ReplayOptions with = options();
  with.motion = BodyMotion::prescribed;
  Replay replay(with);
  moved(replay, 0.0, pose({0.0, 0.0, -0.002}));
  const Vector3d proxy = moved(replay, 0.001, pose({0.0003, 0.0, -0.002})).proxy;
  const Quaterniond turned(AngleAxisd(0.7, Vector3d(1.0, 2.0, 0.5).normalized()));
  const SceneContact contact = moved(replay, 0.002, pose({nan, 0.0, 0.0}), {Vector3d::Zero(), turned});
  ASSERT_EQ(contact.state, ContactState::invalid);
  EXPECT_EQ(contact.proxy, proxy);
  EXPECT_GT(contact.force.norm(), 0.1);
  EXPECT_NEAR(contact.force.dot(contact.normal), 0.0, 1e-12);
  // What it needs fades with it.
  for (int i = 3; i < 20; ++i) {
    const SceneContact fading = moved(replay, 0.001 * i, pose({nan, 0.0, 0.0}));
    EXPECT_NEAR(fading.load_to_hold / fading.force.norm(), contact.load_to_hold / contact.force.norm(), 1e-9) << i;
    EXPECT_LT(fading.load, contact.load);
  }
}

// After a time stamp far ahead, or behind, one sample is refused: the rest go on by their own steps.
TEST(Replay, GoesOnAfterOneWrongTime) {
  for (const double wrong : {1e6, -1.0}) {
    ReplayOptions with = options();
    with.finger.damping = 1.0;
    Replay replay(with);
    Replay same(with);
    int refused = 0;
    for (int i = 0; i < 40; ++i) {
      const DevicePose finger{{1e-5 * i, 0.0, -0.002}};
      refused += moved(replay, i == 20 ? wrong : 1e-3 * i, finger).state == ContactState::invalid;
      const SceneContact expected = moved(same, 1e-3 * i, finger);
      EXPECT_NEAR(replay.contacts().front().force.x(), expected.force.x(), i > 30 ? 1e-12 : 1.0);
    }
    EXPECT_EQ(refused, 1) << wrong;
  }
}

TEST(Replay, NamesWhatIsWrongWithItsOptions) {
  const auto refused = [](auto change, const char* told) {
    ReplayOptions with = options();
    change(with);
    expect_mention(complaint([&] { Replay{with}; }), told);
  };
  refused([](ReplayOptions& with) { with.law = nullptr; }, "law");
  refused([](ReplayOptions& with) { with.fingers = 0; }, "fingers");
  refused([](ReplayOptions& with) { with.fingers = 17; }, "fingers");
  refused([](ReplayOptions& with) { with.finger.damping = -1.0; }, "damping");
  refused([](ReplayOptions& with) { with.body.mass = 0.0; }, "mass");
  refused(
      [](ReplayOptions& with) {
        with.curve = CurveKind::table;
        with.tolerance = 0.0;
      },
      "tolerance");
  refused(
      [](ReplayOptions& with) {
        with.curve = CurveKind::box;
        with.projection = Projection::radial;
      },
      "a box goes with closest-point only");
}

TEST(Kinds, ReadBackAsTheyArePrinted) {
  for (const CurveKind kind : curve_kinds) EXPECT_EQ(parse_curve_kind(to_string(kind)), kind);
  for (const Projection kind : projections) EXPECT_EQ(parse_projection(to_string(kind)), kind);
  EXPECT_THROW(static_cast<void>(parse_curve_kind("circle")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(parse_projection("")), std::invalid_argument);
  EXPECT_EQ(parse_projection("closest_point"), Projection::closest_point);
}

}  // namespace
}  // namespace limitcurve::godobject::test::replay_test
