// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/kernel/pack.hpp"
#include "godobject/kernel/step.hpp"

namespace limitcurve::godobject::kernel {

template <class Isa, class Real>
std::size_t step_packs(const Shared<Real>& shared, const BasicContactBatch<Real>& contacts, std::size_t count) noexcept {
  using Number = Pack<Real, Isa>;
  std::size_t i = 0;
  for (; i + Number::size <= count; i += Number::size) step_contacts<Real, Number>(shared, contacts, i);
  return i;
}

}  // namespace limitcurve::godobject::kernel
