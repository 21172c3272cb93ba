// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "quadrature": eq. (17), by quadrature and by closed forms.
namespace limitcurve::stability {

/// The slope of the integrand is infinite where ρ = s, when the centre of rotation lies under the finger.
Hazard centre_under_the_finger();
/// The same by brute force: the cost of adaptive subdivision.
Hazard adaptive_subdivision();
/// A pressure that is infinite at the rim, (1−ρ²)ⁿ with n < 0.
Hazard singular_rim();
/// Kinks of measured profiles.
Hazard kinks_of_a_profile();
/// Next to ρ = s the complement of the elliptic modulus vanishes.
Hazard vanishing_complement();
/// Far from the contact the moment is the remainder of terms that grow like s³ or s⁴ and cancel.
Hazard moment_far_away();
/// Near the centre (1+s²)E − (1−s²)K, two numbers near π/2, must give 3πs²/4.
Hazard force_near_the_centre();

}  // namespace limitcurve::stability
