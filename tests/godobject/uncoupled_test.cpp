// SPDX-License-Identifier: MIT
// The box is the paper's §3.1: a friction test of the force and one of the moment, each with its own slip state, "they
// do not influence each other in any way".
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

FingerCurve hertz_box() {
  return box(1.0, hertz()->moment_ratio());
}

/// Eqs. (8) to (12) for a single number: a proxy on a line (or a circle), a spring, a sticking limit and one while it
/// slides. It comes to rest when its trial has retreated within `sliding`/(1 + margin·(sticking/sliding − 1)).
struct Scalar {
  double stiffness;
  double margin;
  bool slides = false;
  bool slipped = false;
  double proxy = 0.0;

  /// What the spring exerts on the finger at `goal`.
  double step(double goal, double sticking, double sliding) {
    const double trial = stiffness * (proxy - goal);
    slipped = std::fabs(trial) > (slides ? sliding : sticking) * (1.0 + 1e-12);
    if (slipped) proxy = goal + std::copysign(sliding / stiffness, trial);
    const double rest = sliding / (1.0 + margin * (sticking / sliding - 1.0));
    slides = slipped || (slides && sliding < sticking && !(std::fabs(trial) < rest));
    return stiffness * (proxy - goal);
  }
};

TEST(Uncoupled, IsTwoScalarTests) {
  Random random(8);
  for (int scene = 0; scene < 60; ++scene) {
    FingerParameters with = parameters(random.uniform(0.2, 1.0), 0.005, 1000.0, random.logarithmic(1e-3, 1.0));
    with.mu_dynamic = with.mu * random.uniform(0.1, 1.0);
    with.mu_r = random.logarithmic(1e-4, 1e-2);
    with.mu_r_dynamic = *with.mu_r * random.uniform(0.1, 1.0);
    with.rest_margin = random.uniform(0.0, 1.0);
    SoftFinger finger(hertz_box(), with);
    Scalar force{1000.0, with.rest_margin};
    Scalar moment{with.twist_stiffness, with.rest_margin};
    double x = 0.0;
    double angle = 0.0;
    finger.update(on_plane(x, 0.0, 0.001), angle);
    const double stride = random.logarithmic(1e-5, 1e-3);
    const double turn = random.logarithmic(0.01, 2.0) * *with.mu_r / with.twist_stiffness;
    for (int i = 0; i < 1000; ++i) {
      x += random.uniform(-1.0, 1.0) * stride;
      angle += random.uniform(-1.0, 1.0) * turn;
      const double depth = random.uniform(5e-4, 2e-3);
      const double load = 1000.0 * depth;
      const FingerOutput output = finger.update(on_plane(x, 0.0, depth), angle);
      const double expected_force = force.step(x, with.mu * load, *with.mu_dynamic * load);
      const double expected_moment = moment.step(angle, *with.mu_r * load, *with.mu_r_dynamic * load);
      ASSERT_NEAR(output.force.x(), expected_force, 1e-11 * load) << scene << ' ' << i;
      ASSERT_NEAR(output.moment, expected_moment, 1e-11 * *with.mu_r * load) << scene << ' ' << i;
      ASSERT_EQ(output.state, force.slipped || moment.slipped ? ContactState::slip : ContactState::stick)
          << scene << ' ' << i;
      // How far from the next slip: nearer of the two, each to the limit that acts on it.
      const double share =
          std::max(std::fabs(expected_force) / ((force.slides ? *with.mu_dynamic : with.mu) * load),
                   std::fabs(expected_moment) / ((moment.slides ? *with.mu_r_dynamic : *with.mu_r) * load));
      if (output.state == ContactState::stick) {
        ASSERT_NEAR(finger.margin(), std::max(1.0 - share, 0.0), 1e-9) << scene << ' ' << i;
      }
    }
  }
}

TEST(Uncoupled, ATwistWithoutTorsionDoesNotSlip) {
  FingerParameters with = parameters();
  with.mu_r = 0.0;
  SoftFinger finger(hertz_box(), with);
  finger.update(on_plane(0.0, 0.0, 0.001), 0.0);
  const FingerOutput turned = finger.update(on_plane(0.0, 0.0, 0.001), 1.0);
  EXPECT_EQ(turned.state, ContactState::stick);
  EXPECT_EQ(turned.moment, 0.0);
}

}  // namespace
}  // namespace limitcurve::godobject::test
