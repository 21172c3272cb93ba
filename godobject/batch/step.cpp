// SPDX-License-Identifier: MIT
#include "godobject/batch/step.hpp"

namespace limitcurve::godobject::kernel {

template <class Real>
void step_with([[maybe_unused]] InstructionSet set, const Shared<Real>& shared, const BasicContactBatch<Real>& contacts) noexcept {
  const std::size_t count = contacts.size();
  std::size_t i = 0;
#ifdef LIMITCURVE_PACKS
#ifdef LIMITCURVE_WIDE_PACKS
  if (set == InstructionSet::avx512) i = step_packs<Avx512>(shared, contacts, count);
  if (set == InstructionSet::avx2) i = step_packs<Avx2>(shared, contacts, count);
#endif
  if (set == InstructionSet::sse2) i = step_packs<Sse2>(shared, contacts, count);
#endif
  for (; i < count; ++i) step_contacts<Real, Real>(shared, contacts, i);
}

template void step_with(InstructionSet, const Shared<double>&, const ContactBatch&) noexcept;
template void step_with(InstructionSet, const Shared<float>&, const FloatContactBatch&) noexcept;

}  // namespace limitcurve::godobject::kernel
