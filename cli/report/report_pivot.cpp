// SPDX-License-Identifier: MIT
#include "cli/io/materials.hpp"
#include "cli/report/report_files.hpp"

#include "godobject/scene/pivot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The same block with each material of Table 1, its grip left open.
void write_materials(const std::filesystem::path& output, const std::filesystem::path& data) {
  GatheredRows pivot(output / "pivot_materials.csv");
  for (const Material& material : read_materials(data)) {
    for (const godobject::PivotCase kind : cases) {
      const std::string name(godobject::to_string(kind));
      pivot.add({"pivot", "--case", name, "--material", material.name, "--every", "20"}, {{"material", material.name}, {"case", name}});
    }
  }
  pivot.finish();
  std::filesystem::copy_file(data / "materials.csv", output / "table_1.csv", std::filesystem::copy_options::overwrite_existing);
}

/// By how much the block turns before it has left the fingers, over the twist's stiffness, which the paper does not give.
void write_stiffnesses(const std::filesystem::path& output) {
  AtomicFile file(output / "pivot_stiffness.csv");
  Rows rows({file.output()}, {"case", "ratio", "angle"});
  for (const godobject::PivotCase kind : {godobject::PivotCase::coupled, godobject::PivotCase::exact}) {
    for (int i = -4; i <= 8; ++i) {
      const double ratio = std::pow(10.0, 0.25 * i);
      godobject::PivotOptions options;
      options.kind = kind;
      const double arm = *options.mu_r / options.mu;
      options.twist_stiffness = ratio * options.stiffness * arm * arm;
      godobject::Pivot pivot(options);
      double angle = 0.0;
      while (pivot.row().state != godobject::ContactState::free && pivot.step()) {
        if (pivot.row().state != godobject::ContactState::free) angle = std::max(angle, pivot.row().angle);
      }
      rows.row(godobject::to_string(kind), ratio, angle);
    }
  }
  rows.finish();
  file.commit();
}

/// Two fingers that carry and turn a block, with and without a friction moment.
void write_pinch(const std::filesystem::path& output, const std::filesystem::path& data) {
  GatheredRows pinch(output / "pinch.csv");
  for (const std::string friction : {"soft", "point"}) {
    std::vector<std::string> call{"replay",
                                  "--trace",
                                  (data / "scenes" / "pinch.csv").string(),
                                  "--fingers",
                                  "2",
                                  "--surface",
                                  "box:x=0.12,y=0.04,z=0.04",
                                  "--body",
                                  "free:mass=0.1",
                                  "--damping",
                                  "2",
                                  "--law",
                                  "hertz",
                                  "--radius-law",
                                  "constant:a=0.006",
                                  "--mu",
                                  "0.6",
                                  "--stiffness",
                                  "1000",
                                  "--twist-stiffness",
                                  "0.036"};
    if (friction == "point") call.insert(call.end(), {"--mu-r", "0"});
    pinch.add(call, {{"friction", friction}});
  }
  pinch.finish();
  std::filesystem::copy_file(data / "scenes" / "pinch.csv", output / "pinch_trace.csv", std::filesystem::copy_options::overwrite_existing);
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

void write_pivot_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  write_runs(output);
  write_materials(output, data);
  write_stiffnesses(output);
  write_map(output);
  write_pinch(output, data);
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
