// SPDX-License-Identifier: MIT
#include "limitcurve/quadrature/double_exponential.hpp"

#include <limits>

namespace limitcurve {

namespace {

/// x(t) = ½(1 + tanh(½π sinh t)), told as the distances from 0 and from 1.
template <class Real>
DoubleExponentialNode<Real> node_at(Extended t) {
  constexpr Extended pi = 3.141592653589793238462643383279502884L;
  const Extended tail = std::exp(-pi * std::sinh(std::fabs(t)));
  const Extended near = tail / (1 + tail);
  const Extended far = 1 / (1 + tail);
  const Extended weight = pi * std::cosh(t) * near * far;
  const auto small = static_cast<Real>(near);
  const auto large = static_cast<Real>(far);
  return t < 0 ? DoubleExponentialNode<Real>{small, large, static_cast<Real>(weight)}
               : DoubleExponentialNode<Real>{large, small, static_cast<Real>(weight)};
}

}  // namespace

template <class Real>
const DoubleExponential<Real>& DoubleExponential<Real>::rule() {
  static const DoubleExponential shared;
  return shared;
}

template <class Real>
DoubleExponential<Real>::DoubleExponential() {
  for (int level = 0; level <= last_level; ++level) {
    const Extended step = std::ldexp(Extended(1), -level);
    // Each level adds the odd multiples of its step; level 0 has them all, its middle counted on the right.
    const int first = level == 0 ? 0 : 1;
    const int stride = level == 0 ? 1 : 2;
    for (int j = first;; j += stride) {
      const Extended t = step * j;
      const DoubleExponentialNode<Real> right = node_at<Real>(t);
      // Squares of the distance must stay normal: nothing downstream meets a subnormal. Asked so that the loop ends even
      // where long double has a narrower exponent than it claims, and both sides underflow to zero (valgrind).
      if (!(right.from_right > std::sqrt(std::numeric_limits<Real>::min()))) break;
      right_[static_cast<std::size_t>(level)].push_back(right);
      if (j > 0) left_[static_cast<std::size_t>(level)].push_back(node_at<Real>(-t));
    }
  }
}

template class DoubleExponential<double>;
template class DoubleExponential<Extended>;

}  // namespace limitcurve
