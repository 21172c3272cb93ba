// SPDX-License-Identifier: MIT
#include "limitcurve/patch/patch_table.hpp"

#include "limitcurve/patch/half_spaces.hpp"
#include "patch_reference.hpp"
#include "tests/limitcurve/shared.hpp"

/// Tables of patches against the patches, whose own tests compare them with independent sums.
namespace limitcurve {

namespace {

/// A twist with its rotation as speed m₀ω.
struct Twist {
  double vx, vy, spin;
  [[nodiscard]] PatchTwist of(const Patch& patch) const { return {vx, vy, spin / patch.moment_ratio()}; }
};

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(bits_); }
  double normal() { return std::normal_distribution<double>()(bits_); }
  std::size_t below(std::size_t count) { return bits_() % count; }
  /// Anywhere, often near an edge of the cube of twists, where tables of faces meet.
  Twist twist() {
    Twist t{normal(), normal(), normal()};
    const double size = std::max({std::fabs(t.vx), std::fabs(t.vy), std::fabs(t.spin)});
    std::array<double, 3> q{t.vx / size, t.vy / size, t.spin / size};
    if (below(2) == 0) {
      const std::size_t one = below(3);
      q[one] = std::copysign(1.0, q[one]);
      q[(one + 1) % 3] = std::copysign(1.0 - std::pow(10.0, uniform(-12.0, -1.0)), q[(one + 1) % 3]);
    }
    return {q[0], q[1], q[2]};
  }

 private:
  std::mt19937_64 bits_;
};

/// A camera's image of a contact: a cap that is cut off at 0, with noise of the sensor.
Patch camera_image(Random& random) {
  const auto columns = 8 + random.below(20);
  const auto rows = 8 + random.below(20);
  std::vector<double> pressures;
  const double exponent = random.uniform(0.3, 2.0);
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const double x = (static_cast<double>(i % columns) + 0.5) / static_cast<double>(columns) - 0.5;
    const double y = (static_cast<double>(i / columns) + 0.5) / static_cast<double>(rows) - 0.5;
    const double cap = std::pow(std::max(0.0, 1.0 - 5.0 * x * x - 6.0 * y * y - 2.0 * x * y), exponent);
    pressures.push_back(std::max(0.0, cap + 0.01 * random.normal()));
  }
  return Patch::image(pressures, columns, 0.0005);
}

Patch random_patch(Random& random) {
  const double x = random.uniform(0.004, 0.02);
  const double y = random.uniform(0.004, 0.02);
  const std::vector<PatchPoint> pad{{0, 0}, {x, 0.1 * y}, {1.1 * x, y}, {0.4 * x, 0.5 * y}, {0.1 * x, y}};
  const auto law = [&]() -> Law {
    const std::vector<std::string> laws{"hertz", "uniform", "parabolic", "cone", "power:n=2.3", "gaussian:sigma=0.4"};
    return parse_law(laws[random.below(laws.size())]);
  };
  switch (random.below(5)) {
    case 0:
      return Patch::rectangle(x, y);
    case 1:
      return Patch::polygon(pad);
    case 2:
      return Patch::ellipse(law(), x, y);
    case 3:
      return Patch::rectangle(x, y).orthotropic(random.uniform(0.7, 1.4), random.uniform(0.7, 1.4));
    default:
      return camera_image(random);
  }
}

/// The largest of |ΔF| and |ΔM|/m₀.
double apart(const Patch& one, const Patch& other, const Twist& twist) {
  return test::difference(one.wrench(twist.of(one)), other.wrench(twist.of(one)), one.moment_ratio());
}

/// The finest tolerance that the refusal of `build` names; 0 if it names none.
double named_tolerance(const Patch& patch, double refused) {
  const std::string text = test::complaint([&] { (void)PatchTable::build(patch, refused); });
  if (text == "none") return refused;
  const std::size_t end = text.find(" or more");
  return end == std::string::npos ? 0.0 : std::stod(text.substr(text.rfind(' ', end - 1)));
}

TEST(PatchTable, ItsErrorIsAtMostTheCheckedOneAndItIsMonotone) {
  Random random(7);
  for (int i = 0; i < 12; ++i) {
    const Patch patch = random_patch(random);
    for (const double tolerance : {1e-2, 1e-3}) {
      const PatchTable table = PatchTable::build(patch, tolerance);
      EXPECT_LE(table.checked_error(), tolerance);
      EXPECT_LE(table.bytes(), PatchTable::most_bytes);
      double worst = 0.0;
      for (int k = 0; k < 2000; ++k) worst = std::max(worst, apart(patch, table, random.twist()));
      EXPECT_LE(worst, table.checked_error()) << i;
      for (int k = 0; k < 4000; ++k) {
        const Twist a = random.twist();
        const double step = std::pow(10.0, random.uniform(-8.0, -2.0));
        const Twist d{step * random.normal(), step * random.normal(), step * random.normal()};
        const Twist b{a.vx + d.vx, a.vy + d.vy, a.spin + d.spin};
        const PatchWrench from = table.wrench(a.of(table));
        const PatchWrench to = table.wrench(b.of(table));
        const double rise = (to.fx - from.fx) * d.vx + (to.fy - from.fy) * d.vy +
                            (to.moment - from.moment) / table.moment_ratio() * d.spin;
        EXPECT_GE(rise, -1e-14 * step) << i << ' ' << step;
      }
    }
  }
}

TEST(PatchTable, TheWrenchIsContinuousWhereFacesMeet) {
  Random random(8);
  const PatchTable table = PatchTable::build(Patch::rectangle(0.01, 0.02), 0.05);
  for (int i = 0; i < 20'000; ++i) {
    const std::size_t axis = random.below(3);
    std::array<double, 3> q{};
    q[axis] = 1.0;
    q[(axis + 1) % 3] = random.below(2) == 0 ? 1.0 : -1.0;
    q[(axis + 2) % 3] = i % 10 == 0 ? q[axis] : random.uniform(-1.0, 1.0);
    std::array<double, 3> r = q;
    constexpr double step = 1e-9;
    q[axis] += step;
    r[(axis + 1) % 3] *= 1.0 + step;
    EXPECT_LE(apart(table, table, {q[0], q[1], q[2]}), 0.0);
    EXPECT_LE(test::difference(table.wrench(Twist{q[0], q[1], q[2]}.of(table)),
                               table.wrench(Twist{r[0], r[1], r[2]}.of(table)), table.moment_ratio()),
              1e-7);
  }
}

TEST(PatchTable, SlidesAlongTheAxesAndAPureSpinAreExact) {
  Random random(9);
  for (int i = 0; i < 5; ++i) {
    const Patch patch = random_patch(random);
    const PatchTable table = PatchTable::build(patch, 1e-2);
    for (const Twist& twist : {Twist{1, 0, 0}, Twist{0, -2, 0}, Twist{0, 0, 1}, Twist{0, 0, -0.1}})
      EXPECT_LE(apart(patch, table, twist), 1e-14);
    EXPECT_EQ(table.moment_ratio(), patch.moment_ratio());
    EXPECT_EQ(table.radius(), patch.radius());
    EXPECT_EQ(table.factors().x, patch.factors().x);
  }
}

TEST(PatchTable, WhatTakesAPatchTakesATable) {
  const Patch patch = Patch::ellipse(parse_law("power:n=2.3"), 0.004, 0.002);
  const PatchTable table = PatchTable::build(patch, 1e-4);
  Random random(10);
  for (int i = 0; i < 50; ++i) {
    const PatchWrench wrench{random.normal(), random.normal(), 1e-3 * random.normal()};
    const double exact = load_to_hold(patch, 0.6, wrench);
    EXPECT_NEAR(load_to_hold(table, 0.6, wrench), exact, 3e-4 * exact);
    const PatchSlip slip = table.slip(wrench);
    const PatchSlip expected = patch.slip(wrench);
    EXPECT_NEAR(slip.gauge, expected.gauge, 3e-4 * expected.gauge);
    EXPECT_LE(slip.error, 2e-4);
    EXPECT_GE(slip.error, table.checked_error());
  }
  EXPECT_EQ(half_spaces(table, 14).rows.size(), half_spaces(patch, 14).rows.size());
  // Beside the origin, with other friction along x than along y.
  const Patch aside = Patch::polygon(std::array<PatchPoint, 4>{{{3, 1}, {5, 1}, {5, 2}, {3, 2}}}).orthotropic(2.0, 0.5);
  const PatchTable of_aside = read_patch_table_csv(to_csv(PatchTable::build(aside, 1e-3)), "aside.csv");
  EXPECT_EQ(of_aside.centre().x, aside.centre().x);
  EXPECT_EQ(of_aside.centre().y, aside.centre().y);
  for (int i = 0; i < 50; ++i) {
    const PatchTwist twist = random.twist().of(aside);
    const PatchFriction found = of_aside.about_origin(twist);
    EXPECT_LE(test::difference(found.wrench, aside.about_origin(twist).wrench, aside.moment_ratio()), found.error);
    const PatchWrench wrench{random.normal(), random.normal(), random.normal()};
    const double exact = load_to_hold(aside, 0.6, wrench);
    EXPECT_NEAR(load_to_hold(of_aside, 0.6, wrench), exact, 3e-3 * exact);
  }
}

TEST(PatchTable, RefusesPointsAndToleranceByName) {
  const std::vector<PatchLoad> loads{{-0.04, -0.04, 1}, {0.04, -0.02, 2}, {-0.04, 0.08, 1}};
  EXPECT_EQ(named_tolerance(Patch::points(loads), 1e-2), 0.0) << "no tolerance is possible";
  EXPECT_EQ(named_tolerance(Patch::points(loads).smoothed(0.01), 1e-3), 1e-3);
  EXPECT_THROW((void)PatchTable::build(Patch::points(std::vector<PatchLoad>{{0, 0, 1}}), 1e-2), std::invalid_argument);
  EXPECT_THROW((void)PatchTable::build(Patch::rectangle(1, 1), 0.2), std::invalid_argument);
  EXPECT_THROW((void)PatchTable::build(Patch::rectangle(1, 1), test::nan), std::invalid_argument);
  // The tolerance that a refusal names is possible.
  const Patch pixel = Patch::image(std::vector{3.0}, 1, 0.001);
  for (const auto& [patch, tolerance] : {std::pair(Patch::rectangle(0.1, 0.01), 2e-5), {pixel, 5e-3}}) {
    const double named = named_tolerance(patch, tolerance);
    EXPECT_GT(named, tolerance);
    EXPECT_LE(PatchTable::build(patch, named).checked_error(), named);
  }
  test::expect_mention(test::complaint([&] { (void)PatchTable::build(pixel, 5e-3); }),
                       "or coarse pixels allow no less");
}

TEST(PatchTable, FilesKeepEveryBitAndSayWhereTheyAreWrong) {
  const PatchTable table = PatchTable::build(Patch::rectangle(0.02, 0.01).orthotropic(0.5, 1.5), 0.03, "a, \"pad\"");
  const std::string text = to_csv(table);
  const PatchTable again = read_patch_table_csv(text, "t.csv");
  EXPECT_EQ(to_csv(again), text);
  EXPECT_EQ(again.checked_error(), table.checked_error());
  Random random(11);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(apart(table, again, random.twist()), 0.0);
  const auto refused = [](const std::string& file, const char* told) {
    test::expect_mention(test::complaint([&] { (void)read_patch_table_csv(file, "t.csv"); }), told);
  };
  std::string edited = text;
  edited[edited.rfind('3')] = '4';
  refused(edited, "t.csv: the table was edited or damaged");
  refused(text.substr(0, text.size() / 2), "t.csv:");
  refused("x,y\n1,2\n", "t.csv:1:1: not a table");
  refused("", "t.csv:1:1: not a table");
  // Contents that no patch has: a look-up would leave the nodes, or find a load of 0.
  const auto no_table = [&](const char* told, const auto& change) {
    PatchTableContents contents = table.contents();
    change(contents);
    test::expect_mention(test::complaint([&] { (void)PatchTable(contents); }), told);
  };
  no_table("moment_ratio = nan", [](PatchTableContents& of) { of.moment_ratio = test::nan; });
  no_table("my = 0", [](PatchTableContents& of) { of.factors.y = 0.0; });
  no_table("centre_x = inf", [](PatchTableContents& of) { of.centre.x = test::inf; });
  for (const double power : {-1.0, 0.0, test::nan})
    no_table("expected finite numbers and a power > 0", [&](PatchTableContents& of) { of.nodes[7][0] = power; });
  no_table("expected finite numbers", [](PatchTableContents& of) { of.nodes.back()[2] = test::inf; });
}

}  // namespace

}  // namespace limitcurve
