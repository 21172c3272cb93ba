// SPDX-License-Identifier: MIT
#include "limitcurve/patch/shape.hpp"

#include <algorithm>

namespace limitcurve::patch {

namespace {

/// A weighted sum of patches: powers add, and so do wrenches about the same point.
struct Sum final : Shape {
  struct Part {
    double weight;
    std::shared_ptr<const Shape> shape;
  };
  std::vector<Part> parts;

  explicit Sum(std::vector<Part> summands) : parts(std::move(summands)) {
    double heaviest = 0.0;
    for (const Part& part : parts) heaviest = std::max(heaviest, part.weight);
    double total = 0.0;
    for (Part& part : parts) total += part.weight /= heaviest;
    for (Part& part : parts) {
      part.weight /= total;
      centre.x += part.weight * part.shape->centre.x;
      centre.y += part.weight * part.shape->centre.y;
    }
    for (const Part& part : parts) {
      const PatchPoint lever = from_centre(part);
      radius = std::max(radius, std::hypot(lever.x, lever.y) + part.shape->radius);
    }
    measure_moment_ratio();
  }

  [[nodiscard]] PatchPoint from_centre(const Part& part) const noexcept {
    return {part.shape->centre.x - centre.x, part.shape->centre.y - centre.y};
  }

  /// Adds the friction of a part. Its moment is about its own centre, which is at `lever` from the reference point of the sum.
  static void add(PatchFriction& sum, double weight, const PatchFriction& friction, PatchPoint lever) noexcept {
    sum.power += weight * friction.power;
    sum.wrench.fx += weight * friction.wrench.fx;
    sum.wrench.fy += weight * friction.wrench.fy;
    sum.wrench.moment += weight * (friction.wrench.moment + lever.x * friction.wrench.fy - lever.y * friction.wrench.fx);
  }

  /// The twist of a part about its own centre.
  [[nodiscard]] static PatchTwist twist_at(const PatchTwist& twist, PatchPoint lever) noexcept {
    const PatchPoint velocity = velocity_at(twist, lever.x, lever.y);
    return {velocity.x, velocity.y, twist.omega};
  }
  static bool is_zero(const PatchTwist& twist) noexcept { return twist.vx == 0.0 && twist.vy == 0.0 && twist.omega == 0.0; }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    PatchFriction sum;
    for (const Part& part : parts) {
      const PatchPoint lever = from_centre(part);
      const PatchTwist there = twist_at(twist, lever);
      if (!is_zero(there)) add(sum, part.weight, part.shape->evaluate(there), lever);
    }
    return sum;
  }
  /// Converts a part's error, in units of its own m₀ and about its own centre, to the sum's.
  [[nodiscard]] double converted(const Part& part, double own, double lever) const noexcept {
    return part.weight * own * (1.0 + (part.shape->moment_ratio + lever) / moment_ratio);
  }
  [[nodiscard]] double error(const PatchTwist& twist) const noexcept override {
    double bound = 4.0 * epsilon;
    for (const Part& part : parts) {
      const PatchPoint lever = from_centre(part);
      const PatchTwist there = twist_at(twist, lever);
      if (!is_zero(there)) bound += converted(part, part.shape->error(there) + 2.0 * epsilon, std::hypot(lever.x, lever.y));
    }
    return bound;
  }
  [[nodiscard]] PatchFriction about_origin(const PatchTwist& twist, PatchPoint factors) const noexcept override {
    PatchFriction sum;
    sum.error = 4.0 * epsilon;
    for (const Part& part : parts) {
      const PatchFriction own = part.shape->about_origin(twist, factors);
      add(sum, part.weight, own, {0.0, 0.0});
      sum.error += converted(part, own.error, std::hypot(part.shape->centre.x, part.shape->centre.y));
    }
    return sum;
  }

  template <class Change>
  [[nodiscard]] std::shared_ptr<Shape> changed(const Change& change) const {
    std::vector<Part> there;
    for (const Part& part : parts) {
      const std::shared_ptr<const Shape> shape = change(*part.shape);
      there.push_back({part.weight, shape ? shape : part.shape});
    }
    return std::make_shared<Sum>(std::move(there));
  }
  [[nodiscard]] std::shared_ptr<Shape> moved(double x, double y) const override {
    return changed([=](const Shape& shape) { return shape.moved(x, y); });
  }
  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    return changed([=](const Shape& shape) { return shape.stretched(sx, sy); });
  }
  [[nodiscard]] std::shared_ptr<Shape> smoothed(double least_radius) const override {
    return changed([=](const Shape& shape) { return shape.smoothed(least_radius); });
  }
  [[nodiscard]] double area() const override {
    double area = 0.0;
    for (const Part& part : parts) area += part.shape->area();
    return area;
  }
  [[nodiscard]] double nanoseconds() const noexcept override {
    double sum = 0.0;
    for (const Part& part : parts) sum += part.shape->nanoseconds();
    return sum;
  }
  [[nodiscard]] std::vector<PatchPoint> concentrations() const override {
    std::vector<PatchPoint> all;
    for (const Part& part : parts) {
      all.push_back(part.shape->centre);
      for (const PatchPoint& place : part.shape->concentrations()) all.push_back(place);
    }
    return all;
  }
  [[nodiscard]] SecondMoments second_moments() const override {
    SecondMoments sum;
    for (const Part& part : parts) {
      const SecondMoments own = part.shape->second_moments();
      const PatchPoint lever = from_centre(part);
      sum.xx += part.weight * (own.xx + lever.x * lever.x);
      sum.yy += part.weight * (own.yy + lever.y * lever.y);
      sum.xy += part.weight * (own.xy + lever.x * lever.y);
    }
    return sum;
  }
};

}  // namespace

std::shared_ptr<Shape> make_sum(const std::vector<std::pair<double, std::shared_ptr<const Shape>>>& parts) {
  std::vector<Sum::Part> summands;
  for (const auto& [weight, shape] : parts) summands.push_back({weight, shape});
  return std::make_shared<Sum>(std::move(summands));
}

}  // namespace limitcurve::patch
