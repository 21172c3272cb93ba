// SPDX-License-Identifier: MIT
#include "limitcurve/curve_view.hpp"
#include "limitcurve/kernel/instruction_set.hpp"
#include "limitcurve/wrench.hpp"

#include <cstddef>

namespace limitcurve::kernel {

#ifdef LIMITCURVE_WIDE_PACKS
/// In a source file of its own for each instruction set: lookup_packs.hpp.
template <class Isa>
std::size_t gauges_in_packs(const CurveView<double>& curve, const UnitWrench* wrenches, double* gauges,
                            std::size_t count) noexcept;
#endif

/// The gauges of the first wrenches, as many as fill packs of the widest supported set; returns their number. Declared
/// in table.cpp.
std::size_t gauges([[maybe_unused]] const CurveView<double>& curve, [[maybe_unused]] const UnitWrench* wrenches,
                   [[maybe_unused]] double* gauges, [[maybe_unused]] std::size_t count) noexcept {
#ifdef LIMITCURVE_WIDE_PACKS
  const InstructionSet set = widest_set();
  if (set == InstructionSet::avx512) return gauges_in_packs<Avx512>(curve, wrenches, gauges, count);
  if (set == InstructionSet::avx2) return gauges_in_packs<Avx2>(curve, wrenches, gauges, count);
#endif
  return 0;
}

}  // namespace limitcurve::kernel
