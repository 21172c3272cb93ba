// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

/// Unit wrenches that share neither code nor derivation with the library, in 100-digit arithmetic. At the points of
/// data/reference/limit_curve.csv they are compared with it (truth_test.cpp).
namespace limitcurve::stability {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

struct ExactWrench {
  Exact force;
  Exact moment;
};

/// p = (n+1)(1−ρ²)ⁿ P/(πa²), n > −1, at s ∈ [0, ∞) away from the rim (|s−1| ≥ 1e-3, or s = 1): hypergeometric series.
ExactWrench exact_power(double n, double s);

/// Hertz and flat punch at any s ∈ [0, 1e20]: elementary forms; 100 digits are more than their cancellation.
ExactWrench exact_hertz(double s);
ExactWrench exact_flat_punch(double s);
ExactWrench exact_cone(double s);

/// |value/exact − 1|, at least 2⁻⁵⁴, so that it can be drawn on a logarithmic axis; inf for NaN.
double relative_error(double value, const Exact& exact);

}  // namespace limitcurve::stability
