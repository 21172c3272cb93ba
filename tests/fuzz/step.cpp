// SPDX-License-Identifier: MIT
#include "tests/fuzz/steps.hpp"

using namespace limitcurve;

/// The step of the god-object, fed with any bits: finite output, wrench within the limit, slip work ≥ 0, no exception.
static const fuzz::Target step_target("step", [](std::string_view input) {
  fuzz::Bytes bytes(input);
  fuzz::run_steps(bytes, [](const auto&, const auto&, const test::StepCheck& check) {
    fuzz::require(check.fault.empty(), check.fault);
  });
});
