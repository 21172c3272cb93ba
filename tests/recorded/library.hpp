// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch.hpp"
#include "godobject/finger_curve.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/limitcurve.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

/// The recorder's interface to the library: a finger and a batch from command-line words, with plain input and output.
namespace recorded {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double inf = std::numeric_limits<double>::infinity();

using Vector = std::array<double, 3>;

/// What a finger is given in a step.
struct Sample {
  Vector point;
  Vector normal;
  double depth;
  double twist;
  double time_step;
};

/// What it gives.
struct Output {
  std::string state;
  Vector proxy;
  double angle;
  double depth;
  double load;
  Vector force;
  double moment;
  double cor;
  double slip_work;
  double margin = nan;
  double load_to_hold = nan;
};

namespace lib = limitcurve;
namespace go = limitcurve::godobject;

/// Of the command line's words.
struct Setting {
  go::CurveKind kind;
  go::Projection projection;
  go::FingerParameters finger;
};

inline Setting make_setting(std::string_view parameters, std::string_view curve, std::string_view projection, double mu_times,
                            double twist_stiffness_times) {
  Setting setting{go::parse_curve_kind(curve), go::parse_projection(projection), {}};
  go::FingerParameters& finger = setting.finger;
  finger.mu = 0.6 * mu_times;
  finger.radius_law = lib::RadiusLaw::constant(0.006);
  finger.stiffness = 1000.0;
  finger.twist_stiffness = 0.036 * twist_stiffness_times;
  if (parameters == "dynamic") {
    finger.mu_dynamic = 0.45 * mu_times;
  } else if (parameters == "power-radius") {
    finger.radius_law = lib::RadiusLaw::power(0.005, 0.259);
  } else if (parameters == "no-moment") {
    finger.mu_r = 0.0;
  } else if (parameters == "small-leaps") {
    finger.max_displacement = 0.01;
  } else if (parameters == "soft-hold") {
    finger.fault_decay = 0.9;
  } else if (parameters == "damped") {
    finger.damping = 2.0;
    finger.twist_damping = 1e-4;
    finger.mu_dynamic = 0.5 * mu_times;
    finger.radius_law = lib::RadiusLaw::power(0.005, 0.259);
  } else if (parameters != "plain") {
    throw std::invalid_argument("parameters '" + std::string(parameters) +
                                "', expected plain, dynamic, power-radius, no-moment, small-leaps, soft-hold or damped");
  }
  return setting;
}

inline go::FingerCurve make_curve(const Setting& setting) {
  return go::make_finger_curve(setting.kind, lib::hertz(), 1e-11);
}

/// One finger, fed with samples.
class Finger {
 public:
  explicit Finger(const Setting& setting) : finger_(make_curve(setting), setting.finger, setting.projection) {}

  Output update(const Sample& sample) {
    Output output = output_of(finger_.update(contact_of(sample), sample.twist, sample.time_step));
    output.margin = finger_.margin();
    output.load_to_hold = finger_.load_to_hold();
    return output;
  }
  [[nodiscard]] Output preview(const Sample& sample) const {
    return output_of(finger_.preview(contact_of(sample), sample.twist, sample.time_step));
  }
  [[nodiscard]] go::FingerState state() const { return finger_.state(); }
  void restore(const go::FingerState& state) { finger_.restore(state); }
  void reset() { finger_.reset(); }

 private:
  static go::Contact contact_of(const Sample& sample) {
    return {{sample.point[0], sample.point[1], sample.point[2]}, {sample.normal[0], sample.normal[1], sample.normal[2]}, sample.depth};
  }
  static Output output_of(const go::FingerOutput& output) {
    return {.state = std::string(go::to_string(output.state)),
            .proxy = {output.proxy.x(), output.proxy.y(), output.proxy.z()},
            .angle = output.angle,
            .depth = output.depth,
            .load = output.load,
            .force = {output.force.x(), output.force.y(), output.force.z()},
            .moment = output.moment,
            .cor = output.cor,
            .slip_work = output.slip_work};
  }

  go::SoftFinger finger_;
};

/// Many contacts.
template <class Real>
using Contacts = go::BasicContactArrays<Real>;

/// The curve of a batch. A batch of floats is stepped on a table of floats, as fine as there is.
template <class Real>
go::BasicFingerCurve<Real> make_batch_curve(const Setting& setting) {
  if (setting.kind == go::CurveKind::ellipse) return lib::Ellipse::through_intercepts(lib::hertz()->moment_ratio());
  if (setting.kind == go::CurveKind::box) return lib::box(1.0, lib::hertz()->moment_ratio());
  return lib::BasicTable<Real>::build(lib::hertz(), lib::BasicTable<Real>::finest_tolerance);
}

template <class Real>
go::BasicBatch<Real> make_batch(const Setting& setting) {
  return {make_batch_curve<Real>(setting), setting.finger, setting.projection};
}

}  // namespace recorded
