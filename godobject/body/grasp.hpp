// SPDX-License-Identifier: MIT
#pragma once

#include "../soft_finger.hpp"
#include "../surface.hpp"
#include "rigid_body.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// One rigid body and the fingers on it: steps a–e of the paper. Proxies are in the body's frame, so that step e, which
/// carries them with the body, is exact and keeps the sign of the rotation (eq. 13 takes its absolute value). Springs
/// and inertia are integrated together by implicit Euler steps: stable at every stiffness; modes that the time step
/// cannot resolve are damped. A body that no moment acts on turns without a change of its energy or its angular
/// momentum.
///
/// Bodies touch fingers, not each other. For a scene of several bodies make a Grasp for each; a finger that may touch
/// several bodies is in each Grasp. Allocates at construction only.
class Grasp {
 public:
  /// Largest number of Newton steps from each of two starts; usually 2 to 4 are needed. Each costs seven evaluations of
  /// all fingers.
  static constexpr int iteration_limit = 20;
  /// A step that cannot be solved is done in parts, down to 1/128 of it, with the devices' poses in between; usually it
  /// is whole.
  static constexpr int max_parts = 128;
  /// Largest number of halvings of a Newton step; usually 0.
  static constexpr int halving_limit = 24;
  /// Equations count as solved if the residual is at most this fraction of the velocities, including those that the
  /// step's loads give.
  static constexpr double solved_fraction = 1e-9;

  /// A body that turns by more [rad] in a step is moved in parts, too.
  static constexpr double largest_turn = 2.0;

  /// Throws std::invalid_argument with parameter, value, unit and range.
  Grasp(const BodyParameters& parameters, const BodyState& state, AnySurface surface, std::vector<SoftFinger> fingers);

  /// One time step [s] > 0, with a device pose for each finger; a missing pose counts as far away. `force` [N] and
  /// `moment` [N m] about the centre of mass, in world axes, are added to gravity and the fingers' forces. A pose that
  /// is not finite makes its finger `invalid`; the finger then acts with its last force. An invalid time step, or
  /// forces that are not finite or would carry the body beyond `farthest` (its position in m, its velocities in m/s and
  /// rad/s), move nothing: all fingers are `invalid` and name the fault. If a later part of a step in parts
  /// fails, the earlier parts stay done. Does not throw, allocate or lock. Cost: usually 15 to 40 contact queries per
  /// finger, for a step in parts some thousands; at most 2 `max_parts` solutions, and as many again for each finger
  /// that begins to slip, of 2 `iteration_limit` (7 + `halving_limit`) queries each.
  void step(std::span<const DevicePose> devices, double time_step,
            const Eigen::Vector3d& force = Eigen::Vector3d::Zero(),
            const Eigen::Vector3d& moment = Eigen::Vector3d::Zero()) noexcept;

  /// Moves the body to a given state in a time [s] ≥ 0 (0: no dampers), and does steps a–c and e. An invalid time, or a
  /// state that is not finite, beyond `farthest` or not of unit length, moves nothing: all fingers are `invalid`, and
  /// name the fault.
  void carry(BodyState state, std::span<const DevicePose> devices, double time_step) noexcept;

  /// Puts the body into a state at once and does steps a–c there: fingers that do not touch yet touch down, the springs
  /// of those that do are loaded. No finger is too far from its last place. A new scene or episode begins with `reset`.
  void place(BodyState state, std::span<const DevicePose> devices) noexcept;

  /// Forgets all contacts, and what was dissipated, as after construction. The body stays: `place` puts it where a
  /// scene begins.
  void reset() noexcept;

  [[nodiscard]] const BodyParameters& parameters() const& noexcept { return parameters_; }
  void parameters() const&& = delete;
  [[nodiscard]] const BodyState& body() const& noexcept { return state_; }
  void body() const&& = delete;
  [[nodiscard]] std::size_t finger_count() const noexcept { return fingers_.size(); }
  /// A finger. Its output is in the body's frame.
  [[nodiscard]] const SoftFinger& finger(std::size_t index) const& noexcept { return fingers_[index]; }
  void finger(std::size_t index) const&& = delete;

  /// Force of finger `index` on its user, normal load plus friction, in the world [N].
  [[nodiscard]] Eigen::Vector3d force_on_user(std::size_t index) const noexcept;
  /// The friction moment on the user about the contact normal, in the world [N m].
  [[nodiscard]] Eigen::Vector3d moment_on_user(std::size_t index) const noexcept;

  /// Kinetic energy, potential energy of gravity and energy of the springs, summed [J].
  [[nodiscard]] double energy() const noexcept;
  /// Energy that the slip of all fingers has dissipated since the beginning [J].
  [[nodiscard]] double dissipated() const noexcept { return dissipated_; }
  /// Number of steps whose equations were not solved, not even in parts (a step with a rejected sample is not divided).
  /// Even there momentum changes by the impulse of the fingers' forces as they are rendered; the position is
  /// approximate.
  [[nodiscard]] std::size_t unsolved() const noexcept { return unsolved_; }
  /// Number of steps that were done in parts. There the output of a finger is that at the end, `slip` if a part
  /// slipped.
  [[nodiscard]] std::size_t divided() const noexcept { return divided_; }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  /// Force and moment about the centre of mass, world axes.
  struct Load {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double size = 0.0;  ///< the sizes of all forces, and of all moments divided by the radius of gyration, summed [N]

    void add(const Eigen::Vector3d& more_force, const Eigen::Vector3d& more_moment, double gyration) noexcept {
      force += more_force;
      moment += more_moment;
      size += more_force.norm() + more_moment.norm() / gyration;
    }
  };

  /// Velocities at the end of the step, and their residual. Velocities are measured as the speed of a point at the
  /// radius of gyration.
  struct Attempt {
    Vector6 velocities;
    Vector6 error;
    double size;  ///< of the error [m/s]
    double unit;  ///< of the velocities at the beginning, and of those that the loads give in the step [m/s]
  };

  [[nodiscard]] Load preview(const BodyState& state, std::span<const DevicePose> devices,
                             double time_step) const noexcept;
  void commit(std::span<const DevicePose> devices, double time_step, bool continues) noexcept;
  void mark_invalid(Fault fault, double time_step) noexcept;
  void compare_places(std::span<const DevicePose> devices, double time_step) noexcept;
  void remember(std::span<const DevicePose> devices) noexcept;
  [[nodiscard]] std::span<const DevicePose> between(std::span<const DevicePose> devices, double fraction) noexcept;
  [[nodiscard]] Attempt attempt(const Vector6& velocities, std::span<const DevicePose> devices, double time_step,
                                const Load& external) const noexcept;
  [[nodiscard]] bool may_divide(std::span<const DevicePose> devices, double time_step) const noexcept;
  [[nodiscard]] Attempt solve(std::span<const DevicePose> devices, double time_step, const Load& external,
                              bool& solved) noexcept;
  [[nodiscard]] Attempt search(std::span<const DevicePose> devices, double time_step, const Load& external,
                               const Vector6& start, bool& solved) noexcept;
  [[nodiscard]] bool begin_slips(const Attempt& at, std::span<const DevicePose> devices, double time_step) noexcept;
  [[nodiscard]] BodyState end_of(const Attempt& attempt, double time_step) const noexcept;
  [[nodiscard]] Attempt improve(Attempt now, std::span<const DevicePose> devices, double time_step,
                                const Load& external) noexcept;

  BodyParameters parameters_;
  BodyState state_;
  AnySurface surface_;
  std::vector<SoftFinger> fingers_;
  std::vector<DevicePose> last_devices_;          // of the last step, for its first `last_count_` fingers
  std::vector<DevicePose> between_;               // at the end of a part of a step
  std::vector<FrictionMemory<double>> friction_;  // of the fingers, before a step is tried
  std::vector<double> elapsed_;                   // of their faults, before `compare_places` [s]
  double gyration_;                               // radius of gyration [m]
  std::size_t last_count_ = 0;
  double dissipated_ = 0.0;
  std::size_t unsolved_ = 0;
  std::size_t divided_ = 0;
  Eigen::Matrix<double, 6, 6, Eigen::DontAlign> inverse_slope_;  // of the residual by the velocities
  double slope_time_step_ = 0.0;                                 // of inverse_slope_ [s]; 0 if there is none
};

}  // namespace limitcurve::godobject
