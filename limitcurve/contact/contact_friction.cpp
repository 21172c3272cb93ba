// SPDX-License-Identifier: MIT
#include "limitcurve/contact/contact_friction.hpp"

#include "limitcurve/internal/number.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace limitcurve {

RadiusLaw ContactFriction::radius(double moment_ratio) const {
  if (!(mu >= 0.0 && mu <= std::numeric_limits<double>::max())) throw out_of_range("mu", mu, "1", ">= 0 and finite");
  if (radius_law.has_value() == mu_r.has_value())
    throw std::invalid_argument(std::string("got ") + (mu_r ? "both" : "none") +
                                " of radius_law and mu_r, expected one of them");
  if (mu_r) return RadiusLaw::of_mu_r(*mu_r, gamma, mu, moment_ratio);
  if (gamma != 0.0) throw out_of_range("gamma", gamma, "1", "0 without mu_r");
  return *radius_law;
}

}  // namespace limitcurve
