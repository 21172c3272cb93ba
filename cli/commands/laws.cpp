// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"

#include "limitcurve/laws.hpp"

#include <algorithm>

namespace limitcurve::cli {

namespace {

class Laws final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "laws", "List the pressure laws",
        "Columns: law (an example you can pass to --law), moment_ratio (m0 = mu_r/(mu a)), method (the one that 'auto' "
        "selects; closed,\nfor power:n, still needs one smooth integral), and error (a bound on the error of "
        "moment_ratio).\nUnlisted: samples:FILE.csv, a measured profile with the columns radius,pressure.",
        "limitcurve laws"};
  }

  void declare(Options&) override {}

  void run(const Results& results) override {
    Rows rows(results, {"law", "moment_ratio", "method", "error"});
    for (const std::string_view name : law_examples()) {
      const Law law = parse_law(name);
      const WrenchEstimate pure_twist = law->evaluate(0.0);
      rows.row(name, pure_twist.wrench.moment, to_string(law->allows(Method::closed) ? Method::closed : Method::ring),
               pure_twist.error.moment);
    }
    rows.finish();
  }
};

}  // namespace

std::unique_ptr<Subcommand> make_laws() {
  return std::make_unique<Laws>();
}

}  // namespace limitcurve::cli
