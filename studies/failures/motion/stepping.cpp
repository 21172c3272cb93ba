// SPDX-License-Identifier: MIT
// Entry "time": finger springs on a light body.
#include "../failures.hpp"

#include "../../../tests/integrators.hpp"
#include "../numerics/sampling.hpp"
#include "godobject/surface.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"
#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using test::Integrator;
using test::step_by;

constexpr double tick = 1e-3;
constexpr std::array integrators{Integrator::explicit_euler, Integrator::symplectic_euler, Integrator::implicit_euler};
constexpr std::array names{"explicit Euler", "symplectic Euler", "limitcurve"};

Grasp gripped(const BodyParameters& body, const Eigen::Vector3d& edges, const FingerParameters& with) {
  const SoftFinger finger(Ellipse::through_intercepts(hertz()->moment_ratio()), with);
  return {body, BodyState{}, AnySurface(BoxSurface(0.5 * edges)), {finger, finger}};
}

/// Two fingers on the faces ±z.
std::array<DevicePose, 2> pinch(double thickness, double depth) {
  return {DevicePose{{0.0, 0.0, 0.5 * thickness - depth}}, DevicePose{{0.0, 0.0, depth - 0.5 * thickness}}};
}

/// A body on two sticking fingers, displaced a little and released. κ = kΔt²/m and ζ = b/(2√(km)) of both fingers together, or of
/// their twist.
bool gains_energy(Integrator integrator, double kappa, double zeta, bool twisting) {
  const Eigen::Vector3d edges = Eigen::Vector3d::Constant(0.04);
  BodyParameters body;
  body.mass = 0.1;
  body.inertia.setConstant(1e-4);
  body.gravity.setZero();
  body.free = {!twisting, false, false, false, false, twisting};
  FingerParameters with;
  with.mu = 1e6;
  const double inertia = twisting ? 1e-4 : body.mass;
  const double spring = 0.5 * kappa * inertia / (tick * tick);
  const double damper = zeta * std::sqrt(kappa) * inertia / tick;
  (twisting ? with.twist_stiffness : with.stiffness) = spring;
  (twisting ? with.twist_damping : with.damping) = damper;
  Grasp scene = gripped(body, edges, with);
  const auto devices = pinch(0.04, 1e-3);
  scene.place(BodyState{}, devices);
  constexpr double little = 1e-9;
  BodyState start;
  if (twisting) {
    start.orientation = Eigen::AngleAxisd(2.0 * little, Eigen::Vector3d::UnitZ());
  } else {
    start.position.x() = little;
  }
  scene.place(start, devices);
  // Long enough to show a gain of κ/2 a step.
  const int steps = 800 + static_cast<int>(1.0 / kappa);
  const int swing = 60 + static_cast<int>(7.0 / std::sqrt(kappa));
  double first = 0.0;
  double last = 0.0;
  for (int i = 0; i < steps; ++i) {
    step_by(integrator, scene, devices, tick);
    const double away = std::fabs(twisting ? scene.body().orientation.z() : scene.body().position.x());
    if (!(away <= 1e4 * little)) return true;
    if (i >= steps / 2 && i < steps / 2 + swing) first = std::max(first, away);
    if (i >= steps - swing) last = std::max(last, away);
  }
  // A decay to rounding is no growth.
  return last > 1.1 * std::max(first, 1e-3 * little);
}

constexpr double least_tried = 1e-3;
constexpr double most_tried = 1e8;

/// The largest κ tried without a gain, 0 if there is none.
double largest(Integrator integrator, double zeta, bool twisting) {
  if (gains_energy(integrator, least_tried, zeta, twisting)) return 0.0;
  double low = std::log(least_tried);
  double high = std::log(most_tried);
  if (!gains_energy(integrator, most_tried, zeta, twisting)) return most_tried;
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    (gains_energy(integrator, std::exp(middle), zeta, twisting) ? high : low) = middle;
  }
  return std::exp(low);
}

/// How far a block of 10 g falls that is held against its weight [m].
double fallen(Integrator integrator, double stiffness) {
  const Eigen::Vector3d edges{0.03, 0.03, 0.02};
  BodyParameters body = BodyParameters::block(0.01, edges);
  body.gravity = {0.0, -9.81, 0.0};
  FingerParameters with;
  with.mu = 0.6;
  with.stiffness = stiffness;
  with.twist_stiffness = 0.07;
  Grasp scene = gripped(body, edges, with);
  const auto devices = pinch(0.02, 2.0 / stiffness);
  scene.place(BodyState{}, devices);
  for (double time = 0.0; time < 5.0; time += tick) step_by(integrator, scene, devices, tick);
  // Limit the distance of a lost block.
  return std::min(std::fabs(scene.body().position.y()), 1000.0 * 0.01 * 9.81 / (2.0 * stiffness));
}

}  // namespace

Hazard light_body() {
  Hazard found;
  for (const bool twisting : {false, true}) {
    const std::string what = twisting ? "k_rΔt²/I" : "kΔt²/m";
    const double ours = largest(Integrator::implicit_euler, 0.0, twisting);
    for (const std::size_t i : {0U, 1U}) {
      found.findings.push_back({"stiff fingers, light body", std::string(names[i]) + ", undamped",
                                "largest " + what + " without a gain of energy (tried: 1e-3 to 1e8)",
                                largest(integrators[i], 0.0, twisting), ours});
    }
  }
  return found;
}

Hazard stiffness_and_damping() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"time_map", {}});
  const std::vector<double> stiffnesses = in_ratios(1e-2, 1e3, 41);
  const std::vector<double> dampings = evenly(0.0, 2.0, 21);
  std::array<double, 3> lost{};
  for (std::size_t i = 0; i < integrators.size(); ++i) {
    for (const double zeta : dampings) {
      for (const double kappa : stiffnesses) {
        const bool gains = gains_energy(integrators[i], kappa, zeta, false);
        lost[i] += gains;
        figure.rows.push_back({names[i], study::number_text(zeta), kappa, gains ? 1.0 : 0.0});
      }
    }
    lost[i] /= static_cast<double>(stiffnesses.size() * dampings.size());
  }
  // Where the characteristic polynomials have a root on the unit circle; β = bΔt/m = 2ζ√κ. The damper's speed is that of the last step.
  for (const double kappa : in_ratios(1e-2, 0.25, 60)) {
    // z³ − 2z² + (1 + κ + β)z − β: κ = β(1 − β).
    const double root = std::sqrt(std::max(1.0 - 4.0 * kappa, 0.0));
    figure.rows.push_back({names[0], "least damping", kappa, 0.25 * (1.0 - root) / std::sqrt(kappa)});
    figure.rows.push_back({names[0], "most damping", kappa, 0.25 * (1.0 + root) / std::sqrt(kappa)});
  }
  // z² − (2 − β − κ)z + 1 − β: κ + 2β = 4.
  for (const double kappa : in_ratios(1e-2, 4.0, 60)) {
    figure.rows.push_back({names[1], "most damping", kappa, 0.25 * (4.0 - kappa) / std::sqrt(kappa)});
  }
  // Two fingers of 1000 N/m on 0.1 kg at 1 kHz, without dampers (the defaults) and with those of the pivot; and 2000 N/m on 10 g.
  for (const char* name : names) {
    figure.rows.push_back({name, "defaults", 0.02, 0.0});
    figure.rows.push_back({name, "pivot", 0.02, 0.1 / (2.0 * std::sqrt(0.02))});
    figure.rows.push_back({name, "10 g", 0.4, 0.0});
  }
  for (const std::size_t i : {0U, 1U}) {
    found.findings.push_back({"stiff fingers, light body", std::string(names[i]) + ", any damping",
                              "share of the map 0.01 ≤ kΔt²/m ≤ 1000, ζ ≤ 2 that gains energy", lost[i], lost[2]});
  }
  return found;
}

Hazard block_of_ten_grams() {
  Hazard found;
  for (const auto& [integrator, stiffness] : {std::pair(0U, 2000.0), std::pair(1U, 2e5)}) {
    found.findings.push_back(
        {"10 g between two fingers, 1 kHz", std::string(names[integrator]) + ", undamped",
         "distance from the grip after 5 s, in static spring deflections (1000: lost; " + study::number_text(stiffness / 1000.0) + " kN/m)",
         fallen(integrators[integrator], stiffness) / (0.01 * 9.81 / (2.0 * stiffness)),
         fallen(Integrator::implicit_euler, stiffness) / (0.01 * 9.81 / (2.0 * stiffness))});
  }
  return found;
}

Hazard released_grip() {
  Hazard found;
  std::array<double, 3> gain{};
  for (std::size_t i = 0; i < integrators.size(); ++i) {
    const Eigen::Vector3d edges{0.03, 0.03, 0.02};
    BodyParameters body = BodyParameters::block(0.01, edges);
    body.gravity.setZero();
    body.free = {true, false, false, false, false, false};
    FingerParameters with;
    with.mu = 0.6;
    with.stiffness = 2000.0;
    Grasp scene = gripped(body, edges, with);
    // Held by 10 N, displaced sideways almost to slip, then released to 0.2 N in one step.
    scene.place(BodyState{}, pinch(0.02, 5e-3));
    BodyState drawn;
    drawn.position = {2.9e-3, 0.0, 0.0};
    scene.place(drawn, pinch(0.02, 5e-3));
    scene.carry(drawn, pinch(0.02, 1e-4), tick);
    const double before = scene.energy();
    double most = before;
    for (int j = 1; j <= 200; ++j) {
      step_by(integrators[i], scene, pinch(0.02, 1e-4), tick);
      if (std::isfinite(scene.energy())) most = std::max(most, scene.energy());
    }
    gain[i] = most / before - 1.0;
  }
  found.findings.push_back(
      {"grip released in one step", "explicit Euler, undamped", "energy gained in the next 0.2 s / energy before", gain[0], gain[2]});
  return found;
}

}  // namespace limitcurve::stability
