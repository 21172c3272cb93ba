// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/accuracy.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/contact_radius.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/limit_curve.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/patch.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/table_file.hpp"
#include "limitcurve/validate.hpp"
#include "limitcurve/version.hpp"
#include "limitcurve/wrench.hpp"

/// The friction limit curve of a soft finger, for any axisymmetric pressure: the page to start from.
///
/// ```cpp
/// #include "limitcurve/limitcurve.hpp"
/// using namespace limitcurve;
/// const Law law = parse_law("xydas-kao:k=3");                              // a pressure under the finger
/// const Table table = Table::build(law, 1e-6);                             // its limit curve, for a loop
/// const UnitWrench unit = table.wrench(SlipTwist::about_cor(0.5));         // it slips about a centre of rotation at c = 0.5 a
/// const double mu = 0.6, load = 2, radius = 0.005;                         // [1], [N], [m]
/// const double force = mu * load * unit.force, moment = mu * load * radius * unit.moment;  // [N], [N m]
/// if (!(force > 0 && moment > 0 && table.gauge(unit) > 0.999)) return 1;   // on the limit curve: 1
/// ```
///
/// Units: lengths in metres, loads in newtons. A *unit wrench* (f, m) is friction in units of μP and μPa; s = c/a is the distance of the centre of
/// rotation (COR) in contact radii. What throws is std::invalid_argument with a message that names the thing, its value and what is expected; no
/// member function of a finished law, curve or table throws. README.md has the mathematics, docs/accuracy.md every bound with its test.
namespace limitcurve {

// 1. Generate.

/// A pressure law from its name, `hertz`, `power:n=2.3`, `mix:0.7*hertz+0.3*uniform`; each has a factory in laws.hpp too.
Law parse_law(std::string_view text);

// law->evaluate(s)           unit wrench at s ∈ [0, ∞] with a bound of its error, at most 1e-14 relative. 0.1 µs to 0.1 ms.
// Table::build(law, 1e-8)    the curve for a loop, 0.7 to 10 KiB; certified_error() ≤ tolerance·max(1, m₀), from 1e-1 to 1e-14. Milliseconds.
// table.wrench(SlipTwist), table.gauge(UnitWrench), table.along(UnitWrench)      some ten to a hundred nanoseconds; no allocation.
// to_csv(table), to_json(table), to_header(table), read_table_csv(text, name)    files of a table: table_file.hpp

// 2. Validate.

// ExactCurve(law)                                the curve itself: what approximations are compared with
// Ellipse, Superellipse, Quartic, box, diamond   approximations.hpp; `curve_error(model, exact)` says how wrong one is: validate.hpp

/// The cheapest limit curve whose error is at most `tolerance`, first, and what it beat; error as a share of the exact radius on a ray.
std::vector<Candidate> choose(const Law& law, double tolerance);

// 3. In newtons.

/// Γ(P) = m₀ μ P a(P) [N m], the moment that a pure twist needs; RadiusLaw is a(P).
double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load);

// p_curve(curve, radius_law, mu, load, points)   the limit curve at one load [N]: force [N], moment [N m] and the COR [m] of each point
// load_to_hold(curve, radius_law, mu, F, M)      the grip [N] that holds a force and a moment
// Patch::rectangle(0.02, 0.01).wrench(twist)     contacts that are not round: patch.hpp

}  // namespace limitcurve
