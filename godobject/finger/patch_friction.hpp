// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_limits.hpp"
#include "godobject/finger/springs.hpp"
#include "limitcurve/patch.hpp"

#include <memory>

namespace limitcurve::godobject {

class PatchProjector;

/// Step b of a contact that is a patch: the closest point of its limit surface, in the patch's axes. `angle` is the proxy's α_p [rad], `last`
/// what the last step left; `next` receives what this one leaves. If no slip may begin, what rests keeps the sticking limit.
[[nodiscard]] KeptDeflection friction_of_patch(const PatchProjector& patch, const ContactLimits& limits, const TrialDeflection& trial,
                                               const Eigen::Vector3d& normal, const Spin& spin, double angle, const PatchMemory& last,
                                               bool may_begin, FrictionMemory<double>& friction, PatchMemory& next) noexcept;

/// The gauge of the present friction wrench: the load that holds it at μ = 1 [N].
[[nodiscard]] double patch_gauge(const PatchProjector& patch, const FingerState& state) noexcept;

/// The projector of a patch whose points get a radius [m]; 0: the least, 1e-3 m₀. Throws std::invalid_argument with parameter, value, unit
/// and range.
[[nodiscard]] std::shared_ptr<const PatchProjector> make_projector(const Patch& patch, double point_radius);

}  // namespace limitcurve::godobject
