// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::cli {

/// The zero of a sensor's channels over a log, from the pauses between contacts.
///
/// A pause is at least five consecutive rows whose load is less than `least_load` above the lowest percentile of all
/// loads: an offset does not matter. Its zero is the median of its middle half, because the first and the last rows may
/// still be loaded. Between two pauses the zero is linear in the row, before the first and after the last it is theirs.
class SensorZero {
 public:
  static constexpr std::size_t shortest_pause = 5;

  /// `channels` have a number each row, in order of time, and so have `loads`, with the sign of a load.
  SensorZero(const std::vector<std::vector<double>>& channels, std::span<const double> loads, double least_load);

  [[nodiscard]] std::size_t pauses() const { return middles_.size(); }
  /// Those within which the load changes: by more than the noise of the log, and than 5 % of the least load, in half of
  /// the rows that give the zero; or which have a pause's rows by the least load below it, because a light grip gives
  /// it.
  [[nodiscard]] std::size_t unsettled() const { return unsettled_; }
  /// Standard deviation of the load from row to row.
  [[nodiscard]] double noise() const { return noise_; }
  /// The zero of a channel at a row; of a pause. None of them if there is no pause.
  [[nodiscard]] double at(std::size_t channel, std::size_t row) const;
  [[nodiscard]] std::span<const double> levels(std::size_t channel) const { return levels_[channel]; }
  /// Root mean square of a channel about its zero in the pauses, at least that of its smallest step: a standard
  /// deviation of one row. 0 if the channel never changes there.
  [[nodiscard]] double sigma(std::size_t channel) const { return sigmas_[channel]; }

 private:
  std::vector<double> middles_;              ///< rows
  std::vector<std::vector<double>> levels_;  ///< of each channel and pause
  std::vector<double> sigmas_;
  std::size_t unsettled_ = 0;
  double noise_ = 0.0;
};

}  // namespace limitcurve::cli
