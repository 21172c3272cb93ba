// SPDX-License-Identifier: MIT
// The functions that the page calls: a finger on a plate and a block between two fingers, for WebAssembly. One scene of each, in static
// storage; numbers only. scripts/maintain/playground compiles it.

#include "docs/playground/block.hpp"
#include "limitcurve/curve_view.hpp"

#include <array>
#include <cstdint>

/// Exports a function of that name to the page.
#define PLAYGROUND_EXPORT(name) extern "C" [[clang::export_name(#name)]]

namespace limitcurve {

// The page needs only power laws as radius laws, without the checks and messages of the library's source.
RadiusLaw RadiusLaw::power(double coefficient, double exponent) {
  return {coefficient, exponent};
}
double RadiusLaw::exponent(double /*load*/) const noexcept {
  return exponent_;
}
double RadiusLaw::sampled_radius(double /*load*/) const noexcept {
  return coefficient_;
}

}  // namespace limitcurve

namespace limitcurve::playground {

namespace {

constexpr int most_cells = 128;
std::array<double, TablePieces<double>::numbers_per_cell * most_cells> cells;
// One bucket for each side, with its last cell; the table's own search finds the others.
std::array<std::uint16_t, 4> last_cells;

CurveView<double> exact_curve;  // of the law
CurveView<double> curve;        // that the fingers use
FingerSettings settings{.radius_law = RadiusLaw::power(0.006, 0.0)};
Finger finger;
Block block;
std::array<double, 32> numbers;

/// The wrench of a slip (slide, spin ≥ 0, not both 0); on the box's corner both limits.
void write_wrench(const CurveView<double>& of, double slide, double spin) noexcept {
  if (of.is_box) {
    numbers[0] = slide > 0.0 ? of.force_max : 0.0;
    numbers[1] = spin > 0.0 ? of.moment_max : 0.0;
    return;
  }
  const bool outside = slide > spin;
  const double x = outside ? spin / slide : slide / spin;
  const Jet<double> jet = of.jet(outside, x);
  numbers[0] = outside ? jet.trailing(x) : jet.leading();
  numbers[1] = outside ? jet.leading() : jet.trailing(x);
}

void write_finger(const Finger& of) noexcept {
  numbers = {static_cast<double>(of.state),
             of.proxy_x,
             of.proxy_y,
             of.angle,
             of.depth,
             of.load,
             of.force_x,
             of.force_y,
             of.moment,
             of.cor,
             of.trial_force,
             of.trial_moment,
             of.limit_force,
             of.radius,
             of.x,
             of.y,
             of.goal_angle};
}

}  // namespace

/// Input for the rows of a table: origin and c₀ … c₆ of each cell, those inside the rim first.
PLAYGROUND_EXPORT(cell_numbers) double* cell_numbers() {
  return cells.data();
}

/// Output of the functions below.
PLAYGROUND_EXPORT(results) double* results() {
  return numbers.data();
}

/// Call it after writing the rows: sets the curve of the law and the curve in use.
PLAYGROUND_EXPORT(use_table) void use_table(int inside, int outside) {
  last_cells = {static_cast<std::uint16_t>(inside - 1), static_cast<std::uint16_t>(inside - 1),
                static_cast<std::uint16_t>(inside + outside - 1), static_cast<std::uint16_t>(inside + outside - 1)};
  exact_curve = {};
  exact_curve.table = {.cells = cells.data(), .cell_of_bucket = last_cells.data(), .dropped_bits = 63, .buckets = 1, .searches = true};
  const Jet<double> rim = exact_curve.jet(false, 1.0);
  exact_curve.set_scale(exact_curve.jet(true, 0.0).value, exact_curve.jet(false, 0.0).value, rim.leading(), rim.trailing(1.0));
  curve = exact_curve;
}

/// Uses the ellipse through the intercepts in place of the table.
PLAYGROUND_EXPORT(use_ellipse) void use_ellipse() {
  const double force = exact_curve.force_max;
  const double moment = exact_curve.moment_max;
  const double diagonal = std::sqrt(force * force + moment * moment);
  curve = {};
  curve.set_scale(force, moment, force * force / diagonal, moment * moment / diagonal);
}

/// Uses the box in place of the table: separate limits of force and moment (§3.1).
PLAYGROUND_EXPORT(use_box) void use_box() {
  const double force = exact_curve.force_max;
  const double moment = exact_curve.moment_max;
  curve = {};
  curve.is_box = true;
  curve.set_scale(force, moment, force, moment);
}

/// Unit wrench of a slip |v| : a|ω|; of the law if `exact`, otherwise of the curve in use.
PLAYGROUND_EXPORT(unit_wrench) void unit_wrench(int exact, double slide, double spin) {
  write_wrench(exact != 0 ? exact_curve : curve, slide, spin);
}

/// a(P) = coefficient·P^exponent; projections with the values of `Projection`.
PLAYGROUND_EXPORT(set_finger)
void set_finger(double mu, double coefficient, double exponent, double stiffness, double twist_stiffness, double damping,
                double twist_damping, int projection) {
  settings = {mu,
              RadiusLaw::power(coefficient, exponent),
              stiffness,
              twist_stiffness,
              damping,
              twist_damping,
              static_cast<godobject::Projection>(projection)};
}

/// A finger before any contact.
PLAYGROUND_EXPORT(new_finger) void new_finger() {
  finger = {};
}

PLAYGROUND_EXPORT(step_finger) void step_finger(double x, double y, double twist, double depth, double time_step) {
  finger.update(curve, settings, {x, y, twist, depth}, time_step);
  write_finger(finger);
}

PLAYGROUND_EXPORT(take_block) void take_block(double load) {
  block.take(curve, settings, load);
  write_finger(block.finger);
}

/// Writes the finger, and from 20 on x, y and angle of the block and its velocities.
PLAYGROUND_EXPORT(step_block) void step_block(double load, double time_step) {
  block.step(curve, settings, load, time_step);
  write_finger(block.finger);
  const std::array<double, 6> motion{block.x, block.y, block.angle, block.velocity_x, block.velocity_y, block.spin};
  for (std::size_t i = 0; i < motion.size(); ++i) numbers[20 + i] = motion[i];
}

}  // namespace limitcurve::playground
