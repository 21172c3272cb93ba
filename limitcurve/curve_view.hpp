// SPDX-License-Identifier: MIT
#pragma once

// Internal: installed because other headers need it; it may change in every version.

#include "arithmetic.hpp"
#include "search.hpp"

#include <array>
#include <cstdint>

// Clang would compile these as functions, and take those of a program with other flags for the library's, too. GCC
// inlines them.
#ifdef __clang__
#define LIMITCURVE_INLINED [[nodiscard, gnu::always_inline]]
#else
#define LIMITCURVE_INLINED [[nodiscard]]
#endif

namespace limitcurve {

/// The support function D(x) of a limit curve along one side, with its derivatives. Inside the rim x = s = c/a and D(x)
/// = H(x, 1); outside x = 1/s and D(x) = H(1, x). x ∈ [0, 1] on both sides. The leading component of the wrench is the
/// force inside, the moment outside.
template <class Real>
struct Jet {
  Real leading;   ///< D′
  Real trailing;  ///< D − xD′
  Real second;    ///< D″ ≥ 0, the derivative of the leading component
  Real third;     ///< D‴

  [[nodiscard]] Real value(Real x) const noexcept { return trailing + x * leading; }  ///< D
  /// A step of Horner's scheme for both components, and for the Taylor coefficients of the leading one.
  [[gnu::always_inline]] void append(Real t, Real next_leading, Real next_trailing) noexcept {
    third = third * t + second;
    second = second * t + leading;
    leading = leading * t + next_leading;
    trailing = trailing * t + next_trailing;
  }
  /// Force and moment.
  template <class Mask>
  [[nodiscard]] std::array<Real, 2> wrench(Mask outside) const noexcept {
    using arithmetic::select;
    return {select(outside, trailing, leading), select(outside, leading, trailing)};
  }
  /// The components a short step from x, by their Taylor series.
  [[nodiscard]] Jet moved(Real x, Real step) const noexcept {
    const Real half_step = Real(0.5) * step;
    return {leading + step * (second + half_step * third),
            trailing - step * (x * second + half_step * (second + x * third)), second, third};
  }
};

/// A cell of a table (TableView) at an index.
template <class Real>
struct LoadedCell {
  const Real* numbers;
  bool outside;

  [[nodiscard]] Real origin() const noexcept { return numbers[0]; }
  [[nodiscard]] Real leading(int i) const noexcept { return numbers[2 * i + 2 + outside]; }
  [[nodiscard]] Real trailing(int i) const noexcept { return numbers[2 * i + 3 - outside]; }
};
template <std::floating_point Real, std::integral Index>
[[nodiscard]] constexpr LoadedCell<Real> load_cell(const Real* array, Index at, bool outside) noexcept {
  return {array + at, outside};
}

/// The cells of a table as a control loop reads them: the support function D(x) of both sides (Jet), a polynomial in
/// each cell. Plain pointers to data that the table owns; copies are cheap.
///
/// A cell holds force and moment side by side as polynomials, so that one instruction serves both: inside the rim D′
/// and D − xD′, outside D − xD′ and D′.
///
/// How a cell is found: y = 1 − x is the distance from the rim. The exponent and the leading mantissa bits of y +
/// `offset`, offset = 2^−d, are the number of a bucket. So every octave towards the rim, where most limit curves are
/// singular, has the same number of buckets. There are two runs of buckets, inside and outside the rim. A bucket knows
/// the last cell that begins in it or before it. A search is needed only if several cells begin in one bucket: next to
/// a singularity elsewhere, as of a pressure that is concentrated at the centre. NaN counts as the rim, so that no
/// index leaves the arrays.
template <class Real>
struct TableView {
  const Real* cells =
      nullptr;  ///< of each: its origin x₀, twice, then fᵢ, mᵢ of f = Σ fᵢ (x − x₀)ⁱ, i = 0 … degree; aligned as a Pair
  const std::uint16_t* cell_of_bucket = nullptr;  ///< place of its last cell, in pairs of numbers; inside, then outside
  Real offset = 0;                                ///< 2^−d
  int dropped_bits = 0;                           ///< of the mantissa
  std::array<int, 2> runs = {0, 0};               ///< begin of each run, minus the leading bits of `offset`
  std::array<int, 2> first_cells = {0, 0};        ///< place of the first cell of each side
  int degree = most_degree;                       ///< of D
  int halvings = 0;  ///< of a search: fewer than 2^halvings cells begin in any bucket after its first

  static constexpr int least_degree = 3;
  static constexpr int most_degree = 6;
  /// The pairs of numbers of a cell, and those beyond the last cell that a pack may load.
  [[nodiscard]] static constexpr int pairs_per_cell(int degree) noexcept { return degree + 2; }
  static constexpr int padding = 4;

  /// Writes the cell with the origin `x` and the coefficients of D.
  static constexpr void write_cell(bool outside, double x, const std::array<double, most_degree + 1>& coefficients,
                                   int degree, Real* to) noexcept {
    to[0] = to[1] = static_cast<Real>(x);
    for (int i = 0; i <= degree; ++i) {
      to += 2;
      const double leading = i < degree ? (i + 1) * coefficients[static_cast<std::size_t>(i) + 1] : 0.0;
      to[outside] = static_cast<Real>(leading);
      to[!outside] = static_cast<Real>((1 - i) * coefficients[static_cast<std::size_t>(i)] - x * leading);
    }
  }

  /// Force and moment at x ∈ [0, 1]. Inlined at -O2, too.
  [[nodiscard, gnu::always_inline]] arithmetic::Pair<Real> wrench(bool outside, Real x) const noexcept {
    const Real* const cell = cells + 2 * place(outside, x);
    const Real t = x - *cell;
    auto sum = arithmetic::load_pair(cell + 2 * degree + 2);
    const auto add = [&](int i) { sum = sum * t + arithmetic::load_pair(cell + 2 * i + 2); };
    // Branches are faster than a loop: a processor learns them.
    if (degree > 5) add(5);
    if (degree > 4) add(4);
    if (degree > 3) add(3);
    add(2);
    add(1);
    add(0);
    return sum;
  }

  /// The components and the derivatives of D at x ∈ [0, 1]. `Number` is Real or a pack of it, `outside` a bool or
  /// the pack's mask.
  template <class Number, class Mask>
  LIMITCURVE_INLINED Jet<Number> jet(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const auto at = place(outside, x);
    const auto cell = load_cell(cells, at + at, outside);
    const Number t = x - cell.origin();
    Jet<Number> jet{};
    if (degree > 5) jet.append(t, cell.leading(6), cell.trailing(6));
    if (degree > 4) jet.append(t, cell.leading(5), cell.trailing(5));
    if (degree > 3) jet.append(t, cell.leading(4), cell.trailing(4));
    jet.append(t, cell.leading(3), cell.trailing(3));
    jet.append(t, cell.leading(2), cell.trailing(2));
    jet.append(t, cell.leading(1), cell.trailing(1));
    jet.append(t, cell.leading(0), cell.trailing(0));
    jet.third = Number(Real(2)) * jet.third;
    return jet;
  }

  /// The place of the cell that contains x, in pairs of numbers.
  template <class Number, class Mask>
  [[nodiscard]] auto place(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const Number y = larger(Number(Real(0)), Number(Real(1)) - x);
    const auto bits = leading_bits(y + Number(offset), dropped_bits);
    const auto last = gather(cell_of_bucket, bits + one_of(runs, outside, bits));
    if (halvings > 0) [[unlikely]]
      return search(last, outside, x);
    return last;
  }

 private:
  /// The place of the last cell at or before `last` that begins at or before x.
  template <class Index, class Mask, class Number>
  [[nodiscard]] Index search(Index last, Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const Index first = one_of(first_cells, outside, last);
    const int one_cell = degree + 2;
    for (int step = one_cell << (halvings - 1); step >= one_cell; step /= 2) {
      // The first cell of a side begins at 0, and so ends the search.
      const Index next = first + not_negative(last - first - (step - one_cell));
      const auto is_after = gather(cells, next + next) > larger(Number(Real(0)), x);
      last = last - one_of({0, step}, is_after, last);
    }
    return last;
  }
};

/// A limit curve as a control loop reads it: plain data, in unit wrenches. Valid as long as its table. `Real` is the
/// arithmetic type; `Number` below is Real or a pack of Reals.
template <class Real>
struct CurveView {
  bool is_box = false;  ///< uncoupled limits; if false, a table or, without one, an ellipse
  Real force_max = 1;   ///< f at pure sliding
  Real moment_max = 1;  ///< m at pure spin: the moment ratio m₀ where force_max is 1
  Real inverse_force_max = 1;
  Real inverse_moment_max = 1;
  Real rim_force = 0;  ///< the wrench at s = 1, the centre of rotation on the rim
  Real rim_moment = 0;
  TableView<Real> table = {};
  const Real* ray_starts = nullptr;  ///< of a table: three coefficients for each part of the rays (ray_start)

  /// 2^ray_bits parts from pure sliding to pure spin, and one for pure spin alone.
  static constexpr int ray_bits = 7;

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

  /// Where a search on a ray starts: the curve parameter (CurvePoint), to about 1e-8 if the curve is smooth there, by a
  /// parabola in the moment's share of the wrench, m/m_max over f/f_max + m/m_max. 0 without a table.
  template <class Number>
  [[nodiscard]] Number ray_start(Number share) const noexcept {
    using namespace arithmetic;
    const Number zero = Number(Real(0));
    const Number one = Number(Real(1));
    if (ray_starts == nullptr) return zero;
    // NaN counts as pure sliding, so that no index leaves the array.
    share = smaller(one, larger(zero, share));
    constexpr int dropped_bits = std::numeric_limits<Real>::digits - 1 - ray_bits;
    const auto part = leading_bits(one + share, dropped_bits) - leading_bits(one, dropped_bits);
    const auto at = part + part + part;
    return gather(ray_starts, at) + share * (gather(ray_starts, at + 1) + share * gather(ray_starts, at + 2));
  }

  /// The support function inside or outside the rim at x ∈ [0, 1]. Not for the box, whose corner has many normals.
  template <class Number, class Mask>
  LIMITCURVE_INLINED Jet<Number> jet(Mask outside, Number x) const noexcept {
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
    return {first, b * b * inverse, second, Number(Real(-3)) * first * second * inverse};
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

/// A trial wrench in components of one side of the curve: the leading one is the force inside the rim, the moment
/// outside.
template <class Real, class Number>
struct CurveSide {
  using Mask = decltype(Number{} < Number{});
  Mask outside;
  Number leading;   ///< of the trial wrench
  Number trailing;  ///< of the trial wrench

  CurveSide(Mask is_outside, Number force, Number moment) noexcept : outside(is_outside) {
    using namespace arithmetic;
    leading = select(outside, moment, force);
    trailing = select(outside, force, moment);
  }

  /// The x at which a search starts: that of the curve parameter `last`; if `last` is 0 (none known), that of the twist
  /// slide : spin = guess_twist().
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
    const auto [force, moment] = jet.wrench(outside);
    return {force, moment, select(outside, one, x), select(outside, x, one), select(outside, Number(Real(2)) - x, x)};
  }
};

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// The point where the ray from the origin through a wrench ≠ 0 meets the curve, and in `gauge` the wrench's gauge: 1
/// on the curve, less inside. Root of T·leading − L·trailing, L and T the curve's components at x. `last` is the curve
/// parameter of a warm start, or 0. Not for the box.
template <class Real, class Number>
[[nodiscard]] CurvePoint<Number> point_on_ray(const CurveView<Real>& curve, Number force, Number moment, Number last,
                                              Number& gauge) noexcept {
  // First guess: the normal of the ellipse with the same intercepts.
  const auto guess_twist = [&]() noexcept {
    const Number a = Number(curve.force_max);
    const Number b = Number(curve.moment_max);
    return std::array{force * b * b, moment * a * a};
  };
  const CurveSide<Real, Number> side(force * Number(curve.rim_moment) > moment * Number(curve.rim_force), force,
                                     moment);
  Jet<Number> jet;
  const Root<Number> root = find_root<Real>(
      [&](Number at) noexcept -> Residual<Number> {
        jet = curve.jet(side.outside, at);
        const Number turn = side.trailing + at * side.leading;
        const Number up = jet.trailing * side.leading;
        const Number down = jet.leading * side.trailing;
        return {up - down, -jet.second * turn, -jet.third * turn - jet.second * side.leading,
                Number(4 * std::numeric_limits<Real>::epsilon()) * (up + down)};
      },
      side.begin(last, guess_twist));
  const Number x = root.x + root.step;
  jet = jet.moved(root.x, root.step);
  // Gauge by the tangent at x: its error is the square of that of x.
  gauge = (side.trailing + x * side.leading) / jet.value(x);
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

/// The gauge of a wrench divided by the sum f/f_max + m/m_max, of which its moment has the `share`.
template <class Real, class Number>
[[nodiscard]] Number gauge_per_sum(const CurveView<Real>& curve, Number share) noexcept {
  return gauge(curve, (Number(Real(1)) - share) * Number(curve.force_max), share * Number(curve.moment_max),
               curve.ray_start(share));
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve

#undef LIMITCURVE_INLINED
