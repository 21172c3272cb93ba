// SPDX-License-Identifier: MIT
#include "fit/engine_coefficients.hpp"

#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace limitcurve::fit {
namespace {

const RadiusLaw silicone = RadiusLaw::power(2.07e-3, 0.259);

double coefficient(const EngineContact& contact, const std::string& parameter) {
  for (const EngineCoefficient& item : contact.coefficients) {
    if (item.parameter == parameter) return item.value;
  }
  throw std::out_of_range(parameter);
}

/// The moment limit that each engine computes from what it was given, by its documentation.
double moment_limit(const EngineContact& contact, double load) {
  const std::string& engine = contact.engine;
  if (engine == "mujoco") return coefficient(contact, "geom.friction[1]") * load;
  if (engine == "chrono") return coefficient(contact, "SetSpinningFriction") * load;
  if (engine == "gazebo") {
    return 3.0 * std::acos(-1.0) / 16.0 * coefficient(contact, "surface/friction/torsional/patch_radius") *
           coefficient(contact, "surface/friction/torsional/coefficient") * load;
  }
  if (engine == "physx")
    return coefficient(contact, "PxMaterial.dynamicFriction") * coefficient(contact, "PxShape.minTorsionalPatchRadius") * load;
  if (engine == "bullet") return coefficient(contact, "setSpinningFriction") * 1.0 * load;
  if (engine == "ode") return coefficient(contact, "surface.rhoN") * load;
  throw std::out_of_range(engine);
}

TEST(EngineCoefficients, GiveEveryEngineTheExactLimits) {
  for (const Law& law : {hertz(), uniform(), flat_punch(), parabolic()}) {
    for (const double load : {0.5, 3.0, 12.0}) {
      std::set<std::string> engines;
      for (const EngineContact& contact : translate(law, silicone, 0.8, load)) {
        engines.insert(contact.engine);
        EXPECT_NEAR(moment_limit(contact, load) / (0.8 * load * law->moment_ratio() * silicone.radius(load)), 1.0, 1e-14) << contact.engine;
        EXPECT_EQ(contact.documentation.substr(0, 4), "http");
        for (const EngineCoefficient& item : contact.coefficients) EXPECT_FALSE(item.formula.empty() || item.unit.empty());
      }
      EXPECT_EQ(engines, (std::set<std::string>{"mujoco", "chrono", "gazebo", "physx", "bullet", "ode"}));
    }
  }
}

TEST(EngineCoefficients, PatchRadiusOfGazeboIsTheContactRadiusForHertz) {
  for (const EngineContact& contact : translate(hertz(), silicone, 0.8, 3.0)) {
    if (contact.engine == "gazebo") {
      EXPECT_NEAR(coefficient(contact, "surface/friction/torsional/patch_radius") / silicone.radius(3.0), 1.0, 1e-14);
    }
  }
}

TEST(EngineCoefficients, ErrorsAreThoseOfTheShapes) {
  for (const EngineContact& contact : translate(hertz(), RadiusLaw::constant(0.005), 0.8, 3.0)) {
    // A constant radius is followed by constant coefficients.
    EXPECT_NEAR(contact.max_error_over_loads, contact.error.max_error, 1e-12);
    if (contact.model == "ellipse") {
      EXPECT_NEAR(contact.error.max_error, 0.0638, 6e-5);
      // At the same COR: measured in the engine itself as 0.14.
      EXPECT_NEAR(contact.max_wrench_error, 0.14, 0.01);
    } else if (contact.model == "box") {
      EXPECT_GT(contact.error.max_over_estimate, 0.45);
      EXPECT_LE(contact.error.max_under_estimate, 1e-12);
      // Just off pure sliding the box still gives the whole moment.
      EXPECT_NEAR(contact.max_wrench_error, 1.0, 1e-3);
    } else {
      EXPECT_EQ(contact.model, "diamond");
      EXPECT_GT(contact.error.max_under_estimate, 0.2);
      EXPECT_LE(contact.error.max_over_estimate, 1e-12);
    }
  }
}

TEST(EngineCoefficients, ErrorAtTheSameCorDoesNotDependOnUnitsOfLength) {
  const double expected = translate(gaussian(1.0), RadiusLaw::constant(0.005), 0.8, 3.0).front().max_wrench_error;
  EXPECT_GT(expected, 0.05);
  for (const double sigma : {1e-6, 1e-3, 1e3, 1e6}) {
    const EngineContact contact = translate(gaussian(sigma), RadiusLaw::constant(0.005 / sigma), 0.8, 3.0).front();
    EXPECT_NEAR(contact.max_wrench_error, expected, 1e-9) << sigma;
  }
}

TEST(EngineCoefficients, ConstantCoefficientsCannotFollowAGrowingRadius) {
  const EngineContact ellipse = translate(hertz(), silicone, 0.8, 3.0, {1.5, 6.0}).front();
  // At half the load the radius is 2^-0.259 of what it was, and the moment's limit 2^0.259 = 1.197 times too large.
  EXPECT_NEAR(ellipse.max_error_over_loads, std::pow(2.0, 0.259) - 1.0, 1e-3);
}

TEST(EngineCoefficients, RefuseBadInput) {
  EXPECT_THROW(translate(hertz(), silicone, -1.0, 3.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, std::numeric_limits<double>::quiet_NaN(), 3.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 0.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 3.0, {4.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 3.0, {0.0, 2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::fit
