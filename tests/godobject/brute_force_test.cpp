// SPDX-License-Identifier: MIT
// A finger by brute force: the paper's steps a–c with dampers, static and dynamic friction, radius laws and every
// projection, written out in plain numbers. Roots by bisection, limit curves from eq. (17) itself. It shares nothing
// with the library's step.
#include "tests/godobject/scene.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

namespace limitcurve::godobject::test::brute_force_test {
namespace {

using std::numbers::pi;

struct Vec {
  double x = 0.0, y = 0.0, z = 0.0;
};
Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
double dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double norm(const Vec& a) {
  return std::sqrt(dot(a, a));
}
Vec tangential(const Vec& a, const Vec& n) {
  return a - dot(a, n) * n;
}
Eigen::Vector3d eigen(const Vec& a) {
  return {a.x, a.y, a.z};
}

/// f and m of a slip at the angle θ: slide sin θ, spin cos θ.
using Curve = std::function<std::pair<double, double>(double)>;

/// The angle in [0, π/2] at which a rising function changes its sign.
template <class Function>
double bisect(double low, double high, Function&& rises) {
  for (int i = 0; i < 100 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (rises(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// The limits of force and moment at a load, and the curve between them.
struct Limit {
  double force;   // μP
  double radius;  // a
};

struct Model {
  Curve curve;
  bool box = false;
  double m0 = 0.0;
  Projection projection = Projection::closest_point;
  FingerParameters with;

  [[nodiscard]] double radius(double load) const {
    if (with.mu_r) return *with.mu_r / (with.mu * m0) * std::pow(load, with.gamma);
    return with.radius_law.radius(load);
  }
  [[nodiscard]] Limit limit(double load, bool slides) const {
    const double mu_d = with.mu_dynamic.value_or(with.mu);
    if (!slides) return {with.mu * load, radius(load)};
    const double part = with.mu_r_dynamic ? *with.mu_r_dynamic / *with.mu_r * with.mu / mu_d : 1.0;
    return {mu_d * load, part * radius(load)};
  }
  /// The fraction of the sliding limit within which a finger comes to rest.
  [[nodiscard]] double rest_within(bool moment) const {
    double fraction = with.mu_dynamic.value_or(with.mu) / with.mu;
    if (moment && with.mu_r_dynamic) fraction = *with.mu_r_dynamic / *with.mu_r;
    return 1.0 / (1.0 + with.rest_margin * (1.0 / fraction - 1.0));
  }
  [[nodiscard]] std::pair<double, double> on_ray(double f, double m) const {
    return curve(bisect(0.0, 0.5 * pi, [&, f = f, m = m](double angle) {
      const auto [force, moment] = curve(angle);
      return force * m - moment * f;
    }));
  }
  [[nodiscard]] double gauge(double f, double m) const {
    if (f == 0.0 && m == 0.0) return 0.0;
    const auto [force, moment] = on_ray(f, m);
    return std::hypot(f, m) / std::hypot(force, moment);
  }
  /// Force and moment that a trial wrench beyond the limit is projected to.
  [[nodiscard]] std::pair<double, double> project(double force, double moment, const Limit& limit, double load,
                                                  double ratio) const {
    const double f = force / limit.force;
    const double m = moment / (limit.force * limit.radius);
    std::pair<double, double> at;
    if (projection == Projection::closest_point) {
      const double chi = limit.radius * limit.radius * ratio;
      at = curve(bisect(0.0, 0.5 * pi, [&](double angle) {
        const auto [on_f, on_m] = curve(angle);
        return std::sin(angle) * chi * (m - on_m) - std::cos(angle) * (f - on_f);
      }));
    } else if (projection == Projection::radial || radius(load) == radius(2.0 * load)) {
      at = on_ray(f, m);
    } else {
      const double log_load = bisect(0.0, 60.0, [&](double log) {
        const double by = std::exp(log);
        return 1.0 - gauge(f / by, m / (by * radius(by * load) / radius(load)));
      });
      const double by = std::exp(log_load);
      const double grows = radius(by * load) / radius(load);
      const double angle = bisect(0.0, 0.5 * pi, [&](double angle_at) {
        const auto [on_f, on_m] = curve(angle_at);
        return on_f * m / grows - on_m * f;
      });
      at = curve(std::atan2(std::sin(angle) * grows, std::cos(angle)));
    }
    return {at.first * limit.force, at.second * limit.force * limit.radius};
  }
};

/// What a step gives; `near` if a decision is within rounding of the other one.
struct Step {
  bool touches = false;
  bool slips = false;
  Vec proxy, force;
  double load = 0.0, moment = 0.0, angle = 0.0;
  bool near = false;
};

class BruteFinger {
 public:
  explicit BruteFinger(Model model) : model_(std::move(model)) {}

  Step step(const Vec& goal, const Vec& n, double depth, double twist, double dt) {
    const FingerParameters& with = model_.with;
    Step out;
    if (!(depth > 0.0)) {
      touches_ = false;
      last_finger_ = goal - depth * n;
      turns_ = 0.0;
      last_twist_ = twist;
      out.proxy = last_finger_;
      out.angle = twist;
      return out;
    }
    const Vec finger = goal - depth * n;
    if (touches_ && std::fabs(twist - last_twist_) > pi)
      turns_ -= 2.0 * pi * std::round((twist - last_twist_) / (2.0 * pi));
    if (!touches_) {
      turns_ = 0.0;
      slides_ = spins_ = false;
      proxy_ = goal;
      angle_ = twist;
      last_finger_ = goal;
      last_angle_ = twist;
      last_depth_ = 0.0;
    }
    const double goal_angle = twist + turns_;
    const double b = dt > 0.0 ? with.damping / dt : 0.0;
    const double b_r = dt > 0.0 ? with.twist_damping / dt : 0.0;
    const Vec stretch = proxy_ - finger;
    const Vec was = proxy_ - last_finger_;
    const Vec pull = (with.stiffness + b) * tangential(stretch, n) - b * tangential(was, n);
    const double turn = (with.twist_stiffness + b_r) * (angle_ - goal_angle) - b_r * (angle_ - last_angle_);
    const double load = std::max(with.stiffness * depth + b * (depth - last_depth_), 0.0);
    const double force = norm(pull);
    const double moment = std::fabs(turn);
    const double ratio = (with.stiffness + b) / (with.twist_stiffness + b_r);

    double kept_force = force;
    double kept_moment = moment;
    if (load == 0.0) {
      // Nothing is kept without a load.
      kept_force = kept_moment = 0.0;
      out.slips = force > 0.0 || moment > 0.0;
      slides_ = out.slips && (!model_.box || force > 0.0);
      spins_ = out.slips && moment > 0.0;
    } else if (model_.box) {
      kept_force = clamp(force, model_.limit(load, false).force, model_.limit(load, true).force,
                         model_.rest_within(false), slides_, out);
      const Limit rest = model_.limit(load, false);
      const Limit slide = model_.limit(load, true);
      kept_moment = clamp(moment, rest.force * rest.radius * model_.m0, slide.force * slide.radius * model_.m0,
                          model_.rest_within(true), spins_, out);
    } else {
      const auto part = [&](bool slides) {
        const Limit limit = model_.limit(load, slides);
        return model_.gauge(force / limit.force, moment / (limit.force * limit.radius));
      };
      const double here = part(slides_);
      out.near = near(here, 1.0);
      out.slips = here > 1.0;
      if (out.slips) {
        slides_ = true;
        std::tie(kept_force, kept_moment) = model_.project(force, moment, model_.limit(load, true), load, ratio);
      } else if (slides_) {
        const double within = std::min(model_.rest_within(false), model_.rest_within(true));
        out.near = out.near || near(here, within);
        slides_ = within < 1.0 && !(here < within);
      }
    }
    const Vec friction = force > 0.0 ? (kept_force / force) * pull : Vec{};
    out.moment = moment > 0.0 ? kept_moment / moment * turn : 0.0;
    // The proxy follows on the plane, or on the paraboloid about the goal.
    double up = dot(stretch, n);
    if (kept_force < force) {
      const Vec relaxed = (b / (with.stiffness + b)) * tangential(was, n);
      const Vec left = relaxed + (1.0 / (with.stiffness + b)) * friction;
      const double before = dot(tangential(stretch, n), tangential(stretch, n));
      double rise = up - depth;
      if (rise != 0.0 && dot(left, left) < before)
        rise = std::min(rise * dot(left, left) / before, std::sqrt(up * up + before - dot(left, left)) - depth);
      up = depth + rise;
      proxy_ = goal + left + rise * n;
    }
    if (kept_moment < moment)
      angle_ = goal_angle + (out.moment + b_r * (angle_ - last_angle_)) / (with.twist_stiffness + b_r);
    out.load = (with.stiffness + b) * up - b * dot(was, n);
    if (b > 0.0) out.load = std::max(out.load, 0.0);
    out.touches = touches_ = true;
    out.proxy = proxy_;
    out.force = friction;
    out.angle = angle_;
    last_finger_ = finger;
    last_angle_ = goal_angle;
    last_twist_ = twist;
    last_depth_ = depth;
    return out;
  }

 private:
  static bool near(double one, double other) { return std::fabs(one - other) < 1e-7; }

  static double clamp(double trial, double rest, double slide, double within, bool& slides, Step& out) {
    const double limit = slides ? slide : rest;
    out.near = out.near || near(trial / limit, 1.0) || near(trial / slide, within);
    if (trial > limit) {
      out.slips = slides = true;
      return std::min(slide, trial);
    }
    slides = slides && within < 1.0 && !(trial / slide < within);
    return trial;
  }

  Model model_;
  bool touches_ = false;
  bool slides_ = false;
  bool spins_ = false;
  Vec proxy_, last_finger_;
  double angle_ = 0.0, last_angle_ = 0.0, last_twist_ = 0.0, turns_ = 0.0, last_depth_ = 0.0;
};

/// A finger's parameters, its curve and projection, at random.
struct RandomFinger {
  Model model;
  SoftFinger finger;
};

RandomFinger random_finger(Random& random) {
  static const std::array<Law, 3> laws{hertz(), uniform(), parabolic()};
  static const std::array<FingerCurve, 3> tables{exact_curve(laws[0]), exact_curve(laws[1]), exact_curve(laws[2])};
  const auto law = random.below(laws.size());
  const std::uint64_t kind = random.below(4);
  Model model;
  model.m0 = laws[law]->moment_ratio();
  FingerCurve curve = tables[law];
  if (kind == 0) {
    model.box = true;
    curve = box(1.0, model.m0);
  } else if (kind == 1) {
    curve = Ellipse::through_intercepts(model.m0);
    model.curve = [m0 = model.m0](double angle) {
      const double f = std::sin(angle);
      const double m = m0 * m0 * std::cos(angle);
      const double length = std::hypot(std::sin(angle), m0 * std::cos(angle));
      return std::pair(f / length, m / length);
    };
  } else {
    model.curve = [law = laws[law]](double angle) {
      const UnitWrench wrench = ExactCurve(law).wrench({std::sin(angle), std::cos(angle)});
      return std::pair(wrench.force, wrench.moment);
    };
  }
  if (!model.box) model.projection = projections.at(random.below(projections.size()));
  FingerParameters& with = model.with;
  with.mu = random.logarithmic(0.05, 3.0);
  if (random.below(2) == 0) with.mu_dynamic = with.mu * random.uniform(0.2, 1.0);
  switch (random.below(4)) {
    case 0:
      with.radius_law = RadiusLaw::constant(random.logarithmic(1e-3, 0.02));
      break;
    case 1:
      with.radius_law = RadiusLaw::hertz(0.008, 2e5);
      break;
    case 2:
      with.radius_law = RadiusLaw::power(0.002, random.uniform(0.05, 1.0 / 3.0));
      break;
    default:
      with.mu_r = random.logarithmic(1e-4, 0.02);
      with.gamma = random.uniform(-0.3, 1.0 / 3.0);
      if (with.mu_dynamic) with.mu_r_dynamic = *with.mu_r * random.uniform(0.2, 1.0);
  }
  with.stiffness = random.logarithmic(100.0, 1e4);
  with.twist_stiffness = with.stiffness * random.logarithmic(1e-6, 1e-4);
  with.rest_margin = random.uniform(0.0, 1.0);
  if (random.below(2) == 0) {
    with.damping = with.stiffness * random.logarithmic(1e-5, 1e-2);
    with.twist_damping = with.twist_stiffness * random.logarithmic(1e-5, 1e-2);
  }
  const SoftFinger finger(curve, with, model.projection);
  return {model, finger};
}

// 1500 random sets of parameters, on a tilted plane or a ball, pressed, dragged, twisted and lifted. A set ends where a
// decision is within 1e-7 of the other one.
TEST(BruteForce, AFingerWrittenOutDoesTheSame) {
  Random random(1500);
  int slips = 0;
  int compared = 0;
  int ended = 0;
  const int sets = study_cases(1500);
  for (int set = 0; set < sets; ++set) {
    auto [model, finger] = random_finger(random);
    const FingerParameters& with = model.with;
    BruteFinger brute(model);
    const double depth = random.logarithmic(2e-4, 2e-3);
    const double ball = random.below(2) == 0 ? 0.0 : random.logarithmic(0.03, 0.3);
    Vec along{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    Vec normal{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.1, 1.0)};
    normal = (1.0 / norm(normal)) * normal;
    along = tangential(along, normal);
    along = (1.0 / norm(along)) * along;
    const Vec aside{normal.y * along.z - normal.z * along.y, normal.z * along.x - normal.x * along.z,
                    normal.x * along.y - normal.y * along.x};
    // Loads the springs in a few steps.
    const double stride = 0.3 * with.mu * depth;
    const double load = with.stiffness * depth;
    const double swing = 0.3 * with.mu * load * model.radius(load) * model.m0 / with.twist_stiffness;
    double x = 0.0, y = 0.0, twist = 0.0;
    const double dt = random.below(4) == 0 ? 0.0 : random.logarithmic(1e-4, 1e-2);
    for (int i = 0; i < 40; ++i) {
      x += random.uniform(-1.0, 1.5) * stride;
      y += random.uniform(-1.0, 1.0) * stride;
      twist += random.uniform(-1.0, 1.5) * std::min(swing, 2.0);
      const double deep = i % 17 == 16 ? -depth : depth * random.uniform(0.8, 1.2);
      Vec n = normal;
      Vec goal = x * along + y * aside;
      if (ball > 0.0) {
        const Vec out = ball * normal + goal;
        n = (1.0 / norm(out)) * out;
        goal = ball * n;
      }
      const double given = std::remainder(twist, 2.0 * pi);
      const Step expected = brute.step(goal, n, deep, given, i == 0 ? 0.0 : dt);
      if (expected.near) {
        ++ended;
        break;
      }
      const FingerOutput found = finger.update(Contact{eigen(goal), eigen(n), deep}, given, dt);
      const std::string where =
          "set " + std::to_string(set) + " step " + std::to_string(i) + " " + std::string(to_string(model.projection));
      const ContactState state = !expected.touches ? ContactState::free
                                 : expected.slips  ? ContactState::slip
                                                   : ContactState::stick;
      ASSERT_EQ(to_string(found.state), to_string(state)) << where;
      const double force = 1e-8 * (1.0 + with.mu) * load;
      ASSERT_LE((found.force - eigen(expected.force)).norm(), force) << where;
      ASSERT_LE((found.proxy - eigen(expected.proxy)).norm(), force / with.stiffness) << where;
      ASSERT_NEAR(found.load, expected.load, force) << where;
      ASSERT_NEAR(found.moment, expected.moment, force * model.radius(load)) << where;
      // In the air the angle counts as an angle, whichever way the twist was unwrapped in contact.
      const double turn = found.angle - expected.angle;
      ASSERT_LE(std::fabs(expected.touches ? turn : std::remainder(turn, 2.0 * pi)),
                force * model.radius(load) / with.twist_stiffness + 1e-14)
          << where;
      slips += expected.slips;
      ++compared;
    }
  }
  EXPECT_GT(slips, sets * 5);
  EXPECT_GT(compared, sets * 25);
  EXPECT_LT(ended, sets / 10 + 2);
}

}  // namespace
}  // namespace limitcurve::godobject::test::brute_force_test
