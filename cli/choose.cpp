// SPDX-License-Identifier: MIT
#include "cli/lookup_cost.hpp"
#include "cli/subcommands.hpp"

#include "limitcurve/boundary_error.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

struct Candidate {
  std::string model;
  double parameter;
  double error;
  double nanoseconds;
};

class Choose final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"choose", "The cheapest limit boundary that is good enough, with those it beat",
            "Columns: model and parameter as in validate (table: its tolerance; exact: nan); error, the largest radial error in the\n"
            "normalised plane; nanoseconds, what one look-up of the wrench by slip twist took here and now (median); chosen,\n"
            "true for the cheapest whose error is at most the tolerance. Times vary from run to run and machine to machine.",
            "limitcurve choose --law hertz --tolerance 1e-3"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.number("--tolerance", tolerance_, positive, "Largest radial error, relative (0.01 is 1 %)", Presence::required);
  }

  void run(const Results& results) override {
    const std::vector<Candidate> candidates = measure();
    const Candidate* best = nullptr;
    for (const Candidate& candidate : candidates) {
      const bool fits = candidate.error <= tolerance_;
      if (fits && (best == nullptr || candidate.nanoseconds < best->nanoseconds)) best = &candidate;
    }
    if (best == nullptr) {
      throw std::runtime_error("--tolerance: no boundary of law '" + law_->name() + "' is that good, expected at least " +
                               format_number(exact_error));
    }
    Rows rows(results, {"model", "parameter", "error", "nanoseconds", "chosen"});
    for (const Candidate& candidate : candidates) {
      rows.row(candidate.model, candidate.parameter, candidate.error, candidate.nanoseconds, &candidate == best);
    }
    rows.finish();
  }

 private:
  /// What ExactCurve promises.
  static constexpr double exact_error = 1e-14;

  [[nodiscard]] std::vector<Candidate> measure() const {
    const ExactCurve exact(law_);
    const double moment_ratio = exact.moment_ratio();
    std::vector<Candidate> candidates;
    const auto add = [&](std::string model, double parameter, const auto& boundary) {
      candidates.push_back({std::move(model), parameter, boundary_error(boundary, exact).max_error, lookup_cost(boundary)});
    };
    add("box", std::numeric_limits<double>::infinity(), box(1.0, moment_ratio));
    add("diamond", 1.0, diamond(1.0, moment_ratio));
    add("ellipse", 1.0, Ellipse::through_intercepts(moment_ratio));
    const Superellipse superellipse = minimax_superellipse(exact);
    add("superellipse", superellipse.exponent(), superellipse);
    const Quartic quartic = minimax_quartic(exact);
    add("quartic", quartic.kappa(), quartic);
    // An error of f and of m/m0 that together make at most the tolerance in radius.
    const double table_tolerance = std::clamp(0.5 * tolerance_ * std::min(moment_ratio, 1.0), 1e-10, Table::coarsest_tolerance);
    add("table", table_tolerance, Table::build(law_, table_tolerance));
    candidates.push_back({"exact", std::numeric_limits<double>::quiet_NaN(), exact_error, lookup_cost(exact)});
    return candidates;
  }

  Law law_;
  double tolerance_ = 0.0;
};

}  // namespace

std::unique_ptr<Subcommand> make_choose() {
  return std::make_unique<Choose>();
}

}  // namespace limitcurve::cli
