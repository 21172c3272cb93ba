// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/table_reader.hpp"

namespace limitcurve::cli {

namespace {

class Lookup final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"lookup", "Evaluate a table that 'limitcurve table' wrote",
            "Columns: c in contact radii, force in units of mu P, and moment in units of mu P a. A table that was cut "
            "off or edited\nis rejected.",
            "limitcurve lookup --table hertz.csv --c 0,0.5,1,inf"};
  }

  void declare(Options& options) override {
    options.text("--table", file_, "FILE", "Table, .csv or .json", Presence::required);
    options.numbers("--c", distances_, signed_distance,
                    "Distances from the contact centre to the centre of rotation, in contact radii");
  }

  void run(const Results& results) override {
    const limitcurve::Table table = read_table(file_);
    Rows rows(results, {"c", "force", "moment"});
    for (const double c : distances_) {
      const UnitWrench wrench = table.wrench(SlipTwist::about_cor(c));
      rows.row(c, wrench.force, wrench.moment);
    }
    rows.finish();
  }

 private:
  std::string file_;
  std::vector<double> distances_;
};

}  // namespace

std::unique_ptr<Subcommand> make_lookup() {
  return std::make_unique<Lookup>();
}

}  // namespace limitcurve::cli
