// SPDX-License-Identifier: MIT
#include "cli/report/report_files.hpp"

#include "godobject/pivot.hpp"

#include <array>
#include <string_view>

namespace limitcurve::cli {

namespace {

// The paper's two cases and the exact one.
constexpr std::array cases{godobject::PivotCase::coupled, godobject::PivotCase::uncoupled, godobject::PivotCase::exact};

/// A grip that eases by itself, and an operator who regrips at 30°.
void write_runs(const std::filesystem::path& output) {
  GatheredRows pivot(output / "pivot.csv");
  for (const godobject::PivotCase kind : cases) {
    const std::string name(godobject::to_string(kind));
    const std::vector<std::string> call{"pivot", "--case", name, "--material", "sandpaper", "--every", "10"};
    std::vector<std::string> released = call;
    released.insert(released.end(), {"--release", "from=0.5,to=0.25,over=10"});
    pivot.add(released, {{"case", name}, {"grip", "release"}});
    std::vector<std::string> operated = call;
    operated.insert(operated.end(), {"--operator", "target=30deg"});
    pivot.add(operated, {{"case", name}, {"grip", "operator"}});
  }
  pivot.finish();
}

/// The angle when the block has slid far enough to be lost.
double angle_at_loss(const godobject::PivotOptions& options) {
  constexpr double lost = 0.005;
  godobject::Pivot pivot(options);
  while (pivot.row().grip_slip < lost && pivot.row().state != godobject::ContactState::free && pivot.step()) {
  }
  return pivot.row().angle;
}

void write_map(const std::filesystem::path& output) {
  constexpr double start = 1.0;  // N
  AtomicFile file(output / "pivot_map.csv");
  Rows rows({file.output()}, {"case", "offset", "rate", "angle"});
  for (const godobject::PivotCase kind : cases) {
    for (int i = 1; i <= 10; ++i) {
      for (const double rate : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0}) {
        godobject::PivotOptions options;
        options.kind = kind;
        options.offset = 0.001 * i;
        options.grip = {{0.0, start}, {start / rate, 0.0}};
        options.duration = start / rate + 1.0;
        rows.row(godobject::to_string(kind), options.offset, rate, angle_at_loss(options));
      }
    }
  }
  rows.finish();
  file.commit();
}

}  // namespace

void write_pivot_files(const std::filesystem::path& output) {
  write_runs(output);
  write_map(output);
}

void write_translate_file(const std::filesystem::path& output) {
  constexpr std::string_view radius_law = "power:c=0.00207,gamma=0.259";
  GatheredRows translate(output / "translate.csv");
  for (const std::string law : {"hertz", "uniform"}) {
    translate.add({"translate", "--law", law, "--radius-law", std::string(radius_law), "--mu", "0.6", "--load", "2"},
                  {{"law", law}, {"radius_law", std::string(radius_law)}, {"mu", "0.6"}, {"load", "2"}});
  }
  translate.finish();
}

}  // namespace limitcurve::cli
