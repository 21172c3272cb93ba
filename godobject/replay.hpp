// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger_curve.hpp"
#include "godobject/grasp.hpp"
#include "godobject/surface.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// Where a body is that somebody else moves.
struct BodyPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< of the centre of mass [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, of unit length
};

/// Who moves the body whose surface the fingers touch.
enum class BodyMotion {
  fixed,       ///< nobody: its frame is the world's
  prescribed,  ///< the trace: each sample says where it is
  free,        ///< the fingers and gravity: it begins at rest, its frame the world's
};

/// What a finger of the scene does and feels; places and vectors in the world.
struct SceneContact {
  ContactState state = ContactState::free;                ///< invalid: all that follows is held from the last good step
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();        ///< x_p [m]; while free, the finger itself
  double angle = 0.0;                                     ///< α_p [rad], of the finger's twist relative to the body
  double depth = 0.0;                                     ///< d [m]
  double load = 0.0;                                      ///< P [N]; what the user feels of it is P times the normal
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user [N], tangential
  double moment = 0.0;                                    ///< friction moment on the user about the normal [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();       ///< outward, of the surface at the contact; 0 before the first contact query
  double margin = 1.0;                                    ///< to slip, as a fraction: `SoftFinger::margin`
  double load_to_hold = 0.0;                              ///< the grip needed [N]: `SoftFinger::load_to_hold`
  Eigen::Vector3d centre_of_rotation =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< of the slip [m]; inf for pure sliding, NaN unless it slips
  double dissipated = 0.0;                                                  ///< by this finger's slip since the beginning [J], never falls
};

/// Everything that a replay needs to know. `Replay` validates it.
struct ReplayOptions {
  Law law = {};                        ///< pressure law; must be set
  CurveKind curve = CurveKind::table;  ///< of the law
  Projection projection = Projection::closest_point;
  double tolerance = 1e-6;                          ///< of the table, in unit wrenches; used by `CurveKind::table` only
  FingerParameters finger = {};                     ///< of every finger
  AnySurface surface = AnySurface(PlaneSurface{});  ///< of the body, in its frame
  std::size_t fingers = 1;                          ///< 1 to `Replay::most_fingers`
  BodyMotion motion = BodyMotion::fixed;
  BodyParameters body = {};  ///< where it is free
};

/// The god-object over a recorded motion of one finger or several on a surface of any kind, which may rest, be moved or be free.
class Replay {
 public:
  static constexpr std::size_t most_fingers = 16;
  /// A free body is not moved over a gap in the trace longer than this [s].
  static constexpr double longest_step = 1.0;

  /// Throws `std::invalid_argument` that names the parameter, its value, unit and range.
  explicit Replay(const ReplayOptions& options);

  /// The next sample: time [s], a pose for each finger (a missing one counts as far away), and where the body is, which counts
  /// where its motion is prescribed. A time that is not finite or earlier than the last, or a pose of the body that is no pose,
  /// makes all fingers `invalid` and moves nothing; so does a pose of a finger that is not finite, for that finger.
  void step(double time, std::span<const DevicePose> fingers, const BodyPose& body = {}) noexcept;

  /// What the fingers do now, one each.
  [[nodiscard]] std::span<const SceneContact> contacts() const& noexcept { return contacts_; }
  void contacts() const&& = delete;
  [[nodiscard]] const BodyState& body() const& noexcept { return grasp_.body(); }
  void body() const&& = delete;
  /// Steps of a free body whose equations were not solved to rounding: `Grasp::unsolved`.
  [[nodiscard]] std::size_t unsolved() const noexcept { return grasp_.unsolved(); }
  /// How far the fingers' curve is from the one that was asked for: the table's certified error and what samples of the pressure leave open,
  /// 0 in closed form.
  [[nodiscard]] double curve_error() const noexcept { return curve_error_; }

 private:
  Replay(const ReplayOptions& options, const KindOfCurve& curve);
  void move(std::span<const DevicePose> fingers, const BodyPose& body, double time_step) noexcept;

  Grasp grasp_;
  std::vector<SceneContact> contacts_;
  std::vector<DevicePose> refused_;
  BodyMotion motion_;
  double curve_error_;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace limitcurve::godobject
