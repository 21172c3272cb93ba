// SPDX-License-Identifier: MIT
#include "limitcurve/laws/smooth_pieces.hpp"

#include "limitcurve/quadrature/tanh_sinh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace limitcurve {

namespace {

/// Integral and first moment. An error that cancels in one by symmetry about a kink does not cancel in the other.
using Values = std::array<Extended, 2>;

/// Required agreement of a piece with its halves, as a fraction of the whole integral; the first that can be reached is used.
constexpr std::array<Extended, 4> agreements{std::max(1e-16L, 8 * std::numeric_limits<Extended>::epsilon()), 1e-13L, 1e-10L, 1e-7L};
/// Narrowest piece: a double does not resolve smaller distances.
constexpr Extended narrowest = 4e-16L;
constexpr std::size_t most_places = 64;
/// Features of the smallest width in one cell. The quadrature points of a cell's halves are at most a twentieth of the cell apart, so that
/// none of these features lies between them.
constexpr Extended features_per_cell = 20;

struct Piece {
  Extended left;
  Extended right;
  Values values;
  Values truncation{};  ///< error of the values, from the quadrature
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
    const auto [value, truncation] = integrate<2>(integrand, right - left);
    return {left, right, value, truncation};
  }

  /// Difference of a piece's integrals from those of its two parts, plus its own truncation error, as a fraction of the whole.
  [[nodiscard]] Extended difference(const Piece& whole, const Piece& left, const Piece& right) const {
    Extended worst = 0;
    for (std::size_t i = 0; i < whole.values.size(); ++i) {
      worst = std::max(worst, (std::fabs(left.values[i] + right.values[i] - whole.values[i]) + whole.truncation[i]) / total_[i]);
    }
    return worst;
  }

  /// `cells`, halved until each part agrees with its halves, in order. Empty if at some depth more than `most_places` parts do not agree: a
  /// point that is not smooth spoils one part, noise spoils all.
  [[nodiscard]] std::vector<Piece> parts(const std::vector<Piece>& cells) const {
    std::vector<Piece> good;
    std::vector<Piece> waiting = cells;
    while (!waiting.empty()) {
      std::vector<Piece> halves;
      for (Piece& now : waiting) {
        const auto [left, right] = halves_of(now);
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

  /// `parts` with neighbours joined where that does not change the integral: in pairs, then pairs of pairs, so that rounding does not add
  /// up.
  [[nodiscard]] std::vector<Piece> joined(std::vector<Piece> parts) const {
    while (true) {
      std::vector<Piece> next;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        next.push_back(parts[i]);
        if (i + 1 == parts.size()) break;
        Piece together = piece(parts[i].left, parts[i + 1].right);
        const Extended change = difference(together, parts[i], parts[i + 1]);
        if (change > agreement_) continue;
        together.error = parts[i].error + parts[i + 1].error + change;
        next.back() = together;
        ++i;
      }
      if (next.size() == parts.size()) return next;
      parts = std::move(next);
    }
  }

  [[nodiscard]] SmoothPieces cut(const std::vector<Extended>& breaks, Extended narrowest_feature) {
    outer_ = breaks.back();
    std::vector<std::vector<Piece>> given;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      given.push_back(cells(breaks[i], breaks[i + 1], features_per_cell * narrowest_feature * outer_));
      for (const Piece& cell : given.back()) {
        for (std::size_t k = 0; k < total_.size(); ++k) total_[k] += cell.values[k];
      }
    }
    // No load, or not a number: the caller reports it.
    if (!(total_[0] > 0 && total_[0] <= std::numeric_limits<Extended>::max())) return {breaks, total_[0]};
    for (const Extended agreement : agreements) {
      agreement_ = agreement;
      std::vector<Piece> found;
      const bool done = std::all_of(given.begin(), given.end(), [&](const std::vector<Piece>& cells) {
        const std::vector<Piece> good = joined(parts(cells));
        found.insert(found.end(), good.begin(), good.end());
        return !good.empty();
      });
      // Each point that is not smooth adds two breaks.
      if (done && found.size() < breaks.size() + 2 * most_places) return sum(found);
    }
    std::vector<Piece> rough;
    for (const std::vector<Piece>& cells : given) {
      const std::vector<Piece> some = unresolved(cells, std::max<std::size_t>(2 * most_places / given.size(), 1));
      rough.insert(rough.end(), some.begin(), some.end());
    }
    return sum(rough);
  }

 private:
  [[nodiscard]] std::vector<Piece> cells(Extended left, Extended right, Extended width) const {
    const auto count = static_cast<std::size_t>(std::ceil((right - left) / width));
    std::vector<Piece> result;
    for (std::size_t i = 0; i < count; ++i) {
      const auto edge = [&](std::size_t k) {
        return k == count ? right : left + (right - left) * static_cast<Extended>(k) / static_cast<Extended>(count);
      };
      result.push_back(piece(edge(i), edge(i + 1)));
    }
    return result;
  }

  [[nodiscard]] std::array<Piece, 2> halves_of(const Piece& whole) const {
    const Extended middle = whole.left + (whole.right - whole.left) / 2;
    return {piece(whole.left, middle), piece(middle, whole.right)};
  }

  /// Rough cells as at most `most` pieces. The error of a piece is the sum of its difference from its cells and of theirs from their
  /// halves, all taken as positive. It is an estimate, not a bound; but the true errors of rough cells have different signs.
  [[nodiscard]] std::vector<Piece> unresolved(const std::vector<Piece>& cells, std::size_t most) const {
    const std::size_t group = (cells.size() + most - 1) / most;
    std::vector<Piece> result;
    for (std::size_t begin = 0; begin < cells.size(); begin += group) {
      const std::size_t end = std::min(begin + group, cells.size());
      Piece together = piece(cells[begin].left, cells[end - 1].right);
      Piece sum{together.left, together.right, {}};
      for (std::size_t i = begin; i < end; ++i) {
        const auto [left, right] = halves_of(cells[i]);
        together.error += difference(cells[i], left, right);
        for (std::size_t k = 0; k < sum.values.size(); ++k) sum.values[k] += cells[i].values[k];
      }
      together.error += difference(together, sum, Piece{});
      result.push_back(together);
    }
    return result;
  }

  static SmoothPieces sum(const std::vector<Piece>& pieces) {
    SmoothPieces result{{pieces.front().left}};
    for (const Piece& one : pieces) {
      result.breaks.push_back(one.right);
      result.integral += one.values[0];
      result.error += one.error;
    }
    return result;
  }

  const std::function<Extended(Extended)>& function_;
  Values total_{};
  Extended outer_ = 1;
  Extended agreement_ = 0;
};

}  // namespace

SmoothPieces smooth_pieces(const std::function<Extended(Extended)>& function, const std::vector<Extended>& breaks,
                           Extended narrowest_feature) {
  return Cutter(function).cut(breaks, narrowest_feature);
}

}  // namespace limitcurve
