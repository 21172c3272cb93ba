// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table/builder.hpp"

#include <array>

namespace limitcurve::table {

/// A cell under construction: D′ = Σ lᵢ uⁱ, i < nodes, and its integral D over [left, right], u = (x − left)/(right −
/// left), in extended precision.
class DraftCell {
 public:
  /// Interpolates D′ between `left` and `right` at 3 to 6 `nodes`; `start` is D at the left end. Then samples its
  /// error, until one is above `limit`.
  DraftCell(const Source& source, bool outside, std::size_t nodes, double left, double right, Extended start,
            double limit);

  /// Whether a chord may replace the interpolation of D′: next to x = 0, where D′ may begin like a root of x, and where
  /// D′ rises by rounding only.
  [[nodiscard]] bool may_be_straight() const noexcept;
  /// Replaces D′ by its chord.
  void straighten();

  [[nodiscard]] double left() const noexcept { return left_; }
  [[nodiscard]] double right() const noexcept { return right_; }
  [[nodiscard]] Extended width() const noexcept { return Extended(right_) - left_; }
  /// D at its right end.
  [[nodiscard]] Extended end() const noexcept { return support(1); }
  /// The smallest Bernstein coefficient of dD′/du. If it is ≥ 0, the cell is convex.
  [[nodiscard]] Extended least_growth() const noexcept;
  /// The largest error of both components at the samples between the nodes, the curve's own included.
  [[nodiscard]] Extended error() const noexcept;
  /// The exact D′ at the right end.
  [[nodiscard]] Extended leading_at_end() const noexcept { return samples_[nodes_ - 1].leading; }
  /// The exact curve at the nodes and between them.
  [[nodiscard]] const std::vector<Sample>& samples() const noexcept { return samples_; }

  /// Raises D at the right end by `rise`; D′ at both ends stays.
  void raise_end(Extended rise) noexcept;
  /// Whether the cell would be convex after raise_end(rise).
  [[nodiscard]] bool stays_convex(Extended rise) const noexcept;
  /// Raises D everywhere.
  void raise(Extended rise) noexcept { start_ += rise; }

  [[nodiscard]] TableCell finished() const noexcept;

 private:
  static constexpr std::size_t most_nodes = 6;

  [[nodiscard]] double place(std::size_t k) const noexcept;
  [[nodiscard]] Extended leading(Extended u) const noexcept;
  [[nodiscard]] Extended support(Extended u) const noexcept;
  [[nodiscard]] Extended error_at(const Sample& exact) const noexcept;
  void interpolate();
  void look_between(const Source& source, bool outside, double limit);

  std::size_t nodes_;
  double left_;
  double right_;
  Extended start_;
  std::array<Extended, most_nodes> coefficients_{};
  std::vector<Sample> samples_;
};

}  // namespace limitcurve::table
