// SPDX-License-Identifier: MIT
#include "cli/io/materials.hpp"
#include "cli/report/report_files.hpp"

#include "godobject/scene/pivot.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace limitcurve::cli {

namespace {

// The paper's two cases and the exact one.
constexpr std::array cases{godobject::PivotCase::coupled, godobject::PivotCase::uncoupled, godobject::PivotCase::exact};

/// Dampers as quiet as a hand [N s/m]: on sandpaper the block's turn has a damping ratio of 1, on rayon of 1.2. Measured for digits of young
/// adults: mostly above 1 (J. Park, N. Pazin, J. Friedman, V. M. Zatsiorsky, M. L. Latash, Clinical Biomechanics 29:129-137, 2014).
constexpr double quiet_damping = 86.0;

/// The operator of such a hand: slow enough that the block does not oscillate. The rate is a fraction of the block's default load in a second.
godobject::GripOperator quiet_operator(const godobject::PivotOptions& options) {
  godobject::GripOperator hand;
  hand.speed = 0.1;
  hand.rate = 0.2 * godobject::default_load(options);
  return hand;
}

/// A grip that eases by itself, without dampers, so that the god-object lies on the p-curves; and an operator with a hand's dampers.
void write_runs(const std::filesystem::path& output) {
  GatheredRows pivot(output / "pivot.csv");
  for (const godobject::PivotCase kind : cases) {
    const std::string name(godobject::to_string(kind));
    const std::vector<std::string> call{"pivot", "--case", name, "--material", "sandpaper", "--every", "10"};
    std::vector<std::string> released = call;
    released.insert(released.end(), {"--release", "from=0.5,to=0.25,over=10", "--damping", "0"});
    pivot.add(released, {{"case", name}, {"grip", "release"}});
    std::vector<std::string> operated = call;
    operated.insert(operated.end(),
                    {"--operator", "target=30deg,speed=0.1,rate=0.1", "--damping", format_number(quiet_damping), "--duration", "15"});
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

/// What the operator achieves, over the offset of the centre of mass: the angle of the block, its slip past the fingers, and how often it turns back
/// by more than 0.1° before he has regripped.
void write_offsets(const std::filesystem::path& output, const std::filesystem::path& data) {
  constexpr double reversal = 0.1 * std::numbers::pi / 180.0;
  AtomicFile file(output / "pivot_offsets.csv");
  Rows rows({file.output()}, {"material", "case", "offset", "angle", "grip_slip", "reversals"});
  for (const Material& material : read_materials(data)) {
    for (const godobject::PivotCase kind : cases) {
      for (const double offset : {0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.0065, 0.007, 0.008, 0.009}) {
        godobject::PivotOptions options;
        options.kind = kind;
        options.mu = material.mu;
        options.mu_r = material.mu_r;
        options.damping = quiet_damping;
        options.duration = 25.0;
        options.grip_operator = quiet_operator(options);
        options.offset = offset;
        godobject::Pivot pivot(options);
        double extreme = 0.0;
        double sense = 1.0;
        std::size_t reversals = 0;
        const double start_load = pivot.row().load;
        bool eased = false;
        // Until it has left the fingers, or is held as firmly as at the beginning.
        while (pivot.row().state != godobject::ContactState::free && !(eased && pivot.row().load >= start_load) && pivot.step()) {
          eased = eased || pivot.row().load < 0.9 * start_load;
          const double ahead = sense * (pivot.row().angle - extreme);
          if (ahead > 0.0) extreme = pivot.row().angle;
          if (ahead >= -reversal) continue;
          ++reversals;
          sense = -sense;
          extreme = pivot.row().angle;
        }
        rows.row(material.name, godobject::to_string(kind), offset, pivot.row().angle, pivot.row().grip_slip, reversals);
      }
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
  write_offsets(output, data);
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
