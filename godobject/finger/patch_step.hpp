// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_limits.hpp"
#include "godobject/finger/springs.hpp"

namespace limitcurve {
class Patch;
}

namespace limitcurve::godobject {

/// Step b of a contact that is not round, as a finger calls it. godobject/patch implements it; nothing here needs a
/// patch's definition.
class PatchStep {
 public:
  virtual ~PatchStep() = default;

  /// The closest point of the limit surface, in the patch's axes. `angle` is the proxy's α_p [rad], `last` what the
  /// last step left; `next` receives what this one leaves. If no slip may begin, what rests keeps the sticking limit.
  /// Does not allocate.
  [[nodiscard]] virtual KeptDeflection friction(const ContactLimits& limits, const TrialDeflection& trial,
                                                const Eigen::Vector3d& normal, const Spin& spin, double angle,
                                                const PatchMemory& last, bool may_begin, FrictionMemory<double>& memory,
                                                PatchMemory& next) const noexcept = 0;
  /// The gauge of the current friction wrench: the load that holds it at μ = 1 [N].
  [[nodiscard]] virtual double gauge(const FingerState& state) const noexcept = 0;
  /// The patch with its points smoothed.
  [[nodiscard]] virtual const Patch& patch() const noexcept = 0;
};

}  // namespace limitcurve::godobject
