// SPDX-License-Identifier: MIT
#pragma once

#include "tests/godobject/scene.hpp"
#if __has_include("godobject/surfaces/surfaces.hpp")
#include "godobject/surfaces/surfaces.hpp"
#define LIMITCURVE_TESTS_CURVED
#endif

#include <cstdlib>

/// Seeded random scenes: every kind of surface, sets of parameters, and devices that press, slide, twist, rest and lift
/// off.
namespace limitcurve::godobject::test {

struct NamedSurface {
  std::string name;
  AnySurface surface;
};

inline std::vector<NamedSurface> all_surfaces() {
  return {
      {"plane", AnySurface(PlaneSurface{})},
#ifdef LIMITCURVE_TESTS_CURVED
      {"sphere", AnySurface(SphereSurface(0.03))},
      {"small sphere", AnySurface(SphereSurface(0.01))},
      {"capsule", AnySurface(CapsuleSurface(0.012, 0.03))},
      {"cylinder", AnySurface(CylinderSurface(0.02, 0.03))},
      {"box", AnySurface(BoxSurface({0.03, 0.02, 0.04}))},
#else
      {"ball", AnySurface(Ball{0.03})},
#endif
  };
}

struct NamedParameters {
  std::string name;
  FingerParameters finger;
};

/// All of them with k_l = 1000 N/m and k_r = 0.036 N m/rad.
inline std::vector<NamedParameters> all_parameters() {
  const auto with = [](std::string name, auto change) {
    FingerParameters finger = parameters(0.6, 0.006, 1000.0, 0.036);
    change(finger);
    return NamedParameters{std::move(name), finger};
  };
  return {with("plain", [](FingerParameters&) {}),
          with("dampers",
               [](FingerParameters& finger) {
                 finger.damping = 2.0;
                 finger.twist_damping = 2e-5;
               }),
          with("radius grows with the load",
               [](FingerParameters& finger) { finger.radius_law = RadiusLaw::power(0.004, 0.3); }),
          with("mu_dynamic below mu", [](FingerParameters& finger) { finger.mu_dynamic = 0.3; }),
          with("mu_dynamic 0", [](FingerParameters& finger) { finger.mu_dynamic = 0.0; }),
          with("mu 0", [](FingerParameters& finger) { finger.mu = 0.0; }),
          with("moment coefficient",
               [](FingerParameters& finger) {
                 finger.mu_r = 0.002;
                 finger.mu_r_dynamic = 0.001;
               }),
          with("moment coefficient 0", [](FingerParameters& finger) { finger.mu_r = 0.0; }),
          with("moment coefficient 0 while it slips",
               [](FingerParameters& finger) {
                 finger.mu_r = 0.002;
                 finger.mu_r_dynamic = 0.0;
               }),
          with("all at once", [](FingerParameters& finger) {
            finger.damping = 1.0;
            finger.twist_damping = 1e-5;
            finger.mu_dynamic = 0.4;
            finger.radius_law = RadiusLaw::power(0.005, 0.2);
          })};
}

struct Choice {
  NamedSurface surface;
  CurveChoice curve;
  NamedParameters parameters;
};

/// Calls `body(choice, random)` for every curve on every surface, with the sets of parameters in turn. As often as the
/// environment's LIMITCURVE_ROUNDS says, each time with other random numbers and the next set of parameters: ten rounds
/// are every one with every other.
template <class Body>
void for_each_choice(std::uint64_t seed, Body&& body) {
  const char* const given = std::getenv("LIMITCURVE_ROUNDS");
  const std::uint64_t rounds = given != nullptr ? std::stoull(given) : 1;
  const auto surfaces = all_surfaces();
  const auto parameter_sets = all_parameters();
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Random random(seed + 1000 * round);
    std::size_t next = static_cast<std::size_t>(seed + round);
    for (const CurveChoice& curve : all_curves()) {
      for (const NamedSurface& surface : surfaces) {
        const Choice choice{surface, curve, parameter_sets[next++ % parameter_sets.size()]};
        SCOPED_TRACE(choice.surface.name + ", " + curve.name() + ", " + choice.parameters.name + ", round " +
                     std::to_string(round));
        body(choice, random);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

inline Vector3d random_direction(Random& random) {
  Vector3d way;
  do {
    way = random.vector(1.0);
  } while (!(way.squaredNorm() > 0.01 && way.squaredNorm() < 1.0));
  return way.normalized();
}

inline Quaterniond random_orientation(Random& random) {
  return Quaterniond(AngleAxisd(random.uniform(-std::numbers::pi, std::numbers::pi), random_direction(random)));
}

/// A smooth random function of time: an offset and a sine.
class Wave {
 public:
  Wave(Random& random, double offset, double amplitude, double low, double high)
      : offset_(offset),
        amplitude_(amplitude),
        speed_(random.logarithmic(low, high)),
        phase_(random.uniform(0.0, 6.0)) {}
  [[nodiscard]] double at(double time) const { return offset_ + amplitude_ * std::sin(speed_ * time + phase_); }

 private:
  double offset_;
  double amplitude_;
  double speed_;  // [rad/s]
  double phase_;
};

/// A device that presses about 1 mm into a surface near a random point, slides a few mm to and fro, turns and twists,
/// rests at times and lifts off at times.
class RandomDevice {
 public:
  RandomDevice(const AnySurface& surface, Random& random)
      : along_{Wave(random, 0.0, random.uniform(0.0, 0.005), 3.0, 60.0),
               Wave(random, 0.0, random.uniform(0.0, 0.005), 3.0, 60.0)},
        depth_(random, random.uniform(0.0005, 0.002), random.uniform(0.0, 0.0015), 3.0, 40.0),
        twist_(random, random.uniform(-3.0, 3.0), random.uniform(0.0, 1.0), 3.0, 60.0),
        tilt_(random, 0.0, random.uniform(0.0, 0.7), 3.0, 60.0),
        orientation_(random_orientation(random)),
        axis_(random_direction(random)),
        rest_(random.uniform(0.0, 0.15)) {
    Vector3d from = 0.2 * random_direction(random);
    from.z() = std::fabs(from.z());  // above the plane
    const Contact contact = surface.contact(from, {});
    place_ = contact.point;
    normal_ = contact.normal;
    tangent_ = normal_.unitOrthogonal();
  }

  [[nodiscard]] DevicePose at(double time) const {
    if (time > rest_ && time < rest_ + 0.02) time = rest_;  // repeated samples
    const Vector3d position = place_ + tangent_ * along_[0].at(time) + normal_.cross(tangent_) * along_[1].at(time) -
                              normal_ * depth_.at(time);
    return {position, Quaterniond(AngleAxisd(tilt_.at(time), axis_)) * orientation_, twist_.at(time)};
  }
  [[nodiscard]] const Vector3d& normal() const { return normal_; }

 private:
  std::array<Wave, 2> along_;
  Wave depth_;
  Wave twist_;
  Wave tilt_;
  Quaterniond orientation_;
  Vector3d axis_;
  double rest_;
  Vector3d place_;
  Vector3d normal_;
  Vector3d tangent_;
};

/// How far results may be apart when positions are off by `length` [m] and angles by `angle` [rad], each in every one
/// of `steps` samples. A slip is the way to the nearest point of a convex set in the metric of the springs' energy,
/// which brings no two trials farther apart; so errors add, in √(2E) = |(√k_l x, √k_r α)|, and the limits' own error,
/// of the load, adds to each. `margin` covers what that leaves out: the two other projections, and a contact's several
/// roundings.
struct Tolerance {
  double length;
  double angle;
  double force;
  double moment;

  static Tolerance of(const FingerParameters& finger, double time_step, double length, double angle, int steps,
                      double margin = 10.0) {
    const double per_second = time_step > 0.0 ? 1.0 / time_step : 0.0;
    const double stiff = std::sqrt(finger.stiffness + finger.damping * per_second);
    const double twist_stiff = std::sqrt(finger.twist_stiffness + finger.twist_damping * per_second);
    const double energy = margin * steps * (stiff * length + twist_stiff * angle);
    return {energy / stiff, energy / twist_stiff, energy * stiff, energy * twist_stiff};
  }
};

}  // namespace limitcurve::godobject::test
