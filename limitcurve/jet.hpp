// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve {

/// The support function of a limit curve along one side, D(x), with its derivatives. Inside the rim x = s = c/a and D(x) = H(x, 1);
/// outside x = 1/s and D(x) = H(1, x). x ∈ [0, 1] on both. The leading component of the wrench is the force inside, the moment outside.
template <class Real>
struct Jet {
  Real value;   ///< D
  Real first;   ///< D′, the leading component
  Real second;  ///< D″ ≥ 0, how fast the leading component grows
  Real third;   ///< D‴

  [[nodiscard]] Real leading() const noexcept { return first; }
  [[nodiscard]] Real trailing(Real x) const noexcept { return value - x * first; }
};

}  // namespace limitcurve
