// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace limitcurve {

/// A pressure law whose `forces` are read from polynomials: for loops on a law without a closed form, whose quadrature takes 3
/// to 10 µs where this takes some 15 ns. All else, `evaluate` above all, is the law's own.
///
/// s is cut where the law's curve may be singular: at the rim, and at either end (a pressure with odd powers of ρ gives it
/// a singularity at the centre). Towards each of these the pieces halve, down to one that bears no further cut, so
/// that an exponent names the piece and nothing needs to be known of the singularity. In each, f, m and df/ds (over
/// the powers of s that they have at the ends) are interpolated at 16 Chebyshev points by the law's `forces`, and compared
/// with it between them. A piece that misses the tolerance is halved, thrice at most, and then left to the law itself.
///
/// Build: some 500 to 8000 evaluations of the law's `forces` (2 to 100 ms). Memory: 384 bytes a piece, 20 kB as a rule.
/// Built when asked for, not with every law or curve, because a fit or a table needs fewer evaluations than that.
/// Immutable, like every law; `forces` neither allocates nor loops.
class ExpandedLaw final : public PressureLaw {
 public:
  /// Relative error of f and m against the law's `forces` that a piece must keep; ten times as much in df/ds.
  static constexpr double default_tolerance = 1e-13;

  /// `tolerance` ∈ [1e-14, 1e-3].
  explicit ExpandedLaw(Law law, double tolerance = default_tolerance);

  [[nodiscard]] std::string name() const override { return law_->name(); }
  [[nodiscard]] Extended density(RadialPosition<Extended> position) const noexcept override { return law_->density(position); }
  [[nodiscard]] double density(RadialPosition<double> position) const noexcept override { return law_->density(position); }
  [[nodiscard]] Extended rim_exponent() const noexcept override { return law_->rim_exponent(); }
  [[nodiscard]] const std::vector<Extended>& breaks() const noexcept override { return law_->breaks(); }
  [[nodiscard]] bool has_polynomial_pieces() const noexcept override { return law_->has_polynomial_pieces(); }
  [[nodiscard]] std::optional<UnitForces<Extended>> closed(Extended s) const noexcept override { return law_->closed(s); }
  [[nodiscard]] std::optional<Extended> punch_density(RadialPosition<Extended> at) const noexcept override {
    return law_->punch_density(at);
  }
  [[nodiscard]] Extended punch_exponent() const noexcept override { return law_->punch_exponent(); }
  [[nodiscard]] bool allows(Method method) const noexcept override { return law_->allows(method); }
  [[nodiscard]] WrenchEstimate evaluate(double s, Method method = Method::automatic) const noexcept override {
    return law_->evaluate(s, method);
  }

  [[nodiscard]] bool has_quick_forces() const noexcept override { return true; }
  /// Relative error of f and m: that of the law's own `forces` and at most `error()`.
  [[nodiscard]] UnitForces<double> forces(double s) const noexcept override;

  /// The largest relative difference of f and m to the law's `forces` that was found, twice.
  [[nodiscard]] double error() const noexcept { return error_; }
  /// Whether s lies in a piece; elsewhere the law itself is evaluated.
  [[nodiscard]] bool covers(double s) const noexcept;
  /// Of the pieces.
  [[nodiscard]] std::size_t bytes() const noexcept { return pieces_.size() * sizeof(Piece); }

 private:
  static constexpr std::size_t terms = 16;
  static constexpr std::size_t most_octaves = 53;  // to the last bit of 1 ± y
  static constexpr std::uint16_t no_piece = 0xFFFF;

  /// f and m side by side, as one instruction takes them; powers of the place in the piece, t ∈ [−1, 1].
  struct Piece {
    alignas(16) std::array<double, 2 * terms> wrench;
    std::array<double, terms> slope;
  };

  /// A stretch of the distance y from a singular place, u = scale·y − offset ∈ [0, 1], in equal parts.
  struct Stretch {
    double scale;
    double offset;
    std::size_t first;  ///< its first part's place in slots_
    std::size_t parts;
  };

  /// y ∈ [0, ½]: octave by octave from ½ inwards, then all that is left.
  struct Approach {
    std::array<Stretch, most_octaves + 1> stretches;
    std::size_t count = 0;
  };

  /// An approach and the distance on it.
  struct Place {
    std::size_t approach;
    double distance;
  };
  /// The part of a stretch, by its place in slots_, and t in it.
  struct Part {
    std::size_t slot;
    double t;
  };
  class Builder;

  static Place place_of(double s) noexcept;
  [[nodiscard]] Part part_of(Place place) const noexcept;

  Law law_;
  double error_ = 0.0;
  std::array<Approach, 4> approaches_;  // towards s = 0, the rim from inside, the rim from outside, s = ∞
  std::vector<std::uint16_t> slots_;    // of each part its piece's number, or no_piece
  std::vector<Piece> pieces_;
};

/// The law with `forces` by polynomials, unless they are quick as they are.
Law expanded(Law law);

}  // namespace limitcurve
