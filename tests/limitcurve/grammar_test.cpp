// SPDX-License-Identifier: MIT
// Law strings: what is accepted, and what a refusal says.
#include "limitcurve/internal/number.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

TEST(LawGrammar, NamedLawsAreMembersOfTheirFamilies) {
  for (const auto& [named, general] : {std::pair{"hertz", "power:n=0.5"},
                                       {"uniform", "power:n=0"},
                                       {"parabolic", "power:n=1"},
                                       {"flat-punch", "power:n=-0.5"}}) {
    EXPECT_EQ(parse_law(named)->evaluate(0.7).wrench, parse_law(general)->evaluate(0.7).wrench) << named;
  }
}

TEST(LawGrammar, MixtureTakesExponentsWithASign) {
  const UnitWrench mixed = parse_law("mix:1e+3*hertz+1e3*uniform")->evaluate(0.7).wrench;
  const UnitWrench same = parse_law("mix:0.5*hertz+0.5*uniform")->evaluate(0.7).wrench;
  EXPECT_EQ(mixed, same);
}

TEST(LawGrammar, AMixtureOfManyEqualLawsIsTheLaw) {
  for (const auto& [name, parts] : {std::pair{"hertz", 1000}, {"power:n=0.3", 300}}) {
    std::string text = "mix:";
    for (int i = 0; i < parts; ++i) text.append(i == 0 ? "1*" : "+1*").append(name);
    const Law mixed = parse_law(text);
    EXPECT_EQ(mixed->name(), text);
    for (const double s : {0.0, 0.4, 1.0, 1e9}) {
      EXPECT_LE(apart(mixed->evaluate(s).wrench, parse_law(name)->evaluate(s).wrench), 1e-13);
    }
  }
}

TEST(LawGrammar, SaysWhatIsWrong) {
  for (const auto& [text, place] : {std::pair{"", "expected one of hertz"},
                                    {"herz", "expected one of hertz"},
                                    {"Hertz", "expected one of hertz"},
                                    {"hertz ", "expected one of hertz"},
                                    {" hertz", "expected one of hertz"},
                                    {"hertz:", "hertz has no parameter, expected hertz"},
                                    {"hertz:n=1", "hertz has no parameter 'n', expected hertz"},
                                    {"hertz:a=0.005", "the contact radius is that of the radius law"},
                                    {"power", "expected n=NUMBER"},
                                    {"power:", "expected n=NUMBER"},
                                    {"power:n", "expected n=NUMBER"},
                                    {"power:n=", "got ''"},
                                    {"power:k=1", "got 'k=1'"},
                                    {"power:n=1x", "got '1x'"},
                                    {"power:n=1,n=2", "'n' twice in 'n=1,n=2'"},
                                    {"power:n=-1", "n = -1"},
                                    {"power:n=-1.5", "-1 < n"},
                                    {"power:n=nan", "n = nan"},
                                    {"power:n=inf", "n = inf"},
                                    {"xydas-kao:k=0", "k = 0"},
                                    {"xydas-kao:k=-3", "k = -3"},
                                    {"xydas-kao:k=nan", "k = nan"},
                                    {"xydas-kao:n=3", "expected k=NUMBER"},
                                    {"gaussian:sigma=0", "sigma = 0"},
                                    {"gaussian:sigma=-1", "sigma = -1"},
                                    {"gaussian:sigma=", "'sigma' in 'sigma=': got ''"},
                                    {"mix:", "expected WEIGHT*LAW, got ''"},
                                    {"mix:hertz", "expected WEIGHT*LAW, got 'hertz'"},
                                    {"mix:0.5*hertz+", "expected WEIGHT*LAW, got ''"},
                                    {"mix:0.5*hertz++0.5*uniform", "expected WEIGHT*LAW, got ''"},
                                    {"mix:x*hertz", "expected WEIGHT*LAW, got 'x*hertz'"},
                                    {"mix:0.5*herz", "law 'herz'"},
                                    {"mix:0*hertz", "weight of hertz = 0"},
                                    {"mix:-1*hertz+2*uniform", "weight of hertz = -1"},
                                    {"mix:nan*hertz", "weight of hertz = nan"},
                                    {"mix:1*mix:1*hertz", "mixture of mixtures"},
                                    {"mix:1*power:n=-2", "n = -2"}}) {
    const std::string told = complaint([&, &text = text] { parse_law(text); });
    expect_mention(told, place);
    EXPECT_TRUE(told.starts_with("law '") && told.find('\n') == std::string::npos) << told;
  }
}

TEST(LawGrammar, AWordThatIsNearIsSuggestedAndNoOther) {
  expect_mention(complaint([] { parse_law("hetz"); }), "did you mean 'hertz'?");
  expect_mention(complaint([] { parse_law("unif"); }), "did you mean 'uniform'?");
  EXPECT_EQ(complaint([] { parse_law("abcdefg"); }).find("did you mean"), std::string::npos);
}

}  // namespace

}  // namespace limitcurve::test
