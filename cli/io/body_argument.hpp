// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/body/rigid_body.hpp"
#include "godobject/scene/replay.hpp"

#include <string>

namespace limitcurve::cli {

struct SurfaceArgument;

/// The motion of the touched body, and the parameters of a free one.
struct BodyArgument {
  godobject::BodyMotion motion = godobject::BodyMotion::fixed;
  godobject::BodyParameters parameters = {};
};

/// Reads a body from a command line: `fixed`; `trace`, moved by the trace; `planar:mass=0.1`, which slides and turns in
/// the x-y plane without friction of its own; `free:mass=0.1`, with gravity (9.81 along −z, or `gravity=…`). Moments of
/// inertia are those of a homogeneous body with this surface, or `inertia=…` [kg m²] about every axis. Throws
/// std::invalid_argument.
BodyArgument read_body(const std::string& text, const SurfaceArgument& surface);

}  // namespace limitcurve::cli
