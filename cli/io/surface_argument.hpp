// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/rigid_body.hpp"
#include "godobject/surface.hpp"

#include <functional>
#include <string>

namespace limitcurve::cli {

/// What a finger touches.
struct SurfaceArgument {
  godobject::AnySurface surface;
  /// The evenly filled body with this surface and a mass [kg]; empty where the surface encloses none that is known.
  std::function<godobject::BodyParameters(double mass)> even_body;
};

/// The surface that a command line names: `plane`, `sphere:radius=0.05`, `capsule:radius=0.01,length=0.1`,
/// `cylinder:radius=0.02,length=0.1`, `box:x=0.12,y=0.04,z=0.04` (lengths of its edges), and `mesh:FILE.obj` or
/// `mesh:FILE.stl[,scale=0.001]` (the file's unit) where the program was built with meshes. Lengths in metres. Throws
/// std::invalid_argument that names the item and what was expected.
SurfaceArgument read_surface(const std::string& text);

}  // namespace limitcurve::cli
