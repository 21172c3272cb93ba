// SPDX-License-Identifier: MIT
// A finger in an existing haptic loop: position and orientation of the device in, force and torque out. The device is
// simulated with the interface of real ones (OpenHaptics: a callback at 1 kHz that reads a column-major transform in
// millimetres and writes force [N] and torque [N mm]; CHAI3D's cGenericHapticDevice has getPosition, getRotation and
// setForceAndTorque, in metres). Neither is needed to build this.
//     example_haptic_loop [DAMPING]     of the device [N s/m]; too little for the finger's gains is an error
#include "godobject/godobject.hpp"
#include "godobject/scene/passivity.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;

/// A simulated device: a handle of 60 g on damped bearings, in a user's hand, which is a spring and a damper towards
/// the position that the user wants. y is up, as in most device frames. The scheduler calls back once a millisecond.
class StandInDevice {
 public:
  using Callback = void (*)(StandInDevice& device, void* user_data);

  explicit StandInDevice(const god::DeviceDamping& damping) : damping_(damping) {}
  void get_transform(double (&columns)[16]) const noexcept {
    const double c = std::cos(angle_), s = std::sin(angle_);
    const double about_y[16] = {
        c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 1e3 * place_.x(), 1e3 * place_.y(), 1e3 * place_.z(), 1};
    std::copy(std::begin(about_y), std::end(about_y), columns);
  }
  void set_force(const double (&newton)[3]) noexcept { force_ = {newton[0], newton[1], newton[2]}; }
  void set_torque(const double (&newton_millimetre)[3]) noexcept { torque_ = 1e-3 * newton_millimetre[1]; }
  [[nodiscard]] double greatest_force() const noexcept { return 8.0; }  ///< limit of its motors [N]

  /// Sets the position [m] and the rotation about y [rad] that the user wants.
  void want(const Eigen::Vector3d& place, double angle) noexcept {
    wanted_ = place;
    wanted_angle_ = angle;
  }
  void run(double seconds, Callback callback, void* user_data) {
    constexpr int parts = 10;  // of a millisecond, for the handle's own motion
    for (int millisecond = 0; millisecond < std::lround(1000.0 * seconds); ++millisecond) {
      callback(*this, user_data);
      for (int part = 0; part < parts; ++part) move(1e-3 / parts);
    }
  }
  [[nodiscard]] Eigen::Vector3d hand_force() const noexcept { return 400.0 * (wanted_ - place_) - 6.0 * velocity_; }
  [[nodiscard]] double speed() const noexcept { return velocity_.norm(); }

 private:
  void move(double time) noexcept {
    velocity_ += time / 0.06 * (hand_force() + force_ - damping_.sliding * velocity_);
    place_ += time * velocity_;
    spin_ += time / 2e-5 * (0.1 * (wanted_angle_ - angle_) - 2e-3 * spin_ + torque_ - damping_.twist * spin_);
    angle_ += time * spin_;
  }

  god::DeviceDamping damping_;
  Eigen::Vector3d place_{0.0, 0.01, 0.0}, velocity_ = Eigen::Vector3d::Zero(), force_ = Eigen::Vector3d::Zero(),
                                          wanted_ = place_;
  double angle_ = 0.0, spin_ = 0.0, torque_ = 0.0, wanted_angle_ = 0.0;
};

/// The finger for a haptic loop: construct it before the loop, call `step` once in each cycle.
class TouchOfPlane {
 public:
  /// Throws if the device has not the damping that these gains need: kT/2 + |b|, here 1.5 N s/m, and kT more for each
  /// sample of delay.
  TouchOfPlane(double greatest_force, const god::DeviceDamping& device)
      : finger_(lc::Table::build(lc::hertz(), 1e-6), parameters()), greatest_force_(greatest_force) {
    god::require_passive(finger_.parameters(), time_step, device);
  }

  /// Device in, force [N] and torque [N m] in the device's frame out. Allocates nothing and never throws.
  void step(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation, Eigen::Vector3d& force,
            Eigen::Vector3d& torque) noexcept {
    // The plane through the device's origin: its outward normal is z, the device's is y.
    const god::FingerOutput& output = finger_.update(ground_, {y_up_ * position, y_up_ * orientation}, time_step);
    force = whole_force();
    torque = y_up_.conjugate() * output.moment_vector();
    // A force beyond the motors' limit is scaled, so its direction stays.
    const double share = std::min(1.0, greatest_force_ / std::max(force.norm(), 1e-300));
    force *= share;
    torque *= share;
  }
  [[nodiscard]] god::FingerOutput output() const noexcept { return finger_.output(); }
  /// In the device's frame, before it is scaled.
  [[nodiscard]] Eigen::Vector3d whole_force() const noexcept {
    return y_up_.conjugate() * finger_.output().whole_force();
  }

 private:
  static constexpr double time_step = 1e-3;  // [s]

  static god::FingerParameters parameters() {
    return {.mu = 0.6,
            .radius_law = lc::RadiusLaw::power(0.00207, 0.259),  // a silicone finger
            .stiffness = 1000.0,
            .twist_stiffness = 0.01,
            .damping = 1.0,
            .twist_damping = 1e-5};
  }

  god::AnySurface ground_ = god::PlaneSurface{};
  Eigen::Quaterniond y_up_ = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  god::SoftFinger finger_;
  double greatest_force_;
};

/// The callback: the only place that converts units and frames.
void servo(StandInDevice& device, void* user_data) {
  auto& touch = *static_cast<TouchOfPlane*>(user_data);
  double columns[16];
  device.get_transform(columns);
  Eigen::Matrix3d rotation;
  rotation << columns[0], columns[4], columns[8], columns[1], columns[5], columns[9], columns[2], columns[6],
      columns[10];
  const Eigen::Vector3d position = 1e-3 * Eigen::Vector3d(columns[12], columns[13], columns[14]);
  Eigen::Vector3d force, torque;
  touch.step(position, Eigen::Quaterniond(rotation).normalized(), force, torque);
  device.set_force({force.x(), force.y(), force.z()});
  device.set_torque({1e3 * torque.x(), 1e3 * torque.y(), 1e3 * torque.z()});
}

int main(int argc, char** argv) try {
  const god::DeviceDamping damping{argc > 1 ? std::strtod(argv[1], nullptr) : 2.0, 5e-5};
  StandInDevice device(damping);
  TouchOfPlane touch(device.greatest_force(), damping);
  bool right = true;
  const auto report = [&](const char* what, god::ContactState expected) {
    const god::FingerOutput output = touch.output();
    std::printf("%-28s %-6s load %.3f N  friction %.3f N  moment %+.3f N mm  out of balance with the hand %.1e N\n",
                what, god::to_string(output.state).data(), output.load, output.force.norm(), 1e3 * output.moment,
                (device.hand_force() + touch.whole_force()).norm());
    right = right && output.state == expected;
  };
  device.run(0.5, servo, &touch);
  report("above the plane", god::ContactState::free);
  device.want({0.0, -0.005, 0.0}, 0.0);
  device.run(1.0, servo, &touch);
  report("pressed on it", god::ContactState::stick);
  device.want({0.001, -0.005, 0.0}, 0.02);
  device.run(1.0, servo, &touch);
  report("pulled and turned a little", god::ContactState::stick);
  right = right && device.speed() < 1e-3;
  for (int i = 0; i <= 100; ++i) {
    device.want({0.001 + 0.0003 * i, -0.005, 0.0}, 0.02 + 0.06 * i);
    device.run(0.01, servo, &touch);
  }
  report("dragged and turned on", god::ContactState::slip);
  right = right && touch.output().force.norm() < 0.6 * touch.output().load;  // less than with pure sliding
  return right ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
