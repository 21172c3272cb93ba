// SPDX-License-Identifier: MIT
#include "limitcurve/kernel/lookup_packs.hpp"

namespace limitcurve::kernel {

template std::size_t gauges_in_packs<Avx512>(const CurveView<double>&, const UnitWrench*, double*,
                                             std::size_t) noexcept;

}  // namespace limitcurve::kernel
