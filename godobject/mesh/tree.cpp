// SPDX-License-Identifier: MIT
#include "godobject/mesh/tree.hpp"

#include <limits>
#include <numeric>

namespace limitcurve::godobject {

Tree::Tree(std::span<const Eigen::Vector3d> vertices, std::span<const Face> faces) : order_(faces.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(faces.size() + 1);
  nodes_.push_back({});
  split(0, vertices, faces, 0, static_cast<int>(faces.size()));
  nodes_.shrink_to_fit();
}

void Tree::split(int node, std::span<const Eigen::Vector3d> vertices, std::span<const Face> faces, int first, int count) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  Eigen::Vector3d centre_low = low;
  Eigen::Vector3d centre_high = high;
  const auto face_at = [&](int which) -> const Face& { return faces[static_cast<std::size_t>(which)]; };
  const auto vertex = [&](int which) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(which)]; };
  const auto middle = [&](int which) -> Eigen::Vector3d {
    const Face& face = face_at(which);
    return vertex(face[0]) + vertex(face[1]) + vertex(face[2]);
  };
  for (int i = first; i < first + count; ++i) {
    const int which = order_[static_cast<std::size_t>(i)];
    for (const int corner : face_at(which)) {
      low = low.cwiseMin(vertex(corner));
      high = high.cwiseMax(vertex(corner));
    }
    centre_low = centre_low.cwiseMin(middle(which));
    centre_high = centre_high.cwiseMax(middle(which));
  }
  Node& here = nodes_[static_cast<std::size_t>(node)];
  here = {low, high, first, count};
  if (count <= leaf_size) return;
  int axis = 0;
  (centre_high - centre_low).maxCoeff(&axis);
  const int half = count / 2;
  const auto begin = order_.begin() + first;
  // Equal middles are sorted by index, so that the tree is the same on every machine.
  std::nth_element(begin, begin + half, begin + count, [&](int one, int other) {
    const double difference = middle(one)[axis] - middle(other)[axis];
    return difference != 0.0 ? difference < 0.0 : one < other;
  });
  const int children = static_cast<int>(nodes_.size());
  here.first = children;
  here.count = 0;
  nodes_.push_back({});
  nodes_.push_back({});
  split(children, vertices, faces, first, half);
  split(children + 1, vertices, faces, first + half, count - half);
}

}  // namespace limitcurve::godobject
