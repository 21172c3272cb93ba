// SPDX-License-Identifier: MIT
#include "limitcurve/measured/cubic_pieces.hpp"

#include "limitcurve/quadrature/kernels.hpp"

#include <limits>
#include <utility>

namespace limitcurve {

CubicPieces::CubicPieces(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {
  intervals_.reserve(2 * pieces_.size());
  add_interval(0, pieces_.size());
}

std::size_t CubicPieces::add_interval(std::size_t begin, std::size_t end) {
  const std::size_t index = intervals_.size();
  const Extended left = pieces_[begin].left;
  const Extended right = pieces_[end - 1].left + pieces_[end - 1].width;
  intervals_.push_back({left, right, begin, 0, {}, true});
  const Extended half = (right - left) / 2;
  std::vector<Mass> masses;
  bool has_sound_parts = true;
  if (end - begin == 1) {
    using Rule = boost::math::quadrature::gauss<Extended, 20>;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const int side : {-1, 1}) {
        const Extended radius = left + half * (1 + static_cast<Extended>(side) * Rule::abscissa()[i]);
        masses.push_back({radius, half * Rule::weights()[i] * 2 * radius * pieces_[begin](radius)});
      }
    }
  } else {
    const std::size_t middle = begin + (end - begin) / 2;
    for (const std::size_t part : {add_interval(begin, middle), add_interval(middle, end)}) {
      masses.insert(masses.end(), intervals_[part].rule.begin(), intervals_[part].rule.end());
      has_sound_parts = has_sound_parts && intervals_[part].is_sound;
    }
  }
  const auto [rule, is_sound] = gauss_rule(masses);
  intervals_[index].rule = rule;
  intervals_[index].is_sound = has_sound_parts && is_sound;
  intervals_[index].next = intervals_.size();
  return index;
}

std::pair<std::array<CubicPieces::Mass, CubicPieces::order>, bool> CubicPieces::gauss_rule(
    const std::vector<Mass>& masses) {
  Extended left = std::numeric_limits<Extended>::max();
  Extended right = 0;
  for (const auto& [radius, mass] : masses) {
    if (!(mass > 0)) continue;
    left = std::min(left, radius);
    right = std::max(right, radius);
  }
  // The polynomials p_k that are orthogonal under the masses, p_(k+1) = (x − a_k) p_k − b_k p_(k−1) (Stieltjes), x from
  // −1 to 1 where there is mass: across the whole interval, the digits of a narrow support would be lost.
  const Extended middle = (left + right) / 2;
  const Extended half = right > left ? (right - left) / 2 : 1;
  std::array<Extended, order> a{};
  std::array<Extended, order> b{};
  std::array<Extended, order> norm{};
  std::vector<Extended> p(masses.size(), 1);
  std::vector<Extended> before(masses.size(), 0);
  std::size_t count = 0;  // fewer than `order` for fewer masses
  for (; count < order; ++count) {
    const std::size_t k = count;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const Extended square = masses[i].mass * p[i] * p[i];
      norm[k] += square;
      a[k] += square * (masses[i].radius - middle) / half;
    }
    if (!(norm[k] > 0)) break;
    a[k] /= norm[k];
    if (k > 0) b[k] = norm[k] / norm[k - 1];
    for (std::size_t i = 0; i < masses.size(); ++i) {
      before[i] = ((masses[i].radius - middle) / half - a[k]) * p[i] - b[k] * before[i];
      std::swap(before[i], p[i]);
    }
  }
  // The nodes are the roots of the last polynomial: Newton's method from the right, with the roots already found
  // divided out. All roots are real, so its steps become shorter until they are rounding. The masses are Christoffel's
  // numbers, 1/Σ p_k²/norm_k.
  std::array<Mass, order> rule;
  rule.fill({masses.front().radius, 0});
  std::array<Extended, order> roots{};
  Extended lost = norm[0];
  Extended lost_moment = a[0] * norm[0];
  for (std::size_t found = 0; found < count; ++found) {
    Extended x = 2;  // beyond all roots: the largest may be 1, by which the search for the next divides
    Extended sum = 0;
    Extended length = 6;  // more than the first step
    while (true) {
      std::array<Extended, 2> last{0, 0};  // a polynomial and its slope
      std::array<Extended, 2> next{1, 0};
      sum = 0;
      for (std::size_t k = 0; k < count; ++k) {
        sum += next[0] * next[0] / norm[k];
        last = {(x - a[k]) * next[0] - b[k] * last[0], next[0] + (x - a[k]) * next[1] - b[k] * last[1]};
        std::swap(last, next);
      }
      Extended slope = next[1];
      for (std::size_t i = 0; i < found; ++i) slope -= next[0] / (x - roots[i]);
      const Extended step = next[0] / slope;
      if (!(std::fabs(step) < length)) break;
      length = std::fabs(step);
      x -= step;
    }
    rule[found] = {middle + half * x, 1 / sum};
    roots[found] = x;
    lost -= rule[found].mass;
    lost_moment -= rule[found].mass * x;
  }
  const Extended rounding = 64 * std::numeric_limits<Extended>::epsilon() * norm[0];
  return {rule, std::fabs(lost) <= rounding && std::fabs(lost_moment) <= rounding};
}

namespace evaluators {

namespace {

template <class Real>
Quadrature<Real> ring_in(const CubicPieces& pressure, Real s, Slope slope) noexcept {
  if (std::isinf(s)) return {{1, 0, 0}, {0, 0, 0}};
  const auto [value, error, wavering] = pressure.integrate(
      s, slope == Slope::wanted ? 3 : 2, [&](Real rho, Real from_cor) { return ring_kernel(rho, s, from_cor); });
  return {{value[0], value[1], value[2]}, {error[0], error[1], error[2]}};
}

}  // namespace

Quadrature<Extended> ring(const CubicPieces& pressure, Extended s, Slope slope) noexcept {
  return ring_in(pressure, s, slope);
}
Quadrature<double> ring(const CubicPieces& pressure, double s, Slope slope) noexcept {
  return ring_in(pressure, s, slope);
}

Quadrature<double> line_profile(const CubicPieces& pressure, double t) noexcept {
  const auto [value, error, wavering] =
      pressure.integrate(t, 2, [&](double rho, double from_t) { return line_kernel(rho, t, from_t); });
  return {{value[0], value[1], 0.0}, {error[0], error[1], 0.0}};
}

}  // namespace evaluators

}  // namespace limitcurve
