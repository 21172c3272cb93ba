// SPDX-License-Identifier: MIT
// What the host's settings may not change: -ffast-math in a user's file, another rounding, subnormal numbers flushed to
// 0.
#include "tests/godobject/host_settings.hpp"
#include "tests/godobject/host_settings_user.hpp"

namespace limitcurve::godobject::test {
namespace {

constexpr double time_step = 1e-3;

std::vector<DevicePose> path_on(const AnySurface& surface, Random& random) {
  const RandomDevice device(surface, random);
  std::vector<DevicePose> path;
  for (int i = 0; i < 100; ++i) path.push_back(device.at(i * time_step));
  // Also subnormal positions, depths and twists.
  for (const std::size_t i : {41U, 42U, 43U}) path[i].twist += 1e-310 * static_cast<double>(i);
  path[60].position *= 1e-300;
  path[61].position = {1e-310, -3e-310, 2e-310};
  return path;
}

void expect_same_bits(const FingerState& one, const FingerState& other) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const auto same = [&](const Vector3d& a, const Vector3d& b) {
    for (Eigen::Index i = 0; i < 3; ++i) ASSERT_EQ(bits(a[i]), bits(b[i]));
  };
  expect_same(one.output, other.output);
  ASSERT_EQ(one.in_contact, other.in_contact);
  same(one.sample.goal, other.sample.goal);
  same(one.sample.normal, other.sample.normal);
  same(plain::vector(one.spin.normal), plain::vector(other.spin.normal));
  same(plain::vector(one.contact.finger), plain::vector(other.contact.finger));
  ASSERT_EQ(one.contact.face, other.contact.face);
  ASSERT_EQ(one.faults.refused, other.faults.refused);
  ASSERT_EQ(one.friction.force_slides, other.friction.force_slides);
  ASSERT_EQ(bits(one.limit_load), bits(other.limit_load));
  ASSERT_EQ(bits(one.sample.angle), bits(other.sample.angle));
  ASSERT_EQ(bits(one.sample.unwrapped_by), bits(other.sample.unwrapped_by));
}

// The step lives in the library: a user's file gets the same to the last bit, whatever its own arithmetic, and samples
// that are NaN are refused.
TEST(HostSettings, FastMathInAUsersFileChangesNothing) {
  int refused = 0;
  for_each_choice(31, [&](const Choice& choice, Random& random) {
    const FingerCurve curve = make_finger_curve(choice.curve.kind, hertz(), 1e-8);
    const std::vector<DevicePose> path = path_on(choice.surface.surface, random);
    const SoftFinger finger(curve, choice.parameters.finger, choice.curve.projection);
    const UsersRun own = use(finger, choice.surface.surface, path, time_step);
    const UsersRun fast = use_with_fast_math(finger, choice.surface.surface, path, time_step);
    for (std::size_t i = 0; i < path.size(); ++i) {
      SCOPED_TRACE("sample " + std::to_string(i));
      expect_same_bits(own.states[i], fast.states[i]);
      if (testing::Test::HasFatalFailure()) return;
      ASSERT_EQ(own.margins[i], fast.margins[i]);
      ASSERT_EQ(own.outputs[i].force, fast.outputs[i].force);
      ASSERT_EQ(own.outputs[i].load, fast.outputs[i].load);
      refused += fast.outputs[i].state == ContactState::invalid;
    }
    // Its own use of friction is its own affair, but right where its arithmetic is.
    const auto expected = rub(curve, choice.curve.projection, 3.0, 0.01);
    const auto found = rub_with_fast_math(curve, choice.curve.projection, 3.0, 0.01);
    for (std::size_t i = 0; i < 2; ++i) ASSERT_NEAR(found[i], expected[i], 1e-9);
  });
  EXPECT_GT(refused, 90 * static_cast<int>(all_surfaces().size()));
}

// Other files' copies of a template are not those of the file with -ffast-math, whichever the linker meets first.
TEST(HostSettings, FastMathInAUsersFileIsNotShared) {
  EXPECT_NE(rub_of_fast_math(), (static_cast<Rub>(&apply_friction<double, double>)));
  EXPECT_NE(on_ray_of_fast_math(), (static_cast<OnRay>(&point_on_ray<double, double>)));
}

// A rounding in each of 100 steps is nothing against 1e-9 of some newtons.
TEST(HostSettings, AFingerFeelsTheSameUnderAnyRounding) {
  for_each_choice(32, [&](const Choice& choice, Random& random) {
    const FingerCurve curve = make_finger_curve(choice.curve.kind, hertz(), 1e-8);
    const std::vector<DevicePose> path = path_on(choice.surface.surface, random);
    const SoftFinger finger(curve, choice.parameters.finger, choice.curve.projection);
    const UsersRun nearest = use(finger, choice.surface.surface, path, time_step);
    for (const Setting& setting : settings()) {
      const UsersRun other = under(setting, [&] { return use(finger, choice.surface.surface, path, time_step); });
      for (std::size_t i = 0; i < path.size(); ++i) {
        SCOPED_TRACE(setting.name + ", sample " + std::to_string(i));
        const FingerOutput& a = nearest.outputs[i];
        const FingerOutput& b = other.outputs[i];
        ASSERT_EQ(a.state == ContactState::invalid, b.state == ContactState::invalid);
        ASSERT_LE((a.proxy - b.proxy).norm(), 1e-9);
        ASSERT_NEAR(a.angle, b.angle, 1e-9);
        ASSERT_NEAR(a.load, b.load, 1e-9);
        ASSERT_LE((a.force - b.force).norm(), 1e-9);
        ASSERT_NEAR(a.moment, b.moment, 1e-9);
        ASSERT_GE(b.slip_work, 0.0);
      }
    }
  });
}

TEST(HostSettings, ATableLooksUpTheSameUnderAnyRounding) {
  const Table table = Table::build(hertz(), 1e-10);
  Random random(33);
  std::vector<SlipTwist> twists{{0.0, 1.0}, {1.0, 0.0}, {1.0, 1.0}, {1e-310, 1.0}, {1.0, 1e-310}, {5e-324, 5e-324}};
  for (int i = 0; i < 20000; ++i) twists.push_back({random.logarithmic(1e-12, 1e12), 1.0});
  for (int i = 1; i <= 64; ++i) {  // about the ends of cells
    const double x = i / 64.0;
    for (const double beside : {std::nextafter(x, 0.0), x, std::nextafter(x, 2.0)}) {
      twists.push_back({beside, 1.0});
      twists.push_back({1.0, beside});
    }
  }
  const auto look_up = [&] {
    std::vector<UnitWrench> wrenches;
    for (const SlipTwist& twist : twists) wrenches.push_back(table.wrench(twist));
    return wrenches;
  };
  const std::vector<UnitWrench> nearest = look_up();
  for (const Setting& setting : settings()) {
    const std::vector<UnitWrench> other = under(setting, look_up);
    for (std::size_t i = 0; i < twists.size(); ++i) {
      // A twist of nothing but subnormal numbers is none where those are flushed to 0.
      if (std::fmax(twists[i].slide, twists[i].spin) < 1e-300 && setting.name == "no subnormals") continue;
      ASSERT_LE(apart(nearest[i], other[i]), 1e-9) << setting.name << ' ' << twists[i].slide << ' ' << twists[i].spin;
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
