// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/approximations.hpp"  // IWYU pragma: export
#include "../limitcurve/laws.hpp"            // IWYU pragma: export
#include "../limitcurve/table.hpp"           // IWYU pragma: export
#include "contact.hpp"                       // IWYU pragma: export
#include "finger_curve.hpp"                  // IWYU pragma: export
#include "soft_finger.hpp"                   // IWYU pragma: export
#include "surface.hpp"                       // IWYU pragma: export

/// The soft-finger god-object. Start here: this file includes what a control loop needs to touch a plane or contacts
/// that you pass. Bodies (body/), scenes (scene/) and more surfaces (surfaces/) have headers of their own.
///
/// ```cpp
/// #include "godobject/godobject.hpp"
/// using namespace limitcurve;
/// const godobject::FingerParameters skin{.mu = 0.6, .stiffness = 1000, .twist_stiffness = 0.025, .damping = 1};
/// godobject::SoftFinger finger(Table::build(hertz()), skin);
/// const godobject::AnySurface plate{godobject::PlaneSurface()};
/// for (int step = 0; step < 1000; ++step) {  // every millisecond
///   const godobject::DevicePose device{{1e-5 * step, 0, -1e-3}, Eigen::Quaterniond::Identity()};  // [m]
///   const godobject::FingerOutput output = finger.update(plate, device, 1e-3);                     // [s]
///   // On the user: output.whole_force() [N], output.moment_vector() [N m].
///   if (output.state == godobject::ContactState::invalid || !(output.whole_force().norm() < 2)) return 1;
/// }
/// ```
///
/// Units: metres, newtons, seconds, radians. Constructors throw std::invalid_argument with the parameter, its value,
/// unit and range. The control loop does not throw, allocate or lock: a bad sample gives ContactState::invalid, and the
/// last output fades. Distinct fingers on distinct threads need no lock. godobject/README.md explains the step,
/// docs/paper.md our corrections.
///
/// A finger has
///  - a limit curve, FingerCurve: a Table of any law, an Ellipse, or a box (the paper's uncoupled step);
///  - FingerParameters (finger.hpp): friction, contact radius a(P), springs, dampers;
///  - a Projection: closest_point settles at eq. (17)'s wrench if the slide keeps its direction; radial and c_curve
///    come from the paper (§5).
/// `update` takes an AnySurface (plane, or yours by surface.hpp; sphere, capsule, cylinder, box by
/// surfaces/surfaces.hpp), or a Contact that other code has found, in the frame of the touched body (BodyPose).
///
/// A SoftFinger can also take a Patch, a contact that is not round. Batch and FloatBatch step thousands of contacts in
/// a single call (batch/batch.hpp). apply_friction is the friction step alone, for simulators with their own springs
/// (friction.hpp). body/grasp.hpp holds a rigid body with several fingers. scene/replay.hpp runs recorded motions,
/// scene/pivot.hpp the paper's experiment; scene/choose_step.hpp finds the cheapest model that a scene needs.
namespace limitcurve::godobject {}
