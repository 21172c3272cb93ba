// SPDX-License-Identifier: MIT
#include "cli/io/patch_argument.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <algorithm>
#include <cmath>

using namespace limitcurve;

namespace {

double dot(const PatchTwist& twist, const PatchWrench& wrench) {
  return twist.vx * wrench.fx + twist.vy * wrench.fy + twist.omega * wrench.moment;
}

/// Finite, of power W·T ≥ 0, and each wrench within what any other twist allows: convex.
void require_honest(const Patch& patch) {
  const double arm = patch.moment_ratio() > 0.0 ? patch.moment_ratio() : 1.0;
  const PatchTwist twists[] = {{1.0, 0.0, 0.0},        {0.3, -0.8, 1.0 / arm},  {-1.0, 0.5, 1e-6 / arm},
                               {0.0, 0.0, -1.0 / arm}, {1e-3, 1e-3, 1.0 / arm}, {0.0, -2.0, -0.7 / arm},
                               {1.0, 1.0, 1e-14 / arm}};
  for (const PatchTwist& twist : twists) {
    const PatchFriction friction = patch.evaluate(twist);
    const double error = patch.about_origin(twist).error;
    fuzz::require(error >= 0.0, "an error below 0 or NaN");
    fuzz::require(fuzz::is_finite(friction.power) && friction.power >= 0.0, "a power below 0, infinite or NaN");
    fuzz::require(fuzz::is_finite(dot(twist, friction.wrench)), "a wrench that is not finite");
    const double size =
        std::hypot(twist.vx, twist.vy, arm * twist.omega) * std::max({1.0, patch.factors().x, patch.factors().y});
    const double slack = (1e-9 + 4.0 * error) * size;
    fuzz::require(std::fabs(dot(twist, friction.wrench) - friction.power) <= slack,
                  "a power that is not twist times wrench");
    for (const PatchTwist& other : twists) {
      const double least = dot(other, friction.wrench);
      fuzz::require(patch.power(other) >= least - slack * 10.0, "a wrench outside of the limit surface");
    }
  }
}

}  // namespace

/// A patch: the first line is the argument; @ stands for a file with the rest. The result is an error or a valid patch.
static const fuzz::Target patch_target("patch", [](std::string_view text) {
  static fuzz::TemporaryFile file;
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string argument(text.substr(0, end));
  // Other files are none of its business, and laws have targets of their own (some take a second to project).
  const std::size_t colon = argument.find(':');
  const std::string kind = argument.substr(0, colon);
  const bool reads = kind == "points" || kind == "polygon" || kind == "image";
  if (reads && argument.substr(std::min(colon + 1, argument.size()), 1) != "@") return;
  if (kind == "ellipse" && argument.find("law=hertz") == std::string::npos &&
      argument.find("law=cone") == std::string::npos)
    return;
  if (argument.find("samples") != std::string::npos || argument.find("mix") != std::string::npos) return;
  file.replace(text.substr(std::min(end + 1, text.size())));
  if (reads) argument.replace(colon + 1, 1, file.path());
  std::optional<Patch> patch;
  if (const auto complaint = fuzz::complaint_of([&] { patch = cli::parse_patch(argument).patch(); })) {
    fuzz::require(complaint->substr(0, 7) == "patch '", "a complaint that does not name the patch");
    return;
  }
  require_honest(*patch);
});
