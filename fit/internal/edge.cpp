// SPDX-License-Identifier: MIT
#include "fit/internal/edge.hpp"

#include "fit/internal/contact_assumptions.hpp"
#include "fit/internal/contact_preparation.hpp"
#include "fit/internal/edge_model.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::fit::internal {

namespace {

constexpr std::array<double, 3> floors{0.003, 0.01, 0.005};
constexpr double most_outside = 0.03;

using Vector = Eigen::VectorXd;
using Objective = std::function<double(const Vector&)>;

/// A bounded parameter as a free one, and back.
double freed(double value, const std::array<double, 2>& bounds) {
  const double share = std::clamp((value - bounds[0]) / (bounds[1] - bounds[0]), 1e-4, 1.0 - 1e-4);
  return std::log(share / (1.0 - share));
}
double bound(double free, const std::array<double, 2>& bounds) {
  return bounds[0] + (bounds[1] - bounds[0]) / (1.0 + std::exp(-free));
}

Vector gradient_of(const Objective& cost, const Vector& v) {
  constexpr double step = 1e-5;
  Vector gradient(v.size());
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const Vector off = Vector::Unit(v.size(), i) * step;
    gradient[i] = (cost(v + off) - cost(v - off)) / (2.0 * step);
  }
  return gradient;
}

/// The nearest minimum of a smooth function, by BFGS with steps that halve until they descend.
Vector descend(const Objective& cost, Vector v, double scale) {
  constexpr int most_steps = 100;
  constexpr double longest = 0.5;
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(v.size(), v.size()) / scale;
  double value = cost(v);
  Vector gradient = gradient_of(cost, v);
  for (int step = 0; step < most_steps; ++step) {
    Vector move = -inverse * gradient;
    if (!(move.dot(gradient) < 0.0)) {
      inverse.setIdentity(v.size(), v.size());
      inverse /= scale;
      move = -inverse * gradient;
    }
    if (move.lpNorm<Eigen::Infinity>() > longest) move *= longest / move.lpNorm<Eigen::Infinity>();
    double next = cost(v + move);
    for (int half = 0; half < 30 && !(next <= value + 1e-4 * move.dot(gradient)); ++half) {
      move *= 0.5;
      next = cost(v + move);
    }
    if (!(next < value)) break;
    const bool is_done = value - next < 1e-9 * scale;
    v += move;
    value = next;
    if (is_done) break;
    const Vector before = gradient;
    gradient = gradient_of(cost, v);
    const Vector change = gradient - before;
    const double product = move.dot(change);
    if (!(product > 0.0)) continue;
    const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(v.size(), v.size()) - move * change.transpose() / product;
    inverse = (left * inverse * left.transpose() + move * move.transpose() / product).eval();
  }
  return v;
}

/// Limits with this share of the rows inside: the least pinball loss of log s, rounded within 1 %.
Vector envelope(const EdgeModel& model, std::span<const EdgeRow> rows, double share) {
  std::vector<double> forces;
  std::vector<double> moments;
  for (const EdgeRow& row : rows) {
    forces.push_back(row.force);
    moments.push_back(row.moment);
  }
  const auto high = [](std::vector<double>& values) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return std::log(std::max(*place, 1e-12));
  };
  Vector start = Vector::Zero(model.size());
  start[0] = high(forces);
  start[1] = high(moments);
  if (model.limits() == 3) start[2] = 0.1;
  start[model.limits() + 1] = 0.1;
  const auto whole = [&](const Vector& limits) {
    Vector v = start;
    v.head(model.limits()) = limits;
    return v;
  };
  const Objective loss = [&](const Vector& limits) {
    constexpr double width = 0.01;
    const Vector v = whole(limits);
    double sum = 0.0;
    for (const EdgeRow& row : rows) {
      const double e = std::log(std::max(model.place(row, v).size, 1e-6)) / width;
      sum += width * ((share - 1.0) * e + (e > 30.0 ? e : std::log1p(std::exp(e))));
    }
    return sum;
  };
  Vector v = whole(descend(loss, start.head(model.limits()), static_cast<double>(rows.size())));
  if (model.limits() == 3) v[2] = std::clamp(v[2], model.bounds(2)[0], model.bounds(2)[1]);
  return v;
}

/// A maximum of the likelihood; the best of several starts, those with few rows outside first.
struct Edge {
  Vector v;
  double cost = std::numeric_limits<double>::infinity();
  double outside = 1.0;
};
Edge find_edge(const EdgeModel& model, std::span<const EdgeRow> rows, const std::optional<Vector>& near) {
  std::vector<Vector> starts;
  for (const double share : {0.75, 0.93, 0.98}) starts.push_back(envelope(model, rows, share));
  if (near) starts.push_back(*near);
  Edge best;
  for (Vector start : starts) {
    const auto to_bounded = [&](Vector v) {
      for (Eigen::Index i = 2; i < v.size(); ++i) v[i] = bound(v[i], model.bounds(i));
      return v;
    };
    for (Eigen::Index i = 2; i < start.size(); ++i) start[i] = freed(start[i], model.bounds(i));
    const Objective cost = [&](const Vector& v) { return model.cost(rows, to_bounded(v)); };
    Edge edge{to_bounded(descend(cost, start, static_cast<double>(rows.size())))};
    edge.cost = model.cost(rows, edge.v);
    edge.outside = model.outside(rows, edge.v);
    const bool is_beyond = edge.outside > most_outside;
    const bool best_is_beyond = best.outside > most_outside;
    if (is_beyond != best_is_beyond ? !is_beyond : edge.cost < best.cost) best = edge;
  }
  return best;
}

/// The sandwich of whole grips; p and k at their bounds are held.
Eigen::MatrixXd covariance_by_grip(const EdgeModel& model, std::span<const EdgeRow> rows, const Vector& v) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const auto [low, high] = model.bounds(i);
    if (i < model.limits() || std::min(v[i] - low, high - v[i]) > 1e-3 * (high - low)) free.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  const auto moved = [&](Eigen::Index i, double step) -> Vector {
    return v + Vector::Unit(v.size(), free[static_cast<std::size_t>(i)]) * step;
  };
  std::map<std::size_t, Vector> scores;
  for (const EdgeRow& row : rows) scores.try_emplace(row.grip, Vector::Zero(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    constexpr double step = 1e-4;
    const Vector up = moved(i, step);
    const Vector down = moved(i, -step);
    for (const EdgeRow& row : rows) {
      const double change =
          model.chance(model.place(row, up), up).cost - model.chance(model.place(row, down), down).cost;
      scores[row.grip][i] += change / (2.0 * step);
    }
  }
  Eigen::MatrixXd filling = Eigen::MatrixXd::Zero(count, count);
  for (const auto& [grip, score] : scores) filling += score * score.transpose();
  Eigen::MatrixXd bread(count, count);
  constexpr double step = 2e-3;
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const auto at = [&](double a, double b) { return model.cost(rows, moved(i, a * step) + moved(j, b * step) - v); };
      bread(i, j) = bread(j, i) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * step * step);
    }
  }
  const Eigen::MatrixXd inverse = bread.completeOrthogonalDecomposition().pseudoInverse();
  const auto grips = static_cast<double>(scores.size());
  const double few = grips / std::max(1.0, grips - static_cast<double>(model.limits()));
  const Eigen::MatrixXd small = few * inverse * filling * inverse;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(v.size(), v.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j)
      result(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]) = small(i, j);
  }
  return result;
}

/// NaN of less than two numbers.
double variance_of(const std::vector<double>& numbers) {
  if (numbers.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Map<const Eigen::ArrayXd> all(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  return (all - all.mean()).square().sum() / (static_cast<double>(numbers.size()) - 1.0);
}

/// Which grips reach the limit, and which way.
struct Reached {
  std::size_t grips = 0;
  std::size_t at_limit = 0;
  std::array<std::size_t, 3> ways{};     ///< slides, twists, both; a grip may slip one way after the other
  std::array<std::size_t, 2> telling{};  ///< that slide or do both, twist or do both
  /// Of slides below the limit and at it, in order, relative to the reference load; and the largest wrench below.
  std::array<std::vector<double>, 2> loads;
  double below = 0.0;
  /// Means of ten slips of a grip, of all if it has fewer: of the angle, and of the load if they tell the moment's
  /// limit.
  std::vector<double> angles;
  std::vector<double> log_loads;
};
Reached reached(const EdgeModel& model, std::span<const EdgeRow> rows, const Vector& v) {
  struct Grip {
    std::array<std::size_t, 3> ways{};
    int telling = 0;  ///< rows with little noise less the others
    double size = 0.0;
    double load = 0.0;
    bool slides = false;
    bool is_told = false;
    double slips = 0.0;
    double angles = 0.0;
    double log_loads = 0.0;
  };
  std::map<std::size_t, Grip> by_grip;
  Reached all;
  const auto tell = [&](Grip& grip) {
    const double angle = grip.angles / grip.slips;
    all.angles.push_back(angle);
    if (angle > std::numbers::pi / 6) all.log_loads.push_back(grip.log_loads / grip.slips);
    grip.slips = grip.angles = grip.log_loads = 0.0;
    grip.is_told = true;
  };
  for (const EdgeRow& row : rows) {
    Grip& grip = by_grip[row.grip];
    const EdgePlace at = model.place(row, v);
    const bool is_slip = model.chance(at, v).at_limit > 0.5;
    // With more noise the angle says nothing.
    if (is_slip && at.sigma < 0.3) {
      grip.angles += at.angle;
      grip.log_loads += row.log_load;
      if (++grip.slips == 10.0) tell(grip);
    }
    // Noise alone reaches the limit under a small load.
    const bool is_noisy = at.sigma > 0.1;
    grip.telling += is_noisy ? -1 : 1;
    if (is_noisy) continue;
    if (at.size > grip.size) {
      grip.load = std::exp(row.log_load);
      grip.slides = at.angle < std::numbers::pi / 4;
    }
    grip.size = std::max(grip.size, at.size);
    if (is_slip) ++grip.ways.at(at.angle < std::numbers::pi / 6 ? 0 : at.angle > std::numbers::pi / 3 ? 1 : 2);
  }
  all.grips = by_grip.size();
  for (auto& [number, grip] : by_grip) {
    if (grip.slips > 2.0 && !grip.is_told) tell(grip);
    const std::array<bool, 3> ways{grip.ways[0] > 2, grip.ways[1] > 2, grip.ways[2] > 2};
    for (std::size_t i = 0; i < 3; ++i) all.ways.at(i) += ways.at(i) ? 1 : 0;
    for (std::size_t i = 0; i < 2; ++i) all.telling.at(i) += ways.at(i) || ways[2] ? 1 : 0;
    const bool reaches = ways[0] || ways[1] || ways[2];
    all.at_limit += reaches ? 1 : 0;
    if (grip.telling < 0 || !grip.slides) continue;
    all.loads.at(reaches ? 1 : 0).push_back(grip.load);
    if (!reaches) all.below = std::max(all.below, grip.size);
  }
  for (std::vector<double>& loads : all.loads) std::ranges::sort(loads);
  return all;
}

/// What an error of 1 % of the load leaves open of gamma: all, if no two loads tell it.
double unknown_gamma(const Reached& at_limit) {
  const double variance = variance_of(at_limit.log_loads);
  return variance > 0.0 ? 0.01 * 0.01 / variance : std::numeric_limits<double>::infinity();
}

void require(bool good, const char* expected) {
  if (!good) throw std::invalid_argument(std::string("loss edge: ") + expected);
}

}  // namespace

ContactFit fit_edge(std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options) {
  constexpr std::size_t most_rows = 6000;
  require(model.kind == ContactModel::Kind::law, "only for the curve of a law");
  const ContactPreparation preparation = prepare(samples, options);
  require(preparation.with_sigma, "needs standard deviations: --zero, or columns sigma_force and sigma_moment");
  const std::unique_ptr<UnitCurve> curve = make_curve(model);
  const GaugeTable gauge(*curve);
  const EdgeModel edge_model(gauge, options.fit_gamma, options.gamma);
  std::set<std::size_t> grips;
  for (const Sample& sample : samples) grips.insert(sample.grip);
  require(!grips.contains(0), "needs to know which rows are one grip: --least-load, or a column grip");
  require(grips.size() >= 4, "expected at least 4 grips");
  std::vector<EdgeRow> all;
  for (const Sample& sample : samples) {
    all.push_back({std::fabs(sample.force) / sample.load, std::fabs(sample.moment) / sample.load,
                   sample.sigma_force / sample.load, sample.sigma_moment / sample.load,
                   std::log(sample.load / preparation.reference_load), sample.grip});
  }
  // In turn A B B A B A A B …, which no periodic order of slides, twists and holds follows.
  std::map<std::size_t, std::size_t> half_of;
  for (const std::size_t grip : grips) half_of.emplace(grip, std::popcount(half_of.size()) % 2);
  const std::size_t stride = std::max<std::size_t>(1, all.size() / most_rows);
  std::vector<EdgeRow> rows;
  std::array<std::vector<EdgeRow>, 2> halves;
  for (std::size_t i = 0; i < all.size(); i += stride) {
    rows.push_back(all[i]);
    halves.at(half_of.at(all[i].grip)).push_back(all[i]);
  }

  const Edge edge = find_edge(edge_model, rows, std::nullopt);
  if (edge.outside > most_outside) {
    throw std::invalid_argument(format_number(std::ceil(1e4 * edge.outside) / 100.0) +
                                " % of the rows lie outside any edge, expected at most 3 %: no slips, a wrong zero or "
                                "normal, a coefficient that changed" +
                                (options.fit_gamma ? "" : ", or another gamma (--fit-gamma)"));
  }
  const Eigen::MatrixXd spread = covariance_by_grip(edge_model, rows, edge.v);
  const Vector difference = find_edge(edge_model, halves[0], edge.v).v - find_edge(edge_model, halves[1], edge.v).v;
  const ContactLayout layout{false, options.fit_gamma, options.gamma};
  const std::size_t free = layout.size();
  std::vector<double> values(free);
  std::vector<double> covariance(free * free);
  for (std::size_t i = 0; i < free; ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    values[i] = edge.v[a];
    for (std::size_t j = 0; j < free; ++j) covariance[i * free + j] = spread(a, static_cast<Eigen::Index>(j));
    covariance[i * free + i] += std::pow(0.5 * difference[a], 2) + std::pow(floors.at(i), 2);
  }
  const Reached at_limit = reached(edge_model, all, edge.v);
  if (variance_of(at_limit.angles) < 0.1 * 0.1) {
    throw std::invalid_argument(
        "not identifiable from these samples: mu, mu_r: the slips turn about one centre of rotation and give one point "
        "of the curve, moment/force = " +
        format_number(std::tan(at_limit.angles.front()) * std::exp(values[1] - values[0]), 3) +
        " m: add slips about others");
  }
  const auto [low, high] = gamma_range;
  const Parameter gamma{"gamma", 0.0, low, high};
  if (options.fit_gamma) {
    const double unknown = unknown_gamma(at_limit);
    require(unknown < 0.5, "only twists tell gamma: add some under other loads");
    covariance.back() += unknown * unknown;
    refuse_hidden(gamma, covariance.back());
  }

  ContactFit fit{model.name(), {}, {}, {}, {}};
  FitReport& report = fit.report;
  const double factor = std::exp(edge.v[edge_model.limits() + 1]);
  const double share = 1.0 / (1.0 + std::exp(-edge.v[edge_model.limits()]));
  for (const EdgeRow& row : all) {
    const EdgePlace at = edge_model.place(row, edge.v);
    fit.residuals.push_back((at.size - 1.0) / std::hypot(at.sigma * factor, smallest_sigma));
  }
  report.residuals = all.size();
  report.free_parameters = static_cast<std::size_t>(edge_model.size());
  report.rms = factor;
  // The rows of one grip say what one row says.
  report.aic = 2.0 * edge.cost * static_cast<double>(grips.size()) / static_cast<double>(rows.size()) +
               2.0 * static_cast<double>(edge_model.size());
  report.converged = true;
  report.message = "maximum likelihood";
  report_limits(fit, *curve, layout, model, values, covariance, preparation.reference_load, options.largest_radius);
  const auto& [slides, twists, both] = at_limit.ways;
  report.note = note_of(fit.model, options, all.size(), true) + "; " + std::to_string(at_limit.at_limit) + " of " +
                std::to_string(at_limit.grips) + " grips reach the limit: " + std::to_string(slides) + " slides, " +
                std::to_string(twists) + " twists, " + std::to_string(both) + " both";
  if (factor > 1.8) {
    report.scatter_refused = true;
    report.warnings.emplace_back(
        "the edge is blurred: a wrong zero or normal of the sensor, a coefficient that changed, or no slips; mu may be "
        "too high");
  } else if (share < 0.03) {
    report.warnings.emplace_back(
        "no sharp edge: the finger did not slip, or not in these rows; a limit is what the wrench reached");
  }
  const std::array<double, 2> most_difference{0.05, 0.15};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string& name = report.estimates[i].name;
    require(covariance[i * free + i] < 0.5 * 0.5, i == 0 ? "mu has a standard error above 50 %: add slides"
                                                         : "mu_r has a standard error above 50 %: add twists");
    const double apart = std::fabs(difference[static_cast<Eigen::Index>(i)]);
    if (apart > most_difference.at(i)) {
      report.warnings.push_back(name + ": two halves of the grips differ by " + format_number(100.0 * apart, 2) +
                                " %: few of them slipped that way");
    }
    if (at_limit.ways.at(i) == 0 || at_limit.telling.at(i) < 2) {
      report.warnings.push_back(name + ": no grip of those that reach the limit is a " + (i == 0 ? "slide" : "twist") +
                                ", so this limit is extrapolated along the curve, and may be far off: add some");
    }
  }
  const auto& [below, at_it] = at_limit.loads;
  const bool many = std::min(below.size(), at_it.size()) >= 5;
  const bool falls = many && at_it.back() < below.front();
  const bool grows = many && below.back() < at_it.front();
  if (falls || grows) {
    const auto range = [&](const std::vector<double>& loads) {
      return format_number(loads.front() * preparation.reference_load, 3) + " to " +
             format_number(loads.back() * preparation.reference_load, 3) + " N";
    };
    report.warnings.push_back("mu: the slides of " + range(at_it) + " reach the limit, those of " + range(below) +
                              " at most " + format_number(100.0 * at_limit.below, 2) +
                              " % of it. If they slipped, too, mu " + (falls ? "falls" : "grows") +
                              " with the load: fit the rows of each load alone");
  }
  if (options.fit_gamma) {
    warn_of_end(report, gamma, values[2]);
  } else if (!falls && !grows) {
    // Holds may feign a small gamma: it counts if it is many standard errors and halves apart.
    constexpr double feigned = 0.02;
    const EdgeModel with_gamma(gauge, true, options.gamma);
    const Vector other = find_edge(with_gamma, rows, std::nullopt).v;
    const double unknown = unknown_gamma(reached(with_gamma, all, other));
    if (!(unknown < 0.5)) return fit;
    const double apart = find_edge(with_gamma, halves[0], other).v[2] - find_edge(with_gamma, halves[1], other).v[2];
    const double error = std::hypot(std::sqrt(covariance_by_grip(with_gamma, rows, other)(2, 2)), 0.5 * apart,
                                    std::hypot(feigned, unknown));
    warn_of_growth(report, options.gamma, {"gamma", other[2], error, "1"}, static_cast<double>(grips.size()) - 3.0,
                   std::numeric_limits<double>::infinity());
  }
  return fit;
}

}  // namespace limitcurve::fit::internal
