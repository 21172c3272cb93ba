// SPDX-License-Identifier: MIT
#include "cli/commands/radius_check.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <limits>

namespace limitcurve::cli {

void warn_of_radii(Messages& messages, const RadiusLaw& radius_law, std::span<const double> loads) {
  constexpr double largest_radius = 0.1;
  double radius = 0.0;
  double at_load = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const double load : loads) {
    if (!(load > 0.0)) continue;
    least = std::min(least, load);
    most = std::max(most, load);
    if (radius_law.radius(load) > radius) {
      radius = radius_law.radius(load);
      at_load = load;
    }
  }
  if (radius > largest_radius) {
    messages.say("limitcurve: warning: the radius law gives a contact radius of " + format_number(radius, 3) + " m at a load of " +
                 format_number(at_load, 3) + " N: is the law in metres?");
  }
  const auto [first, last] = radius_law.sampled_loads();
  if (least < first || most > last) {
    messages.say("limitcurve: warning: the radius law is extrapolated: its samples have loads from " + format_number(first, 3) + " to " +
                 format_number(last, 3) + " N, it is used from " + format_number(least, 3) + " to " + format_number(most, 3) + " N");
  }
}

void warn_of_patch(Messages& messages, const std::string& text, const Patch& patch, double largest_arm) {
  if (!(patch.moment_ratio() > largest_arm)) return;
  messages.say("limitcurve: warning: patch '" + text + "': its load is at a mean distance of " + format_number(patch.moment_ratio(), 3) +
               " m from its centre: is it in metres?");
}

}  // namespace limitcurve::cli
