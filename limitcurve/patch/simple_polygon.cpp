// SPDX-License-Identifier: MIT
#include "limitcurve/patch/shape.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <iterator>
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
  // Shamos and Hoey's sweep along x: the edges that the line crosses are kept in their order along it, and only
  // neighbours there are compared. Until two edges meet the order does not change.
  const auto is_before = [](const PatchPoint& a, const PatchPoint& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  const auto first = [&](std::size_t i) { return std::min(vertex(i), vertex(i + 1), is_before); };
  const auto last = [&](std::size_t i) { return std::max(vertex(i), vertex(i + 1), is_before); };
  /// Whether edge i begins to the left of j or with it, and lies below it where both are.
  const auto starts_below = [&](std::size_t i, std::size_t j) {
    const int begins = turn(first(i), last(i), first(j));
    const int side = begins != 0 ? begins : turn(first(i), last(i), last(j));
    return side != 0 ? side > 0 : i < j;
  };
  const auto is_below = [&](std::size_t i, std::size_t j) {
    return i != j && (is_before(first(j), first(i)) ? !starts_below(j, i) : starts_below(i, j));
  };
  const auto compare = [&](std::size_t i, std::size_t j) {
    const bool neighbours = (i + 1) % count == j || (j + 1) % count == i;
    if (neighbours || !meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) return;
    throw std::invalid_argument(edge_name(std::min(i, j), count) + " meets " + edge_name(std::max(i, j), count) +
                                ", expected one ring that does not meet itself; for holes or several parts use an "
                                "image");
  };
  struct Event {
    PatchPoint at;
    bool ends;
    std::size_t edge;
  };
  std::vector<Event> events;
  for (std::size_t i = 0; i < count; ++i) events.insert(events.end(), {{first(i), false, i}, {last(i), true, i}});
  // At one point edges begin before others end: they meet there.
  std::sort(events.begin(), events.end(), [&](const Event& one, const Event& other) {
    return is_before(one.at, other.at) || (!is_before(other.at, one.at) && one.ends < other.ends);
  });
  std::set<std::size_t, decltype(is_below)> open(is_below);
  std::vector<decltype(open)::iterator> places(count);
  for (const auto& [at, ends, edge] : events) {
    if (!ends) places[edge] = open.insert(edge).first;
    const auto here = places[edge];
    const auto above = std::next(here);
    if (here != open.begin()) {
      const auto below = std::prev(here);
      compare(*below, edge);
      if (ends && above != open.end()) compare(*below, *above);
    }
    if (above != open.end()) compare(edge, *above);
    if (ends) open.erase(here);
  }
}

}  // namespace limitcurve::patch
