// SPDX-License-Identifier: MIT
#include "godobject/batch/batch.hpp"

#include "godobject/batch/step.hpp"

#include <stdexcept>
#include <utility>

namespace limitcurve::godobject {

namespace kernel {

template <class Real>
void step_with([[maybe_unused]] InstructionSet set, const Shared<Real>& shared,
               const BasicContactBatch<Real>& contacts) noexcept {
  const std::size_t count = contacts.size();
  std::size_t i = 0;
#ifdef LIMITCURVE_PACKS
#ifdef LIMITCURVE_WIDE_PACKS
  if (set == InstructionSet::avx512) i = step_packs<Avx512>(shared, contacts, count);
  if (set == InstructionSet::avx2) i = step_packs<Avx2>(shared, contacts, count);
#endif
  if (set == InstructionSet::baseline) i = step_packs<Baseline>(shared, contacts, count);
#endif
  for (; i < count; ++i) step_contacts<Real, Real>(shared, contacts, i);
}

template void step_with(InstructionSet, const Shared<double>&, const ContactBatch&) noexcept;
template void step_with(InstructionSet, const Shared<float>&, const FloatContactBatch&) noexcept;

}  // namespace kernel

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
