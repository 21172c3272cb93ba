// SPDX-License-Identifier: MIT
#pragma once

#include "../contact/radius_law.hpp"
#include "../pressure_law.hpp"
#include "../validate/validate.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve {
class Patch;
}

/// The facts about engines are in data/engines/engines.csv and coefficients.csv, which the library contains.
namespace limitcurve::engines {

/// A coefficient for a physics engine.
struct EngineCoefficient {
  std::string parameter;  ///< in the engine's spelling
  double value;
  std::string unit;  ///< SI, "1" if none
  std::string formula;  ///< from μ, μ_r = μ m₀ a, m₀, a, and f, the other body's friction, which is 1 here; or a number
  std::string
      two_bodies;    ///< how the engine combines the numbers of two bodies; empty for a setting of the whole scene
  std::string note;  ///< what the engine multiplies it by; the name of the value in the engine, if there is a name
  double low;        ///< smallest value over the range of loads
  double high;       ///< largest
};

/// A soft finger in a physics engine with its best coefficients. Errors are fractions of the exact limit curve's radius
/// in the normalised plane, unless said otherwise, and leave out a measured pressure's profile_error().
struct EngineContact {
  std::string engine;  ///< mujoco, physx, …; `find_engine` knows their other names
  /// Shape of the resulting limit curve: ellipse, diamond (friction pyramid), box (uncoupled) or point (no moment).
  std::string model;
  std::vector<EngineCoefficient> coefficients;
  CurveError error;  ///< of that shape against the exact curve, at the given load
  /// Largest distance in the normalised plane between the wrenches of engine and exact curve for the same slip twist
  /// (imposed COR).
  double max_wrench_error = 0.0;
  /// Largest error.max_error over the range of loads, because constant coefficients cannot follow a(P).
  double max_error_over_loads = 0.0;
  std::string documentation;  ///< where the project documents the coefficients, or its source
  std::string caveat;         ///< what else must be set
};

/// Range of loads for `max_error_over_loads`.
struct LoadRange {
  double low;   ///< [N], > 0
  double high;  ///< [N], ≥ low
};

/// The coefficients that give a contact with friction coefficient `mu` > 0 [1] its exact limits μP and Γ = m₀ μ P a(P)
/// at `load` > 0 [N], for each engine and shape in the order of data/engines/engines.csv; an engine that cannot carry a
/// moment gets the friction alone. Contacts whose moment no number sets (field: pressure on a mesh) are left out.
/// Throws std::invalid_argument for values out of range.
std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load,
                                     LoadRange loads);
/// The same over the loads from a quarter of `load` to four times `load`.
std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load);
/// The same for a contact that is not round: Γ = m₀ μ P about its centre of pressure, at every load. Errors compare the
/// powers of the shape and of the patch over all sliding twists (`engine_shapes`), because the largest ratio of powers
/// is also the largest ratio of radii. Throws also for a patch without moment. A friction factor of all directions goes
/// into μ; if mx ≠ my, engines that have two coefficients of friction get mx and my, and `engines_of_one_friction` are
/// left out.
std::vector<EngineContact> translate(const Patch& patch, double mu);
std::vector<std::string> engines_of_one_friction();

/// The name in `translate` of an engine that may have others (isaac-lab, pybullet). Throws std::invalid_argument with
/// all names.
std::string find_engine(std::string_view name);

/// A number in an engine's scene. The parameter is the engine's own name, or a word from data/engines/coefficients.csv:
/// friction, torsional, ….
struct EngineNumber {
  std::string engine;
  std::string parameter;
  double value;
};

/// What a number in an engine's scene means.
struct CoefficientMeaning {
  std::string engine;
  std::string parameter;   ///< in the engine's spelling
  double moment_per_load;  ///< largest moment over load [m]; NaN for a number that sets no moment of its own
  double radius;           ///< contact radius [m] that a contact of the law needs for it; NaN as above
  std::string note;        ///< how the engine uses the number, what was assumed; whether that is a fingertip's radius
};

/// The inverse of `translate`: one row per number, in their order. Numbers of one engine belong to one contact; a
/// parameter that the engine has already had begins its next contact. The friction of a contact is among the
/// numbers; otherwise it is `mu` > 0. If a number is missing, the engine's default counts, but a switch counts as on,
/// and the note says so. A number that another number switches off has moment 0. Throws std::invalid_argument for an
/// unknown name, with the known ones, for values < 0 or not finite, and if a radius needs `mu` and it is NaN.
std::vector<CoefficientMeaning> read_coefficients(std::span<const EngineNumber> numbers, double mu, const Law& law);

}  // namespace limitcurve::engines
