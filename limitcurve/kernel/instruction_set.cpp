// SPDX-License-Identifier: MIT
#include "limitcurve/kernel/instruction_set.hpp"

#include <initializer_list>

namespace limitcurve::kernel {

bool is_supported(InstructionSet set) noexcept {
#ifdef LIMITCURVE_PACKS
  switch (set) {
    case InstructionSet::single:
    case InstructionSet::baseline:
      return true;
#ifdef LIMITCURVE_WIDE_PACKS
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#else
    default:
      return false;
#endif
  }
#endif
  return set == InstructionSet::single;
}

InstructionSet widest_set() noexcept {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::baseline}) {
    if (is_supported(set)) return set;
  }
  return InstructionSet::single;
}

}  // namespace limitcurve::kernel
