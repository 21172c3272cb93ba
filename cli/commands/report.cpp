// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/report/drawing.hpp"
#include "cli/report/report_files.hpp"
#include "cli/report/share.hpp"

#include <stdexcept>
#include <system_error>

namespace limitcurve::cli {

namespace {

class Report final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"report", "Writes a page with charts of all this for the laws and materials in data/",
            "Writes index.html, a self-contained page, the figures (SVG, PNG), and the CSV files of the figures.\n"
            "Drawing needs python3 with matplotlib. The environment variable LIMITCURVE_SHARE may name the folder with scripts/ and data/.",
            "limitcurve report -o out"};
  }

  void declare(Options& options) override {
    options.text("-o,--output", directory_, "DIR", "Output folder; created if it does not exist", Presence::required);
  }

  void run(const Results&) override {
    const std::filesystem::path share = find_share();
    const std::filesystem::path data = share / "data";
    const std::filesystem::path directory = directory_;
    std::error_code refused;
    std::filesystem::create_directories(directory, refused);
    if (refused) throw std::runtime_error("cannot make the folder '" + directory_ + "': " + refused.message());
    write_curve_files(directory);
    write_error_files(directory);
    write_table_files(directory, data);
    write_replay_files(directory, data);
    write_steady_twist_file(directory);
    write_fit_files(directory, data);
    write_patch_files(directory, data);
    write_pivot_files(directory, data);
    write_translate_file(directory);
    write_work_precision_files(directory, data);
    draw_report(share / "scripts" / "figures" / "report.py", directory);
  }

 private:
  std::string directory_;
};

}  // namespace

std::unique_ptr<Subcommand> make_report() {
  return std::make_unique<Report>();
}

}  // namespace limitcurve::cli
