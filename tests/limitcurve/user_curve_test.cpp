// SPDX-License-Identifier: MIT
// A user's own limit curve and law as a table: what is no limit curve is refused with the requirement that it breaks.

#include "tests/function_law.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

/// Any function of the slip twist s : 1 or 1 : s.
struct Own {
  std::function<UnitWrench(double slide, double spin)> function;
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const { return function(twist.slide, twist.spin); }
};

/// The ellipse x² + (y/b)² = 1 by its support function.
UnitWrench ellipse(double v, double w, double b) {
  const double size = std::hypot(v, b * w);
  return {v / size, b * b * w / size};
}

TEST(OwnCurve, IsATable) {
  const Table table = Table::build(Own{[](double v, double w) { return ellipse(v, w, 0.6); }}, 1e-10, {.name = "mine"});
  EXPECT_NEAR(table.wrench({0.5, 1.0}).force, ellipse(0.5, 1.0, 0.6).force, 1e-10);
}

TEST(OwnCurve, IsToldWhichRequirementItBreaks) {
  const std::pair<std::function<UnitWrench(double, double)>, std::string> wrong[] = {
      {[](double v, double w) {
         return v > 0.4 ? UnitWrench{nan, 0.1} : ellipse(v, w, 0.6);
       },
       "is not a finite number >= 0"},
      {[](double v, double w) {
         return UnitWrench{ellipse(v, w, 0.6).force, -ellipse(v, w, 0.6).moment};
       },
       "is not a finite number >= 0"},
      {[](double v, double w) {
         return v > w ? UnitWrench{1.0, 0.3} : UnitWrench{0.4, 0.9};
       },
       "corner"},
      // An ellipse and a segment: its direction is a flat face.
      {[](double v, double w) {
         const UnitWrench round = ellipse(v, w, 0.6);
         return v > w ? UnitWrench{round.force + 0.3, round.moment} : UnitWrench{round.force, round.moment + 0.3};
       },
       "flat face"},
      {[](double v, double w) {
         return UnitWrench{std::pow(v / (v + w), 2.0), 0.6 * std::pow(w / (v + w), 2.0)};
       },
       "does more work"},
      // By the ray in place of the normal.
      {[](double v, double w) {
         return UnitWrench{v / std::hypot(v, w / 0.6), w / std::hypot(v, w / 0.6)};
       },
       "does more work"},
  };
  for (const auto& [function, why] : wrong) {
    const std::string said = complaint([&, &curve = function] { Table::build(Own{curve}, 1e-6, {.name = "mine"}); });
    expect_mention(said, why);
    expect_mention(said, "mine");
  }
}

TEST(OwnLaw, TakesOptions) {
  const Law ring = std::make_shared<FunctionLaw>(
      "ring", [](Extended rho) { return 2 * rho * rho; }, std::vector<Extended>{0, 1});
  EXPECT_LE(Table::build(ring, 1e-8, {.preferred_bytes = 8192}).bytes(), 8192U);
}

}  // namespace

}  // namespace limitcurve::test
