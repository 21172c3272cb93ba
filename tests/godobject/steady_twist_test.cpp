// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::steady_twist_test {
namespace {

constexpr double mu = 0.6;
constexpr double radius = 0.005;
constexpr double stiffness = 1000.0;
constexpr double depth = 0.002;
constexpr double load = stiffness * depth;

/// A finger whose device turns about a centre fixed in space: wrench and COR that it settles at, and by how much the
/// force lags the device.
struct Trailing {
  double cor;     ///< c′ [m]
  double force;   ///< [N]
  double moment;  ///< [N m]
  double lag;     ///< angle from the device's velocity to the force that drags the proxy [rad]
};

/// F(c) and M(c).
const Law pressure = hertz();
double hertz_force(double cor) {
  return mu * load * pressure->forces(cor / radius).force;
}
double hertz_moment(double cor) {
  return mu * load * radius * pressure->forces(cor / radius).moment;
}
/// The law: the proxy runs on a circle of radius c′ and is dragged along its path, so that springs and damper in line,
/// k_l + iωb, stretch by e = iF/(k_l + iωb), and the device is at c′ + e: c² = (c′ + Fωb/K²)² + (F k_l/K²)², K² = k_l²
/// + (ωb)². `drag` is ωb [N/m].
Trailing trailing_by_law(double c, double k, double drag) {
  const double square = k * k + drag * drag;
  double low = 0.0;
  double high = c;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    const double force = hertz_force(middle);
    (std::hypot(middle + force * drag / square, force * k / square) < c ? low : high) = middle;
  }
  const double force = hertz_force(low);
  return {low, force, hertz_moment(low), std::asin(force * k / (square * c))};
}

// docs/theory.md, "The step": about a centre that stays, a finger is a trailer: to four digits at 1 mrad a step.
TEST(SteadyTwist, AboutAFixedCentreTheFingerTrails) {
  const Table table = Table::build(hertz(), 1e-8);
  constexpr double rate = 2.0;  // [rad/s]
  for (const double c : {0.3 * radius, 0.9 * radius}) {
    for (const auto& [k, damping] : {std::pair{1000.0, 0.0}, {5000.0, 0.0}, {1000.0, 200.0}, {5000.0, 1000.0}}) {
      for (const double twist_stiffness : {0.004, 0.04}) {
        const Trailing law = trailing_by_law(c, k, rate * damping);
        const std::string where =
            "c " + std::to_string(c) + " k " + std::to_string(k) + " b " + std::to_string(damping);
        FingerParameters soft = parameters(mu, radius, k, twist_stiffness);
        soft.damping = damping;
        SoftFinger finger(table, soft);
        constexpr double step = 1e-3;
        double angle = 0.0;
        for (int i = 0; i <= 12000; ++i) {
          angle = step * i;
          finger.update(on_plane(c * std::cos(angle), c * std::sin(angle), load / k), angle, step / rate);
        }
        const FingerOutput& output = finger.output();
        const double lag = angle + 1.5 * std::numbers::pi - std::atan2(output.force.y(), output.force.x());
        EXPECT_NEAR(output.force.norm(), law.force, 1e-4 * mu * load) << where;
        EXPECT_NEAR(std::fabs(output.moment), law.moment, 1e-4 * mu * load * radius) << where;
        EXPECT_NEAR(output.cor, law.cor, 1e-4 * radius) << where;
        EXPECT_NEAR(std::remainder(lag, 2.0 * std::numbers::pi), law.lag, 1e-3) << where;
      }
    }
  }
}

/// Slip, in lengths max(μP/k_l, aΓ/k_r), after which a finger that starts from rest stays within
/// accuracy::steady_wrench of eq. (17), under a twist about s = c/a at the stiffness ratio κ, with a radius that grows
/// with the load. Twice `longest` is looked at.
double settled_after(const Law& law, const Table& table, double kappa, double s, double pressed, double longest) {
  const double m0 = law->moment_ratio();
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  const double a = soft.radius_law.radius(stiffness * pressed);
  soft.twist_stiffness = kappa * stiffness * (m0 * a) * (m0 * a);
  SoftFinger finger(table, soft);
  const double limit = mu * stiffness * pressed;
  const double length = std::max(limit / stiffness, a * limit * m0 * a / soft.twist_stiffness);
  const double u = SlipTwist::about_cor(s).spin_fraction();
  const UnitWrench expected = law->evaluate(s).wrench;
  const double step = std::min(0.05 * length, 2.0 * a / u);
  double last = 0.0;
  for (int n = 0; n * step <= 2.0 * longest * length; ++n) {
    finger.update(on_plane(n * step * (1.0 - u), 0.0, pressed), n * step * u / a);
    const UnitWrench felt = unit_wrench(finger.state(), mu, a);
    if (std::hypot(felt.force - expected.force, felt.moment - expected.moment) > accuracy::steady_wrench)
      last = n * step;
  }
  return last / length;
}

// Stiffness ratios and centres of rotation over six decades each, every half decade, and where the transient is
// longest, at light and heavy loads: eq. (17) at once, and the transient no longer than docs/theory.md says.
TEST(SteadyTwist, ForgetsTheStartInTheLengthDocumented) {
  const auto forgets = [](const Law& law, double longest, double kappa, double s) {
    const Table table = Table::build(law, 1e-8);
    for (int i = -6; i <= 6; ++i) {
      for (int j = -6; j <= 6; ++j) {
        const double pressed = (i + j) % 2 == 0 ? 0.002 : 0.0002;
        EXPECT_LT(settled_after(law, table, std::pow(10.0, 0.5 * i), std::pow(10.0, 0.5 * j), pressed, longest),
                  longest)
            << law->name() << ": kappa 10^" << 0.5 * i << " s 10^" << 0.5 * j;
      }
    }
    const double found = settled_after(law, table, kappa, s, 0.002, longest);
    EXPECT_LT(found, longest) << law->name();
    // And the bound is no idle one.
    EXPECT_GT(found, 0.8 * longest) << law->name();
  };
  forgets(hertz(), 40.0, 1.7, 0.74);
  forgets(flat_punch(), 60.0, 1.3, 0.99);
  // Where 24 lengths were said to be enough.
  EXPECT_GT(settled_after(hertz(), Table::build(hertz(), 1e-8), 1.88, 0.78, 0.002, 40.0), 24.0);
}

// The path of a finger that slides and turns through a bend: with half the time step it is at least twice as near to
// the path of very small steps.
TEST(SteadyTwist, HalvingTheTimeStepHalvesThePathError) {
  const FingerCurve curve = exact_curve(uniform());
  const auto run = [&](int steps) {
    SoftFinger finger(curve, parameters());
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      finger.update(on_plane(0.01 * t, 0.01 * t * t, depth), 2.0 * t * t * t);
    }
    const FingerOutput output = finger.output();
    return Vector3d(output.proxy.x() / radius, output.proxy.y() / radius, output.angle);
  };
  const Vector3d limit = run(1 << 17);
  double last = (run(64) - limit).norm();
  EXPECT_GT(last, 1e-5);
  for (int steps = 128; steps <= 2048; steps *= 2) {
    const double error = (run(steps) - limit).norm();
    EXPECT_LT(error, 0.55 * last) << steps;
    last = error;
  }
}

// What docs/paper.md says of eq. (23) and of the c-curve where the radius grows with the load: 0.255 N, and 0.438,
// 0.416, 0.4135 N in steps of 100, 10, 1 µm, where eq. (17) has 0.487 N.
TEST(SteadyTwist, GrowingRadius) {
  const Table table = Table::build(hertz(), 1e-8);
  const auto force = [&](Projection projection, double step) {
    FingerParameters with = parameters(0.6, 0.006, 1000.0, 0.036);
    with.radius_law = RadiusLaw::power(0.006, 1.0 / 3.0);
    SoftFinger finger(table, with, projection);
    const int count = static_cast<int>(std::lround(0.04 / step));
    for (int i = 0; i <= count; ++i) finger.update(on_plane(step * i, 0.0, 0.001), step * i / 0.005);
    return finger.output().force.norm();
  };
  EXPECT_NEAR(force(Projection::radial, 1e-5), 0.255, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-4), 0.438, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-5), 0.416, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-6), 0.4135, 0.0005);
  // (3π/8)s(1 − s²/4), s = 5/6.
  const double s = 5.0 / 6.0;
  EXPECT_NEAR(force(Projection::closest_point, 1e-5), 0.6 * 3.0 * std::numbers::pi / 8.0 * s * (1.0 - 0.25 * s * s),
              1e-7);
}

}  // namespace
}  // namespace limitcurve::godobject::test::steady_twist_test
