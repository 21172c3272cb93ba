// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/contact_radius.hpp"
#include "../limitcurve/pressure_law.hpp"
#include "../limitcurve/validate.hpp"

#include <string>
#include <vector>

namespace limitcurve::fit {

/// A coefficient of a physics engine.
struct EngineCoefficient {
  std::string parameter;  ///< in the engine's spelling
  double value;
  std::string unit;     ///< SI, "1" if none
  std::string formula;  ///< its formula from μ, a, m₀
  std::string word{};   ///< the value's name in the engine, if it has one
};

/// A soft finger in a physics engine with its best coefficients. Errors are fractions of the exact limit curve's radius in the normalised
/// plane, unless said otherwise.
struct EngineContact {
  std::string engine;  ///< mujoco, chrono, gazebo, physx, bullet, ode
  /// Shape of the resulting limit curve: ellipse, diamond (friction pyramid) or box (uncoupled).
  std::string model;
  std::vector<EngineCoefficient> coefficients;
  CurveError error;  ///< of that shape against the exact curve, at the given load
  /// Largest distance in the normalised plane between the wrenches of engine and exact curve for the same slip twist (imposed COR).
  double max_wrench_error = 0.0;
  /// Largest error.max_error over the range of loads: constant coefficients cannot follow a(P).
  double max_error_over_loads = 0.0;
  std::string documentation;  ///< where the project documents the coefficient
  std::string caveat;         ///< details that the documentation leaves out
};

/// Range of loads for `max_error_over_loads`.
struct LoadRange {
  double low;   ///< [N], > 0
  double high;  ///< [N], ≥ low
};

/// The coefficients for MuJoCo (elliptic and pyramidal cone), Chrono, Gazebo/SDFormat, PhysX, Bullet and ODE that give a contact with
/// friction coefficient `mu` > 0 [1] its exact limits μP and Γ = m₀ μ P a(P) at `load` > 0 [N]. Throws std::invalid_argument for values
/// out of range.
std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load, LoadRange loads);
/// The same over the loads from a quarter of `load` to four times `load`.
std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load);

}  // namespace limitcurve::fit
