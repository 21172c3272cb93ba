// SPDX-License-Identifier: MIT
#include "limitcurve/quadrature/evaluators.hpp"

#include "limitcurve/quadrature/closed_form.hpp"
#include "limitcurve/quadrature/kernels.hpp"
#include "limitcurve/quadrature/tanh_sinh.hpp"

#include <algorithm>
#include <limits>

namespace limitcurve::evaluators {

namespace {

constexpr Extended pi = closed_form::pi;

template <class Real>
using Sums = std::array<Real, 4>;  // the same, and the load

/// A radius in a piece, and its distance from the COR's ring ρ = s.
template <class Real>
struct SplitPosition {
  RadialPosition<Real> at;
  Real from_cor;
};

/// A law's number, or 0 for one that is negative, infinite or NaN: the load tells what is missing.
template <class Real>
Real usable(Real density) noexcept {
  return density >= 0 && density <= std::numeric_limits<Real>::max() ? density : 0;
}

template <class Real>
Sums<Real> loaded(Real load, const Triple<Real>& of_unit_load) noexcept {
  return {load * of_unit_load[0], load * of_unit_load[1], load * of_unit_load[2], load};
}

/// The sums and their errors. A law that does not keep the promises of PressureLawOf, such as one
/// with a kink between its breaks, has not the load 1 in the points of the quadrature either.
/// Force and moment of a ring are at most `most` = {1, largest radius} times its load, and smooth
/// where the pressure is not: so what is missing of the load tells their errors, four times if
/// rings hide each other.
template <class Real>
Quadrature<Real> checked_by_load(Sums<Real> value, Sums<Real> error, const Sums<Real>& wavering,
                                 const std::array<Real, 2>& most) noexcept {
  constexpr Real rounding = sizeof(Real) > sizeof(double) ? Real(1e-15L) : Real(1e-13);
  const Real missing = std::fabs(1 - value[3]);
  if (!(missing <= rounding)) {
    for (std::size_t i = 0; i < most.size(); ++i) {
      // In this order of arguments NaN becomes the largest possible value.
      value[i] = std::min(most[i], value[i]);
      error[i] = std::min(most[i], wavering[i] + 4 * missing * most[i]);
    }
  }
  return {{value[0], value[1], value[2]}, {error[0], error[1], error[2]}};
}

/// Sums ∫ kernel(position) dρ over the pieces between the breaks, split at s. The integrand is the kernel times rim^e
/// with e = `rim_exponent` ≤ 0: on the last piece the substitution rim ∝ y^{1/(1+e)} absorbs that factor exactly. The
/// kernel returns `Sums`.
template <class Real, class Kernel>
Quadrature<Real> integrate_pieces(const std::vector<Extended>& breaks, Real rim_exponent, Real s, std::size_t wanted,
                                  Kernel&& kernel) noexcept {
  const auto outer = breaks.empty() ? Real(1) : static_cast<Real>(breaks.back());
  Sums<Real> value{};
  Sums<Real> error{};
  Sums<Real> wavering{};
  const auto add_piece = [&](Real left, Real right) {
    const auto at = [&](Real from_left, Real from_right) {
      const Real radius = from_left < from_right ? left + from_left : right - from_right;
      const Real from_cor = s <= left ? (left - s) + from_left : (s - right) + from_right;
      return SplitPosition<Real>{{radius, (outer - right) + from_right}, from_cor};
    };
    Integrals<4, Real> piece;
    if (rim_exponent == 0) {
      piece = integrate<4>([&](Real x, Real y) { return kernel(at(x, y)); }, right - left, wanted);
    } else if (right < outer) {
      // Not the last piece, but the rim may be one rounding from its end.
      piece = integrate<4>(
          [&](Real x, Real y) {
            const SplitPosition<Real> position = at(x, y);
            const Real weight = std::pow(position.at.rim, rim_exponent);
            Sums<Real> result = kernel(position);
            for (Real& r : result) r *= weight;
            return result;
          },
          right - left, wanted);
    } else {
      // rim = ℓ·y^p with p = 1/(1+e), hence rim^e d(rim) = ℓ^{1+e} p dy: the singular factor is gone.
      const Real length = right - left;
      const Real power = 1 / (1 + rim_exponent);
      const Real scale = std::pow(length, 1 + rim_exponent) * power;
      piece = integrate<4>(
          [&](Real x, Real y) {
            const Real from_right = length * std::pow(y, power);
            const Real from_left = length * -std::expm1(power * (x < y ? std::log1p(-x) : std::log(y)));
            Sums<Real> result = kernel(at(from_left, from_right));
            for (Real& r : result) r *= scale;
            return result;
          },
          Real(1), wanted);
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      value[i] += piece.value[i];
      error[i] += piece.error[i];
      wavering[i] += piece.wavering[i];
    }
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const auto left = static_cast<Real>(breaks[i]);
    const auto right = static_cast<Real>(breaks[i + 1]);
    if (left < s && s < right) {
      add_piece(left, s);
      add_piece(s, right);
    } else {
      add_piece(left, right);
    }
  }
  return checked_by_load(value, error, wavering, {Real(1), outer});
}

template <class Real>
Quadrature<Real> ring_in(const PressureLaw& law, Real s, Slope slope) noexcept {
  // At s = ∞ the kernel is ∞/∞: use its limit.
  if (std::isinf(s)) return {{1, 0, 0}, {0, 0, 0}};
  return integrate_pieces(law.breaks(), static_cast<Real>(law.rim_exponent()), s, slope == Slope::wanted ? 3 : 2,
                          [&](const SplitPosition<Real>& position) -> Sums<Real> {
                            const Real rho = position.at.radius;
                            // The contribution is negligible there, and an unbounded density would overflow.
                            if (rho < std::numeric_limits<Real>::min()) return {0, 0, 0, 0};
                            return loaded(2 * rho * usable(law.density(position.at)),
                                          ring_kernel(rho, s, position.from_cor));
                          });
}

}  // namespace

Quadrature<Extended> ring(const PressureLaw& law, Extended s, Slope slope) noexcept {
  return ring_in(law, s, slope);
}
Quadrature<double> ring(const PressureLaw& law, double s, Slope slope) noexcept {
  return ring_in(law, s, slope);
}

UnitWrench ring_wrench(double rho, double s) noexcept {
  const auto [force, moment, slope] = ring_kernel(rho, s, std::fabs(rho - s));
  return {force, moment};
}

Quadrature<Extended> punch(const PressureLaw& law, Extended s) noexcept {
  return integrate_pieces(law.breaks(), law.punch_exponent(), s, 3,
                          [&](const SplitPosition<Extended>& position) -> Sums<Extended> {
                            const Extended t = position.at.radius;
                            const UnitForces<Extended> flat = closed_form::flat_punch(s / t);
                            return loaded(usable(law.punch_density(position.at).value_or(0)),
                                          {flat.force, t * flat.moment, flat.force_slope / t});
                          });
}

Quadrature<Extended> direct(const PressureLaw& law, Extended s) noexcept {
  if (std::isinf(s)) return {{1, 0, 0}, {0, 0, 0}};
  Triple<Extended> inner_error{};
  Quadrature<Extended> estimate = integrate_pieces(
      law.breaks(), law.rim_exponent(), s, 3, [&](const SplitPosition<Extended>& position) -> Sums<Extended> {
        const auto [rho, rim] = position.at;
        const Extended load = 2 * rho * usable(law.density(position.at));
        const Extended gap = rho < s ? position.from_cor : -position.from_cor;  // s − ρ
        const auto angular = integrate<3>(
            [&, rho = rho](Extended from_cor_side, Extended) -> Triple<Extended> {
              // 1 − cos θ = 2 sin²(θ/2): exact where the COR is near.
              const Extended half = std::sin(from_cor_side / 2);
              const Extended versine = 2 * half * half;
              const Extended distance = std::sqrt(gap * gap + 2 * rho * s * versine);
              const Extended across = gap + rho * versine;  // s − ρ cos θ
              const Extended along = -gap + s * versine;    // ρ − s cos θ
              const Extended sine = 2 * half * std::cos(from_cor_side / 2);
              return {across / distance, rho * along / distance,
                      (rho * sine / distance) * (rho * sine / distance) / distance};
            },
            pi);
        Triple<Extended> mean{};
        for (std::size_t i = 0; i < mean.size(); ++i) {
          mean[i] = angular.value[i] / pi;
          inner_error[i] = std::max(inner_error[i], angular.error[i]);
        }
        return loaded(load, mean);
      });
  // The angular errors have the weight ∫ 2ρ g dρ = 1. The integrand changes sign, so the rounding error is absolute,
  // not relative.
  constexpr Extended rounding = 16 * std::numeric_limits<Extended>::epsilon();
  estimate.error.force += inner_error[0] / pi + rounding;
  estimate.error.moment += inner_error[1] / pi + rounding;
  return estimate;
}

Quadrature<double> line_profile(const PressureLaw& law, double t) noexcept {
  return integrate_pieces(law.breaks(), static_cast<double>(law.rim_exponent()), t, 2,
                          [&](const SplitPosition<double>& position) -> Sums<double> {
                            return loaded(2.0 * position.at.radius * usable(law.density(position.at)),
                                          line_kernel(position.at.radius, t, position.from_cor));
                          });
}

WrenchEstimate rounded(const Quadrature<Extended>& estimate) noexcept {
  // Half a unit in the last place of the double, plus the rounding of the extended sums.
  constexpr Extended relative =
      std::numeric_limits<double>::epsilon() / 2 + 64 * std::numeric_limits<Extended>::epsilon();
  const auto bound = [](Extended value, Extended truncation) {
    return static_cast<double>((relative * std::fabs(value) + truncation) * (1 + 1e-15L)) +
           std::numeric_limits<double>::denorm_min();
  };
  const auto& [forces, error] = estimate;
  return {{static_cast<double>(forces.force), static_cast<double>(forces.moment)},
          {bound(forces.force, error.force), bound(forces.moment, error.moment)},
          static_cast<double>(forces.force_slope)};
}

}  // namespace limitcurve::evaluators
