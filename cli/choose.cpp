// SPDX-License-Identifier: MIT
#include "limitcurve/choose.hpp"

#include "cli/subcommands.hpp"

namespace limitcurve::cli {

namespace {

class Choose final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"choose", "The cheapest limit boundary that is good enough, with those it beat",
            "Columns: model and parameter as in validate (table: its tolerance; exact: nan); error, the largest radial error in the\n"
            "normalised plane; nanoseconds of a wrench by its slip twist, on one machine: read them as ratios; chosen, true for\n"
            "the cheapest whose error is at most the tolerance.",
            "limitcurve choose --law hertz --tolerance 1e-3"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.number("--tolerance", tolerance_, positive, "Largest radial error, relative (0.01 is 1 %), from 1e-10 to 1",
                   Presence::required);
  }

  void run(const Results& results) override {
    const std::vector<Candidate> candidates = choose(law_, tolerance_);
    Rows rows(results, {"model", "parameter", "error", "nanoseconds", "chosen"});
    for (const Candidate& candidate : candidates) {
      rows.row(candidate.model, candidate.parameter, candidate.error, candidate.nanoseconds, candidate.chosen);
    }
    rows.finish();
  }

 private:
  Law law_;
  double tolerance_ = 0.0;
};

}  // namespace

std::unique_ptr<Subcommand> make_choose() {
  return std::make_unique<Choose>();
}

}  // namespace limitcurve::cli
