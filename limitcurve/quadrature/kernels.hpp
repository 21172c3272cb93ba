// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/quadrature/closed_form.hpp"
#include "limitcurve/quadrature/elliptic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// The kernels of eq. (17): what a ring that carries the unit load gives (docs/theory.md).
namespace limitcurve::evaluators {

template <class Real>
using Triple = std::array<Real, 3>;  // force, moment, force slope

/// Force, moment and slope of a ring of radius ρ that carries the unit load; `from_cor` is |ρ − s|.
template <class Real>
[[nodiscard]] Triple<Real> ring_kernel(Real rho, Real s, Real from_cor) noexcept {
  const Real larger = std::max(rho, s);
  const Real q = std::min(rho, s) / larger;
  const Real complement = from_cor / larger * ((rho + s) / larger);
  const auto [b, d] = elliptic_pair(q, complement);
  const Real e = b + complement * d;
  constexpr auto scale = static_cast<Real>(2 / closed_form::pi);
  if (rho <= s) return {scale * e, scale * rho * q * b, scale * q * d * (q / s)};
  return {scale * q * b, scale * rho * e, scale * d / rho};
}

/// G′ and N of a ring of radius ρ that carries the unit load: (2/π) asin(t/ρ) and (2/π)√(ρ² − t²) where t < ρ, else 1
/// and 0.
[[nodiscard]] inline Triple<double> line_kernel(double rho, double t, double from_t) noexcept {
  if (rho <= t) return {1.0, 0.0, 0.0};
  constexpr auto scale = static_cast<double>(2 / closed_form::pi);
  const double half_chord = std::sqrt(from_t * (rho + t));
  return {scale * std::atan2(t, half_chord), scale * half_chord, 0.0};
}

}  // namespace limitcurve::evaluators
