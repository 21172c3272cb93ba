// SPDX-License-Identifier: MIT
#include "limitcurve/contact/radius_law.hpp"
#include "limitcurve/internal/number.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace limitcurve;

/// The grammar of the radius laws: what it accepts is a power law that says so itself, and radii are positive.
static const fuzz::Target radius_law_target("radius_law", [](std::string_view text) {
  std::optional<RadiusLaw> law;
  if (fuzz::complaint_of([&] { law = RadiusLaw::parse(text); })) return;
  fuzz::require(law->radius(1.0) > 0.0 && fuzz::is_finite(law->radius(1.0)), "a coefficient that is not a radius");
  fuzz::require(law->exponent() >= 0.0 && law->exponent() <= 1.0, "an exponent out of range");
  double last = 0.0;
  for (const double load : {0.0, 1e-3, 0.5, 1.0, 7.0, 1e3}) {
    const double radius = law->radius(load);
    fuzz::require(radius >= last, "a radius that shrinks with the load, or is none");
    last = radius;
  }
  const std::string name = "power:c=" + format_number(law->radius(1.0)) + ",gamma=" + format_number(law->exponent());
  const RadiusLaw again = RadiusLaw::parse(name);
  fuzz::require(again.radius(3.0) == law->radius(3.0), "the same power law has another radius");
});
