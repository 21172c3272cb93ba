// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_batch.hpp"
#include "godobject/contact_limits.hpp"

namespace limitcurve::godobject {

/// Step b for many contacts that share a limit curve and parameters: every curve and projection, μ_d < μ_s, a(P), Γ = 0, in double or
/// float. Dampers, faults, faded forces and unwrapped angles are a SoftFinger's.
///
///     const Batch batch(Table::build(hertz(), 1e-8), {.mu = 0.6});
///     ContactArrays arrays(10000);
///     batch.step(arrays.batch());  // every millisecond, after x, y, angle and depth are written
///
/// The results are those of one contact at a time, whatever the processor's vectors (README, "Batches"). Immutable; one may serve any
/// number of threads, each with a part of the arrays. Allocates at construction only.
template <class Real>
class BasicBatch {
 public:
  /// Throws std::invalid_argument naming parameter, value, unit and range. A box goes with the closest point only.
  BasicBatch(BasicFingerCurve<Real> curve, const FingerParameters& parameters, Projection projection = Projection::closest_point);

  /// Steps all contacts; the arrays must be of one length.
  void step(const BasicContactBatch<Real>& contacts) const noexcept;

 private:
  BasicFingerCurve<Real> curve_;
  ContactLimits limits_;
  Projection projection_;
  Real stiffness_;
  Real twist_stiffness_;
};

extern template class BasicBatch<double>;
extern template class BasicBatch<float>;

using Batch = BasicBatch<double>;
using FloatBatch = BasicBatch<float>;

}  // namespace limitcurve::godobject
