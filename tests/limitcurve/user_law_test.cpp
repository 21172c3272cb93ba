// SPDX-License-Identifier: MIT
// Laws of a user's own: what they need, and what becomes of one that does not keep its promises.
#include "tests/function_law.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test::own_law_test {
namespace {

constexpr std::array<double, 15> cors{0.0, 1e-6, 0.1, 0.31, 0.37, 0.5, 0.62, 0.75, 0.9, 1.0, 1.1, 2.0, 30.0, 1e6, inf};

/// Pressures of discs on each other, each a law of one piece: a sum with a kink, a jump or a
/// singular ring at each radius, whose wrench is known in closed form.
struct Discs {
  std::string name;
  Law kind;
  std::vector<double> radii;   ///< the largest is 1
  std::vector<double> shares;  ///< of the load; sum 1

  [[nodiscard]] Extended pressure(Extended rho) const {
    Extended sum = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const Extended at = rho / radii[i];
      if (at > 1) continue;
      const Extended steep = kind->rim_exponent() == 0 ? 1 : std::pow(1 - at, kind->rim_exponent());
      sum += shares[i] / (Extended(radii[i]) * radii[i]) * kind->density(RadialPosition<Extended>{at, 1 - at}) * steep;
    }
    return sum;
  }
  [[nodiscard]] UnitWrench wrench(double s) const {
    UnitWrench sum{};
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const UnitWrench one = kind->evaluate(s / radii[i]).wrench;
      sum.force += shares[i] * one.force;
      sum.moment += shares[i] * radii[i] * one.moment;
    }
    return sum;
  }
  /// The law, told of its radii or not.
  [[nodiscard]] Law law(bool told) const {
    std::vector<Extended> breaks{0, 1};
    if (told) breaks.insert(breaks.end(), radii.begin(), radii.end());
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return std::make_shared<FunctionLaw>(
        name, [*this](Extended rho) { return pressure(rho); }, breaks);
  }
};

/// `evaluate` is finite, possible, and off by no more than it says.
void expect_honest(const Law& law, const Discs& truth) {
  SCOPED_TRACE(law->name());
  for (const double s : cors) {
    const UnitWrench exact = truth.wrench(s);
    const WrenchEstimate found = law->evaluate(s);
    EXPECT_TRUE(are_near(found.wrench, exact,
                         {found.error.force + 1e-15 * exact.force, found.error.moment + 1e-15 * exact.moment}))
        << s;
    EXPECT_TRUE(found.wrench.force <= 1.0 && found.wrench.moment <= 1.0) << s;
    const UnitForces<double> quick = law->forces(s);
    EXPECT_FALSE(std::isnan(quick.force + quick.moment)) << s;
  }
}

/// The same of a table, or it is refused by name.
void expect_honest_table(const Law& law, const Discs& truth, double tolerance) {
  try {
    const Table table = Table::build(law, tolerance);
    for (double s = 1e-3; s < 1e3; s *= 1.02) {
      ASSERT_LE(apart(table.wrench(SlipTwist::about_cor(s)), truth.wrench(s)), table.checked_error())
          << law->name() << ' ' << s;
    }
  } catch (const std::exception& error) {
    expect_mention(error.what(), law->name());
  }
}

std::vector<Discs> discs() {
  return {{"a kink", parabolic(), {0.371, 1.0}, {0.3, 0.7}},
          {"kinks", parabolic(), {0.31, 0.47, 0.62, 0.83, 1.0}, {0.2, 0.2, 0.2, 0.2, 0.2}},
          {"a steep kink", hertz(), {0.5, 1.0}, {0.5, 0.5}},
          {"a jump", uniform(), {1.0 / 3.0, 1.0}, {0.3, 0.7}},
          {"a jump near the rim", uniform(), {0.999, 1.0}, {0.5, 0.5}},
          {"a narrow peak", uniform(), {1e-4, 1.0}, {0.1, 0.9}},
          {"a flat punch inside", flat_punch(), {0.7, 1.0}, {1.0, 0.0}},
          {"a flat punch within another", flat_punch(), {0.7, 1.0}, {0.5, 0.5}}};
}

TEST(OwnLaw, ThatListsItsKinksAndJumpsIsExact) {
  for (const Discs& truth : discs()) {
    const Law law = truth.law(true);
    expect_honest(law, truth);
    if (truth.kind->rim_exponent() != 0) continue;  // beside a singular ring digits are lost
    for (const double s : cors) {
      const WrenchEstimate found = law->evaluate(s);
      EXPECT_LE(std::max(found.error.force, found.error.moment), accuracy::evaluate_by_quadrature)
          << truth.name << ' ' << s;
    }
  }
}

TEST(OwnLaw, ThatHidesThemIsRefusedOrSaysALargerError) {
  for (const Discs& truth : discs()) {
    expect_honest(truth.law(false), truth);
    for (const double tolerance : {1e-2, 1e-5}) expect_honest_table(truth.law(false), truth, tolerance);
  }
}

/// The same with kinks, jumps and rings at random, some of which the law tells.
TEST(OwnLaw, ThatHidesSomethingAtRandomIsRefusedOrSaysALargerError) {
  for (int i = 0; i < study_cases(400, 20); ++i) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(i));
    std::uniform_real_distribution<double> uniformly(0.0, 1.0);
    Discs truth{"case " + std::to_string(i), i % 3 == 0 ? parabolic() : i % 3 == 1 ? uniform() : hertz(), {1.0}, {1.0}};
    for (int k = i % 4; k >= 0; --k) {
      const double share = 0.5 * uniformly(generator);
      for (double& other : truth.shares) other *= 1.0 - share;
      truth.radii.push_back(std::pow(uniformly(generator), 1.0 + i % 5));
      truth.shares.push_back(share);
    }
    expect_honest(truth.law(false), truth);
  }
}

/// Pressures that are invalid: `evaluate` never has a NaN, and says that it knows nothing; curves and
/// tables refuse them.
TEST(OwnLaw, WithoutASensiblePressureIsRefused) {
  constexpr Extended not_a_number = std::numeric_limits<Extended>::quiet_NaN();
  const std::vector<Extended> whole{0, 1};
  const std::vector<std::pair<const char*, std::function<Extended(Extended)>>> pressures{
      {"twice the load", [](Extended) { return 2; }},
      {"nothing", [](Extended) { return 0; }},
      {"not a number", [](Extended) { return not_a_number; }},
      {"not a number in a ring", [](Extended rho) { return rho > 0.5L && rho < 0.6L ? not_a_number : 1; }},
      {"infinite", [](Extended) { return std::numeric_limits<Extended>::infinity(); }},
      {"huge", [](Extended) { return std::numeric_limits<Extended>::max(); }},
      {"negative in a ring", [](Extended rho) { return rho > 0.5L && rho < 0.6L ? -1 : 1; }},
      {"infinite load", [](Extended rho) { return std::pow(1 - rho * rho, -1); }},
      {"noise", [](Extended rho) { return std::sin(1e9L * rho) > 0 ? 2 : 0; }},
  };
  for (const auto& [name, pressure] : pressures) {
    const Law law = std::make_shared<FunctionLaw>(name, pressure, whole);
    for (const double s : cors) {
      const WrenchEstimate found = law->evaluate(s);
      EXPECT_TRUE(found.wrench.force >= 0.0 && found.wrench.force <= 1.0 && found.wrench.moment >= 0.0 &&
                  found.wrench.moment <= 1.0)
          << name << s;
      if (s < inf) {
        EXPECT_TRUE(found.error.force > 1e-4 && found.error.force <= 1.01) << name << ' ' << found.error.force;
      }
    }
    EXPECT_THROW(ExactCurve{law}, std::invalid_argument) << name;
    EXPECT_THROW(Table::build(law, 1e-2), std::invalid_argument) << name;
  }
  for (const std::vector<Extended>& breaks :
       std::vector<std::vector<Extended>>{{}, {0}, {0.1L, 1}, {0, 1, 0.5L}, {0, 0, 1}, {0, not_a_number}}) {
    const Law law = std::make_shared<FunctionLaw>(
        "bad breaks", [](Extended) { return 1; }, breaks);
    EXPECT_THROW(ExactCurve{law}, std::invalid_argument) << breaks.size();
  }
}

/// Singular ones in the usual form, computed without the distance from the rim.
TEST(OwnLaw, ThatComputesItsRimFromTheRadiusSaysWhatItLost) {
  const Discs punch{"", flat_punch(), {1.0}, {1.0}};
  for (const Extended soft : {0.0L, 1e-24L, 1e-12L}) {
    const auto pressure = [soft](Extended rho) { return 0.5L * std::pow((1 - rho * rho) + soft, -0.5L); };
    const Law law =
        std::make_shared<FunctionLaw>("softened by " + std::to_string(soft), pressure, std::vector<Extended>{0, 1});
    for (const double s : cors) {
      const WrenchEstimate found = law->evaluate(s);
      // By how much the softened pressure is another one: less than √soft. The reference is rounded to double.
      const double meant = std::sqrt(static_cast<double>(soft)) + std::numeric_limits<double>::epsilon() / 2;
      EXPECT_TRUE(are_near(found.wrench, punch.wrench(s), {found.error.force + meant, found.error.moment + meant}))
          << s;
    }
  }
}

}  // namespace
}  // namespace limitcurve::test::own_law_test
