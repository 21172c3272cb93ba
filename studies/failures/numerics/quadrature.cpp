// SPDX-License-Identifier: MIT
// Entry "quadrature": eq. (17) as one integral over the radius, where it breaks.
#include "../failures.hpp"

#include "../../../tests/function_law.hpp"
#include "by_ring.hpp"
#include "customary_quadrature.hpp"
#include "elliptic.hpp"
#include "limitcurve/laws.hpp"
#include "sampling.hpp"
#include "truth.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve::stability {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double hertz_density(double rho) {
  return 1.5 * std::sqrt(std::max(1.0 - rho * rho, 0.0));
}

double our_force(const PressureLaw& law, double s) {
  return study::ByRing(law).forces(s).force;
}

void raise(double& worst, double value) {
  worst = std::max(worst, value);
}

/// The error for the figure: the largest in each interval of CORs, so that accidentally good points do not hide the others.
class Envelope {
 public:
  Envelope(Figure& figure, std::string panel) : figure_(figure), panel_(std::move(panel)) {}

  void add(const std::string& series, double x, double error) {
    for (Peak& peak : peaks_) {
      if (peak.series == series) {
        raise(peak.error, error);
        peak.x = x;
        return;
      }
    }
    peaks_.push_back({series, x, error});
  }

  void close() {
    for (const Peak& peak : peaks_) figure_.rows.push_back({panel_, peak.series, peak.x, peak.error});
    peaks_.clear();
  }

 private:
  struct Peak {
    std::string series;
    double x;
    double error;
  };
  Figure& figure_;
  std::string panel_;
  std::vector<Peak> peaks_;
};

/// The value of a function that may throw.
template <class Call>
double or_nothing(const Call& call) {
  try {
    return call();
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

Hazard centre_under_the_finger() {
  Hazard found;
  const Law law = hertz();
  Figure& figure = found.figures.emplace_back(Figure{"quadrature_rim", {}});
  double tanh_sinh_worst = 0.0;
  double gauss_worst = 0.0;
  double ours_worst = 0.0;
  double unstated = 0.0;
  double ours_unstated = 0.0;
  const auto measure = [&](Envelope& envelope, double s, double x) {
    const Exact truth = exact_hertz(s).force;
    const customary::Function integrand = customary::force_integrand(hertz_density, s);
    const customary::Answer answer = customary::tanh_sinh(integrand);
    const double tanh_sinh = relative_error(answer.value, truth);
    const double gauss = relative_error(customary::gauss(integrand), truth);
    const double ours = relative_error(our_force(*law, s), truth);
    envelope.add("tanh-sinh, not split", x, tanh_sinh);
    envelope.add("Gauss, 30 points, not split", x, gauss);
    envelope.add("limitcurve", x, ours);
    raise(tanh_sinh_worst, tanh_sinh);
    raise(gauss_worst, gauss);
    raise(ours_worst, ours);
    // An error estimate below rounding is meaningless.
    const double error = static_cast<double>(abs(Exact(answer.value - truth)));
    if (error > 1e-14) raise(unstated, error / std::max(answer.stated_error, 1e-300));
    const WrenchEstimate estimate = law->evaluate(s, Method::ring);
    raise(ours_unstated, static_cast<double>(abs(Exact(estimate.wrench.force - truth))) / estimate.error.force);
  };
  constexpr int stretches = 80;
  constexpr int places = 10;
  Envelope across(figure, "across");
  for (int i = 0; i < stretches; ++i) {
    // An odd fraction of an interval: at "round" CORs the rule's points are accidentally good.
    for (int k = 0; k < places; ++k) measure(across, 2.0 * (i + (k + 0.3717) / places) / stretches, 2.0 * (i + 0.5) / stretches);
    across.close();
  }
  Envelope near(figure, "near");
  for (const double distance : in_ratios(1e-15, 0.9, 60)) {
    measure(near, 1.0 - distance, distance);
    near.close();
  }
  found.findings.push_back({"COR under the finger", "Boost's tanh-sinh over the whole radius",
                            "relative error of f at a requested 1e-9 (Hertz, at the CORs of the figure)", tanh_sinh_worst, ours_worst});
  found.findings.push_back({"COR under the finger", "the same, its error estimate", "error / error stated", unstated, ours_unstated});
  found.findings.push_back({"COR under the finger", "Gauss, 30 points over the whole radius",
                            "relative error of f (Hertz, at the CORs of the figure)", gauss_worst, ours_worst});
  return found;
}

Hazard adaptive_subdivision() {
  Hazard found;
  const Law law = parabolic();
  const customary::Function density = [](double rho) { return 2.0 * (1.0 - rho * rho); };
  double worst = 0.0;
  double ours_worst = 0.0;
  for (const double s : evenly(0.0137, 0.9937, 50)) {
    const Exact truth = exact_power(1.0, s).force;
    raise(worst, relative_error(customary::adaptive_gauss_kronrod(customary::force_integrand(density, s), 1e-14), truth));
    raise(ours_worst, relative_error(our_force(*law, s), truth));
  }
  found.findings.push_back({"COR under the finger", "adaptive Gauss–Kronrod, 15 points",
                            "relative error of f at a requested 1e-14 (parabolic, at 50 CORs)", worst, ours_worst});
  return found;
}

// The methods of the next two.
constexpr std::array series{"tanh-sinh, split at s", "Gauss, 30 points, split at s", "limitcurve"};

// The usual rules split at s, and avoid the one point where the pressure is infinite.
Hazard singular_rim() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"quadrature_singular", {}});
  const auto errors = [](double n, double s) {
    const Exact truth = exact_power(n, s).force;
    const customary::Function density = [n](double rho) { return rho < 1.0 ? (n + 1.0) * std::pow(1.0 - rho * rho, n) : 0.0; };
    const customary::Function integrand = customary::force_integrand(density, s);
    return std::array{relative_error(customary::tanh_sinh(integrand, customary::split_at(s)).value, truth),
                      relative_error(customary::gauss(integrand, customary::split_at(s)), truth),
                      relative_error(our_force(*power(n), s), truth)};
  };
  for (const double above : in_ratios(1e-3, 1.0, 31)) {
    const auto at_place = errors(above - 1.0, 0.5);
    for (std::size_t i = 0; i < series.size(); ++i) figure.rows.push_back({"exponent", series[i], above, at_place[i]});
  }
  for (const double s : evenly(0.02, 2.98, 75)) {
    const auto at_place = errors(-0.9, s);
    for (std::size_t i = 0; i < series.size(); ++i) figure.rows.push_back({"cor", series[i], s, at_place[i]});
  }
  for (const auto& [n, name] : {std::pair{-0.5, "flat punch"}, std::pair{-0.9, "n = −0.9"}, std::pair{-0.99, "n = −0.99"}}) {
    std::array<double, 3> worst{};
    for (const double s : {0.1, 0.5, 0.9, 1.1, 2.0}) {
      const auto at_place = errors(n, s);
      for (std::size_t i = 0; i < worst.size(); ++i) raise(worst[i], at_place[i]);
    }
    const std::string quantity = std::string("relative error of f (") + name + ", at five CORs)";
    found.findings.push_back({"pressure infinite at the rim", "Boost's tanh-sinh, split at s", quantity, worst[0], worst[2]});
    if (n == -0.5) found.findings.push_back({"pressure infinite at the rim", "Gauss, 30 points, split at s", quantity, worst[1], worst[2]});
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
  Figure& figure = found.figures.emplace_back(Figure{"quadrature_kinks", {}});
  std::array<double, 3> worst{};
  double unstated = 0.0;
  double ours_unstated = 0.0;
  for (const double s : evenly(0.0131, 1.9931, 100)) {
    const Exact exact = truth(s);
    const customary::Function integrand = customary::force_integrand([&](double rho) { return pressure(rho); }, s);
    const customary::Answer answer = customary::tanh_sinh(integrand, customary::split_at(s));
    const std::array errors{relative_error(answer.value, exact), relative_error(customary::gauss(integrand, customary::split_at(s)), exact),
                            relative_error(our_force(told, s), exact)};
    for (std::size_t i = 0; i < errors.size(); ++i) {
      figure.rows.push_back({"force", series[i], s, errors[i]});
      raise(worst[i], errors[i]);
    }
    raise(unstated, static_cast<double>(abs(Exact(answer.value - exact))) / std::max(answer.stated_error, 1e-300));
    for (const PressureLaw* law : {&told, &untold}) {
      const WrenchEstimate estimate = law->evaluate(s, Method::ring);
      raise(ours_unstated, static_cast<double>(abs(Exact(estimate.wrench.force - exact))) / estimate.error.force);
    }
  }
  const std::string quantity = "relative error of f (a profile of five pieces, at the CORs of the figure; ours knows the kinks)";
  const double ours = worst[2];
  found.findings.push_back({"kinks of a measured profile", "Boost's tanh-sinh, split at s", quantity, worst[0], ours});
  found.findings.push_back({"kinks of a measured profile", "the same, its error estimate", "error / error stated (ours also if not told)",
                            unstated, ours_unstated});
  found.findings.push_back({"kinks of a measured profile", "Gauss, 30 points, split at s", quantity, worst[1], ours});
  return found;
}

// Eq. (17) as printed has the modulus
// k = 2√(ρs)/(ρ+s), with complement δ², δ = |ρ−s|/(ρ+s). A quadrature graded to ρ = s goes down to δ = 1e-300.
Hazard vanishing_complement() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"quadrature_complement", {}});
  std::array<double, 3> breaks_down{};
  constexpr std::array ways{"modulus rounded", "complement squared", "limitcurve"};
  for (const double delta : in_ratios(1e-300, 0.5, 120)) {
    const Exact truth = exact_first_kind(Exact(delta) * delta);
    // q = min/max of ρ and s, and its complement 1 − q² as ours has it from the exact distance: K(k) = (1+q) K(q).
    const double q = (1.0 - delta) / (1.0 + delta);
    const double complement = 4.0 * delta / ((1.0 + delta) * (1.0 + delta));
    const std::array values{or_nothing([&] { return boost::math::ellint_1(std::sqrt((1.0 - delta) * (1.0 + delta))); }),
                            or_nothing([&] { return boost::math::ellint_rf(0.0, delta * delta, 1.0); }),
                            (1.0 + q) * study::elliptic_pair(q, complement).first_kind()};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double error = std::isfinite(values[i]) ? relative_error(values[i], truth) : infinity;
      figure.rows.push_back({"first kind", ways[i], delta, error});
      if (error > 1e-12) raise(breaks_down[i], delta);
    }
  }
  const std::string quantity = "least relative distance of ρ and s at which K is accurate to 1e-12";
  found.findings.push_back({"complement of the modulus vanishes", "Boost's K of the modulus k", quantity, breaks_down[0], breaks_down[2]});
  found.findings.push_back({"complement of the modulus vanishes", "R_F of the squared distance", quantity, breaks_down[1], breaks_down[2]});
  return found;
}

}  // namespace limitcurve::stability
