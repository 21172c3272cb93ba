// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/triangle_list.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// A bounding-box tree of triangles, divided at the median: at most 2 nodes for each triangle, depth log2 of their number. Queries do not
/// allocate, and visit each node at most once.
class Tree {
 public:
  Tree() = default;
  Tree(std::span<const Eigen::Vector3d> vertices, std::span<const Face> faces);

  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }
  [[nodiscard]] const Eigen::Vector3d& low() const noexcept { return nodes_[0].low; }
  [[nodiscard]] const Eigen::Vector3d& high() const noexcept { return nodes_[0].high; }

  /// Calls `visit(face)` for every face whose box, grown by `margin` on all sides, meets the segment. `visit` returns the part of the
  /// segment that is still to be searched (1: all of it).
  template <class Visit>
  void along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin, Visit&& visit) const noexcept;

  /// Calls `visit(face)` for every face whose box meets the box.
  template <class Visit>
  void overlapping(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Visit&& visit) const {
    where([&](const Eigen::Vector3d& l,
              const Eigen::Vector3d& h) { return ((l - high).array() <= 0.0).all() && ((low - h).array() <= 0.0).all(); },
          visit);
  }

  /// Calls `visit(face)` for the faces in all boxes for which `meets(low, high)` is true, and true for the boxes around them.
  template <class Meets, class Visit>
  void where(Meets&& meets, Visit&& visit) const;

  /// Calls `visit(face)`, nearest boxes first, for faces whose boxes have a squared distance from the point below `bound`. `visit` returns
  /// the new bound. Stops after `node_limit` nodes.
  template <class Visit>
  void near(const Eigen::Vector3d& point, double bound, int node_limit, Visit&& visit) const noexcept;

 private:
  static constexpr int leaf_size = 4;
  static constexpr std::size_t stack_size = 64;  // more than the depth for 2^31 triangles

  struct Node {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    int first = 0;  // of its faces in order_, or of its two children
    int count = 0;  // of its faces; 0: it has children
  };

  void split(int node, std::span<const Eigen::Vector3d> vertices, std::span<const Face> faces, int first, int count);
  [[nodiscard]] double square_distance(int node, const Eigen::Vector3d& point) const noexcept {
    const Node& box = nodes_[static_cast<std::size_t>(node)];
    return (box.low - point).cwiseMax(point - box.high).cwiseMax(0.0).squaredNorm();
  }
  [[nodiscard]] const Node& at(int node) const noexcept { return nodes_[static_cast<std::size_t>(node)]; }

  std::vector<Node> nodes_;
  std::vector<int> order_;
};

template <class Visit>
void Tree::along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin, Visit&& visit) const noexcept {
  const Eigen::Vector3d way = to - from;
  const double square = way.squaredNorm();
  if (!(square > 0.0)) return;
  const Eigen::Vector3d half = 0.5 * way;
  const Eigen::Vector3d middle = from + half;
  const Eigen::Vector3d size = half.cwiseAbs();
  const Eigen::Vector3d per_way = way / square;
  double end = 1.0;
  // Separating axes: the box's three, and its edges crossed with the segment. No division, whose rounding has no bound; the margin covers
  // the other rounding.
  const auto meets = [&](const Node& node) {
    const Eigen::Vector3d extent = 0.5 * (node.high - node.low) + Eigen::Vector3d::Constant(margin);
    const Eigen::Vector3d apart = middle - 0.5 * (node.high + node.low);
    if (((apart.cwiseAbs() - extent - size).array() > 0.0).any()) return false;
    if (std::abs(apart.y() * half.z() - apart.z() * half.y()) > extent.y() * size.z() + extent.z() * size.y()) return false;
    if (std::abs(apart.z() * half.x() - apart.x() * half.z()) > extent.z() * size.x() + extent.x() * size.z()) return false;
    if (std::abs(apart.x() * half.y() - apart.y() * half.x()) > extent.x() * size.y() + extent.y() * size.x()) return false;
    return 0.5 + apart.dot(-per_way) - extent.dot(per_way.cwiseAbs()) <= end + 1e-9;
  };
  std::array<int, stack_size> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const Node& node = at(stack[--height]);
    if (!meets(node)) continue;
    if (node.count > 0) {
      for (int i = 0; i < node.count; ++i) end = std::min(end, visit(order_[static_cast<std::size_t>(node.first + i)]));
      continue;
    }
    const Node& one = at(node.first);
    const Node& other = at(node.first + 1);
    const bool one_first = (other.low + other.high - one.low - one.high).dot(way) >= 0.0;
    stack[height++] = one_first ? node.first + 1 : node.first;
    stack[height++] = one_first ? node.first : node.first + 1;
  }
}

template <class Meets, class Visit>
void Tree::where(Meets&& meets, Visit&& visit) const {
  std::array<int, stack_size> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const Node& node = at(stack[--height]);
    if (!meets(node.low, node.high)) continue;
    for (int i = 0; i < node.count; ++i) visit(order_[static_cast<std::size_t>(node.first + i)]);
    if (node.count > 0) continue;
    stack[height++] = node.first;
    stack[height++] = node.first + 1;
  }
}

template <class Visit>
void Tree::near(const Eigen::Vector3d& point, double bound, int node_limit, Visit&& visit) const noexcept {
  struct Entry {
    int node;
    double square;
  };
  std::array<Entry, stack_size> stack;
  std::size_t height = 0;
  stack[height++] = {0, square_distance(0, point)};
  for (int opened = 0; height > 0 && opened < node_limit; ++opened) {
    const Entry entry = stack[--height];
    if (!(entry.square < bound)) continue;
    const Node& node = at(entry.node);
    if (node.count > 0) {
      for (int i = 0; i < node.count; ++i) bound = std::min(bound, visit(order_[static_cast<std::size_t>(node.first + i)]));
      continue;
    }
    Entry nearer{node.first, square_distance(node.first, point)};
    Entry farther{node.first + 1, square_distance(node.first + 1, point)};
    if (farther.square < nearer.square) std::swap(nearer, farther);
    if (farther.square < bound) stack[height++] = farther;
    if (nearer.square < bound) stack[height++] = nearer;
  }
}

}  // namespace limitcurve::godobject
