// SPDX-License-Identifier: MIT
// What a finger does alike whether its contact is round or a patch.
#include "limitcurve/patch/patch.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

// Between two walls 20 mm apart, the finger 1 mm deep in each: a sample that landed anew is what it is after a sample
// in between.
TEST(SoftFinger, TouchesDownWhereItLandsAnew) {
  const Vector3d n = Vector3d::UnitX();
  const Patch patch = Patch::ellipse(hertz(), 0.01, 0.004);
  for (const double damping : {0.0, 2.0}) {
    FingerParameters with = parameters();
    with.damping = damping;
    for (const SoftFinger& start : {hertz_finger(with), SoftFinger(patch, with)}) {
      SoftFinger lands = start;
      SoftFinger leaves = start;
      for (SoftFinger* finger : {&lands, &leaves}) {
        finger->update({-0.01 * n, n, 0.001}, 3.0, 1e-3);
        finger->update({Vector3d(-0.01, 0.001, 0.0), n, 0.001}, -3.0, 1e-3);
      }
      leaves.update({-0.01 * n, n, -0.01}, -3.0, 1e-3);
      const Contact other{0.01 * n, -n, 0.001, {}, true};
      EXPECT_EQ(lands.preview(other, -3.0, 1e-3).load, leaves.preview(other, -3.0, 1e-3).load);
      const FingerOutput output = lands.update(other, -3.0, 1e-3);
      const FingerOutput expected = leaves.update(other, -3.0, 1e-3);
      EXPECT_NEAR(output.load, (1000.0 + damping / 1e-3) * 0.001, 1e-12);
      EXPECT_EQ(output.load, expected.load);
      EXPECT_EQ(output.angle, expected.angle);
      EXPECT_EQ(output.moment, 0.0);
      EXPECT_EQ(output.force, Vector3d::Zero());
      EXPECT_TRUE(same_bits(output.proxy, expected.proxy));
      EXPECT_EQ(output.state, ContactState::stick);
    }
  }
}

TEST(SoftFinger, WhatWasMovedFromStaysWhatItWas) {
  const auto force_of = [](SoftFinger& finger) {
    finger.reset();
    finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
    return finger.update(on_plane(0.01, 0.0, 0.002), 0.1).force;
  };
  auto round = hertz_finger();
  SoftFinger patch(Patch::rectangle(0.01, 0.01), round.parameters());
  for (SoftFinger* finger : {&round, &patch}) {
    const Vector3d before = force_of(*finger);
    { const SoftFinger gone = std::move(*finger); }
    EXPECT_EQ(force_of(*finger), before);  // NOLINT(bugprone-use-after-move)
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
