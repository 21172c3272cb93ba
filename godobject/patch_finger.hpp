// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/patch.hpp"
#include "finger.hpp"
#include "surface.hpp"

#include <memory>

namespace limitcurve::godobject {

class PatchProjector;

/// The whole state of a PatchFinger between steps. Plain numbers.
struct PatchFingerState {
  FingerState finger;
  Numbers axis{};     ///< unit tangent, the patch's x axis at α_p = 0; parallel-transported as the normal turns
  PatchTwist slip{};  ///< the last slip, in the patch's axes [m, rad]; zero without slip
};

/// A soft-finger god-object whose contact is a pressure patch, for contacts that are not round. Contact, faults and output are those of
/// SoftFinger. The limit surface replaces the limit curve; the projection is the closest point (maximum dissipation) in F_x, F_y, M.
///
///     PatchFinger finger(Patch::rectangle(0.02, 0.01), {.mu = 0.6});
///     const FingerOutput output = finger.update(contact, twist, 1e-3);
///
/// The patch is fixed to the finger: its axes, and those of orthotropic friction, turn with the proxy's α_p. On the plane z = 0 its x axis
/// at α_p = 0 is the world's; for another normal that axis is rotated with the shortest rotation from z to the normal. The contact point is
/// the centre of pressure: springs act there, and moments refer to it; the origin of the patch's file does not matter. The size does not
/// depend on the load: the radius law is not used. For a disc the step equals that of SoftFinger to 1e-9.
///
/// Points get a radius ε: |u| becomes √(|u|² + ε²ω²), which changes the limit by less than ε/m₀ of it. Without it a point under the centre
/// of rotation bears any force up to its limit, and the search has no derivative there. Image pixels become such points with the pixel's
/// radius of gyration.
///
/// A step does not allocate, throw or lock. Within an ellipsoid inside the limit surface, the common case, it does not evaluate the patch;
/// a slip costs 5 to 20 evaluations (Patch states the cost of one).
class PatchFinger {
 public:
  /// `point_radius` is ε [m], at least 1e-3 m₀; 0 means that. Throws std::invalid_argument with parameter, value, unit and range; also for
  /// a moment coefficient, because the patch determines the moments.
  PatchFinger(const Patch& patch, const FingerParameters& parameters, double point_radius = 0.0);

  /// One step, as SoftFinger::update.
  FingerOutput update(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) noexcept;
  FingerOutput update(const Contact& contact, double device_twist, double time_step = 0.0) noexcept;

  [[nodiscard]] FingerOutput output() const noexcept { return state_.finger.output(); }
  [[nodiscard]] const PatchFingerState& state() const noexcept { return state_; }
  void restore(const PatchFingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }

  /// The patch with its points smoothed by ε.
  [[nodiscard]] const Patch& patch() const noexcept;
  [[nodiscard]] const FingerParameters& parameters() const noexcept { return parameters_; }

  /// Margin to slip, as a fraction of the limit: 1 without friction or while free, 0 on the limit and during slip.
  [[nodiscard]] double margin() const noexcept;
  /// The smallest load [N] under which the contact bears its present friction without slip; inf if none does.
  [[nodiscard]] double load_to_hold() const noexcept;
  /// The slip's centre of rotation, in the surface's frame [m]; infinite for pure sliding, NaN without slip.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;

 private:
  void advance(const Contact& contact, const Spin& spin, double device_twist, double time_step) noexcept;

  FingerParameters parameters_;
  std::shared_ptr<const PatchProjector> projector_;
  double rest_share_ = 1.0;  // fraction of the dynamic limit within which a contact comes to rest
  PatchFingerState state_;
};

}  // namespace limitcurve::godobject
