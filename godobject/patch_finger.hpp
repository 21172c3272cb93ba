// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/surface.hpp"
#include "limitcurve/patch.hpp"

#include <memory>

namespace limitcurve::godobject {

class PatchProjector;

/// All that a PatchFinger remembers from one step to the next.
struct PatchFingerState {
  FingerState finger;
  Numbers axis{};     ///< unit tangent: where the patch's x axis is at α_p = 0; parallel-transported as the normal turns
  PatchTwist slip{};  ///< the last slip, in the patch's axes [m, rad]: what the springs gave; zero unless it slips
};

/// A god-object whose contact is a pressure patch: `SoftFinger` for contacts that are not round. It shares contact, faults and output; the limit
/// surface takes the place of the limit curve, and the projection is the closest point (maximum dissipation) in F_x, F_y, M.
///
///     PatchFinger finger(Patch::rectangle(0.02, 0.01), {.mu = 0.6});
///     const FingerOutput output = finger.update(contact, twist, 1e-3);
///
/// The patch is fixed to the finger: its axes, and those of orthotropic friction, turn with the proxy's α_p. On the plane z = 0 its x axis is the
/// world's where α_p = 0; on another normal that axis turned from z to the normal by the shortest way. Its centre of pressure is the contact point:
/// springs act and moments count there, and the origin of the patch's file plays no part. Its size does not depend on the load: a radius law is not
/// used. For a disc the step is that of SoftFinger to 1e-9.
///
/// Points get a radius, for a point under the centre of rotation bears any force up to its limit, so that a search has no derivative there: |u| becomes
/// √(|u|² + ε²ω²), which is wrong by less than ε/m₀ of the limit. Image pixels all become such points of the pixel's own radius of gyration.
///
/// No step allocates, throws or takes a lock. Within an ellipsoid that lies in the limit surface, where a contact mostly is, a step costs no
/// evaluation of the patch; a slip costs 5 to 20 (Patch has the cost of one).
class PatchFinger {
 public:
  /// `point_radius` ε [m], > 0: default 1e-3 m₀, which is also the least. Throws std::invalid_argument naming parameter, value, unit and range; a
  /// moment coefficient is refused, for the patch has its own moments.
  PatchFinger(const Patch& patch, const FingerParameters& parameters, double point_radius = 0.0);

  /// One step, as SoftFinger::update.
  FingerOutput update(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) noexcept;
  FingerOutput update(const Contact& contact, double device_twist, double time_step = 0.0) noexcept;

  [[nodiscard]] FingerOutput output() const noexcept { return state_.finger.output(); }
  [[nodiscard]] const PatchFingerState& state() const noexcept { return state_; }
  void restore(const PatchFingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }

  /// The patch that drives: the points of the one given have their radius.
  [[nodiscard]] const Patch& patch() const noexcept;
  [[nodiscard]] const FingerParameters& parameters() const noexcept { return parameters_; }

  /// How far the finger is from slipping, as a fraction: 1 without friction, 0 on the limit; 0 while it slips, 1 while free.
  [[nodiscard]] double margin() const noexcept;
  /// The least load [N] under which the contact would bear its present friction without slipping; inf where none does.
  [[nodiscard]] double load_to_hold() const noexcept;
  /// Where the slip's centre of rotation is, in the surface's frame [m]; infinite for pure sliding, NaN unless it slips.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;

 private:
  void advance(const Contact& contact, const Spin& spin, double device_twist, double time_step) noexcept;

  FingerParameters parameters_;
  std::shared_ptr<const PatchProjector> projector_;
  double rest_share_ = 1.0;  // of the dynamic limit, within which a contact comes to rest
  PatchFingerState state_;
};

}  // namespace limitcurve::godobject
