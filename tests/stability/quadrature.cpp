// SPDX-License-Identifier: MIT
// Entry a: eq. (17) as one integral over the radius, and its closed forms, where they break.
#include "atlas.hpp"
#include "limitcurve/evaluators.hpp"
#include "limitcurve/laws.hpp"
#include "truth.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace limitcurve::stability {

namespace {

using std::numbers::pi;

/// What a customary quadrature is given: a function on [0, 1], and the accuracy asked for.
using Integrand = std::function<double(double)>;
constexpr double asked = 1e-9;

/// A rule's answer, and the error it owns up to.
struct Answer {
  double value;
  double stated_error;
};

/// The integrand of the force, 2ρg(ρ)·(2/π)·(kernel), as one writes it down: complete elliptic integrals by their modulus.
Integrand force_integrand(const std::function<double(double)>& density, double s) {
  return [density, s](double rho) {
    // Boost throws at modulus 1, so everybody keeps off it.
    const double q = std::min(std::min(rho, s) / std::max(rho, s), 1.0 - std::numeric_limits<double>::epsilon());
    if (q == 0.0) return 0.0;
    const double e = boost::math::ellint_2(q);
    const double kernel = rho <= s ? e : (e - (1.0 - q * q) * boost::math::ellint_1(q)) / q;
    return 4.0 / pi * rho * density(rho) * kernel;
  };
}

Answer by_tanh_sinh(const Integrand& integrand) {
  static boost::math::quadrature::tanh_sinh<double> rule;
  double error = 0.0;
  const double value = rule.integrate(integrand, 0.0, 1.0, asked, &error);
  return {value, error};
}

template <unsigned points>
double by_gauss(const Integrand& integrand) {
  return boost::math::quadrature::gauss<double, points>::integrate(integrand, 0.0, 1.0);
}

double by_gauss_kronrod(const Integrand& integrand) {
  return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(integrand, 0.0, 1.0, 15, asked);
}

double hertz_density(double rho) {
  return 1.5 * std::sqrt(std::max(1.0 - rho * rho, 0.0));
}

/// Where a curve is drawn that must show what happens at s = 1: evenly, the rim included.
std::vector<double> across_the_rim() {
  std::vector<double> cors;
  for (int i = 1; i <= 120; ++i) cors.push_back(i / 60.0);
  return cors;
}

/// Hazard: the centre of rotation lies under the finger, where the slope of the integrand is logarithmic.
void centre_under_the_finger(Entry& entry) {
  const Law law = hertz();
  Figure figure{"quadrature_rim", {}};
  double worst_tanh_sinh = 0.0;
  double worst_gauss = 0.0;
  double worst_ours = 0.0;
  for (const double s : across_the_rim()) {
    const Exact truth = exact_hertz(s).force;
    const Integrand integrand = force_integrand(hertz_density, s);
    const double tanh_sinh = relative_error(by_tanh_sinh(integrand).value, truth);
    const double gauss = relative_error(by_gauss<30>(integrand), truth);
    const double ours = relative_error(evaluators::ring(*law, s).forces.force, truth);
    figure.rows.push_back({"force", "tanh-sinh, not split", s, tanh_sinh});
    figure.rows.push_back({"force", "Gauss, 30 points, not split", s, gauss});
    figure.rows.push_back({"force", "Gauss-Kronrod, adaptive", s, relative_error(by_gauss_kronrod(integrand), truth)});
    figure.rows.push_back({"force", "limitcurve", s, ours});
    worst_tanh_sinh = std::max(worst_tanh_sinh, tanh_sinh);
    worst_gauss = std::max(worst_gauss, gauss);
    worst_ours = std::max(worst_ours, ours);
  }
  const std::string quantity = "relative error of f (Hertz, s ≤ 2), 1e-9 asked";
  entry.findings.push_back(
      {"COR under the finger", "tanh-sinh, not split at r = c", quantity, worst_tanh_sinh, worst_ours, "Quadrature.CentreUnderTheFinger"});
  entry.findings.push_back(
      {"COR under the finger", "Gauss, 30 points, not split", quantity, worst_gauss, worst_ours, "Quadrature.CentreUnderTheFinger"});
  entry.figures.push_back(std::move(figure));
}

}  // namespace

const Entry& quadrature() {
  static const Entry entry = [] {
    Entry made{"quadrature", {}, {}};
    centre_under_the_finger(made);
    return made;
  }();
  return entry;
}

}  // namespace limitcurve::stability
