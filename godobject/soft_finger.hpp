// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_state.hpp"
#include "godobject/friction.hpp"

#include <Eigen/Core>

#include <numbers>
#include <utility>

namespace limitcurve::godobject {

/// Where a finger touches a surface: the result of step a (paper, eq. 7).
struct Contact {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< x_g, the surface point nearest the finger [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward unit normal there
  double depth = 0.0;                                 ///< d [m], how far the finger is beneath the surface; ≤ 0 outside
};

/// What a step gives.
struct FingerOutput {
  ContactState state = ContactState::free;
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();        ///< x_p [m]; while free, the finger itself
  double angle = 0.0;                                     ///< α_p [rad] in the frame of the device's twist; while free, the twist
  double depth = 0.0;                                     ///< d [m]
  double load = 0.0;                                      ///< P = k_l d [N], 0 while free
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user, k_l (x_p − x_g) [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal, k_r (α_p − α_g) [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  double slip_work = 0.0;                                 ///< dissipated in this step [J], ≥ 0
};

/// All that a finger remembers from one step to the next. A plain value: copy, save and restore it.
struct FingerState {
  FingerOutput output;
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();  ///< x_g of the last good step [m]
  double goal_angle = 0.0;                         ///< α_g of the last good step [rad], unwrapped
  double device_angle = 0.0;                       ///< the device's twist as it was given [rad]
  double turn = 0.0;                               ///< what unwrapping has added to it [rad], a multiple of 2π
  double start = -1.0;                             ///< spin fraction of the last slip; < 0: it sticks
  bool touching = false;
};

/// A soft-finger god-object on one surface: steps a–c of the paper, corrected (README, "Corrections to the paper").
/// The boundary decides how force and moment limit each other, the projection where a slipping proxy comes to lie.
template <LimitBoundary Boundary, class Projection>
class SoftFinger {
 public:
  /// A contact farther than this from the origin [m], or turned farther [rad], is taken for a fault of the device.
  static constexpr double farthest = 1e6;

  /// Throws std::invalid_argument naming parameter, value, unit and range.
  SoftFinger(Boundary boundary, const FingerParameters& parameters, Projection projection = {})
      : friction_(std::move(boundary), parameters, projection) {}

  /// One step: the contact of the finger with the surface and the device's twist α_s [rad] about the normal. The twist may
  /// wrap around at any multiple of 2π: a jump of more than π between steps is taken for a turn of the other sense.
  /// Input that is not finite, or no contact (a normal that is not of unit length), gives the state `invalid`: the last
  /// good output is held, the finger's memory untouched.
  const FingerOutput& update(const Contact& contact, double twist) noexcept {
    FingerOutput& output = state_.output;
    if (!usable(contact, twist)) {
      output.state = ContactState::invalid;
      output.slip_work = 0.0;
      return output;
    }
    if (!(contact.depth > 0.0)) return release(contact, twist);
    const double goal_angle = unwrap(twist);
    if (!state_.touching) {
      // Touch-down: no friction yet. (The paper's α_0 is the twist here; angles are kept absolute, and α_p − α_g is the same.)
      output.proxy = contact.point;
      output.angle = goal_angle;
      state_.touching = true;
      state_.start = -1.0;
    }
    state_.goal = contact.point;
    state_.goal_angle = goal_angle;
    output.depth = contact.depth;
    output.load = friction_.law().stiffness() * contact.depth;

    Eigen::Vector3d offset = output.proxy - contact.point;
    offset -= contact.normal * contact.normal.dot(offset);
    const double r = offset.norm();
    const double lag = output.angle - goal_angle;
    const double rho = std::fabs(lag);
    const auto result = friction_.resolve(r, rho, output.load, state_.start);

    if (!result.slips) {
      output.state = ContactState::stick;
      output.force = offset * friction_.law().stiffness();
      output.moment = friction_.law().twist_stiffness() * (result.twist == rho ? lag : 0.0);
      if (result.twist != rho) output.angle = goal_angle;
      output.cor = std::numeric_limits<double>::quiet_NaN();
      output.slip_work = 0.0;
      state_.start = -1.0;
      return output;
    }
    // r = 0 and ρ = 0 have no direction, and need none: eq. (23) without its 0/0.
    const double per_metre = r > 0.0 ? 1.0 / r : 0.0;
    output.force = offset * (result.force * per_metre);
    output.moment = std::copysign(result.moment, lag);
    bool moves = false;
    if (result.offset != r) {
      const Eigen::Vector3d proxy = contact.point + offset * (result.offset * per_metre);
      moves = proxy != output.proxy;
      output.proxy = proxy;
    }
    if (result.twist != rho) {
      const double angle = goal_angle + std::copysign(result.twist, lag);
      moves = moves || angle != output.angle;
      output.angle = angle;
    }
    // A slip that is lost in the rounding of the proxy is none.
    output.state = moves ? ContactState::slip : ContactState::stick;
    output.cor = moves ? result.cor : std::numeric_limits<double>::quiet_NaN();
    output.slip_work = moves ? result.slip_work : 0.0;
    state_.start = moves ? result.spin_fraction : -1.0;
    return output;
  }

  [[nodiscard]] const FingerOutput& output() const noexcept { return state_.output; }
  [[nodiscard]] const FingerState& state() const noexcept { return state_; }
  void restore(const FingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }

  [[nodiscard]] const Friction<Boundary, Projection>& friction() const noexcept { return friction_; }

  /// How far the finger is from slipping, as a fraction: 1 without friction, 0 on the limit; 0 while it slips, 1 while free.
  [[nodiscard]] double margin() const noexcept {
    const FingerOutput& output = state_.output;
    if (!state_.touching) return 1.0;
    if (output.state == ContactState::slip) return 0.0;
    const double r = output.force.norm() / friction_.law().stiffness();
    const double rho = std::fabs(output.moment) / friction_.law().twist_stiffness();
    return std::clamp(friction_.margin(r, rho, output.load, state_.start >= 0.0), 0.0, 1.0);
  }

 private:
  [[nodiscard]] static bool usable(const Contact& contact, double twist) noexcept {
    // One comparison for all, which is false for NaN too.
    const double squares = contact.point.squaredNorm() + contact.depth * contact.depth + twist * twist;
    return squares <= farthest * farthest && std::fabs(contact.normal.squaredNorm() - 1.0) <= 1e-6;
  }

  const FingerOutput& release(const Contact& contact, double twist) noexcept {
    FingerOutput output;
    output.proxy = contact.point - contact.normal * contact.depth;
    output.angle = twist;
    output.depth = contact.depth;
    state_ = {.output = output, .goal = contact.point, .goal_angle = twist, .device_angle = twist};
    return state_.output;
  }

  /// α_g: the device's angle with its turns put back. Adds exactly 0 as long as the device does not jump.
  double unwrap(double twist) noexcept {
    const double jump = twist - state_.device_angle;
    if (state_.touching && std::fabs(jump) > std::numbers::pi) {
      state_.turn -= 2.0 * std::numbers::pi * std::round(jump / (2.0 * std::numbers::pi));
    } else if (!state_.touching) {
      state_.turn = 0.0;
    }
    state_.device_angle = twist;
    return twist + state_.turn;
  }

  Friction<Boundary, Projection> friction_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
