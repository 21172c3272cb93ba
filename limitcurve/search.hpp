// SPDX-License-Identifier: MIT
#pragma once

// Internal: installed because other headers need it; it may change in every version.

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

/// A step shorter than this fraction of the distance from the nearer end of [0, 1] is the last: its error is of third
/// order.
template <class Real>
inline constexpr Real last_step = sizeof(Real) == sizeof(float) ? Real(3e-4) : Real(1e-5);

/// What a search found: the x of its last evaluation, and the step from there to the root.
template <class Number>
struct Root {
  Number x;
  Number step;
};

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// The root of `residual` in [0, 1], where residual(0) ≥ 0 and residual(1) ≤ 0: Halley's method from the first guess
/// `x`, inside a bracket that every step narrows. The last call of `residual` is at the x that is returned. After
/// `max_search_steps` evaluations without convergence the result is the last x, which is in the bracket. If `residual`
/// returns NaN, the result is still a number in [0, 1].
template <class Real, class Number, class Function>
[[nodiscard]] Root<Number> find_root(Function&& residual, Number x) noexcept {
  using namespace arithmetic;
  const Number zero = Number(Real(0));
  const Number half = Number(Real(0.5));
  Number low = zero;
  Number high = Number(Real(1));
  for (int step = 1;; ++step) {
    const Residual<Number> at = residual(x);
    // Compare with x times the slope, not with a constant: where the slope is small, a small value still means a long
    // step.
    const auto searching = abs(at.value) > larger(at.rounding, Number(search_tolerance<Real>) * x * abs(at.slope));
    if (!any(searching)) return {x, zero};
    low = select(at.value > zero, x, low);
    high = select(at.value > zero, high, x);
    const Number halley = x - at.value * at.slope / (at.slope * at.slope - half * at.value * at.curvature);
    // By its length, not by its curvature, which may vanish by chance.
    const auto is_inside = halley > low && halley < high;
    const auto is_last = is_inside && abs(halley - x) <= Number(last_step<Real>) * smaller(x, Number(Real(1)) - x);
    // Lanes of a pack that are done keep their x, and with it their last step.
    const auto goes_on = searching && !is_last;
    if (!any(goes_on) || step == max_search_steps) return {x, select(searching && is_last, halley - x, zero)};
    // A step out of the bracket or a NaN (0/0) is replaced by bisection. So is every eighth step: Halley steps may
    // alternate forever.
    const Number middle = half * (low + high);
    x = select(goes_on, step % 8 == 0 ? middle : select(is_inside, halley, middle), x);
  }
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve
