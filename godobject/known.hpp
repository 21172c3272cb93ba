// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve::godobject {

/// What a step knows of a contact beforehand, and does not ask.
enum class Known {
  nothing,
  home,      ///< that the contact is at home (Home)
  slipping,  ///< … and where the last slip was, from where a search may need one step
  resting,   ///< … and that there is no last slip to begin a search from
  lost,      ///< … but not by which way to the foot: one step does not lead there
};

}  // namespace limitcurve::godobject
