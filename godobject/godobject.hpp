// SPDX-License-Identifier: MIT
#pragma once

/// The soft-finger god-object: everything of this module. The mathematics, symbols and caveats are in godobject/README.md.
#include "godobject/any_surface.hpp"               // IWYU pragma: export
#include "godobject/batch.hpp"                     // IWYU pragma: export
#include "godobject/c_curve_projection.hpp"        // IWYU pragma: export
#include "godobject/choice.hpp"                    // IWYU pragma: export
#include "godobject/choose_step.hpp"               // IWYU pragma: export
#include "godobject/closest_point_projection.hpp"  // IWYU pragma: export
#include "godobject/contact.hpp"                   // IWYU pragma: export
#include "godobject/contact_arrays.hpp"            // IWYU pragma: export
#include "godobject/contact_law.hpp"               // IWYU pragma: export
#include "godobject/contact_state.hpp"             // IWYU pragma: export
#include "godobject/device_pose.hpp"               // IWYU pragma: export
#include "godobject/elliptic_pull.hpp"             // IWYU pragma: export
#include "godobject/finger_state.hpp"              // IWYU pragma: export
#include "godobject/float_batch.hpp"               // IWYU pragma: export
#include "godobject/free_disc.hpp"                 // IWYU pragma: export
#include "godobject/friction.hpp"                  // IWYU pragma: export
#include "godobject/grasp.hpp"                     // IWYU pragma: export
#include "godobject/grip.hpp"                      // IWYU pragma: export
#include "godobject/kinds.hpp"                     // IWYU pragma: export
#include "godobject/passivity.hpp"                 // IWYU pragma: export
#include "godobject/pivot.hpp"                     // IWYU pragma: export
#include "godobject/projection.hpp"                // IWYU pragma: export
#include "godobject/radial_projection.hpp"         // IWYU pragma: export
#include "godobject/replay.hpp"                    // IWYU pragma: export
#include "godobject/rigid_body.hpp"                // IWYU pragma: export
#include "godobject/scene_replay.hpp"              // IWYU pragma: export
#include "godobject/soft_finger.hpp"               // IWYU pragma: export
#include "godobject/surface.hpp"                   // IWYU pragma: export
#include "godobject/surfaces.hpp"                  // IWYU pragma: export
