// SPDX-License-Identifier: MIT
#include "limitcurve/patch/disc_models.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/validate/shipped_costs.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace limitcurve {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr std::size_t directions = 128;
constexpr std::size_t distances = 121;
constexpr double decades = 3.0;  ///< of distances, either way

/// The COR of a twist: its direction, and the logarithm (base 10) of its distance in `length_`. ±∞ is pure sliding and
/// pure spin.
struct Cor {
  double direction;
  double exponent;
};

/// A model: its power, and the distance of its COR for a wrench.
struct Model {
  std::function<double(const PatchTwist&)> power;
  std::function<double(const PatchWrench&)> cor_distance;
  bool is_isotropic = true;  ///< its power depends on |v| and |ω| alone
};

class Comparison {
 public:
  explicit Comparison(const Patch& patch)
      : patch_(patch), m0_(patch.moment_ratio()), factor_(disc_factor(patch)), length_(m0_ / factor_) {
    if (!(m0_ > 0.0))
      throw std::invalid_argument("all load of the patch is on one point, expected a patch that resists a turn");
    for (std::size_t i = 0; i < distances; ++i) {
      for (std::size_t j = 0; j < directions; ++j) {
        let_interrupt();
        grid_.push_back(cor_at(i, j));
        const PatchFriction friction = patch_.evaluate(twist_at(grid_.back()));
        power_.push_back(friction.power);
        wrench_.push_back(friction.wrench);
      }
    }
    const PatchPoint centre = patch_.centre();
    for (const auto& [x, y, load] : patch_.round_measures().concentrations) {
      const double distance = std::hypot(x - centre.x, y - centre.y);
      if (!(distance > 0.0)) continue;  // pure spin
      let_interrupt();
      concentrations_.push_back({std::atan2(y - centre.y, x - centre.x), std::log10(distance / length_)});
      concentrated_power_.push_back(patch_.power(twist_at(concentrations_.back())));
    }
  }

  /// H_model/H − 1 and 1 − H_model/H at their largest, and the mean square over the grid.
  [[nodiscard]] CurveError power_error(const Model& model) const {
    std::size_t most = 0;
    std::size_t least = 0;
    std::vector<double> ratio(grid_.size());
    double squares = 0.0;
    double power = 0.0;
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      let_interrupt();
      if (!model.is_isotropic || i % directions == 0) power = model.power(twist_at(grid_[i]));
      ratio[i] = power / power_[i];
      squares += (ratio[i] - 1.0) * (ratio[i] - 1.0);
      if (ratio[i] > ratio[most]) most = i;
      if (ratio[i] < ratio[least]) least = i;
    }
    const auto ratio_at = [&](const Cor& cor) {
      let_interrupt();
      return model.power(twist_at(cor)) / patch_.power(twist_at(cor));
    };
    double largest = climb(grid_[most], ratio[most], ratio_at);
    double highest = 0.0;
    Cor sharpest{};
    for (std::size_t i = 0; i < concentrations_.size(); ++i) {
      const double there = model.power(twist_at(concentrations_[i])) / concentrated_power_[i];
      if (!(there > highest)) continue;
      highest = there;
      sharpest = concentrations_[i];
    }
    if (highest > 0.0) largest = std::max(largest, climb(sharpest, highest, ratio_at));
    double smallest = -climb(grid_[least], -ratio[least], [&](const Cor& cor) { return -ratio_at(cor); });
    // Pure spin, and pure sliding in all directions.
    for (std::size_t j = 0; j <= directions; ++j) {
      const double end = ratio_at({cor_at(0, j).direction, j == directions ? -inf : inf});
      largest = std::max(largest, end);
      smallest = std::min(smallest, end);
    }
    CurveError error;
    error.max_over_estimate = std::max(0.0, largest - 1.0);
    error.max_under_estimate = std::max(0.0, 1.0 - smallest);
    error.max_error = std::max(error.max_over_estimate, error.max_under_estimate);
    error.rms_error = std::sqrt(squares / static_cast<double>(grid_.size()));
    return error;
  }

  [[nodiscard]] double factor() const { return factor_; }

  [[nodiscard]] CurveError error(const Model& model) const {
    CurveError error = power_error(model);
    add_cor_error(model, error);
    return error;
  }

  /// `fraction(slide, spin)`: force and moment of a shape as fractions of their limits, for the speeds |(mx v_x, my
  /// v_y)| and m₀|ω|.
  [[nodiscard]] EngineShape shape(const char* name, UnitWrench (*fraction)(double slide, double spin)) const {
    const auto [mx, my] = patch_.factors();
    const auto speed = [mx = mx, my = my](const PatchTwist& twist) { return std::hypot(mx * twist.vx, my * twist.vy); };
    const auto of = [&](const PatchTwist& twist) { return fraction(speed(twist), m0_ * std::fabs(twist.omega)); };
    Model model;
    model.is_isotropic = mx == my;
    model.power = [&](const PatchTwist& twist) {
      const UnitWrench share = of(twist);
      return share.force * speed(twist) + share.moment * m0_ * std::fabs(twist.omega);
    };
    EngineShape result{name, power_error(model), 0.0};
    const auto compare = [&, mx = mx, my = my](const PatchTwist& twist, const PatchWrench& wrench) {
      const UnitWrench share = of(twist);
      const double along = share.force / speed(twist);
      const double apart = std::hypot(along * mx * twist.vx - wrench.fx / mx, along * my * twist.vy - wrench.fy / my,
                                      share.moment - wrench.moment / m0_);
      result.max_wrench_error = std::max(result.max_wrench_error, apart);
    };
    for (std::size_t i = 0; i < grid_.size(); ++i) compare(twist_at(grid_[i]), wrench_[i]);
    // Beside the twists where box and diamond jump between corners.
    constexpr double far = 9.0;
    constexpr double beside = 1e-9;
    for (std::size_t j = 0; j < directions; ++j) {
      for (const double exponent : {-far, -beside, beside, far}) {
        const PatchTwist twist = twist_at({cor_at(0, j).direction, exponent});
        compare(twist, patch_.wrench(twist));
      }
    }
    return result;
  }

  /// The radius of the disc of this law with the smallest largest error on the grid, and that error. Power grows with
  /// the radius: bisection.
  [[nodiscard]] std::pair<double, double> best_radius(const PressureLaw& law) const {
    const auto over_and_under = [&](double a) {
      double over = a * law.moment_ratio() / length_;  // pure spin
      double under = over;
      for (std::size_t i = 0; i < distances; ++i) {
        let_interrupt();
        const PatchTwist twist = twist_at(grid_[i * directions]);
        const double disc = disc_power(law, a, twist, factor_);
        const auto [low, high] =
            std::minmax_element(power_.begin() + static_cast<std::ptrdiff_t>(i * directions),
                                power_.begin() + static_cast<std::ptrdiff_t>((i + 1) * directions));
        over = std::max(over, disc / *low);
        under = std::min(under, disc / *high);
      }
      for (std::size_t i = 0; i < concentrations_.size(); ++i) {
        let_interrupt();
        over = std::max(over, disc_power(law, a, twist_at(concentrations_[i]), factor_) / concentrated_power_[i]);
      }
      return std::pair{over - 1.0, 1.0 - under};
    };
    // Near 0 logarithms are dense, whatever the patch's size.
    const double unit = length_ / law.moment_ratio();
    double low = -4.0;
    double high = 4.0;
    while (high - low > 1e-14) {
      const double middle = 0.5 * (low + high);
      const auto [over, under] = over_and_under(unit * std::exp(middle));
      (over > under ? high : low) = middle;
    }
    const double a = unit * std::exp(0.5 * (low + high));
    const auto [over, under] = over_and_under(a);
    return {a, std::max(over, under)};
  }

  [[nodiscard]] static double disc_power(const PressureLaw& law, double a, const PatchTwist& twist, double factor) {
    const double slide = std::hypot(twist.vx, twist.vy);
    const double spin = a * std::fabs(twist.omega);
    const UnitForces<double> forces = law.forces(spin > 0.0 ? slide / spin : inf);
    return factor * (slide * forces.force + spin * forces.moment);
  }

 private:
  [[nodiscard]] static Cor cor_at(std::size_t distance, std::size_t direction) {
    return {2.0 * std::numbers::pi * static_cast<double>(direction) / static_cast<double>(directions),
            decades * (2.0 * static_cast<double>(distance) / static_cast<double>(distances - 1) - 1.0)};
  }

  [[nodiscard]] PatchTwist twist_at(const Cor& cor) const {
    // |v| = 1 beyond the length, its product with ω is 1 within.
    const double slide = cor.exponent > 0.0 ? 1.0 : std::pow(10.0, cor.exponent);
    const double spin = cor.exponent > 0.0 ? std::pow(10.0, -cor.exponent) : 1.0;
    return {slide * std::sin(cor.direction), -slide * std::cos(cor.direction), spin / length_};
  }

  /// The largest value near a grid point: steps to the sides, halved when none is better.
  template <class Function>
  [[nodiscard]] static double climb(Cor at, double value, const Function& function) {
    Cor step{2.0 * std::numbers::pi / static_cast<double>(directions),
             2.0 * decades / static_cast<double>(distances - 1)};
    for (int halvings = 0; halvings < 24;) {
      bool better = false;
      for (const Cor& other :
           {Cor{at.direction + step.direction, at.exponent}, Cor{at.direction - step.direction, at.exponent},
            Cor{at.direction, at.exponent + step.exponent}, Cor{at.direction, at.exponent - step.exponent}}) {
        const double there = function(other);
        if (!(there > value)) continue;
        value = there;
        at = other;
        better = true;
      }
      if (better && std::fabs(at.exponent) < 2.0 * decades) continue;
      step = {0.5 * step.direction, 0.5 * step.exponent};
      ++halvings;
    }
    return value;
  }

  void add_cor_error(const Model& model, CurveError& error) const {
    error.max_cor_ratio = 0.0;
    error.min_cor_ratio = inf;
    const auto take = [&](double ratio) {
      error.max_cor_ratio = std::max(error.max_cor_ratio, ratio);
      error.min_cor_ratio = std::min(error.min_cor_ratio, ratio);
    };
    const auto ratio = [&](const Cor& cor, const PatchWrench& wrench) {
      let_interrupt();
      return model.cor_distance(wrench) / (length_ * std::pow(10.0, cor.exponent));
    };
    for (std::size_t i = 0; i < grid_.size(); ++i) take(ratio(grid_[i], wrench_[i]));
    // Towards both ends the ratio has a limit, or grows without bound.
    constexpr double runaway = 0.1;
    for (std::size_t j = 0; j < directions; ++j) {
      for (const double end : {-1.0, 1.0}) {
        const auto ratio_at = [&](double exponent) {
          const Cor cor{cor_at(0, j).direction, exponent};
          return ratio(cor, patch_.wrench(twist_at(cor)));
        };
        const double before = ratio_at(5.0 * end);
        const double at = ratio_at(6.0 * end);
        take(!(at <= before * (1.0 + runaway)) ? inf : before > at * (1.0 + runaway) ? 0.0 : at);
      }
    }
    error.max_cor_error = std::max(error.max_cor_ratio - 1.0, 1.0 - error.min_cor_ratio);
  }

  const Patch& patch_;
  double m0_;
  double factor_;              ///< of the discs
  double length_;              ///< m₀ of the patch without factors, about
  std::vector<Cor> grid_;      ///< distance by distance
  std::vector<double> power_;  ///< of the patch there
  std::vector<PatchWrench> wrench_;
  std::vector<Cor> concentrations_;  ///< of the patch: sharp maxima of a model's over-estimate, which the grid misses
  std::vector<double> concentrated_power_;
};

/// A curve's COR for a wrench.
template <class Curve>
double cor_distance(const Curve& curve, double a, const PatchWrench& wrench) {
  const UnitWrench unit{std::hypot(wrench.fx, wrench.fy), std::fabs(wrench.moment) / a};
  return a * curve.along(unit).normal.cor();
}

Model disc(const Law& law, double a, double factor) {
  const auto power = [law, a, factor](const PatchTwist& twist) {
    return Comparison::disc_power(*law, a, twist, factor);
  };
  if (law->allows(Method::closed)) {
    return {power, [exact = ExactCurve(law), a](const PatchWrench& wrench) { return cor_distance(exact, a, wrench); }};
  }
  constexpr double tolerance = 1e-9;
  return {power, [table = Table::build(law, tolerance), a](const PatchWrench& wrench) {
            return cor_distance(table, a, wrench);
          }};
}

Model ellipsoid(const Patch& patch) {
  const auto [mx, my] = patch.factors();
  const double m0 = patch.moment_ratio();
  // The normal at the wrench (F, M) is (F_x/mx², F_y/my², M/m₀²).
  return {[mx = mx, my = my, m0](const PatchTwist& twist) {
            return std::hypot(mx * twist.vx, my * twist.vy, m0 * twist.omega);
          },
          [mx = mx, my = my, m0](const PatchWrench& wrench) {
            return std::hypot(wrench.fx / (mx * mx), wrench.fy / (my * my)) / std::fabs(wrench.moment) * m0 * m0;
          },
          mx == my};
}

DiscModel disc_model(const Comparison& comparison, const char* kind, const Law& law, double a) {
  return {std::string(kind) + ":" + law->name(), a, comparison.error(disc(law, a, comparison.factor()))};
}

DiscModel best_disc(const Comparison& comparison) {
  Law best;
  double radius = 0.0;
  double least = inf;
  for (const std::string_view name : law_examples()) {
    const Law law = parse_law(name);
    const auto [a, error] = comparison.best_radius(*law);
    if (!(error < least)) continue;
    best = law;
    radius = a;
    least = error;
  }
  // Between grid points both errors may be larger: balance them again.
  const auto imbalance = [&](double a) {
    const CurveError error = comparison.power_error(disc(best, a, comparison.factor()));
    return error.max_over_estimate - error.max_under_estimate;
  };
  constexpr double near = 0.01;
  if (least > 1e-6 && imbalance(radius * (1.0 - near)) < 0.0 && imbalance(radius * (1.0 + near)) > 0.0) {
    constexpr int bits = 24;
    std::uintmax_t steps = 20;
    const auto [low, high] = boost::math::tools::toms748_solve(imbalance, radius * (1.0 - near), radius * (1.0 + near),
                                                               boost::math::tools::eps_tolerance<double>(bits), steps);
    radius = 0.5 * (low + high);
  }
  return disc_model(comparison, "disc", best, radius);
}

}  // namespace

double disc_factor(const Patch& patch) {
  const auto [mx, my] = patch.factors();
  return 2.0 * mx * my / (mx + my);
}

std::vector<DiscModel> disc_models(const Patch& patch) {
  const Comparison comparison(patch);
  std::vector<DiscModel> models{best_disc(comparison)};
  const Patch::RoundMeasures measures = patch.round_measures();
  const double equal_area = std::sqrt(measures.area / std::numbers::pi);
  if (equal_area > 0.0) models.push_back(disc_model(comparison, "disc-equal-area", measures.law, equal_area));
  models.push_back({"ellipsoid", patch.moment_ratio(), comparison.error(ellipsoid(patch))});
  return models;
}

std::vector<EngineShape> engine_shapes(const Patch& patch) {
  const Comparison comparison(patch);
  return {comparison.shape("ellipse",
                           [](double slide, double spin) -> UnitWrench {
                             const double power = std::hypot(slide, spin);
                             return {slide / power, spin / power};
                           }),
          comparison.shape("diamond",
                           [](double slide, double spin) {
                             return slide > spin ? UnitWrench{1.0, 0.0} : UnitWrench{0.0, 1.0};
                           }),
          comparison.shape("box",
                           [](double slide, double spin) {
                             return UnitWrench{slide > 0.0 ? 1.0 : 0.0, spin > 0.0 ? 1.0 : 0.0};
                           }),
          comparison.shape("point", [](double slide, double) {
            return UnitWrench{slide > 0.0 ? 1.0 : 0.0, 0.0};
          })};
}

std::vector<Candidate> choose(const Patch& patch, double tolerance) {
  if (!(tolerance >= 1e-10 && tolerance <= 1.0))
    throw out_of_range("tolerance", tolerance, "1", "1e-10 <= tolerance <= 1");
  const Comparison comparison(patch);
  const DiscModel round = best_disc(comparison);
  std::vector<Candidate> candidates{
      {round.name, round.parameter, round.error.max_error, shipped_costs::of("table").wrench},
      {"ellipsoid", patch.moment_ratio(), comparison.error(ellipsoid(patch)).max_error,
       shipped_costs::of("ellipse").wrench},
      {"patch", std::numeric_limits<double>::quiet_NaN(), 0.0, patch.nanoseconds()}};
  choose_cheapest(candidates, tolerance);
  return candidates;
}

}  // namespace limitcurve
