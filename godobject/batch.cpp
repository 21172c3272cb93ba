// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"

#include "godobject/batch/step.hpp"

#include <stdexcept>
#include <utility>

namespace limitcurve::godobject {

template <class Real>
BasicBatch<Real>::BasicBatch(BasicFingerCurve<Real> curve, const FingerParameters& parameters, Projection projection)
    : curve_(std::move(curve)),
      limits_(parameters, curve_.moment_max()),
      projection_(projection),
      stiffness_(static_cast<Real>(parameters.stiffness)),
      twist_stiffness_(static_cast<Real>(parameters.twist_stiffness)) {
  check_projection(curve_, projection);
}

template <class Real>
void BasicBatch<Real>::step(const BasicContactBatch<Real>& contacts) const noexcept {
  const kernel::Shared<Real> shared{curve_.view(), projection_, limits_, stiffness_, twist_stiffness_};
  kernel::step_with(kernel::widest_set(), shared, contacts);
}

template class BasicBatch<double>;
template class BasicBatch<float>;

}  // namespace limitcurve::godobject
