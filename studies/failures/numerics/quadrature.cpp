// SPDX-License-Identifier: MIT
// Entry "quadrature": eq. (17) as one integral over the radius, where it breaks.
#include "../failures.hpp"

#include "../../../tests/function_law.hpp"
#include "by_ring.hpp"
#include "customary_quadrature.hpp"
#include "limitcurve/laws.hpp"
#include "sampling.hpp"
#include "truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limitcurve::stability {

namespace {

double hertz_density(double rho) {
  return 1.5 * std::sqrt(std::max(1.0 - rho * rho, 0.0));
}

double our_force(const PressureLaw& law, double s) {
  return study::ByRing(law).forces(s).force;
}

}  // namespace

Hazard centre_under_the_finger() {
  Hazard found;
  const Law law = hertz();
  Figure& figure = found.draw("quadrature_rim");
  constexpr std::array series{"tanh-sinh, not split", "Gauss, 30 points, not split", "limitcurve"};
  std::array<double, 3> worst{};
  double unstated = 0.0;
  double ours_unstated = 0.0;
  const auto measure = [&](double s) {
    const Exact truth = exact_hertz(s).force;
    const customary::Function integrand = customary::force_integrand(hertz_density, s);
    const customary::Answer answer = customary::tanh_sinh(integrand);
    const std::array errors{relative_error(answer.value, truth), relative_error(customary::gauss(integrand), truth),
                            relative_error(our_force(*law, s), truth)};
    raise(worst, errors);
    // An error estimate below rounding is meaningless.
    const double error = static_cast<double>(abs(Exact(answer.value - truth)));
    if (error > 1e-14) raise(unstated, error / std::max(answer.stated_error, 1e-300));
    const WrenchEstimate estimate = law->evaluate(s, Method::ring);
    raise(ours_unstated, static_cast<double>(abs(Exact(estimate.wrench.force - truth))) / estimate.error.force);
    return errors;
  };
  constexpr int stretches = 80;
  constexpr int places = 10;
  for (int i = 0; i < stretches; ++i) {
    // Drawn is the worst of an interval. An odd fraction of it: at "round" CORs the rule's points are accidentally
    // good.
    std::array<double, 3> here{};
    for (int k = 0; k < places; ++k) {
      const std::array errors = measure(2.0 * (i + (k + 0.3717) / places) / stretches);
      raise(here, errors);
    }
    for (std::size_t j = 0; j < here.size(); ++j) figure.add("across", series[j], 2.0 * (i + 0.5) / stretches, here[j]);
  }
  for (const double distance : in_ratios(1e-15, 0.9, 60)) measure(1.0 - distance);
  const std::string quantity = "relative error of f at a requested 1e-9 (Hertz, 860 CORs)";
  found.add("COR under the finger", "Boost's tanh-sinh over the whole radius", quantity, worst[0], worst[2]);
  found.add("COR under the finger", "the same, its error estimate", "error / error stated", unstated, ours_unstated);
  found.add("COR under the finger", "Gauss, 30 points over the whole radius", quantity, worst[1], worst[2]);
  return found;
}

// The usual rules split at s, and avoid the one point where the pressure is infinite.
Hazard singular_rim() {
  Hazard found;
  Figure& figure = found.draw("quadrature_singular");
  constexpr std::array series{"tanh-sinh, split at s", "Gauss, 30 points, split at s", "limitcurve"};
  const auto errors = [](double n, double s) {
    const Exact truth = exact_power(n, s).force;
    const customary::Function density = [n](double rho) {
      return rho < 1.0 ? (n + 1.0) * std::pow(1.0 - rho * rho, n) : 0.0;
    };
    const customary::Function integrand = customary::force_integrand(density, s);
    return std::array{relative_error(customary::tanh_sinh(integrand, customary::split_at(s)).value, truth),
                      relative_error(customary::gauss(integrand, customary::split_at(s)), truth),
                      relative_error(our_force(*power(n), s), truth)};
  };
  for (const double above : in_ratios(1e-3, 1.0, 31)) {
    const auto at_place = errors(above - 1.0, 0.5);
    for (std::size_t i = 0; i < series.size(); ++i) figure.add("exponent", series[i], above, at_place[i]);
  }
  for (const double s : evenly(0.02, 2.98, 75)) {
    const auto at_place = errors(-0.9, s);
    for (std::size_t i = 0; i < series.size(); ++i) figure.add("cor", series[i], s, at_place[i]);
  }
  for (const auto& [n, name] :
       {std::pair{-0.5, "flat punch"}, std::pair{-0.9, "n = −0.9"}, std::pair{-0.99, "n = −0.99"}}) {
    std::array<double, 3> worst{};
    for (const double s : {0.1, 0.5, 0.9, 1.1, 2.0}) {
      const auto at_place = errors(n, s);
      raise(worst, at_place);
    }
    const std::string quantity = std::string("relative error of f (") + name + ", at five CORs)";
    found.add("pressure infinite at the rim", "Boost's tanh-sinh, split at s", quantity, worst[0], worst[2]);
    if (n == -0.5)
      found.add("pressure infinite at the rim", "Gauss, 30 points, split at s", quantity, worst[1], worst[2]);
  }
  return found;
}

// A sum of paraboloids with radii b has a kink at each b, and a known wrench.
Hazard kinks_of_a_profile() {
  Hazard found;
  static constexpr std::array<double, 5> radii{0.31, 0.47, 0.62, 0.83, 1.0};
  const auto pressure = []<class Real>(Real rho) {
    Real sum = 0;
    for (const Real b : radii) sum += 2 / (b * b) * std::max(1 - rho / b * (rho / b), Real(0)) / radii.size();
    return sum;
  };
  const auto truth = [](double s) {
    Exact force = 0;
    for (const double b : radii) force += exact_power(1.0, s / b).force / radii.size();
    return force;
  };
  std::vector<Extended> breaks{0};
  breaks.insert(breaks.end(), radii.begin(), radii.end());
  const test::FunctionLaw told("kinks", pressure, breaks);
  const test::FunctionLaw untold("kinks", pressure, {0, 1});
  std::array<double, 3> worst{};
  double unstated = 0.0;
  double ours_unstated = 0.0;
  for (const double s : evenly(0.0131, 1.9931, 100)) {
    const Exact exact = truth(s);
    const customary::Function integrand = customary::force_integrand([&](double rho) { return pressure(rho); }, s);
    const customary::Answer answer = customary::tanh_sinh(integrand, customary::split_at(s));
    const std::array errors{relative_error(answer.value, exact),
                            relative_error(customary::gauss(integrand, customary::split_at(s)), exact),
                            relative_error(our_force(told, s), exact)};
    raise(worst, errors);
    raise(unstated, static_cast<double>(abs(Exact(answer.value - exact))) / std::max(answer.stated_error, 1e-300));
    for (const PressureLaw* law : {&told, &untold}) {
      const WrenchEstimate estimate = law->evaluate(s, Method::ring);
      raise(ours_unstated, static_cast<double>(abs(Exact(estimate.wrench.force - exact))) / estimate.error.force);
    }
  }
  const std::string quantity = "relative error of f (a profile of five pieces, 100 CORs; ours knows the kinks)";
  const double ours = worst[2];
  found.add("kinks of a measured profile", "Boost's tanh-sinh, split at s", quantity, worst[0], ours);
  found.add("kinks of a measured profile", "the same, its error estimate",
            "error / error stated (ours also if not told)", unstated, ours_unstated);
  found.add("kinks of a measured profile", "Gauss, 30 points, split at s", quantity, worst[1], ours);
  return found;
}

}  // namespace limitcurve::stability
