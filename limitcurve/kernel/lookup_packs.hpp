// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"
#include "limitcurve/kernel/pack.hpp"
#include "limitcurve/kernel/pack_x86.hpp"
#include "limitcurve/wrench.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

/// Gauges of a table by packs, in the order of operations of single ones (BasicTable).
namespace limitcurve::kernel {

/// The numbers of two packs in memory, those at even places first.
template <class Isa, std::size_t... lane>
[[nodiscard]] std::array<Pack<double, Isa>, 2> unzip(const double* pairs, std::index_sequence<lane...>) noexcept {
  const auto one = load(pairs, Pack<double, Isa>()).lanes;
  const auto other = load(pairs + sizeof...(lane), Pack<double, Isa>()).lanes;
  return {Pack<double, Isa>(__builtin_shufflevector(one, other, static_cast<int>(2 * lane)...)),
          Pack<double, Isa>(__builtin_shufflevector(one, other, static_cast<int>(2 * lane + 1)...))};
}

template <class Isa>
using Places = std::make_index_sequence<Pack<double, Isa>::size>;

template <class Isa>
[[gnu::flatten]] std::size_t gauges_in_packs(const CurveView<double>& curve, const UnitWrench* wrenches, double* gauges,
                                             std::size_t count) noexcept {
  using Number = Pack<double, Isa>;
  const CurveView<double> own = curve;
  std::size_t i = 0;
  for (; i + Number::size <= count; i += Number::size) {
    const auto given = unzip<Isa>(&wrenches[i].force, Places<Isa>());
    const Number turn = abs(given[1]) * Number(own.inverse_moment_max);
    const Number sum = abs(given[0]) * Number(own.inverse_force_max) + turn;
    const auto is_usual = sum > Number(0.0) && sum <= Number(std::numeric_limits<double>::max());
    *reinterpret_cast<typename Registers<double, Isa>::Unaligned*>(gauges + i) =
        select(is_usual, sum * gauge_per_sum(own, turn / sum), sum).lanes;
  }
  return i;
}

}  // namespace limitcurve::kernel
