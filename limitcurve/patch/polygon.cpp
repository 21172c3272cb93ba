// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/polygon_edge.hpp"
#include "limitcurve/patch/shape.hpp"
#include "limitcurve/pressure_law.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace limitcurve::patch {

namespace {

/// With the COR beyond this many radii the closed edge integrals lose digits; Gauss quadrature on the edges does not.
constexpr double far = 3.0;

/// Gauss–Legendre's rule of 10 points on [−1, 1]. With the COR three radii away the nearest singularity lies 2.8
/// half-edges from the middle: relative error 5.5^(−20) = 2e-15 of an integral that is small itself.
struct EdgeRule {
  std::array<double, 10> place;
  std::array<double, 10> weight;

  EdgeRule() {
    using Rule = boost::math::quadrature::gauss<double, 10>;
    for (std::size_t i = 0; i < 5; ++i) {
      place[i] = -Rule::abscissa()[i];
      place[i + 5] = Rule::abscissa()[i];
      weight[i] = weight[i + 5] = 0.5 * Rule::weights()[i];
    }
  }
};

/// Uniform pressure on a simple polygon: by the divergence theorem, with y = x − c, outward normals n, d = n·y and p =
/// n·x on an edge,
///   A⟨ŷ⟩ = Σ n J,  A⟨|y|⟩ = Σ d J/3,  A⟨x·ŷ⟩ = Σ J (p/3 + ⅔ n·c),  J = ∫ |y| ds.
/// Far away |y| is replaced by q = |y| + ĉ·y = (ĉ⊥·x)²/(|y| − ĉ·y), which is small and positive. The linear function
/// that is left has known means: −ĉ in ⟨ŷ⟩, |c| in ⟨|y|⟩, none in ⟨x·ŷ⟩.
struct Polygon final : Shape {
  struct Edge {
    double x, y;    ///< first vertex, from the centre of pressure
    double tx, ty;  ///< unit vector along it, counter-clockwise: the outward normal is (ty, −tx)
    double length;
    double p;    ///< distance of its line from the centre of pressure, along the normal
    double mid;  ///< twice the coordinate of its middle along the line, from the point nearest the centre of pressure
  };
  std::vector<PatchPoint> vertices;  ///< counter-clockwise, from `base` in the coordinates of the twist
  PatchPoint base;
  PatchPoint middle;  ///< the centre of pressure, from `base`
  std::vector<Edge> edges;
  double whole_area = 0.0;
  double perimeter = 0.0;
  EdgeRule rule;

  explicit Polygon(std::vector<PatchPoint> corners, PatchPoint reference = {})
      : vertices(std::move(corners)), base(reference) {
    measure();
    if (base.x != 0.0 || base.y != 0.0) middle = {};  // but for the rounding of `base`
    centre = {base.x + middle.x, base.y + middle.y};
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      const PatchPoint& from = vertices[i];
      const PatchPoint& to = vertices[(i + 1) % count];
      const double x = from.x - middle.x;
      const double y = from.y - middle.y;
      const double dx = to.x - from.x;
      const double dy = to.y - from.y;
      const double length = std::hypot(dx, dy);
      edges.push_back({x, y, dx / length, dy / length, length, (x * dy - y * dx) / length,
                       2.0 * (x * dx + y * dy) / length + length});
      radius = std::max(radius, std::hypot(x, y));
      perimeter += length;
    }
    measure_moment_ratio();
  }

  /// Area and centre of pressure; turns the vertices counter-clockwise.
  void measure() {
    const PatchPoint front = vertices.front();
    Extended area = 0;
    Extended ax = 0;
    Extended ay = 0;
    double reach = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const PatchPoint& from = vertices[i];
      const PatchPoint& to = vertices[(i + 1) % vertices.size()];
      const Extended x1 = Extended(from.x) - front.x;
      const Extended y1 = Extended(from.y) - front.y;
      const Extended x2 = Extended(to.x) - front.x;
      const Extended y2 = Extended(to.y) - front.y;
      const Extended cross = x1 * y2 - x2 * y1;
      area += cross / 2;
      ax += cross * (x1 + x2) / 6;
      ay += cross * (y1 + y2) / 6;
      reach = std::max({reach, std::fabs(to.x - front.x), std::fabs(to.y - front.y)});
    }
    // A smaller area is rounding of the vertices.
    constexpr Extended least = 1e-12L;
    if (!(std::fabs(area) > least * reach * reach)) {
      throw std::invalid_argument("the polygon has area " + format_number(static_cast<double>(std::fabs(area))) +
                                  " m^2, expected more than 1e-12 of its extent squared");
    }
    middle = {static_cast<double>(front.x + ax / area), static_cast<double>(front.y + ay / area)};
    if (area < 0) std::reverse(vertices.begin(), vertices.end());
    whole_area = static_cast<double>(std::fabs(area));
  }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    if (only_slides(twist, radius)) return sliding(twist);
    const PatchPoint cor{-twist.vy / twist.omega, twist.vx / twist.omega};
    const double distance = std::hypot(cor.x, cor.y);
    if (distance <= far * radius) {
      const EdgeSums sums =
          pairwise(0, edges.size(), [&](std::size_t first, std::size_t last) { return near_sums(first, last, cor); });
      return from_distance(twist.omega, sums.mean / (3.0 * whole_area), {sums.gx / whole_area, sums.gy / whole_area},
                           sums.moment / whole_area);
    }
    const EdgeSums sums = pairwise(
        0, edges.size(), [&](std::size_t first, std::size_t last) { return far_sums(first, last, cor, distance); });
    return from_distance(twist.omega, distance + sums.mean / (3.0 * whole_area),
                         {sums.gx / whole_area - cor.x / distance, sums.gy / whole_area - cor.y / distance},
                         sums.moment / whole_area);
  }

  /// The sums over the edges; J of each is `integral`, n·c is `nc`.
  struct EdgeSums {
    double gx = 0.0;
    double gy = 0.0;
    double mean = 0.0;
    double moment = 0.0;

    void add(const Edge& edge, double nc, double integral) noexcept {
      gx += edge.ty * integral;
      gy -= edge.tx * integral;
      mean += (edge.p - nc) * integral;
      moment += (edge.p / 3.0 + 2.0 / 3.0 * nc) * integral;
    }
  };

  /// `sums(first, last)` of short runs of edges, added in pairs: rounding grows with log n, not with n.
  template <class Sums>
  static EdgeSums pairwise(std::size_t first, std::size_t last, const Sums& sums) noexcept {
    constexpr std::size_t short_run = 16;
    if (last - first <= short_run) return sums(first, last);
    const std::size_t middle = first + (last - first) / 2;
    const EdgeSums one = pairwise(first, middle, sums);
    const EdgeSums other = pairwise(middle, last, sums);
    return {one.gx + other.gx, one.gy + other.gy, one.mean + other.mean, one.moment + other.moment};
  }

  [[nodiscard]] EdgeSums near_sums(std::size_t first, std::size_t last, PatchPoint cor) const noexcept {
    const auto distance_of = [&](const Edge& edge) {
      const double x = edge.x - cor.x;
      const double y = edge.y - cor.y;
      return std::sqrt(x * x + y * y);
    };
    EdgeSums sums;
    double next = distance_of(edges[first]);
    for (std::size_t i = first; i < last; ++i) {
      const Edge& edge = edges[i];
      const double here = next;
      next = distance_of(edges[i + 1 < edges.size() ? i + 1 : 0]);
      const double nc = edge.ty * cor.x - edge.tx * cor.y;
      const double along = edge.mid - 2.0 * (edge.tx * cor.x + edge.ty * cor.y);
      sums.add(edge, nc, edge_integral(here, next, edge.length, along, edge.p - nc));
    }
    return sums;
  }

  [[nodiscard]] EdgeSums far_sums(std::size_t first, std::size_t last, PatchPoint cor, double distance) const noexcept {
    const double cx = cor.x / distance;
    const double cy = cor.y / distance;
    EdgeSums sums;
    for (std::size_t i = first; i < last; ++i) {
      const Edge& edge = edges[i];
      const double half = 0.5 * edge.length;
      std::array<double, 10> terms;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const double s = half * (1.0 + rule.place[k]);
        const double x = edge.x + s * edge.tx;
        const double y = edge.y + s * edge.ty;
        const double gap = distance - (cx * x + cy * y);  // −ĉ·y
        const double across = cx * y - cy * x;
        const double square = across * across;
        terms[k] = rule.weight[k] * square / (std::sqrt(gap * gap + square) + gap);
      }
      double integral = 0.0;
      for (const double term : terms) integral += term;
      sums.add(edge, edge.ty * cor.x - edge.tx * cor.y, integral * edge.length);
    }
    return sums;
  }

  [[nodiscard]] double error(const PatchTwist& twist) const noexcept override {
    const double speed = std::hypot(twist.vx, twist.vy);
    const double spin = std::fabs(twist.omega);
    const double reach = speed <= far * radius * spin ? radius + speed / spin : 2.0 * radius;
    return epsilon * (16.0 + perimeter * reach * reach / (whole_area * moment_ratio));
  }

  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    std::vector<PatchPoint> there = vertices;
    // From the centre: far from the origin the products would lose the digits of the shape.
    for (PatchPoint& vertex : there) vertex = {(vertex.x - middle.x) * sx, (vertex.y - middle.y) * sy};
    return std::make_shared<Polygon>(std::move(there), PatchPoint{centre.x * sx, centre.y * sy});
  }
  [[nodiscard]] double area() const override { return whole_area; }
  [[nodiscard]] double nanoseconds() const noexcept override { return 10.0 + 16.0 * static_cast<double>(edges.size()); }
};

bool same(const PatchPoint& one, const PatchPoint& other) {
  return one.x == other.x && one.y == other.y;
}

}  // namespace

std::shared_ptr<Shape> make_polygon(std::span<const PatchPoint> vertices) {
  const auto fits = [](double coordinate) { return std::fabs(coordinate) <= most_length; };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::string place = "vertex " + std::to_string(i + 1) + ": ";
    if (!fits(vertices[i].x))
      throw std::invalid_argument(place + out_of_range("x", vertices[i].x, "m", "-1e100 <= x <= 1e100").what());
    if (!fits(vertices[i].y))
      throw std::invalid_argument(place + out_of_range("y", vertices[i].y, "m", "-1e100 <= y <= 1e100").what());
    if (i > 0 && same(vertices[i], vertices[i - 1])) {
      throw std::invalid_argument(place + "equal to vertex " + std::to_string(i) + ", expected another place");
    }
  }
  if (vertices.size() > 3 && same(vertices.front(), vertices.back())) vertices = vertices.first(vertices.size() - 1);
  if (vertices.size() < 3) {
    throw std::invalid_argument("a polygon of " + std::to_string(vertices.size()) + " vertices, expected at least 3");
  }
  require_size(vertices);
  check_simple(vertices);
  return std::make_shared<Polygon>(std::vector<PatchPoint>(vertices.begin(), vertices.end()));
}

}  // namespace limitcurve::patch
