// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

/// Where methods break, the usual ones and ours. Each entry of docs/stability.md has a function
/// for each hazard, and figures; studies/failures/measure --check measures them anew and compares.
/// The measuring files contain the usual methods in their common form; truth.hpp has the true values.
namespace limitcurve::stability {

/// A point of a figure: series `series` in panel `panel`.
struct Row {
  std::string panel;
  std::string series;
  double x;
  double value;
};

/// A figure's rows: NAME.csv, drawn as docs/stability/NAME.svg by studies/failures/figures.py.
struct Figure {
  std::string name;
  std::vector<Row> rows;

  void add(std::string panel, std::string series, double x, double value) {
    rows.push_back({std::move(panel), std::move(series), x, value});
  }
};

/// A line of the table at the top of docs/stability.md: the effect of a hazard on a usual method and on ours, the same
/// quantity measured in the same way.
struct Finding {
  std::string hazard;
  std::string method;    ///< the usual one
  std::string quantity;  ///< the measured quantity, with its unit
  double breaks;         ///< its value for the usual method; inf, nan: it returned this, or threw
  double stands;         ///< its value for ours
};

/// The measurements of one hazard.
struct Hazard {
  std::vector<Finding> findings;
  std::vector<Figure> figures;

  void add(std::string hazard, std::string method, std::string quantity, double breaks, double stands) {
    findings.push_back({std::move(hazard), std::move(method), std::move(quantity), breaks, stands});
  }
  Figure& draw(std::string name) { return figures.emplace_back(Figure{std::move(name), {}}); }
};

/// An entry of the document, under the heading `name`. Measuring a hazard takes at most some seconds.
struct Entry {
  std::string name;
  std::vector<Hazard (*)()> hazards;
};

// Entry "quadrature": eq. (17), by quadrature and by closed forms.

/// The slope of the integrand is infinite where ρ = s, when the centre of rotation lies under the finger.
Hazard centre_under_the_finger();
/// A pressure that is infinite at the rim, (1−ρ²)ⁿ with n < 0.
Hazard singular_rim();
/// Kinks of measured profiles.
Hazard kinks_of_a_profile();
/// Far from the contact the moment is the remainder of terms that grow like s³ or s⁴ and cancel.
Hazard moment_far_away();
/// Near the centre (1+s²)E − (1−s²)K, two numbers near π/2, must give 3πs²/4.
Hazard force_near_the_centre();

// Entry "tables": limit curves as lookup tables.

/// Evenly spaced nodes across the rim, where the derivatives of a limit curve are singular.
Hazard even_spacing();
/// Centres of rotation beyond the last node.
Hazard beyond_the_last_node();
/// An interpolant that is not convex: a driven finger has more than one equilibrium.
Hazard false_equilibria();

// Entry "fits": curves with few parameters, fitted to the exact one and to measurements.

/// The centre of rotation that an approximation implies, towards the axes.
Hazard cor_near_the_axes();
/// The shape of the pressure and the radius of the contact, which measured slips hardly distinguish.
Hazard shape_and_radius();

// Entry "projection": how a step finds the friction wrench.

/// Springs of twist and sliding whose ratio differs by up to a million, under a steady twist.
Hazard stiffness_ratios();
/// Newton's method for the closest point without a bracket, over stiffness ratios and distances of the trial.
Hazard newton_without_bracket();
/// Limits of force and moment applied one after the other.
Hazard order_of_limits();

// Entry "time": springs, dampers and bodies in steps of time.

/// The stiffest springs with which an integrator is stable on a light body.
Hazard light_body();
/// Forces that reach the device one or two samples late.
Hazard delayed_forces();
/// Positions in steps of an encoder, and velocities from their differences.
Hazard encoder_steps();

// Entry "geometry": angles, which a device reports on a circle, and surfaces with an unexpected nearest point or
// normal.

/// The device's angle jumps from π to −π.
Hazard half_a_turn();
/// A finger pressed deeper than half a plate.
Hazard thin_plate();
/// Friction carried over an edge.
Hazard normals_that_jump();

// Entry "reality": real devices.

/// Rates from 100 Hz to 10 kHz, with jitter.
Hazard rates_and_jitter();
/// A load that drops in one step while the finger rests.
Hazard collapsing_load();

}  // namespace limitcurve::stability
