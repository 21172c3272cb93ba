// SPDX-License-Identifier: MIT
// Entry "quadrature": the closed forms of the textbooks in double arithmetic, as printed, where they cancel.
#include "../failures.hpp"

#include "limitcurve/laws.hpp"
#include "sampling.hpp"
#include "truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limitcurve::stability {

namespace {

using std::numbers::pi;

/// s > 1, as printed.
double hertz_moment(double s) {
  return 3.0 / 64.0 *
         ((8.0 - 8.0 * s * s + 3.0 * std::pow(s, 4)) * std::asin(1.0 / s) +
          3.0 * (2.0 - s * s) * std::sqrt(s * s - 1.0));
}

double flat_punch_moment(double s) {
  return 0.5 * ((1.0 - s * s / 2.0) * std::asin(1.0 / s) + 0.5 * std::sqrt(s * s - 1.0));
}

double uniform_moment(double s) {
  const double k = std::comp_ellint_1(1.0 / s);
  const double e = std::comp_ellint_2(1.0 / s);
  return 4.0 * s / (9.0 * pi) * ((4.0 - 2.0 * s * s) * e + (2.0 * s * s - 5.0 + 3.0 / (s * s)) * k);
}

double cone_moment(double s) {
  const double t = std::sqrt(s * s - 1.0);
  return (1.0 / 3.0 - s * s / 2.0) * std::asin(1.0 / s) - t / 6.0 - 4.0 / 9.0 * t * t * t + 4.0 / 9.0 * s * s * s;
}

/// s < 1, as printed.
double uniform_force(double s) {
  return 4.0 / (3.0 * pi * s) * ((1.0 + s * s) * std::comp_ellint_2(s) + (s * s - 1.0) * std::comp_ellint_1(s));
}

struct PrintedForm {
  const char* law;
  double (*moment)(double s);
  Exact (*truth)(double s);
};

const std::array<PrintedForm, 4> printed_forms{
    {{"hertz", hertz_moment, [](double s) { return exact_hertz(s).moment; }},
     {"flat-punch", flat_punch_moment, [](double s) { return exact_flat_punch(s).moment; }},
     {"uniform", uniform_moment, [](double s) { return exact_power(0.0, s).moment; }},
     {"cone", cone_moment, [](double s) { return exact_cone(s).moment; }}}};

}  // namespace

Hazard moment_far_away() {
  Hazard found;
  Figure& figure = found.draw("closed_forms_far");
  const std::vector<double> cors = in_ratios(1.1, 1e8, 160);
  std::vector<double> ours(cors.size(), 0.0);
  for (const PrintedForm& form : printed_forms) {
    const Law law = parse_law(form.law);
    double worst = 0.0;
    for (std::size_t i = 0; i < cors.size(); ++i) {
      const Exact truth = form.truth(cors[i]);
      figure.add("far", form.law, cors[i], std::min(relative_error(form.moment(cors[i]), truth), 1.0));
      const double error = relative_error(law->forces(cors[i]).moment, truth);
      raise(ours[i], error);
      raise(worst, error);
    }
    const double at = 1e4;
    found.add("closed form as s → ∞", std::string(form.law) + ", as printed",
              "relative error of m at s = 1e4 (ours: s ≤ 1e8)", relative_error(form.moment(at), form.truth(at)), worst);
  }
  for (std::size_t i = 0; i < cors.size(); ++i) figure.add("far", "limitcurve", cors[i], ours[i]);
  return found;
}

Hazard force_near_the_centre() {
  double worst = 0.0;
  for (const double s : in_ratios(1e-10, 0.9, 120)) {
    raise(worst, relative_error(uniform()->forces(s).force, exact_power(0.0, s).force));
  }
  const double at = 1e-8;
  return {{{"closed form as s → 0", "uniform, as printed", "relative error of f at s = 1e-8 (ours: s ≥ 1e-10)",
            relative_error(uniform_force(at), exact_power(0.0, at).force), worst}},
          {}};
}

}  // namespace limitcurve::stability
