// SPDX-License-Identifier: MIT
#include "godobject/patch/patch_projection.hpp"
#include "limitcurve/patch/patch_table.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::patch_finger_test {
namespace {

Patch tripod() {
  const std::vector<PatchLoad> loads{{-0.04, -0.04, 1}, {0.04, -0.02, 2}, {-0.04, 0.08, 1}};
  return Patch::points(loads);
}

std::vector<std::pair<std::string, Patch>> patches() {
  return {{"rectangle", Patch::rectangle(0.02, 0.01)},
          {"slim rectangle", Patch::rectangle(0.05, 0.005)},
          {"hertz", Patch::ellipse(hertz(), 0.008, 0.004)},
          {"slim hertz", Patch::ellipse(hertz(), 0.001, 0.01)},
          {"uniform", Patch::ellipse(uniform(), 0.002, 0.004)},
          {"tripod", tripod().smoothed(1e-3 * tripod().moment_ratio())},
          {"orthotropic", Patch::rectangle(0.02, 0.01).orthotropic(0.5, 2.0)},
          {"table", PatchTable::build(Patch::ellipse(parse_law("cone"), 0.008, 0.004), 1e-3)}};
}

FingerParameters usual() {
  return parameters(0.6, 0.006, 1000.0, 0.036);
}

}  // namespace

TEST(PatchProjector, ClosestPointIsOnTheSurfaceAndTheSlipItsNormal) {
  // 1e6 trials in the whole study.
  const int trials = studies_are_whole() ? 28571 : repetitions(1000, 50);
  for (const auto& [name, patch] : patches()) {
    const PatchProjector projector(patch);
    const double m0 = patch.moment_ratio();
    for (const double ratio : {1e-3, 1e-1, 1.0, 1e1, 1e3}) {
      std::mt19937 bits(4);
      std::normal_distribution<double> normal;
      std::uniform_real_distribution<double> decades(-0.5, 2.0);
      for (int i = 0; i < trials; ++i) {
        PatchWrench trial{normal(bits), normal(bits), normal(bits)};
        const double size = 3.0 * std::pow(10.0, decades(bits)) / std::hypot(trial.fx, trial.fy, trial.moment);
        trial = {size * trial.fx, size * trial.fy, size * m0 * trial.moment};
        const PatchProjection found = projector.project(trial, 3.0, 500.0, m0 * std::sqrt(ratio), {});
        ASSERT_TRUE(found.converged) << name << ' ' << ratio << ' ' << i;
        ASSERT_LE(found.evaluations, PatchProjector::most_evaluations);
        if (!found.slips) {
          EXPECT_LE(projector.patch().gauge({trial.fx / 3.0, trial.fy / 3.0, trial.moment / m0 * m0 / 3.0}), 1.0 + 1e-9)
              << name;
          continue;
        }
        // What the springs gave is the slip; W·T = μP H(T) puts W on the surface with T as its normal.
        EXPECT_NEAR((trial.fx - found.wrench.fx) / 500.0, found.slip.vx, 1e-12);
        const double power =
            found.wrench.fx * found.slip.vx + found.wrench.fy * found.slip.vy + found.wrench.moment * found.slip.omega;
        const double available = 3.0 * patch.power(found.slip);
        EXPECT_GT(power, 0.0);
        const double slipped = std::hypot(found.slip.vx, found.slip.vy, m0 * found.slip.omega);
        // Of a slip near none the rounding of the trial is what is left.
        const double rounding =
            4.0 * std::numeric_limits<double>::epsilon() * std::hypot(trial.fx, trial.fy, trial.moment / m0) / 500.0;
        EXPECT_NEAR(power, available, 1e-9 * available + 1e-11 * slipped + 3.0 * rounding) << name << ' ' << ratio;
      }
    }
  }
}

/// Two to seven points, of which one may be a thousand times heavier.
Patch random_points(std::mt19937& bits) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PatchLoad> loads(2 + bits() % 6);
  for (PatchLoad& load : loads) load = {0.01 * unit(bits), 0.01 * unit(bits), std::pow(10.0, 1.5 * unit(bits))};
  const Patch patch = Patch::points(loads).orthotropic(bits() % 2 == 0 ? 1.0 : std::pow(10.0, 0.5 * unit(bits)), 1.0);
  return patch.smoothed(1e-3 * patch.moment_ratio());
}

TEST(PatchProjector, PointsStickWithinTheirLimitAndAlwaysConverge) {
  std::mt19937 bits(17);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(-1.5, 1.5);
  const int sets = study_cases(600);
  for (int set = 0; set < sets; ++set) {
    const Patch patch = random_points(bits);
    const PatchProjector projector(patch);
    const double m0 = patch.moment_ratio();
    for (int i = 0; i < 60; ++i) {
      const double size = std::pow(10.0, 0.3 * normal(bits));
      PatchWrench trial{normal(bits), normal(bits), normal(bits)};
      const double length = std::hypot(trial.fx, trial.fy, trial.moment);
      trial = {size * trial.fx / length, size * trial.fy / length, size * m0 * trial.moment / length};
      const double ratio = std::pow(10.0, unit(bits));
      const PatchProjection found = projector.project(trial, 1.0, 1000.0, m0 * ratio, {});
      ASSERT_TRUE(found.converged) << set << ' ' << i;
      ASSERT_LE(found.evaluations, PatchProjector::most_evaluations);
      if (found.slips) {
        const double power =
            found.wrench.fx * found.slip.vx + found.wrench.fy * found.slip.vy + found.wrench.moment * found.slip.omega;
        const double slipped = std::hypot(found.slip.vx, found.slip.vy, m0 * found.slip.omega);
        ASSERT_NEAR(power, patch.power(found.slip), 1e-8 * slipped + 1e-15) << set << ' ' << i;
      } else {
        ASSERT_LE(patch.gauge(trial), 1.0 + 1e-9) << set << ' ' << i;
      }
    }
  }
}

TEST(PatchFinger, OfADiscIsSoftFinger) {
  const int steps = repetitions(studies_are_whole() ? 4000 : 800, 100);
  for (const char* name : {"hertz", "uniform"}) {
    const Law law = parse_law(name);
    FingerParameters parameters = usual();
    for (const bool damped : {false, true}) {
      parameters.damping = damped ? 2.0 : 0.0;
      parameters.twist_damping = damped ? 1e-4 : 0.0;
      parameters.mu_dynamic = 0.5;
      SoftFinger patch(Patch::ellipse(law, 0.006, 0.006), parameters);
      SoftFinger disc(Table::build(law, 1e-12), parameters);
      double x = 0.0;
      double y = 0.0;
      double twist = 0.1;
      std::mt19937 bits(9);
      std::normal_distribution<double> normal;
      int slips = 0;
      for (int i = 0; i < steps; ++i) {
        x += 1e-4 * normal(bits) + 2e-5;
        y += 1e-4 * normal(bits);
        twist += 0.02 * normal(bits);
        const Contact contact = on_plane(x, y, 1.5e-3 + 1e-3 * std::sin(0.01 * i));
        const FingerOutput one = patch.update(contact, twist, 1e-3);
        const FingerOutput two = disc.update(contact, twist, 1e-3);
        ASSERT_EQ(one.state, two.state) << name << ' ' << i;
        EXPECT_NEAR((one.proxy - two.proxy).norm(), 0.0, 1e-9 * 0.006) << i;
        EXPECT_NEAR(one.angle, two.angle, 1e-9) << i;
        EXPECT_LE((one.force - two.force).norm(), 1e-9) << i;
        EXPECT_NEAR(one.moment / 0.006, two.moment / 0.006, 1e-9) << i;
        slips += one.state == ContactState::slip;
        if (one.state == ContactState::slip) {
          EXPECT_NEAR(one.cor / two.cor, 1.0, 1e-5);
          EXPECT_NEAR((patch.centre_of_rotation() - disc.centre_of_rotation()).norm() / one.cor, 0.0, 1e-4);
        }
        EXPECT_NEAR(patch.margin(), disc.margin(), 1e-8);
        EXPECT_NEAR(patch.load_to_hold(), disc.load_to_hold(), 1e-8);
      }
      EXPECT_GT(slips, steps / 10);
    }
  }
}

TEST(PatchFinger, SteadyTwistGivesThePatchsWrench) {
  for (const auto& [name, patch] : patches()) {
    for (const double ratio : {1e-2, 1.0, 1e2}) {
      FingerParameters parameters = usual();
      const double m0 = patch.moment_ratio();
      // So stiff that the deflection, which turns with the patch, adds little to the proxy's velocity.
      parameters.stiffness = 1e6;
      parameters.twist_stiffness = 1e6 * m0 * m0 * ratio;
      SoftFinger finger(patch, parameters);
      // The device turns about a point that is fixed to it: in the patch's axes the twist is constant.
      const PatchTwist twist{0.3 * m0, -0.5 * m0, 1.0};
      double x = 0.0;
      double y = 0.0;
      double angle = 0.0;
      FingerOutput output;
      const double step = 1e-4;
      for (int i = 0; i < 1500; ++i) {
        const double lag = finger.output().state == ContactState::free ? angle : finger.output().angle;
        x += step * (twist.vx * std::cos(lag) - twist.vy * std::sin(lag));
        y += step * (twist.vx * std::sin(lag) + twist.vy * std::cos(lag));
        angle += step * twist.omega;
        output = finger.update(on_plane(x, y, 1e-6), std::remainder(angle, 6.283185307179586));
      }
      const PatchWrench wrench = finger.patch()->wrench(twist);
      // The user feels the opposite of what drives the patch; its axes turn with α_p.
      const double c = std::cos(output.angle);
      const double s = std::sin(output.angle);
      EXPECT_NEAR(-(c * output.force.x() + s * output.force.y()) / 0.6, wrench.fx, 1e-3) << name << ' ' << ratio;
      EXPECT_NEAR(-(-s * output.force.x() + c * output.force.y()) / 0.6, wrench.fy, 1e-3) << name << ' ' << ratio;
      EXPECT_NEAR(-output.moment / (0.6 * m0), wrench.moment / m0, 1e-3) << name << ' ' << ratio;
    }
  }
}

TEST(PatchFinger, FrictionAlongAndAcrossTurnsWithTheFinger) {
  // Twice as rough along the patch's x axis.
  FingerParameters parameters = usual();
  parameters.mu = 0.3;
  for (const double turned : {0.0, 1.5707963267948966, 0.5}) {
    for (const bool upside_down : {false, true}) {
      SoftFinger finger(Patch::rectangle(0.02, 0.02).orthotropic(2.0, 1.0), parameters);
      const Vector3d normal = upside_down ? Vector3d(0, 1, 0) : Vector3d(0, 0, 1);
      const Vector3d x = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal) * Vector3d::UnitX();
      const Vector3d along = x * std::cos(turned) + normal.cross(x) * std::sin(turned);
      FingerOutput output;
      for (int i = 0; i < 50; ++i) output = finger.update({1e-4 * i * along, normal, 1e-3}, turned);
      EXPECT_EQ(output.state, ContactState::slip);
      EXPECT_NEAR(-output.force.dot(along), 0.6, 1e-9) << turned;
      finger.reset();
      const Vector3d across = normal.cross(along);
      for (int i = 0; i < 50; ++i) output = finger.update({1e-4 * i * across, normal, 1e-3}, turned);
      EXPECT_NEAR(-output.force.dot(across), 0.3, 1e-9) << turned;
    }
  }
}

// A twist has no orientation: one of an earlier step must not turn the patch. The normal tilts, then turns by 90°, so
// that a projected axis differs from that of a held orientation.
TEST(PatchFinger, WithATwistNoEarlierOrientationTurnsIt) {
  std::vector<FingerOutput> felt;
  for (const std::optional<double>& first : {std::optional<double>(), std::optional(0.0), std::optional(1.0)}) {
    SoftFinger finger(Patch::rectangle(0.02, 0.002), usual());
    if (first) finger.update(on_plane(0.0, 0.0, -0.001), Orientation(AngleAxisd(*first, Vector3d::UnitZ())));
    for (int i = 0; i < 160; ++i) {
      const double tilt = 0.01 * std::min(i, 50);
      const double turn = 0.01 * std::numbers::pi * std::clamp(i - 50, 0, 50);
      const Vector3d normal(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
      finger.update({{1e-4 * std::max(i - 100, 0), 0.0, 0.0}, normal, 0.002}, 0.02 * std::max(i - 100, 0));
    }
    felt.push_back(finger.output());
    expect_same(felt.back(), felt.front());
  }
}

// A state of a round finger has no axis yet: its margin is that of the next step, which sticks.
TEST(PatchFinger, TheStateOfARoundFingerHasAMargin) {
  for (const double turned : {0.0, 0.3}) {
    SoftFinger round = hertz_finger(usual());
    SoftFinger patch(Patch::rectangle(0.02, 0.002).orthotropic(2.0, 1.0), usual());
    for (const double x : {0.0, 4e-4}) round.update(on_plane(x, 0.0, 0.002), turned);
    patch.restore(round.state());
    const double margin = patch.margin();
    const double load = patch.load_to_hold();
    patch.update(on_plane(4e-4, 0.0, 0.002), turned);
    ASSERT_EQ(patch.output().state, ContactState::stick);
    EXPECT_LT(margin, 0.9);
    EXPECT_DOUBLE_EQ(margin, patch.margin());
    EXPECT_DOUBLE_EQ(load, patch.load_to_hold());
  }
}

TEST(PatchFinger, TheOriginOfThePatchPlaysNoPart) {
  SoftFinger here(Patch::rectangle(0.02, 0.01), usual());
  const std::vector<PatchPoint> corners{{0.49, -0.255}, {0.51, -0.255}, {0.51, -0.245}, {0.49, -0.245}};
  SoftFinger there(Patch::polygon(corners), usual());
  for (int i = 0; i < 100; ++i) {
    const FingerOutput one = here.update(on_plane(1e-4 * i, 5e-5 * i, 1e-3), 0.01 * i);
    const FingerOutput two = there.update(on_plane(1e-4 * i, 5e-5 * i, 1e-3), 0.01 * i);
    EXPECT_LE((one.force - two.force).norm(), 1e-9);
    EXPECT_NEAR(one.moment, two.moment, 1e-11);
  }
}

TEST(PatchFinger, WithoutFrictionFollowsTheFinger) {
  FingerParameters parameters = usual();
  parameters.mu = 0.0;
  SoftFinger finger(Patch::rectangle(0.02, 0.01), parameters);
  for (int i = 0; i < 10; ++i) {
    const FingerOutput output = finger.update(on_plane(1e-3 * i, 0, 1e-3), 0.1 * i);
    EXPECT_EQ(output.force.norm(), 0.0);
    EXPECT_EQ(output.moment, 0.0);
    EXPECT_NEAR(output.proxy.x(), 1e-3 * i, 1e-15);
  }
}

TEST(PatchFinger, BadParametersAreNamed) {
  const auto refused = [](const Patch& patch, const FingerParameters& parameters, const char* told,
                          double radius = 0.0) {
    expect_mention(complaint([&] { SoftFinger(patch, parameters, radius); }), told);
  };
  FingerParameters parameters = usual();
  parameters.mu_r = 0.01;
  refused(tripod(), parameters, "mu_r");
  parameters = usual();
  parameters.mu = nan;
  refused(tripod(), parameters, "mu = nan");
  const Patch point = Patch::points(std::vector<PatchLoad>{{1, 2, 3}});
  refused(point, usual(), "on one point");
  refused(point, usual(), "none", 0.001);
  refused(tripod(), usual(), "point_radius = 1e-09", 1e-9);
}

}  // namespace limitcurve::godobject::test::patch_finger_test
