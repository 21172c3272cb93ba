// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve::godobject::kernel {

/// The arithmetic of a batch: single numbers, or packs of an instruction set.
enum class InstructionSet { single, baseline, avx2, avx512 };

/// Whether this processor and this build support a set.
[[nodiscard]] bool is_supported(InstructionSet set) noexcept;

/// The widest supported set.
[[nodiscard]] InstructionSet widest_set() noexcept;

}  // namespace limitcurve::godobject::kernel
