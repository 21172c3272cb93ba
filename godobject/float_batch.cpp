// SPDX-License-Identifier: MIT
#include "godobject/float_batch.hpp"

#include "godobject/internal/float_loops.hpp"

namespace limitcurve::godobject::detail {

namespace {

constexpr float farthest = FloatContactBatch::farthest;

LIMITCURVE_CLONES
int count_unusable(std::size_t count, const float* __restrict x, const float* __restrict y, const float* __restrict angle,
                   const float* __restrict depth) noexcept {
  int bad = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool near = std::fabs(x[i]) <= farthest;
    const bool near_too = std::fabs(y[i]) <= farthest;
    const bool turned = std::fabs(angle[i]) <= farthest;
    const bool deep = depth[i] > farthest;
    const bool usable = near & near_too & turned & !deep;
    bad += usable ? 0 : 1;
  }
  return bad;
}

/// Ellipse and radial projection.
LIMITCURVE_CLONES
void elliptic_loop(const FloatStep& law, std::size_t count, const float* __restrict x, const float* __restrict y,
                   const float* __restrict angle, const float* __restrict depth, float* __restrict proxy_x, float* __restrict proxy_y,
                   float* __restrict proxy_angle, float* __restrict start, float* __restrict force_x, float* __restrict force_y,
                   float* __restrict moment) noexcept {
  const float stiffness = law.stiffness;
  const float twist_stiffness = law.twist_stiffness;
  const float mu = law.mu;
  const float force_scale = law.per_force_max;
  const float moment_scale = law.arm * law.per_moment_max;
  for (std::size_t i = 0; i < count; ++i) {
    const float gx = x[i];
    const float gy = y[i];
    const float ga = angle[i];
    const float d = depth[i];
    const float px = proxy_x[i];
    const float py = proxy_y[i];
    const float pa = proxy_angle[i];
    const float s = start[i];
    // Not free now, nor before.
    const bool held = (d > 0.0F) & (s >= -1.0F);
    const float old_x = held ? px : gx;
    const float old_y = held ? py : gy;
    const float old_angle = held ? pa : ga;
    const float pull_x = old_x - gx;
    const float pull_y = old_y - gy;
    const float turn = old_angle - ga;
    const float scaled_x = pull_x * force_scale;
    const float scaled_y = pull_y * force_scale;
    const float scaled_turn = turn * moment_scale;
    const float length = std::sqrt((scaled_x * scaled_x + scaled_y * scaled_y) + scaled_turn * scaled_turn);
    const float limit = d > 0.0F ? mu * d : 0.0F;
    const float at_rest = d > 0.0F ? -1.0F : -2.0F;
    const float shrinking = limit / (length > limit ? length : 1.0F);
    const float share = length > limit ? shrinking : 1.0F;
    const float rounding = resolution * ((std::fabs(old_x) + std::fabs(old_y)) * force_scale + std::fabs(old_angle) * moment_scale);
    const float proxy_share = length > limit * (1.0F + float_slip_guard) + rounding ? share : 1.0F;
    const float slid_x = shrunk(old_x, gx, pull_x, proxy_share);
    const float slid_y = shrunk(old_y, gy, pull_y, proxy_share);
    const float turned = shrunk(old_angle, ga, turn, proxy_share);
    // What does not shrink does not move, bit for bit.
    const float new_x = proxy_share < 1.0F ? slid_x : old_x;
    const float new_y = proxy_share < 1.0F ? slid_y : old_y;
    const float new_angle = proxy_share < 1.0F ? turned : old_angle;
    const float motion = std::fabs(new_x - old_x) + std::fabs(new_y - old_y) + std::fabs(new_angle - old_angle);
    force_x[i] = pull_x * (stiffness * share);
    force_y[i] = pull_y * (stiffness * share);
    moment[i] = turn * (twist_stiffness * share);
    proxy_x[i] = new_x;
    proxy_y[i] = new_y;
    proxy_angle[i] = new_angle;
    start[i] = motion > 0.0F ? 0.0F : at_rest;
  }
}

}  // namespace

int all_usable(std::size_t count, const float* x, const float* y, const float* angle, const float* depth) noexcept {
  return count_unusable(count, x, y, angle, depth) == 0 ? 1 : 0;
}

CheckedFloatStep float_step(const ContactLaw& law, double force_max, double moment_max) noexcept {
  const double arm = law.twist_stiffness() / (law.stiffness() * law.constant_radius());
  const FloatStep step{static_cast<float>(law.stiffness()),
                       static_cast<float>(law.twist_stiffness()),
                       static_cast<float>(law.mu()),
                       static_cast<float>(arm),
                       static_cast<float>(law.constant_radius() / arm),
                       static_cast<float>(1.0 / force_max),
                       static_cast<float>(1.0 / moment_max)};
  bool usable = law.radius_law() == nullptr && law.has_one_limit();
  for (const float number : {step.stiffness, step.twist_stiffness, step.mu, step.arm, step.compliance_ratio, step.per_force_max,
                             step.per_moment_max, step.arm * step.per_moment_max}) {
    usable = usable && number >= 1e-9F && number <= 1e9F;
  }
  return {usable, step};
}

void step_floats(const FloatStep& law, const FloatContactBatch& batch) noexcept {
  for_each_block(batch, 1024, [&](const FloatContactBatch& block) {
    elliptic_loop(law, block.size(), block.x.data(), block.y.data(), block.angle.data(), block.depth.data(), block.proxy_x.data(),
                  block.proxy_y.data(), block.proxy_angle.data(), block.start.data(), block.force_x.data(), block.force_y.data(),
                  block.moment.data());
  });
}

}  // namespace limitcurve::godobject::detail
