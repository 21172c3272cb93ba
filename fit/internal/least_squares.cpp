// SPDX-License-Identifier: MIT
#include "fit/internal/least_squares.hpp"

#include "limitcurve/internal/interruption.hpp"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

namespace limitcurve::fit::internal {

namespace {

/// What `let_interrupt` threw. It does not pass through Ceres, where every later residual is 0, which ends the
/// iteration.
class Interruption {
 public:
  [[nodiscard]] bool has_come() noexcept {
    try {
      if (thrown_ == nullptr) let_interrupt();
    } catch (...) {
      thrown_ = std::current_exception();
    }
    return thrown_ != nullptr;
  }
  void rethrow() const {
    if (thrown_ != nullptr) std::rethrow_exception(thrown_);
  }

 private:
  std::exception_ptr thrown_;
};

/// One sample's residual for Ceres. The model and the interruption outlive the problem.
class SampleCost final : public ceres::CostFunction {
 public:
  SampleCost(const ResidualModel& model, std::size_t sample, std::span<const Parameter> parameters,
             Interruption& interruption)
      : model_(model), sample_(sample), parameters_(parameters), interruption_(interruption) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters.size()));
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    double* const gradient = jacobians != nullptr ? jacobians[0] : nullptr;
    if (interruption_.has_come()) {
      residuals[0] = 0.0;
      if (gradient != nullptr) std::fill_n(gradient, parameters_.size(), 0.0);
      return true;
    }
    if (!model_.evaluate(sample_, {blocks[0], parameters_.size()}, residuals[0], gradient)) return false;
    for (std::size_t j = 0; gradient != nullptr && j < parameters_.size(); ++j) {
      if (parameters_[j].is_held()) gradient[j] = 0.0;
    }
    return std::isfinite(residuals[0]);
  }

 private:
  const ResidualModel& model_;
  std::size_t sample_;
  std::span<const Parameter> parameters_;
  Interruption& interruption_;
};

std::unique_ptr<ceres::LossFunction> make_loss(const Loss& loss) {
  switch (loss.kind) {
    case Loss::Kind::huber:
      return std::make_unique<ceres::HuberLoss>(loss.scale);
    case Loss::Kind::cauchy:
      return std::make_unique<ceres::CauchyLoss>(loss.scale);
    case Loss::Kind::squared:
    case Loss::Kind::edge:  // no loss of residuals
      break;
  }
  return nullptr;
}

/// ψ(r) = ½ dρ(r²)/dr and ψ′(r).
struct Influence {
  double value;
  double slope;
};
Influence influence(const Loss& loss, double residual) {
  const double scaled = residual / loss.scale;
  switch (loss.kind) {
    case Loss::Kind::huber:
      return std::abs(scaled) <= 1.0 ? Influence{residual, 1.0} : Influence{std::copysign(loss.scale, residual), 0.0};
    case Loss::Kind::cauchy: {
      const double weight = 1.0 / (1.0 + scaled * scaled);
      return {residual * weight, (1.0 - scaled * scaled) * weight * weight};
    }
    case Loss::Kind::squared:
    case Loss::Kind::edge:  // no loss of residuals
      break;
  }
  return {residual, 1.0};
}

/// Ceres logs through glog, which prints to standard error by default; a library must not do that.
ceres::Solver::Options quiet_options(double tolerance) {
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  options.minimizer_progress_to_stdout = false;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  // At the minimum of exact data rounding makes steps invalid. Ceres would report several in a row on standard error.
  options.max_num_consecutive_invalid_steps = 1000;
  // The defaults (1e-6, 1e-10, 1e-8) are too coarse for noise-free data.
  options.function_tolerance = tolerance;
  options.gradient_tolerance = 1e-18;
  options.parameter_tolerance = 1e-14;
  options.num_threads = 1;
  return options;
}

/// Why the minimiser stopped: the first sentence of its message. The numbers in the others depend on the locale.
std::string reason_of(const ceres::Solver::Summary& summary) {
  return summary.message.substr(0, summary.message.find(". "));
}

/// One run of Ceres from `solution.values`, within the bounds.
void descend(const ResidualModel& model, std::span<const Parameter> parameters, const Loss& loss, double tolerance,
             Solution& solution) {
  const std::size_t free = parameters.size();
  double* const block = solution.values.data();
  const std::unique_ptr<ceres::LossFunction> loss_function = make_loss(loss);
  Interruption interruption;
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  problem.AddParameterBlock(block, static_cast<int>(free));
  for (std::size_t i = 0; i < model.count(); ++i) {
    let_interrupt();
    // The problem owns the cost functions.
    problem.AddResidualBlock(new SampleCost(model, i, parameters, interruption), loss_function.get(), block);
  }
  for (std::size_t j = 0; j < free; ++j) {
    const int index = static_cast<int>(j);
    if (parameters[j].is_held()) continue;
    if (std::isfinite(parameters[j].low)) problem.SetParameterLowerBound(block, index, parameters[j].low);
    if (std::isfinite(parameters[j].high)) problem.SetParameterUpperBound(block, index, parameters[j].high);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(quiet_options(tolerance), &problem, &summary);
  interruption.rethrow();
  if (summary.termination_type == ceres::FAILURE && summary.num_successful_steps <= 0 && solution.iterations == 0) {
    throw std::invalid_argument("the fit cannot start: " + reason_of(summary));
  }
  solution.converged = summary.termination_type == ceres::CONVERGENCE;
  solution.iterations += static_cast<int>(summary.iterations.size());
  solution.message = reason_of(summary);
  solution.cost = summary.final_cost;
  solution.residuals.resize(model.count());
  solution.jacobian.resize(model.count() * free);
  for (std::size_t i = 0; i < model.count(); ++i) {
    let_interrupt();
    if (!model.evaluate(i, solution.values, solution.residuals[i], solution.jacobian.data() + i * free))
      solution.converged = false;
  }
}

/// How the cost depends on one parameter: dcost/dx, and what a Gauss–Newton step in it alone would gain.
struct Descent {
  double slope = 0.0;
  double gain = 0.0;
};
Descent descent_of(const Solution& solution, std::size_t parameter, const Loss& loss) {
  const std::size_t free = solution.values.size();
  Descent descent;
  double curvature = 0.0;
  for (std::size_t i = 0; i < solution.residuals.size(); ++i) {
    const double residual = solution.residuals[i];
    const double gradient = solution.jacobian[i * free + parameter];
    const double pull = influence(loss, residual).value;
    descent.slope += pull * gradient;
    curvature += (residual == 0.0 ? 1.0 : pull / residual) * gradient * gradient;
  }
  if (curvature > 0.0) descent.gain = descent.slope * descent.slope / (2 * curvature);
  return descent;
}

/// The variance of a residual that gives the same covariance by least squares (Huber 1981, Robust Statistics,
/// eq. 7.6.5): K² [Σψ²/(n − p)] / mean(ψ′)², K = 1 + (p/n) var(ψ′)/mean(ψ′)². It is one number for all rows: a sandwich
/// of each row's own ψ² is 0 for a row that alone determines a parameter, because that row has no residual.
double pooled_variance(const Solution& solution, const Loss& loss) {
  const auto count = static_cast<double>(solution.residuals.size());
  const auto free = static_cast<double>(solution.values.size());
  double filling = 0.0;
  double slope = 0.0;
  double slope_square = 0.0;
  for (const double residual : solution.residuals) {
    const Influence pull = influence(loss, residual);
    filling += pull.value * pull.value;
    slope += pull.slope / count;
    slope_square += pull.slope * pull.slope / count;
  }
  if (!(slope > 0.0)) return std::numeric_limits<double>::infinity();
  const double few = 1.0 + free / count * (slope_square / (slope * slope) - 1.0);
  return few * few * filling / std::max(1.0, count - free) / (slope * slope);
}

}  // namespace

Solution minimise(const ResidualModel& model, std::span<const Parameter> parameters, const Loss& loss,
                  double tolerance) {
  Solution solution;
  for (const Parameter& parameter : parameters) {
    solution.values.push_back(std::clamp(parameter.start, parameter.low, parameter.high));
  }
  descend(model, parameters, loss, tolerance, solution);
  // On a bound Ceres (2.1) may stop early: it cuts its step there, and takes the small change of the cost for
  // convergence. Where parameters that can still move would gain, those that the cost presses against their bounds are
  // held, and the others are solved for again.
  for (std::size_t round = 0; round <= parameters.size(); ++round) {
    std::vector<Parameter> held(parameters.begin(), parameters.end());
    bool is_on_bound = false;
    double gain = 0.0;
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      Parameter& parameter = held[j];
      if (parameter.is_held()) continue;
      const double value = solution.values[j];
      const Descent descent = descent_of(solution, j, loss);
      if ((value <= parameter.low && descent.slope > 0.0) || (value >= parameter.high && descent.slope < 0.0)) {
        parameter.low = parameter.high = value;
        is_on_bound = true;
      } else {
        gain = std::fmax(gain, descent.gain);
      }
    }
    // A first pass (a coarse tolerance) is not asked for more than it promises.
    const bool is_least = !is_on_bound || tolerance >= coarse_tolerance || !(gain > 1e3 * tolerance * solution.cost);
    if (is_least) return solution;
    if (round == parameters.size()) break;
    descend(model, held, loss, tolerance, solution);
  }
  solution.converged = false;
  return solution;
}

double cost_of(const Solution& solution, const Loss& loss) {
  const std::unique_ptr<ceres::LossFunction> function = make_loss(loss);
  double cost = 0.0;
  for (const double residual : solution.residuals) {
    std::array<double, 3> rho{residual * residual, 1.0, 0.0};
    if (function) function->Evaluate(residual * residual, rho.data());
    cost += 0.5 * rho[0];
  }
  return cost;
}

std::vector<double> covariance(const Solution& solution, std::span<const Parameter> parameters, const Loss& loss,
                               double variance) {
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto free = static_cast<Eigen::Index>(parameters.size());
  const auto count = static_cast<Eigen::Index>(solution.residuals.size());
  const Eigen::Map<const RowMatrix> jacobian(solution.jacobian.data(), count, free);

  // The test of identifiability uses columns of unit length, so that units do not matter.
  Eigen::VectorXd length = jacobian.colwise().norm();
  constexpr double rank_threshold = 1e-9;
  const double longest = length.maxCoeff();
  std::string names;
  for (Eigen::Index j = 0; j < free; ++j) {
    // No residual depends on it, except by rounding (parameters are logarithms or of order one).
    if (!(length[j] > rank_threshold * longest))
      names += (names.empty() ? "" : ", ") + parameters[static_cast<std::size_t>(j)].name;
  }
  if (!names.empty()) throw std::invalid_argument("not identifiable from these samples: " + names);
  const Eigen::MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinV);
  const double largest = svd.singularValues()[0];
  const bool too_few = count < free;
  if (too_few || !(svd.singularValues()[free - 1] > rank_threshold * largest)) {
    for (Eigen::Index j = 0; j < free; ++j) {
      // The direction without effect on the cost: its large components are the undetermined parameters.
      if (too_few || std::abs(svd.matrixV()(j, free - 1)) > 0.1)
        names += (names.empty() ? "" : ", ") + parameters[static_cast<std::size_t>(j)].name;
    }
    throw std::invalid_argument("not identifiable from these samples: " + names);
  }

  if (loss.kind != Loss::Kind::squared) variance = std::max(variance, pooled_variance(solution, loss));
  RowMatrix result = variance * svd.matrixV() * svd.singularValues().array().square().inverse().matrix().asDiagonal() *
                     svd.matrixV().transpose();
  result = (length.cwiseInverse().asDiagonal() * result * length.cwiseInverse().asDiagonal()).eval();
  return {result.data(), result.data() + result.size()};
}

}  // namespace limitcurve::fit::internal
