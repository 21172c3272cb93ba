// SPDX-License-Identifier: MIT
#include "limitcurve/expanded_law.hpp"

#include "limitcurve/number.hpp"
#include "limitcurve/piecewise_polynomial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

namespace limitcurve {

namespace {

/// f, m and df/ds without the powers of s that they have where s → 0 and s → ∞.
using Values = std::array<double, 3>;

constexpr std::size_t inside_approaches = 2;
constexpr Extended pi = 3.141592653589793238462643383279502884L;

}  // namespace

ExpandedLaw::Place ExpandedLaw::place_of(double s) noexcept {
  // Distances from the rim keep their digits.
  if (s <= 1.0) return s <= 0.5 ? Place{0, s} : Place{1, 1.0 - s};
  const double q = 1.0 / s;
  return q <= 0.5 ? Place{3, q} : Place{2, (s - 1.0) * q};
}

ExpandedLaw::Part ExpandedLaw::part_of(Place place) const noexcept {
  const Approach& approach = approaches_[place.approach];
  constexpr double below_half = 0.5 * (1.0 - 0x1p-53);
  const double y = place.distance > below_half ? below_half : place.distance;
  // ¼ ≤ y < ½ is octave 0. A NaN falls into the last stretch, and stays one.
  constexpr std::uint64_t first_exponent = std::bit_cast<std::uint64_t>(0.25) >> 52U;
  const std::uint64_t octave = std::min<std::uint64_t>(first_exponent - (std::bit_cast<std::uint64_t>(y) >> 52U), approach.count - 1);
  const Stretch& stretch = approach.stretches[octave];
  const double x = (y * stretch.scale - stretch.offset) * static_cast<double>(stretch.parts);
  const auto last = static_cast<double>(stretch.parts - 1);
  const int part = x > 0.0 ? static_cast<int>(x < last ? x : last) : 0;
  return {stretch.first + static_cast<std::size_t>(part), 2.0 * (x - part) - 1.0};
}

UnitForces<double> ExpandedLaw::forces(double s) const noexcept {
  const Place place = place_of(s);
  const Part part = part_of(place);
  const std::uint16_t number = slots_[part.slot];
  if (number == no_piece) return law_->forces(s);
  const Piece& piece = pieces_[number];
  const auto [force, moment] = polynomial<terms, 2>(piece.wrench.data(), part.t);
  const double slope = polynomial<terms, 1>(piece.slope.data(), part.t)[0];
  if (place.approach < inside_approaches) return {s * force, moment, slope};
  const double q = 1.0 / s;
  return {force, q * moment, q * q * q * slope};
}

bool ExpandedLaw::covers(double s) const noexcept {
  return slots_[part_of(place_of(s)).slot] != no_piece;
}

/// Fills the approaches of a law.
class ExpandedLaw::Builder {
 public:
  Builder(ExpandedLaw& target, double tolerance) : target_(target), law_(*target.law_), tolerance_(tolerance) {
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) {
        const Extended angle = pi * static_cast<Extended>(j * (2 * i + 1)) / (2 * terms);
        analysis_[j][i] = (j == 0 ? 1 : 2) * std::cos(angle) / terms;
      }
    }
  }

  void build() {
    for (std::size_t i = 0; i < target_.approaches_.size(); ++i) build(i);
  }

 private:
  /// An octave is cut into no more parts, and when a law has been evaluated so often, what is left is left to it.
  static constexpr std::size_t most_parts = 8;
  static constexpr std::size_t most_evaluations = 8000;
  /// The rest of an approach is tried as one piece every so many octaves.
  static constexpr std::size_t trial = 3;

  /// After so many octaves with gaps, one after the other, so is what is left of the approach.
  static constexpr std::size_t hopeless = 3;

  void build(std::size_t number) {
    Approach& approach = target_.approaches_[number];
    std::size_t failed = 0;
    double end = 0.5;
    for (std::size_t octave = 0;; ++octave, end *= 0.5) {
      const bool last = octave == most_octaves || failed == hopeless || evaluations_ > most_evaluations;
      if (last || octave % trial == 0) {
        const auto rest = expand(number, 0.0, end);
        if (rest || last) {
          add_stretch(approach, 1.0 / end, 0.0, std::span(&rest, 1));
          return;
        }
      }
      failed = add_octave(number, 0.5 * end) ? 0 : failed + 1;
    }
  }

  /// [left, 2·left], in as few parts as keep the tolerance; whether all of them do.
  bool add_octave(std::size_t number, double left) {
    std::array<std::optional<Expansion>, most_parts> parts;
    bool good = false;
    std::size_t count = 0;
    while (!good && count < most_parts) {
      count = count == 0 ? 1 : 2 * count;
      parts.fill(std::nullopt);
      const double width = left / static_cast<double>(count);
      good = true;
      for (std::size_t i = 0; i < count && (good || count == most_parts); ++i) {
        parts[i] = expand(number, left + static_cast<double>(i) * width, left + static_cast<double>(i + 1) * width);
        good = good && parts[i].has_value();
      }
    }
    add_stretch(target_.approaches_[number], 1.0 / left, 1.0, std::span(parts).first(count));
    return good;
  }

  struct Expansion {
    Piece piece;
    double error;
  };

  void add_stretch(Approach& approach, double scale, double offset, std::span<const std::optional<Expansion>> parts) {
    approach.stretches[approach.count++] = {scale, offset, target_.slots_.size(), parts.size()};
    for (const auto& part : parts) {
      target_.slots_.push_back(part ? static_cast<std::uint16_t>(target_.pieces_.size()) : no_piece);
      if (!part) continue;
      target_.pieces_.push_back(part->piece);
      target_.error_ = std::max(target_.error_, 2.0 * part->error);
    }
  }

  /// The law at the double s that is nearest to a distance y of an approach, and that s.
  [[nodiscard]] std::pair<double, Values> sample(std::size_t number, double y) {
    ++evaluations_;
    const std::array<double, 4> places{y, 1.0 - y, 1.0 / (1.0 - y), 1.0 / std::max(y, 1e-90)};
    const double s = places[number];
    const auto [force, moment, slope] = law_.forces(s);
    if (number < inside_approaches) return {s, {s > 0.0 ? force / s : slope, moment, slope}};
    return {s, {force, s * moment, s * s * s * slope}};
  }

  /// The polynomials on [left, right], or nothing where they miss the tolerance.
  [[nodiscard]] std::optional<Expansion> expand(std::size_t number, double left, double right) {
    const double middle = 0.5 * (left + right);
    const double half = 0.5 * (right - left);
    std::array<Values, terms> samples;
    for (std::size_t i = 0; i < terms; ++i) samples[i] = sample(number, middle + half * static_cast<double>(node(2 * i + 1))).second;
    std::array<std::array<Extended, terms>, 3> series{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < terms; ++j) {
        for (std::size_t i = 0; i < terms; ++i) series[k][j] += analysis_[j][i] * samples[i][k];
      }
      // The last terms tell what is missing: no need to look where they are large.
      const auto tail = static_cast<double>(std::fabs(series[k][terms - 1]) + std::fabs(series[k][terms - 2]));
      if (!(tail <= 4.0 * tolerance_of(k) * std::fabs(samples[0][k]))) return std::nullopt;
    }
    Expansion result{{}, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Extended, terms> powers = in_powers(series[k]);
      for (std::size_t j = 0; j < terms; ++j) {
        (k < 2 ? result.piece.wrench[2 * j + k] : result.piece.slope[j]) = static_cast<double>(powers[j]);
      }
    }
    // The ends, and between the nodes.
    for (const std::size_t place : {0U, 2U, 8U, 14U, 20U, 26U, 30U, 32U}) {
      const auto [s, truth] = sample(number, middle + half * static_cast<double>(node(place)));
      const double t = (place_of(s).distance - middle) / half;
      const auto [force, moment] = polynomial<terms, 2>(result.piece.wrench.data(), t);
      const Values found{force, moment, polynomial<terms, 1>(result.piece.slope.data(), t)[0]};
      for (std::size_t k = 0; k < 3; ++k) {
        const double error = std::fabs(found[k] - truth[k]) / std::fabs(truth[k]);
        if (!(error <= tolerance_of(k))) return std::nullopt;
        if (k < 2) result.error = std::max(result.error, error);
      }
    }
    return result;
  }

  [[nodiscard]] double tolerance_of(std::size_t component) const { return component < 2 ? tolerance_ : 10.0 * tolerance_; }

  /// cos(πi/(2·terms)): the Chebyshev points at odd i.
  [[nodiscard]] static Extended node(std::size_t i) { return std::cos(pi * static_cast<Extended>(i) / (2 * terms)); }

  /// Σ cⱼTⱼ(t) in powers of t.
  [[nodiscard]] static std::array<Extended, terms> in_powers(const std::array<Extended, terms>& series) {
    std::array<Extended, terms> result{series[0]};
    std::array<Extended, terms> before{1};
    std::array<Extended, terms> now{0, 1};
    for (std::size_t j = 1; j < terms; ++j) {
      for (std::size_t k = 0; k <= j; ++k) result[k] += series[j] * now[k];
      std::array<Extended, terms> next{};
      for (std::size_t k = 0; k < terms; ++k) next[k] = (k > 0 ? 2 * now[k - 1] : 0) - before[k];
      before = now;
      now = next;
    }
    return result;
  }

  ExpandedLaw& target_;
  const PressureLaw& law_;
  double tolerance_;
  std::size_t evaluations_ = 0;
  std::array<std::array<Extended, terms>, terms> analysis_;  // of Chebyshev coefficient j, the weight of sample i
};

ExpandedLaw::ExpandedLaw(Law law, double tolerance) : law_(std::move(law)) {
  if (!(tolerance >= 1e-14 && tolerance <= 1e-3)) throw out_of_range("tolerance", tolerance, "1", "1e-14 <= tolerance <= 1e-3");
  Builder(*this, tolerance).build();
}

Law expanded(Law law) {
  if (law->has_quick_forces()) return law;
  return std::make_shared<ExpandedLaw>(std::move(law));
}

}  // namespace limitcurve
