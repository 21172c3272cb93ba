// SPDX-License-Identifier: MIT
#include "godobject/finger/patch_step.hpp"
#include "godobject/patch/patch_projection.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/wrench.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

/// A tangent vector, turned about the normal.
Vector3d turned_about(const Vector3d& tangent, const Vector3d& normal, double angle) noexcept {
  return tangent * std::cos(angle) + normal.cross(tangent) * std::sin(angle);
}

/// The patch's x axis at α_p = 0, so that at α_p it is the tangent part of the finger's x axis, turned by α_p − α_g and
/// the device's twist. It follows from the present orientation, not from the path: transport along a closed path would
/// turn the patch. A device without an orientation, or whose x axis is normal to the surface, transports the last axis;
/// a new contact begins with the world's x axis, turned from z to the normal.
Vector3d zero_axis(const Vector3d& n, const Spin& spin, const Vector3d& last) noexcept {
  const auto tangent_part = [&](const Vector3d& axis) { return Vector3d(axis - n * n.dot(axis)); };
  if (spin.started) {
    const Orientation q(spin.scalar, spin.axis[0], spin.axis[1], spin.axis[2]);
    const Vector3d tangent = tangent_part(q * Vector3d::UnitX());
    if (const double length = tangent.norm(); length > 1e-6) return turned_about(tangent / length, n, -spin.angle);
  }
  const Vector3d tangent = tangent_part(last);
  if (const double length = tangent.norm(); length > 0.1) return tangent / length;
  const double c = 1.0 + n.z();
  if (!(c > 1e-12)) return Vector3d::UnitX();
  return {1.0 - n.x() * n.x() / c, -n.x() * n.y() / c, -n.x()};
}

/// A force in the patch's axes, and a moment.
PatchWrench in_axes(const Vector3d& x, const Vector3d& normal, const Vector3d& force, double moment) noexcept {
  return {x.dot(force), normal.cross(x).dot(force), moment};
}

/// The projector of a patch whose points get a radius [m]; 0: the least, 1e-3 m₀.
PatchProjector projector_of(const Patch& patch, double point_radius) {
  const double least = 1e-3 * patch.moment_ratio();
  if (point_radius == 0.0 && least == 0.0) {
    throw std::invalid_argument(
        "point_radius = 0 m: all load of the patch is on one point, which has no friction moment; expected > 0");
  }
  if (point_radius != 0.0 && !(point_radius >= least && point_radius <= 1e15)) {
    throw out_of_range("point_radius", point_radius, "m", ">= 1e-3 of the patch's m0, " + format_number(least));
  }
  return PatchProjector(patch.smoothed(point_radius == 0.0 ? least : point_radius));
}

class PatchFinger final : public PatchStep {
 public:
  PatchFinger(const Patch& patch, double point_radius) : projector_(projector_of(patch, point_radius)) {}

  [[nodiscard]] KeptDeflection friction(const ContactLimits& limits, const TrialDeflection& trial,
                                        const Vector3d& normal, const Spin& spin, double angle, const PatchMemory& last,
                                        bool may_begin, FrictionMemory<double>& friction,
                                        PatchMemory& next) const noexcept override;
  [[nodiscard]] double gauge(const FingerState& state) const noexcept override {
    const FingerOutput& output = state.output;
    Vector3d axis = state.patch.axis;
    // A state from a round finger has none: take that of the next step.
    if (axis.isZero(0.0)) axis = turned_about(zero_axis(output.normal, state.spin, axis), output.normal, output.angle);
    return patch().gauge(in_axes(axis, output.normal, output.force, output.moment));
  }
  [[nodiscard]] const Patch& patch() const noexcept override { return projector_.patch(); }

 private:
  PatchProjector projector_;
};

KeptDeflection PatchFinger::friction(const ContactLimits& limits, const TrialDeflection& trial, const Vector3d& normal,
                                     const Spin& spin, double angle, const PatchMemory& last, bool may_begin,
                                     FrictionMemory<double>& friction, PatchMemory& next) const noexcept {
  next.zero_axis = zero_axis(normal, spin, last.zero_axis);
  next.axis = turned_about(next.zero_axis, normal, angle);
  const double stiffness = trial.springs.stiffness;
  const double twist_stiffness = trial.springs.twist_stiffness;
  const PatchWrench wrench = in_axes(next.axis, normal, trial.tangential * stiffness, trial.twist * twist_stiffness);
  const PatchTwist last_slip{last.slip.x(), last.slip.y(), last.slip.z()};

  const auto project = [&](bool slides) -> PatchProjection {
    const double limit = limits.mu(slides) * trial.limit_load;
    const bool has_friction = limit > min_sliding_fraction * limits.mu(false) * trial.limit_load;
    if (has_friction)
      return projector_.project(wrench, limit, stiffness, std::sqrt(twist_stiffness / stiffness), last_slip);
    return {true, {}, {wrench.fx / stiffness, wrench.fy / stiffness, trial.twist}};
  };
  const bool was_sliding = friction.force_slides;
  PatchProjection found = project(was_sliding);
  if (found.slips && !was_sliding && may_begin && limits.mu(true) < limits.mu(false)) found = project(true);
  friction.force_slides = keeps_sliding(was_sliding, found.slips, limits.force_stick_fraction(),
                                        [&] { return patch().gauge(wrench) / (limits.mu(true) * trial.limit_load); });

  KeptDeflection kept{trial.tangential,
                      trial.twist,
                      found.slips,
                      found.slips,
                      found.slips,
                      0.0,
                      stiffness * trial.tangential.norm(),
                      std::fabs(wrench.moment),
                      found.converged};
  if (!found.slips) return kept;
  next.slip = {found.slip.vx, found.slip.vy, found.slip.omega};
  kept.tangential = (next.axis * found.wrench.fx + normal.cross(next.axis) * found.wrench.fy) / stiffness;
  kept.twist = found.wrench.moment / twist_stiffness;
  const SlipTwist slip{std::hypot(found.slip.vx, found.slip.vy), std::fabs(found.slip.omega)};
  kept.cor = slip.is_zero() ? 0.0 : slip.cor();
  return kept;
}

}  // namespace

SoftFinger::SoftFinger(const Patch& patch, const FingerParameters& parameters, double point_radius)
    : parameters_(parameters), limits_(parameters, std::nullopt) {
  patch_ = std::make_shared<const PatchFinger>(patch, point_radius);
}

}  // namespace limitcurve::godobject
