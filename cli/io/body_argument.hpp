// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/replay.hpp"
#include "godobject/rigid_body.hpp"

#include <string>

namespace limitcurve::cli {

struct SurfaceArgument;

/// Who moves what a finger touches, and what it is made of where it is free.
struct BodyArgument {
  godobject::BodyMotion motion = godobject::BodyMotion::fixed;
  godobject::BodyParameters parameters = {};
};

/// The body that a command line names: `fixed`; `trace`, moved as the trace says; `planar:mass=0.1`, sliding and turning in the
/// x-y plane without friction of its own; `free:mass=0.1`, with gravity (9.81 along −z, or `gravity=…`). Moments of inertia
/// are those of the evenly filled surface, or `inertia=…` [kg m²] about every axis. Throws std::invalid_argument.
BodyArgument read_body(const std::string& text, const SurfaceArgument& surface);

}  // namespace limitcurve::cli
