// SPDX-License-Identifier: MIT
#include "tests/fuzz/steps.hpp"

using namespace limitcurve;

/// The step of the god-object, fed with any bits: finite output, wrench within the limit, slip work ≥ 0, no exception.
static const fuzz::Target step_target("step", [](const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  fuzz::run_steps(bytes, [](const auto&, const auto&, const test::StepCheck& check) {
    fuzz::require(check.fault.empty(), check.fault);
  });
});
