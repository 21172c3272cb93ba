// SPDX-License-Identifier: MIT
#pragma once

#include "arithmetic.hpp"

#include <limits>

namespace limitcurve {

/// A function and its first two derivatives at a point x. The search finds its root.
template <class Number>
struct Residual {
  Number value;
  Number slope;  ///< < 0 near the root
  Number curvature;
  Number rounding;  ///< rounding error of `value`: a smaller value counts as zero
};

/// The largest number of evaluations in one search. A good first guess usually needs two, a poor one three to six.
inline constexpr int max_search_steps = 64;

/// The search stops when a further step would change x by less than this fraction of x.
template <class Real>
inline constexpr Real search_tolerance = 4 * std::numeric_limits<Real>::epsilon();

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// The root of `residual` in [0, 1], where residual(0) ≥ 0 and residual(1) ≤ 0: Halley's method from the first guess `x`, inside a bracket
/// that every step narrows. The last call of `residual` is at the x that is returned. After `max_search_steps` evaluations without
/// convergence the result is the last x, which is in the bracket. If `residual` returns NaN, the result is still a number in [0, 1].
template <class Real, class Number, class Function>
[[nodiscard]] Number find_root(Function&& residual, Number x) noexcept {
  using namespace arithmetic;
  const Number half = Number(Real(0.5));
  Number low = Number(Real(0));
  Number high = Number(Real(1));
  for (int step = 1;; ++step) {
    const Residual<Number> at = residual(x);
    // Compare with x times the slope, not with a constant: where the slope is small, a small value still means a long step.
    const auto searching = abs(at.value) > larger(at.rounding, Number(search_tolerance<Real>) * x * abs(at.slope));
    if (!any(searching) || step == max_search_steps) return x;
    low = select(at.value > Number(Real(0)), x, low);
    high = select(at.value > Number(Real(0)), high, x);
    Number next = x - at.value * at.slope / (at.slope * at.slope - half * at.value * at.curvature);
    // A step out of the bracket or a NaN (0/0) is replaced by bisection. So is every eighth step: Halley steps may alternate for ever.
    const Number middle = half * (low + high);
    next = step % 8 == 0 ? middle : select(next > low, select(next < high, next, middle), middle);
    x = select(searching, next, x);
  }
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve
