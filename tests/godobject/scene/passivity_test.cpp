// SPDX-License-Identifier: MIT
// The gains that the formulas call passive or stable, against energy counted in a sampled wall and a body let go.
#include "godobject/scene/passivity.hpp"

#include "tests/godobject/scene.hpp"
#include "tests/integrators.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace limitcurve::godobject::test::passivity_test {
namespace {

constexpr double sample_time = 1e-3;

FingerParameters gains(double stiffness, double damping, double twist_stiffness, double twist_damping) {
  FingerParameters result = parameters(0.6, 0.005, stiffness, twist_stiffness);
  result.damping = damping;
  result.twist_damping = twist_damping;
  return result;
}

/// A device with its own damping; the user moves it from point to point in straight lines (which damps least between
/// two samples), while the finger's wrench is held for a sample. Counts what the user puts in.
class SampledWall {
 public:
  SampledWall(const FingerParameters& with, DeviceDamping device) : finger_(hertz_finger(with)), device_(device) {}

  void move(double x, double depth, double twist) {
    const FingerOutput output = finger_.update(on_plane(x_, 0.0, depth_), twist_, sample_time);
    const double load = output.state == ContactState::free ? 0.0 : output.load;
    const double slide = x - x_;
    const double press = depth - depth_;
    const double turn = twist - twist_;
    // The rendered force pulls back: the user works against it, and against the device's damper at the speed of the straight line.
    energy_ += load * press - output.force.x() * slide - output.moment * turn;
    energy_ += (device_.sliding * (slide * slide + press * press) + device_.twist * turn * turn) / sample_time;
    x_ = x;
    depth_ = depth;
    twist_ = twist;
  }
  [[nodiscard]] double energy() const { return energy_; }

 private:
  SoftFinger finger_;
  DeviceDamping device_;
  double x_ = 0.0;
  double depth_ = -1e-3;
  double twist_ = 0.0;
  double energy_ = 0.0;
};

const FingerParameters choices[] = {gains(1000.0, 0.0, 0.04, 0.0), gains(1000.0, 0.4, 0.04, 1e-5), gains(50.0, 2.0, 0.001, 1e-4)};

// A thousandth less, and a user who goes to and fro with every sample gets energy from each channel without end.
TEST(Passivity, AThousandthLessGivesEnergyWithoutEnd) {
  for (const FingerParameters& with : choices) {
    const DeviceDamping enough = device_damping_needed(with, sample_time);
    for (const double share : {0.999, 1.001}) {
      for (int channel = 0; channel < 3; ++channel) {
        SampledWall wall(with, {share * enough.sliding, share * enough.twist});
        double after_start = 0.0;
        for (int i = 0; i < 3000; ++i) {
          const double side = i % 2 == 0 ? 1.0 : -1.0;
          wall.move(channel == 0 ? side * 1e-5 : 0.0, channel == 1 ? 0.002 + side * 1e-5 : 0.002, channel == 2 ? side * 1e-4 : 0.0);
          if (i == 99) after_start = wall.energy();
        }
        if (share < 1.0) {
          EXPECT_LT(wall.energy(), after_start) << channel;
        } else {
          EXPECT_GT(wall.energy(), after_start) << channel;
        }
      }
    }
  }
}

TEST(Passivity, ExplicitCouplingEndsWhereSaid) {
  const auto grows = [](double stiffness, double damping, double mass, double twist_stiffness, double twist_damping, double inertia) {
    BodyParameters body;
    body.mass = mass;
    body.inertia.setConstant(inertia);
    body.gravity.setZero();
    body.free = {true, false, false, false, false, true};
    FingerParameters with = gains(stiffness, damping, twist_stiffness, twist_damping);
    with.mu = 1e6;
    const auto finger = hertz_finger(with);
    Grasp grasp(body, BodyState{}, AnySurface(BoxSurface(Eigen::Vector3d::Constant(0.02))), {finger, finger});
    const std::array devices{DevicePose{{0.0, 0.0, 0.019}}, DevicePose{{0.0, 0.0, -0.019}}};
    grasp.place(BodyState{}, devices);
    BodyState start;
    start.position.x() = 1e-9;
    start.orientation = Eigen::AngleAxisd(1e-9, Eigen::Vector3d::UnitZ());
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
      EXPECT_EQ(grows(10.0, 0.1, mass, stiffness * 1e-4, damping * 1e-4, mass * 1e-4), share > 1.0) << damping_share << ' ' << share;
    }
  }
}

// A user who goes to and fro against a spring and a damper whose force comes N samples late: at the worst pace he wins exactly what the device
// needs to dissipate, at any other less. A damper helps a late spring, and is late itself.
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

TEST(Passivity, SaysWhatToChange) {
  const FingerParameters with = gains(1000.0, 0.4, 0.04, 1e-5);
  EXPECT_EQ(device_damping_needed(1000.0, 0.4, 1e-3), 0.9);
  EXPECT_EQ(device_damping_needed(1000.0, -0.4, 1e-3), 0.9);
  EXPECT_EQ(device_damping_needed(1000.0, 0.0, 1e-3, 2), 2.5);
  EXPECT_NO_THROW(require_passive(with, sample_time, {0.91, 1.0}));
  const auto message = [&](DeviceDamping device, double time) -> std::string {
    try {
      require_passive(with, time, device);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(message({0.65, 1.0}, sample_time).find("more than 0.9 N s/m, got 0.65; expected a stiffness below 500"), std::string::npos);
  EXPECT_NE(message({0.3, 1.0}, sample_time).find("less damping"), std::string::npos);
  EXPECT_NE(message({1.0, 1e-5}, sample_time).find("twist"), std::string::npos);
  EXPECT_NE(message({-1.0, 1.0}, sample_time).find("damping of the device"), std::string::npos);
  EXPECT_NE(message({1.0, 1.0}, 0.0).find("sample_time"), std::string::npos);
}

}  // namespace
}  // namespace limitcurve::godobject::test::passivity_test
