// SPDX-License-Identifier: MIT
#pragma once

#include "../validate/choose.hpp"
#include "../validate/validate.hpp"
#include "patch.hpp"

#include <string>
#include <vector>

/// Errors of round models of a patch. Offline: 2e4 evaluations of the patch.
namespace limitcurve {

/// A round model about the centre of pressure: a disc of a law and a radius, or the ellipsoid √(v² + m₀²ω²).
struct DiscModel {
  std::string name;
  double parameter;  ///< radius of a disc [m]; m₀ of the ellipsoid [m]
  CurveError error;  ///< of H_model/H over twists; see `disc_models`
};

/// The factor of the discs' μ: the patch's friction factor if both are equal, else 2 mx my/(mx + my), which has the
/// smallest largest relative error in pure sliding.
double disc_factor(const Patch& patch);

/// The round models of a patch and their errors against it:
///   disc:LAW              the law of `law_examples()` and the radius with the smallest largest error,
///   disc-equal-area:LAW   the disc of the patch's area, with the law of an ellipse, otherwise uniform; left out if the
///                         patch has no area,
///   ellipsoid             √(v² + m₀²ω²), m₀ = H(0, 0, 1); v is (mx v_x, my v_y) under orthotropic friction.
/// Discs have `disc_factor` times μ.
/// `max_over_estimate` and `max_under_estimate` are the largest of H_model/H − 1 and 1 − H_model/H over all twists,
/// accurate to 1e-6. `rms_error` is the root mean square of H_model/H − 1 over CORs in 128 directions, evenly, at 121
/// distances from 1e-3 to 1e3 m₀/`disc_factor`, evenly in their logarithm. `max_cor_error` is over the same CORs, and
/// farther ones: the largest |c_model/c − 1| of COR distances where both wrenches have the same direction of force and
/// the same ratio of moment to force; inf if it has no bound. Throws std::invalid_argument for a patch without moment,
/// all of whose load is on one point.
std::vector<DiscModel> disc_models(const Patch& patch);

/// A shape that physics engines give the limits |(F_x/mx, F_y/my)| ≤ μP and |M| ≤ m₀ μP, m₀ = H(0, 0, 1).
struct EngineShape {
  std::string name;         ///< ellipse, diamond, box, or point (no moment)
  CurveError error;         ///< of H_shape/H over twists, as in `disc_models`; no COR
  double max_wrench_error;  ///< largest distance of the wrenches of one twist over the CORs above, in units of these
                            ///< limits; accurate to 1e-2
};

/// The shapes and their errors against a patch. Throws like `disc_models`.
std::vector<EngineShape> engine_shapes(const Patch& patch);

/// The disc, the ellipsoid and the patch itself as candidates, sorted by cost. `chosen` marks the cheapest that is
/// accurate enough; the patch always is. Throws like `disc_models`, and for a tolerance outside [1e-10, 1].
std::vector<Candidate> choose(const Patch& patch, double tolerance);

}  // namespace limitcurve
