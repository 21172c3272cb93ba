// SPDX-License-Identifier: MIT
// A contact near its home is asked less (FingerState::home): whatever comes, a finger does what one does that is asked all in every step.
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

namespace limitcurve::godobject::test {
namespace {

bool are_same(double one, double other) {
  return one == other || (std::isnan(one) && std::isnan(other));
}

bool are_same(const FingerOutput& one, const FingerOutput& other) {
  return one.state == other.state && same_bits(one.proxy, other.proxy) && same_bits(one.force, other.force) && one.angle == other.angle &&
         one.moment == other.moment && one.depth == other.depth && one.load == other.load && one.slip_work == other.slip_work &&
         are_same(one.cor, other.cor);
}

/// A motion that wanders, by steps of six decades, or trembles by as much as may be a leap; and what goes wrong with it: numbers that are none
/// or absurd, leaps, angles that wrap around, time that goes backwards.
class Wandering {
 public:
  Wandering(std::uint64_t seed, double leap)
      : random_(seed),
        place_(far(), far(), far()),
        step_(random_.logarithmic(1e-6, 0.3)),
        is_tilted_(one_in(2)),
        trembling_(one_in(3) ? std::min(leap, 2.0) : 0.0) {
    turn_normal(is_tilted_ ? 1.0 : 0.0);
  }

  struct Input {
    Contact contact;
    double twist;
    double time_step;
  };

  Input next() {
    place_ += step_ * direction();
    twist_ += step_ * random_.uniform(-100.0, 100.0);
    if (is_tilted_ && one_in(20)) turn_normal(0.1);
    Input input{{place_, normal_, random_.uniform(-0.0005, 0.0045)}, twist_, one_in(4) ? 1e-3 : 0.0};
    if (trembling_ > 0.0 && !one_in(3)) {
      input.contact.point = place_ + random_.uniform(0.0, 0.6) * trembling_ * direction();
      input.contact.depth = random_.uniform(0.0, 0.6) * trembling_;
    }
    if (one_in(20)) input.twist += 2.0 * std::numbers::pi * random_.uniform(0.0, 2.0);
    if (one_in(40)) input.contact.point += 2.0 * direction();
    if (one_in(40)) input.contact.depth = random_.logarithmic(1e-3, 1.0);
    if (one_in(15)) *any_number_of(input) = odd_numbers[random_.bits() % odd_numbers.size()];
    return input;
  }

 private:
  using Limits = std::numeric_limits<double>;
  static constexpr std::array<double, 14> odd_numbers{
      0.0, -0.0, 5e-324,      -1e-300,     1e154, 1e300, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
      1e6, -1e6, 999999.9999, 1.0000001e6, -1e-3};

  bool one_in(std::uint64_t count) { return random_.bits() % count == 0; }
  /// Most begin near the origin, some where SoftFinger::farthest is not far.
  double far() { return one_in(8) ? random_.uniform(0.99999, 1.0) * 1e6 : 0.0; }
  Eigen::Vector3d direction() { return {random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0)}; }
  void turn_normal(double by) { normal_ = (normal_ + by * direction()).normalized(); }

  double* any_number_of(Input& input) {
    const std::size_t i = random_.bits() % 9;
    if (i < 3) return &input.contact.point[static_cast<Eigen::Index>(i)];
    if (i < 6) return &input.contact.normal[static_cast<Eigen::Index>(i - 3)];
    if (i == 6) return &input.contact.depth;
    return i == 7 ? &input.twist : &input.time_step;
  }

  Random random_;
  Eigen::Vector3d place_;
  Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();
  double step_;
  bool is_tilted_;
  double trembling_;  // [m]
  double twist_ = 0.0;
};

TEST(Home, AFingerThereDoesWhatOneDoesThatIsAskedAll) {
  const Table table = Table::build(hertz(), 1e-6);
  for (const double jump_limit : {0.5, 0.02, std::numeric_limits<double>::infinity()}) {
    FingerParameters with = parameters();
    with.jump_limit = jump_limit;
    for (const std::optional<double> mu_dynamic : {std::optional<double>{}, std::optional<double>{0.4}}) {
      with.mu_dynamic = mu_dynamic;
      const auto walk = [&](const auto& boundary, auto projection) {
        SoftFinger finger(boundary, with, projection);
        SoftFinger asked = finger;
        int at_home = 0;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
          Wandering wandering(seed, jump_limit);
          finger.reset();
          asked.reset();
          for (int i = 0; i < 300; ++i) {
            const auto [contact, twist, time_step] = wandering.next();
            at_home += finger.state().has_home();
            asked.restore(asked.state());
            ASSERT_FALSE(asked.state().has_home());
            ASSERT_TRUE(are_same(finger.update(contact, twist, time_step), asked.update(contact, twist, time_step))) << seed << ' ' << i;
            ASSERT_EQ(finger.margin(), asked.margin());
          }
        }
        EXPECT_GT(at_home, 3000);
      };
      walk(Ellipse::through_intercepts(0.6), Radial{});
      walk(Ellipse::through_intercepts(0.6), ClosestPoint{});
      // Which knows beforehand where to begin a search, too, or that there is nowhere.
      walk(table, ClosestPoint{});
    }
  }
}

// Not in one step, but by many small ones.
TEST(Home, DoesNotLeadBeyondTheFarthest) {
  auto finger = hertz_finger();
  const double farthest = decltype(finger)::farthest;
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = farthest - 20.0 + 0.04 * i;
    const Contact contact = on_plane(x, 0.0, 0.002);
    const bool is_far = x * x + contact.depth * contact.depth > farthest * farthest;
    EXPECT_EQ(finger.update(contact, 0.0).state == ContactState::invalid, is_far) << x;
    refused += is_far;
  }
  EXPECT_GT(refused, 400);
}

// Another finger's state may be restored, and what is at home there may be a leap here.
TEST(Home, IsNotAnotherFingers) {
  auto wide = hertz_finger();
  FingerParameters with = parameters();
  with.jump_limit = 0.01;
  auto narrow = hertz_finger(with);
  for (const double x : {0.0, 0.001}) wide.update(on_plane(x, 0.0, 0.002), 0.0);
  ASSERT_TRUE(wide.state().has_home());
  narrow.restore(wide.state());
  EXPECT_EQ(narrow.update(on_plane(0.05, 0.0, 0.002), 0.0).state, ContactState::invalid);
  EXPECT_EQ(wide.update(on_plane(0.05, 0.0, 0.002), 0.0).state, ContactState::slip);
}

// With dampers, or a radius that depends on the load, there is more to ask.
TEST(Home, IsOnlyWhereLittleIsAsked) {
  FingerParameters damped = parameters();
  damped.damping = 1.0;
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  for (const FingerParameters& with : {damped, soft}) {
    auto finger = hertz_finger(with);
    for (const double x : {0.0, 0.001}) finger.update(on_plane(x, 0.0, 0.002), 0.0, 1e-3);
    EXPECT_FALSE(finger.state().has_home());
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
