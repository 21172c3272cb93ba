// SPDX-License-Identifier: MIT
#include "godobject/pivot.hpp"

#include "godobject/finger_curve.hpp"
#include "godobject/grasp.hpp"
#include "godobject/surface.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::godobject {

namespace {

constexpr std::array<std::pair<PivotCase, std::string_view>, 3> cases{
    {{PivotCase::coupled, "coupled"}, {PivotCase::uncoupled, "uncoupled"}, {PivotCase::exact, "exact"}}};

/// Between the two fingers; it acts on nothing but the depth that a finger may reach.
constexpr double thickness = 0.04;

double within(std::string_view name, double value, std::string_view unit, bool zero_allowed) {
  const bool good = zero_allowed ? value >= 0.0 && value <= 1e9 : value > 0.0 && value <= 1e9;
  if (!good) throw out_of_range(name, value, unit, zero_allowed ? ">= 0, up to 1e9" : "> 0, up to 1e9");
  return value;
}

void validate(const PivotOptions& options) {
  within("length", options.length, "m", false);
  within("height", options.height, "m", false);
  within("mass", options.mass, "kg", false);
  within("gravity", options.gravity, "m/s^2", true);
  within("time_step", options.time_step, "s", false);
  within("duration", options.duration, "s", true);
  if (options.duration / options.time_step > 1e9) throw out_of_range("time_step", options.time_step, "s", ">= duration/1e9");
  if (!(options.offset >= 0.0 && options.offset < 0.5 * options.length)) {
    throw out_of_range("offset", options.offset, "m", "0 <= offset < length/2");
  }
  if (options.grip_operator) {
    if (!options.grip.empty()) throw std::invalid_argument("grip: both a grip and an operator are given, expected one of them");
    within("target", options.grip_operator->target, "rad", false);
    within("start_load", options.grip_operator->start_load, "N", false);
    within("rate", options.grip_operator->rate, "N/s", false);
    within("regrip_rate", options.grip_operator->regrip_rate, "N/s", false);
    within("speed", options.grip_operator->speed, "rad/s", false);
  }
  double last = -std::numeric_limits<double>::infinity();
  for (const GripSample& sample : options.grip) {
    within("load", sample.load, "N", true);
    if (!(sample.time > last && sample.time <= 1e9)) throw out_of_range("time of a grip sample", sample.time, "s", "finite and increasing");
    last = sample.time;
  }
}

FingerParameters finger_parameters(const PivotOptions& options) {
  FingerParameters result;
  result.mu = options.mu;
  result.moment_coefficient = options.moment_coefficient;
  result.mu_dynamic = options.mu_dynamic;
  result.moment_coefficient_dynamic = options.moment_coefficient_dynamic;
  result.stiffness = options.stiffness;
  if (options.twist_stiffness) {
    result.twist_stiffness = *options.twist_stiffness;
  } else {
    if (!(options.mu > 0.0 && options.moment_coefficient > 0.0)) {
      throw std::invalid_argument("twist_stiffness: none given, expected one where mu or moment_coefficient is 0");
    }
    const double ratio = options.moment_coefficient / options.mu;
    result.twist_stiffness = options.stiffness * ratio * ratio;
  }
  result.damping = options.damping;
  result.twist_damping = options.twist_damping.value_or(options.damping * result.twist_stiffness / result.stiffness);
  return result;
}

/// The block must hang in the grip at the start: the springs may give by less than takes it out of the grip, or half around.
void require_hold(const PivotOptions& options, const FingerParameters& finger) {
  const double share = 0.5 * options.mass * options.gravity;
  if (const double least = 2.0 * share / options.height; !(finger.stiffness > least)) {
    throw out_of_range("stiffness", finger.stiffness, "N/m",
                       "> " + format_number(least) + ", that the block's weight sinks it by less than half its height");
  }
  if (const double least = share * options.offset / std::numbers::pi; !(finger.twist_stiffness > least)) {
    throw out_of_range("twist_stiffness", finger.twist_stiffness, "N m/rad",
                       "> " + format_number(least) + ", that the block's weight turns it by less than half a turn");
  }
}

/// The limit curve of the case.
FingerCurve curve_of(const PivotOptions& options) {
  const Law law = options.law ? options.law : hertz();
  const CurveKind kind = options.kind == PivotCase::uncoupled ? CurveKind::box
                         : options.kind == PivotCase::exact   ? CurveKind::table
                                                              : CurveKind::ellipse;
  return make_finger_curve(kind, law, options.tolerance).curve;
}

Projection projection_of(const PivotOptions& options) noexcept {
  return options.kind == PivotCase::coupled ? Projection::radial : Projection::closest_point;
}

/// Who sets the load of the fingers.
class GripHand {
 public:
  explicit GripHand(const PivotOptions& options) : grip_(options.grip), operator_(options.grip_operator) {
    if (grip_.empty()) grip_ = {{0.0, 0.5}, {10.0, 0.25}};
    if (operator_) load_ = operator_->start_load;
  }

  /// The load at a time, one time step after the last, with the block turned so far and turning so fast.
  double load(double time, double time_step, double angle, double speed) noexcept {
    if (!operator_) return scheduled(time);
    if (angle >= operator_->target) regrips_ = true;
    if (regrips_) {
      load_ = std::min(load_ + operator_->regrip_rate * time_step, operator_->start_load);
    } else {
      load_ = std::clamp(load_ + (speed > operator_->speed ? 1.0 : -1.0) * operator_->rate * time_step, 0.0, operator_->start_load);
    }
    return load_;
  }

 private:
  [[nodiscard]] double scheduled(double time) const noexcept {
    if (time <= grip_.front().time) return grip_.front().load;
    for (std::size_t i = 1; i < grip_.size(); ++i) {
      if (time > grip_[i].time) continue;
      const double share = (time - grip_[i - 1].time) / (grip_[i].time - grip_[i - 1].time);
      return grip_[i - 1].load + share * (grip_[i].load - grip_[i - 1].load);
    }
    return grip_.back().load;
  }

  std::vector<GripSample> grip_;
  std::optional<GripOperator> operator_;
  double load_ = 0.0;
  bool regrips_ = false;
};

double angle_of(const BodyState& state) noexcept {
  return 2.0 * std::atan2(state.orientation.z(), state.orientation.w());
}

}  // namespace

class Pivot::Scene {
 public:
  explicit Scene(const PivotOptions& options) : options_(options), hand_(options), grasp_(make_grasp(options)) {
    const double weight = options_.mass * options_.gravity;
    const FingerParameters& finger = grasp_.finger(0).parameters();
    // The fingers took hold where their springs, once the block hangs on them level, just bear it.
    const double sag = 0.5 * weight / finger.stiffness;
    const double give = 0.5 * weight * options_.offset / finger.twist_stiffness;
    BodyState start;
    start.orientation = Eigen::AngleAxisd(-give, Eigen::Vector3d::UnitZ());
    start.position = -(start.orientation * Eigen::Vector3d(options_.offset, -sag, 0.0));
    BodyState level;
    level.position = {-options_.offset, 0.0, 0.0};
    grasp_.place(start, devices());
    const double load = hand_.load(0.0, 0.0, 0.0, 0.0);
    depth_ = load / finger.stiffness;
    grasp_.place(start, devices());
    grip_ = grasp_.finger(0).output().proxy;
    grasp_.place(level, devices());
    describe(0.0, load);
  }

  [[nodiscard]] const PivotRow& row() const noexcept { return row_; }

  bool step() noexcept {
    if (row_.time >= options_.duration - 0.5 * options_.time_step || row_.y < -options_.length) return false;
    // A multiple, not a sum: times stay round.
    ++count_;
    const double time = static_cast<double>(count_) * options_.time_step;
    const double load = hand_.load(time, options_.time_step, row_.angle, grasp_.body().angular_velocity.z());
    // As deep beneath the faces as spring and damper together give that load.
    const FingerParameters& finger = grasp_.finger(0).parameters();
    const double rate = finger.damping / options_.time_step;
    depth_ = load > 0.0 ? (load + rate * depth_) / (finger.stiffness + rate) : 0.0;
    grasp_.step(devices(), options_.time_step);
    describe(time, load);
    return true;
  }

 private:
  static Grasp make_grasp(const PivotOptions& options) {
    const Eigen::Vector3d edges{options.length, options.height, thickness};
    const SoftFinger finger(curve_of(options), finger_parameters(options), projection_of(options));
    return Grasp(BodyParameters::planar_block(options.mass, edges, options.gravity), BodyState{}, AnySurface(BoxSurface(0.5 * edges)),
                 {finger, finger});
  }

  /// Two opposite fingers at the origin.
  [[nodiscard]] std::array<DevicePose, 2> devices() const noexcept {
    const double reach = 0.5 * thickness - depth_;
    return {DevicePose{{0.0, 0.0, reach}}, DevicePose{{0.0, 0.0, -reach}}};
  }

  void describe(double time, double load) noexcept {
    const BodyState& body = grasp_.body();
    const FingerOutput output = grasp_.finger(0).output();
    row_.time = time;
    row_.x = body.position.x();
    row_.y = body.position.y();
    row_.angle += std::remainder(angle_of(body) - row_.angle, 2.0 * std::numbers::pi);
    if (output.state != ContactState::free) row_.grip_slip = (output.proxy - grip_).norm();
    row_.load = load;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    double moment = 0.0;
    for (std::size_t i = 0; i < grasp_.finger_count(); ++i) {
      force += grasp_.finger(i).output().force;
      moment += grasp_.moment_on_user(i).z();
    }
    row_.friction_force = force.norm();
    row_.friction_moment = std::fabs(moment);
    row_.state = output.state;
    row_.cor = output.cor;
  }

  PivotOptions options_;
  GripHand hand_;
  PivotRow row_;
  Grasp grasp_;
  Eigen::Vector3d grip_ = Eigen::Vector3d::Zero();  // where the first finger took hold, in the block's frame
  double depth_ = 0.0;                              // of the fingers beneath their faces [m]
  long count_ = 0;
};

std::string_view to_string(PivotCase kind) noexcept {
  for (const auto& [known, name] : cases) {
    if (known == kind) return name;
  }
  return "unknown";
}

PivotCase parse_pivot_case(std::string_view text) {
  for (const auto& [kind, name] : cases) {
    if (name == text) return kind;
  }
  throw std::invalid_argument("case '" + std::string(text) + "': expected coupled|uncoupled|exact");
}

Pivot::Pivot(const PivotOptions& options) {
  validate(options);
  const FingerParameters finger = finger_parameters(options);
  static_cast<void>(ContactLimits(finger, 1.0));
  require_hold(options, finger);
  scene_ = std::make_unique<Scene>(options);
}

Pivot::~Pivot() = default;
Pivot::Pivot(Pivot&&) noexcept = default;
Pivot& Pivot::operator=(Pivot&&) noexcept = default;

const PivotRow& Pivot::row() const noexcept {
  return scene_->row();
}

bool Pivot::step() noexcept {
  return scene_->step();
}

std::vector<PivotRow> run_pivot(const PivotOptions& options) {
  Pivot pivot(options);
  std::vector<PivotRow> rows{pivot.row()};
  while (pivot.step()) rows.push_back(pivot.row());
  return rows;
}

double holding_load(const PivotOptions& options) {
  validate(options);
  const FingerParameters finger = finger_parameters(options);
  if (!(finger.mu > 0.0)) return std::numeric_limits<double>::infinity();
  const FingerCurve curve = curve_of(options);
  const double share = 0.5 * options.mass * options.gravity;
  return ContactLimits(finger, curve.moment_ratio()).load_to_hold(curve, share, share * options.offset);
}

}  // namespace limitcurve::godobject
