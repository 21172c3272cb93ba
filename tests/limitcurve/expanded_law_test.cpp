// SPDX-License-Identifier: MIT
// A law by polynomials against 30-digit values, against the law itself, and at the places where it leaves the law to itself.
#include "limitcurve/expanded_law.hpp"
#include "limitcurve/accuracy.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace limitcurve::test {

namespace {

/// A COR anywhere: all scales, and near the rim on either side.
double random_cor(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double x = uniform(random);
  switch (random() % 3) {
    case 0:
      return (1.0 - x) / x;
    case 1:
      return 1.0 + (random() % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, -0.3 - 15.0 * x);
    default:
      return std::pow(10.0, 40.0 * x - 20.0);
  }
}

TEST(ExpandedLaw, IsRightInRelativeTerms) {
  for (const std::string& name : reference_laws()) {
    const Law law = parse_law(name);
    if (law->has_quick_forces()) continue;
    const ExpandedLaw expanded_law(law);
    EXPECT_LE(expanded_law.error(), 2.0 * ExpandedLaw::default_tolerance) << name;
    for (const ReferenceRow& row : reference_rows()) {
      if (row.law != name) continue;
      const UnitForces<double> forces = expanded_law.forces(row.s);
      EXPECT_LE(relative_error(forces.force, row.force), accuracy::forces_expanded) << name << ' ' << row.s;
      EXPECT_LE(relative_error(forces.moment, row.moment), accuracy::forces_expanded) << name << ' ' << row.s;
      const double slope_bound = std::max(loop_bounds(*law, row.s).slope, 1e-11);
      EXPECT_LE(relative_error(forces.force_slope, row.force_slope), slope_bound) << name << ' ' << row.s;
    }
  }
}

/// Between the places that the builder has seen.
TEST(ExpandedLaw, StatesItsError) {
  for (const char* name : {"xydas-kao:k=3", "xydas-kao:k=0.2", "power:n=2.3", "power:n=-0.9", "mix:1*hertz+2*xydas-kao:k=5"}) {
    const Law law = parse_law(name);
    const ExpandedLaw expanded_law(law);
    std::mt19937_64 random(7);
    for (int i = 0; i < 300; ++i) {
      const double s = random_cor(random);
      const UnitForces<double> found = expanded_law.forces(s);
      const WrenchEstimate truth = law->evaluate(s);
      const double bound = expanded_law.error() + accuracy::forces_by_quadrature;
      EXPECT_NEAR(found.force, truth.wrench.force, bound * truth.wrench.force) << name << ' ' << s;
      EXPECT_NEAR(found.moment, truth.wrench.moment, bound * truth.wrench.moment) << name << ' ' << s;
    }
  }
}

TEST(ExpandedLaw, CoversASmoothLawAndLeavesASteepRimToTheLaw) {
  const ExpandedLaw smooth(xydas_kao(3.0));
  std::mt19937_64 random(11);
  for (int i = 0; i < 3000; ++i) EXPECT_TRUE(smooth.covers(random_cor(random)));
  for (const double s : {0.0, 1e-300, 1.0, 1e300, std::numeric_limits<double>::infinity()}) EXPECT_TRUE(smooth.covers(s)) << s;

  const Law law = power(-0.9);
  const ExpandedLaw steep(law);
  for (const double s : {0.3, 0.9, 1.2, 30.0}) EXPECT_TRUE(steep.covers(s)) << s;
  const double at_rim = 1.0 - 1e-14;
  EXPECT_FALSE(steep.covers(at_rim));
  EXPECT_EQ(steep.forces(at_rim).force, law->forces(at_rim).force);
  EXPECT_EQ(steep.forces(at_rim).force_slope, law->forces(at_rim).force_slope);
}

/// A coarser tolerance is kept as well, with fewer pieces.
TEST(ExpandedLaw, TakesATolerance) {
  const Law law = xydas_kao(3.0);
  const ExpandedLaw coarse(law, 1e-6);
  EXPECT_LT(coarse.bytes(), ExpandedLaw(law).bytes());
  std::mt19937_64 random(13);
  for (int i = 0; i < 1000; ++i) {
    const double s = random_cor(random);
    EXPECT_NEAR(coarse.forces(s).force / law->forces(s).force, 1.0, 2e-6) << s;
    EXPECT_NEAR(coarse.forces(s).moment / law->forces(s).moment, 1.0, 2e-6) << s;
  }
  EXPECT_THROW(ExpandedLaw(law, 0.0), std::invalid_argument);
  EXPECT_THROW(ExpandedLaw(law, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(ExpandedLaw, IsTheLawInAllElse) {
  const Law law = power(0.3);
  const Law other = expanded(law);
  EXPECT_EQ(other->name(), law->name());
  EXPECT_EQ(other->moment_ratio(), law->moment_ratio());
  EXPECT_EQ(other->breaks(), law->breaks());
  for (const Method method : {Method::automatic, Method::closed, Method::ring, Method::punch}) {
    EXPECT_EQ(other->allows(method), law->allows(method));
    EXPECT_EQ(other->evaluate(0.7, method).wrench, law->evaluate(0.7, method).wrench);
  }
  EXPECT_TRUE(std::isnan(other->forces(std::numeric_limits<double>::quiet_NaN()).force));
}

/// What is quick already is left as it is.
TEST(ExpandedLaw, IsNotBuiltForAClosedForm) {
  for (const char* name : {"hertz", "uniform", "cone", "gaussian:sigma=0.4", "mix:0.7*hertz+0.3*uniform"}) {
    const Law law = parse_law(name);
    EXPECT_EQ(expanded(law), law) << name;
  }
  const Law once = expanded(xydas_kao(3.0));
  EXPECT_EQ(expanded(once), once);
}

}  // namespace

}  // namespace limitcurve::test
