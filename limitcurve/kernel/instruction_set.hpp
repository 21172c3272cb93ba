// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve::kernel {

/// The arithmetic of a batch or of many gauges: single numbers, or packs of an instruction set.
enum class InstructionSet { single, baseline, avx2, avx512 };

/// The packs' types of sets (pack.hpp).
struct Baseline;
struct Avx2;
struct Avx512;

/// Whether this processor and this build support a set.
[[nodiscard]] bool is_supported(InstructionSet set) noexcept;

/// The widest supported set.
[[nodiscard]] InstructionSet widest_set() noexcept;

}  // namespace limitcurve::kernel
