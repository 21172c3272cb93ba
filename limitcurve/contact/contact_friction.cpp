// SPDX-License-Identifier: MIT
#include "limitcurve/contact/contact_friction.hpp"

#include "limitcurve/internal/number.hpp"

#include <limits>
#include <stdexcept>

namespace limitcurve {

RadiusLaw ContactFriction::radius(double moment_ratio) const {
  if (!(mu >= 0.0 && mu <= std::numeric_limits<double>::max())) throw out_of_range("mu", mu, "1", ">= 0 and finite");
  if (radius_law.has_value() == mu_r.has_value())
    throw std::invalid_argument(mu_r ? "give radius_law or mu_r, not both: each sets the moment limit"
                                     : "the contact needs a size: give radius_law or mu_r");
  if (mu_r) return RadiusLaw::of_mu_r(*mu_r, gamma, mu, moment_ratio);
  if (gamma != 0.0) throw out_of_range("gamma", gamma, "1", "0 without mu_r");
  return *radius_law;
}

}  // namespace limitcurve
