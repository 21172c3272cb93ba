// SPDX-License-Identifier: MIT
#include "limitcurve/patch/patch.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/patch/shape.hpp"

#include <algorithm>
#include <stdexcept>

namespace limitcurve {

namespace {

double checked_length(const char* name, double length) {
  if (!(length >= patch::least_length && length <= patch::most_length))
    throw out_of_range(name, length, "m", "1e-100 <= length <= 1e100");
  return length;
}

/// Evaluates at a scaled twist, so that no square overflows or underflows, with the rotation as speed at `reach`. The
/// scale is a power of two, so that nothing is rounded.
template <class Evaluate>
PatchFriction scaled(const PatchTwist& twist, double reach, const Evaluate& evaluate) noexcept {
  const double size = std::max({std::fabs(twist.vx), std::fabs(twist.vy), std::fabs(twist.omega) * reach});
  constexpr double much = 1e60;
  const bool is_usual = size > 1.0 / much && size < much && std::fabs(twist.omega) < much &&
                        std::isfinite(twist.vx + twist.vy + twist.omega);
  if (is_usual) return evaluate(twist);
  if (!std::isfinite(twist.vx) || !std::isfinite(twist.vy) || !std::isfinite(twist.omega)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, {nan, nan, nan}, nan};
  }
  // ω·reach itself may overflow or underflow; the sum of the exponents does not.
  constexpr int none = std::numeric_limits<int>::min() / 2;
  const auto exponent_of = [](double x) { return x != 0.0 ? std::ilogb(x) : none; };
  const int exponent =
      std::max({exponent_of(twist.vx), exponent_of(twist.vy), exponent_of(twist.omega) + exponent_of(reach)});
  if (exponent <= none) return {};
  // A larger rate is possible only for a single point, which does not move by it.
  constexpr double most = 1e200;
  PatchFriction friction = evaluate({std::ldexp(twist.vx, -exponent), std::ldexp(twist.vy, -exponent),
                                     std::clamp(std::ldexp(twist.omega, -exponent), -most, most)});
  friction.power = std::ldexp(friction.power, exponent);
  return friction;
}

}  // namespace

namespace patch {

PatchFriction Shape::about_origin(const PatchTwist& twist, PatchPoint factors, PatchPoint middle) const noexcept {
  // Stretched only now: far from the origin the factors would round the twist by more than its part at the patch.
  const PatchPoint velocity = velocity_at(twist, middle.x, middle.y);
  const PatchTwist here{factors.x * velocity.x, factors.y * velocity.y, twist.omega};
  if (velocity.x == 0.0 && velocity.y == 0.0 && twist.omega == 0.0) return {};
  PatchFriction friction = evaluate(here);
  // Moving the reference point rounds the velocity by ε of its terms; the lever multiplies the error of the force.
  const double lever = std::hypot(centre.x, centre.y);
  const double own = error(here);
  friction.error = (own + (lever > 0.0 ? 2.0 * epsilon : 0.0)) * (1.0 + lever / moment_ratio);
  friction.wrench.moment += centre.x * friction.wrench.fy - centre.y * friction.wrench.fx;
  friction.wrench.fx *= factors.x;
  friction.wrench.fy *= factors.y;
  return friction;
}

}  // namespace patch

Patch::Patch(const std::shared_ptr<const patch::Shape>& isotropic)
    : Patch(isotropic, 1.0, 1.0, isotropic->centre, isotropic->radius) {}

Patch::Patch(std::shared_ptr<const patch::Shape> shape, double mx, double my, PatchPoint centre, double radius)
    : shape_(std::move(shape)),
      centre_(centre),
      mx_(mx),
      my_(my),
      moment_ratio_(shape_->moment_ratio),
      radius_(radius) {}

Patch Patch::points(std::span<const PatchLoad> loads) {
  return Patch(patch::make_points(loads));
}

Patch Patch::polygon(std::span<const PatchPoint> vertices) {
  return Patch(patch::make_polygon(vertices));
}

Patch Patch::rectangle(double x, double y) {
  const double right = checked_length("x", x) / 2.0;
  const double top = checked_length("y", y) / 2.0;
  const std::vector<PatchPoint> corners{{-right, -top}, {right, -top}, {right, top}, {-right, top}};
  return polygon(corners);
}

Patch Patch::ellipse(const Law& law, double a, double b) {
  return Patch(patch::make_ellipse(checked(law), checked_length("a", a), checked_length("b", b)));
}

Patch Patch::image(std::span<const double> pressures, std::size_t columns, double width, double height,
                   std::optional<double> floor) {
  return Patch(patch::make_image({pressures.begin(), pressures.end()}, columns, checked_length("pixel", width),
                                 checked_length("pixel", height), floor));
}

Patch Patch::orthotropic(double mx, double my) const {
  const auto fits = [](double factor) { return factor >= 1e-6 && factor <= 1e6; };
  if (!fits(mx)) throw out_of_range("mx", mx, "1", "1e-6 <= mx <= 1e6");
  if (!fits(my)) throw out_of_range("my", my, "1", "1e-6 <= my <= 1e6");
  if (mx == 1.0 && my == 1.0) return *this;
  return {shape_->stretched(my, mx), mx_ * mx, my_ * my, centre_, radius_};
}

Patch Patch::smoothed(double radius) const {
  auto smooth = shape_->smoothed(checked_length("radius", radius) * std::sqrt(mx_ * my_));
  if (!smooth) return *this;
  const double wider = (smooth->radius - shape_->radius) / std::min(mx_, my_);
  return {std::move(smooth), mx_, my_, centre_, radius_ + wider};
}

// Orthotropic friction: diag(mx, my)(v + ω ẑ × x) is the velocity of the point (my x, mx y) under the twist (mx v_x, my
// v_y, ω). So H is that of the stretched patch at that twist, and its gradient follows by the chain rule.
PatchFriction Patch::evaluate(const PatchTwist& twist) const noexcept {
  PatchFriction friction = scaled(twist, shape_->radius, [this](const PatchTwist& one) {
    return shape_->evaluate({mx_ * one.vx, my_ * one.vy, one.omega});
  });
  friction.wrench.fx *= mx_;
  friction.wrench.fy *= my_;
  return friction;
}

PatchFriction Patch::about_origin(const PatchTwist& twist) const noexcept {
  const double reach = shape_->radius + std::hypot(shape_->centre.x, shape_->centre.y);
  PatchFriction friction = scaled(twist, reach, [this](const PatchTwist& one) {
    return shape_->about_origin(one, {mx_, my_}, centre_);
  });
  if (mx_ != 1.0 || my_ != 1.0) friction.error = (friction.error + 2.0 * patch::epsilon) * std::max({1.0, mx_, my_});
  return friction;
}

std::vector<std::string> Patch::remarks() const {
  return shape_->law() ? shape_->law()->remarks() : shape_->remarks();
}

double Patch::nanoseconds() const noexcept {
  return shape_->nanoseconds();
}

Patch::RoundMeasures Patch::round_measures() const {
  std::vector<PatchLoad> concentrations = shape_->concentrations();
  for (PatchLoad& at : concentrations) at = {at.x / my_, at.y / mx_, at.load};
  // shape_ is stretched: divide its area by the stretch.
  return {shape_->area() / (mx_ * my_), shape_->law() ? shape_->law() : uniform(), std::move(concentrations)};
}

}  // namespace limitcurve
