// SPDX-License-Identifier: MIT
#include "godobject/replay.hpp"

#include "godobject/choice.hpp"
#include "godobject/soft_finger.hpp"

#include <algorithm>
#include <stdexcept>

namespace limitcurve::godobject {

class Replay::Runner {
 public:
  Runner() = default;
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;
  virtual ~Runner() = default;
  virtual ReplayRow step(const TraceSample& sample) noexcept = 0;
  virtual void run(std::span<const TraceSample> samples, std::span<ReplayRow> rows) noexcept = 0;
};

namespace {

template <LimitBoundary Boundary, class Projection>
class PlaneRunner : public Replay::Runner {
 public:
  PlaneRunner(Boundary boundary, const FingerParameters& parameters, Projection projection)
      : finger_(std::move(boundary), parameters, projection) {}

  ReplayRow step(const TraceSample& sample) noexcept override { return advance(sample); }

  void run(std::span<const TraceSample> samples, std::span<ReplayRow> rows) noexcept override {
    const std::size_t count = std::min(samples.size(), rows.size());
    for (std::size_t i = 0; i < count; ++i) rows[i] = advance(samples[i]);
  }

 private:
  ReplayRow advance(const TraceSample& sample) noexcept {
    Contact contact{{sample.x, sample.y, 0.0}, Eigen::Vector3d::UnitZ(), -sample.z};
    // Not finite, or before the last good sample: the finger is given what it refuses.
    const bool in_time = sample.time >= last_time_ && sample.time <= std::numeric_limits<double>::max();
    if (!in_time) contact.depth = std::numeric_limits<double>::quiet_NaN();
    const FingerOutput& output = finger_.update(contact, sample.twist);
    if (output.state != ContactState::invalid) last_time_ = sample.time;
    return {.time = sample.time,
            .state = output.state,
            .px = output.proxy.x(),
            .py = output.proxy.y(),
            .angle = output.angle,
            .depth = output.depth,
            .load = output.load,
            .fx = output.force.x(),
            .fy = output.force.y(),
            .moment = output.moment,
            .cor = output.cor};
  }

  SoftFinger<Boundary, Projection> finger_;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

FingerParameters finger_parameters(const ReplayOptions& options) {
  return {.mu = options.mu,
          .mu_dynamic = options.mu_dynamic,
          .radius_law = options.radius_law,
          .moment_coefficient = options.moment_coefficient,
          .moment_coefficient_dynamic = options.moment_coefficient_dynamic,
          .stiffness = options.stiffness,
          .twist_stiffness = options.twist_stiffness,
          .jump_limit = options.jump_limit,
          .hold_share = options.hold_share};
}

Replay::Replay(const ReplayOptions& options) {
  if (!options.law) throw std::invalid_argument("law: none given, expected a pressure law");
  const FingerParameters parameters = finger_parameters(options);
  // Before a table is built for nothing.
  static_cast<void>(ContactLaw(parameters, options.law->moment_ratio()));
  runner_ = visit_boundary(options.boundary, options.law, options.tolerance, [&](auto&& boundary) {
    using Boundary = std::decay_t<decltype(boundary)>;
    return visit_projection(options.projection, [&](auto projection) -> std::unique_ptr<Runner> {
      return std::make_unique<PlaneRunner<Boundary, decltype(projection)>>(std::move(boundary), parameters, projection);
    });
  });
}

Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

ReplayRow Replay::step(const TraceSample& sample) noexcept {
  return runner_->step(sample);
}

void Replay::run(std::span<const TraceSample> samples, std::span<ReplayRow> rows) noexcept {
  runner_->run(samples, rows);
}

}  // namespace limitcurve::godobject
