// SPDX-License-Identifier: MIT
#include "cli/io/unit_checks.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitcurve::cli {

template <class Text>
void UnitChecks::note(First& first, const Text& text) {
  if (first.count++ == 0) first.text = text();
}

void UnitChecks::load(double load) {
  constexpr double most = 1000.0;
  if (load > most && std::isfinite(load))
    note(loads_, [&] {
      return "a load of " + format_number(load, 6) + " N is unusual for a finger; " +
             (source.empty() ? "hold and fit convert millinewtons by --units force=mN" : source);
    });
}

void UnitChecks::wrench(double force, double moment) {
  constexpr double large = 0.2;  // [N m], and the arm [m]
  if (std::fabs(moment) <= large || !(std::fabs(moment) > large * std::fabs(force))) return;
  note(wrenches_, [&] {
    return "a moment of " + format_number(moment, 6) + " N m with a force of " + format_number(force, 6) +
           " N has an arm of more than 0.2 m; " +
           (source.empty() ? "hold and fit convert N mm by --units moment=Nmm" : source);
  });
}

void UnitChecks::force_under(double load, double force) {
  ++loaded_;
  if (std::fabs(force) > load) ++swapped_;
}

void UnitChecks::twist(double before, double now, double time) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double step = std::fabs(now - before);
  if (!(step > 1.0)) return;
  if (std::fabs(step - turn) < 1.0 && std::fabs(now) <= turn && std::fabs(before) <= turn) return;
  note(twists_, [&] {
    return "the twist changes by " + format_number(step, 6) + " rad up to time " + format_number(time, 6) +
           " s: if it is in degrees, add --units angle=deg";
  });
}

void UnitChecks::time_step(double step) {
  ++steps_;
  if (step > 1.0) ++long_steps_;
}

void UnitChecks::angle(const std::string& what, double angle, std::string_view text) {
  if (std::fabs(angle) <= 2.0 * std::numbers::pi || text.ends_with("deg") || text.ends_with("rad")) return;
  others_.push_back(what + " = " + format_number(angle) + " rad is more than a turn: if you mean degrees, write " +
                    format_number(angle) + "deg");
}

void UnitChecks::radii(const RadiusLaw& law, std::span<const double> loads) {
  constexpr double largest_radius = 0.1;
  double radius = 0.0;
  double at_load = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const double load : loads) {
    if (!(load > 0.0 && std::isfinite(load))) continue;
    least = std::min(least, load);
    most = std::max(most, load);
    if (law.radius(load) > radius) {
      radius = law.radius(load);
      at_load = load;
    }
  }
  if (radius > largest_radius) {
    others_.push_back("a contact radius of " + format_number(radius, 6) + " m at " + format_number(at_load, 6) +
                      " N: --radius-law and --mu-r must be in metres, so that 6 mm are 0.006");
  }
  const auto [first, last] = law.sampled_loads();
  if (least < first || most > last) {
    others_.push_back("the radius law is extrapolated: it was measured from " + format_number(first) + " to " +
                      format_number(last) + " N and is used from " + format_number(least) + " to " +
                      format_number(most) + " N");
  }
}

void UnitChecks::length(const std::string& what, double across) {
  constexpr double longest = 0.5;
  if (across > longest)
    others_.push_back(what + ": " + format_number(across, 6) + " m across: lengths must be in metres");
}

std::vector<std::string> UnitChecks::lines() const {
  std::vector<std::string> texts = others_;
  for (const First* const first : {&loads_, &wrenches_, &twists_}) {
    if (first->count == 0) continue;
    texts.push_back(first->text + (first->count > 1 ? " (the first of " + std::to_string(first->count) + ")" : ""));
  }
  if (2 * swapped_ > loaded_) {
    texts.push_back("the friction force exceeds the load in " + std::to_string(swapped_) + " of " +
                    std::to_string(loaded_) + " rows: are the two columns swapped?");
  }
  if (2 * long_steps_ > steps_) {
    texts.push_back("the time steps exceed 1 s in " + std::to_string(long_steps_) + " of " + std::to_string(steps_) +
                    " rows: if time is in ms or ns, add --units time=ms or time=1e-9");
  }
  for (std::string& text : texts) text.insert(0, "warning: ");
  return texts;
}

std::vector<std::string> radius_warnings(const RadiusLaw& law, std::span<const double> loads) {
  UnitChecks questions;
  questions.radii(law, loads);
  for (const double one : loads) questions.load(one);
  return questions.lines();
}

}  // namespace limitcurve::cli
