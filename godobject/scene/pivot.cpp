// SPDX-License-Identifier: MIT
#include "godobject/scene/pivot.hpp"

#include "godobject/finger_curve.hpp"
#include "godobject/scene/gripped_block.hpp"
#include "limitcurve/internal/names.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::godobject {

CurveKind PivotOptions::limit_curve() const noexcept {
  if (curve) return *curve;
  switch (kind) {
    case PivotCase::coupled:
      return CurveKind::ellipse;
    case PivotCase::uncoupled:
      return CurveKind::box;
    case PivotCase::exact:
      break;
  }
  return CurveKind::table;
}

namespace {

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
  if (!(options.time_step > 0.0 && options.time_step <= 1.0))
    throw out_of_range("time_step", options.time_step, "s", "> 0, up to 1");
  within("duration", options.duration, "s", true);
  if (options.duration / options.time_step > 1e9)
    throw out_of_range("time_step", options.time_step, "s", ">= duration/1e9");
  if (!(options.offset >= 0.0 && options.offset < 0.5 * options.length)) {
    throw out_of_range("offset", options.offset, "m",
                       "0 <= offset < length/2 = " + format_number(0.5 * options.length) + " m");
  }
  if (options.grip_operator) {
    if (!options.grip.empty())
      throw std::invalid_argument("grip: both a grip and an operator are given, expected one of them");
    within("target", options.grip_operator->target, "rad", false);
    within("start_load", options.grip_operator->start_load.value_or(1.0), "N", false);
    within("rate", options.grip_operator->rate.value_or(1.0), "N/s", false);
    within("regrip_rate", options.grip_operator->regrip_rate.value_or(1.0), "N/s", false);
    within("speed", options.grip_operator->speed, "rad/s", false);
  }
  double last = -std::numeric_limits<double>::infinity();
  for (const GripSample& sample : options.grip) {
    within("load", sample.load, "N", true);
    if (!(sample.time > last && sample.time <= 1e9))
      throw out_of_range("time of a grip sample", sample.time, "s", "finite and increasing");
    last = sample.time;
  }
}

Projection projection_of(const PivotOptions& options) noexcept {
  return options.projection.value_or(options.kind == PivotCase::coupled ? Projection::radial
                                                                        : Projection::closest_point);
}

FingerCurve make_curve(const PivotOptions& options, CurveKind kind) {
  return make_finger_curve(kind, options.law ? options.law : hertz(), options.tolerance);
}

/// The finger's parameters without its springs.
FingerParameters friction_parameters(const PivotOptions& options) {
  FingerParameters result;
  result.mu = options.mu;
  result.radius_law = options.radius_law;
  result.mu_r = options.mu_r;
  result.mu_dynamic = options.mu_dynamic;
  result.mu_r_dynamic = options.mu_r_dynamic;
  return result;
}

/// The smallest load of each finger with which the curve holds the level block.
double load_to_hold(const PivotOptions& options, const FingerCurve& curve) {
  if (!(options.mu > 0.0)) return std::numeric_limits<double>::infinity();
  const double fraction = 0.5 * options.mass * options.gravity;
  return ContactLimits(friction_parameters(options), curve.moment_max())
      .load_to_hold(curve, fraction, fraction * options.offset);
}

/// μ_r/μ_l [m]: the given one, or m₀ a at the load that holds the block.
double moment_arm(const PivotOptions& options, const FingerCurve& curve) {
  if (options.mu_r) return options.mu > 0.0 ? *options.mu_r / options.mu : 0.0;
  const double load = load_to_hold(options, curve);
  return std::isfinite(load) ? curve.moment_ratio() * options.radius_law.radius(load) : 0.0;
}

FingerParameters finger_parameters(const PivotOptions& options, const FingerCurve& curve) {
  FingerParameters result = friction_parameters(options);
  result.stiffness = options.stiffness;
  if (options.twist_stiffness) {
    result.twist_stiffness = *options.twist_stiffness;
  } else {
    const double arm = moment_arm(options, curve);
    if (!(arm > 0.0)) {
      throw std::invalid_argument(
          "twist_stiffness: absent, expected a value if mu, the moment coefficient or the load that holds the block is "
          "0");
    }
    result.twist_stiffness = options.stiffness * arm * arm;
  }
  result.max_speed =
      std::numeric_limits<double>::infinity();  // the fingers are as deep as load and stiffness make them
  result.damping = options.damping;
  result.twist_damping = options.twist_damping.value_or(options.damping * result.twist_stiffness / result.stiffness);
  return result;
}

/// Throws unless the block stays in the grip at the start: its weight must deflect the springs by less than half its
/// height, and less than half a turn, and the loads must not press the fingers beyond what is a position.
void require_hold(const PivotOptions& options, const FingerParameters& finger) {
  const double fraction = 0.5 * options.mass * options.gravity;
  if (const double least = 2.0 * fraction / options.height; !(finger.stiffness > least)) {
    throw out_of_range(
        "stiffness", finger.stiffness, "N/m",
        "> " + format_number(least) + ", so that the block's weight lowers it by less than half its height");
  }
  if (const double least = fraction * options.offset / std::numbers::pi; !(finger.twist_stiffness > least)) {
    throw out_of_range("twist_stiffness", finger.twist_stiffness, "N m/rad",
                       "> " + format_number(least) + ", so that the block's weight turns it by less than half a turn");
  }
  double load = options.grip_operator ? options.grip_operator->start_load.value_or(0.0) : 0.0;
  for (const GripSample& sample : options.grip) load = std::max(load, sample.load);
  if (load == 0.0) load = 2.0 * default_load(options);
  if (const double least = 2.0 * load / farthest; !(finger.stiffness > least)) {
    throw out_of_range("stiffness", finger.stiffness, "N/m",
                       "> " + format_number(least) + ", so that a load of " + format_number(load) +
                           " N presses a finger in by less than 5e5 m");
  }
}

}  // namespace

/// The load of the fingers over time: the schedule, or the operator.
class GripLoad {
 public:
  explicit GripLoad(const PivotOptions& options) : grip_(options.grip), operator_(options.grip_operator) {
    const double usual = default_load(options);
    if (grip_.empty()) grip_ = {{0.0, usual}, {10.0, 0.5 * usual}};
    if (!operator_) return;
    load_ = start_load_ = operator_->start_load.value_or(2.0 * usual);
    rate_ = operator_->rate.value_or(usual);
    regrip_rate_ = operator_->regrip_rate.value_or(10.0 * usual);
  }

  /// The load one time step after a row.
  double next(const PivotRow& row, double time, double time_step, double speed) noexcept {
    if (!operator_) return scheduled(time);
    if (row.angle >= operator_->target || slides_out(row)) regrips_ = true;
    if (regrips_) {
      load_ = std::min(load_ + regrip_rate_ * time_step, start_load_);
    } else {
      load_ = std::clamp(load_ + (speed > operator_->speed ? 1.0 : -1.0) * rate_ * time_step, 0.0, start_load_);
    }
    return load_;
  }

  /// The load at the beginning.
  [[nodiscard]] double first() const noexcept { return operator_ ? load_ : scheduled(0.0); }

 private:
  /// Whether the block slides out more than it turns.
  [[nodiscard]] bool slides_out(const PivotRow& row) const noexcept {
    return operator_->regrips_on_slide &&
           row.grip_slip > std::max(GripOperator::slide_limit, GripOperator::slide_per_turn * std::fabs(row.angle));
  }

  [[nodiscard]] double scheduled(double time) const noexcept {
    if (time <= grip_.front().time) return grip_.front().load;
    for (std::size_t i = 1; i < grip_.size(); ++i) {
      if (time > grip_[i].time) continue;
      const double fraction = (time - grip_[i - 1].time) / (grip_[i].time - grip_[i - 1].time);
      return grip_[i - 1].load + fraction * (grip_[i].load - grip_[i - 1].load);
    }
    return grip_.back().load;
  }

  std::vector<GripSample> grip_;
  std::optional<GripOperator> operator_;
  double start_load_ = 0.0;
  double rate_ = 0.0;
  double regrip_rate_ = 0.0;
  double load_ = 0.0;
  bool regrips_ = false;
};

class Pivot::Scene {
 public:
  Scene(const PivotOptions& options, const FingerCurve& curve, const FingerParameters& parameters)
      : options_(options),
        curve_error_(curve.error()),
        holding_load_(load_to_hold(options, curve)),
        grip_load_(options),
        block_(options, SoftFinger(curve, parameters, projection_of(options))) {
    const double load = grip_load_.first();
    block_.take(load);
    describe(0.0, load, block_.grasp().finger(0).output());
  }

  [[nodiscard]] const PivotRow& row() const noexcept { return row_; }
  [[nodiscard]] double holding_load() const noexcept { return holding_load_; }
  [[nodiscard]] double curve_error() const noexcept { return curve_error_; }

  bool step() noexcept {
    if (row_.time >= options_.duration - 0.5 * options_.time_step || row_.y < -options_.length) return false;
    // A multiple of the time step, not a sum: times stay round.
    ++count_;
    const double time = static_cast<double>(count_) * options_.time_step;
    const double load = grip_load_.next(row_, time, options_.time_step, block_.grasp().body().angular_velocity.z());
    const FingerOutput last = block_.grasp().finger(0).output();
    block_.step(load, options_.time_step);
    describe(time, load, last);
    return true;
  }

 private:
  /// `last`: the first finger's output of the step before.
  void describe(double time, double load, const FingerOutput& last) noexcept {
    const Grasp& grasp = block_.grasp();
    const BodyState& body = grasp.body();
    const FingerOutput& output = grasp.finger(0).output();
    row_.time = time;
    row_.x = body.position.x();
    row_.y = body.position.y();
    row_.angle = block_.angle();
    if (output.state != ContactState::free) row_.grip_slip = (output.proxy - block_.grip()).norm();
    row_.load = load;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    double moment = 0.0;
    for (std::size_t i = 0; i < grasp.finger_count(); ++i) {
      force += grasp.finger(i).output().force;
      moment += grasp.moment_on_user(i).z();
    }
    row_.friction_force = force.norm();
    row_.friction_moment = std::fabs(moment);
    row_.state = output.state;
    row_.fault = output.fault;
    row_.cor = output.cor;
    const FingerSample& sample = grasp.finger(0).state().sample;
    const bool free = output.state == ContactState::free;
    row_.r = free ? 0.0 : (output.proxy - sample.goal).norm();
    row_.rho = free ? 0.0 : std::fabs(output.angle - sample.angle);
    row_.trial_r = free ? 0.0 : (last.proxy - sample.goal).norm();
    row_.trial_rho = free ? 0.0 : std::fabs(last.angle - sample.angle);
  }

  PivotOptions options_;
  double curve_error_;
  double holding_load_;
  GripLoad grip_load_;
  PivotRow row_;
  GrippedBlock block_;
  long count_ = 0;
};

std::span<const std::string_view> pivot_case_names() noexcept {
  static constexpr std::array<std::string_view, 3> names{"coupled", "uncoupled", "exact"};
  return names;
}
std::string_view to_string(PivotCase kind) noexcept {
  return pivot_case_names()[static_cast<std::size_t>(kind)];
}
PivotCase parse_pivot_case(std::string_view text) {
  return parse_name<PivotCase>(pivot_case_names(), "case", text);
}

Pivot::Pivot(const PivotOptions& options) {
  validate(options);
  static_cast<void>(ContactLimits(friction_parameters(options), 1.0));
  const FingerCurve curve = make_curve(options, options.limit_curve());
  const FingerParameters finger = finger_parameters(options, curve);
  static_cast<void>(ContactLimits(finger, 1.0));
  require_hold(options, finger);
  scene_ = std::make_unique<Scene>(options, curve, finger);
}

Pivot::~Pivot() = default;
Pivot::Pivot(Pivot&&) noexcept = default;
Pivot& Pivot::operator=(Pivot&&) noexcept = default;

const PivotRow& Pivot::row() const noexcept {
  return scene_->row();
}

double Pivot::holding_load() const noexcept {
  return scene_->holding_load();
}

double Pivot::curve_error() const noexcept {
  return scene_->curve_error();
}

bool Pivot::step() noexcept {
  return scene_->step();
}

double default_load(const PivotOptions& options) {
  validate(options);
  constexpr double usual = 0.5;
  const double load = 1.3 * load_to_hold(options, make_curve(options, CurveKind::ellipse));
  if (!(load > usual && load <= 1e8)) return usual;
  // Round up to two digits. Powers of ten by multiplication, because not every library's pow() is exact.
  double parts = 1.0;
  while (load * parts < 10.0) parts *= 10.0;
  double unit = 1.0;
  while (load >= 100.0 * unit) unit *= 10.0;
  return std::ceil(load * parts / unit) / parts * unit;
}

}  // namespace limitcurve::godobject
