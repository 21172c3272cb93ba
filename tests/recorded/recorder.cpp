// SPDX-License-Identifier: MIT
// Prints results of library functions without a subcommand: batches, and a finger's preview, restore, jumps, faults
// and turns. scripts/maintain/record compares that with what is recorded. Motions are made here, by formula.
//   recorder SCENARIO PARAMETERS CURVE PROJECTION [mu-times=F] [twist-stiffness-times=F]
#include "tests/recorded/library.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace recorded {
namespace {

// Motions. ----------------------------------------------------------------------------------------------------------------------------

/// Numbers in [0, 1) that are the same everywhere: Knuth's MMIX generator, its upper half.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) { static_cast<void>(between(0.0, 1.0)); }
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * static_cast<double>(state_ >> 32U) * 0x1p-32;
  }

 private:
  std::uint64_t state_;
};

constexpr int steps = 400;

/// Swings about 0, of which each contact has its own; all rest in the steps from 150 to 200.
class Swing {
 public:
  Swing(Numbers& numbers, double least, double most)
      : amplitude_(numbers.between(least, most)), rate_(numbers.between(3.0, 18.0)), phase_(numbers.between(0.0, 6.0)) {}
  [[nodiscard]] double at(int step) const {
    const int moved = step < 150 ? step : std::max(step - 50, 150);
    return amplitude_ * std::sin(rate_ * 1e-3 * moved + phase_);
  }

 private:
  double amplitude_;
  double rate_;
  double phase_;
};

/// Of one contact in a batch: rubs to and fro, and lifts off now and then.
struct Motion {
  explicit Motion(std::uint64_t seed) : Motion(Numbers(seed)) {}
  explicit Motion(Numbers numbers)
      : x(numbers, 1e-3, 8e-3),
        y(numbers, 1e-3, 8e-3),
        twist(numbers, 0.1, 1.5),
        press(numbers, 0.3e-3, 2.2e-3),
        depth(numbers.between(1e-3, 2e-3)) {}
  Swing x;
  Swing y;
  Swing twist;
  Swing press;
  double depth;
};

/// A finger that rubs a ball of radius 50 mm.
Sample sample_at(int step) {
  static const Motion motion(7);
  const double tilt = motion.x.at(step) / 0.05;
  const double lean = motion.y.at(step) / 0.05;
  const Vector normal{std::sin(tilt) * std::cos(lean), std::sin(lean), std::cos(tilt) * std::cos(lean)};
  return {.point = {0.05 * normal[0], 0.05 * normal[1], 0.05 * normal[2]},
          .normal = normal,
          .depth = motion.depth + motion.press.at(step),
          .twist = motion.twist.at(step),
          .time_step = 1e-3};
}

// Scenarios. --------------------------------------------------------------------------------------------------------------------------

template <class Real>
void run_batch(const Setting& setting) {
  constexpr std::size_t count = 150;  // more than a loop takes at a time, and no multiple of what a register holds
  constexpr int fault_begins = 100;
  constexpr int fault_ends = 110;
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < count; ++i) motions.emplace_back(100 + i);
  Contacts<Real> contacts(count);
  const go::BasicBatch<Real> batch = make_batch<Real>(setting);
  std::puts("step,contact,state,px,py,angle,fx,fy,moment");
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < count; ++i) {
      contacts.x()[i] = static_cast<Real>(motions[i].x.at(step));
      contacts.y()[i] = static_cast<Real>(motions[i].y.at(step));
      contacts.twist()[i] = static_cast<Real>(motions[i].twist.at(step));
      contacts.depth()[i] = static_cast<Real>(motions[i].depth + motions[i].press.at(step));
    }
    const bool is_fault = step >= fault_begins && step < fault_ends;
    // No depth is none; of a position that is no number a batch of floats touches nothing (one of doubles is not tried here).
    if (is_fault) contacts.depth()[6] = static_cast<Real>(nan);
    if (is_fault && std::same_as<Real, float>) contacts.x()[77] = static_cast<Real>(nan);
    batch.step(contacts.batch());
    if (step % 57 != 56 && step != fault_begins + 2) continue;
    const go::BasicContactBatch<Real> felt = contacts.batch();
    for (const std::size_t i : {0U, 6U, 77U, 149U}) {
      const auto value = [i](auto array) { return static_cast<double>(array[i]); };
      std::printf("%d,%zu,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", step, i, std::string(go::to_string(felt.state[i])).c_str(),
                  value(felt.proxy_x), value(felt.proxy_y), value(felt.proxy_angle), value(felt.fx), value(felt.fy), value(felt.moment));
    }
  }
}

void print_header() {
  std::puts("what,step,state,px,py,pz,angle,depth,load,fx,fy,fz,moment,cor,margin,hold_load,dissipated");
}

void print(std::string_view what, int step, const Output& output, double dissipated) {
  std::printf("%s,%d,%s", std::string(what).c_str(), step, output.state.c_str());
  for (const double value : {output.proxy[0], output.proxy[1], output.proxy[2], output.angle, output.depth, output.load, output.force[0],
                             output.force[1], output.force[2], output.moment, output.cor, output.margin, output.load_to_hold, dissipated}) {
    if (std::isnan(value)) {
      std::printf(",nan");
    } else {
      std::printf(",%.17g", value);
    }
  }
  std::puts("");
}

/// Runs a finger over the motion as `change` changes it, and prints every 29th step and those near `shown`.
void run_changed(const Setting& setting, const std::vector<int>& shown, const std::function<void(int, Sample&)>& change) {
  Finger finger(setting);
  double dissipated = 0.0;
  print_header();
  for (int step = 0; step < steps; ++step) {
    Sample sample = sample_at(step);
    change(step, sample);
    const Output output = finger.update(sample);
    dissipated += output.slip_work;
    const bool is_near = std::any_of(shown.begin(), shown.end(), [&](int event) { return std::abs(step - event) <= 1; });
    if (step % 29 == 28 || is_near) print("update", step, output, dissipated);
  }
}

void run_preview(const Setting& setting) {
  Finger finger(setting);
  double dissipated = 0.0;
  print_header();
  for (int step = 0; step < steps; ++step) {
    // Every step, for a preview must leave nothing behind.
    const Output ahead = finger.preview(sample_at(step + 7));
    const Output output = finger.update(sample_at(step));
    dissipated += output.slip_work;
    if (step % 37 != 36) continue;
    print("preview", step + 7, ahead, ahead.slip_work);
    print("update", step, output, dissipated);
  }
}

/// A finger that goes back to where it was, another that is put there, and one that forgets all.
void run_restore(const Setting& setting) {
  constexpr int saved = 120;
  constexpr int restored = 260;
  Finger finger(setting);
  print_header();
  go::FingerState state;
  for (int step = 0; step < restored; ++step) {
    finger.update(sample_at(step));
    if (step == saved) state = finger.state();
  }
  Finger other(setting);
  finger.restore(state);
  other.restore(state);
  for (int step = saved + 1; step < steps; ++step) {
    if (step == 330) other.reset();
    const Output again = finger.update(sample_at(step));
    const Output its = other.update(sample_at(step));
    if (step % 37 != 36 && step != saved + 1 && step != 330) continue;
    print("restored", step, again, again.slip_work);
    print("other", step, its, its.slip_work);
  }
}

void run_leaps(const Setting& setting) {
  run_changed(setting, {100, 101, 220, 300, 320}, [](int step, Sample& sample) {
    // For one sample; for good, until it is back; by less than is refused.
    if (step == 100 || (step >= 220 && step < 300)) sample.point[0] += 0.03;
    if (step >= 320) sample.point[1] += 0.009;
  });
}

void run_faults(const Setting& setting) {
  run_changed(setting, {105, 115, 130, 140, 150, 160, 180, 190, 210}, [](int step, Sample& sample) {
    if (step >= 100 && step < 115) sample.point[1] = nan;
    if (step == 130) sample.depth = nan;
    if (step == 140) sample.twist = inf;
    if (step == 150) sample.normal[2] *= 1.1;
    if (step == 160) sample.time_step = -1e-3;
    if (step == 180) sample.point[0] = 2e6;
    if (step == 190) sample.twist = -2e6;
    if (step >= 210 && step < 220) sample.normal = {0.0, 0.0, 0.0};
  });
}

/// Rotation by more than a turn and back, from a device that wraps its angle.
void run_turns(const Setting& setting) {
  run_changed(setting, {300}, [](int step, Sample& sample) {
    const double turned = 0.05 * (step < 200 ? step : 400 - step);
    sample.twist = std::remainder(turned, 2.0 * std::numbers::pi);
    if (step >= 300) sample.twist += 6.0 * std::numbers::pi;
  });
}

void run_irregular(const Setting& setting) {
  run_changed(setting, {}, [](int step, Sample& sample) {
    constexpr std::array<double, 5> time_steps{1e-3, 2e-3, 0.0, 0.5e-3, 1e-10};
    sample.time_step = time_steps[static_cast<std::size_t>(step) % time_steps.size()];
  });
}

struct Scenario {
  std::string_view name;
  void (*run)(const Setting& setting);
};
constexpr std::array scenarios{Scenario{"double", run_batch<double>}, Scenario{"float", run_batch<float>}, Scenario{"preview", run_preview},
                               Scenario{"restore", run_restore},      Scenario{"leaps", run_leaps},        Scenario{"faults", run_faults},
                               Scenario{"turns", run_turns},          Scenario{"irregular", run_irregular}};

/// The factor that the arguments give that name, or 1.
double factor(const std::vector<std::string_view>& words, std::string_view name) {
  for (const std::string_view word : words) {
    if (word.starts_with(name) && word.substr(name.size()).starts_with('=')) return std::stod(std::string(word.substr(name.size() + 1)));
  }
  return 1.0;
}

}  // namespace
}  // namespace recorded

int main(int argc, char** argv) {
  using namespace recorded;
  try {
    const std::vector<std::string_view> words(argv + 1, argv + argc);
    if (words.size() < 4)
      throw std::invalid_argument("expected SCENARIO PARAMETERS CURVE PROJECTION [mu-times=F] [twist-stiffness-times=F]");
    const auto* const scenario =
        std::find_if(scenarios.begin(), scenarios.end(), [&](const Scenario& one) { return one.name == words[0]; });
    if (scenario == scenarios.end()) {
      throw std::invalid_argument("scenario '" + std::string(words[0]) +
                                  "', expected double, float, preview, restore, leaps, faults, turns or irregular");
    }
    scenario->run(make_setting(words[1], words[2], words[3], factor(words, "mu-times"), factor(words, "twist-stiffness-times")));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "recorder: error: %s\n", error.what());
    return 2;
  }
  return 0;
}
