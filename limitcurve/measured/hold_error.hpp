// SPDX-License-Identifier: MIT
#pragma once

#include "../contact/contact_friction.hpp"
#include "../pressure_law.hpp"

#include <cmath>

namespace limitcurve {

/// How far `load_to_hold` may be off [N] because the pressure of `law` is known only at samples: an estimate, of first
/// order in the law's stated error; 0 for a law given by a formula. `load` is the result of `load_to_hold` for `force`
/// [N] and `moment` [N·m] on `curve`, a curve of the law; if that is an ellipse or a box with the law's intercepts, set
/// `intercepts_only`. Does not throw for arguments that `load_to_hold` accepted. Cost: one call of `along` and one or
/// two of `evaluate`.
///
/// The load is the largest of (F v/μ + M w/(μ a))/H(v, w) over the slips: at the slip where it touches, a change of the
/// curve enters by δH = v δf + w δm alone (envelope theorem), and by 1/(1 + γω) if the radius grows with the load. An
/// ellipse or a box has δm = m δm₀/m₀. Measured moments (`RadiusLaw::is_of_moments`) divide m by m₀: of an ellipse or a
/// box nothing of the law is left, and of the curve δm becomes δm − m δm₀/m₀. As m₀ ≥ m ≥ m₀ − s f for any law, that
/// can be at most s (f + δf)(1 + δm₀/m₀), which is 0 for a pure spin.
template <class Curve>
double hold_error(const Curve& curve, const PressureLaw& law, const ContactFriction& contact, double load, double force,
                  double moment, bool intercepts_only = false) {
  if (law.profile_error() == 0.0 || !(load > 0.0 && std::isfinite(load))) return 0.0;
  const RadiusLaw radius_law = detail::radius_law_of(curve, contact);
  if (intercepts_only && radius_law.is_of_moments()) return 0.0;
  const double limit = contact.mu * load;
  const auto [touched, normal] =
      curve.along({std::fabs(force) / limit, std::fabs(moment) / (limit * radius_law.radius(load))});
  UnitWrench error{};
  if (!intercepts_only) error = law.evaluate(normal.cor()).error;
  if (intercepts_only || radius_law.is_of_moments()) {
    const WrenchEstimate spin = law.evaluate(0.0);
    const double ratio = spin.error.moment / spin.wrench.moment;
    error.moment += touched.moment * ratio;
    if (!intercepts_only)
      error.moment = std::fmin(error.moment, normal.cor() * (touched.force + error.force) * (1.0 + ratio));
  }
  const double support = normal.slide * touched.force + normal.spin * touched.moment;
  const double growth = 1.0 + radius_law.exponent(load) * normal.spin * touched.moment / support;
  return load * (normal.slide * error.force + normal.spin * error.moment) / (support * growth);
}

}  // namespace limitcurve
