// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace limitcurve {

/// First guesses at the closest points of one table in one metric f² + χm², for searches that have no last one to begin from: where a
/// contact begins to slip.
///
/// Tabulated is by what multiple the coordinate of the foot on its side exceeds what the trial alone tells, the quotient of x̂/f_max and
/// ŷ/m_max; 1 throughout where the curve is an ellipse and the metric its own. It is bilinear on patches over the share that
/// the moment has in the sum x̂/f_max + ŷ/m_max, and over one over that sum, which is 1 on the chord of the intercepts. Near a curve the
/// guess is good to 1e-4 as a rule, and to some 1e-3 about the rim, where the curve's derivatives are singular.
class FootGuesses {
 public:
  /// Patches are as wide as one over so many: of the share from 0 to 1, …
  static constexpr std::size_t shares = 64;
  /// … and of one over the sum.
  static constexpr std::size_t distances = 64;
  /// Sums from here on are left to Table::closest: pulls that far beyond the curve are rare.
  static constexpr double farthest = 2.0;

  /// Expects χ within 1e±100. Cost: some 1500 searches; 70 KB.
  FootGuesses(const Table& table, double chi);

  /// As Table::closest, for the table that the guesses are for and a finite trial that is on or beyond the chord of the intercepts. `parts`
  /// is (x̂/f_max, ŷ/m_max), and `sum` their sum. As a rule one step of the fourth order, from the guess.
  /// The wrench is returned alone, in a register, for a step waits for it; all that the foot is goes through memory.
  [[nodiscard, gnu::noinline]] Pair closest(const Table& table, Pair trial, Pair parts, double sum, Foot& foot) const noexcept {
    const auto search = [&](double start) {
      foot = table.closest({trial[0], trial[1]}, chi_, per_chi_, start);
      return Pair{foot.wrench.force, foot.wrench.moment};
    };
    if (!(sum < farthest && parts[0] > 0.0 && parts[1] > 0.0)) [[unlikely]]
      return search(-1.0);
    const Pair at = Pair{parts[1] * shares, distances} / Pair{sum, sum};
    // The trial's side of the normal at the rim.
    const Pair beyond_rim = trial - Pair{table.rim().force, table.rim().moment};
    if (beyond_rim[0] > chi_ * beyond_rim[1]) {
      const double start = parts[1] / parts[0] * multiple(patches_[1], at);
      const auto [moment, force, x, cell] = table.outside().closest_in_one_long_step(Pair{trial[1], trial[0]}, per_chi_, start);
      if (cell == TableSide::none) [[unlikely]]
        return search(2.0 - start);
      foot = {{force, moment}, {1.0, x}, 2.0 - x, cell};
      return Pair{force, moment};
    }
    const double start = parts[0] / parts[1] * multiple(patches_[0], at);
    const auto [force, moment, x, cell] = table.inside().closest_in_one_long_step(trial, chi_, start);
    if (cell == TableSide::none) [[unlikely]]
      return search(start);
    foot = {{force, moment}, {x, 1.0}, x, cell};
    return Pair{force, moment};
  }

 private:
  static constexpr std::size_t first_distance = distances / 2;

  /// Coefficients of 1, u, w and uw, where u and w are distances from the middle of a patch in patches.
  struct Patch {
    float constant;
    float by_share;
    float by_distance;
    float by_both;
  };
  using Patches = std::array<Patch, (shares + 1) * (distances - first_distance + 1)>;

  /// At a share and a distance in patches. The nearest whole numbers are the last bits of what adding a number so large leaves.
  [[gnu::always_inline]] [[nodiscard]] static double multiple(const Patches& patches, Pair at) noexcept {
    constexpr double large = 0x1.8p52;
    const Pair shifted = at + Pair{large, large};
    const Pair from = at - (shifted - Pair{large, large});
    const auto whole = [](double number) { return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(number) & 0xFFFF); };
    const Patch& patch = patches[whole(shifted[0]) * (distances - first_distance + 1) + whole(shifted[1]) - first_distance];
    return (double{patch.constant} + from[0] * double{patch.by_share}) +
           from[1] * (double{patch.by_distance} + from[0] * double{patch.by_both});
  }

  std::array<Patches, 2> patches_;  // inside, outside; by share, then by distance
  double chi_;
  double per_chi_;
};

}  // namespace limitcurve
