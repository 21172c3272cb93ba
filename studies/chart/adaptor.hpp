// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch/batch.hpp"
#include "godobject/body/grasp.hpp"
#include "godobject/godobject.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/table.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// The part of the library's interface that the workloads (studies/chart/finger_bench.cpp) use.
/// scripts/maintain/compare_speed compiles the workloads against two commits, each with its own copy of this file.
namespace limitcurve::bench {

using godobject::BodyState;
using godobject::Contact;
using godobject::DevicePose;

/// The limit curve of a Hertz contact, and the projection; the table has a tolerance of 1e-8 (in a batch of floats: the
/// finest possible).
enum class Model { ellipse_radial, table_radial, table_closest_point };

/// Properties of a finger beside springs and friction.
struct Skin {
  bool damped = false;
  bool radius_grows = false;  ///< a(P), a silicone finger's; else constant
};

inline godobject::FingerParameters parameters(Skin skin) {
  godobject::FingerParameters result;
  result.mu = 0.6;
  result.radius_law = skin.radius_grows ? RadiusLaw::power(0.00207, 0.259) : RadiusLaw::constant(0.005);
  result.stiffness = 1000.0;
  result.twist_stiffness = 0.04;
  result.max_speed = 1e9;  // the workloads jump
  if (skin.damped) {
    result.damping = 1.0;
    result.twist_damping = 4e-5;
  }
  return result;
}

template <Model model, class Real = double>
godobject::BasicFingerCurve<Real> make_curve() {
  if constexpr (model == Model::ellipse_radial) return Ellipse::through_intercepts(hertz()->moment_ratio());
  return BasicTable<Real>::build(hertz(), std::is_same_v<Real, float> ? 1e-6 : 1e-8);
}

template <Model model>
inline constexpr godobject::Projection projection =
    model == Model::table_closest_point ? godobject::Projection::closest_point : godobject::Projection::radial;

template <Model model>
auto make_finger(Skin skin) {
  return godobject::SoftFinger(make_curve<model>(), parameters(skin), projection<model>);
}

/// A step, in a time [s]. The moment on the user [N m].
template <class Finger>
double update(Finger& finger, const Contact& contact, double twist, double time_step) {
  return finger.update(contact, twist, time_step).moment;
}

/// The next search for the closest point has no warm start, like a finger's first.
template <class Finger>
void forget_closest_point(Finger& finger) {
  finger.forget_warm_start();
}

/// Input of a batch.
template <class Real>
struct BatchInput {
  std::span<const Real> x, y, angle, depth;
};

template <Model model, class Real>
class Batch {
 public:
  Batch(Skin skin, std::size_t count)
      : stepper_(make_curve<model, Real>(), parameters(skin), projection<model>),
        arrays_(count),
        batch_(arrays_.batch()) {}
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  void step(const BatchInput<Real>& input) {
    batch_.x = input.x;
    batch_.y = input.y;
    batch_.twist = input.angle;
    batch_.depth = input.depth;
    stepper_.step(batch_);
  }

  [[nodiscard]] std::span<const Real> moment() const { return batch_.moment; }

 private:
  godobject::BasicBatch<Real> stepper_;
  godobject::BasicContactArrays<Real> arrays_;
  godobject::BasicContactBatch<Real> batch_;
};

/// A block of 100 g, 12 x 4 x 4 cm, and this many fingers on it. It may be locked against tilting, about x and y.
template <Model model>
auto make_grasp(Skin skin, std::size_t fingers, bool tilts) {
  const Eigen::Vector3d edges{0.12, 0.04, 0.04};
  auto body = godobject::BodyParameters::block(0.1, edges);
  body.free = {true, true, true, tilts, tilts, true};
  return godobject::Grasp(body, BodyState{}, godobject::AnySurface(godobject::BoxSurface(0.5 * edges)),
                          std::vector<godobject::SoftFinger>(fingers, make_finger<model>(skin)));
}

/// The moment on the user of a grasp's finger [N m].
inline double moment_of(const godobject::Grasp& grasp, std::size_t finger) {
  return grasp.finger(finger).output().moment;
}

inline Table build_table(const std::string& law, double tolerance) {
  return Table::build(parse_law(law), tolerance);
}

inline constexpr double finest_tolerance = Table::finest_tolerance;

/// Force and moment of a slip twist (|v| : a|ω|), added.
inline double wrench_sum(const Table& table, double slide, double spin) {
  const UnitWrench wrench = table.wrench(SlipTwist{slide, spin});
  return wrench.force + wrench.moment;
}

}  // namespace limitcurve::bench
