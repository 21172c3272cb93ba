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
  std::vector<std::string> notes =
      {};  ///< "note: …" of what was changed in a file's surface, "warning: …" of a size that is none in metres
};

/// Reads a surface from a command line: `plane`, `sphere:radius=0.05`,
/// `capsule:radius=0.01,length=0.1`, `cylinder:radius=0.02,length=0.1`, `box:x=0.12,y=0.04,z=0.04`
/// (lengths of its edges), and `mesh:FILE.obj` or `mesh:FILE.stl[,scale=0.001][,body=2]` (the
/// file's unit; one of its bodies) if the program was built with meshes. Lengths in metres. Throws
/// std::invalid_argument with the wrong item and the expected ones.
SurfaceArgument read_surface(const std::string& text);

}  // namespace limitcurve::cli
