// SPDX-License-Identifier: MIT
#include "fit/internal/chance.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace limitcurve::fit::internal {

using boost::math::complement;

double chi_squared_chance(double freedom, double value) {
  return boost::math::cdf(complement(boost::math::chi_squared(freedom), value));
}
double chi_squared_bound(double freedom, double chance) {
  return boost::math::quantile(complement(boost::math::chi_squared(freedom), chance));
}
double student_quantile(double freedom, double share) {
  return boost::math::quantile(boost::math::students_t(freedom), share);
}
double fisher_chance(double freedom, double spare, double ratio) {
  return boost::math::cdf(complement(boost::math::fisher_f(freedom, spare), ratio));
}

}  // namespace limitcurve::fit::internal
