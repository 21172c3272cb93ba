// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve {

/// What `remove_noise` found.
struct SignedNoise {
  double least = 0.0;          ///< most negative pressure
  std::size_t place = 0;       ///< its index
  double floor = 0.0;          ///< pressures up to this count as 0
  std::size_t negative = 0;    ///< their number
  std::size_t zeroed = 0;      ///< number of pressures other than 0 that count as 0, the negative ones among them
  double load_fraction = 0.0;  ///< their sum with signs, over the sum of all: what the load loses

  [[nodiscard]] std::string text() const {
    return (negative > 0
                ? std::to_string(negative) + " pressures are negative, down to " + format_number(least, 3) + "; "
                : "") +
           std::to_string(zeroed) + " up to " + format_number(floor, 3) + " count as 0, " +
           format_number(100.0 * load_fraction, 2) + " % of the load";
  }
};

/// Sets to 0 what is a sensor's noise around 0: with `floor` all pressures up to it; else, if pressures are negative,
/// all up to 1.5 times the most negative. (Clipped at 0 the noise would leave a pressure far from the centre, and bias
/// the moment: +27 % at 3 % noise.) `areas` are what each pressure stands for. Throws std::invalid_argument that begins
/// with `name_of` the most negative's index if without `floor` that pressure is above 10 % of the largest, or what
/// counts as 0 above 2 % of the load.
template <class Name>
SignedNoise remove_noise(std::vector<double>& pressures, std::span<const double> areas, const Name& name_of,
                         std::optional<double> floor = {}) {
  constexpr double width = 1.5;
  constexpr double most_negative = 0.1;
  constexpr double most_load = 0.02;
  SignedNoise noise;
  double largest = 0.0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    if (pressures[i] < pressures[noise.place]) noise.place = i;
    largest = std::max(largest, pressures[i]);
  }
  if (!pressures.empty()) noise.least = std::min(0.0, pressures[noise.place]);
  if (noise.least < 0.0 && largest == 0.0)
    throw std::invalid_argument(name_of(noise.place) + ": a pressure of " + format_number(noise.least) +
                                ", and none is positive; is the sign reversed?");
  noise.floor = floor.value_or(-width * noise.least);
  if (!floor && -noise.least > most_negative * largest && largest > 0.0) {
    throw std::invalid_argument(name_of(noise.place) + ": a pressure of " + format_number(noise.least) +
                                " beside the largest, " + format_number(largest) +
                                ": more than noise; expected the offset of the sensor to be subtracted");
  }
  double all = 0.0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const double load = pressures[i] * areas[i];
    all += load;
    if (pressures[i] > noise.floor || pressures[i] == 0.0) continue;
    if (pressures[i] < 0.0) ++noise.negative;
    ++noise.zeroed;
    noise.load_fraction += load;
    pressures[i] = 0.0;
  }
  noise.load_fraction = noise.zeroed > 0 && all > 0.0 ? noise.load_fraction / all : 0.0;
  if (!floor && std::fabs(noise.load_fraction) > most_load) {
    throw std::invalid_argument(name_of(noise.place) + ": " + noise.text() +
                                ", expected noise that is at most 2 % of it");
  }
  return noise;
}

}  // namespace limitcurve
