// SPDX-License-Identifier: MIT
#include "limitcurve/patch/shape.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace limitcurve::patch {

namespace {

/// The turn of the path a, b, c: 1 left, −1 right, 0 straight or not distinguishable from straight in extended
/// precision.
int turn(const PatchPoint& a, const PatchPoint& b, const PatchPoint& c) {
  const Extended left = (Extended(b.x) - a.x) * (Extended(c.y) - a.y);
  const Extended right = (Extended(b.y) - a.y) * (Extended(c.x) - a.x);
  const Extended rounding = 8 * std::numeric_limits<Extended>::epsilon() * (std::fabs(left) + std::fabs(right));
  const Extended cross = left - right;
  return cross > rounding ? 1 : cross < -rounding ? -1 : 0;
}

bool between(double low, double value, double high) {
  return std::min(low, high) <= value && value <= std::max(low, high);
}

bool in_box(const PatchPoint& a, const PatchPoint& point, const PatchPoint& b) {
  return between(a.x, point.x, b.x) && between(a.y, point.y, b.y);
}

/// Whether the closed segments ab and cd fraction a point.
bool meet(const PatchPoint& a, const PatchPoint& b, const PatchPoint& c, const PatchPoint& d) {
  const int c_side = turn(a, b, c);
  const int d_side = turn(a, b, d);
  const int a_side = turn(c, d, a);
  const int b_side = turn(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && in_box(a, c, b)) || (d_side == 0 && in_box(a, d, b)) || (a_side == 0 && in_box(c, a, d)) ||
         (b_side == 0 && in_box(c, b, d));
}

std::string edge_name(std::size_t i, std::size_t count) {
  return "the edge from vertex " + std::to_string(i + 1) + " to " + std::to_string((i + 1) % count + 1);
}

}  // namespace

void check_simple(std::span<const PatchPoint> vertices) {
  const std::size_t count = vertices.size();
  const auto vertex = [&](std::size_t i) -> const PatchPoint& { return vertices[i % count]; };
  for (std::size_t i = 0; i < count; ++i) {
    const PatchPoint& before = vertex(i + count - 1);
    const PatchPoint& here = vertex(i);
    const PatchPoint& after = vertex(i + 1);
    const double product = (here.x - before.x) * (after.x - here.x) + (here.y - before.y) * (after.y - here.y);
    if (turn(before, here, after) == 0 && product <= 0.0) {
      throw std::invalid_argument("vertex " + std::to_string(i + 1) +
                                  ": its two edges lie on each other and enclose no area, expected a simple polygon");
    }
  }
  // Sweep along x, edges in order of their left ends: compare an edge only with those whose range of x overlaps its
  // own.
  const auto left = [&](std::size_t i) { return std::min(vertex(i).x, vertex(i + 1).x); };
  const auto right = [&](std::size_t i) { return std::max(vertex(i).x, vertex(i + 1).x); };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) { return left(one) < left(other); });
  std::set<std::pair<double, std::size_t>> open;
  for (const std::size_t i : order) {
    while (!open.empty() && open.begin()->first < left(i)) open.erase(open.begin());
    for (const auto& [end, j] : open) {
      const bool neighbours = (i + 1) % count == j || (j + 1) % count == i;
      if (neighbours || !meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) continue;
      throw std::invalid_argument(edge_name(std::min(i, j), count) + " meets " + edge_name(std::max(i, j), count) +
                                  ", expected a polygon that does not meet itself");
    }
    open.emplace(right(i), i);
  }
}

}  // namespace limitcurve::patch
