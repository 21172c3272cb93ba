// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/quadrature/tanh_sinh.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace limitcurve {

/// A pressure g(ρ) of many cubic pieces, prepared for integrals ∫ K(ρ, s) 2ρ g dρ in a time that grows like the
/// logarithm of their number. K is a kernel of eq. (17), analytic but for its singularities at ρ = ±s.
///
/// Pieces are joined two by two into a binary tree of intervals. Each interval has the Gauss rule of its own mass 2ρ g
/// dρ, made from those of its halves. It replaces the interval where s is at least its width away: there K is analytic
/// within 3 half-widths, and the error of the rule is 5.8^(−2n), 4e-19 of the interval's integral. Greengard & Rokhlin,
/// J. Comput. Phys. 73 (1987), have the idea; Gautschi, "Orthogonal Polynomials" (2004), §2.2, the rule of a sum of
/// masses.
class CubicPieces {
 public:
  /// g = value + t(slope + t(square + t·cube)) on [left, left + width], t the distance from the left end.
  struct Piece {
    Extended left;
    Extended width;
    Extended value;
    Extended slope;
    Extended square;
    Extended cube;

    template <class Real>
    [[nodiscard]] Real operator()(Real radius) const noexcept {
      const Real t = std::clamp<Real>(radius - static_cast<Real>(left), 0, static_cast<Real>(width));
      const Real g = static_cast<Real>(value) +
                     t * (static_cast<Real>(slope) + t * (static_cast<Real>(square) + t * static_cast<Real>(cube)));
      // A cubic that ends at 0 may be negative by rounding.
      return std::max<Real>(g, 0);
    }
  };

  /// The pieces in the order of their radii, each beginning where the one before ends.
  explicit CubicPieces(std::vector<Piece> pieces);

  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }

  template <class Real>
  [[nodiscard]] Real operator()(Real radius) const noexcept {
    const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), radius,
                                        [](Real r, const Piece& piece) { return r < static_cast<Real>(piece.left); });
    return (*(after - 1))(radius);
  }

  /// ∫ 2ρ g K dρ of the first `wanted` components of `kernel(ρ, |ρ − s|)`, an array of three numbers. The singularities
  /// of K at ρ = s are not stronger than a logarithm or a root. Truncation ≤ 1e-18 of the integral, or the stated
  /// error, which comes from tanh–sinh on pieces next to the centre.
  template <class Real, class Kernel>
  [[nodiscard]] Integrals<3, Real> integrate(Real s, std::size_t wanted, const Kernel& kernel) const noexcept {
    Integrals<3, Real> sum;
    const auto add = [&](const std::array<Real, 3>& value, Real factor) {
      for (std::size_t i = 0; i < 3; ++i) sum.value[i] += factor * value[i];
    };
    for (std::size_t i = 0; i < intervals_.size();) {
      const Interval& interval = intervals_[i];
      const auto left = static_cast<Real>(interval.left);
      const auto right = static_cast<Real>(interval.right);
      if (interval.is_sound && std::max(left - s, s - right) >= right - left) {
        for (const Mass& mass : interval.rule) {
          const auto radius = static_cast<Real>(mass.radius);
          add(kernel(radius, std::fabs(radius - s)), static_cast<Real>(mass.mass));
        }
        i = interval.next;
      } else if (interval.next == i + 1) {
        const Piece& piece = pieces_[interval.piece];
        const auto add_part = [&](Real from, Real to) {
          // Near the centre K's other singularity, −s, is near, too.
          if (from < to - from) {
            const Integrals<3, Real> part = integrate_near_centre(piece, s, from, to, wanted, kernel);
            add(part.value, 1);
            for (std::size_t k = 0; k < 3; ++k) sum.error[k] += part.error[k];
          } else {
            integrate_beside(piece, s, from, to, kernel, add);
          }
        };
        const bool divided = left < s && s < right;
        add_part(left, divided ? s : right);
        if (divided) add_part(s, right);
        ++i;
      } else {
        ++i;  // its halves
      }
    }
    return sum;
  }

 private:
  struct Mass {
    Extended radius;
    Extended mass;
  };
  static constexpr std::size_t order = 12;
  /// An interval, followed by those of its two halves down to single pieces; `next` is the first that is not part of
  /// it. If rounding spoils the `rule`, as where nearly all load is on a speck, the parts must do.
  struct Interval {
    Extended left;
    Extended right;
    std::size_t piece;
    std::size_t next;
    std::array<Mass, order> rule;
    bool is_sound;
  };

  /// Adds the interval of the pieces [begin, end) and its parts; returns its index.
  std::size_t add_interval(std::size_t begin, std::size_t end);
  /// The rule of the masses, and whether it has their sum and their first moment.
  [[nodiscard]] static std::pair<std::array<Mass, order>, bool> gauss_rule(const std::vector<Mass>& masses);

  /// [from, to] with s at an end or outside, by Gauss–Legendre in σ^(1/6), σ = |ρ − s|: a factor σ^α log σ becomes
  /// smooth.
  template <class Real, class Kernel, class Add>
  static void integrate_beside(const Piece& piece, Real s, Real from, Real to, const Kernel& kernel,
                               const Add& add) noexcept {
    using Rule = boost::math::quadrature::gauss<Real, 30>;
    const bool above = s <= from;
    const auto root = [](Real sigma) { return std::cbrt(std::sqrt(sigma)); };
    const Real near = root(above ? from - s : s - to);
    const Real far = root(above ? to - s : s - from);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const int side : {-1, 1}) {
        const Real u = (near + far) / 2 + static_cast<Real>(side) * Rule::abscissa()[i] * (far - near) / 2;
        const Real cube = u * u * u;
        const Real sigma = cube * cube;
        const Real radius = above ? s + sigma : s - sigma;
        add(kernel(radius, sigma),
            Rule::weights()[i] * (far - near) / 2 * 6 * cube * u * u * 2 * radius * piece(radius));
      }
    }
  }

  template <class Real, class Kernel>
  static Integrals<3, Real> integrate_near_centre(const Piece& piece, Real s, Real from, Real to, std::size_t wanted,
                                                  const Kernel& kernel) noexcept {
    return limitcurve::integrate<3>(
        [&](Real from_left, Real from_right) {
          const Real radius = from_left < from_right ? from + from_left : to - from_right;
          const Real sigma = s <= from ? (from - s) + from_left : (s - to) + from_right;
          std::array<Real, 3> value = kernel(radius, sigma);
          for (Real& v : value) v *= 2 * radius * piece(radius);
          return value;
        },
        to - from, wanted);
  }

  std::vector<Piece> pieces_;
  std::vector<Interval> intervals_;
};

namespace evaluators {
/// As for a law (quadrature/evaluators.hpp).
Quadrature<Extended> ring(const CubicPieces& pressure, Extended s, Slope slope = Slope::wanted) noexcept;
Quadrature<double> ring(const CubicPieces& pressure, double s, Slope slope = Slope::wanted) noexcept;
Quadrature<double> line_profile(const CubicPieces& pressure, double t) noexcept;
}  // namespace evaluators

}  // namespace limitcurve
