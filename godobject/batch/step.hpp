// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch/step_contacts.hpp"
#include "godobject/kernel/instruction_set.hpp"

#include <cstddef>

namespace limitcurve::godobject::kernel {

/// Steps all contacts: those that fill packs with the set, which must be supported, the others with single numbers. All sets give the same
/// bits.
template <class Real>
void step_with(InstructionSet set, const Shared<Real>& shared, const BasicContactBatch<Real>& contacts) noexcept;

struct Sse2;
struct Avx2;
struct Avx512;

/// Steps the first contacts, as many as fill packs, and returns their number. Each instruction set has its own source file.
template <class Isa, class Real>
std::size_t step_packs(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts, std::size_t count) noexcept;

}  // namespace limitcurve::godobject::kernel
