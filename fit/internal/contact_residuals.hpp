// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/least_squares.hpp"
#include "fit/internal/unit_curve.hpp"
#include "fit/measurements.hpp"

#include <span>
#include <vector>

namespace limitcurve::fit::internal {

/// Samples in units of their errors, as input of the residuals.
struct WeightedSample {
  double force;        ///< |F|/σ_F
  double moment;       ///< |M|/σ_M; the curve is symmetric, so signs do not matter
  double load_force;   ///< P/σ_F
  double load_moment;  ///< P/σ_M
  double log_load;     ///< ln(P/P₀), P₀ the reference load
};

/// Layout of the parameter vector; log μ and log μ_r come first.
struct ContactLayout {
  bool shape = false;
  bool gamma = false;
  double fixed_gamma = 0.0;
  [[nodiscard]] std::size_t size() const noexcept { return 2 + (shape ? 1 : 0) + (gamma ? 1 : 0); }
  [[nodiscard]] std::size_t gamma_place() const noexcept { return shape ? 3 : 2; }
};

/// Signed distance of each sample from the curve q(t) = (μ P x(t)/σ_F, μ_r P (P/P₀)^γ y(t)/σ_M), positive outside:
///   d = (sample − q(t*))·N, where N is the outward unit normal at the closest point t*.
/// Because t* minimises the distance, its derivative vanishes: ∂d/∂θ = −N·∂q/∂θ at fixed t*.
/// Errors of variance σ² along a curve of curvature κ move samples outwards by about κσ²/2 on average; `expect_drift`
/// subtracts that.
class ContactResiduals final : public ResidualModel {
 public:
  ContactResiduals(std::span<const WeightedSample> samples, UnitCurve& curve, ContactLayout layout);
  std::size_t count() const noexcept override { return samples_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override;

  /// From now on subtracts from each residual its mean at its closest point for `parameters`: that of errors of ±σ
  /// along the tangent.
  void expect_drift(std::span<const double> parameters, double variance);

  /// The ray through the origin on which slips about one centre of rotation lie, where it fits best.
  struct Ray {
    double ratio;           ///< moment/force [m] at the reference load
    double relative_error;  ///< of the ratio, for residuals of variance 1
    double correlation;     ///< of moment/load with force/load: negative where slips spread along the curve
    std::vector<double> distances;
  };
  [[nodiscard]] Ray common_ray(std::span<const double> parameters) const;

 private:
  [[nodiscard]] PlanePoint scale_of(const WeightedSample& sample, std::span<const double> parameters) const noexcept;
  [[nodiscard]] double closest(PlanePoint sample, PlanePoint scale, double start) const noexcept;

  std::span<const WeightedSample> samples_;
  UnitCurve& curve_;
  ContactLayout layout_;
  /// Last closest point of each sample, a good start for the next; negative: none yet.
  mutable std::vector<double> last_;
  std::vector<double> drift_;
};

}  // namespace limitcurve::fit::internal
