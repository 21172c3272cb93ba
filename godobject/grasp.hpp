// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/rigid_body.hpp"
#include "godobject/soft_finger.hpp"
#include "godobject/surface.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// One body and the fingers on it: steps a–e of the paper. The proxies are kept in the body's frame, so that step e,
/// carrying them with the body, is exact and keeps the sign of the rotation (eq. 13 takes its absolute value). The springs of the fingers and
/// the body's inertia are integrated together by implicit Euler steps: stable at every stiffness, damping what the time step cannot resolve.
///
/// Bodies meet fingers only, not each other: a scene of several bodies has a Grasp for each, and a finger that may touch
/// several is in each of them. Allocates at construction only.
class Grasp {
 public:
  /// Newton steps of the integrator at most, from each of two starts; 2 to 4 as a rule, each seven evaluations of all fingers.
  static constexpr int iteration_limit = 20;
  /// Halvings of a Newton step at most; 0 as a rule.
  static constexpr int halving_limit = 24;
  /// Equations count as solved when what is left of them is this share of the velocities, and those that the loads give in a step.
  static constexpr double solved_share = 1e-9;

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  Grasp(const BodyParameters& parameters, const BodyState& state, AnySurface surface, std::vector<SoftFinger> fingers);

  /// One time step [s] > 0 with a device for each finger; a missing one counts as far away. `force` and `moment` about the
  /// centre of mass, world axes, act on the body beside gravity and fingers. Poses that are not finite make their finger
  /// `invalid`; it then acts with its last force.
  void step(std::span<const DevicePose> devices, double time_step, const Eigen::Vector3d& force = Eigen::Vector3d::Zero(),
            const Eigen::Vector3d& moment = Eigen::Vector3d::Zero()) noexcept;

  /// Steps a–c and e with the body moved by somebody else, to a state, in a time [s] ≥ 0 (0: no dampers).
  void carry(const BodyState& state, std::span<const DevicePose> devices, double time_step) noexcept;

  /// Steps a–c with the body held in a state: where fingers touch down, and where a scene starts.
  void place(const BodyState& state, std::span<const DevicePose> devices) noexcept;

  [[nodiscard]] const BodyParameters& parameters() const& noexcept { return parameters_; }
  void parameters() const&& = delete;
  [[nodiscard]] const BodyState& body() const& noexcept { return state_; }
  void body() const&& = delete;
  [[nodiscard]] std::size_t finger_count() const noexcept { return fingers_.size(); }
  /// A finger; its proxy, force and so on are in the body's frame.
  [[nodiscard]] const SoftFinger& finger(std::size_t index) const& noexcept { return fingers_[index]; }
  void finger(std::size_t index) const&& = delete;

  /// What finger `index` exerts on its user, in the world: normal load and friction together [N].
  [[nodiscard]] Eigen::Vector3d force_on_user(std::size_t index) const noexcept;
  /// The friction moment on the user about the contact normal, in the world [N m].
  [[nodiscard]] Eigen::Vector3d moment_on_user(std::size_t index) const noexcept;

  /// Kinetic, gravity's and the springs' energy [J].
  [[nodiscard]] double energy() const noexcept;
  /// What the slip of all fingers has dissipated since the beginning [J].
  [[nodiscard]] double dissipated() const noexcept { return dissipated_; }
  /// Steps whose equations were not solved to rounding within the limit.
  [[nodiscard]] std::size_t unsolved() const noexcept { return unsolved_; }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  /// Force and moment about the centre of mass, world axes.
  struct Load {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  };

  /// Velocities at the end of the step, what is wrong with them, and its size in a common unit: the speed of a point a radius of
  /// gyration away.
  struct Attempt {
    Vector6 velocities;
    Vector6 error;
    double size;
  };

  [[nodiscard]] static DevicePose in_body(const BodyState& state, const DevicePose& device) noexcept;
  [[nodiscard]] Load preview(const BodyState& state, std::span<const DevicePose> devices, double time_step) const noexcept;
  void commit(std::span<const DevicePose> devices, double time_step) noexcept;
  void account() noexcept;
  [[nodiscard]] Vector6 residual(const Vector6& velocities, std::span<const DevicePose> devices, double time_step, const Load& external,
                                 const Eigen::Vector3d& momentum) const noexcept;
  [[nodiscard]] BodyState solve(std::span<const DevicePose> devices, double time_step, const Load& external) noexcept;
  template <class Try>
  [[nodiscard]] Attempt improve(Attempt now, double unit, double gyration, double time_step, const Try& attempt) const noexcept;

  BodyParameters parameters_;
  BodyState state_;
  AnySurface surface_;
  std::vector<SoftFinger> fingers_;
  double dissipated_ = 0.0;
  std::size_t unsolved_ = 0;
};

}  // namespace limitcurve::godobject
