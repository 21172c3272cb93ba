// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/kernel/step_contacts.hpp"

#include <cstddef>

namespace limitcurve::godobject::kernel {

/// What steps the contacts of a batch: single numbers, or packs, by the instruction set that they need.
enum class InstructionSet { single, sse2, avx2, avx512 };

/// Whether this processor and this build have it.
[[nodiscard]] bool is_supported(InstructionSet set) noexcept;

/// The widest of those.
[[nodiscard]] InstructionSet widest_set() noexcept;

/// Steps all contacts: as many as fill packs by a set that is supported, the others by single numbers. The bits are the same whatever the
/// set.
template <class Real>
void step_with(InstructionSet set, const Shared<Real>& shared, const BasicContactBatch<Real>& contacts) noexcept;

struct Sse2;
struct Avx2;
struct Avx512;

/// Steps the first contacts, as many as fill packs; returns their number. One source file for each instruction set.
template <class Isa, class Real>
std::size_t step_packs(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts, std::size_t count) noexcept;

}  // namespace limitcurve::godobject::kernel
