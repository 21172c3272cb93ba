// SPDX-License-Identifier: MIT
#include "limitcurve/engines/engine_coefficients.hpp"

#include "limitcurve/engines/engine_facts.hpp"
#include "limitcurve/patch/patch.hpp"
#include "tests/limitcurve/shared.hpp"

#include <map>
#include <set>
#include <sstream>

namespace limitcurve::engines {
namespace {

using test::expect_mention;
using test::nan;
const RadiusLaw silicone = RadiusLaw::power(2.07e-3, 0.259);

double coefficient(const EngineContact& contact, const std::string& parameter) {
  for (const EngineCoefficient& item : contact.coefficients) {
    if (item.parameter == parameter) return item.value;
  }
  throw std::out_of_range(parameter);
}

/// The moment limit that each engine computes from what it was given, by its documentation or source; 0 where it has
/// none.
double moment_limit(const EngineContact& contact, double load) {
  for (const EngineCoefficient& item : contact.coefficients) {
    if (item.formula == "mu_r") return item.value * load;
  }
  struct Rule {
    double constant;
    std::vector<std::string> factors;
  };
  const double pi = std::numbers::pi;
  static const std::map<std::string, Rule> rules{
      {"gazebo",
       {3.0 * pi / 16.0, {"surface/friction/torsional/patch_radius", "surface/friction/torsional/coefficient"}}},
      {"physx", {1.0, {"PxMaterial.dynamicFriction", "PxShape.minTorsionalPatchRadius"}}},
      {"isaac", {1.0, {"physics:dynamicFriction", "physxCollision:minTorsionalPatchRadius"}}},
      {"sapien", {1.0, {"PhysxMaterial.dynamic_friction", "min_patch_radius"}}},
      {"bullet", {1.0, {"setSpinningFriction"}}},
      {"dex-net", {pi, {"finger_radius", "finger_radius", "friction_coef"}}},
      {"gz-sim-bullet", {1.0, {"surface/friction/torsional/coefficient"}}}};
  const auto rule = rules.find(contact.engine);
  if (rule == rules.end() && contact.model == "point") return 0.0;
  double product = rules.at(contact.engine).constant * load;
  for (const std::string& factor : rule->second.factors) product *= coefficient(contact, factor);
  return product;
}

TEST(EngineCoefficients, GiveEveryEngineTheExactLimits) {
  for (const Law& law : {hertz(), uniform(), flat_punch(), parabolic()}) {
    for (const double load : {0.5, 3.0, 12.0}) {
      for (const EngineContact& contact : translate(law, silicone, 0.8, load)) {
        const bool bears = contact.model != "point";
        EXPECT_NEAR(moment_limit(contact, load) / (0.8 * load * law->moment_ratio() * silicone.radius(load)),
                    bears ? 1.0 : 0.0, 1e-14)
            << contact.engine;
        EXPECT_EQ(contact.documentation.substr(0, 4), "http");
        EXPECT_FALSE(contact.caveat.empty());
        std::set<std::string> parameters;
        bool has_friction = false;
        for (const EngineCoefficient& item : contact.coefficients) {
          EXPECT_FALSE(item.formula.empty() || item.unit.empty());
          EXPECT_TRUE(parameters.insert(item.parameter).second) << item.parameter;
          EXPECT_LE(item.low, item.value);
          EXPECT_GE(item.high, item.value);
          has_friction = has_friction || (item.formula.substr(0, 2) == "mu" && item.value == 0.8);
        }
        EXPECT_TRUE(has_friction) << contact.engine;
      }
    }
  }
}

TEST(EngineCoefficients, WhatIsReadIsWhatWasTranslated) {
  int moments = 0;
  for (const Law& law : {hertz(), uniform()}) {
    for (const EngineContact& contact : translate(law, silicone, 0.8, 3.0)) {
      std::vector<EngineNumber> numbers;
      for (const EngineCoefficient& item : contact.coefficients)
        numbers.push_back({contact.engine, item.parameter, item.value});
      const std::vector<CoefficientMeaning> read =
          read_coefficients(numbers, nan, law);  // all of a contact's numbers: its friction, too
      ASSERT_EQ(read.size(), numbers.size());
      for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].parameter, numbers[i].parameter);
        if (std::isnan(read[i].moment_per_load)) continue;
        ++moments;
        EXPECT_NEAR(read[i].moment_per_load, 0.8 * law->moment_ratio() * silicone.radius(3.0), 1e-17)
            << read[i].parameter;
        EXPECT_NEAR(read[i].radius, silicone.radius(3.0), 1e-17) << read[i].parameter;
        EXPECT_EQ(read[i].note.find("default;"), std::string::npos) << read[i].note;
        // The loads scale the moment, and with it the number: half the lever is half of it, or its root.
        EXPECT_LT(contact.coefficients[i].low, contact.coefficients[i].high);
      }
    }
  }
  // One number sets the moment in each shape and engine that has one.
  int shapes = 0;
  for (const EngineContact& contact : translate(hertz(), silicone, 0.8, 3.0)) shapes += contact.model != "point";
  EXPECT_EQ(moments, 2 * shapes);
}

CoefficientMeaning read_one(const std::string& engine, const std::string& parameter, double value, double mu,
                            const Law& law) {
  return read_coefficients(std::array{EngineNumber{engine, parameter, value}}, mu, law).front();
}

TEST(EngineCoefficients, AreReadByShortNamesAndOtherNamesOfEngines) {
  // MuJoCo's default under mu = 1: the radius that has it in a Hertz contact.
  const CoefficientMeaning mujoco = read_one("mjx", "torsional", 0.005, 1.0, hertz());
  EXPECT_EQ(mujoco.engine, "mjx");
  EXPECT_EQ(mujoco.parameter, "geom.friction[1]");
  EXPECT_EQ(mujoco.moment_per_load, 0.005);
  EXPECT_NEAR(mujoco.radius, 0.005 * 16.0 / (3.0 * std::numbers::pi), 1e-17);
  EXPECT_EQ(mujoco.note.find("no fingertip"), std::string::npos);
  // A lever in scenes of grasping hands.
  const CoefficientMeaning maniskill = read_one("maniskill", "min_patch_radius", 0.1, 2.0, uniform());
  EXPECT_NEAR(maniskill.moment_per_load, 0.2, 1e-15);
  EXPECT_NEAR(maniskill.radius, 0.15, 1e-15);
  expect_mention(maniskill.note, "no fingertip");
  // An area: 37 times less than the contact of this radius bears.
  EXPECT_NEAR(read_one("dexnet", "finger_radius", 0.005, 0.5, hertz()).moment_per_load, 0.5 * std::numbers::pi * 25e-6,
              1e-19);
  // Rolling and sliding friction set no moment about the normal.
  for (const auto& [engine, parameter] :
       {std::pair{"mujoco", "rolling"}, std::pair{"dart", "friction"}, std::pair{"pybullet", "rolling"}}) {
    EXPECT_TRUE(std::isnan(read_one(engine, parameter, 0.1, 0.5, hertz()).radius));
  }
  for (const auto& [engine, parameter] :
       {std::pair{"mujocco", "torsional"}, std::pair{"mujoco", "torsion"}, std::pair{"dart", "torsional"}}) {
    EXPECT_THROW(read_one(engine, parameter, 0.1, 0.5, hertz()), std::invalid_argument);
  }
  // A radius needs a friction.
  for (const auto& [value, mu] : {std::pair{-1e-3, 0.5}, {nan, 0.5}, {1e-3, 0.0}, {1e-3, nan}})
    EXPECT_THROW(read_one("mujoco", "torsional", value, mu, hertz()), std::invalid_argument);
}

// A part of a note that is for some values, "[>0] …", is shown for those alone.
TEST(EngineCoefficients, NotesBelongToValues) {
  int parts = 0;
  for (const Facts& row : all_coefficients()) {
    if (row.at("word").empty()) continue;
    for (const std::string& engine : words(row.at("engine"))) {
      const std::string& formula = row.at("formula");
      const double own = find_formula(formula) != nullptr ? 0.0024 : std::stod(formula);
      for (const double value : {0.0, own, 6.0, 2000.0}) {
        const std::string told = "; " + read_one(engine, row.at("parameter"), value, 0.8, hertz()).note + ";";
        std::istringstream note(row.at("note"));
        for (std::string part; std::getline(note >> std::ws, part, ';');) {
          const std::size_t end = part.front() == '[' ? part.find(']') : std::string::npos;
          if (end == std::string::npos) continue;
          const bool bound = part[1] == '>' || part[1] == '<';
          const double number = std::stod(part.substr(bound ? 2 : 1));
          const bool meant = part[1] == '>' ? value > number : part[1] == '<' ? value < number : value == number;
          EXPECT_EQ(told.find("; " + part.substr(end + 2) + ";") != std::string::npos, meant)
              << engine << told << value;
          ++parts;
        }
        EXPECT_EQ(told.find('['), std::string::npos) << told;
      }
    }
  }
  EXPECT_GT(parts, 100);
  // Without dContactAxisDep rho is the limit of spin; a lever that grows with the depth is one, too.
  EXPECT_EQ(read_one("ode", "rho", 0.02, 0.5, hertz()).moment_per_load, 0.02);
  EXPECT_TRUE(std::isnan(read_one("ode", "rho", 0.0, nan, hertz()).moment_per_load));
  EXPECT_NEAR(read_one("isaac", "torsional_patch_radius", 0.05, 0.5, hertz()).moment_per_load,
              0.5 * std::sqrt(0.05 * 1e-4), 1e-17);
}

TEST(EngineCoefficients, NumbersOfOneEngineBelongTogether) {
  struct Case {
    std::vector<EngineNumber> numbers;  // the last one is asked
    double moment;
    double radius;  // under uniform pressure: of lever 2/3
    const char* note;
  };
  const double gazebo = 3.0 * std::numbers::pi / 16.0;
  const std::vector<Case> cases{
      // Gazebo multiplies by its own coefficient, 1 by default, and not by the friction of the force.
      {{{"gazebo", "patch_radius", 0.01}}, gazebo * 0.01, gazebo * 0.01 / 0.5 * 1.5, "with coefficient 1, the default"},
      {{{"gazebo", "coefficient", 10.0}, {"gazebo", "patch_radius", 0.02}},
       gazebo * 0.2,
       gazebo * 0.2 / 0.5 * 1.5,
       "no fingertip"},
      {{{"gazebo", "mu", 3.0}, {"gazebo", "patch_radius", 0.01}}, gazebo * 0.01, gazebo * 0.01 / 3.0 * 1.5, "default"},
      {{{"gazebo", "coefficient", 0.0}, {"gazebo", "patch_radius", 0.02}}, 0.0, 0.0, "; no moment"},
      {{{"gazebo", "use_patch_radius", 0.0}, {"gazebo", "patch_radius", 0.02}},
       0.0,
       0.0,
       "needs use_patch_radius 1; no moment"},
      // Another engine's numbers do not matter, and a parameter that comes again begins another contact.
      {{{"gazebo", "use_patch_radius", 0.0}, {"mujoco", "torsional", 0.005}},
       0.005,
       0.015,
       "if condim 4: the default is 3"},
      {{{"mujoco", "condim", 3.0}, {"mujoco", "condim", 4.0}, {"mujoco", "torsional", 0.005}}, 0.005, 0.015, ""},
      {{{"mujoco", "torsional", 0.005}, {"mujoco", "condim", 3.0}, {"mujoco", "torsional", 0.005}},
       0.005,
       0.015,
       "if condim 4"},
      {{{"mujoco", "condim", 3.0}, {"mujoco", "torsional", 0.005}}, 0.0, 0.0, "needs condim 4; no moment"},
      {{{"mujoco", "friction", 1.0}, {"mujoco", "torsional", 0.005}}, 0.005, 0.0075, ""},
      {{{"mujoco", "pair.condim", 3.0}, {"mujoco", "pair.torsional", 0.005}}, 0.0, 0.0, "needs pair.condim 4"},
      {{{"genesis", "enable_torsional_friction", 0.0}, {"genesis", "torsional", 0.005}},
       0.0,
       0.0,
       "needs enable_torsional_friction 1"},
      // What another number switches off; 1 is Gazebo's default of use_patch_radius.
      {{{"gazebo", "use_patch_radius", 1.0}, {"gazebo", "surface_radius", 0.02}},
       0.0,
       0.0,
       "needs use_patch_radius 0;"},
      {{{"gazebo", "surface_radius", 0.02}}, 0.0, 0.0, "needs use_patch_radius 0: the default is 1; no moment"},
      {{{"gazebo", "use_patch_radius", 0.0}, {"gazebo", "surface_radius", 0.01}},
       gazebo * 0.001,
       gazebo * 0.001 / 0.5 * 1.5,
       "depth"},
      {{{"webots", "rhoN", 0.002}, {"webots", "rho", 0.5}}, 0.0, 0.0, "needs rollingFriction[2] 0; no moment"},
      {{{"webots", "rho2", 0.3}, {"webots", "rho", 0.5}}, 0.0, 0.0, "needs rollingFriction[1] 0; no moment"},
      {{{"webots", "rhoN", 0.0}, {"webots", "rho", 0.005}}, 0.005, 0.015, "limits spin too"},
      {{{"ode", "rhoN", 0.002}, {"ode", "rho", 0.005}}, 0.0, 0.0, "needs rhoN 0; no moment"},
      // PhysX multiplies by the friction of sliding.
      {{{"physx", "static_friction", 0.9}, {"physx", "dynamic_friction", 0.8}, {"physx", "min_patch_radius", 0.01}},
       0.008,
       0.015,
       ""},
      {{{"physx", "static_friction", 0.9}, {"physx", "min_patch_radius", 0.01}}, 0.009, 0.015, ""},
      {{{"isaac", "min_patch_radius", 0.0}}, 0.0, 0.0, "; no moment"},
      {{{"mujoco", "friction", 0.0}, {"mujoco", "torsional", 0.0}}, 0.0, 0.0, "; no moment"},
  };
  for (const Case& one : cases) {
    const CoefficientMeaning meaning = read_coefficients(one.numbers, 0.5, uniform()).back();
    EXPECT_NEAR(meaning.moment_per_load, one.moment, 1e-15 * one.moment) << meaning.parameter << " " << meaning.note;
    EXPECT_NEAR(meaning.radius, one.radius, 1e-15 * one.radius) << meaning.parameter << " " << meaning.note;
    expect_mention(meaning.note, one.note);
    EXPECT_EQ(meaning.note.find("fingertip") != std::string::npos, one.radius > 0.02) << meaning.note;
  }
}

TEST(EngineCoefficients, APatchThatIsADiscIsTranslatedAsOne) {
  const std::vector<EngineContact> disc = translate(hertz(), RadiusLaw::constant(0.005), 0.8, 3.0);
  const std::vector<EngineContact> patch = translate(Patch::ellipse(hertz(), 0.005, 0.005), 0.8);
  ASSERT_EQ(patch.size(), disc.size());
  for (std::size_t i = 0; i < disc.size(); ++i) {
    EXPECT_EQ(patch[i].engine, disc[i].engine);
    for (std::size_t k = 0; k < disc[i].coefficients.size(); ++k) {
      EXPECT_NEAR(patch[i].coefficients[k].value, disc[i].coefficients[k].value, 1e-12);
    }
    EXPECT_NEAR(patch[i].error.max_over_estimate, disc[i].error.max_over_estimate, 1e-6) << disc[i].model;
    EXPECT_NEAR(patch[i].error.max_under_estimate, disc[i].error.max_under_estimate, 1e-6) << disc[i].model;
    EXPECT_NEAR(patch[i].max_wrench_error, disc[i].max_wrench_error, 1e-2) << disc[i].model;
  }
  // Two points far apart: a pure spin bears all of the load at half their distance. About one of them only the other
  // slides, with half the power that the box needs.
  constexpr std::array points{PatchLoad{-0.01, 0.0, 1.0}, PatchLoad{0.01, 0.0, 1.0}};
  for (const EngineContact& contact : translate(Patch::points(points), 0.5)) {
    if (contact.engine == "chrono") {
      EXPECT_NEAR(coefficient(contact, "SetSpinningFriction"), 0.5 * 0.01, 1e-17);
    }
    if (contact.model == "box") {
      EXPECT_NEAR(contact.error.max_over_estimate, 1.0, 1e-6);
    }
    if (contact.model == "point") {
      EXPECT_EQ(contact.error.max_under_estimate, 1.0);
    }
  }
}

/// The largest distance in the normalised plane of both wrenches of one slip; the ellipse's has the direction (s, 1), s
/// = c/(m₀ a).
double largest_distance_of_wrenches(const Law& law) {
  const double m0 = law->moment_ratio();
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const double s = std::tan(0.5 * std::numbers::pi * (i + 0.5) / 500);
    const UnitForces<double> exact = law->forces(m0 * s);
    worst =
        std::max(worst, std::hypot(exact.force - s / std::hypot(s, 1.0), exact.moment / m0 - 1.0 / std::hypot(s, 1.0)));
  }
  return worst;
}

TEST(EngineCoefficients, ErrorsAreThoseOfTheShapes) {
  for (const EngineContact& contact : translate(hertz(), RadiusLaw::constant(0.005), 0.8, 3.0)) {
    // A constant radius is followed by constant coefficients.
    EXPECT_NEAR(contact.max_error_over_loads, contact.error.max_error, 1e-12);
    if (contact.model == "ellipse") {
      EXPECT_NEAR(contact.error.max_error, 0.0638, 6e-5);
      // At the same COR: measured in the engine itself as 0.14.
      EXPECT_NEAR(contact.max_wrench_error, largest_distance_of_wrenches(hertz()), 1e-4);
    } else if (contact.model == "box") {
      EXPECT_GT(contact.error.max_over_estimate, 0.45);
      EXPECT_LE(contact.error.max_under_estimate, 1e-12);
      // Just off pure sliding the box still gives the whole moment.
      EXPECT_NEAR(contact.max_wrench_error, 1.0, 1e-3);
    } else if (contact.model == "diamond") {
      EXPECT_GT(contact.error.max_under_estimate, 0.2);
      EXPECT_LE(contact.error.max_over_estimate, 1e-12);
    } else {
      EXPECT_EQ(contact.model, "point");
      EXPECT_EQ(contact.error.max_under_estimate, 1.0);
      // Just off a pure twist the force is whole and the moment missing.
      EXPECT_NEAR(contact.max_wrench_error, std::sqrt(2.0), 1e-6);
    }
  }
}

TEST(EngineCoefficients, ConstantCoefficientsCannotFollowAGrowingRadius) {
  const EngineContact ellipse = translate(hertz(), silicone, 0.8, 3.0, {1.5, 6.0}).front();
  // At half the load the radius is 2^-0.259 of what it was, and the moment's limit 2^0.259 = 1.197 times too large.
  EXPECT_NEAR(ellipse.max_error_over_loads, std::pow(2.0, 0.259) - 1.0, 1e-3);
}

// Once, for a Gaussian of sigma = 1e-3, the error at the same COR was sampled at its ends only.
TEST(EngineCoefficients, ErrorsDoNotDependOnTheUnitOfLength) {
  const auto errors = [](double sigma, double radius, double load) {
    std::vector<double> all;
    for (const EngineContact& contact : translate(gaussian(sigma), RadiusLaw::power(radius, 0.25), 0.8, load)) {
      all.insert(all.end(), {contact.error.max_error, contact.max_wrench_error, contact.max_error_over_loads});
    }
    return all;
  };
  const std::vector<double> expected = errors(1.0, 0.005, 1.0);
  for (const auto& [sigma, radius, load] :
       {std::array{1e-6, 0.005, 1.0}, {1e-3, 5.0, 1.0}, {1e6, 1e-9, 1.0}, {1.0, 0.005, 1e3}}) {
    const std::vector<double> found = errors(sigma, radius, load);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]) << sigma << ' ' << i;
  }
}

TEST(EngineCoefficients, RefuseBadInput) {
  EXPECT_THROW(translate(hertz(), silicone, -1.0, 3.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, nan, 3.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 0.0), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 3.0, {4.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(translate(hertz(), silicone, 0.8, 3.0, {0.0, 2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::engines
