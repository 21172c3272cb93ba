// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/report/drawing.hpp"
#include "cli/report/report_files.hpp"
#include "cli/report/share.hpp"

#include <functional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

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

  void run(const Results& results) override {
    const std::filesystem::path share_directory = find_share();
    const std::filesystem::path data = share_directory / "data";
    const std::filesystem::path directory = directory_;
    std::error_code refused;
    std::filesystem::create_directories(directory, refused);
    if (refused) throw std::runtime_error("cannot make the folder '" + directory_ + "': " + refused.message());
    // What each takes of the time, as measured; drawing takes the rest.
    const std::vector<std::pair<double, std::function<void()>>> parts{
        {0.01, [&] { write_curve_files(directory); }},       {0.08, [&] { write_error_files(directory); }},
        {0.01, [&] { write_table_files(directory, data); }}, {0.0, [&] { write_replay_files(directory, data); }},
        {0.0, [&] { write_steady_twist_file(directory); }},  {0.0, [&] { write_fit_files(directory, data); }},
        {0.24, [&] { write_patch_files(directory, data); }}, {0.09, [&] { write_pivot_files(directory, data); }},
        {0.0, [&] { write_translate_file(directory); }},     {0.0, [&] { write_work_precision_files(directory, data); }}};
    double done = 0.0;
    for (const auto& [share, write] : parts) {
      write();
      results.messages->progress(done += share);
    }
    results.output.write(draw_report(share_directory / "scripts" / "figures" / "report.py", directory, *results.messages, done));
    results.output.flush();
  }

 private:
  std::string directory_;
};

}  // namespace

std::unique_ptr<Subcommand> make_report() {
  return std::make_unique<Report>();
}

}  // namespace limitcurve::cli
