// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"
#include "godobject/internal/clones.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace limitcurve::godobject::detail {

namespace {

/// A number for each contact of a block, aligned for the widest vectors.
struct alignas(64) Row {
  std::array<double, table_block> values;
  double* data() noexcept { return values.data(); }
  double& operator[](std::size_t i) noexcept { return values[i]; }
};

/// A pair of numbers for each contact, one pair after another, as they come from memory.
struct alignas(64) PairRow {
  std::array<double, 2 * table_block> values;
  const double* data() const noexcept { return values.data(); }
  void put(std::size_t i, Pair pair) noexcept { std::memcpy(values.data() + 2 * i, &pair, sizeof pair); }
};

/// What becomes of a contact. As a double, because selections between rows of one width are vectorised.
constexpr double sticks = 0.0;
constexpr double searches = 1.0;
constexpr double slides = 2.0;
constexpr double left_over = 3.0;

// The loops below repeat Friction::grip, ClosestPoint, TableSide::closest and step_one operation by operation, in the
// same order, so that the bits are the same. Restrict counts on parameters only.

/// Friction::grip as far as the trial, for contacts that touch and touched before. Not 0 if any is to be searched for.
LIMITCURVE_CLONES
int make_trials(const TableStep& law, std::size_t count, const double* __restrict x, const double* __restrict y,
                const double* __restrict angle, const double* __restrict depth, const double* __restrict proxy_x,
                const double* __restrict proxy_y, const double* __restrict proxy_angle, const double* __restrict start,
                const double* __restrict trend, double* __restrict r, double* __restrict trial_force, double* __restrict trial_moment,
                double* __restrict place, double* __restrict fate) noexcept {
  constexpr double farthest = 1e90;  // far within farthest_trial
  int any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double pull_x = proxy_x[i] - x[i];
    const double pull_y = proxy_y[i] - y[i];
    const double turn = std::fabs(proxy_angle[i] - angle[i]);
    r[i] = std::sqrt(pull_x * pull_x + pull_y * pull_y);
    const double load = law.stiffness * depth[i];
    const double force_unit = law.mu * load;
    const double moment_unit = force_unit * law.radius;
    const double per_length = law.stiffness * (1.0 / force_unit);
    const double per_angle = law.twist_stiffness * (1.0 / moment_unit);
    const double force = r[i] * per_length;
    const double moment = turn * per_angle;
    const bool within = r[i] * (per_length * law.per_force_max) + turn * (per_angle * law.per_moment_max) <= 1.0;
    trial_force[i] = force;
    trial_moment[i] = moment;
    const double trust = 0.1 * (start[i] < 2.0 - start[i] ? start[i] : 2.0 - start[i]);
    place[i] = std::fabs(trend[i]) <= trust ? start[i] + trend[i] : start[i];
    // Non-short-circuit, to be vectorised. Free contacts, new ones, those without torsional friction and trials on an axis
    // or beyond farthest_trial are left.
    const bool usual = (depth[i] > 0.0) & (start[i] >= -1.0) & (load > law.least_load);
    const bool searched = (force > 0.0) & (moment > 0.0) & (force <= farthest) & (moment <= farthest) & (place[i] > 0.0) & (place[i] < 2.0);
    fate[i] = usual ? (within ? sticks : (searched ? searches : left_over)) : left_over;
    any |= static_cast<int>(fate[i] == searches);
  }
  return any;
}

/// The beginning of Table::closest: on the side of the place. What is not searched for begins at the rim, where any search can.
LIMITCURVE_CLONES
void begin_searches(double chi, double per_chi, std::size_t count, const double* __restrict trial_force,
                    const double* __restrict trial_moment, const double* __restrict place, const double* __restrict fate,
                    double* __restrict side, double* __restrict x, double* __restrict kappa, double* __restrict primary,
                    double* __restrict secondary) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const double force = trial_force[i];
    const double moment = trial_moment[i];
    const double from = fate[i] == searches ? place[i] : 1.0;
    const bool outside = from > 1.0;
    const double from_slide = 2.0 - from;
    side[i] = outside ? 1.0 : 0.0;
    x[i] = outside ? from_slide : from;
    kappa[i] = outside ? per_chi : chi;
    primary[i] = outside ? moment : force;
    secondary[i] = outside ? force : moment;
  }
}

/// A search in a table for a contact, with the cell that it is in. A side is 0 inside the rim, 1 outside.
struct Searches {
  Row side, x, kappa, trial_primary, trial_secondary;
  PairRow left_and_rise, constant, square, cube;
  Row right;
  Row next, primary, secondary, done;
};

/// TableSide::closest's residual and step, and the cell's values where the step leads.
LIMITCURVE_CLONES
void advance_searches(std::size_t count, double share_of_x, double least_steep, double steepest, const double* __restrict x_of,
                      const double* __restrict kappa_of, const double* __restrict trial_primary, const double* __restrict trial_secondary,
                      const double* __restrict left_and_rise, const double* __restrict constant, const double* __restrict square_of,
                      const double* __restrict cube, const double* __restrict right, double* __restrict next_of, double* __restrict primary,
                      double* __restrict secondary, double* __restrict done) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = x_of[i];
    const double kappa = kappa_of[i];
    const double left = left_and_rise[2 * i];
    const double rise = left_and_rise[2 * i + 1];
    const double constant_0 = constant[2 * i];
    const double constant_1 = constant[2 * i + 1];
    const double square_0 = square_of[2 * i];
    const double square_1 = square_of[2 * i + 1];
    const double cube_0 = cube[2 * i];
    const double cube_1 = cube[2 * i + 1];
    const double rise_secondary = -left * rise;
    const double from_left = x - left;
    // TableSide::Cell::jet.
    const double cubed_0 = from_left * cube_0;
    const double cubed_1 = from_left * cube_1;
    const double bent_0 = square_0 + cubed_0;
    const double bent_1 = square_1 + cubed_1;
    const double rest_0 = bent_0 + (cubed_0 + cubed_0);
    const double rest_1 = bent_1 + (cubed_1 + cubed_1);
    const double value_0 = (constant_0 + from_left * rise) + (from_left * from_left) * bent_0;
    const double value_1 = (constant_1 + from_left * rise_secondary) + (from_left * from_left) * bent_1;
    const double slope_0 = rise + from_left * (square_0 + rest_0);
    const double slope_1 = rise_secondary + from_left * (square_1 + rest_1);
    const double over_0 = trial_primary[i] - value_0;
    const double over_1 = trial_secondary[i] - value_1;
    const double lever = x * kappa;
    const double value = over_0 - lever * over_1;
    const double fall = (slope_0 - lever * slope_1) + kappa * over_1;
    const double square = (rest_0 - lever * rest_1) - kappa * slope_1;
    const double cubic = (cube_0 - lever * cube_1) - kappa * rest_1;
    // TableSide::step_from.
    const double fall_square = fall * fall;
    const double shift = (value * fall) / (fall_square + value * square);
    const double curved = square * square + fall * std::fabs(cubic);
    const double rest = (shift * shift) * std::fabs(shift) * curved;
    const double next = x + shift;
    const bool last = (rest <= (share_of_x * x) * fall_square) & (fall >= least_steep) & (fall < steepest);
    const bool inside = (next >= left) & (next < right[i]);
    next_of[i] = next;
    // TableSide::Cell::Jet::after.
    primary[i] = (value_0 + shift * slope_0) + (shift * shift) * (rest_0 + shift * cube_0);
    secondary[i] = (value_1 + shift * slope_1) + (shift * shift) * (rest_1 + shift * cube_1);
    done[i] = (last & inside) ? 1.0 : 0.0;
  }
}

/// The point of the boundary that is closest to each contact's trial, with its normal, and its place. The normal is not told from the
/// place: 2 − (2 − x) is not always x, and a rounding decides whether a contact at rest is within the limit.
struct Feet {
  Row force, moment, slide, spin, place;
};

/// What the searches that are done have found. Not 0 if any is not done.
LIMITCURVE_CLONES
int take_found(std::size_t count, const double* __restrict side, const double* __restrict next, const double* __restrict primary,
               const double* __restrict secondary, const double* __restrict done, double* __restrict wrench_force,
               double* __restrict wrench_moment, double* __restrict slide, double* __restrict spin, double* __restrict place,
               double* __restrict fate) noexcept {
  int any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool outside = side[i] != 0.0;
    const double first = primary[i];
    const double second = secondary[i];
    const double there = next[i];
    const double from_slide = 2.0 - there;
    const double what = fate[i];
    wrench_force[i] = outside ? second : first;
    wrench_moment[i] = outside ? first : second;
    slide[i] = outside ? 1.0 : there;
    spin[i] = outside ? there : 1.0;
    place[i] = outside ? from_slide : there;
    fate[i] = ((what == searches) & (done[i] != 0.0)) ? slides : what;
    any |= static_cast<int>(fate[i] == searches);
  }
  return any;
}

/// Friction::let_slip and what step_one does with it. Not 0 if any contact is left.
LIMITCURVE_CLONES
int finish(const TableStep& law, std::size_t count, const double* __restrict x, const double* __restrict y, const double* __restrict angle,
           const double* __restrict depth, double* __restrict proxy_x, double* __restrict proxy_y, double* __restrict proxy_angle,
           double* __restrict start, double* __restrict trend, double* __restrict force_x, double* __restrict force_y,
           double* __restrict moment_of, const double* __restrict r_of, const double* __restrict trial_force,
           const double* __restrict trial_moment, const double* __restrict wrench_force, const double* __restrict wrench_moment,
           const double* __restrict slide, const double* __restrict spin, const double* __restrict place,
           const double* __restrict fate) noexcept {
  // All is read first: what is read under a condition is not vectorised.
  const double stiffness = law.stiffness;
  const double twist_stiffness = law.twist_stiffness;
  int any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double old_force_x = force_x[i];
    const double old_force_y = force_y[i];
    const double old_moment = moment_of[i];
    const double old_x = proxy_x[i];
    const double old_y = proxy_y[i];
    const double old_angle = proxy_angle[i];
    const double old_start = start[i];
    const double old_trend = trend[i];
    const double pull_x = old_x - x[i];
    const double pull_y = old_y - y[i];
    const double turn = old_angle - angle[i];
    const double force_unit = law.mu * (stiffness * depth[i]);
    const double moment_unit = force_unit * law.radius;
    const double t = place[i];
    const double foot_force = wrench_force[i];
    const double foot_moment = wrench_moment[i];
    const double aim_force = trial_force[i];
    const double aim_moment = trial_moment[i];
    const double what = fate[i];
    // The tangent at the foot: what is not beyond it sticks.
    const double reach = slide[i] * foot_force + spin[i] * foot_moment;
    const double height = slide[i] * aim_force + spin[i] * aim_moment;
    const bool outside = (what == slides) & (height > reach);
    const bool slipping = (what == slides) & (height > reach * (1.0 + slip_guard));
    const double cut = foot_force * (force_unit / r_of[i] * law.compliance);
    const double twist_cut = foot_moment * (moment_unit / std::fabs(turn) * law.twist_compliance);
    const double least = cut < 1.0 ? cut : 1.0;
    const double twist_least = twist_cut < 1.0 ? twist_cut : 1.0;
    const double kept = least > 0.0 ? least : 0.0;
    const double twist_kept = twist_least > 0.0 ? twist_least : 0.0;
    const double share = outside ? kept : 1.0;
    const double twist_share = outside ? twist_kept : 1.0;
    const double felt_x = pull_x * share;
    const double felt_y = pull_y * share;
    const double felt_turn = turn * twist_share;
    const double slid_x = x[i] + felt_x;
    const double slid_y = y[i] + felt_y;
    const double slid_angle = angle[i] + felt_turn;
    const double new_x = slipping ? slid_x : old_x;
    const double new_y = slipping ? slid_y : old_y;
    const double new_angle = slipping ? slid_angle : old_angle;
    const bool moves = (new_x != old_x) | (new_y != old_y) | (new_angle != old_angle);
    const double next = moves ? t : -1.0;
    const bool left = what == left_over;
    const double change = t - old_start;
    const double new_trend = moves ? change : 0.0;
    const double new_start = slipping ? next : -1.0;
    const double new_force_x = felt_x * stiffness;
    const double new_force_y = felt_y * stiffness;
    const double new_moment = felt_turn * twist_stiffness;
    force_x[i] = left ? old_force_x : new_force_x;
    force_y[i] = left ? old_force_y : new_force_y;
    moment_of[i] = left ? old_moment : new_moment;
    proxy_x[i] = left ? old_x : new_x;
    proxy_y[i] = left ? old_y : new_y;
    proxy_angle[i] = left ? old_angle : new_angle;
    trend[i] = (slipping & !left) ? new_trend : old_trend;
    start[i] = left ? old_start : new_start;
    any |= static_cast<int>(left);
  }
  return any;
}

/// One step of the first `count` searches.
void step_searches(const Table& table, Searches& search, std::size_t count) noexcept {
  for (std::size_t j = 0; j < count; ++j) {
    const TableSide& side = search.side[j] != 0.0 ? table.outside() : table.inside();
    const TableSide::Cell* cell = &side.cell(search.x[j]);
    search.left_and_rise.put(j, Pair{cell->left, cell->rise});
    search.constant.put(j, cell->constant);
    search.square.put(j, cell->square);
    search.cube.put(j, cell->cube);
    search.right[j] = (cell + 1)->left;
  }
  advance_searches(count, TableSide::closest_share, TableSide::least_steep, TableSide::steepest, search.x.data(), search.kappa.data(),
                   search.trial_primary.data(), search.trial_secondary.data(), search.left_and_rise.data(), search.constant.data(),
                   search.square.data(), search.cube.data(), search.right.data(), search.next.data(), search.primary.data(),
                   search.secondary.data(), search.done.data());
}

/// The next steps, of the searches that are not done, closed up. What wants a bracket is left over.
void search_on(const Table& table, const TableStep& law, Row& trial_force, Row& trial_moment, Searches& search, std::size_t count,
               Feet& feet, Row& fate) noexcept {
  std::array<std::size_t, table_block> contact;
  std::size_t open = 0;
  const auto keep = [&](std::size_t j, std::size_t i) {
    if (!(search.next[j] >= 0.0 && search.next[j] <= 1.0)) {
      fate[i] = left_over;
      return;
    }
    contact[open] = i;
    search.side[open] = search.side[j];
    search.x[open] = search.next[j];
    search.kappa[open] = search.kappa[j];
    search.trial_primary[open] = search.trial_primary[j];
    search.trial_secondary[open] = search.trial_secondary[j];
    ++open;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (fate[i] != searches) continue;
    // From here on on the trial's side, as Table::search_closest: from the rim, where it began on the other.
    const bool outside = trial_force[i] - law.rim.force > law.compliance_ratio * (trial_moment[i] - law.rim.moment);
    if (outside != (search.side[i] != 0.0)) {
      search.side[i] = outside ? 1.0 : 0.0;
      search.next[i] = 1.0;
      search.kappa[i] = outside ? law.per_compliance_ratio : law.compliance_ratio;
      std::swap(search.trial_primary[i], search.trial_secondary[i]);
    }
    keep(i, i);
  }
  for (int round = 1; round < TableSide::quick_limit && open > 0; ++round) {
    const std::size_t stepped = std::exchange(open, 0);
    step_searches(table, search, stepped);
    for (std::size_t j = 0; j < stepped; ++j) {
      const std::size_t i = contact[j];
      if (search.done[j] == 0.0) {
        keep(j, i);
        continue;
      }
      const bool outside = search.side[j] != 0.0;
      feet.force[i] = outside ? search.secondary[j] : search.primary[j];
      feet.moment[i] = outside ? search.primary[j] : search.secondary[j];
      feet.slide[i] = outside ? 1.0 : search.next[j];
      feet.spin[i] = outside ? search.next[j] : 1.0;
      feet.place[i] = outside ? 2.0 - search.next[j] : search.next[j];
      fate[i] = slides;
    }
  }
  for (std::size_t j = 0; j < open; ++j) fate[contact[j]] = left_over;
}

}  // namespace

bool step_on_table(const Table& table, const TableStep& law, const ContactBatch& block, std::array<bool, table_block>& left) noexcept {
  const std::size_t count = block.size();
  Row r, trial_force, trial_moment, fate;
  Feet feet;
  if (make_trials(law, count, block.x.data(), block.y.data(), block.angle.data(), block.depth.data(), block.proxy_x.data(),
                  block.proxy_y.data(), block.proxy_angle.data(), block.start.data(), block.trend.data(), r.data(), trial_force.data(),
                  trial_moment.data(), feet.place.data(), fate.data()) != 0) {
    Searches search;
    begin_searches(law.compliance_ratio, law.per_compliance_ratio, count, trial_force.data(), trial_moment.data(), feet.place.data(),
                   fate.data(), search.side.data(), search.x.data(), search.kappa.data(), search.trial_primary.data(),
                   search.trial_secondary.data());
    // The first step of all, searched for or not: in a scene that moves nearly all are, and most need no other.
    step_searches(table, search, count);
    if (take_found(count, search.side.data(), search.next.data(), search.primary.data(), search.secondary.data(), search.done.data(),
                   feet.force.data(), feet.moment.data(), feet.slide.data(), feet.spin.data(), feet.place.data(), fate.data()) != 0) {
      search_on(table, law, trial_force, trial_moment, search, count, feet, fate);
    }
  } else {
    feet = {r, r, r, r, r};
  }
  const bool any_left =
      finish(law, count, block.x.data(), block.y.data(), block.angle.data(), block.depth.data(), block.proxy_x.data(), block.proxy_y.data(),
             block.proxy_angle.data(), block.start.data(), block.trend.data(), block.force_x.data(), block.force_y.data(),
             block.moment.data(), r.data(), trial_force.data(), trial_moment.data(), feet.force.data(), feet.moment.data(),
             feet.slide.data(), feet.spin.data(), feet.place.data(), fate.data()) != 0;
  if (any_left)
    std::transform(fate.values.begin(), fate.values.begin() + count, left.begin(), [](double what) { return what == left_over; });
  return any_left;
}

}  // namespace limitcurve::godobject::detail
