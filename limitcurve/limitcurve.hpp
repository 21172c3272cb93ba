// SPDX-License-Identifier: MIT
#pragma once

#include "accuracy.hpp"
#include "approximations.hpp"
#include "choose.hpp"
#include "contact/load_curves.hpp"
#include "contact/load_to_hold.hpp"
#include "exact_curve.hpp"
#include "laws.hpp"
#include "limit_curve.hpp"
#include "pressure_law.hpp"
#include "table.hpp"
#include "table_file.hpp"
#include "validate.hpp"
#include "version.hpp"
#include "wrench.hpp"

/// The friction limit curve of a soft finger, for any axisymmetric pressure. Start here: this file includes the whole module.
///
/// ```cpp
/// #include "limitcurve/limitcurve.hpp"
/// using namespace limitcurve;
/// const Law law = parse_law("xydas-kao:k=3");                              // a pressure under the finger
/// const Table table = Table::build(law);                                   // its limit curve, for a loop
/// const UnitWrench unit = table.wrench(SlipTwist::about_cor(0.5));         // slip about a centre of rotation at c = 0.5 a
/// const double mu = 0.6, load = 2, radius = 0.005;                         // [1], [N], [m]
/// const double force = mu * load * unit.force, moment = mu * load * radius * unit.moment;  // [N], [N m]
/// if (!(force > 0 && moment > 0 && table.gauge(unit) > 0.999)) return 1;   // on the limit curve: 1
/// ```
///
/// Units: lengths in metres, loads in newtons. A *unit wrench* (f, m) is a force in units of μP and a moment in units of μPa.
/// s = c/a ∈ [0, ∞] is the distance of the centre of rotation (COR) from the contact centre, in contact radii.
/// Errors: factories and builders throw std::invalid_argument; the message names the parameter, its value and the permitted range.
/// Member functions that evaluate a law, a curve or a table do not throw.
/// docs/theory.md has the mathematics, docs/accuracy.md every error bound with its test.
namespace limitcurve {

// 1. Generate.

/// The pressure law with this name: `hertz`, `power:n=2.3`, `mix:0.7*hertz+0.3*uniform`. laws.hpp has all names, and a factory for each
/// law. Throws std::invalid_argument for an unknown name or a parameter out of range.
Law parse_law(std::string_view text);

// law->evaluate(s)              unit wrench at s ∈ [0, ∞] and a bound of its error, at most 1e-14 relative: microseconds to
//                               half a millisecond
// Table::build(law, 1e-8)       the curve for a control loop: checked_error() ≤ tolerance·max(1, m₀), tolerance 1e-14 to
//                               1e-1: milliseconds
// table.wrench(SlipTwist), table.gauge(UnitWrench), table.along(UnitWrench)    ten to a hundred nanoseconds, no allocation
// to_csv(table), to_json(table), to_header(table), read_table_csv(text, name)  table files: table_file.hpp

// 2. Validate.

// ExactCurve(law)                                the exact curve, the reference for approximations
// Ellipse, box, diamond                          approximations: approximations.hpp
// curve_error(model, exact)                      the error of an approximation: validate.hpp

/// Compares the limit curves that can stand for `law`: all candidates, sorted by cost. `chosen` marks the cheapest one whose radial error,
/// relative to the exact curve on the same ray, is at most `tolerance` ∈ [1e-10, 1]. Details: choose.hpp.
std::vector<Candidate> choose(const Law& law, double tolerance);

// 3. In newtons.

/// Γ(P) = m₀ μ P a(P) [N m], the largest friction moment at load P [N]: the moment of a pure twist. RadiusLaw is a(P).
double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load);

// p_curve(curve, contact, load, points)          the limit curve at one load [N]: force [N], moment [N m] and COR [m] of each point
// load_to_hold(curve, contact, F, M)             the smallest grip [N] that holds a force and a moment without slip
// Patch::rectangle(0.02, 0.01).wrench(twist)     contacts that are not round, and load_to_hold(patch, mu, wrench): patch.hpp
// half_spaces(patch, 32)                         inequalities inside the limit surface, for a planner: patch/half_spaces.hpp

}  // namespace limitcurve
