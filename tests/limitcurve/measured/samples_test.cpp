// SPDX-License-Identifier: MIT
#include "limitcurve/measured/samples.hpp"
#include "limitcurve/measured/hold_error.hpp"
#include "limitcurve/measured/own_radii.hpp"
#include "limitcurve/quadrature/evaluators.hpp"
#include "tests/function_law.hpp"
#include "tests/limitcurve/counted_law.hpp"
#include "tests/limitcurve/table_errors.hpp"

namespace limitcurve {
namespace {

constexpr std::array<double, 12> cors{0.0, 1e-6, 0.1, 0.37, 0.5, 0.75, 0.9, 1.0, 1.1, 2.0, 30.0, 1e6};

double hertz_pressure(double r) {
  return r < 1.0 ? std::sqrt((1.0 - r) * (1.0 + r)) : 0.0;
}

/// Unevenly spaced samples of a profile, the radii in millimetres and the pressures in any unit.
template <class Profile>
std::vector<PressureSample> sampled(Profile&& profile, std::size_t count, double noise) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> error(0.0, 1.0);
  std::vector<PressureSample> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double even = static_cast<double>(i) / static_cast<double>(count - 1);
    const double radius = even + 0.05 * std::sin(3.0 * 3.14159265358979 * even) / 3.0;
    result.push_back(
        {4.2 * radius, 17.0 * profile(std::min(radius, 1.0)) + (noise > 0.0 ? noise * error(random) : 0.0)});
  }
  return result;
}

void expect_within_stated_error(const PressureLaw& law, const PressureLaw& truth, double largest_error) {
  for (const double s : cors) {
    const WrenchEstimate estimate = law.evaluate(s);
    const WrenchEstimate exact = truth.evaluate(s);
    EXPECT_TRUE(test::are_near(estimate.wrench, exact.wrench,
                               {estimate.error.force + exact.error.force, estimate.error.moment + exact.error.moment}))
        << "s = " << s;
    EXPECT_LE(estimate.error.moment, largest_error);
  }
}

TEST(Samples, TwoHundredOfAHertzProfileAreHertzWithinTheirStatedError) {
  const Law law = samples(sampled(hertz_pressure, 200, 0.0), "hertz.csv");
  expect_within_stated_error(*law, *hertz(), 5e-4);
}

// The contact ends where its pressure does: a sensor's line goes on with rows of zero, or of noise below it.
TEST(Samples, RowsWithoutPressureAtTheEndAreNoContact) {
  const std::vector<PressureSample> profile = sampled(hertz_pressure, 50, 0.0);
  const double end = profile.back().radius;
  std::vector<PressureSample> jump = profile;
  jump.back().pressure = jump[jump.size() - 2].pressure;
  std::vector<PressureSample> jump_to_zero = jump;
  jump_to_zero.push_back({end, 0.0});
  for (const auto& [contact, law] :
       {std::pair(profile, samples(profile, "hertz.csv")), std::pair(jump_to_zero, samples(jump, "cut.csv"))}) {
    for (const double pressure : {0.0, -1e-3}) {
      for (const double far : {1.1, 4.0}) {
        std::vector<PressureSample> longer = contact;
        longer.insert(longer.end(), {{1.05 * end, pressure}, {far * end, pressure}});
        const Law same = samples(longer, "tail.csv");
        for (const double s : {0.0, 0.5, 1.0, 3.0}) {
          EXPECT_EQ(same->forces(s).moment, law->forces(s).moment);
          EXPECT_EQ(same->evaluate(s).error.force, law->evaluate(s).error.force);
        }
      }
    }
  }
  const std::vector<std::vector<PressureSample>> none{{{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                                                      {{0, 1}, {0, 0}, {1, 0}, {2, 0}}};
  for (const auto& one : none) EXPECT_THROW(samples(one, "none.csv"), std::invalid_argument);
  // Up to the first radius the pressure is that of its first sample: a disc, whose rim may be named farther out.
  const std::vector<PressureSample> step{{4.0, 1.0}, {4.0, 0.0}, {6.0, 0.0}, {8.0, 0.0}};
  EXPECT_EQ(samples(step, "step.csv")->rim(), 4.0);
  for (const double rim : {4.0, 8.0}) {
    const auto [wrench, error, slope] = samples(step, "step.csv", rim)->evaluate(0.7);
    const WrenchEstimate disc = uniform()->evaluate(0.7 * rim / 4.0);
    EXPECT_LE(test::apart(wrench, UnitWrench{disc.wrench.force, disc.wrench.moment * 4.0 / rim}), 1e-14) << rim;
    EXPECT_LE(error.force + error.moment, 1e-12) << rim;
  }
}

/// p = 1 on b ≤ ρ ≤ 1: the uniform disc less a smaller one, by linearity.
UnitWrench annulus(double b, double s) {
  const WrenchEstimate whole = uniform()->evaluate(s);
  const WrenchEstimate hole = uniform()->evaluate(s / b);
  const double share = b * b;
  return {(whole.wrench.force - share * hole.wrench.force) / (1.0 - share),
          (whole.wrench.moment - share * b * hole.wrench.moment) / (1.0 - share)};
}

TEST(Samples, ARingWithSharpEdgesIsExact) {
  // Jumps are samples that share a radius: nothing is interpolated across them.
  const std::array<PressureSample, 6> profile{{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}, {3.0, 3.0}, {4.0, 3.0}}};
  const Law law = samples(profile, "ring.csv");
  for (const double s : cors) {
    const WrenchEstimate estimate = law->evaluate(s);
    constexpr double bound = accuracy::has_extended ? 1e-15 : accuracy::evaluate_by_quadrature;
    EXPECT_LE(test::apart(estimate.wrench, annulus(0.5, s)), bound) << s;
    EXPECT_LE(estimate.error.force, bound);
  }
}

TEST(Samples, OfAFormulaAreExactWhereTheirRadiiCrowdAtTheRim) {
  constexpr int last = 5000;
  const auto worst = [](auto radius_of) {
    std::vector<PressureSample> rows;
    for (int i = 0; i <= last; ++i) {
      const double radius = i < last ? radius_of(i) : 1.0;
      rows.push_back({radius, hertz_pressure(radius)});
    }
    const Law law = samples(rows, "formula.csv");
    double error = 0.0;
    for (const double s : cors)
      error = std::max(error, test::apart(law->evaluate(s).wrench, hertz()->evaluate(s).wrench));
    return error;
  };
  EXPECT_LT(worst([](int i) { return std::sin(i * 3.14159265358979324 / (2 * last)); }), 5.1e-13);
  EXPECT_NEAR(worst([](int i) { return static_cast<double>(i) / last; }), 6e-7, 0.3e-7);
}

// Every second sample has no pressure at all.
TEST(Samples, ARingOfOneSampleHasAnError) {
  const auto [wrench, error, slope] =
      samples(std::array<PressureSample, 7>{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 5}, {5, 0}, {6, 0}}}, "ring.csv")
          ->evaluate(0.0);
  for (const double mean_radius : {4.0, 4.0 + 1.0 / 24.0}) EXPECT_NEAR(wrench.moment, mean_radius / 5.0, error.moment);
  EXPECT_LT(error.moment, 0.5);
}

TEST(Samples, NoiseEntersTheStatedError) {
  // In proportion to the pressure: a sensor that clips noise at 0 adds load at the rim, which no sample tells.
  std::vector<PressureSample> rows = sampled([](double) { return 1.0; }, 150, 0.2);
  for (PressureSample& row : rows) row.pressure *= std::max((1.0 - row.radius / 4.2) * (1.0 + row.radius / 4.2), 0.0);
  const Law law = samples(rows, "noisy.csv");
  for (const double s : {0.3, 1.0, 2.0}) {
    const auto [wrench, error, slope] = law->evaluate(s);
    EXPECT_NEAR(wrench.moment, parabolic()->evaluate(s).wrench.moment, error.moment);
    EXPECT_LT(error.moment, 2e-2);
  }
}

// Once every row twice gave m₀ = 0.58031 ± 2.6e-16 where once gives 0.58392 ± 0.031 (truth 0.58905).
TEST(Samples, RowsThatSayTheSameTwiceAreNoJump) {
  std::vector<PressureSample> once;
  for (int i = 0; i <= 10; ++i) once.push_back({0.1 * i, std::sqrt(std::max(0.0, 1.0 - 0.01 * i * i))});
  const Law law = samples(once, "once.csv");
  for (const std::size_t times : {2U, 3U}) {
    std::vector<PressureSample> rows;
    for (const PressureSample& row : once) rows.insert(rows.end(), times, row);
    const Law again = samples(rows, "again.csv");
    for (const double s : cors) {
      const WrenchEstimate one = law->evaluate(s);
      const WrenchEstimate other = again->evaluate(s);
      EXPECT_TRUE(one.wrench == other.wrench && one.error == other.error) << s;
    }
  }
}

// The same: a run of two samples stated no error at all.
TEST(Samples, ARunOfTwoSamplesHasAnErrorToo) {
  // Each radius is measured twice with slightly different values: only jumps, and two samples between them.
  std::vector<PressureSample> rows;
  for (int i = 0; i <= 10; ++i) {
    const double pressure = std::sqrt(std::max(0.0, 1.0 - 0.01 * i * i));
    rows.push_back({0.1 * i, pressure + 1e-9});
    if (i > 0 && i < 10) rows.push_back({0.1 * i, pressure});
  }
  expect_within_stated_error(*samples(rows, "twice.csv"), *hertz(), 0.14);
  // Two samples on either side of a jump.
  const std::array<PressureSample, 4> jump{{{0.0, 2.0}, {0.5, 1.5}, {0.5, 1.0}, {1.0, 0.0}}};
  const auto curved = [](Extended r) { return r < 0.5 ? 2.0 - 2.0 * r * r : 2.0 - r * (1.0 + r); };
  expect_within_stated_error(*samples(jump, "jump.csv"), *test::law_of_function("curved", curved, {0, 0.5L, 1}), 0.65);
  const auto early = [](Extended r) { return r < 0.5 ? (r < 0.01 ? 2.0 : 1.5) : (r < 0.51 ? 1.0 : 1e-9); };
  expect_within_stated_error(*samples(jump, "jump.csv"),
                             *test::law_of_function("early", early, {0, 0.01L, 0.5L, 0.51L, 1}), 0.65);
}

/// A sensor's line of 53 rows to 26 mm, over a Hertz contact of 6 mm with a peak of 1.
std::vector<PressureSample> sensor_line() {
  std::vector<PressureSample> rows;
  for (int i = 0; i <= 52; ++i) rows.push_back({0.5 * i, hertz_pressure(0.5 * i / 6.0)});
  return rows;
}

// With last radius and rim one, a sample of 1e-6 of the load at 20 mm moved a grip from 2.03 to 3.80 N.
TEST(Samples, ASampleChangesAWrenchByNoMoreThanItsShareOfTheLoadIfTheSizeIsNamed) {
  std::mt19937_64 random(2);
  const auto number = [&random] { return std::generate_canonical<double, 53>(random); };
  std::vector<PressureSample> offset = sensor_line();
  for (PressureSample& sample : offset) sample.pressure += 0.04 * offset[0].pressure;
  for (const Law& law : {samples(offset, "offset.csv"), with_own_radii(samples(offset, "offset.csv"))})
    test::expect_mention(law->remarks().front(), "a flat pressure in the outer tenth");
  const Law clean = samples(sensor_line(), "clean.csv", 6.0);
  const double mean = 6.0 * clean->moment_ratio();
  EXPECT_EQ(samples(sensor_line(), "clean.csv")->rim(), 6.0);
  for (int i = 0; i < 60; ++i) {
    std::vector<PressureSample> rows = sensor_line();
    const auto row = 13 + static_cast<std::size_t>(39.0 * number());
    rows[row].pressure = std::pow(10.0, -6.0 * number());
    const Law named = samples(rows, "named.csv", 6.0);
    const Law own = with_own_radii(samples(rows, "own.csv"));
    double share = 0.0;
    for (int k = 0; k < 20000; ++k) {
      const double rho = 1.0 + (k + 0.5) * 4e-4 / 2.0;
      share += 2.0 * rho * 2e-4 * named->density(RadialPosition<double>{rho, 1.0 - rho});
    }
    const double radius = rows[std::min<std::size_t>(row + 1, 52)].radius;
    for (const double c : {0.0, 0.3, 2.0, 6.0, 11.0, 20.0, 300.0}) {
      const UnitWrench before = clean->evaluate(c / 6.0).wrench;
      for (const auto& [law, unit] : {std::pair(named, 6.0), std::pair(own, own->rim())}) {
        const UnitWrench after = law->evaluate(c / unit).wrench;
        EXPECT_LE(std::fabs(after.force - before.force), 1.001 * share + 1e-12) << row << ' ' << c;
        EXPECT_LE(std::fabs(unit * after.moment - 6.0 * before.moment), 1.001 * share * std::max(radius, mean) + 1e-12)
            << row << ' ' << c;
      }
    }
  }
}

TEST(Samples, ARimThatIsTheLastRadiusChangesNothing) {
  const std::vector<PressureSample> rows = sampled(hertz_pressure, 40, 0.0);
  const Law law = samples(rows, "hertz.csv");
  const Law named = samples(rows, "hertz.csv", rows.back().radius);
  EXPECT_EQ(samples(rows, "hertz.csv", 4.5)->name(), "samples:hertz.csv,rim=4.5");
  for (const double s : cors) EXPECT_EQ(named->evaluate(s).wrench, law->evaluate(s).wrench);
  // A rim elsewhere is another unit of length, no more.
  for (const double factor : {0.4, 3.0}) {
    const Law scaled = samples(rows, "hertz.csv", factor * rows.back().radius);
    for (const double s : cors) {
      const UnitWrench expected = law->evaluate(s).wrench;
      const WrenchEstimate found = scaled->evaluate(s / factor);
      EXPECT_NEAR(found.wrench.force, expected.force, 1e-14);
      EXPECT_NEAR(factor * found.wrench.moment, expected.moment, 1e-14);
      EXPECT_NEAR(found.error.force, law->evaluate(s).error.force, 1e-12);
    }
    EXPECT_LE(Table::build(scaled, 1e-6).checked_error(), 1e-6 * std::max(1.0, scaled->moment_ratio()));
  }
}

TEST(Samples, SignedNoiseTellsItsOwnSize) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> error(0.0, 1.0);
  int right = 0;
  constexpr int draws = 100;
  for (int i = 0; i < draws; ++i) {
    const double noise = std::array{5e-4, 2e-3, 5e-3}[static_cast<std::size_t>(i % 3)];
    std::vector<PressureSample> rows;
    for (int k = 0; k <= 520; ++k) rows.push_back({0.05 * k, hertz_pressure(0.05 * k / 6.0) + noise * error(random)});
    const Law law = samples(rows, "signed.csv");
    if (std::fabs(law->rim() - 6.0) < 0.11) ++right;
    ASSERT_FALSE(law->remarks().empty());
    test::expect_mention(law->remarks().front(), "count as 0");
    if (law->rim() < 6.2) {
      EXPECT_NEAR(law->rim() * law->moment_ratio() / (6.0 * 0.58904862254808621), 1.0, 5e-3);
    }
  }
  EXPECT_GE(right, 98);
}

TEST(Samples, SayWhatIsOddAboutThem) {
  const auto remark = [](const std::vector<PressureSample>& rows, double rim = 0.0) {
    std::string all;
    for (const std::string& line : samples(rows, "p.csv", rim)->remarks()) all += line + "\n";
    return all;
  };
  std::vector<PressureSample> rows = sensor_line();
  EXPECT_EQ(remark(rows), "");
  EXPECT_EQ(remark(rows, 6.0), "");
  rows[40].pressure = 0.004;
  test::expect_mention(remark(rows), "warning: p.csv: the mean radius of its load is 3.55,");
  test::expect_mention(remark(rows, 6.0), "note: p.csv: 0.447 % of the load and 2.49 % of the moment");
  test::expect_mention(remark(sensor_line(), 60.0), "warning: p.csv: from the last sample");
  EXPECT_EQ(remark({{0, 3}, {1, 2.5}, {2, 2}, {3, 1}, {4, 0}}),
            "note: p.csv: 5 samples are too few to estimate the error between them; expected 7 or more\n");
}

// A line across a ring that leaves out its hole, and one that ends before the rim, where a punch's pressure is
// unbounded.
TEST(Samples, WhatIsNotMeasuredIsInTheErrorOrSaid) {
  const Law ring = samples(sampled([](double rho) { return rho < 0.5 ? 0.0 : 1.0; }, 20, 0.0), "ring.csv");
  EXPECT_TRUE(ring->remarks().empty());
  std::vector<PressureSample> outside{{3, 1}, {3.5, 1}, {4, 1}, {4.5, 1}, {5, 1}, {5.5, 1}, {6, 1}};
  const std::vector<std::string> said = samples(outside, "ring.csv")->remarks();
  ASSERT_EQ(said.size(), 1U);
  test::expect_mention(said.front(), "25 % of the load: a contact with a hole needs samples of pressure 0");
  for (const int count : {8, 30, 100, 1000}) {
    std::vector<PressureSample> punch;
    for (int i = 0; i < count; ++i) {
      const double rho = static_cast<double>(i) / count;
      punch.push_back({6.0 * rho, 1.0 / std::sqrt(1.0 - rho * rho)});
    }
    const WrenchEstimate spin = samples(punch, "punch.csv", 6.0)->evaluate(0.0);
    EXPECT_LE(std::fabs(spin.wrench.moment - std::numbers::pi / 4.0), spin.error.moment) << count;
    EXPECT_LE(spin.error.moment, 5.0 * std::fabs(spin.wrench.moment - std::numbers::pi / 4.0)) << count;
  }
}

TEST(Samples, PureSlidingIsExactAndNoErrorExceedsWhatProfilesCanDiffer) {
  const std::array<PressureSample, 4> ring{{{0.0, 0.0}, {0.0599, 0.0}, {0.06, 1.0}, {0.065, 1.0}}};
  for (const Law& law : {samples(ring, "ring.csv"), samples(sampled(hertz_pressure, 30, 0.5), "noisy.csv")}) {
    const UnitWrench slide = law->evaluate(test::inf).error;
    EXPECT_LE(slide.force,
              accuracy::has_extended ? std::numeric_limits<double>::epsilon() : accuracy::evaluate_by_quadrature);
    EXPECT_LE(slide.moment, 1e-300);
    for (const double s : cors) {
      const WrenchEstimate estimate = law->evaluate(s);
      const UnitWrench rim{s < 1.0 ? s / 2.0 : 1.0 - 1.0 / (2.0 * s), 1.0};  // less and more than a ring at the rim has
      EXPECT_LE(estimate.error.force, std::min(1.0, 1.0 - 0.9 * rim.force) + 1e-15) << s;
      EXPECT_LE(estimate.error.moment, rim.moment + 1e-15) << s;
    }
  }
}

// Radii even, uneven, and close together at the centre but far apart at the rim: a narrow gap beside a wide one tells
// nothing about the wide one. In one of the first hundred the changes of load cancel: an estimate by their sum alone is
// 0.63 of the true error.
TEST(Samples, OfRandomLawsStateNoErrorBelowTheTrueOne) {
  std::mt19937_64 random(140);
  const auto number = [&random] { return std::generate_canonical<double, 53>(random); };
  for (int i = study_cases(9000, 100); i > 0; --i) {
    const double n = -0.5 + 3.5 * number();
    const Law truth = power(n);
    const auto count = static_cast<int>(std::lround(7.0 * std::pow(200.0 / 7.0, number())));
    const int spread = i % 4;
    std::vector<double> radii{0.0, 1.0};
    for (int k = 1; k < count - 1; ++k) {
      radii.push_back(std::array{static_cast<double>(k) / (count - 1), number(), number() * number(),
                                 std::pow(10.0, -4.0 * number())}[static_cast<std::size_t>(spread)]);
    }
    std::sort(radii.begin(), radii.end());
    std::vector<PressureSample> rows;
    for (const double r : radii) {
      if (!rows.empty() && r - rows.back().radius < 1e-4) continue;
      // A pressure that is infinite at the rim is measured within.
      const double measured = r == 1.0 && n < 0.0 ? 1.0 - 0.25 * (1.0 - rows.back().radius) : r;
      rows.push_back({r, std::pow((1.0 - measured) * (1.0 + measured), n)});
    }
    if (rows.size() < 7) continue;
    const Law law = samples(rows, "random.csv");
    for (const double s : {0.0, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 1.3, 3.0, 20.0}) {
      const WrenchEstimate estimate = law->evaluate(s);
      const UnitForces<double> exact = truth->forces(s);
      EXPECT_TRUE(test::are_near(estimate.wrench, exact, {estimate.error.force + 1e-12, estimate.error.moment + 1e-12}))
          << n << ' ' << rows.size() << ' ' << s;
    }
  }
}

TEST(Samples, TheLoadToHoldIsOffByNoMoreThanItsStatedError) {
  const ExactCurve truth(hertz());
  for (const std::size_t count : {8U, 12U, 30U, 100U}) {
    const Law law = samples(sampled(hertz_pressure, count, 0.0), "hertz.csv");
    const ExactCurve curve(law);
    for (const ContactFriction& contact : {ContactFriction{.mu = 0.6, .radius_law = RadiusLaw::constant(0.006)},
                                           ContactFriction{.mu = 0.6, .radius_law = RadiusLaw::power(0.005, 0.3)},
                                           ContactFriction{.mu = 0.6, .mu_r = 0.002, .gamma = 0.25}}) {
      for (const auto& [force, moment] :
           {std::pair(1.0, 0.0), {1.0, 1e-4}, {1.0, 1e-3}, {1.0, 2e-3}, {1.0, 1e-2}, {0.1, 1e-2}, {0.0, 1e-2}}) {
        const double load = load_to_hold(curve, contact, force, moment);
        const double error = hold_error(curve, *law, contact, load, force, moment);
        EXPECT_NEAR(load, load_to_hold(truth, contact, force, moment), error + 1e-12 * load) << count << ' ' << moment;
        EXPECT_LT(error, 0.2 * load);
        if (moment == 0.0 || (force == 0.0 && contact.mu_r)) {
          EXPECT_LT(error, 1e-12);
        }
      }
    }
  }
  EXPECT_EQ(hold_error(truth, *hertz(), {.mu = 0.6, .radius_law = RadiusLaw::constant(0.006)}, 2.0, 1.0, 1e-3), 0.0);
  // Of an ellipse P² = (F/μ)² + (M/μa m₀)²: only m₀ matters, and with measured moments nothing of the law.
  const Law law = samples(sampled(hertz_pressure, 12, 0.0), "hertz.csv");
  const auto [spin, spin_error, slope] = law->evaluate(0.0);
  const Ellipse ellipse = Ellipse::through_intercepts(spin.moment);
  const std::array<LoadSample, 3> moments{{{0.5, 0.001}, {1.0, 0.002}, {4.0, 0.008}}};
  const ContactFriction measured{.mu = 0.6, .mu_r = 0.002};
  const ContactFriction listed{.mu = 0.6, .radius_law = RadiusLaw::of_moments(moments, 0.6, spin.moment)};
  for (const double moment : {2e-4, 2e-3}) {
    const ContactFriction sized{.mu = 0.6, .radius_law = RadiusLaw::constant(0.006)};
    const double load = load_to_hold(ellipse, sized, 1.0, moment);
    const double spinning = moment / (0.6 * 0.006 * spin.moment);
    const double expected = spinning * spinning / load * spin_error.moment / spin.moment;
    EXPECT_NEAR(hold_error(ellipse, *law, sized, load, 1.0, moment, true), expected, 1e-12);
    for (const ContactFriction& contact : {measured, listed}) {
      const double held = load_to_hold(ellipse, contact, 1.0, moment);
      EXPECT_EQ(hold_error(ellipse, *law, contact, held, 1.0, moment, true), 0.0);
      EXPECT_EQ(hold_error(box(1.0, spin.moment), *law, contact, held, 1.0, moment, true), 0.0);
    }
    const ExactCurve curve(law);
    const double held = load_to_hold(curve, measured, 1.0, moment);
    EXPECT_NEAR(hold_error(curve, *law, listed, held, 1.0, moment),
                hold_error(curve, *law, measured, held, 1.0, moment), 1e-12);
  }
}

TEST(Samples, TheInterpolantDoesNotOvershoot) {
  const std::array<PressureSample, 7> profile{
      {{0.0, 0.0}, {0.2, 0.0}, {0.25, 1.0}, {0.3, 1.0}, {0.7, 1.0}, {0.75, 0.1}, {1.0, 0.0}}};
  const Law law = samples(profile, "steps.csv");
  const double top = law->density(RadialPosition<double>{0.5, 0.5});
  for (int i = 0; i <= 1000; ++i) {
    const double rho = i / 1000.0;
    const double density = law->density(RadialPosition<double>{rho, 1.0 - rho});
    EXPECT_GE(density, 0.0);
    EXPECT_LE(density, top * (1.0 + 1e-12));
  }
}

TEST(Samples, TheErrorOfATableIsHeldByItsFilesChecksum) {
  const std::array<PressureSample, 5> profile{{{0, 1}, {0.3, 0.9}, {0.6, 0.7}, {0.8, 0.5}, {1, 0}}};
  const Table table = Table::build(samples(profile, "p.csv"), 1e-3);
  EXPECT_GT(table.profile_error(), 1e-3);
  const std::string text = to_csv(table);
  EXPECT_EQ(read_table_csv(text, "table.csv").profile_error(), table.profile_error());
  const std::size_t line = text.find("# profile_error: ");
  const std::size_t end = text.find('\n', line);
  const auto expect_refusal = [&](const std::string& fact, const char* told) {
    const std::string edited = text.substr(0, line) + fact + text.substr(end + fact.empty());
    test::expect_mention(test::complaint([&] { read_table_csv(edited, "table.csv"); }), told);
  };
  expect_refusal("# profile_error: 0", "edited or damaged");
  expect_refusal("", "expected '# profile_error: …'");
}

// Intervals of pieces away from the COR are integrated together; tanh-sinh integrates each piece alone.
TEST(Samples, OfManyPiecesHaveTheWrenchThatEachPieceAloneGives) {
  for (const std::size_t count : {5U, 60U, 300U}) {
    const Law law = samples(sampled(hertz_pressure, count, 0.3), "noisy.csv");
    std::vector<double> places(cors.begin(), cors.end());
    for (const std::size_t i : {1U, 2U, 3U}) {
      const auto at = static_cast<double>(law->breaks()[i * count / 5]);
      places.insert(places.end(), {at, at * (1.0 + 1e-15), at * (1.0 - 1e-9)});
    }
    for (const double s : places) {
      const WrenchEstimate together = law->evaluate(s);
      const WrenchEstimate alone = law->evaluate(s, Method::ring);
      constexpr double bound = accuracy::has_extended ? 4e-16 : accuracy::evaluate_by_quadrature;
      EXPECT_TRUE(test::are_near_in_relative_terms(together.wrench, alone.wrench, bound)) << count << ' ' << s;
      EXPECT_NEAR(together.force_slope, alone.force_slope, 1e-13 * alone.force_slope) << count << ' ' << s;
      EXPECT_TRUE(test::are_near_in_relative_terms(law->forces(s), alone.wrench, 1e-14)) << count << ' ' << s;
    }
  }
}

// Nearly all load may lie on a speck of the disc, alone or beside a little pressure everywhere.
TEST(Samples, ARimFarOutOnlyScalesTheUnitOfLength) {
  const std::array<PressureSample, 7> profile{
      {{0, 1}, {1, 0.968}, {2, 0.866}, {3, 0.661}, {3.5, 0.484}, {3.8, 0.312}, {4, 0}}};
  const Law law = samples(profile, "hertz.csv", 4.0);
  for (const double rim : {40.0, 400.0, 4000.0}) {
    const Law wide = samples(profile, "hertz.csv", rim);
    for (const double c : {0.0, 2.0, 7.9, 40.0, 1e4}) {
      const UnitWrench near = law->evaluate(c / 4.0).wrench;
      EXPECT_LE(test::apart(wide->evaluate(c / rim).wrench, UnitWrench{near.force, near.moment * 4.0 / rim}), 1e-14)
          << rim << ' ' << c;
    }
  }
  // A disc or a ring narrower than any sample of it: its wrench is that of one radius.
  for (const double width : {1e-5, 1e-8}) {
    for (const double elsewhere : {0.0, 1e-30}) {
      for (const double place : {0.0, 4.0}) {
        std::vector<PressureSample> rows{{0, place > 0.0 ? elsewhere : 1.0}};
        if (place > 0.0) rows.insert(rows.end(), {{place, elsewhere}, {place, 1.0}});
        rows.insert(rows.end(), {{place + width, 1.0}, {place + 2.0 * width, 1.0}, {place + 2.0 * width, elsewhere}});
        rows.insert(rows.end(), {{6.0, elsewhere}, {8.0, 0.0}});
        const Law speck = samples(rows, "speck.csv", 8.0);
        for (const double s : {0.6, 2.0, 100.0})
          EXPECT_LE(test::apart(speck->evaluate(s).wrench, evaluators::ring_wrench((place + width) / 8.0, s)), width)
              << width << ' ' << elsewhere << ' ' << place << ' ' << s;
      }
    }
  }
}

// It took 80 000: fifteen around each sample for each cell that was tried.
TEST(Samples, ATableOfAThousandTakesFewWrenches) {
  const auto law = std::make_shared<test::CountedLaw>(samples(sampled(hertz_pressure, 1000, 0.0), "hertz.csv"));
  EXPECT_LE(Table::build(law, 1e-8).checked_error(), 1e-8);
  EXPECT_LT(law->count, 15000U);
}

TEST(Samples, RefusesWhatIsNoProfile) {
  const auto refused = [](const std::vector<PressureSample>& profile, const char* told) {
    test::expect_mention(test::complaint([&] { samples(profile, "p.csv"); }), told);
  };
  refused({}, "expected at least 4");
  refused({{0, 1}, {1, 1}, {0.5, 1}, {2, 1}}, "sample 3 (radius 0.5");
  refused({{0, 1}, {1, test::nan}, {1.5, 1}, {2, 1}}, "finite");
  refused({{0, 1}, {0, 1}, {1, 1}, {1, 1}, {2, 1}}, "has 3 samples");
  refused({{0, 1}, {1, 1}, {1, 1}, {0.5, 1}, {2, 1}}, "sample 4 (radius 0.5");
  refused({{-1, 1}, {1, 1}, {1.5, 1}, {2, 1}}, "radius >= 0");
  refused({{0, 0}, {1, 0}, {1.5, 0}, {2, 0}}, "no pressure");
  refused({{0, 1}, {1, 1}, {1, 3}, {1, 2}, {2, 1}}, "at most two");
  refused({{0, 1}, {1, 1}, {2, -0.2}, {3, 0}}, "a pressure of -0.2");
  refused({{0, 1}, {1, 1}, {2, 0.11}, {3, 0.11}, {4, 0.11}, {5, -0.09}}, "% of the load");
  EXPECT_THROW(samples(sensor_line(), "p.csv", -1.0), std::invalid_argument);
  EXPECT_THROW(samples(sensor_line(), "p.csv", 6e-3), std::invalid_argument);
  refused({{0, 1}, {1, 1}, {2, 1}, {2, 0}}, "jump at the last radius");
}

TEST(Table, FollowsJumpsInsideTheContact) {
  for (unsigned seed = 1; seed <= static_cast<unsigned>(study_cases(21, 4)); ++seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniformly(0.0, 1.0);
    std::vector<double> places{0.0, 1.0};
    for (unsigned i = 0; i <= seed % 6; ++i) places.push_back(0.05 + 0.9 * uniformly(generator));
    std::sort(places.begin(), places.end());
    std::vector<PressureSample> profile;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      for (int k = 0; k <= 3; ++k)
        profile.push_back({std::lerp(places[i], places[i + 1], k / 3.0), 0.2 + uniformly(generator)});
    }
    const Law law = samples(profile, "jumps");
    const Table table = Table::build(law, 1e-10);
    EXPECT_LE(table.checked_error(), 1e-10) << seed;
    test::expect_convex_and_smooth(table);
    double worst = 0.0;
    for (int i = 0; i < 400; ++i) {
      // Half of them next to a jump.
      const double place = places[1 + static_cast<std::size_t>(i) % (places.size() - 2)];
      const double s = i % 2 == 0
                           ? std::tan(1.57 * uniformly(generator))
                           : place * (1.0 + (uniformly(generator) - 0.5) * std::pow(10.0, -9.0 * uniformly(generator)));
      worst = std::max(worst, test::apart(table.wrench(SlipTwist::about_cor(s)), law->forces(s)));
    }
    EXPECT_LE(worst, table.checked_error() + 1e-13) << seed;
  }
}

}  // namespace
}  // namespace limitcurve
