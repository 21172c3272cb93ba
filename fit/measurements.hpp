// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limitcurve::fit {

/// A measurement of a force–torque sensor at the onset of slip: a point of the limit curve at that load, with noise.
/// A row of a file with the columns `load,force,moment[,sigma_force,sigma_moment]`.
struct Sample {
  double load = 0.0;    ///< P [N], > 0
  double force = 0.0;   ///< F [N]: tangential friction force; the sign may be either
  double moment = 0.0;  ///< M [N·m]: friction moment about the contact normal; the sign may be either
  /// Standard deviations [N], [N·m]. They must be > 0, or 0 in all samples if they are unknown.
  double sigma_force = 0.0;
  double sigma_moment = 0.0;
  std::size_t row = 0;   ///< the number by which messages name the sample, such as a line of a file; 0: count from 1
  std::size_t grip = 0;  ///< the contact of the log to which the sample belongs, for Loss::edge; 0: unknown
};

/// Contact radii, or moments of pure twists, at loads: the rows of a file with the columns `load,radius[,sigma_radius]`
/// or `load,moment[,sigma_moment]`.
struct LoadSamples {
  enum class Quantity { radius, moment };
  struct Row {
    double load = 0.0;    ///< P [N], > 0
    double value = 0.0;   ///< radius [m] or moment [N·m], > 0
    double sigma = 0.0;   ///< standard deviation of the value, > 0, or 0 in all samples if unknown
    std::size_t row = 0;  ///< as in Sample
  };
  Quantity quantity = Quantity::radius;
  std::vector<Row> samples;
};

/// The loss function decides how much a large residual counts. `scale` is the residual, in standard deviations, above
/// which a sample is doubtful, because ρ(r²) is r² below about scale². The defaults lose 5 % of efficiency on clean
/// Gaussian data.
struct Loss {
  enum class Kind {
    squared,  ///< r²: best for Gaussian errors, but a gross outlier spoils it
    huber,    ///< r² up to scale, then linear: bounded influence
    cauchy,   ///< scale² log(1 + r²/scale²): the influence of gross outliers goes to zero
    edge,     ///< rows may also lie below the limit, as in a log that does not mark slip (`fit_contact` with a law)
  };
  Kind kind = Kind::squared;
  double scale = 1.0;

  /// The loss with the default scale of its kind.
  static constexpr Loss of(Kind kind) noexcept {
    switch (kind) {
      case Kind::squared:
        return squared();
      case Kind::huber:
        return huber();
      case Kind::cauchy:
        return cauchy();
      case Kind::edge:
        return edge();
    }
    return {};
  }
  static constexpr Loss squared() noexcept { return {}; }
  static constexpr Loss huber(double scale = 1.345) noexcept { return {Kind::huber, scale}; }
  static constexpr Loss cauchy(double scale = 2.385) noexcept { return {Kind::cauchy, scale}; }
  static constexpr Loss edge() noexcept { return {Kind::edge}; }
};

/// In the order of Loss::Kind.
inline constexpr std::array<std::string_view, 4> loss_names{"squared", "huber", "cauchy", "edge"};
constexpr const char* to_string(Loss::Kind kind) noexcept {
  return loss_names[static_cast<std::size_t>(kind)].data();
}

}  // namespace limitcurve::fit
