// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/quadrature/cubic_pieces.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace limitcurve {

namespace {

using Piece = CubicPieces::Piece;

/// Monotone cubic through samples of increasing radius: slopes by the weighted harmonic mean of the neighbouring chords,
/// zero where they change sign (Fritsch and Butland 1984); one-sided at the ends, limited alike.
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

  /// Slope of the parabola through three points, limited so that the cubic does not overshoot: the sign of the chord, at most three times
  /// its size.
  static Extended end_slope(Extended chord, Extended next, Extended width, Extended next_width) {
    const Extended slope = ((2 * width + next_width) * chord - width * next) / (width + next_width);
    if (!(slope * chord > 0)) return 0;
    return std::fabs(slope) > 3 * std::fabs(chord) ? 3 * chord : slope;
  }

  std::span<const PressureSample> run_;
};

/// A measured profile as cubics that carry the unit load.
CubicPieces cubics(std::span<const PressureSample> profile, std::string_view source) {
  std::vector<PressureSample> scaled;
  const double outer = profile.back().radius;
  for (const PressureSample& sample : profile) scaled.push_back({sample.radius / outer, std::max(sample.pressure, 0.0)});
  if (scaled.front().radius > 0.0) scaled.insert(scaled.begin(), {0.0, scaled.front().pressure});
  std::vector<Piece> pieces;
  // Jumps divide the profile into runs.
  for (std::size_t begin = 0; begin < scaled.size();) {
    std::size_t end = begin + 1;
    while (end < scaled.size() && scaled[end].radius > scaled[end - 1].radius) ++end;
    MonotoneCubic(std::span(scaled).subspan(begin, end - begin)).append_to(pieces);
    begin = end;
  }
  // ∫ 2ρ p dρ of a cubic, piece by piece: exact.
  Extended load = 0;
  for (const Piece& p : pieces) {
    const Extended w = p.width;
    const Extended zeroth = w * (p.value + w * (p.slope / 2 + w * (p.square / 3 + w * p.cube / 4)));
    const Extended first = w * w * (p.value / 2 + w * (p.slope / 3 + w * (p.square / 4 + w * p.cube / 5)));
    load += 2 * (p.left * zeroth + first);
  }
  if (!(load > 0))
    throw std::invalid_argument("profile '" + std::string(source) + "' has no pressure: expected one > 0 away from the centre");
  for (Piece& p : pieces) {
    for (Extended* coefficient : {&p.value, &p.slope, &p.square, &p.cube}) *coefficient /= load;
  }
  return CubicPieces(std::move(pieces));
}

/// Indices in `rows` of the samples, without rows that repeat the one before.
std::vector<std::size_t> places_of_samples(std::span<const PressureSample> rows) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].radius != rows[i - 1].radius || rows[i].pressure != rows[i - 1].pressure) places.push_back(i);
  }
  return places;
}

/// The profile with an interpolation error: a bound of the change of the wrench if samples are left out (`coarser`). With g' the law of those
/// that stay and δ = |g − g'|, and because the kernels of force and moment are at most min(1, s/ρ) and ρ·min(1, ρ/s):
///   |Δf| ≤ min(∫ 2ρδ dρ, s ∫ 2δ dρ),  |Δm| ≤ min(∫ 2ρ²δ dρ, s⁻¹ ∫ 2ρ³δ dρ).
/// The difference of both wrenches would be no estimate: it changes sign, and is 0 at some s.
class SamplesLaw final : public PressureLawOf<SamplesLaw> {
 public:
  SamplesLaw(std::span<const PressureSample> profile, std::string_view source) : source_(source), pieces_(cubics(profile, source)) {
    for (const Piece& piece : pieces_.pieces()) breaks_.push_back(piece.left);
    breaks_.push_back(1);
    const CubicPieces coarse = cubics(coarser(profile), source);
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
      // The midpoint rule suffices: the integrand is an absolute value with kinks, and an estimate needs few digits.
      constexpr int parts = 16;
      const double width = static_cast<double>(breaks_[i + 1] - breaks_[i]) / parts;
      for (int k = 0; k < parts; ++k) {
        const double rho = static_cast<double>(breaks_[i]) + (k + 0.5) * width;
        double fraction = 2.0 * width * std::fabs(pieces_(rho) - coarse(rho));
        for (double& moment : distance_) {
          moment += fraction;
          fraction *= rho;
        }
      }
    }
  }

  std::string name() const override { return "samples:" + source_; }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return pieces_(at.radius);
  }

  UnitForces<double> forces(double s, Slope slope) const noexcept override { return evaluators::ring(pieces_, s, slope).forces; }
  Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override { return evaluators::ring(pieces_, s, slope); }
  Quadrature<double> line_profile(double t) const noexcept override { return evaluators::line_profile(pieces_, t); }
  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    s = std::fabs(s);
    WrenchEstimate estimate =
        method == Method::automatic ? evaluators::rounded(unrounded(s, Slope::wanted)) : PressureLaw::evaluate(s, method);
    estimate.error.force += std::min(distance_[1], s * distance_[0]);
    estimate.error.moment += std::min(distance_[2], distance_[3] / s);
    return estimate;
  }
  double profile_error() const noexcept override { return std::max(distance_[1], distance_[2]); }

 private:
  /// The profile with samples left out, so that each gap is about twice as wide as the widest gap of the profile within it, or wider: of even
  /// radii every other sample. A narrow gap beside a wide one tells nothing about it. The ends of each run between jumps stay; gaps are merged from
  /// the run's outer end, and what is left at its inner end joins the last. A run with a gap wider than a third of it has too little to
  /// compare with: it becomes constant at its highest pressure, which is as far from it as any profile that does not overshoot.
  static std::vector<PressureSample> coarser(std::span<const PressureSample> profile) {
    constexpr double about_twice = 1.8;
    constexpr double rounding = 1e-9;  // of radii that are meant to be even
    std::vector<PressureSample> kept;
    for (std::size_t begin = 0; begin < profile.size();) {
      std::size_t last = begin;
      while (last + 1 < profile.size() && profile[last + 1].radius > profile[last].radius) ++last;
      std::vector<std::size_t> places{last};
      double widest = 0.0;
      double widest_of_run = 0.0;
      double highest = profile[last].pressure;
      for (std::size_t i = last; i-- > begin;) {
        widest = std::max(widest, profile[i + 1].radius - profile[i].radius);
        widest_of_run = std::max(widest, widest_of_run);
        highest = std::max(highest, profile[i].pressure);
        if (profile[places.back()].radius - profile[i].radius < about_twice * widest) continue;
        places.push_back(i);
        widest = 0.0;
      }
      const PressureSample& inner = profile[begin];
      const PressureSample& outer = profile[last];
      if (3.0 * widest_of_run > (1.0 + rounding) * (outer.radius - inner.radius)) {
        kept.insert(kept.end(), {{inner.radius, highest}, {outer.radius, highest}});
      } else {
        places.back() = begin;
        for (auto place = places.rbegin(); place != places.rend(); ++place) kept.push_back(profile[*place]);
      }
      begin = last + 1;
    }
    return kept;
  }

  std::string source_;
  CubicPieces pieces_;
  std::vector<Extended> breaks_;
  std::array<double, 4> distance_{};  // ∫ 2ρᵏδ dρ, k = 0 … 3
};

}  // namespace

Law samples(std::span<const PressureSample> rows, std::string_view source) {
  const std::vector<std::size_t> places = places_of_samples(rows);
  std::vector<PressureSample> profile;
  for (const std::size_t place : places) profile.push_back(rows[place]);
  const auto refuse = [&](std::size_t i, const std::string& what) {
    return std::invalid_argument("profile '" + std::string(source) + "', sample " + std::to_string(places[i] + 1) + " (radius " +
                                 format_number(profile[i].radius) + ", pressure " + format_number(profile[i].pressure) + "): " + what);
  };
  if (profile.size() < 4) {
    throw std::invalid_argument("profile '" + std::string(source) + "' has " + std::to_string(profile.size()) +
                                " samples: expected at least 4");
  }
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!std::isfinite(profile[i].radius) || !std::isfinite(profile[i].pressure)) throw refuse(i, "expected finite numbers");
    if (profile[i].radius < 0.0) throw refuse(i, "expected a radius >= 0");
    if (i > 0 && profile[i].radius < profile[i - 1].radius) throw refuse(i, "expected radii that do not decrease");
    if (i > 1 && profile[i].radius == profile[i - 2].radius) throw refuse(i, "expected at most two pressures at one radius");
  }
  // For a smaller gap the coefficients of the cubic may overflow.
  const double least_gap = 1e-9 * profile.back().radius;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double gap = profile[i].radius - (i > 0 ? profile[i - 1].radius : 0.0);
    if (gap > 0.0 && gap < least_gap)
      throw refuse(i, "expected a radius equal to the one before, or larger by at least 1e-9 of the last radius");
  }
  if (!(profile.back().radius > profile.front().radius)) throw refuse(profile.size() - 1, "expected a last radius > the first");
  if (profile[profile.size() - 2].radius == profile.back().radius)
    throw refuse(profile.size() - 1, "a jump at the last radius, expected one pressure there");
  // The contact ends where its pressure does: a sensor's line goes on.
  const auto inner = [&]() -> const PressureSample& { return profile[profile.size() - 2]; };
  while (profile.back().pressure <= 0.0 && inner().pressure <= 0.0 && inner().radius > profile.front().radius) profile.pop_back();
  if (profile.back().radius == inner().radius) profile.pop_back();
  return std::make_shared<SamplesLaw>(profile, source);
}

}  // namespace limitcurve
