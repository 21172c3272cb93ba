// SPDX-License-Identifier: MIT
#include "limitcurve/validate/choose.hpp"
#include "limitcurve/validate/validate.hpp"
#include "tests/limitcurve/counted_law.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

const Candidate& chosen(const std::vector<Candidate>& candidates) {
  return *std::find_if(candidates.begin(), candidates.end(),
                       [](const Candidate& candidate) { return candidate.chosen; });
}

TEST(Choose, TakesTheCheapestThatIsGoodEnough) {
  std::vector<const char*> laws{"hertz", "uniform", "flat-punch"};
  if (studies_are_whole()) laws.push_back("xydas-kao:k=3");  // no closed form: fifty times as long as the others
  for (const char* law : laws) {
    for (const double tolerance : {1.0, 0.6, 0.2, 0.07, 0.01, 1e-4, 1e-8}) {
      const auto candidates = choose(parse_law(law), tolerance);
      const Candidate& best = chosen(candidates);
      EXPECT_LE(best.error, tolerance) << law;
      EXPECT_EQ(std::count_if(candidates.begin(), candidates.end(),
                              [](const Candidate& candidate) { return candidate.chosen; }),
                1);
      for (const Candidate& other : candidates) {
        if (other.nanoseconds < best.nanoseconds / (1.0 + cost_tie)) {
          EXPECT_GT(other.error, tolerance) << law << ": " << other.model;
        }
      }
    }
  }
}

TEST(Choose, NamesWhatItTakes) {
  // Diamond and box cost the same but for what a measurement scatters.
  const std::string cheapest = chosen(choose(hertz(), 0.6)).model;
  EXPECT_TRUE(cheapest == "diamond" || cheapest == "box") << cheapest;
  EXPECT_EQ(chosen(choose(uniform(), 0.07)).model, "table");  // its ellipse has an error of 7.04 %
}

// It took 75 000, each 0.15 ms, and built tables of a law whose moment is below any table's error: 45 s.
TEST(Choose, EvaluatesAPeakedLawAFewThousandTimes) {
  const auto law = std::make_shared<CountedLaw>(xydas_kao(0.01));
  const auto candidates = choose(Law(law), 0.01);
  EXPECT_LT(law->count, 10000U);
  EXPECT_EQ(chosen(candidates).model, "exact");
  // The root mean square is over an angle that turns within 1e-14 of the slip twists.
  EXPECT_NEAR(curve_error(box(1.0, law->moment_ratio()), ExactCurve(law)).rms_error, 0.00647925913444, 1e-6 * 0.0065);
}

TEST(Choose, OfEqualCostsTheSmallerErrorWins) {
  std::vector<Candidate> candidates{
      {"dear", 0.0, 0.0, 131.0}, {"table", 0.0, 0.0006, 125.1}, {"curve", 0.0, 0.21, 124.3}, {"cheap", 0.0, 0.3, 10.0}};
  choose_cheapest(candidates, 0.25);
  EXPECT_EQ(chosen(candidates).model, "table");
  for (Candidate& candidate : candidates) candidate.chosen = false;
  choose_cheapest(candidates, 0.5);
  EXPECT_EQ(chosen(candidates).model, "cheap");
  // None is good enough: none is chosen, and digits tell the error from the tolerance.
  candidates = {{"near", 0.0, 0.1002, 10.0}, {"far", 0.0, 0.3, 5.0}};
  choose_cheapest(candidates, 0.1);
  EXPECT_TRUE(std::none_of(candidates.begin(), candidates.end(), [](const Candidate& one) { return one.chosen; }));
  EXPECT_EQ(candidates[1].reason, "10.02 % > 10 %");
  candidates = {{"next", 0.0, 0.0826186923216865, 10.0}};  // in per cent it is the same number
  choose_cheapest(candidates, 0.08261869232168649);
  EXPECT_EQ(candidates[0].reason, "0.0826186923216865 > 0.08261869232168649");
}

TEST(Choose, SaysWhatItBeatAndWhy) {
  const auto candidates = choose(hertz(), 0.01);
  const auto reason = [&](const char* model) {
    return std::find_if(candidates.begin(), candidates.end(),
                        [&](const Candidate& candidate) { return candidate.model == model; })
        ->reason;
  };
  EXPECT_EQ(reason("ellipse"), "6.4 % > 1 %");
  EXPECT_EQ(reason("box"), "50 % > 1 %");
  EXPECT_EQ(reason("exact").substr(0, 3), "0, ");
  expect_mention(reason("exact"), " times the cost");
  EXPECT_TRUE(chosen(candidates).reason.ends_with(": chosen"));
}

TEST(Choose, FractionsAsPeopleReadThem) {
  EXPECT_EQ(in_percent(0.0638), "6.4 %");
  EXPECT_EQ(in_percent(0.01), "1 %");
  EXPECT_EQ(in_percent(1.26), "126 %");
  EXPECT_EQ(in_percent(0.00087), "0.087 %");
  EXPECT_EQ(in_percent(2e-6), "2.0e-06");
  EXPECT_EQ(in_percent(0.0), "0");
}

TEST(Choose, RefusesTolerancesThatMeanNothing) {
  for (const double tolerance : {0.0, -1.0, 1e-11, 2.0})
    EXPECT_THROW(choose(hertz(), tolerance), std::invalid_argument);
}

}  // namespace

}  // namespace limitcurve::test
