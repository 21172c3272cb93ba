// SPDX-License-Identifier: MIT
// Values that others printed, each with its source: nobody here chose them.
#include "limitcurve/validate/validate.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {
namespace {

UnitWrench at(const Law& law, double s) {
  return law->evaluate(s).wrench;
}

/// d(v/ωR)/dt of a free body with a radius of gyration k R, but for a positive factor: 0 where the
/// ratio s of its two velocities stays.
double drift(const Law& law, double s, double square_of_gyration) {
  const UnitWrench unit = at(law, s);
  return s * unit.moment - square_of_gyration * unit.force;
}

// Farkas, Bartels, Unger, Wolf, Phys. Rev. Lett. 90:248302, 2003; Voyenli, Eriksen, Am. J. Phys.
// 53:1149, 1985: a uniform disc that slides and spins ends both at once, at v/ωR = 0.653, a thin
// ring at 1.
TEST(Published, ADiscStopsAt0653AndARingAt1) {
  EXPECT_LT(drift(uniform(), 0.6525, 0.5) * drift(uniform(), 0.6535, 0.5), 0.0);
  EXPECT_LT(drift(power(-0.9999), 0.9995, 1.0) * drift(power(-0.9999), 1.0005, 1.0), 0.0);
}

// Weidman, Malhotra, Physica D 233:1, 2007, after Goyal, Ruina, Papadopoulos, Wear 143:331, 1991:
// on a uniform disc a body whose radius of gyration is below ½ ends with a pure slide, above √⅔
// with a pure spin.
TEST(Published, RegimesOfTheLastMotionChangeAtTwoRadiiOfGyration) {
  EXPECT_NEAR(drift(uniform(), 1e9, 1.0 / 4.0), 0.0, 1e-15);
  EXPECT_NEAR(drift(uniform(), 1e-9, 2.0 / 3.0) / 1e-9, 0.0, 1e-15);
}

// Goyal, Ruina, Papadopoulos, Wear 143:307, 1991: a thin ring, by complete elliptic integrals of modulus 2√s/(1+s).
TEST(Published, ARing) {
  for (const double s : {0.5, 2.0}) {
    const double modulus = 2.0 * std::sqrt(s) / (1.0 + s);
    const double first = std::comp_ellint_1(modulus);
    const double second = std::comp_ellint_2(modulus);
    EXPECT_NEAR(at(power(-0.9999), s).force, ((1.0 + s) * second - (1.0 - s) * first) / (std::numbers::pi * s), 1e-4);
    EXPECT_NEAR(at(power(-0.9999), s).moment, ((1.0 + s) * second + (1.0 - s) * first) / std::numbers::pi, 1e-4);
  }
}

// Zhuravlev, J. Appl. Math. Mech. 62:705, 1998, Hertz: F = μP v/(v + 8ωa/3π), M = M₀ ωa/(ωa + 15πv/16).
TEST(Published, ZhuravlevsTwoNumbers) {
  const PadeModel model = pade_model(ExactCurve(hertz()));
  EXPECT_NEAR(model.force_cor(), 8.0 / (3.0 * std::numbers::pi), 1e-13);
  EXPECT_NEAR(model.moment_cor(), 16.0 / (15.0 * std::numbers::pi), 1e-13);
}

// Xydas, Kao, Int. J. Robotics Res. 18:941, 1999: C₃ = 1.24049, and the moment 2 C_k ∫ρ²
// (1−ρᵏ)^(1/k) dρ, a beta function.
TEST(Published, MomentsOfXydasAndKao) {
  EXPECT_NEAR(xydas_kao(3.0)->density(RadialPosition<double>{0.0, 1.0}), 1.24049, 5e-6);
  for (const double k : {1.5, 2.0, 3.0, 5.0, 10.0, 1000.0}) {
    const double coefficient = 1.5 * k * std::tgamma(3.0 / k) / (std::tgamma(1.0 / k) * std::tgamma(2.0 / k));
    EXPECT_NEAR(xydas_kao(k)->moment_ratio(), 2.0 * coefficient / k * std::beta(3.0 / k, 1.0 + 1.0 / k), 1e-14) << k;
  }
}

// Lubkin, J. Appl. Mech. 18:183, 1951; Contensou, 1963, and Leine, Glocker, Eur. J. Mech. A
// 22:193, 2003: a Hertz contact that spins, and one that turns about its rim.
TEST(Published, HertzInTheMiddleAndAtTheRim) {
  EXPECT_DOUBLE_EQ(at(hertz(), 0.0).moment, 3.0 * std::numbers::pi / 16.0);
  EXPECT_DOUBLE_EQ(at(hertz(), 1.0).force, 9.0 * std::numbers::pi / 32.0);
  EXPECT_DOUBLE_EQ(at(hertz(), 1.0).moment, 9.0 * std::numbers::pi / 128.0);
}

// Friction's power is a mean distance. Larson, Odoni, Urban Operations Research, 1981, Table 3-1:
// 128/45π between two points of a disc, and by Crofton's method (problem 3.20) 5/4 of it from a
// point of its rim.
TEST(Published, MeanDistances) {
  const UnitWrench rim = at(uniform(), 1.0);
  EXPECT_DOUBLE_EQ(rim.force + rim.moment, 5.0 / 4.0 * 128.0 / (45.0 * std::numbers::pi));
}

}  // namespace
}  // namespace limitcurve::test
