// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/arithmetic.hpp"

#include <limits>

namespace limitcurve {

/// A function whose root is sought, with its first two derivatives, at one place.
template <class Number>
struct Residual {
  Number value;
  Number slope;  ///< < 0 near the root
  Number curvature;
  Number rounding;  ///< below this a value is zero for all that its arithmetic can tell
};

/// The largest number of evaluations of one search. Two are the common case from a good first guess, three to six from a poor one; every
/// eighth step halves the bracket, so that 64 always come within rounding of a root.
inline constexpr int max_search_steps = 64;

/// A root counts as found where a further step would move it by less than this fraction of itself.
template <class Real>
inline constexpr Real search_tolerance = 4 * std::numeric_limits<Real>::epsilon();

#ifdef __FAST_MATH__
inline namespace fast_math {  // arithmetic.hpp
#endif

/// Finds where `residual(x)` falls through zero, x ∈ [0, 1], from ≥ 0 at 0 to ≤ 0 at 1: Halley's method from a first guess within a bracket
/// that every step narrows. Returns x; the last call of `residual` was with just this x. A search that has not converged after
/// `max_search_steps` returns its last place, which is in the bracket. NaN gives a place in [0, 1] too, never a NaN.
template <class Real, class Number, class Function>
[[nodiscard]] Number find_root(Function&& residual, Number x) noexcept {
  using namespace arithmetic;
  const Number half = Number(Real(0.5));
  Number low = Number(Real(0));
  Number high = Number(Real(1));
  for (int step = 1;; ++step) {
    const Residual<Number> at = residual(x);
    // A small slope makes a long step, not a small residual: convergence is judged by both.
    const auto searching = abs(at.value) > larger(at.rounding, Number(search_tolerance<Real>) * x * abs(at.slope));
    if (!any(searching) || step == max_search_steps) return x;
    low = select(at.value > Number(Real(0)), x, low);
    high = select(at.value > Number(Real(0)), high, x);
    Number next = x - at.value * at.slope / (at.slope * at.slope - half * at.value * at.curvature);
    // A step out of the bracket, or none (0/0), halves it; and so does every eighth, for steps may go to and fro for ever.
    const Number middle = half * (low + high);
    next = step % 8 == 0 ? middle : select(next > low, select(next < high, next, middle), middle);
    x = select(searching, next, x);
  }
}

#ifdef __FAST_MATH__
}  // namespace fast_math
#endif

}  // namespace limitcurve
