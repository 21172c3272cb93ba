// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace limitcurve::stability::customary {

/// Σ aᵢ exp(−(s/bᵢ)²), three terms, least squares at evenly spaced points on [0, last]: amplitudes by a linear solve, widths by a
/// pattern search around it from (½, 1, 2)·last/5.
class GaussianSum {
 public:
  static constexpr int terms = 3;
  static constexpr int places = 101;

  GaussianSum(const std::function<double(double)>& function, double last) {
    for (int i = 0; i < places; ++i) {
      s_(i) = last * i / (places - 1);
      value_(i) = function(s_(i));
    }
    for (int k = 0; k < terms; ++k) widths_(k) = last / 10.0 * std::pow(2.0, k);
    double best = solve(widths_);
    for (double factor = 1.5; factor > 1.0005;) {
      bool better = false;
      for (int k = 0; k < terms; ++k) {
        for (const double scale : {factor, 1.0 / factor}) {
          Eigen::Array3d trial = widths_;
          trial(k) *= scale;
          const double misfit = solve(trial);
          if (misfit >= best) continue;
          best = misfit;
          widths_ = trial;
          better = true;
        }
      }
      if (!better) factor = std::sqrt(factor);
    }
    solve(widths_);
  }

  [[nodiscard]] double value(double s) const { return (amplitudes_ * (-(s / widths_).square()).exp()).sum(); }
  [[nodiscard]] double slope(double s) const {
    return (amplitudes_ * (-(s / widths_).square()).exp() * (-2.0 * s / widths_.square())).sum();
  }

 private:
  /// Finds the amplitudes for these widths; returns the residual.
  double solve(const Eigen::Array3d& widths) {
    Eigen::Matrix<double, places, terms> basis;
    for (int k = 0; k < terms; ++k) basis.col(k) = (-(s_ / widths(k)).square()).exp();
    const Eigen::Vector3d found = basis.colPivHouseholderQr().solve(value_.matrix());
    amplitudes_ = found.array();
    return (basis * found - value_.matrix()).squaredNorm();
  }

  Eigen::Array<double, places, 1> s_;
  Eigen::Array<double, places, 1> value_;
  Eigen::Array3d widths_;
  Eigen::Array3d amplitudes_;
};

}  // namespace limitcurve::stability::customary
