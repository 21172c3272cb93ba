// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <functional>
#include <string>

namespace limitcurve::table {

/// Throws std::invalid_argument, with the name, the requirement and the place, for a function of the slip twist that is
/// not a limit curve without corners and faces (LimitCurve::wrench): a wrench that is not a number or negative, a twist
/// that does more work on another wrench of the curve than on its own, a wrench that many twists share, or one that
/// jumps. About 2000 evaluations.
void require_limit_curve(const std::function<UnitWrench(SlipTwist)>& curve, const std::string& name);

}  // namespace limitcurve::table
