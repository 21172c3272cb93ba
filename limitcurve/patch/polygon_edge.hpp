// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limitcurve::patch {

/// J = ∫ r ds along a straight edge of length ℓ > 0; r is the distance from the COR. r₁ and r₂ are the distances of the
/// ends, d that of the line, and `along` is s₁ + s₂, the ends' coordinates along the line from the point nearest the
/// COR. Every term is positive:
///   J = ½[s₂r₂ − s₁r₁ + d² ln((r₁ + r₂ + ℓ)/(r₁ + r₂ − ℓ))],  s₂r₂ − s₁r₁ = ½ℓ[(r₁ + r₂) + (s₁ + s₂)²/(r₁ + r₂)].
[[nodiscard]] inline double edge_integral(double r1, double r2, double length, double along, double d) noexcept {
  const double sum = r1 + r2;
  const double excess = sum - length;
  // With the COR on the edge d² ln(…) tends to 0.
  const double logarithm = excess > 0.0 ? d * d * std::log1p(2.0 * length / excess) : 0.0;
  return 0.5 * (0.5 * length * (sum + along * along / sum) + logarithm);
}

}  // namespace limitcurve::patch
