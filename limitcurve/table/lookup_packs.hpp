// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"
#include "limitcurve/kernel/pack.hpp"
#include "limitcurve/kernel/pack_x86.hpp"
#include "limitcurve/table/lookup.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

/// Look-ups in a table by packs, in the order of operations of single ones (BasicTable).
namespace limitcurve::kernel {

/// The numbers of two packs in memory, those at even places first.
template <class Isa, std::size_t... lane>
[[nodiscard]] std::array<Pack<double, Isa>, 2> unzip(const double* pairs, std::index_sequence<lane...>) noexcept {
  const auto one = load(pairs, Pack<double, Isa>()).lanes;
  const auto other = load(pairs + sizeof...(lane), Pack<double, Isa>()).lanes;
  return {Pack<double, Isa>(__builtin_shufflevector(one, other, static_cast<int>(2 * lane)...)),
          Pack<double, Isa>(__builtin_shufflevector(one, other, static_cast<int>(2 * lane + 1)...))};
}
/// The inverse of `unzip`.
template <class Isa, std::size_t... lane>
void zip(Pack<double, Isa> even, Pack<double, Isa> odd, double* pairs, std::index_sequence<lane...>) noexcept {
  constexpr std::size_t size = sizeof...(lane);
  const auto first = __builtin_shufflevector(even.lanes, odd.lanes, static_cast<int>(lane / 2 + lane % 2 * size)...);
  const auto second = __builtin_shufflevector(even.lanes, odd.lanes, static_cast<int>(lane / 2 + lane % 2 * size + size / 2)...);
  __builtin_memcpy(pairs, &first, sizeof first);
  __builtin_memcpy(pairs + size, &second, sizeof second);
}

template <class Isa>
using Places = std::make_index_sequence<Pack<double, Isa>::size>;

template <class Isa, int degree>
[[gnu::flatten]] std::size_t wrenches_of_degree(const TablePieces<double>& pieces, const SlipTwist* twists, UnitWrench* wrenches,
                                                std::size_t count) noexcept {
  using Number = Pack<double, Isa>;
  const TablePieces<double> table = pieces;
  std::size_t i = 0;
  for (; i + Number::size <= count; i += Number::size) {
    const auto given = unzip<Isa>(&twists[i].slide, Places<Isa>());
    const Number slide = abs(given[0]);
    const Number spin = abs(given[1]);
    const Number sum = slide + spin;
    const Number x = smaller(slide, spin) / larger(slide, spin);
    const auto beyond_rim = slide > spin;
    const auto at = table.place(beyond_rim, x);
    const auto cell = load_cell(table.cells, at + at, beyond_rim);
    const Number t = x - cell.origin();
    Number force = cell.force(degree);
    Number moment = cell.moment(degree);
    for (int k = degree - 1; k >= 0; --k) {
      force = force * t + cell.force(k);
      moment = moment * t + cell.moment(k);
    }
    const auto slips = sum > Number(0.0);
    zip(select(slips, force, sum), select(slips, moment, sum), &wrenches[i].force, Places<Isa>());
  }
  return i;
}

template <class Isa>
std::size_t wrenches_in_packs(const TablePieces<double>& table, const SlipTwist* twists, UnitWrench* wrenches, std::size_t count) noexcept {
  switch (table.degree) {
    case 3:
      return wrenches_of_degree<Isa, 3>(table, twists, wrenches, count);
    case 4:
      return wrenches_of_degree<Isa, 4>(table, twists, wrenches, count);
    case 5:
      return wrenches_of_degree<Isa, 5>(table, twists, wrenches, count);
    default:
      return wrenches_of_degree<Isa, 6>(table, twists, wrenches, count);
  }
}

template <class Isa>
[[gnu::flatten]] std::size_t gauges_in_packs(const CurveView<double>& view, const UnitWrench* wrenches, double* gauges,
                                             std::size_t count) noexcept {
  using Number = Pack<double, Isa>;
  const CurveView<double> curve = view;
  std::size_t i = 0;
  for (; i + Number::size <= count; i += Number::size) {
    const auto given = unzip<Isa>(&wrenches[i].force, Places<Isa>());
    const Number force = abs(given[0]);
    const Number moment = abs(given[1]);
    const Number size = larger(force, moment);
    const Number f = force / size;
    const Number m = moment / size;
    Number length;
    static_cast<void>(point_on_ray(curve, f, m, Number(0.0), length));
    const Number sum = force + moment;
    const auto is_usual = sum > Number(0.0) && sum <= Number(std::numeric_limits<double>::max());
    const Number gauge = select(is_usual, sum / (f / length + m / length), sum);
    *reinterpret_cast<typename Registers<double, Isa>::Unaligned*>(gauges + i) = gauge.lanes;
  }
  return i;
}

}  // namespace limitcurve::kernel
