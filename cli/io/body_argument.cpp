// SPDX-License-Identifier: MIT
#include "cli/io/body_argument.hpp"

#include "cli/io/surface_argument.hpp"
#include "limitcurve/internal/range.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/key_values.hpp"

#include <limits>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

using namespace ranges;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

godobject::BodyParameters solid(const SurfaceArgument& surface, double mass, double inertia) {
  godobject::BodyParameters result;
  if (inertia == inertia) {
    result.mass = mass;
    result.inertia.setConstant(inertia);
  } else if (surface.even_body) {
    result = surface.even_body(mass);
  } else {
    throw std::invalid_argument(
        "no 'inertia', and this surface encloses no known volume, expected mass=NUMBER,inertia=NUMBER");
  }
  result.validate();
  return result;
}

}  // namespace

BodyArgument read_body(const std::string& text, const SurfaceArgument& surface) {
  if (text == "fixed") return {};
  if (text == "trace") return {godobject::BodyMotion::prescribed};
  const auto [kind, given] = split_description(text);
  const std::string_view rest = given.value_or("");
  double mass = none;
  double inertia = none;
  if (kind == "planar") {
    read_key_values(rest, {number_key("mass", mass, positive), number_key("inertia", inertia, positive, false)});
    BodyArgument result{godobject::BodyMotion::free, solid(surface, mass, inertia)};
    result.parameters.gravity.setZero();
    result.parameters.free = {true, true, false, false, false, true};
    return result;
  }
  if (kind == "free") {
    double gravity = 9.81;
    read_key_values(rest, {number_key("mass", mass, positive), number_key("inertia", inertia, positive, false),
                           number_key("gravity", gravity, non_negative, false)});
    BodyArgument result{godobject::BodyMotion::free, solid(surface, mass, inertia)};
    result.parameters.gravity = {0.0, 0.0, -gravity};
    return result;
  }
  throw std::invalid_argument(
      "got '" + text + "', expected fixed, trace, planar:mass=0.1 or free:mass=0.1" +
      did_you_mean(kind, {"fixed", "trace", "planar", "free"}, std::string_view(text).substr(kind.size())));
}

}  // namespace limitcurve::cli
