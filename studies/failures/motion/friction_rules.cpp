// SPDX-License-Identifier: MIT
// Entry "projection": wrong rules.
#include "../failures.hpp"
#include "../numerics/sampling.hpp"
#include "bristles.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

/// Force and moment in units of their limits, for a steady twist about s, if one is limited first and the other within the rest
/// of the ellipse. Both springs stretch at a constant rate, a tenth of the limit a step.
std::pair<double, double> one_after_the_other(double s, bool force_first, double moment_ratio) {
  const SlipTwist twist = SlipTwist::about_cor(s);
  double force = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 2000; ++i) {
    force += 0.1 * twist.slide / (twist.slide + twist.spin);
    moment += 0.1 * twist.spin / (twist.slide + twist.spin) / moment_ratio;
    double& first = force_first ? force : moment;
    double& second = force_first ? moment : force;
    first = std::min(first, 1.0);
    second = std::min(second, std::sqrt(1.0 - first * first));
  }
  return {force, moment};
}

constexpr double static_limit = 0.6;  // μ_s P [N]
constexpr double dynamic_limit = 0.5;
constexpr double contact_stiffness = 1000.0;
constexpr double tick = 1e-3;

/// The rule that tests the static limit in every step, and lets the proxy slip to the dynamic limit if it is exceeded.
class AskedEveryStep {
 public:
  AskedEveryStep(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {}

  /// Friction on the finger at x, moving at a speed.
  double update(double x, double speed) {
    double force = stiffness_ * (proxy_ - x);
    if (std::fabs(force - damping_ * speed) > static_limit) {
      force = std::copysign(dynamic_limit, force);
      proxy_ = x + force / stiffness_;
      return force;
    }
    return force - damping_ * speed;
  }

 private:
  double stiffness_;
  double damping_;
  double proxy_ = 0.0;
};

SoftFinger two_limits(double stiffness, double damping) {
  FingerParameters with;
  with.mu = static_limit;
  with.mu_dynamic = dynamic_limit;
  with.stiffness = stiffness;
  with.damping = damping;
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}

/// Under a load of 1 N.
Contact pressed(double x, double stiffness) {
  return {{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), 1.0 / stiffness};
}

/// Forces during one second of a drag at a steady speed.
std::vector<double> dragged(double speed, bool ours) {
  AskedEveryStep rule(contact_stiffness, 0.0);
  auto finger = two_limits(contact_stiffness, 0.0);
  std::vector<double> forces;
  for (int i = 0; i < 1000; ++i) {
    const double x = speed * tick * i;
    forces.push_back(ours ? -finger.update(pressed(x, contact_stiffness), 0.0).force.x() : -rule.update(x, speed));
  }
  return forces;
}

/// Mean time between the largest forces; 0 if there are no two.
double period(const std::vector<double>& forces, double step, double level) {
  int first = -1;
  int last = -1;
  int count = 0;
  for (std::size_t i = 1; i < forces.size(); ++i) {
    if (forces[i - 1] < level || forces[i] >= level) continue;
    if (first < 0) first = static_cast<int>(i);
    last = static_cast<int>(i);
    ++count;
  }
  return count > 1 ? step * (last - first) / (count - 1) : 0.0;
}

double swing(const std::vector<double>& forces) {
  const auto [least, most] = std::minmax_element(forces.begin() + static_cast<std::ptrdiff_t>(forces.size() / 2), forces.end());
  return *most - *least;
}

/// A mass that a soft spring pulls over the ground at a steady speed: friction makes it stick and slip.
struct Drawn {
  double mass = 0.05;
  double spring = 50.0;
  double contact_stiffness = 2e4;
  double contact_damping = 10.0;
  double step = 1e-5;

  /// For a rigid contact: it sticks while the spring gains 2ΔF, then slides for the rest of an oscillation.
  [[nodiscard]] double exact_period(double speed) const {
    const double omega = std::sqrt(spring / mass);
    const double drop = static_limit - dynamic_limit;
    return 2.0 * drop / (spring * speed) + 2.0 * (std::numbers::pi - std::atan(drop * omega / (spring * speed))) / omega;
  }

  /// By simulation, from the drops of the spring's force through its middle.
  [[nodiscard]] double simulated(double speed, bool ours) const {
    AskedEveryStep rule(contact_stiffness, contact_damping);
    auto finger = two_limits(contact_stiffness, contact_damping);
    double x = 0.0;
    double v = 0.0;
    std::vector<double> forces;
    for (int i = 0; i < 200'000; ++i) {
      const double pull = spring * (speed * step * i - x);
      const double friction = ours ? finger.update(pressed(x, contact_stiffness), 0.0, step).force.x() : rule.update(x, v);
      v += step * (pull + friction) / mass;
      x += step * v;
      forces.push_back(pull);
    }
    return period(forces, step, dynamic_limit);
  }
};

}  // namespace

Hazard order_of_limits() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"projection_order", {}});
  const Law law = hertz();
  const double m0 = law->moment_ratio();
  const Table table = Table::build(law, 1e-8);
  const ExactCurve curve(law);
  std::array<double, 3> worst{};
  for (const double s : in_ratios(0.01, 100.0, 61)) {
    const UnitWrench exact = curve.wrench(SlipTwist::about_cor(s));
    const UnitWrench ours = table.wrench(SlipTwist::about_cor(s));
    const std::array wrenches{one_after_the_other(s, true, m0), one_after_the_other(s, false, m0), std::pair(ours.force, ours.moment / m0)};
    constexpr std::array series{"force limited first", "moment limited first", "limitcurve"};
    for (std::size_t i = 0; i < series.size(); ++i) {
      figure.rows.push_back({"force", series[i], s, wrenches[i].first});
      figure.rows.push_back({"moment", series[i], s, wrenches[i].second});
      if (s < 0.1 || s > 10.0) continue;
      worst[i] = std::max(worst[i], std::hypot(wrenches[i].first - exact.force, wrenches[i].second - exact.moment / m0));
    }
  }
  const std::string quantity = "error of the wrench of a steady twist (0.1 ≤ c/a ≤ 10)";
  found.findings.push_back({"order of the limits", "force first, moment within the rest", quantity, worst[0], worst[2]});
  found.findings.push_back({"order of the limits", "moment first, force within the rest", quantity, worst[1], worst[2]});
  return found;
}

Hazard chatter() {
  Hazard found;
  constexpr double speed = 0.005;
  const std::vector<double> asked = dragged(speed, false);
  const std::vector<double> ours = dragged(speed, true);
  const double drop = static_limit - dynamic_limit;
  found.findings.push_back({"μ_s > μ_d, a steady drag", "static limit in every step", "swing of the force, in (μ_s − μ_d)P",
                            swing(asked) / drop, swing(ours) / drop});
  found.findings.push_back({"μ_s > μ_d, a steady drag", "static limit in every step", "chatter of 1/s, at 5 mm/s (steady force: 0)",
                            1.0 / period(asked, tick, 0.99 * static_limit),
                            swing(ours) > 0.0 ? 1.0 / period(ours, tick, dynamic_limit) : 0.0});
  const Drawn drawn;
  double asked_error = 0.0;
  double our_error = 0.0;
  for (const double v : in_ratios(0.02, 0.2, 13)) {
    const double exact = drawn.exact_period(v);
    asked_error = std::max(asked_error, std::fabs(drawn.simulated(v, false) / exact - 1.0));
    our_error = std::max(our_error, std::fabs(drawn.simulated(v, true) / exact - 1.0));
  }
  found.findings.push_back({"μ_s > μ_d, stick–slip of a mass", "static limit in every step",
                            "relative error of the period (20 to 200 mm/s)", asked_error, our_error});
  return found;
}

Hazard collapsing_load() {
  Hazard found;
  constexpr double mu = 0.5;
  FingerParameters with;
  with.mu = mu;
  with.stiffness = contact_stiffness;
  SoftFinger finger(Table::build(hertz(), 1e-8), with);
  // The same stiffness at 5 N, fixed or in proportion to the load.
  Bristles bristles(contact_stiffness, 0.0);
  Bristles per_newton(contact_stiffness / 5.0, 0.0);
  const auto contact = [](double x, double load) { return Contact{{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), load / contact_stiffness}; };
  // A load of 5 N, a deflection up to the limit, then a drop to 5 mN in one step, at rest.
  finger.update(contact(0.0, 5.0), 0.0);
  for (int i = 0; i <= 1000; ++i) {
    finger.update(contact(1e-5 * i, 5.0), 0.0);
    bristles.update(1e-5 * i, mu * 5.0);
    per_newton.update(1e-5 * i, mu);
  }
  const FingerOutput let_go = finger.update(contact(0.01, 0.005), 0.0);
  const double bristle_force = bristles.update(0.01, mu * 0.005);
  const double scaled_force = 0.005 * per_newton.update(0.01, mu);
  const std::string quantity = "friction force at rest / limit (load to a thousandth in one step)";
  const double ours = let_go.force.norm() / (mu * let_go.load);
  found.findings.push_back(
      {"load drops in one step", "bristles of a fixed stiffness (Dahl, LuGre)", quantity, bristle_force / (mu * 0.005), ours});
  found.findings.push_back({"load drops in one step", "bristles of a stiffness in proportion to the load (LuGre of tyres)", quantity,
                            scaled_force / (mu * 0.005), ours});
  return found;
}

}  // namespace limitcurve::stability
