// SPDX-License-Identifier: MIT
#pragma once

#include "../../limitcurve/patch/patch.hpp"
#include "../../limitcurve/table.hpp"
#include "../body/grasp.hpp"
#include "../finger_curve.hpp"
#include "../surface.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// The motion of the body that the fingers touch.
enum class BodyMotion {
  fixed,       ///< it does not move; its frame is the world's
  prescribed,  ///< each sample has its pose
  free,        ///< fingers and gravity move it; it begins at rest, in the world's frame
};

/// The state of one finger of a scene; points and vectors in the world.
struct SceneContact {
  ContactState state =
      ContactState::free;  ///< invalid: the wrench fades as in `FingerOutput`, cor is NaN, places are held
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();  ///< x_p [m]; while free, the finger's position
  double angle = 0.0;                               ///< α_p [rad], relative to the body
  double depth = 0.0;                               ///< d [m]
  double load = 0.0;  ///< P [N]; the force on the user is P times the normal, plus friction
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user [N], tangential
  double moment = 0.0;                                    ///< friction moment on the user about the normal [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< distance of the slip's COR from the contact centre [m];
                                                          ///< NaN without slip
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< outward, of the surface at the contact; 0 before the first contact query
  double margin = 1.0;          ///< margin to slip, as a fraction: `SoftFinger::margin`
  double load_to_hold = 0.0;    ///< smallest load that holds the friction [N]: `SoftFinger::load_to_hold`
  Eigen::Vector3d centre_of_rotation = Eigen::Vector3d::Constant(
      std::numeric_limits<double>::quiet_NaN());  ///< of the slip [m]; inf for pure sliding, NaN without slip
  double dissipated = 0.0;                        ///< energy of this finger's slip since the beginning [J]
  Fault fault = Fault::none;                      ///< the reason for `invalid`
};

/// The options of a replay. `Replay` checks them.
struct ReplayOptions {
  Law law = {};                        ///< pressure law; this or a patch must be set
  CurveKind curve = CurveKind::table;  ///< of the law
  Projection projection = Projection::closest_point;
  double tolerance = Table::default_tolerance;  ///< of the table, in unit wrenches; used by `CurveKind::table` only
  std::optional<Patch> patch = {};  ///< instead of law, curve, projection and tolerance: the contact is not round
  double point_radius = 0.0;        ///< of a patch: as in SoftFinger
  FingerParameters finger = {};     ///< of every finger
  AnySurface surface = AnySurface(PlaneSurface{});  ///< of the body, in its frame
  std::size_t fingers = 1;                          ///< 1 to `Replay::most_fingers`
  BodyMotion motion = BodyMotion::fixed;
  BodyParameters body = {};  ///< of a free body
};

/// Time steps by the stamps of samples, of which some may be wrong.
class SampleClock {
 public:
  /// The time since the last accepted stamp [s], 0 for the first. It is < 0 or not finite if this stamp is refused. If
  /// the next stamp then continues from a refused earlier one, the clock accepts that, too.
  double step(double time) noexcept;

 private:
  double last_ = -std::numeric_limits<double>::infinity();
  double earlier_ = std::numeric_limits<double>::infinity();  ///< the last stamp, if it was refused
};

/// Steps the god-object through a recorded motion of one or several fingers, on a surface that is fixed, prescribed or
/// free.
class Replay {
 public:
  static constexpr std::size_t most_fingers = 16;
  /// A free body does not move over a longer gap between samples [s].
  static constexpr double longest_step = 1.0;

  /// Throws `std::invalid_argument` with the parameter, its value, unit and range. Builds the table of the curve.
  explicit Replay(const ReplayOptions& options);

  /// Steps to the next sample: time [s], a pose for each finger (a missing one counts as far away), and the pose of the
  /// body, used if its motion is prescribed. If the time is not finite or earlier than the last, or the body's pose is
  /// not valid, all fingers are `invalid` and nothing moves; `SampleClock` has the rule. If a finger's pose is not
  /// finite, that finger is `invalid`. `SceneContact::fault` names the reason.
  void step(double time, std::span<const DevicePose> fingers, const BodyPose& body = {}) noexcept;

  /// The current state of each finger.
  [[nodiscard]] std::span<const SceneContact> contacts() const& noexcept { return contacts_; }
  void contacts() const&& = delete;
  [[nodiscard]] const BodyState& body() const& noexcept { return grasp_.body(); }
  void body() const&& = delete;
  /// Number of steps of a free body whose equations were not solved: `Grasp::unsolved`.
  [[nodiscard]] std::size_t unsolved() const noexcept { return grasp_.unsolved(); }
  /// Error of the fingers' curve against the one of its kind [unit wrenches]: checked_error + profile_error of its
  /// table, 0 for a closed form.
  [[nodiscard]] double curve_error() const noexcept { return curve_error_; }

 private:
  void move(std::span<const DevicePose> fingers, const BodyPose& body, double time_step) noexcept;

  double curve_error_ = 0.0;
  Grasp grasp_;
  std::vector<SceneContact> contacts_;
  BodyMotion motion_;
  SampleClock clock_;
};

}  // namespace limitcurve::godobject
