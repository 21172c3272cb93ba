// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/scene/passivity.hpp"

#include "tests/godobject/random_scene.hpp"

#include <deque>

/// What a user can win from a finger along a path of the device, and a search for the path that wins most.
namespace limitcurve::godobject::test {

using Path = std::vector<DevicePose>;

/// The work that the springs did on the user, and how much of it may be rounding [J].
struct Won {
  double work = 0.0;
  double rounding = 0.0;
  [[nodiscard]] double beyond_rounding() const { return work - rounding; }
};

/// Counts the work that a finger without dampers does on its user, who leads the device slowly from sample to sample:
/// the springs' force and moment, integrated along the path while the proxy rests; then the proxy may slip. Work is
/// force times displacement from the rendered wrench, k_l, k_r and the positions of proxy and finger; the library's
/// energies are not used.
class SlowUser {
 public:
  explicit SlowUser(SoftFinger finger) : finger_(std::move(finger)) {}

  void move(const AnySurface& surface, const DevicePose& to) {
    const FingerParameters& with = finger_.parameters();
    const FingerState before = finger_.state();
    const FingerOutput from = finger_.output();
    const double was_stored = stored();
    const FingerOutput now = finger_.update(surface, to);
    const bool had_contact = before.in_contact;
    const bool has_contact = finger_.state().in_contact;
    if (had_contact && has_contact) {
      const Vector3d way = to.position - last_;
      const Vector3d felt = from.whole_force();
      const Vector3d at_end = with.stiffness * (from.proxy - to.position);
      const double turn = finger_.state().sample.angle - before.sample.angle;
      const double moment_at_end = from.moment - with.twist_stiffness * turn;
      won_.work += 0.5 * (felt + at_end).dot(way) + 0.5 * (from.moment + moment_at_end) * turn;
      round(felt.norm() + at_end.norm(), (std::fabs(from.moment) + std::fabs(moment_at_end)), finger_.state());
    } else if (has_contact) {
      // From the surface on.
      won_.work -= 0.5 * with.stiffness * (now.proxy - to.position).squaredNorm();
      round(with.stiffness * now.depth, 0.0, finger_.state());
    } else if (had_contact) {
      // At most what was stored: nothing has slipped yet.
      won_.work += was_stored;
    }
    last_ = to.position;
  }

  [[nodiscard]] const Won& won() const { return won_; }
  /// What the springs still hold [J].
  [[nodiscard]] double stored() const {
    if (!finger_.state().in_contact) return 0.0;
    const FingerOutput now = finger_.output();
    const FingerParameters& with = finger_.parameters();
    return 0.5 * with.stiffness * (now.proxy - last_).squaredNorm() +
           0.5 * now.moment * now.moment / with.twist_stiffness;
  }
  [[nodiscard]] const SoftFinger& finger() const { return finger_; }

 private:
  /// Places are right to ε of their size, which is some 0.1 m, angles to ε of theirs; forces and moments act over that.
  void round(double force, double moment, const FingerState& state) {
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    won_.rounding += 16.0 * ulp * (force * (0.1 + last_.norm()) + moment * (1.0 + std::fabs(state.sample.angle)));
  }

  SoftFinger finger_;
  Vector3d last_ = Vector3d::Zero();
  Won won_;
};

/// Counts what a device whose finger's wrench is sampled, comes `delay` samples late and is held for a time step does
/// on its user, who leads it in a straight line, turning evenly, from sample to sample; less what the device's own
/// damper takes, which is least then.
class SampledUser {
 public:
  SampledUser(SoftFinger finger, DeviceDamping device, double time_step, int delay)
      : finger_(std::move(finger)),
        device_(device),
        time_step_(time_step),
        rendered_(static_cast<std::size_t>(delay) + 1) {}

  void move(const AnySurface& surface, const DevicePose& to) {
    const FingerOutput held = rendered_.front();
    const bool touches = held.state == ContactState::stick || held.state == ContactState::slip;
    const Vector3d way = to.position - last_.position;
    AngleAxisd turned(to.orientation * last_.orientation.conjugate());
    if (turned.angle() > std::numbers::pi) turned.angle() -= 2.0 * std::numbers::pi;
    const Vector3d turn = turned.axis() * turned.angle();
    const double twist = to.twist - last_.twist;
    const FingerOutput now = finger_.update(surface, to, time_step_);
    if (started_) {
      if (touches) {
        const Vector3d force = held.whole_force();
        won_.work += force.dot(way) + held.moment * (held.normal.dot(turn) + twist);
        won_.rounding +=
            16.0 * std::numeric_limits<double>::epsilon() *
            (force.norm() * (0.1 + to.position.norm()) + std::fabs(held.moment) * (1.0 + std::fabs(now.angle)));
        // The spin is counted about the mean of two normals, the held moment acts about the first of them.
        turning_normal_ += 0.5 * std::fabs(held.moment) * (now.normal - held.normal).norm() * turn.norm();
      }
      // About the normal it turns by both.
      const double spin = turn.norm() + std::fabs(twist);
      won_.work -= (device_.sliding * way.squaredNorm() + device_.twist * spin * spin) / time_step_;
    }
    started_ = true;
    last_ = to;
    rendered_.pop_front();
    rendered_.push_back(now);
  }

  [[nodiscard]] const Won& won() const { return won_; }
  /// Σ ½ |M| |Δn| |Δθ| [J], of a device that turns while its finger's normal does.
  [[nodiscard]] double turning_normal() const { return turning_normal_; }

 private:
  SoftFinger finger_;
  DeviceDamping device_;
  double time_step_;
  std::deque<FingerOutput> rendered_;  // the oldest acts now
  DevicePose last_;
  bool started_ = false;
  Won won_;
  double turning_normal_ = 0.0;
};

/// Range of a device's motion about a point of a surface: largest depth [m], sideways displacement [m] and rotation
/// [rad].
struct Reach {
  Vector3d place;
  Vector3d normal;
  double depth;
  double aside;
  double turn;
  double twist;
};

/// A position within reach; `outside` is above the surface.
inline DevicePose random_pose(const Reach& reach, Random& random, bool outside = false) {
  const Vector3d tangent = reach.normal.unitOrthogonal();
  const double depth = outside ? -0.001 : random.uniform(0.0, reach.depth);
  const Vector3d aside = tangent * random.uniform(-reach.aside, reach.aside) +
                         reach.normal.cross(tangent) * random.uniform(-reach.aside, reach.aside);
  const Quaterniond turned(AngleAxisd(random.uniform(0.0, reach.turn), random_direction(random)));
  return {reach.place - reach.normal * depth + (outside ? Vector3d::Zero() : aside), turned,
          random.uniform(-reach.twist, reach.twist)};
}

/// Moves one or two poses of a path, or all, by a share of their reach.
inline Path changed(const Path& path, const Reach& reach, double share, Random& random) {
  Path result = path;
  const double which = random.uniform(0.0, 1.0);
  const auto mix = [&](DevicePose& pose) {
    const DevicePose other = random_pose(reach, random);
    pose.position += share * (other.position - (reach.place - 0.5 * reach.depth * reach.normal));
    pose.orientation = pose.orientation.slerp(share, other.orientation * pose.orientation).normalized();
    pose.twist += share * other.twist;
  };
  if (which < 0.2) {
    for (DevicePose& pose : result) mix(pose);
  } else {
    for (int i = 0; i < (which < 0.7 ? 1 : 2); ++i)
      mix(result[static_cast<std::size_t>(random.uniform(0.0, 0.999) * static_cast<double>(path.size()))]);
  }
  if (random.uniform(0.0, 1.0) < 0.1) {  // one pose as another
    const auto any = [&] {
      return static_cast<std::size_t>(random.uniform(0.0, 0.999) * static_cast<double>(path.size()));
    };
    result[any()] = result[any()];
  }
  return result;
}

/// The best of a random path and `tries` changes of it, each kept if it is not worse. Returns the best value.
template <class Value>
double climb(Path path, const Reach& reach, int tries, Random& random, Value&& value) {
  double best = value(path);
  for (int i = 0; i < tries; ++i) {
    const Path next = changed(path, reach, random.logarithmic(1e-3, 1.0), random);
    const double found = value(next);
    if (!(found >= best)) continue;
    best = found;
    path = next;
  }
  return best;
}

}  // namespace limitcurve::godobject::test
