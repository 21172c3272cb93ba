// SPDX-License-Identifier: MIT
#include "godobject/scene_replay.hpp"

#include "godobject/choice.hpp"
#include "godobject/grasp.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::godobject {

class SceneReplay::Runner {
 public:
  Runner() = default;
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;
  virtual ~Runner() = default;
  virtual void step(double time, std::span<const DevicePose> fingers, const BodyPose& body) noexcept = 0;
  [[nodiscard]] virtual const BodyState& body() const noexcept = 0;
  [[nodiscard]] std::span<const SceneContact> contacts() const noexcept { return contacts_; }

 protected:
  explicit Runner(std::size_t fingers) : contacts_(fingers) {}

  std::vector<SceneContact> contacts_;
};

namespace {

/// A pose that every finger refuses.
DevicePose nowhere() noexcept {
  DevicePose result;
  result.position.setConstant(std::numeric_limits<double>::quiet_NaN());
  return result;
}

bool is_pose(const BodyPose& pose) noexcept {
  return pose.position.squaredNorm() <= 1e12 && std::fabs(pose.orientation.squaredNorm() - 1.0) <= 1e-6;
}

template <LimitBoundary Boundary, class Projection>
class SceneRunner final : public SceneReplay::Runner {
 public:
  SceneRunner(const SceneOptions& options, const Boundary& boundary, const FingerParameters& parameters, Projection projection)
      : Runner(options.fingers),
        grasp_(options.body, BodyState{}, options.surface, std::vector<Finger>(options.fingers, Finger(boundary, parameters, projection))),
        refused_(options.fingers, nowhere()),
        motion_(options.motion) {}

  void step(double time, std::span<const DevicePose> fingers, const BodyPose& body) noexcept override {
    const bool in_time = time >= last_time_ && time <= std::numeric_limits<double>::max();
    const bool begins = last_time_ == -std::numeric_limits<double>::infinity();
    if (!in_time || (motion_ == BodyMotion::prescribed && !is_pose(body))) {
      grasp_.carry(grasp_.body(), refused_, 0.0);
    } else {
      const double time_step = begins ? 0.0 : time - last_time_;
      last_time_ = time;
      move(fingers, body, time_step);
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) describe(i);
  }

  [[nodiscard]] const BodyState& body() const noexcept override { return grasp_.body(); }

 private:
  using Scene = Grasp<AnySurface, Boundary, Projection>;
  using Finger = typename Scene::Finger;

  void move(std::span<const DevicePose> fingers, const BodyPose& body, double time_step) noexcept {
    if (motion_ == BodyMotion::free && time_step >= Finger::shortest_time_step && time_step <= SceneReplay::longest_step) {
      grasp_.step(fingers, time_step);
      return;
    }
    BodyState state = grasp_.body();
    if (motion_ == BodyMotion::prescribed) {
      state.position = body.position;
      state.orientation = body.orientation;
    }
    grasp_.carry(state, fingers, time_step);
  }

  void describe(std::size_t index) noexcept {
    const Finger& finger = grasp_.finger(index);
    const FingerOutput& output = finger.output();
    const BodyState& body = grasp_.body();
    SceneContact& contact = contacts_[index];
    contact.state = output.state;
    contact.dissipated += output.slip_work;
    contact.load = output.load;
    contact.force = body.orientation * output.force;
    contact.moment = output.moment;
    // What is held is what was felt, wherever the body is by now.
    if (output.state == ContactState::invalid) return;
    contact.proxy = body.to_world(output.proxy);
    contact.angle = output.angle;
    contact.depth = output.depth;
    contact.cor = output.cor;
    contact.normal = body.orientation * finger.state().normal;
    contact.margin = finger.margin();
    contact.load_to_hold = finger.load_to_hold();
    contact.centre_of_rotation = finger.centre_of_rotation();
    if (contact.centre_of_rotation.allFinite()) contact.centre_of_rotation = body.to_world(contact.centre_of_rotation);
  }

  Scene grasp_;
  std::vector<DevicePose> refused_;
  BodyMotion motion_;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

SceneReplay::SceneReplay(const SceneOptions& options) {
  const ReplayOptions& finger = options.finger;
  if (!finger.law) throw std::invalid_argument("law: none given, expected a pressure law");
  if (!(options.fingers >= 1 && options.fingers <= most_fingers)) {
    throw std::invalid_argument("fingers = " + std::to_string(options.fingers) + ": expected 1 to " + std::to_string(most_fingers));
  }
  FingerParameters parameters = finger_parameters(finger);
  parameters.damping = options.damping;
  parameters.twist_damping = options.twist_damping;
  // Before a table is built for nothing.
  static_cast<void>(ContactLaw(parameters, finger.law->moment_ratio()));
  options.body.validate();
  runner_ = visit_boundary(finger.boundary, finger.law, finger.tolerance, [&](const auto& boundary) {
    using Boundary = std::decay_t<decltype(boundary)>;
    return visit_projection(finger.projection, [&](auto projection) -> std::unique_ptr<Runner> {
      return std::make_unique<SceneRunner<Boundary, decltype(projection)>>(options, boundary, parameters, projection);
    });
  });
}

SceneReplay::~SceneReplay() = default;
SceneReplay::SceneReplay(SceneReplay&&) noexcept = default;
SceneReplay& SceneReplay::operator=(SceneReplay&&) noexcept = default;

void SceneReplay::step(double time, std::span<const DevicePose> fingers, const BodyPose& body) noexcept {
  runner_->step(time, fingers, body);
}

std::span<const SceneContact> SceneReplay::contacts() const noexcept {
  return runner_->contacts();
}

const BodyState& SceneReplay::body() const noexcept {
  return runner_->body();
}

}  // namespace limitcurve::godobject
