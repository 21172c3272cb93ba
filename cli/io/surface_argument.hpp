// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/body/rigid_body.hpp"
#include "godobject/surface.hpp"

#include <functional>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// A surface that a finger touches.
struct SurfaceArgument {
  godobject::AnySurface surface;
  /// The homogeneous body with this surface and a mass [kg]; empty if the surface encloses no known volume.
  std::function<godobject::BodyParameters(double mass)> even_body;
  std::vector<std::string> notes = {};  ///< "warning: …" of a size that is none in metres
};

/// Reads a surface from a command line: `plane`, `sphere:radius=0.05`,
/// `capsule:radius=0.01,length=0.1`, `cylinder:radius=0.02,length=0.1`, or `box:x=0.12,y=0.04,z=0.04`
/// (lengths of its edges). Lengths in metres. Throws std::invalid_argument with the wrong item and the
/// expected ones; for a mesh, with the engines that touch meshes.
SurfaceArgument read_surface(const std::string& text);

}  // namespace limitcurve::cli
