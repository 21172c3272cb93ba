// SPDX-License-Identifier: MIT
#include "godobject/scene/gripped_block.hpp"

#include "godobject/surfaces/surfaces.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace limitcurve::godobject {

namespace {

/// Thickness of the block between the fingers [m]. It only bounds their depth.
constexpr double thickness = 0.04;

}  // namespace

GrippedBlock::GrippedBlock(const PivotOptions& options, const SoftFinger& finger)
    : edges_(options.length, options.height, thickness),
      offset_(options.offset),
      grasp_(BodyParameters::planar_block(options.mass, edges_, options.gravity), BodyState{},
             AnySurface(BoxSurface(0.5 * edges_)), {finger, finger}) {}

void GrippedBlock::take(double load) noexcept {
  const double weight = -grasp_.parameters().mass * grasp_.parameters().gravity.y();
  const FingerParameters& finger = grasp_.finger(0).parameters();
  // Touch down with the block raised and turned so that, when it is level, the springs just bear its weight.
  const double sag = 0.5 * weight / finger.stiffness;
  const double give = 0.5 * weight * offset_ / finger.twist_stiffness;
  BodyState start;
  start.orientation = Eigen::AngleAxisd(-give, Eigen::Vector3d::UnitZ());
  start.position = -(start.orientation * Eigen::Vector3d(offset_, -sag, 0.0));
  BodyState level;
  level.position = {-offset_, 0.0, 0.0};
  grasp_.place(start, devices());
  depth_ = load / finger.stiffness;
  grasp_.place(start, devices());
  grip_ = grasp_.finger(0).output().proxy;
  grasp_.place(level, devices());
}

void GrippedBlock::step(double load, double time_step) noexcept {
  // The depth at which spring and damper together give that load. After a bad step no damper acts.
  const FingerParameters& finger = grasp_.finger(0).parameters();
  if (time_step > 0.0 && is_time_step(time_step) && std::isfinite(load)) {
    const bool is_damped = time_step >= shortest_time_step && grasp_.finger(0).output().state != ContactState::invalid;
    const double rate = is_damped ? finger.damping / time_step : 0.0;
    depth_ = load > 0.0 ? (load + rate * depth_) / (finger.stiffness + rate) : 0.0;
  }
  // A load that is not finite is a force that is none.
  grasp_.step(devices(), time_step, Eigen::Vector3d::Constant(0.0 * load));
  const Orientation& orientation = grasp_.body().orientation;
  angle_ += std::remainder(2.0 * std::atan2(orientation.z(), orientation.w()) - angle_, 2.0 * std::numbers::pi);
}

void GrippedBlock::change_fingers(const SoftFinger& finger) {
  std::vector<SoftFinger> fingers(grasp_.finger_count(), finger);
  for (std::size_t i = 0; i < fingers.size(); ++i) fingers[i].restore(grasp_.finger(i).state());
  grasp_ = Grasp(grasp_.parameters(), grasp_.body(), AnySurface(BoxSurface(0.5 * edges_)), std::move(fingers));
}

/// Two opposite fingers at the origin.
std::array<DevicePose, 2> GrippedBlock::devices() const noexcept {
  const double reach = 0.5 * thickness - depth_;
  return {DevicePose{{0.0, 0.0, reach}}, DevicePose{{0.0, 0.0, -reach}}};
}

}  // namespace limitcurve::godobject
