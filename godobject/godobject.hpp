// SPDX-License-Identifier: MIT
#pragma once

/// The soft-finger god-object: everything of this module. The mathematics, symbols and caveats are in godobject/README.md.
#include "godobject/batch.hpp"            // IWYU pragma: export
#include "godobject/choose_step.hpp"      // IWYU pragma: export
#include "godobject/contact.hpp"          // IWYU pragma: export
#include "godobject/finger_curve.hpp"     // IWYU pragma: export
#include "godobject/grasp.hpp"            // IWYU pragma: export
#include "godobject/passivity.hpp"        // IWYU pragma: export
#include "godobject/patch_finger.hpp"     // IWYU pragma: export
#include "godobject/pivot.hpp"            // IWYU pragma: export
#include "godobject/replay.hpp"           // IWYU pragma: export
#include "godobject/rigid_body.hpp"       // IWYU pragma: export
#include "godobject/soft_finger.hpp"      // IWYU pragma: export
#include "godobject/surface.hpp"          // IWYU pragma: export
#include "limitcurve/approximations.hpp"  // IWYU pragma: export
#include "limitcurve/laws.hpp"            // IWYU pragma: export
#include "limitcurve/table.hpp"           // IWYU pragma: export
