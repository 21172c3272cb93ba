// SPDX-License-Identifier: MIT
#include "fit/internal/unit_curve.hpp"

#include <cmath>
#include <utility>

namespace limitcurve::fit::internal {

namespace {

/// A curve given by its gauge γ(x, y), in polar angle: point (cos φ, sin φ)/γ, tangent (−γ_y, γ_x), and
/// d(point)/dβ = −point·∂ln γ/∂β at fixed φ.
class PolarCurve : public UnitCurve {
 public:
  struct Gauge {
    double value;
    double x;             ///< ∂γ/∂x
    double y;             ///< ∂γ/∂y
    double log_by_shape;  ///< ∂ln γ/∂β
  };

  Place at(double t) const noexcept override {
    const PlanePoint ray = ray_at(t);
    const Gauge gauge = gauge_of(ray);
    return {{ray.x / gauge.value, ray.y / gauge.value}, {-gauge.y, gauge.x}};
  }
  PlanePoint shape_slope(double t) const noexcept override {
    const PlanePoint ray = ray_at(t);
    const Gauge gauge = gauge_of(ray);
    return ray * (-gauge.log_by_shape / gauge.value);
  }
  double guess(PlanePoint ray) const noexcept override { return std::atan2(ray.y, ray.x) / quarter_turn; }

 protected:
  virtual Gauge gauge_of(PlanePoint ray) const noexcept = 0;

 private:
  static constexpr double quarter_turn = 1.5707963267948966;
  static PlanePoint ray_at(double t) noexcept {
    // cos(π/2) may be slightly negative, and its powers would be NaN.
    return {std::fmax(std::cos(quarter_turn * t), 0.0), std::sin(quarter_turn * t)};
  }
};

/// γ = √(x² + y²).
class EllipseCurve final : public PolarCurve {
 protected:
  Gauge gauge_of(PlanePoint ray) const noexcept override { return {1.0, ray.x, ray.y, 0.0}; }
};

/// γ⁴ = Q = x⁴ + y⁴ + κx²y²; γ_x = (4x³ + 2κxy²)γ/(4Q); ∂ln γ/∂κ = x²y²/(4Q). Convex for 0 ≤ κ ≤
/// 6; κ = 2 is the ellipse.
class FlexibleCurve final : public PolarCurve {
 public:
  std::string shape_name() const override { return "kappa"; }
  double low() const noexcept override { return 0.0; }
  double high() const noexcept override { return 6.0; }
  double start() const noexcept override { return 3.0; }
  void bend(double kappa) noexcept override { kappa_ = kappa; }

 protected:
  Gauge gauge_of(PlanePoint ray) const noexcept override {
    const double x = ray.x * ray.x;
    const double y = ray.y * ray.y;
    const double fourth = x * x + y * y + kappa_ * x * y;
    const double gauge = std::sqrt(std::sqrt(fourth));
    const double scale = gauge / (2.0 * fourth);
    return {gauge, ray.x * (2.0 * x + kappa_ * y) * scale, ray.y * (2.0 * y + kappa_ * x) * scale,
            x * y / (4.0 * fourth)};
  }

 private:
  double kappa_ = 2.0;
};

/// The exact curve of a law or of a member of a family, by its Chebyshev series; t is the spin fraction u.
class LawCurve final : public UnitCurve {
 public:
  explicit LawCurve(const PressureLaw& law) : curve_(law) {}
  LawCurve(const ShapeFamily& family, std::string shape_name, double start)
      : family_(&family), shape_name_(std::move(shape_name)), start_(family.coordinate(start)) {
    bend(start_);
  }

  std::string shape_name() const override { return shape_name_; }
  double low() const noexcept override { return family_ != nullptr ? family_->low() : 0.0; }
  double high() const noexcept override { return family_ != nullptr ? family_->high() : 0.0; }
  double start() const noexcept override { return start_; }
  double parameter(double coordinate) const noexcept override {
    return family_ != nullptr ? family_->parameter(coordinate) : coordinate;
  }
  double parameter_slope(double coordinate) const noexcept override {
    return family_ != nullptr ? family_->parameter_slope(coordinate) : 1.0;
  }

  void bend(double coordinate) noexcept override {
    if (family_ == nullptr || coordinate == bent_to_) return;
    curve_ = family_->member(coordinate);
    bent_to_ = coordinate;
  }
  // The slip twist is the normal, dm/df = −s: in the normalised plane the tangent is (−m₀w, v).
  Place at(double t) const noexcept override { return {curve_.at(t), {-curve_.moment_ratio() * t, 1.0 - t}}; }
  PlanePoint shape_slope(double t) const noexcept override { return curve_.shape_slope(t); }
  double guess(PlanePoint ray) const noexcept override {
    const double sum = curve_.moment_ratio() * ray.x + ray.y;
    return sum > 0.0 ? ray.y / sum : 0.0;
  }
  double moment_ratio() const noexcept override { return curve_.moment_ratio(); }
  double moment_ratio_slope() const noexcept override { return curve_.moment_ratio_slope(); }

 private:
  const ShapeFamily* family_ = nullptr;
  std::string shape_name_;
  double start_ = 0.0;
  double bent_to_ = -1e300;
  ChebyshevCurve curve_;
};

}  // namespace

std::unique_ptr<UnitCurve> make_ellipse() {
  return std::make_unique<EllipseCurve>();
}
std::unique_ptr<UnitCurve> make_flexible() {
  return std::make_unique<FlexibleCurve>();
}
std::unique_ptr<UnitCurve> make_law(const PressureLaw& law) {
  return std::make_unique<LawCurve>(law);
}
std::unique_ptr<UnitCurve> make_family(const ShapeFamily& family, std::string shape_name, double start) {
  return std::make_unique<LawCurve>(family, std::move(shape_name), start);
}

}  // namespace limitcurve::fit::internal
