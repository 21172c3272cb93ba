// SPDX-License-Identifier: MIT
// The gains that the formulas call passive or stable, against energy counted in a sampled wall and a body let go.
#include "godobject/scene/passivity.hpp"

#include "tests/godobject/scene/metamorphic/energy_search.hpp"
#include "tests/integrators.hpp"

#include <Eigen/Eigenvalues>

namespace limitcurve::godobject::test::passivity_test {
namespace {

constexpr double sample_time = 1e-3;

FingerParameters gains(double stiffness, double damping, double twist_stiffness, double twist_damping) {
  FingerParameters result = parameters(0.6, 0.005, stiffness, twist_stiffness);
  result.damping = damping;
  result.twist_damping = twist_damping;
  return result;
}

const FingerParameters choices[] = {gains(1000.0, 0.0, 0.04, 0.0), gains(1000.0, 0.4, 0.04, 1e-5),
                                    gains(50.0, 2.0, 0.001, 1e-4)};

// A thousandth less, and a user who goes to and fro with every sample gets energy from each channel without end.
TEST(Passivity, AThousandthLessGivesEnergyWithoutEnd) {
  for (const FingerParameters& with : choices) {
    const DeviceDamping enough = device_damping_needed(with, sample_time);
    for (const double share : {0.999, 1.001}) {
      for (int channel = 0; channel < 3; ++channel) {
        SampledUser user(hertz_finger(with), {share * enough.sliding, share * enough.twist}, sample_time, 0);
        double after_start = 0.0;
        for (int i = 0; i < 3000; ++i) {
          const double side = i % 2 == 0 ? 1.0 : -1.0;
          const Vector3d way{channel == 0 ? side * 1e-5 : 0.0, 0.0, channel == 1 ? side * 1e-5 : 0.0};
          user.move(AnySurface(PlaneSurface{}),
                    {way - Vector3d(0.0, 0.0, 0.002), {1.0, 0.0, 0.0, 0.0}, channel == 2 ? side * 1e-4 : 0.0});
          if (i == 99) after_start = user.won().work;
        }
        EXPECT_EQ(user.won().work > after_start, share < 1.0) << channel;
      }
    }
  }
}

TEST(Passivity, ExplicitCouplingEndsWhereSaid) {
  const auto grows = [](double stiffness, double damping, double mass, double twist_stiffness, double twist_damping,
                        double inertia) {
    BodyParameters body;
    body.mass = mass;
    body.inertia.setConstant(inertia);
    body.gravity.setZero();
    body.free = {true, false, false, false, false, true};
    FingerParameters with = gains(stiffness, damping, twist_stiffness, twist_damping);
    with.mu = 1e6;
    const auto finger = hertz_finger(with);
    Grasp grasp(body, BodyState{}, AnySurface(BoxSurface(Vector3d::Constant(0.02))), {finger, finger});
    const std::array devices{DevicePose{{0.0, 0.0, 0.019}}, DevicePose{{0.0, 0.0, -0.019}}};
    grasp.place(BodyState{}, devices);
    BodyState start;
    start.position.x() = 1e-9;
    start.orientation = AngleAxisd(1e-9, Vector3d::UnitZ());
    grasp.place(start, devices);
    for (int i = 0; i < 3000; ++i) step_by(Integrator::symplectic_euler, grasp, devices, sample_time);
    return std::fabs(grasp.body().position.x()) > 1e-8 || std::fabs(grasp.body().orientation.z()) > 1e-8;
  };
  for (const double damping_share : {0.0, 0.3}) {
    for (const double share : {0.98, 1.02}) {
      const double mass = 0.05;
      const double damping = damping_share * mass / sample_time;
      const double stiffness = (4.0 * share * mass / (2.0 * sample_time) - 2.0 * damping) / sample_time;
      EXPECT_NEAR(explicit_coupling(stiffness, damping, mass, sample_time, 2), share, 1e-12);
      // Sliding at its limit with a small twist, and the reverse.
      EXPECT_EQ(grows(stiffness, damping, mass, 1e-3, 1e-5, 1e-3), share > 1.0) << damping_share << ' ' << share;
      EXPECT_EQ(grows(10.0, 0.1, mass, stiffness * 1e-4, damping * 1e-4, mass * 1e-4), share > 1.0)
          << damping_share << ' ' << share;
    }
  }
}

// A planar body, its finger at a distance from the centre of mass: springs and dampers of both kinds act at once.
TEST(Passivity, TheSumOfBothCouplingsIsStableAtAnyLever) {
  const auto growth = [](double mass, double inertia, double lever, double stiffness, double damping, double twist,
                         double twist_damping) {
    const auto across = [&](double along, double about) {
      Eigen::Matrix2d result;
      result << along, along * lever, along * lever, along * lever * lever + about;
      result.row(0) /= mass;
      result.row(1) /= inertia;
      return result;
    };
    Eigen::Matrix4d step = Eigen::Matrix4d::Identity();  // velocities first: v' = v - T M⁻¹(Kx + Cv), x' = x + T v'
    step.bottomLeftCorner<2, 2>() = -sample_time * across(stiffness, twist);
    step.bottomRightCorner<2, 2>() -= sample_time * across(damping, twist_damping);
    step.topRows<2>() += sample_time * step.bottomRows<2>();
    return step.eigenvalues().cwiseAbs().maxCoeff();
  };
  Random random(4);
  int unstable_by_mass_alone = 0;
  for (int i = 0; i < 2000; ++i) {
    const double mass = random.logarithmic(1e-3, 1.0);
    const double inertia = mass * random.logarithmic(1e-6, 1e-2);
    const double lever = random.uniform(0.0, 2.0) * std::sqrt(inertia / mass);
    const double felt = 1.0 / (1.0 / mass + lever * lever / inertia);
    const double damping = random.uniform(0.0, 0.4) * felt / sample_time;
    const double twist_damping = random.uniform(0.0, 0.4) * inertia / sample_time;
    const double share = random.uniform(0.3, 0.7);
    const double stiffness = (4.0 * share * felt / sample_time - 2.0 * damping) / sample_time;
    const double twist = (4.0 * (0.99 - share) * inertia / sample_time - 2.0 * twist_damping) / sample_time;
    EXPECT_NEAR(explicit_coupling(stiffness, damping, felt, sample_time) +
                    explicit_coupling(twist, twist_damping, inertia, sample_time),
                0.99, 1e-12);
    EXPECT_LE(growth(mass, inertia, lever, stiffness, damping, twist, twist_damping), 1.0 + 1e-7) << i;
    // The same by the body's whole mass, as if the finger were at its centre.
    const double stiff = 4.0 * 0.6 * mass / (sample_time * sample_time);
    unstable_by_mass_alone += growth(mass, inertia, lever, stiff, 0.0, 1e-9, 0.0) > 1.001;
  }
  EXPECT_GT(unstable_by_mass_alone, 1000);
}

// A user who goes to and fro against a spring and a damper whose force comes N samples late: at the worst pace he wins
// exactly what the device needs to dissipate, at any other less. A damper helps a late spring, and is late itself.
TEST(Passivity, ALateForceNeedsWhatTheWorstPaceWins) {
  constexpr int samples = 800;  // whole periods, so that what the spring stores drops out
  const auto won = [](double stiffness, double damping, int delay, int periods) {
    const auto place = [&](int i) { return std::cos(2.0 * std::numbers::pi * periods * i / samples); };
    const auto force = [&](int i) { return -stiffness * place(i) - damping * (place(i) - place(i - 1)) / sample_time; };
    double work = 0.0, squares = 0.0;
    for (int i = 0; i < samples; ++i) {
      const double step = place(i + 1) - place(i);
      work += force(i - delay) * step;
      squares += step * step;
    }
    return sample_time * work / squares;
  };
  for (const int delay : {0, 1, 2, 5}) {
    for (const double damping : {0.0, 0.05, 0.4, 3.0, -0.4}) {
      const double needed = device_damping_needed(1000.0, damping, sample_time, delay);
      EXPECT_LE(needed, (delay + 0.5) + std::fabs(damping) + 1e-12);
      double most = 0.0;
      for (int i = 1; i <= samples / 2; ++i) most = std::max(most, won(1000.0, damping, delay, i));
      EXPECT_LE(most, needed * (1.0 + 1e-9)) << delay << ' ' << damping;
      EXPECT_GE(most, needed * 0.99) << delay << ' ' << damping;
    }
  }
}

// The energy that a finger gives in uneven steps is a form of the way in each; its largest eigenvalue is what the worst
// hand gains, and at most what is said to be needed.
TEST(Passivity, UnevenStepsNeedWhatTheWorstHandGains) {
  Random random(71);
  for (const double spread : {1.0, 1.3, 3.0, 20.0, 100.0}) {
    for (FingerParameters with : choices) {
      with.mu = 1e6;
      std::vector<double> steps(40);
      for (double& step : steps) step = random.logarithmic(1e-3, 1e-3 * spread);
      const Eigen::Index count = 40;
      Eigen::MatrixXd form = Eigen::MatrixXd::Zero(count, count);
      for (Eigen::Index i = 0; i < count; ++i) {
        const double step = steps[static_cast<std::size_t>(i)];
        form(i, i) = 0.5 * with.stiffness * step;
        if (i > 0)
          form(i, i - 1) = form(i - 1, i) =
              -0.5 * with.damping * std::sqrt(step / steps[static_cast<std::size_t>(i - 1)]);
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(form);
      const double most = solver.eigenvalues()[count - 1];
      SoftFinger finger = hertz_finger(with);
      finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
      double x = 0.0, force = 0.0, given = -finger.spring_energy();
      for (Eigen::Index i = 0; i < count; ++i) {
        const double step = steps[static_cast<std::size_t>(i)];
        const double way = 1e-2 * std::sqrt(step) * solver.eigenvectors()(i, count - 1);
        given += force * way;
        x += way;
        force = finger.update(on_plane(x, 0.0, 0.002), 0.0, step).force.x();
      }
      given += finger.spring_energy();
      EXPECT_NEAR(given, 1e-4 * most, 1e-9 * most) << spread;
      const double needed = device_damping_needed(with, steps).sliding;
      EXPECT_GE(needed, most * (1.0 - 1e-12)) << spread;
      EXPECT_LE(needed, most * (with.damping > 0.0 ? 2.5 : 1.0 + 1e-12)) << spread;
      EXPECT_TRUE(spread > 1.0 || needed == device_damping_needed(with, 1e-3).sliding);
    }
  }
  // With a delay a bound; a gap has no neighbours.
  const double uneven[] = {1e-3, 4e-3, infinity, 1e-3};
  EXPECT_DOUBLE_EQ(device_damping_needed(1000.0, 0.4, uneven), 2.4);
  EXPECT_DOUBLE_EQ(device_damping_needed(1000.0, 0.4, uneven, 1), 6.4);
}

TEST(Passivity, SaysWhatToChange) {
  const FingerParameters with = gains(1000.0, 0.4, 0.04, 1e-5);
  EXPECT_EQ(device_damping_needed(1000.0, 0.4, 1e-3), 0.9);
  EXPECT_EQ(device_damping_needed(1000.0, -0.4, 1e-3), 0.9);
  EXPECT_EQ(device_damping_needed(1000.0, 0.0, 1e-3, 2), 2.5);
  EXPECT_NO_THROW(require_passive(with, sample_time, {0.91, 1.0}));
  const auto refused = [&](DeviceDamping device, double time, const char* told) {
    expect_mention(complaint([&] { require_passive(with, time, device); }), told);
  };
  refused({0.65, 1.0}, sample_time, "more than 0.9 N s/m, got 0.65; expected a stiffness below 500");
  refused({0.3, 1.0}, sample_time, "less damping");
  // What a shorter sample time does not mend.
  EXPECT_TRUE(complaint([&] { require_passive(with, 1e-3, {0.3, 1.0}); }).ends_with("less damping and stiffness"));
  constexpr double uneven[] = {1e-3, 1e-5, 1e-3};
  EXPECT_TRUE(complaint([&] {
                require_passive(with, uneven, {2.0, 1.0});
              })
                  .ends_with("more than 2.5 N s/m, got 2; expected less damping and stiffness, or time steps that "
                             "differ less"));
  refused({1.0, 1e-5}, sample_time, "twist");
  refused({-1.0, 1.0}, sample_time, "damping of the device");
  refused({1.0, 1.0}, 0.0, "sample_time");
  const FingerParameters late = gains(1000.0, 2.0, 0.04, 1e-5);
  expect_mention(complaint([&] { require_passive(late, 1e-3, {2.56, 1.0}, 1); }), "expected a stiffness below 995.998");
  EXPECT_NO_THROW(require_passive(gains(995.99, 2.0, 0.04, 1e-5), 1e-3, {2.56, 1.0}, 1));
}

}  // namespace
}  // namespace limitcurve::godobject::test::passivity_test
