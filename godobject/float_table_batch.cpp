// SPDX-License-Identifier: MIT
#include "godobject/internal/float_loops.hpp"
#include "godobject/internal/float_search.hpp"

#include <array>

namespace limitcurve::godobject::detail {

namespace {

// All lengths: r, ρ·arm and the limit μd, so that no stiffness enters a comparison and nothing leaves the range of floats.

/// The loops take so many contacts at a time, and hold in rows what one hands to the next: within one loop the compiler would split
/// contacts by what is known of them, and take no vectors.
constexpr std::size_t block_size = 128;

struct alignas(64) Row {
  std::array<float, block_size> values;
  float* data() noexcept { return values.data(); }
  float& operator[](std::size_t i) noexcept { return values[i]; }
  float operator[](std::size_t i) const noexcept { return values[i]; }
};

/// Instead of a limit: no contact.
constexpr float no_contact = -1.0F;

/// Where the proxies of a block are before the step, and how far they may be from the finger [m].
struct Before {
  Row x, y, angle, limit;
};

LIMITCURVE_CLONES
void recall(float mu, std::size_t count, const float* __restrict x, const float* __restrict y, const float* __restrict angle,
            const float* __restrict depth, const float* __restrict proxy_x, const float* __restrict proxy_y,
            const float* __restrict proxy_angle, const float* __restrict start, float* __restrict old_x, float* __restrict old_y,
            float* __restrict old_angle, float* __restrict limit) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const float d = depth[i];
    const bool touches = d > 0.0F;
    const bool held = touches & (start[i] >= -1.0F);  // not free now, nor before
    const float px = proxy_x[i];
    const float py = proxy_y[i];
    const float pa = proxy_angle[i];
    old_x[i] = held ? px : x[i];
    old_y[i] = held ? py : y[i];
    old_angle[i] = held ? pa : angle[i];
    limit[i] = touches ? mu * d : no_contact;
  }
}

/// The forces, by the shares to which pull and turn shrink, and where the proxies come to lie, by theirs, which are 1 where the trial
/// is not beyond the limit by more than is rounded. `place` is where a slip's next search may start.
LIMITCURVE_CLONES
void move_proxies(float stiffness, float twist_stiffness, std::size_t count, const float* __restrict x, const float* __restrict y,
                  const float* __restrict angle, float* __restrict proxy_x, float* __restrict proxy_y, float* __restrict proxy_angle,
                  float* __restrict start, float* __restrict trend, float* __restrict force_x, float* __restrict force_y,
                  float* __restrict moment, const float* __restrict old_x_of, const float* __restrict old_y_of,
                  const float* __restrict old_angle_of, const float* __restrict limit, const float* __restrict share_of,
                  const float* __restrict twist_share_of, const float* __restrict proxy_share_of,
                  const float* __restrict proxy_twist_share_of, const float* __restrict place_of) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const float s = start[i];
    const float old_x = old_x_of[i];
    const float old_y = old_y_of[i];
    const float old_angle = old_angle_of[i];
    const float share = share_of[i];
    const float twist_share = twist_share_of[i];
    const float proxy_share = proxy_share_of[i];
    const float proxy_twist_share = proxy_twist_share_of[i];
    const float place = place_of[i];
    const float pull_x = old_x - x[i];
    const float pull_y = old_y - y[i];
    const float turn = old_angle - angle[i];
    // What is not clamped does not move, bit for bit.
    const float slid_x = shrunk(old_x, x[i], pull_x, proxy_share);
    const float slid_y = shrunk(old_y, y[i], pull_y, proxy_share);
    const float turned = shrunk(old_angle, angle[i], turn, proxy_twist_share);
    const float new_x = proxy_share < 1.0F ? slid_x : old_x;
    const float new_y = proxy_share < 1.0F ? slid_y : old_y;
    const float new_angle = proxy_twist_share < 1.0F ? turned : old_angle;
    const float motion = std::fabs(new_x - old_x) + std::fabs(new_y - old_y) + std::fabs(new_angle - old_angle);
    const bool moves = motion > 0.0F;
    const float at_rest = limit[i] >= 0.0F ? -1.0F : -2.0F;
    const float next = moves ? place : at_rest;
    const float change = next - s;
    const float new_trend = (next < s ? next : s) > 0.0F ? change : 0.0F;
    force_x[i] = pull_x * (stiffness * share);
    force_y[i] = pull_y * (stiffness * share);
    moment[i] = turn * (twist_stiffness * twist_share);
    proxy_x[i] = new_x;
    proxy_y[i] = new_y;
    proxy_angle[i] = new_angle;
    start[i] = next;
    trend[i] = new_trend;
  }
}

/// The searches of a block, and what they find.
struct Searches {
  Row r, rho;                     // distances of the proxies, as lengths
  Row trial_force, trial_moment;  // in unit wrenches
  Row primary, secondary;         // of the trial, by the side of the rim on which its normal lies …
  Row outside, kappa;             // … this one, 1 or 0, and the compliance ratio there
  Row x;                          // where the search is
  Row found_primary, found_secondary;
  Row open;  // 1: it searches, 0: it has found, or need not
  Row share, twist_share, proxy_share, proxy_twist_share, place;
};

LIMITCURVE_CLONES
void make_trials(const FloatStep& law, FloatWrench rim, std::size_t count, const float* __restrict x, const float* __restrict y,
                 const float* __restrict angle, const float* __restrict start, const float* __restrict trend, const float* __restrict old_x,
                 const float* __restrict old_y, const float* __restrict old_angle, const float* __restrict limit, float* __restrict r_of,
                 float* __restrict rho_of, float* __restrict trial_force, float* __restrict trial_moment, float* __restrict primary,
                 float* __restrict secondary, float* __restrict outside_of, float* __restrict kappa, float* __restrict at,
                 float* __restrict open) noexcept {
  // What a trial may be beyond the limit at most, in limits, and what limit is none [m]: squares stay finite.
  constexpr float per_farthest_trial = 1e-9F;
  constexpr float least_limit = 1e-20F;
  const float arm = law.arm;
  const float chi = law.compliance_ratio;
  const float per_chi = 1.0F / chi;
  const float per_force_max = law.per_force_max;
  const float per_moment_max = law.per_moment_max;
  for (std::size_t i = 0; i < count; ++i) {
    const float s = start[i];
    const float drift = trend[i];
    const float pull_x = old_x[i] - x[i];
    const float pull_y = old_y[i] - y[i];
    const float r = std::sqrt(pull_x * pull_x + pull_y * pull_y);
    const float rho = std::fabs(old_angle[i] - angle[i]) * arm;
    const float larger = (r > rho ? r : rho) * per_farthest_trial;
    const float least = larger > least_limit ? larger : least_limit;
    const float per_limit = 1.0F / (limit[i] > least ? limit[i] : least);
    const float force = r * per_limit;
    const float moment = rho * per_limit;
    const bool outside = force - rim.force > chi * (moment - rim.moment);
    const float nearer_end = s < 2.0F - s ? s : 2.0F - s;
    const float ahead = s + drift;
    const float place = std::fabs(drift) <= 0.1F * nearer_end ? ahead : s;
    const float opposite = 2.0F - place;
    const float on_side = outside ? opposite : place;
    const bool known = (place > 0.0F) & (place < 2.0F);
    const bool there = (on_side >= 0.0F) & (on_side <= 1.0F);
    const float from = there ? on_side : 1.0F;
    r_of[i] = r;
    rho_of[i] = rho;
    trial_force[i] = force;
    trial_moment[i] = moment;
    primary[i] = outside ? moment : force;
    secondary[i] = outside ? force : moment;
    outside_of[i] = outside ? 1.0F : 0.0F;
    kappa[i] = outside ? per_chi : chi;
    at[i] = known ? from : -1.0F;
    // Within the chord of the intercepts it holds, and so it does where there is no contact.
    open[i] = force * per_force_max + moment * per_moment_max > 1.0F ? 1.0F : 0.0F;
  }
}

/// Takes every open search one step on; how many are still open.
LIMITCURVE_CLONES
int advance(const float* __restrict cells, std::int32_t inside_count, std::int32_t outside_count, std::size_t count,
            const float* __restrict primary, const float* __restrict secondary, const float* __restrict outside_of,
            const float* __restrict kappa, float* __restrict at, float* __restrict found_primary, float* __restrict found_secondary,
            float* __restrict open_of) noexcept {
  const auto inside_cells = static_cast<float>(inside_count);
  const auto outside_cells = static_cast<float>(outside_count);
  int still = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool outside = outside_of[i] != 0.0F;
    const float open = open_of[i];
    const float old_primary = found_primary[i];
    const float old_secondary = found_secondary[i];
    const float x = at[i];
    const float of_side = outside ? outside_cells : inside_cells;
    const std::int32_t number = cell_number(x, of_side) + (outside ? inside_count : 0);
    const std::int32_t first = 8 * number;
    const FloatSearchStep step = step_from(x, kappa[i], primary[i], secondary[i], of_side, cells[first], cells[first + 1], cells[first + 2],
                                           cells[first + 3], cells[first + 4], cells[first + 5], cells[first + 6], cells[first + 7]);
    const float found = open * step.last;
    const float searches = open - found;
    at[i] = open > 0.0F ? step.next : x;
    found_primary[i] = found > 0.0F ? step.primary : old_primary;
    found_secondary[i] = found > 0.0F ? step.secondary : old_secondary;
    open_of[i] = searches;
    still += searches > 0.0F ? 1 : 0;
  }
  return still;
}

/// By what shares the forces shrink to what the search found, and by what the proxies' distances: not at all unless the trial is
/// beyond the tangent there by more than is rounded.
LIMITCURVE_CLONES
void shrink_to_foot(float arm, std::size_t count, const float* __restrict old_x, const float* __restrict old_y,
                    const float* __restrict old_angle, const float* __restrict limit_of, const float* __restrict r_of,
                    const float* __restrict rho_of, const float* __restrict trial_primary, const float* __restrict trial_secondary,
                    const float* __restrict outside_of, const float* __restrict at, const float* __restrict found_primary,
                    const float* __restrict found_secondary, float* __restrict share_of, float* __restrict twist_share_of,
                    float* __restrict proxy_share_of, float* __restrict proxy_twist_share_of, float* __restrict place_of) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const bool outside = outside_of[i] != 0.0F;
    const float q = at[i];
    const float primary = found_primary[i];
    const float secondary = found_secondary[i];
    const float limit = limit_of[i];
    const float r = r_of[i];
    const float rho = rho_of[i];
    const float position = std::fabs(old_x[i]) + std::fabs(old_y[i]);
    const float turned = std::fabs(old_angle[i]) * arm;
    const float opposite = 2.0F - q;
    // No search where it holds for sure: nothing found, and nothing clamped.
    const bool searched = primary + secondary > 0.0F;
    const float force_bound = limit * (outside ? secondary : primary);
    const float moment_bound = limit * (outside ? primary : secondary);
    const bool slides = searched & (force_bound < r);
    const bool turns = searched & (moment_bound < rho);
    const float share = force_bound / (slides ? r : 1.0F);
    const float twist_share = moment_bound / (turns ? rho : 1.0F);
    const float reach = q * primary + secondary;
    const float of_trial = q * trial_primary[i] + trial_secondary[i];
    const float rounding = resolution * (q * (outside ? turned : position) + (outside ? position : turned));
    const float larger = r > rho ? r : rho;
    const float trial = (r > rho) == outside ? trial_secondary[i] : trial_primary[i];
    const float per_limit = trial / (larger > 0.0F ? larger : 1.0F);
    const bool beyond = of_trial > reach * (1.0F + float_slip_guard) + rounding * per_limit;
    share_of[i] = slides ? share : 1.0F;
    twist_share_of[i] = turns ? twist_share : 1.0F;
    proxy_share_of[i] = (slides & beyond) ? share : 1.0F;
    proxy_twist_share_of[i] = (turns & beyond) ? twist_share : 1.0F;
    place_of[i] = outside ? opposite : q;
  }
}

/// Where to begin without a last slip: the normal at the closest point of the ellipse with the same intercepts, roughly (as
/// ClosestPoint::start).
float cold_start(const FloatStep& law, const Searches& all, std::size_t i) noexcept {
  const float force = all.trial_force[i] * law.per_force_max;
  const float moment = all.trial_moment[i] * law.per_moment_max;
  const float ratio = law.per_force_max / law.per_moment_max;
  const float eta = 1.0F / (law.compliance_ratio * ratio * ratio);
  const float square = force * force + moment * moment;
  const float lambda = square > 1.0F ? square * (std::sqrt(square) - 1.0F) / (force * force + eta * moment * moment) : 0.0F;
  const float slide = force * (1.0F + lambda * eta) * ratio;
  const float spin = moment * (1.0F + lambda);
  const bool outside = all.outside[i] != 0.0F;
  const float x = outside ? spin / slide : slide / spin;
  return x >= 0.0F && x <= 1.0F ? x : 1.0F;
}

void recall(const FloatStep& law, const FloatContactBatch& block, Before& before) noexcept {
  recall(law.mu, block.size(), block.x.data(), block.y.data(), block.angle.data(), block.depth.data(), block.proxy_x.data(),
         block.proxy_y.data(), block.proxy_angle.data(), block.start.data(), before.x.data(), before.y.data(), before.angle.data(),
         before.limit.data());
}

void move_proxies(const FloatStep& law, const FloatContactBatch& block, Before& before, Row& share, Row& twist_share, Row& proxy_share,
                  Row& proxy_twist_share, Row& place) noexcept {
  move_proxies(law.stiffness, law.twist_stiffness, block.size(), block.x.data(), block.y.data(), block.angle.data(), block.proxy_x.data(),
               block.proxy_y.data(), block.proxy_angle.data(), block.start.data(), block.trend.data(), block.force_x.data(),
               block.force_y.data(), block.moment.data(), before.x.data(), before.y.data(), before.angle.data(), before.limit.data(),
               share.data(), twist_share.data(), proxy_share.data(), proxy_twist_share.data(), place.data());
}

void search(const FloatStep& law, const FloatTable& table, std::size_t count, Searches& all) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    all.found_primary[i] = all.found_secondary[i] = 0.0F;
    if (all.x[i] < 0.0F) all.x[i] = all.open[i] != 0.0F ? cold_start(law, all, i) : 0.5F;
  }
  // Together as long as many search, then one by one: the same steps either way.
  constexpr int quick_limit = 6;
  int rounds = 0;
  int open = 1;
  while (rounds < quick_limit && open > 0 && (rounds == 0 || open > static_cast<int>(count / 8))) {
    open = advance(&table.inside().data()->left, static_cast<std::int32_t>(table.inside().size()),
                   static_cast<std::int32_t>(table.outside().size()), count, all.primary.data(), all.secondary.data(), all.outside.data(),
                   all.kappa.data(), all.x.data(), all.found_primary.data(), all.found_secondary.data(), all.open.data());
    ++rounds;
  }
  for (std::size_t i = 0; open > 0 && i < count; ++i) {
    if (all.open[i] == 0.0F) continue;
    const FloatSearch search(all.outside[i] != 0.0F ? table.outside() : table.inside(), all.kappa[i], all.primary[i], all.secondary[i]);
    FloatSearchStep found{all.x[i], 0.0F, 0.0F, 0.0F};
    for (int round = rounds; round < quick_limit && found.last == 0.0F; ++round) found = search.step(found.next);
    if (found.last == 0.0F) found = search.bisect();
    all.x[i] = found.next;
    all.found_primary[i] = found.primary;
    all.found_secondary[i] = found.secondary;
    --open;
  }
}

}  // namespace

void step_floats(const FloatStep& law, const FloatTable& table, const FloatContactBatch& batch) noexcept {
  const FloatWrench rim = table.float_wrench(FloatTwist{1.0F, 1.0F});
  Before before;
  Searches at;
  for_each_block(batch, block_size, [&](const FloatContactBatch& block) {
    const std::size_t count = block.size();
    recall(law, block, before);
    make_trials(law, rim, count, block.x.data(), block.y.data(), block.angle.data(), block.start.data(), block.trend.data(),
                before.x.data(), before.y.data(), before.angle.data(), before.limit.data(), at.r.data(), at.rho.data(),
                at.trial_force.data(), at.trial_moment.data(), at.primary.data(), at.secondary.data(), at.outside.data(), at.kappa.data(),
                at.x.data(), at.open.data());
    search(law, table, count, at);
    shrink_to_foot(law.arm, count, before.x.data(), before.y.data(), before.angle.data(), before.limit.data(), at.r.data(), at.rho.data(),
                   at.primary.data(), at.secondary.data(), at.outside.data(), at.x.data(), at.found_primary.data(),
                   at.found_secondary.data(), at.share.data(), at.twist_share.data(), at.proxy_share.data(), at.proxy_twist_share.data(),
                   at.place.data());
    move_proxies(law, block, before, at.share, at.twist_share, at.proxy_share, at.proxy_twist_share, at.place);
  });
}

}  // namespace limitcurve::godobject::detail
