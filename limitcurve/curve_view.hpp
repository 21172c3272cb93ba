// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/search.hpp"
#include "limitcurve/table/pieces.hpp"

#include <array>

namespace limitcurve {

/// A limit curve as a loop reads it: plain data, in units of μP and μPa. `Real` is that of the arithmetic; a `Number` below is Real or a pack
/// of it.
template <class Real>
struct CurveView {
  bool is_box = false;  ///< uncoupled limits; else an ellipse, unless there is a table
  Real force_max = 1;   ///< f at pure sliding
  Real moment_max = 1;  ///< m at pure spin: the moment ratio m₀ where force_max is 1
  Real inverse_force_max = 1;
  Real inverse_moment_max = 1;
  Real rim_force = 0;  ///< the wrench whose centre of rotation lies on the rim, s = 1
  Real rim_moment = 0;
  TablePieces<Real> table = {};

  /// Sets the intercepts and the wrench on the rim.
  void set_scale(Real force_intercept, Real moment_intercept, Real force_on_rim, Real moment_on_rim) noexcept {
    force_max = force_intercept;
    moment_max = moment_intercept;
    inverse_force_max = Real(1) / force_max;
    inverse_moment_max = Real(1) / moment_max;
    rim_force = force_on_rim;
    rim_moment = moment_on_rim;
  }

  [[nodiscard]] bool has_table() const noexcept { return table.cells != nullptr; }

  /// The support function along the side inside or outside the rim, at x ∈ [0, 1]. Not for the box, whose corner has many normals.
  template <class Number, class Mask>
  [[nodiscard]] Jet<Number> jet(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    if (has_table()) return table.jet(outside, x);
    // D = √(A²x² + B²), A the semi-axis of the leading component and B the other's.
    const Number a = select(outside, Number(moment_max), Number(force_max));
    const Number b = select(outside, Number(force_max), Number(moment_max));
    const Number aa = a * a;
    const Number value = sqrt(aa * x * x + b * b);
    const Number inverse = Number(Real(1)) / value;
    const Number first = aa * x * inverse;
    const Number second = (aa - first * first) * inverse;
    return {value, first, second, Number(Real(-3)) * first * second * inverse};
  }
};

/// A point of a limit curve with its outward normal, which is the direction of the slip there.
template <class Number>
struct CurvePoint {
  Number force;
  Number moment;
  Number slide;  ///< |v| : a|ω| = slide : spin, both ≥ 0
  Number spin;
  Number parameter;  ///< t ∈ [0, 2]: s up to the rim, 2 − 1/s beyond. Where a next search may begin
};

/// One side of the curve as a search sees it: what leads inside the rim is the force, outside the moment.
template <class Real, class Number>
struct CurveSide {
  using Mask = decltype(Number{} < Number{});
  Mask outside;
  Number leading;   ///< of the wrench that is sought for
  Number trailing;  ///< of the same

  CurveSide(Mask beyond_rim, Number force, Number moment) noexcept : outside(beyond_rim) {
    using namespace arithmetic;
    leading = select(outside, moment, force);
    trailing = select(outside, force, moment);
  }

  /// x, where a search begins: at the curve parameter `last`; where that is 0, none is known, and a twist serves, slide : spin =
  /// guess_twist().
  template <class Function>
  [[nodiscard]] Number begin(Number last, Function&& guess_twist) const noexcept {
    using namespace arithmetic;
    const Number zero = Number(Real(0));
    const auto is_known = last > zero;
    Number x = select(outside, Number(Real(2)) - last, last);
    if (any(!is_known)) {
      const auto [slide, spin] = guess_twist();
      x = select(is_known, x, select(outside, spin, slide) / select(outside, slide, spin));
    }
    // A wrench on an axis has its root at the end, which no step reaches exactly.
    return select(leading > zero, max(zero, min(Number(Real(1)), x)), zero);
  }

  [[nodiscard]] CurvePoint<Number> point(const Jet<Number>& jet, Number x) const noexcept {
    using arithmetic::select;
    const Number one = Number(Real(1));
    return {select(outside, jet.trailing(x), jet.leading()), select(outside, jet.leading(), jet.trailing(x)), select(outside, one, x),
            select(outside, x, one), select(outside, Number(Real(2)) - x, x)};
  }
};

/// Where the ray from the origin through a wrench, not both components 0, meets the curve; and the wrench's gauge, 1 on the curve and less
/// inside. Root of T·leading − L·trailing, L and T the curve's components at x. Not for the box.
template <class Real, class Number>
[[nodiscard]] CurvePoint<Number> point_on_ray(const CurveView<Real>& curve, Number force, Number moment, Number last,
                                              Number& gauge) noexcept {
  // First guess: the normal of the ellipse with the same intercepts.
  const auto guess_twist = [&]() noexcept {
    const Number a = Number(curve.force_max);
    const Number b = Number(curve.moment_max);
    return std::array{force * b * b, moment * a * a};
  };
  const CurveSide<Real, Number> side(force * Number(curve.rim_moment) > moment * Number(curve.rim_force), force, moment);
  Jet<Number> jet;
  const Number x = find_root<Real>(
      [&](Number at) noexcept -> Residual<Number> {
        jet = curve.jet(side.outside, at);
        const Number turn = side.trailing + at * side.leading;
        const Number up = jet.trailing(at) * side.leading;
        const Number down = jet.leading() * side.trailing;
        return {up - down, -jet.second * turn, -jet.third * turn - jet.second * side.leading,
                Number(4 * std::numeric_limits<Real>::epsilon()) * (up + down)};
      },
      side.begin(last, guess_twist));
  // By the tangent at x, whose error is the square of that of x.
  gauge = (side.trailing + x * side.leading) / jet.value;
  return side.point(jet, x);
}

/// The gauge of a wrench: 0 at the origin, 1 on the curve, more outside. `last` as above.
template <class Real, class Number>
[[nodiscard]] Number gauge(const CurveView<Real>& curve, Number force, Number moment, Number last) noexcept {
  using namespace arithmetic;
  const Number x = force * Number(curve.inverse_force_max);
  const Number y = moment * Number(curve.inverse_moment_max);
  if (curve.is_box) return max(x, y);
  if (!curve.has_table()) return sqrt(x * x + y * y);
  Number result;
  static_cast<void>(point_on_ray(curve, force, moment, last, result));
  return result;
}

}  // namespace limitcurve
