// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"
#include "limitcurve/pressure_law.hpp"

#include <array>
#include <vector>

namespace limitcurve::patch {

/// A law's pressure projected on a line through the contact centre. t is the coordinate on the line in contact radii,
/// and G(t) = ⟨|t − x|⟩ the mean distance of the projected pressure from t. Gives the slope G′, which is odd, and N = G
/// − tG′, the integral of 2x times the projected density from |t| to the rim, which is even and 0 beyond the rim.
/// Interpolated by Chebyshev series.
class LineProfile {
 public:
  /// Throws std::invalid_argument, with the law, if its mean distance from a diameter is below 1e-4 of its radius.
  explicit LineProfile(Law law);

  struct Value {
    double slope;
    double remainder;  ///< N
  };
  /// G′ and N at t, any number; beyond `outer` they are ±1 and 0. Error of G′ and of N/N(0): `error()`.
  [[nodiscard]] Value operator()(double t) const noexcept;

  /// Where the pressure ends: 1, or more for a law without a rim.
  [[nodiscard]] double outer() const noexcept { return outer_; }
  /// Coordinates 0 ≤ t < outer where a derivative of the slope may jump, and some where it changes fast; none for the
  /// polynomials of Hertz and the flat punch.
  [[nodiscard]] const std::vector<double>& kinks() const noexcept { return kinks_; }
  [[nodiscard]] double error() const noexcept { return error_; }
  /// Whether an ellipse's integrals under this law are accurate to 1e-12 (accuracy::patch_ellipse).
  [[nodiscard]] bool is_smooth() const noexcept { return is_smooth_; }
  /// For Hertz and the flat punch: G = g[0] + g[1] t² + g[2] t⁴ in |t| ≤ 1.
  [[nodiscard]] bool is_polynomial() const noexcept { return is_polynomial_; }
  [[nodiscard]] const std::array<double, 3>& polynomial() const noexcept { return polynomial_; }
  [[nodiscard]] const Law& law() const noexcept { return law_; }

 private:
  static constexpr std::size_t order = 14;
  /// Chebyshev series of both functions on [begin, begin + 2 half].
  struct Cell {
    double begin;
    double half;
    std::array<double, order> slope;
    std::array<double, order> remainder;
  };

  /// Whether the law's own profile is `polynomial_`, to rounding.
  [[nodiscard]] bool is_its_polynomial() const noexcept;
  void tabulate(double tolerance);
  /// Adds cells until each is accurate to `tolerance`, or cannot be made so. `before` is the error of the cell being
  /// halved. Returns the largest error of the cells.
  double add_cells(double begin, double end, double tolerance, double before);
  [[nodiscard]] Value at_polynomial(double t) const noexcept;
  [[nodiscard]] static Value at(const Cell& cell, double t) noexcept;

  Law law_;
  double outer_ = 1.0;
  double mean_distance_ = 0.0;  ///< N(0) = G(0): from a diameter
  double error_ = 0.0;
  bool is_smooth_ = true;
  bool is_polynomial_ = false;
  std::array<double, 3> polynomial_{};
  std::vector<double> kinks_;
  std::vector<Cell> cells_;
};

}  // namespace limitcurve::patch
