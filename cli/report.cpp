// SPDX-License-Identifier: MIT
#include "cli/report_files.hpp"
#include "cli/share.hpp"
#include "cli/subcommands.hpp"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace limitcurve::cli {

namespace {

// Debian's own: another python3 that is first on the PATH may lack matplotlib.
constexpr const char* python = "/usr/bin/python3";

/// Runs the script that draws; what it prints becomes ours.
void draw(const std::filesystem::path& script, const std::filesystem::path& directory) {
  const std::string tell = "; the CSV files are in '" + directory.string() + "'";
  std::array<std::string, 6> words{python, script.string(), "--data", directory.string(), "--output", directory.string()};
  std::array<char*, 7> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  pid_t child = 0;
  const int refused = ::posix_spawn(&child, python, nullptr, nullptr, arguments.data(), environ);
  if (refused != 0) {
    throw std::runtime_error(std::string("cannot run ") + python + ": " + std::generic_category().message(refused) +
                             "; install python3-matplotlib to draw the report" + tell);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("lost track of " + script.string() + tell);
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("'" + script.string() + "' failed (it needs python3-matplotlib)" + tell);
  }
}

class Report final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"report", "Everything above for the laws and materials in data/, as one page with charts",
            "Writes index.html, self-contained, and beside it the figures (SVG, PNG) and the CSV files they are drawn from.\n"
            "Drawing needs python3 with matplotlib. LIMITCURVE_SHARE may name the folder that holds scripts/ and data/.",
            "limitcurve report -o out"};
  }

  void declare(Options& options) override {
    options.text("-o,--output", directory_, "DIR", "Folder to write into; made if it does not exist", Presence::required);
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
    draw(share / "scripts" / "report.py", directory);
  }

 private:
  std::string directory_;
};

}  // namespace

std::unique_ptr<Subcommand> make_report() {
  return std::make_unique<Report>();
}

}  // namespace limitcurve::cli
