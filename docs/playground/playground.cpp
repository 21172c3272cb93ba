// SPDX-License-Identifier: MIT
// The functions that the page calls: the library's finger on a plate and its block between two fingers, for
// WebAssembly. One scene of each, in static storage; numbers only. scripts/maintain/playground compiles it with the
// library's sources.

#include "godobject/scene/gripped_block.hpp"
#include "limitcurve/approximations.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

/// Exports a function of that name to the page.
#define PLAYGROUND_EXPORT(name) extern "C" [[clang::export_name(#name)]]

// The module has no exceptions: a parameter that the library refuses stops it.
extern "C" [[noreturn]] void* __cxa_allocate_exception(std::size_t /*size*/) {
  __builtin_trap();
}
extern "C" [[noreturn]] void __cxa_throw(void* /*exception*/, void* /*type*/, void* /*destroy*/) {
  __builtin_trap();
}

namespace limitcurve::godobject {

namespace {

constexpr int most_cells = 128;
std::array<std::array<double, 8>, most_cells> rows;
using View = TableView<double>;
alignas(16) std::array<double, 2 * View::pairs_per_cell(View::most_degree) * most_cells> cells;
// One bucket for each side, with its last cell; the table's own search finds the others.
std::array<std::uint16_t, 2> last_cells;

std::vector<FingerCurve> curves;  // of the law; the ellipse and the box through its intercepts
SoftFinger finger(Ellipse::through_intercepts(1.0), {});
std::optional<GrippedBlock> block;
std::array<double, 21> values;

void write_finger(const SoftFinger& of) noexcept {
  const FingerState& state = of.state();
  const FingerOutput& output = state.output;
  values = {static_cast<double>(output.state),
            output.proxy.x(),
            output.proxy.y(),
            output.angle,
            output.depth,
            output.load,
            output.force.x(),
            output.force.y(),
            output.moment,
            output.cor,
            state.trial_force,
            state.trial_moment,
            of.parameters().mu * state.limit_load,
            of.parameters().radius_law.radius(state.limit_load),
            state.sample.goal.x(),
            state.sample.goal.y(),
            state.sample.angle};
}

}  // namespace

/// Input for the rows of a table: origin and c₀ … c₆ of each cell, those inside the rim first.
PLAYGROUND_EXPORT(cell_numbers) double* cell_numbers() {
  return rows.front().data();
}

/// Output of the functions below.
PLAYGROUND_EXPORT(results) double* results() {
  return values.data();
}

/// Sets the curves of a law. Call it after writing the rows.
PLAYGROUND_EXPORT(use_table) void use_table(int inside, int outside) {
  constexpr int degree = View::most_degree;
  constexpr int pairs = View::pairs_per_cell(degree);
  for (int i = 0; i < inside + outside; ++i) {
    const auto [x, c0, c1, c2, c3, c4, c5, c6] = rows[static_cast<std::size_t>(i)];
    View::write_cell(i >= inside, x, {c0, c1, c2, c3, c4, c5, c6}, degree, cells.data() + 2 * pairs * i);
  }
  last_cells = {static_cast<std::uint16_t>(pairs * (inside - 1)),
                static_cast<std::uint16_t>(pairs * (inside + outside - 1))};
  CurveView<double> view;
  view.table = {.cells = cells.data(),
                .cell_of_bucket = last_cells.data(),
                .dropped_bits = 63,
                .runs = {0, 1},
                .first_cells = {0, pairs * inside},
                .halvings = std::bit_width(static_cast<unsigned>(most_cells))};
  view.set_scale(view.jet(true, 0.0).trailing, view.jet(false, 0.0).trailing, view.jet(false, 1.0).leading,
                 view.jet(false, 1.0).trailing);
  const FingerCurve curve(view, nullptr);
  curves = {curve, Ellipse::through_intercepts(curve.moment_ratio()), box(1.0, curve.moment_ratio())};
}

/// Unit wrench of a slip |v| : a|ω| on a curve: 0 the law's, 1 the ellipse, 2 the box.
PLAYGROUND_EXPORT(unit_wrench) void unit_wrench(int curve, double slide, double spin) {
  const UnitWrench wrench = curves[static_cast<std::size_t>(curve)].wrench({slide, spin});
  values[0] = wrench.force;
  values[1] = wrench.moment;
}

/// Gives the fingers another curve and other parameters; their motion continues. a(P) = coefficient·P^exponent;
/// `projection` is a `Projection`.
PLAYGROUND_EXPORT(set_finger)
void set_finger(int curve, double mu, double coefficient, double exponent, double stiffness, double twist_stiffness,
                double damping, double twist_damping, int projection) {
  const FingerState state = finger.state();
  finger = SoftFinger(curves[static_cast<std::size_t>(curve)],
                      {.mu = mu,
                       .radius_law = RadiusLaw::power(coefficient, exponent),
                       .stiffness = stiffness,
                       .twist_stiffness = twist_stiffness,
                       .damping = damping,
                       .twist_damping = twist_damping},
                      static_cast<Projection>(projection));
  finger.restore(state);
  if (block) block->change_fingers(finger);
}

/// A finger before any contact.
PLAYGROUND_EXPORT(new_finger) void new_finger() {
  finger.reset();
}

PLAYGROUND_EXPORT(step_finger) void step_finger(double x, double y, double twist, double depth, double time_step) {
  static const AnySurface plane{PlaneSurface{}};
  finger.update(plane, {.position = {x, y, -depth}, .twist = twist}, time_step);
  write_finger(finger);
}

/// The block of §6, level and at rest.
PLAYGROUND_EXPORT(take_block) void take_block(double load) {
  block.emplace(PivotOptions{}, finger);
  block->take(load);
  write_finger(block->grasp().finger(0));
}

/// Writes the finger, then x, y and angle of the block and the speed of its turn.
PLAYGROUND_EXPORT(step_block) void step_block(double load, double time_step) {
  block->step(load, time_step);
  write_finger(block->grasp().finger(0));
  const BodyState& body = block->grasp().body();
  values[17] = body.position.x();
  values[18] = body.position.y();
  values[19] = block->angle();
  values[20] = body.angular_velocity.z();
}

}  // namespace limitcurve::godobject
