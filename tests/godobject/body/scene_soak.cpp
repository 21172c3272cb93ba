// SPDX-License-Identifier: MIT
// Random scenes without end: one to four fingers on a body of any shape that rests, is moved or is free, every curve and
// projection, radius laws, dampers, static and dynamic friction. In every step of every finger
//   · what slip dissipates is ≥ 0,
//   · all outputs are finite,
//   · the wrench is within the limit of the load,
//   · a finger that sticks has not moved its proxy by a single bit;
// the momentum of a free body changes by the impulse of the forces as they are rendered, and between fingers at rest without gravity it gains
// no more energy than godobject/README.md, "Bodies", says.
//     scene_soak [FINGER_STEPS [SEED]]
// Prints what it saw and exits with 1 after the first scene that is wrong, which it names so that it can be run again.
#include "godobject/body/grasp.hpp"
#include "limitcurve/internal/number.hpp"
#include "tests/godobject/scene.hpp"

#include <cinttypes>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Tally {
  std::uint64_t finger_steps = 0;
  std::uint64_t slips = 0;
  std::uint64_t sticks = 0;
  std::uint64_t scenes = 0;
  std::uint64_t body_steps = 0;
  std::uint64_t divided = 0;
  std::uint64_t unsolved = 0;
  std::uint64_t unsolved_refused = 0;  // with a refused sample: such a step has no parts
  double momentum_error = 0.0;
  double least_work = std::numeric_limits<double>::infinity();  // of a slip [J]
  double most_beyond = -1.0;                                    // how far a wrench is beyond the limit, as a share of it
  double rise_of_bound = 0.0;                                   // of the energy in one step, as a share of what it may add
  std::string fault = {};
};

/// Of the energy at first, in one step: what rounding may add.
constexpr double rounding_bound = 1e-12;

constexpr int steps_per_scene = 500;

Quaterniond rotation(Random& random, double angle) {
  return Quaterniond(Eigen::AngleAxisd(random.uniform(-angle, angle), (random.vector(1.0) + Vector3d(1e-9, 0.0, 0.0)).normalized()));
}

AnySurface surface(Random& random, double size) {
  switch (random.bits() % 5) {
    case 0:
      return AnySurface(PlaneSurface{});
    case 1:
      return AnySurface(SphereSurface(size));
    case 2:
      return AnySurface(CapsuleSurface(0.5 * size, size));
    case 3:
      return AnySurface(CylinderSurface(size, 0.5 * size));
    default:
      return AnySurface(BoxSurface({size, 0.5 * size, random.uniform(0.02, 1.0) * size}));
  }
}

RadiusLaw radius(Random& random) {
  static const std::array<LoadSample, 4> measured{{{0.3, 0.002}, {1.0, 0.0026}, {3.0, 0.0034}, {9.0, 0.0031}}};
  switch (random.bits() % 4) {
    case 0:
      return RadiusLaw::constant(random.logarithmic(1e-4, 0.05));
    case 1:
      return RadiusLaw::hertz(0.008, 2e5);
    case 2:
      return RadiusLaw::power(0.00207, 0.259);
    default:
      return RadiusLaw::sampled(measured);
  }
}

FingerParameters finger(Random& random) {
  FingerParameters result;
  result.mu = random.logarithmic(0.01, 3.0);
  if (random.bits() % 3 == 0) result.mu_dynamic = result.mu * random.uniform(0.1, 1.0);
  result.radius_law = radius(random);
  if (random.bits() % 4 == 0) result.mu_r = random.logarithmic(1e-4, 0.02);
  result.stiffness = random.logarithmic(10.0, 1e5);
  result.twist_stiffness = result.stiffness * random.logarithmic(1e-7, 1e-3);
  if (random.bits() % 2 == 0) {
    result.damping = result.stiffness * random.logarithmic(1e-5, 1e-2);
    result.twist_damping = result.twist_stiffness * random.logarithmic(1e-5, 1e-2);
  }
  return result;
}

/// The friction of a finger, as named.
struct Choice {
  std::string name;
  FingerCurve curve;
  Projection projection;
};

/// One scene with this curve and projection. Everything in it follows from the seed.
class SoakScene {
 public:
  SoakScene(const Choice& choice, std::uint64_t seed, Tally& tally)
      : random_(seed), tally_(tally), size_(random_.logarithmic(0.01, 0.1)), hand_(make(choice)) {
    devices_.resize(hand_.finger_count());
    for (DevicePose& device : devices_) device = {random_.vector(0.9 * size_), rotation(random_, 3.0), 0.0};
  }

  /// How it goes wrong; empty if it does not.
  std::string run() {
    ++tally_.scenes;
    const double time_step = random_.logarithmic(1e-5, 1e-2);
    const std::uint64_t kind = random_.bits() % 10;
    if (kind == 0) return rest(time_step);
    const double stride = random_.logarithmic(1e-6, 0.2) * size_;
    BodyState body;
    hand_.place(body, devices_);
    for (int i = 0; i < steps_per_scene; ++i) {
      remember();
      for (DevicePose& device : devices_) wander(device, stride);
      if (kind == 1) {
        const BodyState start = hand_.body();
        hand_.step(devices_, time_step);
        if (hand_.divided() == divided_) tally_.momentum_error = std::max(tally_.momentum_error, momentum_error(hand_, start, time_step));
        if (!(tally_.momentum_error <= 1e-11))
          return "momentum is off by " + format_number(tally_.momentum_error) + " in step " + std::to_string(i);
      } else {
        if (kind > 5) {
          body.position += random_.vector(0.3 * stride);
          body.orientation = (rotation(random_, stride / size_) * body.orientation).normalized();
        }
        hand_.carry(body, devices_, time_step);
      }
      if (std::string fault = wrong(); !fault.empty()) return fault + " in step " + std::to_string(i);
    }
    tally_.divided += hand_.divided();
    if (kind == 1) tally_.body_steps += steps_per_scene;
    return {};
  }

 private:
  Grasp make(const Choice& choice) {
    BodyParameters body = BodyParameters::block(random_.logarithmic(1e-3, 10.0), Vector3d::Constant(size_) + 0.5 * random_.vector(size_));
    if (random_.bits() % 2 == 0) body.gravity.setZero();
    if (random_.bits() % 3 == 0) body.free = {true, true, false, false, false, true};
    const FingerParameters with = finger(random_);
    const std::size_t fingers = 1 + random_.bits() % 4;
    return {body, BodyState{}, surface(random_, size_),
            std::vector<SoftFinger>(fingers, SoftFinger(choice.curve, with, choice.projection))};
  }

  void wander(DevicePose& device, double stride) {
    // Now and then it jumps: to another side, off, or deep into the body; and back if it is too far.
    if (random_.bits() % 100 == 0 || (device.position - hand_.body().position).norm() > 1.2 * size_) {
      device.position = hand_.body().to_world(random_.vector(0.9 * size_));
    } else {
      device.position += random_.vector(stride);
    }
    device.orientation = (rotation(random_, stride / size_) * device.orientation).normalized();
    device.twist += random_.uniform(-1.0, 1.0) * stride / size_;
  }

  /// Fingers at rest, pressed from two sides on a body that is knocked: its energy must not rise.
  std::string rest(double time_step) {
    BodyParameters body = hand_.parameters();
    const bool planar = !body.free[2];
    body.gravity.setZero();
    const Vector3d half = Vector3d::Constant(0.5 * size_);
    Grasp held(body, BodyState{}, AnySurface(BoxSurface(half)), {hand_.finger(0), hand_.finger(0)});
    const double depth = random_.logarithmic(1e-3, 0.1) * size_;
    // Pressed along the axis that a planar body turns about, or in the plane.
    const auto axis = static_cast<Eigen::Index>(random_.bits() % 3);
    Vector3d at = random_.vector(0.3 * size_);
    at[axis] = 0.0;
    const Vector3d reach = (half.x() - depth) * Vector3d::Unit(axis);
    const std::array<DevicePose, 2> pinch{DevicePose{at + reach}, DevicePose{at - reach}};
    held.place(BodyState{}, pinch);
    BodyState knocked;
    const double speed = random_.logarithmic(1e-3, 1.0);
    knocked.velocity = random_.vector(speed);
    knocked.angular_velocity = random_.vector(speed / size_);
    if (planar) {
      knocked.velocity.z() = 0.0;
      knocked.angular_velocity.head<2>().setZero();
    }
    if (random_.bits() % 2 == 0) {
      // The gripped point rests, and friction pulls it towards the centre of mass: what the turn of a step adds is not lost elsewhere.
      const FingerParameters& with = held.finger(0).parameters();
      const Vector3d lever = planar ? Vector3d(at.x(), at.y(), 0.0) : at;
      const double stretch = random_.uniform(0.0, 1.0) * std::min(with.mu, 1.0) * depth;
      const double spin = random_.uniform(1.0, 10.0) * std::sqrt(2.0 * with.stiffness * stretch / (body.mass * lever.norm()));
      knocked.angular_velocity *= std::min(spin, 0.5 / time_step) / knocked.angular_velocity.norm();
      knocked.velocity = -knocked.angular_velocity.cross(lever);
      knocked.position = stretch * lever.normalized();
    }
    held.place(knocked, pinch);
    const double first = held.energy();
    double last = first;
    double spun = knocked.angular_velocity.norm();
    for (int i = 0; i < steps_per_scene; ++i) {
      held.step(pinch, time_step);
      for (std::size_t k = 0; k < 2; ++k) {
        ++tally_.finger_steps;
        if (!(held.finger(k).output().slip_work >= 0.0)) return "slip work of a held body in step " + std::to_string(i);
      }
      const double now = held.energy();
      // What the finite angle turned in the step may add (README, "Bodies").
      const double turned = std::max(held.body().angular_velocity.norm(), spun) * time_step;
      spun = held.body().angular_velocity.norm();
      double levers = 0.0;
      double moments = 0.0;
      for (std::size_t k = 0; k < 2; ++k) {
        const FingerOutput output = held.finger(k).output();
        levers += held.force_on_user(k).norm() * output.proxy.norm();
        moments += std::fabs(output.moment);
      }
      const double may_add = turned * turned * (planar ? 0.5 * levers : first + levers + moments);
      const double rise = now - last - rounding_bound * first;
      tally_.rise_of_bound = std::max(tally_.rise_of_bound, rise / may_add);
      if (!(rise <= may_add)) {
        return "energy rises by " + format_number(rise / first) + " of the first, turning by " + format_number(turned) + ", in step " +
               std::to_string(i) + (planar ? " (planar)" : " (spatial)");
      }
      last = now;
    }
    tally_.body_steps += steps_per_scene;
    tally_.divided += held.divided();
    tally_.unsolved += held.unsolved();
    return {};
  }

  /// How far the body's momentum is from that before a step and the impulse of the forces as they are rendered, of the larger of both.
  static double momentum_error(const Grasp& hand, const BodyState& before, double time_step) {
    const BodyParameters& body = hand.parameters();
    const BodyState& now = hand.body();
    Vector3d force = body.mass * body.gravity;
    Vector3d moment = Vector3d::Zero();
    double sizes = force.norm();
    for (std::size_t i = 0; i < hand.finger_count(); ++i) {
      const Vector3d on_body = -hand.force_on_user(i);
      force += on_body;
      moment += (now.orientation * hand.finger(i).state().sample.position()).cross(on_body) - hand.moment_on_user(i);
      sizes += on_body.norm();
    }
    Vector3d linear = body.mass * (now.velocity - before.velocity) - force * time_step;
    Vector3d angular = angular_momentum(body, now) - angular_momentum(body, before) - moment * time_step;
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (!body.free[static_cast<std::size_t>(i)]) linear[i] = 0.0;
      if (!body.free[static_cast<std::size_t>(i) + 3]) angular[i] = 0.0;
    }
    const double gyration = std::sqrt(body.inertia.mean() / body.mass);
    const double size = body.mass * (before.velocity.norm() + now.velocity.norm()) + sizes * time_step +
                        (angular_momentum(body, before).norm() + angular_momentum(body, now).norm()) / gyration;
    return (linear.norm() + angular.norm() / gyration) / size;
  }

  void remember() {
    before_.clear();
    divided_ = hand_.divided();
    unsolved_ = hand_.unsolved();
    for (std::size_t i = 0; i < hand_.finger_count(); ++i) before_.push_back(hand_.finger(i).state());
  }

  /// Whether a finger is refused with reason: a body that is flung away from a device leaves it behind by more than it may be displaced.
  static bool leapt(const FingerState& before, const SoftFinger& finger) {
    const Vector3d seen = finger.state().faults.refused_at;
    const Vector3d good = before.sample.position();
    const double limit = finger.parameters().max_displacement;
    return (seen - good).norm() > limit && !(before.faults.refused && (seen - before.faults.refused_at).norm() <= limit);
  }

  std::string wrong() {
    if (hand_.unsolved() > unsolved_) {
      bool refused = false;
      for (std::size_t i = 0; i < hand_.finger_count(); ++i) {
        refused = refused || hand_.finger(i).output().state == ContactState::invalid || before_[i].output.state == ContactState::invalid;
      }
      ++(refused ? tally_.unsolved_refused : tally_.unsolved);
    }
    for (std::size_t i = 0; i < hand_.finger_count(); ++i) {
      const SoftFinger& one = hand_.finger(i);
      const FingerOutput output = one.output();
      const FingerState& before = before_[i];
      ++tally_.finger_steps;
      tally_.slips += output.state == ContactState::slip;
      tally_.sticks += output.state == ContactState::stick;
      if (output.state == ContactState::invalid) {
        if (!leapt(before, one)) return "good input is refused";
        continue;
      }
      if (!(output.slip_work >= 0.0 && output.slip_work <= 1e300)) return "slip work " + std::to_string(output.slip_work);
      if (output.state == ContactState::slip) tally_.least_work = std::min(tally_.least_work, output.slip_work);
      if (!output.proxy.allFinite() || !output.force.allFinite() || !std::isfinite(output.moment) || !std::isfinite(output.angle))
        return "not finite";
      if (output.state == ContactState::free) continue;
      // In a step of a body in parts a finger may come off and touch down anew.
      if (output.state == ContactState::stick && before.in_contact && hand_.divided() == divided_) {
        if (!same_bits(output.proxy, before.output.proxy) || output.angle != before.output.angle) return "a stuck proxy moved";
      }
      const FrictionLimit<double> limit =
          ContactLimits(one.parameters(), one.curve()->moment_max()).at<double>(one.state().limit_load, 1.0).sticking;
      if (!(limit.force * limit.radius > 1e-100)) continue;
      const UnitWrench wrench{output.force.norm() / limit.force, std::fabs(output.moment) / (limit.force * limit.radius)};
      const double beyond = one.curve()->gauge(wrench) - 1.0;
      tally_.most_beyond = std::max(tally_.most_beyond, beyond);
      if (!(beyond <= 1.1e-12)) return "beyond the limit";
      if (!(one.margin() >= 0.0 && one.margin() <= 1.0)) return "margin " + std::to_string(one.margin());
    }
    return {};
  }

  Random random_;
  Tally& tally_;
  double size_;
  Grasp hand_;
  std::vector<DevicePose> devices_;
  std::vector<FingerState> before_;
  std::size_t divided_ = 0;
  std::size_t unsolved_ = 0;
};

/// The fingers of every law, curve and projection; what is slow to build is built once.
std::vector<Choice> choices() {
  std::vector<Choice> result;
  for (const Law& law : {hertz(), uniform(), flat_punch()}) {
    for_each_curve_and_projection(law, [&](const FingerCurve& curve, Projection projection, const std::string& name) {
      result.push_back({law->name() + ", " + name, curve, projection});
    });
  }
  return result;
}

int soak(std::uint64_t finger_steps, std::uint64_t seed) {
  const std::vector<Choice> all = choices();
  Tally tally;
  for (std::uint64_t scene = 0; tally.finger_steps < finger_steps; ++scene) {
    const Choice& choice = all[scene % all.size()];
    const std::string fault = SoakScene(choice, seed + scene, tally).run();
    if (fault.empty()) continue;
    std::printf("scene %" PRIu64 " of seed %" PRIu64 " (%s): %s\n", scene, seed, choice.name.c_str(), fault.c_str());
    return 1;
  }
  std::printf("seed %" PRIu64 ": %" PRIu64 " finger steps in %" PRIu64
              " scenes, %.1f %% slip, %.1f %% stick; none wrong. Least work of a slip: %.1e J. Farthest beyond the limit, of it: "
              "%.1e. Steps of bodies: %" PRIu64 ", in parts %" PRIu64 ", unsolved %" PRIu64 ", and with a refused sample %" PRIu64
              ", momentum off by %.1e. Largest rise of energy in a step: %.2g of its bound\n",
              seed, tally.finger_steps, tally.scenes, 100.0 * static_cast<double>(tally.slips) / static_cast<double>(tally.finger_steps),
              100.0 * static_cast<double>(tally.sticks) / static_cast<double>(tally.finger_steps), tally.least_work, tally.most_beyond,
              tally.body_steps, tally.divided, tally.unsolved, tally.unsolved_refused, tally.momentum_error, tally.rise_of_bound);
  // One step in 10^4, and one more, may be unsolved.
  return tally.unsolved > 1 + tally.body_steps / 10'000 ? 1 : 0;
}

}  // namespace
}  // namespace limitcurve::godobject::test

int main(int argc, char** argv) {
  const std::uint64_t steps = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return limitcurve::godobject::test::soak(steps, seed);
}
