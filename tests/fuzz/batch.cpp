// SPDX-License-Identifier: MIT
#include "godobject/batch.hpp"
#include "tests/fuzz/any_finger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

/// The arrays of a batch, all contacts free.
struct Arrays {
  explicit Arrays(std::size_t count) {
    for (auto& array : values) array.assign(count, 0.0);
    start.assign(count, -2.0);
  }
  ContactBatch batch() {
    auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, trend, force_x, force_y, moment] = values;
    return {x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment};
  }

  std::array<std::vector<double>, 11> values;
  std::vector<double> start;
};

/// Whether the single step takes the contact too. A batch has no state for what it refuses, and does not unwrap angles.
bool comparable(double x, double y, double angle, double depth) {
  constexpr double farthest = 1e6;
  return x * x + y * y + depth * depth + angle * angle <= farthest * farthest;
}

template <class Boundary, class Projection>
void run(fuzz::Bytes bytes, const Boundary& boundary, Projection projection) {
  FingerParameters parameters = fuzz::any_parameters(bytes);
  parameters.jump_limit = std::numeric_limits<double>::infinity();
  using Finger = SoftFinger<Boundary, Projection>;
  std::vector<Finger> fingers;
  const std::size_t count = 1 + bytes.take<std::uint8_t>() % 11U;  // whole vectors, and what is left of one
  if (fuzz::complaint_of([&] { fingers.assign(count, Finger(boundary, parameters, projection)); })) return;

  Arrays arrays(count);
  std::vector<char> follows(count, 1);
  while (bytes.left() > 0) {
    auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, trend, force_x, force_y, moment] = arrays.values;
    for (std::size_t i = 0; i < count; ++i) {
      const auto choice = bytes.take<std::uint8_t>();
      const auto raw = [&](unsigned bit) { return ((choice >> bit) & 1U) != 0; };
      const double last_angle = angle[i];
      x[i] = fuzz::any_double(bytes, raw(0), 0.02);
      if (raw(1)) y[i] = fuzz::any_double(bytes, raw(0), 0.02);
      depth[i] = fuzz::any_double(bytes, raw(2), 0.004);
      angle[i] = raw(3) ? fuzz::any_double(bytes, true, 1.0) : last_angle + fuzz::any_double(bytes, raw(4), 3.0);
      const bool usable = comparable(x[i], y[i], angle[i], depth[i]);
      const bool free = usable && !(depth[i] > 0.0);
      const bool continues = std::fabs(angle[i] - last_angle) <= std::numbers::pi;
      follows[i] = free || (follows[i] && usable && (continues || fingers[i].output().state == ContactState::free));
    }
    step(fingers.front().friction(), arrays.batch());
    for (std::size_t i = 0; i < count; ++i) {
      if (!follows[i]) continue;
      const FingerOutput& output = fingers[i].update({{x[i], y[i], 0.0}, Eigen::Vector3d::UnitZ(), depth[i]}, angle[i]);
      fuzz::require(output.state != ContactState::invalid, "the single step refuses what the batch is held against");
      fuzz::require(fuzz::same(force_x[i], output.force.x()) && fuzz::same(force_y[i], output.force.y()), "another force in the batch");
      fuzz::require(proxy_x[i] == output.proxy.x() && proxy_y[i] == output.proxy.y(), "another proxy in the batch");
      // Not by bits: unwrapping makes 0 of an angle −0.
      fuzz::require(moment[i] == output.moment, "another moment in the batch");
      fuzz::require(proxy_angle[i] == output.angle, "another angle in the batch");
      fuzz::require((arrays.start[i] >= 0.0) == (output.state == ContactState::slip), "another state in the batch");
    }
  }
}

}  // namespace

/// A batch of contacts, fed with any bits: the bits of the single step, as long as that takes the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  fuzz::with_any_boundary(bytes, [&](const auto& boundary, auto projection) { run(bytes, boundary, projection); });
  return 0;
}
