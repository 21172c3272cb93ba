// SPDX-License-Identifier: MIT
#include "patch_reference.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace limitcurve::test {

namespace {

using Wide = long double;
constexpr Wide pi = std::numbers::pi_v<Wide>;

/// ∫|y|, ∫ŷ of a pressure, y seen from the COR.
struct Means {
  Wide distance = 0;
  Wide x = 0;
  Wide y = 0;

  void add(Wide weight, const Means& other) {
    distance += weight * other.distance;
    x += weight * other.x;
    y += weight * other.y;
  }
};

/// Tanh–sinh with fixed step on [0, 1]: `integrand(from_left, from_right)`. Exact to 1e-15 for singularities at the
/// ends.
template <class Integrand>
Means integrate(const Integrand& integrand) {
  struct Node {
    Wide left;
    Wide right;
    Wide weight;
  };
  static const std::vector<Node> nodes = [] {
    constexpr Wide step = 1.0L / 20;
    std::vector<Node> made;
    for (int k = -100; k <= 100; ++k) {
      const Wide u = pi * std::sinh(k * step);
      const Node node{1 / (1 + std::exp(-u)), 1 / (1 + std::exp(u)), step * pi * std::cosh(k * step)};
      if (node.left * node.right * node.weight > 1e-26L)
        made.push_back({node.left, node.right, node.left * node.right * node.weight});
    }
    return made;
  }();
  Means sum;
  for (const Node& node : nodes) sum.add(node.weight, integrand(node.left, node.right));
  return sum;
}

PatchFriction from_means(const Means& means, const PatchTwist& twist, Wide cx, Wide cy) {
  const Wide sense = twist.omega > 0 ? 1 : -1;
  const Wide moment = means.distance + cx * means.x + cy * means.y;
  return {static_cast<double>(std::fabs(Wide(twist.omega)) * means.distance),
          {static_cast<double>(-sense * means.y), static_cast<double>(sense * means.x),
           static_cast<double>(sense * moment)},
          0.0};
}

Means at_place(Wide x, Wide y) {
  const Wide r = std::sqrt(x * x + y * y);
  return r > 0 ? Means{r, x / r, y / r} : Means{};
}

/// Integrals over the signed triangle from the COR (the origin) to the edge from (x1, y1) to (x2, y2).
Means triangle(Wide x1, Wide y1, Wide x2, Wide y2) {
  const Wide dx = x2 - x1;
  const Wide dy = y2 - y1;
  const Wide cross = x1 * y2 - x2 * y1;
  const Wide foot = std::clamp<Wide>(-(x1 * dx + y1 * dy) / (dx * dx + dy * dy), 0, 1);
  if (cross == 0) return {};
  // From the foot of the perpendicular outwards, so that a COR close to the edge is where the rule is dense.
  Means sum;
  for (const Wide reach : {-foot, 1 - foot}) {
    const Means part =
        integrate([&](Wide u, Wide) { return at_place(x1 + (foot + u * reach) * dx, y1 + (foot + u * reach) * dy); });
    sum.add(std::fabs(reach) * cross, part);
  }
  // y = s p with p on the edge: ∫ s² ds = 1/3 of |p|, ∫ s ds = 1/2 of p̂.
  return {sum.distance / 3, sum.x / 2, sum.y / 2};
}

/// The same over the signed triangle (0, p1, p2) seen from a COR far away at (cx, cy), by 20 × 20 Gauss points; and
/// ⟨p·ŷ⟩ in `moment`, which for a far COR is a small difference of what `triangle` gives.
Means far_triangle(Wide x1, Wide y1, Wide x2, Wide y2, Wide cx, Wide cy, Wide& moment) {
  using Rule = boost::math::quadrature::gauss<Wide, 20>;
  const auto place = [](std::size_t n) { return (1 + (n < 10 ? Rule::abscissa()[n] : -Rule::abscissa()[n - 10])) / 2; };
  const Wide cross = x1 * y2 - x2 * y1;
  Means sum;
  for (std::size_t j = 0; j < 20; ++j) {
    for (std::size_t k = 0; k < 20; ++k) {
      const Wide weight = cross * place(j) * Rule::weights()[j % 10] * Rule::weights()[k % 10] / 4;
      const Wide x = place(j) * (x1 + place(k) * (x2 - x1));
      const Wide y = place(j) * (y1 + place(k) * (y2 - y1));
      const Means one = at_place(x - cx, y - cy);
      sum.add(weight, one);
      moment += weight * (x * one.x + y * one.y);
    }
  }
  return sum;
}

}  // namespace

PatchFriction points_by_sum(std::span<const PatchLoad> loads, const PatchTwist& twist, PatchPoint about, double mx,
                            double my) {
  Wide total = 0;
  for (const PatchLoad& point : loads) total += point.load;
  Wide power = 0;
  Wide fx = 0;
  Wide fy = 0;
  Wide moment = 0;
  for (const PatchLoad& point : loads) {
    const Wide x = Wide(point.x) - about.x;
    const Wide y = Wide(point.y) - about.y;
    // The product has more digits than long double, and next to the COR they count.
    const Wide ux = mx * std::fma(Wide(-twist.omega), y, Wide(twist.vx));
    const Wide uy = my * std::fma(Wide(twist.omega), x, Wide(twist.vy));
    const Wide speed = std::hypot(ux, uy);
    if (speed == 0) continue;
    const Wide share = point.load / total;
    power += share * speed;
    fx += share * mx * ux / speed;
    fy += share * my * uy / speed;
    moment += share * (x * my * uy - y * mx * ux) / speed;
  }
  return {
      static_cast<double>(power), {static_cast<double>(fx), static_cast<double>(fy), static_cast<double>(moment)}, 0.0};
}

PatchFriction polygon_by_triangles(std::span<const PatchPoint> vertices, const PatchTwist& twist, PatchPoint about) {
  const Wide cx = -Wide(twist.vy) / twist.omega;
  const Wide cy = Wide(twist.vx) / twist.omega;
  Wide reach = 0;
  for (const PatchPoint& vertex : vertices)
    reach = std::max(reach, std::hypot(Wide(vertex.x) - about.x, Wide(vertex.y) - about.y));
  const bool far = std::hypot(cx, cy) > 8 * reach;
  Means sum;
  Wide moment = 0;
  Wide area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const PatchPoint& to = vertices[(i + 1) % vertices.size()];
    const Wide x1 = Wide(vertices[i].x) - about.x;
    const Wide y1 = Wide(vertices[i].y) - about.y;
    const Wide x2 = Wide(to.x) - about.x;
    const Wide y2 = Wide(to.y) - about.y;
    sum.add(1, far ? far_triangle(x1, y1, x2, y2, cx, cy, moment) : triangle(x1 - cx, y1 - cy, x2 - cx, y2 - cy));
    area += (x1 * y2 - x2 * y1) / 2;
  }
  const Means means{sum.distance / area, sum.x / area, sum.y / area};
  PatchFriction friction = from_means(means, twist, cx, cy);
  if (far) friction.wrench.moment = static_cast<double>((twist.omega > 0 ? moment : -moment) / area);
  return friction;
}

PatchFriction ellipse_by_rays(const PressureLaw& law, double a, double b, const PatchTwist& twist) {
  const Wide cx = -Wide(twist.vy) / twist.omega;
  const Wide cy = Wide(twist.vx) / twist.omega;
  const Wide tau = std::hypot(cx / a, cy / b);
  const Wide inward = std::atan2(-cy / b, -cx / a);  // in the unit disc, from the COR to the centre
  const auto& breaks = law.breaks();
  const Wide outer = breaks.back();
  const Wide exponent = law.rim_exponent();
  // ∫ R p dR and ∫ R² p dR along the ray that leaves the COR at `angle` from `inward`.
  const auto along_ray = [&](Wide angle) {
    const Wide aside = std::fabs(tau * std::sin(angle));
    const Wide start = -tau * std::cos(angle);  // place of the COR on the ray's line, from the foot of the centre
    if (aside >= outer) return std::array<Wide, 2>{};
    const auto half_chord = [&](Wide radius) { return std::sqrt((radius - aside) * (radius + aside)); };
    std::vector<Wide> cuts{std::max(start, -half_chord(outer)), half_chord(outer)};
    for (const Wide radius : breaks) {
      if (radius <= aside || radius == outer) continue;
      for (const Wide at : {-half_chord(radius), half_chord(radius)}) {
        if (at > cuts.front() && at < half_chord(outer)) cuts.push_back(at);
      }
    }
    if (0 > cuts.front()) cuts.push_back(0);
    std::sort(cuts.begin(), cuts.end());
    std::array<Wide, 2> sum{};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Wide length = cuts[i + 1] - cuts[i];
      if (length < 1e-17L) continue;
      const bool at_left = tau > outer && i == 0 && exponent != 0;
      const bool at_right = i + 2 == cuts.size() && exponent != 0;
      // rim ∝ z^{1/(1+e)} takes rim^e away; the piece is never singular at both ends, for 0 is a cut.
      const Wide power = at_left || at_right ? 1 / (1 + exponent) : 1;
      const Means piece = integrate([&](Wide left, Wide right) -> Means {
        const Wide near = length * std::pow(at_left ? left : right, power);
        const Wide far = length - near;
        const Wide from_left = at_left ? near : at_right ? far : length * left;
        const Wide from_right = at_left ? far : at_right ? near : length * right;
        const Wide s = from_left < from_right ? cuts[i] + from_left : cuts[i + 1] - from_right;
        const Wide rho = std::hypot(aside, s);
        const Wide to_right = half_chord(outer) - cuts[i + 1] + from_right;
        const Wide to_left = half_chord(outer) + cuts[i] + from_left;
        const Wide rim = to_left * to_right / (outer + rho);
        Wide pressure = law.density(RadialPosition<Extended>{rho, rim});
        if (at_left || at_right) {
          // rim^e near^{−e} is what is left, times d near/dz.
          pressure *= std::pow(rim / near, exponent) * power * std::pow(length, 1 + exponent);
        } else {
          pressure *= length * (exponent == 0 ? 1 : std::pow(rim, exponent));
        }
        if (rim <= 0 || near <= 0) return {};
        const Wide distance = s - start;
        return {pressure * distance, pressure * distance * distance, 0};
      });
      sum[0] += piece.distance;
      sum[1] += piece.x;
    }
    return sum;
  };
  // All rays: of a COR outside those that meet the disc; cut where they turn fast, at the axes, and where they touch a
  // break.
  std::vector<Wide> cuts;
  const Wide reach = tau > outer ? std::atan2(outer, std::sqrt((tau - outer) * (tau + outer))) : pi;
  for (const Wide angle : {-reach, Wide(0), reach}) cuts.push_back(angle);
  if (tau <= outer) cuts.insert(cuts.end(), {-pi / 2, pi / 2});
  for (const Wide radius : breaks) {
    if (radius == 0 || radius >= tau || radius == outer) continue;
    for (const Wide angle : {std::asin(radius / tau), pi - std::asin(radius / tau)}) {
      if (angle < reach) cuts.insert(cuts.end(), {-angle, angle});
    }
  }
  for (int k = -8; k <= 8; ++k) {
    const Wide angle = k * pi / 2 - inward;
    if (std::fabs(angle) < reach) cuts.push_back(angle);
  }
  std::sort(cuts.begin(), cuts.end());
  Means sum;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Wide length = cuts[i + 1] - cuts[i];
    if (length < 1e-12L) continue;
    const Means part = integrate([&](Wide left, Wide right) -> Means {
      const Wide angle = left < right ? cuts[i] + length * left : cuts[i + 1] - length * right;
      const auto [first, second] = along_ray(angle);
      const Wide x = a * std::cos(inward + angle);
      const Wide y = b * std::sin(inward + angle);
      const Wide k = std::hypot(x, y);
      return {k * second, x / k * first, y / k * first};
    });
    sum.add(length / pi, part);
  }
  return from_means(sum, twist, cx, cy);
}

PatchFriction image_by_squares(std::span<const double> pressures, std::size_t columns, double pixel,
                               const PatchTwist& twist) {
  Wide total = 0;
  Wide mean_x = 0;
  Wide mean_y = 0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    total += pressures[i];
    mean_x += pressures[i] * pixel * static_cast<Wide>(i % columns);
    mean_y -= pressures[i] * pixel * static_cast<Wide>(i / columns);
  }
  mean_x /= total;
  mean_y /= total;
  PatchFriction sum{};
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    if (pressures[i] == 0.0) continue;
    const auto share = static_cast<double>(pressures[i] / total);
    const auto x = static_cast<double>(pixel * static_cast<Wide>(i % columns) - mean_x);
    const auto y = static_cast<double>(-pixel * static_cast<Wide>(i / columns) - mean_y);
    const double half = pixel / 2;
    const std::array<PatchPoint, 4> corners{
        {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}};
    const auto [power, wrench, error] = polygon_by_triangles(corners, twist, {0, 0});
    sum.power += share * power;
    sum.wrench.fx += share * wrench.fx;
    sum.wrench.fy += share * wrench.fy;
    sum.wrench.moment += share * wrench.moment;
  }
  return sum;
}

double difference(const PatchWrench& one, const PatchWrench& other, double moment_ratio) {
  return std::max(std::hypot(one.fx - other.fx, one.fy - other.fy),
                  std::fabs(one.moment - other.moment) / moment_ratio);
}

double difference(const PatchFriction& one, const PatchFriction& other, double moment_ratio) {
  return std::max(std::fabs(one.power / other.power - 1.0), difference(one.wrench, other.wrench, moment_ratio));
}

}  // namespace limitcurve::test
