// SPDX-License-Identifier: MIT
#include "limitcurve/table/piece.hpp"

#include "limitcurve/table/bernstein.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::table {

namespace {

/// cos(kπ/10): the Chebyshev–Lobatto nodes for even k, points midway between them for odd k.
constexpr std::array<double, 11> cosines{1.0, 0.9510565162951535,  0.8090169943749475,  0.5877852522924731,  0.3090169943749474,
                                         0.0, -0.3090169943749474, -0.5877852522924731, -0.8090169943749475, -0.9510565162951535,
                                         -1.0};

double place(double left, double right, std::size_t k) noexcept {
  if (k == 0) return left;
  if (k == 10) return right;
  return left + (right - left) * (0.5 - 0.5 * cosines[k]);
}

}  // namespace

Piece::Piece(const Source& source, bool outside, double left, double right, Extended start, double limit)
    : left_(left), right_(right), start_(start) {
  samples_.reserve(2 * node_count + 3);
  for (std::size_t k = 0; k <= 10; k += 2) samples_.push_back(source.at(outside, place(left, right, k)));
  interpolate();
  if (least_growth() >= 0 || may_be_straight()) look_between(source, outside, limit);
}

void Piece::interpolate() {
  std::array<Extended, node_count> nodes;
  std::array<Extended, node_count> differences;
  for (std::size_t i = 0; i < node_count; ++i) {
    nodes[i] = (Extended(samples_[i].x) - left_) / width();
    differences[i] = samples_[i].leading;
  }
  for (std::size_t order = 1; order < node_count; ++order) {
    for (std::size_t i = node_count; i-- > order;) {
      differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
    }
  }
  // Newton's form, from the inside out: multiply by u − node, add the difference.
  coefficients_.fill(0);
  for (std::size_t i = node_count; i-- > 0;) {
    for (std::size_t k = node_count; k-- > 1;) coefficients_[k] = coefficients_[k - 1] - nodes[i] * coefficients_[k];
    coefficients_[0] = differences[i] - nodes[i] * coefficients_[0];
  }
}

void Piece::look_between(const Source& source, bool outside, double limit) {
  bool within = true;
  const auto look = [&](double x) {
    if (!(within && x > left_ && x < right_)) return;
    samples_.push_back(source.at(outside, x));
    within = may_be_straight() || error_at(samples_.back()) <= limit;
  };
  for (const std::size_t k : {1U, 9U, 5U, 3U, 7U}) look(place(left_, right_, k));
  // The error of a coarse cell may peak anywhere, and few cells are coarse: take twice as many samples.
  constexpr double coarse = 1e-5;
  for (std::size_t k = 0; limit > coarse && k < 10; ++k) look((place(left_, right_, k) + place(left_, right_, k + 1)) / 2);
  // The curve may be singular at an end of the side; then the largest error is nearer to it.
  for (const double fraction : {0.01, 0.004, 0.0015}) {
    if (left_ == 0.0) look(fraction * right_);
    if (right_ == 1.0) look(1.0 - fraction * (1.0 - left_));
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

bool Piece::may_be_straight() const noexcept {
  const Extended end = samples_[node_count - 1].leading;
  return left_ == 0.0 || std::fabs(end - samples_[0].leading) <= std::numeric_limits<double>::epsilon() / 2 * end;
}

void Piece::straighten() {
  const Extended rise = samples_[node_count - 1].leading - samples_[0].leading;
  coefficients_.fill(0);
  coefficients_[0] = samples_[0].leading;
  // By rounding the rise may be negative.
  coefficients_[1] = std::max<Extended>(rise, 0);
}

Extended Piece::leading(Extended u) const noexcept {
  Extended sum = 0;
  for (std::size_t i = node_count; i-- > 0;) sum = sum * u + coefficients_[i];
  return sum;
}

Extended Piece::support(Extended u) const noexcept {
  Extended sum = 0;
  for (std::size_t i = node_count; i-- > 0;) sum = sum * u + coefficients_[i] / static_cast<Extended>(i + 1);
  return start_ + width() * u * sum;
}

Extended Piece::least_growth() const noexcept {
  std::array<Extended, node_count - 1> slope;
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = static_cast<Extended>(i + 1) * coefficients_[i + 1];
  return least_bernstein_coefficient(slope);
}

Extended Piece::error_at(const Sample& exact) const noexcept {
  const Extended u = (Extended(exact.x) - left_) / width();
  const Extended slope = leading(u);
  return std::max(std::fabs(slope - exact.leading), std::fabs(support(u) - exact.x * slope - exact.trailing));
}

Extended Piece::error() const noexcept {
  Extended worst = 0;
  for (std::size_t i = node_count; i < samples_.size(); ++i) worst = std::max(worst, error_at(samples_[i]));
  return worst;
}

bool Piece::stays_convex(Extended rise) const noexcept {
  // The slope of u(1 − u) is at most 1.
  return std::fabs(6 * rise / width()) <= least_growth();
}

void Piece::raise_end(Extended rise) noexcept {
  // u(1 − u) has the integral 1/6.
  const Extended bow = 6 * rise / width();
  coefficients_[1] += bow;
  coefficients_[2] -= bow;
}

TableCell Piece::cell() const noexcept {
  TableCell result{left_, {}};
  result.coefficients[0] = static_cast<double>(start_);
  Extended scale = 1;
  for (std::size_t i = 0; i < node_count; ++i) {
    result.coefficients[i + 1] = static_cast<double>(coefficients_[i] * scale / static_cast<Extended>(i + 1));
    scale /= width();
  }
  return result;
}

}  // namespace limitcurve::table
