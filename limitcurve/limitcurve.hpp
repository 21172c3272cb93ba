// SPDX-License-Identifier: MIT
#pragma once

/// The page to start from: everything public in limitcurve, in the order in which it is used.
///
///   const Law law = parse_law("hertz");                         a pressure law (laws.hpp)
///   law->evaluate(0.5)                                          its unit wrench at s = c/a, with an error bound
///   const ExactCurve curve(law);                                its limit curve
///   curve.wrench(SlipTwist::about_cor(0.5)); curve.gauge(w);    what every limit curve gives
///   Ellipse::through_intercepts(curve.moment_ratio());          a cheaper curve …
///   curve_error(ellipse, curve)                                 … and how wrong it is
///   Table::build(law, 1e-6)                                     … or the exact one as a table, and its files (table_file.hpp)
///   FloatTable::build(law, 1e-6)                                … in single precision, for many contacts at once
///   p_curve(curve, RadiusLaw::hertz(0.008, 2e5), mu, load, 64)  limit curves in newtons
///   Patch::rectangle(0.02, 0.01).wrench({vx, vy, omega})      a contact that is not round

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
#include "limitcurve/wrench.hpp"
