// SPDX-License-Identifier: MIT
// Notation (docs/theory.md, tables):
//   x          s = c/a inside the rim, 1/s outside: both sides run from 0 to the rim at 1
//   D          the support function of a side; its leading component is D′, its trailing one D − xD′
//   u          (x − left)/(right − left), the place in a cell
//   p, d       2^p buckets in each octave of 1 − x + 2^−d (Buckets)
//   edge       the x where a bucket ends; a cell begins at an edge, unless it is part of a bucket
//   target     error that a cell may have, so that the table's checked error stays within its tolerance
#include "limitcurve/table/builder.hpp"

#include "limitcurve/table/buckets.hpp"
#include "limitcurve/table/draft_cell.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <unordered_map>

namespace limitcurve::table {

namespace {

/// Margin of the checked error above the largest error found, because the true maximum is near a sample, not at it.
constexpr double check_margin = 0.05;

/// Builds both sides of a table with an error of at most `target`.
template <class Real>
class Builder {
 public:
  Builder(const Source& source, double target, int degree, std::size_t max_bytes)
      : source_(source), target_(target), degree_(degree), most_bytes_(max_bytes) {}

  /// Builds both sides, with several cells in a bucket or without; false if that is not possible.
  bool lay(bool splits_buckets) { return (splits_buckets ? lay_in_cells() : lay_in_buckets()) == Outcome::done; }

  /// Makes both sides meet at the rim, where D = f + m; false if a side would not stay convex.
  bool join_at_rim() {
    const Extended at_rim = sides_[0].back().leading_at_end() + sides_[1].back().leading_at_end();
    return std::all_of(sides_.begin(), sides_.end(),
                       [&](std::vector<DraftCell>& side) { return end_at(side, at_rim); });
  }

  [[nodiscard]] TableCells cells() const {
    TableCells result{buckets_.index_bits, buckets_.octaves, {}, {}};
    for (const DraftCell& cell : sides_[0]) result.inside.push_back(cell.finished());
    for (const DraftCell& cell : sides_[1]) result.outside.push_back(cell.finished());
    return result;
  }
  [[nodiscard]] const std::array<std::vector<DraftCell>, 2>& sides() const noexcept { return sides_; }

 private:
  enum class Outcome { done, needs_octave, impossible, too_large };

  /// Builds both sides from cells that begin at edges of buckets, which a look-up finds without a search.
  Outcome lay_in_buckets() {
    const int narrowest = octaves_to_rim();
    int bits = Buckets::least_bits;
    for (int more = 0;;) {
      // The narrowest bucket has the width 2^−(p + d).
      buckets_ = {bits, std::max(narrowest - bits, 1) + more};
      edges_ = buckets_.edges();
      Outcome outcome = fits_in_memory() ? lay_side(false) : Outcome::impossible;
      if (outcome == Outcome::done) outcome = lay_side(true);
      if (outcome == Outcome::done || outcome == Outcome::too_large) return outcome;
      if (outcome == Outcome::needs_octave) {
        ++more;
      } else if (buckets_.index_bits > bits) {
        // The number of bits grew. Starting with it needs fewer octaves.
        bits = buckets_.index_bits;
      } else {
        return outcome;
      }
    }
  }

  /// Builds both sides from cells that begin anywhere, for singularities inside a side or nearer to an end than the
  /// smallest bucket.
  Outcome lay_in_cells() {
    splits_buckets_ = true;
    constexpr int bits = 4;
    buckets_ = {bits, std::clamp(octaves_to_rim() - bits, 1, finest_edge - bits)};
    edges_ = buckets_.edges();
    const Outcome outcome = lay_side(false);
    return outcome == Outcome::done ? lay_side(true) : outcome;
  }

  /// The cell over [left, right]; with D′ as a chord if only that fits.
  [[nodiscard]] DraftCell cell(bool outside, double left, double right, Extended start) const {
    DraftCell result(source_, outside, static_cast<std::size_t>(degree_), left, right, start, target_);
    if (!fits(result) && result.may_be_straight()) {
      DraftCell chord = result;
      chord.straighten();
      if (fits(chord)) return chord;
    }
    return result;
  }
  [[nodiscard]] bool fits(const DraftCell& cell) const { return cell.least_growth() >= 0 && cell.error() <= target_; }

  /// Factor by which the width should change. The error grows like the power `degree` of the width.
  [[nodiscard]] double change(const DraftCell& cell) const {
    if (!(cell.least_growth() >= 0)) return 0.5;
    const double error = std::max(static_cast<double>(cell.error()), 1e-6 * target_);
    return std::clamp(0.93 * std::pow(target_ / error, 1.0 / degree_), 0.25, 4.0);
  }

  [[nodiscard]] int octaves_to_rim() const { return std::max(octaves_to_end(false, true), octaves_to_end(true, true)); }

  /// k such that a cell of width 2^−k fits at an end of a side. The power with which its error falls is estimated from
  /// one try to the next.
  [[nodiscard]] int octaves_to_end(bool outside, bool rim) const {
    const double most_power = degree_;
    double power = most_power;
    double last_error = 0.0;
    int step = 0;
    int k = 1;
    while (k < finest_edge) {
      const double width = std::ldexp(1.0, -k);
      const double left = rim ? 1.0 - width : 0.0;
      const Sample begin = source_.at(outside, left);
      const DraftCell here = cell(outside, left, rim ? 1.0 : width, begin.trailing + begin.x * begin.leading);
      if (fits(here)) break;
      const auto error = static_cast<double>(here.error());
      if (step > 0 && last_error > 0.0 && error > 0.0)
        power = std::clamp(std::log2(last_error / error) / step, 0.5, most_power);
      step = error > target_ ? std::clamp(static_cast<int>(std::ceil(std::log2(error / target_) / power)), 1, 6) : 1;
      last_error = error;
      k += step;
    }
    return std::min(k, finest_edge);
  }

  [[nodiscard]] Outcome lay_side(bool outside) {
    std::vector<DraftCell>& side = sides_[outside];
    side.clear();
    Extended start = source_.at(outside, 0.0).trailing;
    double left = 0.0;
    double guess = splits_buckets_ ? std::ldexp(1.0, -octaves_to_end(outside, false)) : 0.25;
    double last_width = guess;
    while (left < 1.0) {
      std::optional<DraftCell> next = widest(outside, left, guess, start);
      if (!next && splits_buckets_) next = narrower(outside, left, guess, start);
      if (!next) {
        if (splits_buckets_) return Outcome::impossible;
        const double offset = std::ldexp(1.0, -buckets_.octaves);
        const bool at_rim = 1.0 - left <= offset;
        if (buckets_.index_bits + buckets_.octaves == finest_edge) return Outcome::impossible;
        if (at_rim) return Outcome::needs_octave;
        if (buckets_.index_bits == Buckets::most_bits) return Outcome::impossible;
        // All edges used so far are also edges of the finer buckets.
        ++buckets_.index_bits;
        edges_ = buckets_.edges();
        continue;
      }
      // Towards a singularity widths shrink by the same factor from cell to cell: extrapolate it.
      const auto width = static_cast<double>(next->width());
      guess = width * std::clamp(width / last_width, 0.5, 2.0);
      last_width = width;
      left = next->right();
      start = next->end();
      side.push_back(*next);
      if (!fits_in_memory()) return Outcome::too_large;
    }
    return Outcome::done;
  }

  /// Nearly the widest cell from `left` that fits; nothing if even one bucket is too wide.
  [[nodiscard]] std::optional<DraftCell> widest(bool outside, double left, double guess, Extended start) const {
    const auto at_most = [&](double x) {
      return static_cast<std::size_t>(std::upper_bound(edges_.begin(), edges_.end(), x) - edges_.begin()) - 1;
    };
    std::optional<DraftCell> best;
    std::size_t good = at_most(left);
    std::size_t bad = edges_.size();
    std::size_t to = std::clamp(at_most(left + guess), good + 1, bad - 1);
    while (true) {
      const DraftCell here = cell(outside, left, edges_[to], start);
      const bool fit = fits(here);
      if (fit) best = here;
      (fit ? good : bad) = to;
      if (good + 1 >= bad) return best;
      to = std::clamp(at_most(left + change(here) * (here.right() - left)), good + 1, bad - 1);
      constexpr double worthwhile = 1.15;
      if (best && edges_[to] - left < worthwhile * (best->right() - left)) return best;
    }
  }

  /// Nearly the widest cell from `left` that fits within its bucket; nothing if none does.
  [[nodiscard]] std::optional<DraftCell> narrower(bool outside, double left, double guess, Extended start) const {
    const double edge = *std::upper_bound(edges_.begin(), edges_.end(), left);
    constexpr double least = narrowest_cell<Real>;
    std::optional<DraftCell> best;
    double good = 0.0;
    double bad = edge - left;
    double width = std::min(guess, 0.5 * bad);
    constexpr int attempts = 100;
    for (int i = 0; i < attempts && width >= least; ++i) {
      // The rest of the bucket must be wide enough for a cell, too.
      const double right = static_cast<Real>(left + width);
      if (!(right - left >= least && edge - right >= least)) return best;
      const DraftCell here = cell(outside, left, right, start);
      const bool fit = fits(here);
      if (fit) best = here;
      (fit ? good : bad) = width;
      const double next = std::min(change(here) * width, 0.9 * bad);
      constexpr double worthwhile = 1.15;
      if (best && next < worthwhile * good) return best;
      width = best ? next : std::min(next, 0.5 * width);
    }
    return best;
  }

  [[nodiscard]] bool fits_in_memory() const {
    return bytes_of<Real>(sides_[0].size() + sides_[1].size(), degree_, buckets_) <= most_bytes_;
  }

  /// Makes D end at `value`: bends the widest cell that stays convex, and raises those after it. False if there is
  /// none.
  static bool end_at(std::vector<DraftCell>& side, Extended value) {
    const Extended rise = value - side.back().end();
    // Rounding is left: on a nearly straight side only a cell too narrow to bend may stay convex.
    if (std::fabs(rise) <= std::numeric_limits<double>::epsilon() / 2 * value) return true;
    DraftCell* bent = nullptr;
    for (DraftCell& one : side) {
      if (one.stays_convex(rise) && (bent == nullptr || one.width() > bent->width())) bent = &one;
    }
    if (bent == nullptr) return false;
    bent->raise_end(rise);
    for (DraftCell& after : side) {
      if (after.left() > bent->left()) after.raise(rise);
    }
    return true;
  }

  /// The largest p + d for which the edges of buckets are exact.
  static constexpr int finest_edge = std::numeric_limits<Real>::digits - 1;

  const Source& source_;
  double target_;
  int degree_;
  std::size_t most_bytes_;
  Buckets buckets_;
  bool splits_buckets_ = false;
  std::vector<double> edges_;
  std::array<std::vector<DraftCell>, 2> sides_;
};

/// Error bound of the finished table in its own arithmetic: the largest error, plus the error of the exact curve. A
/// maximum of the error is bracketed by three of the cells' samples, and found between them, unless it is clearly
/// smaller than another.
template <class Real>
double find_error(const Source& source, const BasicTable<Real>& table,
                  const std::array<std::vector<DraftCell>, 2>& sides) {
  struct Bracket {
    double error;
    bool outside;
    double left;
    double right;
  };
  double worst = 0.0;
  double exact_error = 0.0;
  const auto error_at = [&](bool outside, const Sample& exact) {
    exact_error = std::max(exact_error, exact.error);
    const Jet<Real> jet = table.view().table.jet(outside, static_cast<Real>(exact.x));
    const auto error = static_cast<double>(
        std::max(std::fabs(Extended(jet.leading) - exact.leading), std::fabs(Extended(jet.trailing) - exact.trailing)));
    worst = std::max(worst, error);
    return error;
  };
  std::vector<Bracket> brackets;
  for (const bool outside : {false, true}) {
    std::map<double, double> errors;
    for (const DraftCell& cell : sides[outside]) {
      for (const Sample& exact : cell.samples()) errors[exact.x] = error_at(outside, exact);
    }
    for (auto here = std::next(errors.begin()); std::next(here) != errors.end(); ++here) {
      const auto before = std::prev(here);
      const auto after = std::next(here);
      if (here->second >= std::max(before->second, after->second))
        brackets.push_back({here->second, outside, before->first, after->first});
    }
  }
  std::sort(brackets.begin(), brackets.end(), [](const Bracket& a, const Bracket& b) { return a.error > b.error; });
  for (const Bracket& bracket : brackets) {
    constexpr double clearly_smaller = 0.7;
    if (bracket.error < clearly_smaller * worst) break;
    constexpr int bits = 6;
    std::uintmax_t steps = 10;
    const auto error = [&](double part) {
      const double x = std::lerp(bracket.left, bracket.right, part);
      return -error_at(bracket.outside, source.at(bracket.outside, static_cast<Real>(x)));
    };
    boost::math::tools::brent_find_minima(error, 0.0, 1.0, bits, steps);
  }
  return (1.0 + check_margin) * worst + exact_error;
}

/// The checked error that a tolerance allows, what rounding has of it, and the error of cells.
template <class Real>
struct Errors {
  double allowed;
  double rounding;
  double target;

  Errors(const Source& source, double tolerance) {
    const Sample spin = source.at(false, 0.0);
    const Sample slide = source.at(true, 0.0);
    const auto scale = static_cast<double>(std::max(spin.trailing, slide.trailing));
    const double own = std::max({spin.error, slide.error, source.at(false, 1.0).error});
    allowed = tolerance * scale;
    rounding = 1.5 * double{std::numeric_limits<Real>::epsilon()} * scale;
    target = 0.95 * (allowed - rounding - own) / (1.0 + check_margin);
  }
};

/// `build` with a given degree and memory; with `splits_buckets` look-ups search.
template <class Real>
std::optional<BasicTable<Real>> build_of_degree(const Source& source, double tolerance, int degree,
                                                std::size_t max_bytes, bool splits_buckets) {
  auto [allowed, rounding, target] = Errors<Real>(source, tolerance);
  constexpr int attempts = 12;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < attempts && target > 0.0; ++i) {
    Builder<Real> builder(source, target, degree, max_bytes);
    if (!builder.lay(splits_buckets)) return std::nullopt;
    if (!builder.join_at_rim()) {
      target *= 0.3;
      continue;
    }
    TableFacts facts{source.name, tolerance, allowed, source.profile_error};
    const BasicTable<Real> table(facts, builder.cells());
    facts.checked_error = find_error(source, table, builder.sides()) + rounding;
    if (facts.checked_error <= allowed) return BasicTable<Real>(facts, builder.cells());
    // Smaller cells with far larger errors meet rounding.
    if (!(facts.checked_error < 2.0 * last)) return std::nullopt;
    last = facts.checked_error;
    target *= 0.8;
  }
  return std::nullopt;
}

}  // namespace

template <class Real>
std::optional<BasicTable<Real>> build(const Source& source, double tolerance, std::size_t bytes) {
  constexpr std::size_t most = BasicTable<Real>::max_bytes;
  // Attempts share what they know of the curve, which may come from a quadrature.
  std::array<std::unordered_map<double, Sample>, 2> known;
  Source remembered = source;
  remembered.sample = [&](bool outside, double x) {
    auto [place, is_new] = known[outside].try_emplace(x);
    if (is_new) place->second = source.at(outside, x);
    return place->second;
  };
  constexpr int highest = TableView<Real>::most_degree;
  for (int degree = TableView<Real>::least_degree; degree < highest; ++degree) {
    if (auto table = build_of_degree<Real>(remembered, tolerance, degree, std::min(bytes, most), false)) return table;
  }
  if (auto table = build_of_degree<Real>(remembered, tolerance, highest, most, false)) return table;
  // A step of a search takes as long as eight degrees. Where the highest degree meets rounding, the lowest may do.
  for (const int degree : {highest, TableView<Real>::least_degree}) {
    if (auto table = build_of_degree<Real>(remembered, tolerance, degree, most, true)) return table;
  }
  return std::nullopt;
}

template std::optional<BasicTable<double>> build(const Source&, double, std::size_t);
template std::optional<BasicTable<float>> build(const Source&, double, std::size_t);

}  // namespace limitcurve::table
