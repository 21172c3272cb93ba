// SPDX-License-Identifier: MIT
// The evaluators of eq. (17) against values that mpmath made, law by law.
#include "limitcurve/quadrature/closed_form.hpp"
#include "reference.hpp"
#include "tests/limitcurve/shared.hpp"

#include <boost/math/constants/constants.hpp>

#include <set>
#include <tuple>

namespace limitcurve::test {

namespace {

class Reference : public testing::TestWithParam<std::string> {
 protected:
  template <class Check>
  void each_row(Check&& check) const {
    for (const ReferenceRow& row : reference_rows()) {
      if (row.law == GetParam()) check(row);
    }
  }
  const Law law_ = parse_law(GetParam());
};

TEST_P(Reference, EvaluateIsRightInRelativeTerms) {
  const long double bound = law_->allows(Method::closed) ? accuracy::evaluate_closed : accuracy::evaluate_by_quadrature;
  each_row([&](const ReferenceRow& row) {
    const WrenchEstimate estimate = law_->evaluate(row.s);
    EXPECT_LE(relative_error(estimate.wrench.force, row.force), bound) << "s = " << row.s;
    EXPECT_LE(relative_error(estimate.wrench.moment, row.moment), bound) << "s = " << row.s;
    EXPECT_LE(relative_error(estimate.force_slope, row.force_slope), 1e-13L) << "s = " << row.s;
  });
}

// The support function at s = 1 is ∫₀¹ (2/π)(1+ρ)E(2√ρ/(1+ρ)) dρ = (2/π) ∫₀¹ 2E(ρ) − (1−ρ²)K(ρ) dρ (DLMF 19.8.12),
// whose integrals are Catalan's constant G (∫K = 2G, ∫E = G + ½, ∫ρ²K = (2G + 1)/4); s → 0 and s → ∞ are the first
// terms of series.
TEST(UniformWear, HasItsClosedForms) {
  using boost::math::double_constants::catalan;
  using boost::math::double_constants::pi;
  const Law law = uniform_wear();
  const auto near = [](double value, double exact) { EXPECT_NEAR(value / exact, 1.0, 1e-14); };
  near(law->moment_ratio(), 0.5);
  near(law->evaluate(1.0).wrench.force, (1 + 2 * catalan) / pi);
  near(law->evaluate(1.0).wrench.moment, (3 - 2 * catalan) / (2 * pi));
  for (const double s : {1e-9, 0.9e-20, 1.1e-20, 1e-300})
    near(law->evaluate(s).wrench.force, s / 2 * (std::log(4 / s) + 0.5));
  for (const double s : {1e9, 1e100}) near(law->evaluate(s).wrench.moment, 1 / (6 * s));
  // Between them eq. (17) as printed.
  for (const double s : {0.01, 0.5, 0.9, 1.1, 3.0}) {
    const WrenchEstimate printed = law->evaluate(s, Method::direct);
    EXPECT_TRUE(
        are_near(law->evaluate(s).wrench, printed.wrench, {printed.error.force + 1e-15, printed.error.moment + 1e-15}))
        << s;
    EXPECT_LT(printed.error.force, 1e-8) << s;
  }
}

// Far from the contact the force is the whole load.
TEST(XydasKao, SmallKCarriesUnitLoadToItsStatedError) {
  for (double k = 0.01; k < 0.1; k *= 1.02) {
    const WrenchEstimate far = xydas_kao(k)->evaluate(1e10);
    EXPECT_LE(std::fabs(far.wrench.force - 1.0), far.error.force) << k;
  }
}

TEST_P(Reference, ForcesForLoopsAreRightInRelativeTerms) {
  each_row([&](const ReferenceRow& row) {
    const UnitForces<double> forces = law_->forces(row.s);
    const LoopBounds bounds = loop_bounds(*law_, row.s);
    EXPECT_LE(relative_error(forces.force, row.force), bounds.wrench) << "s = " << row.s;
    EXPECT_LE(relative_error(forces.moment, row.moment), bounds.wrench) << "s = " << row.s;
    EXPECT_LE(relative_error(forces.force_slope, row.force_slope), bounds.slope) << "s = " << row.s;
  });
}

/// The true error is never above the estimate, and the estimate is not more than 1000 times the true error or
/// `cautious` (where long double is double, 64 roundings of it).
void expect_honest(const PressureLaw& law, const ReferenceRow& row, Method method, long double cautious) {
  const WrenchEstimate estimate = law.evaluate(row.s, method);
  for (const auto& [value, exact, error] : {std::tuple{estimate.wrench.force, row.force, estimate.error.force},
                                            {estimate.wrench.moment, row.moment, estimate.error.moment}}) {
    const long double truth = std::fabs(value - exact);
    EXPECT_LE(truth, error) << to_string(method) << " at s = " << row.s;
    EXPECT_LE(error, std::max(1000 * truth, cautious)) << to_string(method) << " at s = " << row.s;
  }
}

TEST_P(Reference, ErrorEstimatesAreHonest) {
  for (const Method method : {Method::automatic, Method::closed, Method::ring, Method::punch}) {
    if (!law_->allows(method)) continue;
    each_row(
        [&](const ReferenceRow& row) { expect_honest(*law_, row, method, accuracy::has_extended ? 1e-15L : 2e-14L); });
  }
}

/// The double integral costs up to a second a point: six points of every law, or one, another one for the next law,
/// unless studies are whole.
TEST_P(Reference, DirectIsHonestToo) {
  constexpr std::array points{0.0, 0.5, 0.9999, 1.0, 3.0, inf};
  const std::vector<std::string> laws = reference_laws();
  const std::size_t stride = studies_are_whole() ? 1 : points.size();
  std::set<double> chosen;
  for (auto i = static_cast<std::size_t>(std::find(laws.begin(), laws.end(), GetParam()) - laws.begin()) % stride;
       i < points.size(); i += stride) {
    chosen.insert(points[i]);
  }
  std::size_t checked = 0;
  each_row([&](const ReferenceRow& row) {
    if (!chosen.contains(row.s)) return;
    ++checked;
    expect_honest(*law_, row, Method::direct, accuracy::has_extended ? 1e-15L : 2e-13L);
  });
  EXPECT_EQ(checked, chosen.size());
}

INSTANTIATE_TEST_SUITE_P(AllLaws, Reference, testing::ValuesIn(reference_laws()),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(ReferenceFile, CoversEveryKindOfLaw) {
  const auto laws = reference_laws();
  for (const std::string_view example : law_examples()) {
    const std::string_view kind = example.substr(0, example.find(':'));
    if (kind == "uniform-wear") continue;  // its slope at 0 is infinite: UniformWear.HasItsClosedForms
    EXPECT_TRUE(std::any_of(laws.begin(), laws.end(), [&](const std::string& law) {
      return law.substr(0, law.find(':')) == kind;
    })) << kind;
  }
}

/// The closed forms are templates: the bounds of closed_form.hpp in ε hold for each Real.
template <class Real>
void expect_promised_precision(const char* law, UnitForces<Real> (*form)(Real) noexcept,
                               UnitForces<Extended> (*exact)(Extended) noexcept) {
  constexpr Extended epsilon = std::numeric_limits<Real>::epsilon();
  const int roundings = std::string(law) == "cone" ? 16 : 8;
  const UnitForces<Real> none = form(std::numeric_limits<Real>::quiet_NaN());
  EXPECT_TRUE(std::isnan(none.force) && std::isnan(none.moment) && std::isnan(none.force_slope)) << law;
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> decade(-6.0, 6.0);
  std::uniform_real_distribution<double> near_rim(-16.0, -0.3);
  for (int i = 0; i < 4000; ++i) {
    const double drawn = i % 2 == 0 ? std::pow(10.0, decade(random))
                                    : 1.0 + (i % 4 == 1 ? 1.0 : -1.0) * std::pow(10.0, near_rim(random));
    const auto s = static_cast<Real>(drawn);
    const UnitForces<Real> found = form(s);
    const UnitForces<Extended> truth = exact(s);
    EXPECT_LE(std::fabs(found.force - truth.force), 8 * epsilon * truth.force) << law << ' ' << s;
    EXPECT_LE(std::fabs(found.moment - truth.moment), roundings * epsilon * truth.moment) << law << ' ' << s;
    EXPECT_LE(std::fabs(found.force_slope - truth.force_slope), 64 * epsilon * truth.force_slope) << law << ' ' << s;
  }
}

template <class Real>
void expect_promised_precision_of_all() {
  namespace form = closed_form;
  expect_promised_precision<Real>("hertz", form::hertz<Real>, form::hertz<Extended>);
  expect_promised_precision<Real>("flat-punch", form::flat_punch<Real>, form::flat_punch<Extended>);
  expect_promised_precision<Real>("uniform", form::uniform<Real>, form::uniform<Extended>);
  expect_promised_precision<Real>("parabolic", form::parabolic<Real>, form::parabolic<Extended>);
  expect_promised_precision<Real>("cone", form::cone<Real>, form::cone<Extended>);
}

TEST(ClosedForms, KeepTheirPrecisionInEveryReal) {
  expect_promised_precision_of_all<float>();
  expect_promised_precision_of_all<double>();
}

/// The quadrature must not be fooled between the reference's points either: large exponents, whose pressure is all in
/// one place, and CORs where two levels of the rule happen to agree.
TEST(ForcesForLoops, KeepTheirBoundForLargeExponents) {
  for (const char* name : {"xydas-kao:k=30", "xydas-kao:k=1000", "power:n=300", "power:n=1000"}) {
    const Law law = parse_law(name);
    const auto check = [&](double s) {
      EXPECT_TRUE(are_near_in_relative_terms(law->forces(s), law->evaluate(s).wrench, accuracy::forces_by_quadrature))
          << name << ' ' << s;
    };
    for (double s = 1e-5; s < 0.2; s *= 1.5) check(s);
    for (double s = 0.2; s < 1.0; s *= 1.01) check(s);
    for (double s = 1.0; s < 30.0; s *= 1.2) check(s);
  }
}

TEST(ForcesForLoops, GiveNaNForNaN) {
  for (const std::string_view name : law_examples()) {
    const UnitForces<double> forces = parse_law(name)->forces(nan);
    EXPECT_TRUE(std::isnan(forces.force) && std::isnan(forces.moment) && std::isnan(forces.force_slope)) << name;
  }
}

}  // namespace

}  // namespace limitcurve::test
