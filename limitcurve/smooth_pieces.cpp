// SPDX-License-Identifier: MIT
#include "limitcurve/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace limitcurve {

namespace {

/// Integral and first moment: what is symmetric about a kink in one is not in the other.
using Values = std::array<Extended, 2>;

/// How well the parts of a piece must agree with it, in shares of the whole: the finest of these that can be had.
constexpr std::array<Extended, 6> agreements{1e-16L, 1e-15L, 1e-13L, 1e-11L, 1e-9L, 1e-7L};
/// A double cannot tell places nearer than this to each other.
constexpr Extended narrowest = 4e-16L;
constexpr std::size_t most_places = 64;

struct Piece {
  Extended left;
  Extended right;
  Values values;
  Extended error = 0;
};

class Cutter {
 public:
  explicit Cutter(const std::function<Extended(Extended)>& function) : function_(function) {}

  [[nodiscard]] Piece piece(Extended left, Extended right) const {
    const auto integrand = [&](Extended from_left, Extended from_right) {
      const Extended place = from_left < from_right ? left + from_left : right - from_right;
      const Extended value = function_(place);
      return Values{value, value * place};
    };
    return {left, right, DoubleExponential<Extended>::rule().integrate<2>(integrand, right - left).value};
  }

  /// By how much a piece's integrals differ from those of two that make it up, as shares of the whole.
  [[nodiscard]] Extended difference(const Piece& whole, const Piece& left, const Piece& right) const {
    Extended worst = 0;
    for (std::size_t i = 0; i < whole.values.size(); ++i) {
      worst = std::max(worst, std::fabs(left.values[i] + right.values[i] - whole.values[i]) / total_[i]);
    }
    return worst;
  }

  /// The parts of `start` that agree with their halves, in order. Nothing, if more than `most_places` do not at some depth: each
  /// place that is not smooth spoils one part, noise spoils all.
  [[nodiscard]] std::vector<Piece> parts(const Piece& start) const {
    std::vector<Piece> good;
    std::vector<Piece> waiting{start};
    while (!waiting.empty()) {
      std::vector<Piece> halves;
      for (Piece& now : waiting) {
        const Extended middle = now.left + (now.right - now.left) / 2;
        const Piece left = piece(now.left, middle);
        const Piece right = piece(middle, now.right);
        now.error = difference(now, left, right);
        if (now.error <= agreement_ || now.right - now.left <= narrowest * outer_) {
          good.push_back(now);
          continue;
        }
        halves.push_back(left);
        halves.push_back(right);
        if (halves.size() > 2 * most_places) return {};
      }
      waiting = std::move(halves);
    }
    std::sort(good.begin(), good.end(), [](const Piece& one, const Piece& other) { return one.left < other.left; });
    return good;
  }

  /// Appends the breaks after the first of `parts`, which make up one piece: a part is joined to the ones before if that
  /// changes nothing.
  void join(const std::vector<Piece>& parts, SmoothPieces& result) const {
    const auto add = [&](const Piece& one) {
      result.breaks.push_back(one.right);
      result.integral += one.values[0];
      result.error += one.error;
    };
    Piece now = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) {
      Piece together = piece(now.left, parts[i].right);
      const Extended change = difference(together, now, parts[i]);
      together.error = now.error + parts[i].error + change;
      if (change <= agreement_) {
        now = together;
        continue;
      }
      add(now);
      now = parts[i];
    }
    add(now);
  }

  [[nodiscard]] SmoothPieces cut(const std::vector<Extended>& breaks) {
    std::vector<Piece> told;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      told.push_back(piece(breaks[i], breaks[i + 1]));
      for (std::size_t k = 0; k < total_.size(); ++k) total_[k] += told.back().values[k];
    }
    outer_ = breaks.back();
    // Nothing to cut, or nothing that is a number.
    if (!(total_[0] > 0 && total_[0] <= std::numeric_limits<Extended>::max())) return {breaks, total_[0]};
    for (const Extended agreement : agreements) {
      agreement_ = agreement;
      SmoothPieces result{{breaks.front()}};
      const bool done = std::all_of(told.begin(), told.end(), [&](const Piece& one) {
        const std::vector<Piece> good = parts(one);
        if (!good.empty()) join(good, result);
        return !good.empty();
      });
      // A place is pinned between two breaks.
      if (done && result.breaks.size() <= breaks.size() + 2 * most_places) return result;
    }
    SmoothPieces result{breaks, total_[0]};
    for (const Piece& one : told) result.error += unresolved(one);
    return result;
  }

 private:
  /// What a piece that stays as it is may be off by: its integrals against sums of eight parts.
  [[nodiscard]] Extended unresolved(const Piece& whole) const {
    constexpr int parts = 8;
    Piece sum{whole.left, whole.right, {}};
    for (int i = 0; i < parts; ++i) {
      const Extended step = (whole.right - whole.left) / parts;
      const Piece part = piece(whole.left + step * i, i + 1 == parts ? whole.right : whole.left + step * (i + 1));
      for (std::size_t k = 0; k < sum.values.size(); ++k) sum.values[k] += part.values[k];
    }
    return difference(whole, sum, Piece{});
  }

  const std::function<Extended(Extended)>& function_;
  Values total_{};
  Extended outer_ = 1;
  Extended agreement_ = 0;
};

}  // namespace

SmoothPieces smooth_pieces(const std::function<Extended(Extended)>& function, const std::vector<Extended>& breaks) {
  return Cutter(function).cut(breaks);
}

}  // namespace limitcurve
