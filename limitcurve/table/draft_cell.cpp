// SPDX-License-Identifier: MIT
#include "limitcurve/table/draft_cell.hpp"

#include "limitcurve/table/bernstein.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitcurve::table {

DraftCell::DraftCell(const Source& source, bool outside, std::size_t nodes, double left, double right, Extended start,
                     double limit)
    : nodes_(nodes), left_(left), right_(right), start_(start) {
  samples_.reserve(2 * most_nodes + 3);
  for (std::size_t i = 0; i < nodes_; ++i) samples_.push_back(source.at(outside, place(2 * i)));
  interpolate();
  if (least_growth() >= 0 || may_be_straight()) look_between(source, outside, limit);
}

namespace {

/// |y| on [−1, 1] where the product of the distances from 3 to 6 Chebyshev–Lobatto nodes is largest, and with it the
/// error of an interpolation: tan((n − 1)θ) = −(n − 1) tan θ, y = cos θ. From the ends on; −1 after the last.
constexpr std::array<std::array<double, 3>, 4> extrema{{{0.5773502691896258, -1.0},
                                                        {0.7905694150420949, 0.0, -1.0},
                                                        {0.8775854441999608, 0.3603384355413083, -1.0},
                                                        {0.9202480489958662, 0.5655176345490637, 0.0}}};

}  // namespace

/// The Chebyshev–Lobatto nodes for even k, points between them for odd k.
double DraftCell::place(std::size_t k) const noexcept {
  if (k == 0) return left_;
  const std::size_t last = 2 * (nodes_ - 1);
  if (k == last) return right_;
  const double sine = std::sin(std::numbers::pi / 2 * static_cast<double>(k) / static_cast<double>(last));
  return left_ + (right_ - left_) * (sine * sine);
}

void DraftCell::interpolate() {
  std::array<Extended, most_nodes> nodes;
  std::array<Extended, most_nodes> differences;
  for (std::size_t i = 0; i < nodes_; ++i) {
    nodes[i] = (Extended(samples_[i].x) - left_) / width();
    differences[i] = samples_[i].leading;
  }
  for (std::size_t order = 1; order < nodes_; ++order) {
    for (std::size_t i = nodes_; i-- > order;) {
      differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
    }
  }
  // Newton's form, from the inside out: multiply by u − node, add the difference.
  coefficients_.fill(0);
  for (std::size_t i = nodes_; i-- > 0;) {
    for (std::size_t k = nodes_; k-- > 1;) coefficients_[k] = coefficients_[k - 1] - nodes[i] * coefficients_[k];
    coefficients_[0] = differences[i] - nodes[i] * coefficients_[0];
  }
}

void DraftCell::look_between(const Source& source, bool outside, double limit) {
  bool within = true;
  const auto look = [&](double x) {
    if (!(within && x > left_ && x < right_)) return;
    samples_.push_back(source.at(outside, x));
    within = may_be_straight() || error_at(samples_.back()) <= limit;
  };
  for (const double y : extrema[nodes_ - 3]) {
    if (y < 0.0) break;
    look(left_ + (right_ - left_) * (0.5 - 0.5 * y));
    if (y > 0.0) look(left_ + (right_ - left_) * (0.5 + 0.5 * y));
  }
  // The error of a coarse cell may peak anywhere, and few cells are coarse: take more samples.
  constexpr double coarse = 1e-5;
  const std::size_t last = 2 * (nodes_ - 1);
  for (std::size_t k = 0; limit > coarse && k < last; ++k) {
    look((place(k) + place(k + 1)) / 2);
    if (k % 2 == 1) look(place(k));
  }
  // The curve may be singular at an end of the side. In a cell that is much wider than what lies between it and that
  // end, the error may then be largest just beside the smaller neighbour.
  const double wide = (right_ - left_) / 16.0;
  for (const double fraction : {0.01, 0.004, 0.0015}) {
    if (left_ < wide) look(left_ + fraction * (right_ - left_));
    if (1.0 - right_ < wide) look(right_ - fraction * (right_ - left_));
  }
  // Around each break, as far as its neighbours, which have samples of their own.
  const std::vector<double>& breaks = source.breaks;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const auto place_of = [&](std::size_t k) { return outside ? 1.0 / breaks[k] : breaks[k]; };
    const double at = place_of(i);
    const double before = i > 0 ? std::fabs(at - place_of(i - 1)) : 1.0;
    const double after = i + 1 < breaks.size() ? std::fabs(place_of(i + 1) - at) : 1.0;
    look(at);
    for (const double fraction : {0.01, 0.02, 0.035, 0.05, 0.07, 0.1, 0.14}) {
      const double step = fraction * (right_ - left_);
      if (step < (outside ? after : before)) look(at - step);
      if (step < (outside ? before : after)) look(at + step);
    }
  }
}

bool DraftCell::may_be_straight() const noexcept {
  const Extended end = leading_at_end();
  return left_ == 0.0 || std::fabs(end - samples_[0].leading) <= std::numeric_limits<double>::epsilon() / 2 * end;
}

void DraftCell::straighten() {
  const Extended rise = leading_at_end() - samples_[0].leading;
  coefficients_.fill(0);
  coefficients_[0] = samples_[0].leading;
  // By rounding the rise may be negative.
  coefficients_[1] = std::max<Extended>(rise, 0);
}

Extended DraftCell::leading(Extended u) const noexcept {
  Extended sum = 0;
  for (std::size_t i = most_nodes; i-- > 0;) sum = sum * u + coefficients_[i];
  return sum;
}

Extended DraftCell::support(Extended u) const noexcept {
  Extended sum = 0;
  for (std::size_t i = most_nodes; i-- > 0;) sum = sum * u + coefficients_[i] / static_cast<Extended>(i + 1);
  return start_ + width() * u * sum;
}

Extended DraftCell::least_growth() const noexcept {
  std::array<Extended, most_nodes - 1> slope;
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = static_cast<Extended>(i + 1) * coefficients_[i + 1];
  return least_bernstein_coefficient(slope);
}

Extended DraftCell::error_at(const Sample& exact) const noexcept {
  const Extended u = (Extended(exact.x) - left_) / width();
  const Extended slope = leading(u);
  return std::max(std::fabs(slope - exact.leading), std::fabs(support(u) - exact.x * slope - exact.trailing)) +
         exact.error;
}

Extended DraftCell::error() const noexcept {
  Extended worst = 0;
  for (std::size_t i = nodes_; i < samples_.size(); ++i) worst = std::max(worst, error_at(samples_[i]));
  return worst;
}

bool DraftCell::stays_convex(Extended rise) const noexcept {
  // The slope of u(1 − u) is at most 1.
  return std::fabs(6 * rise / width()) <= least_growth();
}

void DraftCell::raise_end(Extended rise) noexcept {
  // u(1 − u) has the integral 1/6.
  const Extended bow = 6 * rise / width();
  coefficients_[1] += bow;
  coefficients_[2] -= bow;
}

TableCell DraftCell::finished() const noexcept {
  TableCell result{left_, {}};
  result.coefficients[0] = static_cast<double>(start_);
  Extended scale = 1;
  for (std::size_t i = 0; i < most_nodes; ++i) {
    result.coefficients[i + 1] = static_cast<double>(coefficients_[i] * scale / static_cast<Extended>(i + 1));
    scale /= width();
  }
  return result;
}

}  // namespace limitcurve::table
