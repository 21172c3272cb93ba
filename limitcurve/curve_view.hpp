// SPDX-License-Identifier: MIT
#pragma once

#include "arithmetic.hpp"
#include "search.hpp"

#include <array>
#include <cstdint>

namespace limitcurve {

/// The support function D(x) of a limit curve along one side, with its derivatives. Inside the rim x = s = c/a and D(x) = H(x, 1); outside
/// x = 1/s and D(x) = H(1, x). x ∈ [0, 1] on both sides. The leading component of the wrench is the force inside, the moment outside.
template <class Real>
struct Jet {
  Real value;   ///< D
  Real first;   ///< D′, the leading component
  Real second;  ///< D″ ≥ 0, the derivative of the leading component
  Real third;   ///< D‴

  [[nodiscard]] Real leading() const noexcept { return first; }
  [[nodiscard]] Real trailing(Real x) const noexcept { return value - x * first; }
};

/// The cells of a table as a control loop reads them: the support function D(x) of both sides (Jet), a polynomial of degree 6 in each cell.
/// Plain pointers to data that the table owns; copies are cheap.
///
/// How a cell is found: y = min(x, 1 − x) is the distance from the nearer end of [0, 1]. The exponent and the leading mantissa bits of y +
/// `offset`, offset = 2^−d, are the number of a bucket. So every octave towards either end, where limit curves may be singular, has the
/// same number of buckets. There are four runs of buckets: inside and outside the rim, near x = 0 and near x = 1. `cell_of_bucket` is the
/// index of the last cell that begins in the bucket or before it. A search is needed only if several cells begin in one bucket: next to a
/// singularity that is not at an end. NaN counts as 0, so that no index leaves the arrays.
template <class Real>
struct TablePieces {
  const Real* cells = nullptr;  ///< eight numbers a cell: its origin x₀, then c₀ … c₆ of D = Σ cᵢ (x − x₀)ⁱ
  const std::uint16_t* cell_of_bucket = nullptr;  ///< four runs: inside near 0, inside near 1, outside near 0, outside near 1
  Real offset = 0;                                ///< 2^−d
  int dropped_bits = 0;                           ///< of the mantissa
  int first_bucket = 0;                           ///< the leading bits of `offset`
  int buckets = 0;                                ///< in each run
  bool searches = false;                          ///< whether any cell begins inside a bucket, not at its edge

  static constexpr int numbers_per_cell = 8;

  /// D and its derivatives at x ∈ [0, 1]. `Number` is Real or a pack of it, `outside` a bool or the pack's mask.
  template <class Number, class Mask>
  [[nodiscard]] Jet<Number> jet(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const auto at = numbers_per_cell * cell(outside, x);
    const Number t = x - gather(cells, at);
    const auto coefficient = [&](int i) { return gather(cells + 1 + i, at); };
    // Horner's scheme for D and its Taylor coefficients together; each starts one step after the one before.
    Number value = coefficient(6);
    Number first = value;
    value = value * t + coefficient(5);
    Number half_second = first;
    first = first * t + value;
    value = value * t + coefficient(4);
    Number sixth_third = half_second;
    half_second = half_second * t + first;
    first = first * t + value;
    value = value * t + coefficient(3);
    for (int i = 2; i >= 0; --i) {
      sixth_third = sixth_third * t + half_second;
      half_second = half_second * t + first;
      first = first * t + value;
      value = value * t + coefficient(i);
    }
    return {value, first, Number(Real(2)) * half_second, Number(Real(6)) * sixth_third};
  }

  /// The index of the cell that contains x.
  template <class Number, class Mask>
  [[nodiscard]] auto cell(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const Number one = Number(Real(1));
    const Number y = larger(Number(Real(0)), smaller(x, one - x));
    const auto bits = leading_bits(y + Number(offset), dropped_bits);
    using Index = decltype(bits + 0);
    const auto run = select(x > one - x, Index{} + buckets, Index{}) + select(outside, Index{} + 2 * buckets, Index{});
    const auto last = gather(cell_of_bucket, bits - first_bucket + run);
    return searches ? search(last, x) : last;
  }

 private:
  /// The cell at or before `cell` that begins at or before x.
  template <class Index, class Number>
  [[nodiscard]] Index search(Index cell, Number x) const noexcept {
    using namespace arithmetic;
    while (true) {
      const Number begin = gather(cells, numbers_per_cell * cell);
      // The first cell of a side begins at 0.
      const auto is_beyond = begin > larger(Number(Real(0)), x);
      if (!any(is_beyond)) return cell;
      cell = cell - select(is_beyond, Index{} + 1, Index{});
    }
  }
};

/// A limit curve as a control loop reads it: plain data, in unit wrenches. Valid as long as its table. `Real` is the arithmetic type;
/// `Number` below is Real or a pack of Reals.
template <class Real>
struct CurveView {
  bool is_box = false;  ///< uncoupled limits; if false, a table or, without one, an ellipse
  Real force_max = 1;   ///< f at pure sliding
  Real moment_max = 1;  ///< m at pure spin: the moment ratio m₀ where force_max is 1
  Real inverse_force_max = 1;
  Real inverse_moment_max = 1;
  Real rim_force = 0;  ///< the wrench at s = 1, the centre of rotation on the rim
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

  /// The support function inside or outside the rim at x ∈ [0, 1]. Not for the box, whose corner has many normals.
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

/// A point of a limit curve with its outward normal, which is the direction of slip.
template <class Number>
struct CurvePoint {
  Number force;
  Number moment;
  Number slide;  ///< |v| : a|ω| = slide : spin, both ≥ 0
  Number spin;
  Number parameter;  ///< curve parameter t ∈ [0, 2]: s up to the rim, 2 − 1/s beyond. A warm start for the next search
};

/// A trial wrench in components of one side of the curve: the leading one is the force inside the rim, the moment outside.
template <class Real, class Number>
struct CurveSide {
  using Mask = decltype(Number{} < Number{});
  Mask outside;
  Number leading;   ///< of the trial wrench
  Number trailing;  ///< of the trial wrench

  CurveSide(Mask beyond_rim, Number force, Number moment) noexcept : outside(beyond_rim) {
    using namespace arithmetic;
    leading = select(outside, moment, force);
    trailing = select(outside, force, moment);
  }

  /// The x at which a search starts: that of the curve parameter `last`; if `last` is 0 (none known), that of the twist slide : spin =
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
    // A wrench on an axis has its root exactly at the end, which the iteration would only approach.
    return select(leading > zero, larger(zero, smaller(Number(Real(1)), x)), zero);
  }

  [[nodiscard]] CurvePoint<Number> point(const Jet<Number>& jet, Number x) const noexcept {
    using arithmetic::select;
    const Number one = Number(Real(1));
    return {select(outside, jet.trailing(x), jet.leading()), select(outside, jet.leading(), jet.trailing(x)), select(outside, one, x),
            select(outside, x, one), select(outside, Number(Real(2)) - x, x)};
  }
};

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// The point where the ray from the origin through a wrench ≠ 0 meets the curve, and in `gauge` the wrench's gauge: 1 on the curve, less
/// inside. Root of T·leading − L·trailing, L and T the curve's components at x. `last` is the curve parameter of a warm start, or 0. Not
/// for the box.
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
  // Gauge by the tangent at x: its error is the square of that of x.
  gauge = (side.trailing + x * side.leading) / jet.value;
  return side.point(jet, x);
}

/// The gauge of a wrench: 0 at the origin, 1 on the curve, more outside. `last` as in point_on_ray.
template <class Real, class Number>
[[nodiscard]] Number gauge(const CurveView<Real>& curve, Number force, Number moment, Number last) noexcept {
  using namespace arithmetic;
  const Number x = force * Number(curve.inverse_force_max);
  const Number y = moment * Number(curve.inverse_moment_max);
  if (curve.is_box) return larger(x, y);
  if (!curve.has_table()) return sqrt(x * x + y * y);
  Number result;
  static_cast<void>(point_on_ray(curve, force, moment, last, result));
  return result;
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve
