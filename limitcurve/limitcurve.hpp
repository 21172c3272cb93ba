// SPDX-License-Identifier: MIT
#pragma once

#include "accuracy.hpp"
#include "approximations.hpp"
#include "contact/load_curves.hpp"
#include "contact/load_to_hold.hpp"
#include "exact_curve.hpp"
#include "laws.hpp"
#include "limit_curve.hpp"
#include "pressure_law.hpp"
#include "table.hpp"
#include "table_file.hpp"
#include "version.hpp"
#include "wrench.hpp"

/// The friction limit curve of a soft finger, for any axisymmetric pressure: how much force and moment a sliding,
/// twisting contact carries. Start here. This header does not include patches (patch/), engines (engines/,
/// tangent_ellipse.hpp) and `hold_error` (measured/).
///
/// ```cpp
/// #include "limitcurve/limitcurve.hpp"
/// using namespace limitcurve;
/// const Law law = parse_law("xydas-kao:k=3");                        // the pressure under the finger
/// const Table table = Table::build(law);                             // its limit curve, fast enough for a loop
/// const UnitWrench unit = table.wrench(SlipTwist::about_cor(0.5));   // slip about a centre of rotation at 0.5 a
/// const double mu = 0.6, load = 2, radius = 0.005;                   // [1], [N], [m]
/// const double force = mu * load * unit.force, moment = mu * load * radius * unit.moment;  // [N], [N m]
/// if (!(force > 0 && moment > 0 && table.gauge(unit) > 0.999)) return 1;  // on the limit curve: 1
/// ```
///
/// Units: lengths in metres, loads in newtons. A *unit wrench* (f, m) is a force in units of μP and a moment in units
/// of μPa. s = c/a ∈ [0, ∞] is the distance of the centre of rotation (COR) from the contact centre, in contact radii.
/// Errors: factories and builders throw std::invalid_argument, naming the parameter, its value and the permitted range.
/// Evaluating a law, curve or table never throws. The mathematics is in docs/theory.md; every error bound, with its
/// test, in docs/accuracy.md.
namespace limitcurve {

// 1. Generate.
// parse_law("power:n=2.3") a pressure law by its name: laws.hpp has all names and factories
// law->evaluate(s)         reference: unit wrench at s ∈ [0, ∞] with its error bound, at most 1e-14 relative;
//                          microseconds to half a millisecond
// Table::build(law, 1e-8)  for control loops: checked_error() ≤ tolerance·max(1, m₀), tolerance 1e-14 to 1e-1;
//                          milliseconds, by quadrature up to seconds
// table.wrench(SlipTwist), table.gauge(UnitWrench), table.along(UnitWrench)    nanoseconds, no allocation
// to_csv(table), to_json(table), read_table_csv(text, name)                    table files: table_file.hpp
// to_header(table)                                                             C or C++ code: export/header.hpp

// 2. Validate.
// ExactCurve(law)                             the reference
// Ellipse, box, diamond                       what physics engines use: approximations.hpp
// curve_error(model, exact)                   how wrong they are: validate/validate.hpp
// choose(law, tolerance)                      which limit curve is good enough: validate/choose.hpp

// 3. In newtons.
// moment_capacity(m₀, radius_law, mu, load)   largest friction moment [N m], of a pure twist: contact/load_curves.hpp
// p_curve(curve, contact, load, points)       the limit curve at one load [N]: force [N], moment [N m], COR [m]
// load_to_hold(curve, contact, F, M)          the smallest grip [N] that holds a force and a moment without slip
// Patch::rectangle(0.02, 0.01).wrench(twist)  contacts that are not round: patch/patch.hpp
// half_spaces(patch, 32)                      inequalities in the limit surface, for planners: patch/half_spaces.hpp

}  // namespace limitcurve
