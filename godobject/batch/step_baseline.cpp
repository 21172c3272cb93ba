// SPDX-License-Identifier: MIT
#include "godobject/batch/step_packs.hpp"

namespace limitcurve::godobject::kernel {

template std::size_t step_packs<Baseline>(const Shared<double>&, const ContactBatch&, std::size_t) noexcept;
template std::size_t step_packs<Baseline>(const Shared<float>&, const FloatContactBatch&, std::size_t) noexcept;

}  // namespace limitcurve::godobject::kernel
