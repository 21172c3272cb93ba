// SPDX-License-Identifier: MIT
// A finger on the ellipse that fits the Hertz curve best, dragged until it slips, renders the fitted force limit.
#include "fit/fit.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/limitcurve.hpp"

#include <cmath>
#include <cstdio>

int main() {
  const auto fit = limitcurve::fit::fit_ellipse(limitcurve::hertz(), limitcurve::fit::Criterion::least_squares);
  limitcurve::godobject::FingerParameters parameters;
  parameters.mu = 0.5;
  parameters.stiffness = 1000.0;
  limitcurve::godobject::SoftFinger finger(fit.curve, parameters, limitcurve::godobject::Projection::radial);
  for (int step = 0; step < 100; ++step) finger.update({{1e-4 * step, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.002}, 0.0);
  const double expected = 0.5 * 2.0 * fit.curve.force_max();
  std::printf("felt %.12g N, expected %.12g N\n", finger.output().force.norm(), expected);
  return std::abs(finger.output().force.norm() - expected) < 1e-12 ? 0 : 1;
}
