// SPDX-License-Identifier: MIT
#include "limitcurve/measured/monotone_cubic.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve {

namespace {

using Piece = CubicPieces::Piece;

/// Monotone cubic through samples of increasing radius: slopes by the weighted harmonic mean of the neighbouring
/// chords, zero where they change sign (Fritsch and Butland 1984); one-sided at the ends, limited alike.
class MonotoneCubic {
 public:
  explicit MonotoneCubic(std::span<const PressureSample> run) : run_(run) {}

  void append_to(std::vector<Piece>& pieces) const {
    for (std::size_t i = 0; i + 1 < run_.size(); ++i) {
      const Extended width = Extended(run_[i + 1].radius) - run_[i].radius;
      const Extended chord = this->chord(i);
      const Extended left = slope(i);
      const Extended right = slope(i + 1);
      pieces.push_back({run_[i].radius, width, run_[i].pressure, left, (3 * chord - 2 * left - right) / width,
                        (left + right - 2 * chord) / (width * width)});
    }
  }

 private:
  [[nodiscard]] Extended chord(std::size_t i) const {
    return (Extended(run_[i + 1].pressure) - run_[i].pressure) / (Extended(run_[i + 1].radius) - run_[i].radius);
  }

  [[nodiscard]] Extended slope(std::size_t i) const {
    const std::size_t last = run_.size() - 1;
    if (last == 1) return chord(0);
    if (i == 0) return end_slope(chord(0), chord(1), run_[1].radius - run_[0].radius, run_[2].radius - run_[1].radius);
    if (i == last) {
      return end_slope(chord(last - 1), chord(last - 2), run_[last].radius - run_[last - 1].radius,
                       run_[last - 1].radius - run_[last - 2].radius);
    }
    const Extended before = chord(i - 1);
    const Extended after = chord(i);
    if (!(before * after > 0)) return 0;
    const Extended width_before = Extended(run_[i].radius) - run_[i - 1].radius;
    const Extended width_after = Extended(run_[i + 1].radius) - run_[i].radius;
    const Extended weight_before = 2 * width_after + width_before;
    const Extended weight_after = width_after + 2 * width_before;
    return (weight_before + weight_after) / (weight_before / before + weight_after / after);
  }

  /// Slope of the parabola through three points, limited so that the cubic does not overshoot: the sign of the chord,
  /// at most three times its size.
  static Extended end_slope(Extended chord, Extended next, Extended width, Extended next_width) {
    const Extended slope = ((2 * width + next_width) * chord - width * next) / (width + next_width);
    if (!(slope * chord > 0)) return 0;
    return std::fabs(slope) > 3 * std::fabs(chord) ? 3 * chord : slope;
  }

  std::span<const PressureSample> run_;
};

}  // namespace

CubicPieces cubics(std::span<const PressureSample> profile, std::string_view source, double rim, bool named) {
  std::vector<PressureSample> scaled;
  for (const PressureSample& sample : profile) scaled.push_back({sample.radius / rim, sample.pressure});
  if (scaled.front().radius > 0.0) scaled.insert(scaled.begin(), {0.0, scaled.front().pressure});
  std::vector<Piece> pieces;
  // Jumps divide the profile into runs.
  for (std::size_t begin = 0; begin + 1 < scaled.size();) {
    std::size_t end = begin + 1;
    while (end < scaled.size() && scaled[end].radius > scaled[end - 1].radius) {
      if (named && end - begin > 1 && scaled[end - 1].pressure == 0.0) break;
      ++end;
    }
    MonotoneCubic(std::span(scaled).subspan(begin, end - begin)).append_to(pieces);
    begin = end < scaled.size() && scaled[end].radius == scaled[end - 1].radius ? end : end - 1;
  }
  // Without pressure up to the rim.
  if (scaled.back().radius < 1.0)
    pieces.push_back({scaled.back().radius, 1 - Extended(scaled.back().radius), 0, 0, 0, 0});
  // ∫ 2ρ p dρ of a cubic, piece by piece: exact.
  Extended load = 0;
  for (const Piece& p : pieces) {
    const Extended w = p.width;
    const Extended zeroth = w * (p.value + w * (p.slope / 2 + w * (p.square / 3 + w * p.cube / 4)));
    const Extended first = w * w * (p.value / 2 + w * (p.slope / 3 + w * (p.square / 4 + w * p.cube / 5)));
    load += 2 * (p.left * zeroth + first);
  }
  if (!(load > 0))
    throw std::invalid_argument("profile '" + std::string(source) +
                                "' has no pressure: expected one > 0 away from the centre");
  for (Piece& p : pieces) {
    for (Extended* coefficient : {&p.value, &p.slope, &p.square, &p.cube}) *coefficient /= load;
  }
  return CubicPieces(std::move(pieces));
}

}  // namespace limitcurve
