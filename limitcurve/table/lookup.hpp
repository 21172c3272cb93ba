// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"
#include "limitcurve/kernel/instruction_set.hpp"
#include "limitcurve/wrench.hpp"

#include <cstddef>

namespace limitcurve::kernel {

/// The gauges of the first wrenches, as many as fill packs; returns their number. Each instruction set has its own source file.
template <class Isa>
std::size_t gauges_in_packs(const CurveView<double>& curve, const UnitWrench* wrenches, double* gauges, std::size_t count) noexcept;

}  // namespace limitcurve::kernel
