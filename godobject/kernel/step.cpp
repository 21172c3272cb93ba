// SPDX-License-Identifier: MIT
#include "godobject/kernel/step.hpp"

#include <initializer_list>

namespace limitcurve::godobject::kernel {

bool is_supported(InstructionSet set) noexcept {
#ifdef LIMITCURVE_PACKS
  switch (set) {
    case InstructionSet::single:
    case InstructionSet::sse2:
      return true;
#ifdef LIMITCURVE_WIDE_PACKS
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512vl");
#else
    default:
      return false;
#endif
  }
#endif
  return set == InstructionSet::single;
}

InstructionSet widest_set() noexcept {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::sse2}) {
    if (is_supported(set)) return set;
  }
  return InstructionSet::single;
}

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
