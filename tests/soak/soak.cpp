// SPDX-License-Identifier: MIT
#include "tests/soak/curves.hpp"
#include "tests/soak/step_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

// Random steps of the god-object, in episodes of one finger each: no NaN, no infinity, no wrench outside its limit, no negative
// slip work, no proxy that moves while it sticks.
//
//     soak [--steps N] [--seed S] [--episode E] [--samples FILE] [--tables DIR | --write-tables DIR]
//
// An episode depends only on the seed and its number, so that a failing one can be run alone (--episode). Prints how many
// steps there were, and by how much a wrench exceeded its limit. --samples writes some outputs, to compare builds
// (scripts/maintain/matrix); these read the same tables, which one of them writes.

namespace limitcurve::soak {
namespace {

struct Settings {
  std::uint64_t steps = 100'000;
  std::uint64_t seed = 1;
  std::string samples;
  std::string tables;
  std::string tables_to_write;
  std::optional<std::uint64_t> episode;
};

constexpr std::size_t kinds = Curves::names.size();

/// What a soak has seen so far.
struct Totals {
  std::uint64_t episodes = 0;
  std::uint64_t steps = 0;
  std::array<std::uint64_t, 4> states{};        ///< free, stick, slip, invalid
  std::array<double, kinds> excess_slipping{};  ///< largest gauge − 1, by kind of curve
  std::array<double, kinds> excess_sticking{};
};

void print_sample(const Sample& sample) {
  const auto& [contact, twist, time_step] = sample;
  std::printf("  point %a %a %a normal %a %a %a depth %a twist %a time step %a\n", contact.point.x(), contact.point.y(), contact.point.z(),
              contact.normal.x(), contact.normal.y(), contact.normal.z(), contact.depth, twist, time_step);
}

void print_output(const godobject::FingerOutput& output) {
  std::printf("  %s proxy %a %a %a angle %a load %a force %a %a %a moment %a cor %a slip work %a\n",
              std::string(to_string(output.state)).c_str(), output.proxy.x(), output.proxy.y(), output.proxy.z(), output.angle, output.load,
              output.force.x(), output.force.y(), output.force.z(), output.moment, output.cor, output.slip_work);
}

class Soak {
 public:
  Soak(const Settings& settings, const Curves& curves) : settings_(settings), curves_(curves) {
    if (settings.samples.empty()) return;
    samples_.open(settings.samples);
    if (!samples_) throw std::runtime_error("cannot write '" + settings.samples + "'");
    samples_ << "curve,projection,episode,step,state,force_x,force_y,force_z,moment,force_scale,moment_scale\n" << std::setprecision(17);
  }

  [[nodiscard]] const Totals& totals() const { return totals_; }
  [[nodiscard]] bool failed() const { return failed_; }

  void run_episode(std::uint64_t episode) {
    RandomBits random(settings_.seed * 0x9e3779b97f4a7c15U + episode);
    const auto kind = static_cast<std::size_t>(random.below(kinds));
    const auto projection = static_cast<godobject::Projection>(random.below(3));
    const bool plain = random.one_in(2);
    const godobject::FingerCurve curve = curves_.any(kind, random);
    // A box goes with the closest point only.
    godobject::SoftFinger finger(curve, any_finger(random, plain), curve.is_box() ? godobject::Projection::closest_point : projection);
    run(finger, random, {kind, episode});
    totals_.episodes = episode + 1;
  }

 private:
  struct Episode {
    std::size_t kind;
    std::uint64_t number;
  };

  void run(godobject::SoftFinger& finger, RandomBits& random, const Episode& episode) {
    Motion motion(random);
    for (int i = 0; i < steps_per_episode; ++i) {
      const Sample& sample = motion.next(random);
      const godobject::FingerState before = finger.state();
      finger.update(sample.contact, sample.twist, sample.time_step);
      StepCheck check = check_step(finger, before, sample);
      if (samples_.is_open() && i % steps_per_sample == 0) write_sample(finger, sample, episode, i);
      const godobject::ContactState state = finger.output().state;
      ++totals_.states[static_cast<std::size_t>(state)];
      if (check.counted) {
        const bool slips = state == godobject::ContactState::slip;
        double& largest = (slips ? totals_.excess_slipping : totals_.excess_sticking)[episode.kind];
        // Also true of NaN.
        if (!(check.excess <= most_excess) && check.fault.empty()) check.fault = "a wrench outside its limit";
        if (settings_.episode && check.excess > largest) std::printf("  %d: %g above the limit\n", i, check.excess);
        largest = std::max(largest, check.excess);
      }
      if (check.fault.empty()) continue;
      failed_ = true;
      std::printf("episode %" PRIu64 " of seed %" PRIu64 ", %s with %s, step %d: %s (%g)\n", episode.number, settings_.seed,
                  Curves::names[episode.kind], std::string(to_string(finger.projection())).c_str(), i, check.fault.c_str(), check.excess);
      print_sample(sample);
      godobject::SoftFinger earlier = finger;
      earlier.restore(before);
      print_output(earlier.output());
      print_output(finger.output());
      break;
    }
    totals_.steps += steps_per_episode;
  }

  /// A row: what the user feels, and the scale that an agreement of it is a share of: the limit, and 2⁻¹⁰ of what the springs and dampers
  /// would make of the whole of the coordinates, so that 1e-12 of it has room for four roundings of them.
  void write_sample(const godobject::SoftFinger& finger, const Sample& sample, const Episode& episode, int step) {
    const godobject::FingerOutput output = finger.output();
    if (output.state != godobject::ContactState::stick && output.state != godobject::ContactState::slip) return;
    const godobject::FingerParameters& parameters = finger.parameters();
    const godobject::FrictionLimit<double> limit = limits_of(finger).sticking;
    const double stiffness = parameters.stiffness + parameters.damping / sample.time_step;
    const double twist_stiffness = parameters.twist_stiffness + parameters.twist_damping / sample.time_step;
    const double place = output.proxy.norm() + sample.contact.point.norm();
    const double angle = std::fabs(output.angle) + std::fabs(sample.twist);
    samples_ << Curves::names[episode.kind] << ',' << to_string(finger.projection()) << ',' << episode.number << ',' << step << ','
             << to_string(output.state) << ',' << output.force.x() << ',' << output.force.y() << ',' << output.force.z() << ','
             << output.moment << ',' << limit.force + std::ldexp(stiffness * place, -10) << ','
             << limit.force * limit.radius + std::ldexp(twist_stiffness * angle, -10) << '\n';
  }

  static constexpr double most_excess = 1.01e-12;  ///< the onset of slip, and rounding of the gauge
  static constexpr int steps_per_episode = 4096;
  static constexpr int steps_per_sample = 128;

  const Settings& settings_;
  const Curves& curves_;
  Totals totals_;
  std::ofstream samples_;
  bool failed_ = false;
};

std::uint64_t read_count(const char* text) {
  std::uint64_t value = 0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, value);
  if (error != std::errc{} || stop != end) throw std::invalid_argument(std::string("got '") + text + "', expected a whole number");
  return value;
}

Settings read_settings(int argc, char** argv) {
  Settings result;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(name + ": expected a value");
    const char* const value = argv[i + 1];
    if (name == "--steps") {
      result.steps = read_count(value);
    } else if (name == "--seed") {
      result.seed = read_count(value);
    } else if (name == "--samples") {
      result.samples = value;
    } else if (name == "--tables") {
      result.tables = value;
    } else if (name == "--write-tables") {
      result.tables_to_write = value;
    } else if (name == "--episode") {
      result.episode = read_count(value);
    } else {
      throw std::invalid_argument(name + ": expected --steps, --seed, --episode, --samples, --tables or --write-tables");
    }
  }
  return result;
}

void print_totals(const Settings& settings, const Totals& totals) {
  std::printf("%" PRIu64 " steps in %" PRIu64 " episodes of seed %" PRIu64 ": free %" PRIu64 ", stick %" PRIu64 ", slip %" PRIu64
              ", invalid %" PRIu64 "\n",
              totals.steps, totals.episodes, settings.seed, totals.states[0], totals.states[1], totals.states[2], totals.states[3]);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    std::printf("largest gauge, %s: slipping 1 + %.3g, sticking 1 + %.3g\n", Curves::names[kind], totals.excess_slipping[kind],
                totals.excess_sticking[kind]);
  }
}

int run(const Settings& settings) {
  if (!settings.tables_to_write.empty()) {
    Curves().write(settings.tables_to_write);
    return 0;
  }
  const Curves curves = settings.tables.empty() ? Curves() : Curves(settings.tables);
  Soak soak(settings, curves);
  if (settings.episode) {
    soak.run_episode(*settings.episode);
  } else {
    while (soak.totals().steps < settings.steps && !soak.failed()) soak.run_episode(soak.totals().episodes);
  }
  print_totals(settings, soak.totals());
  return soak.failed() ? 1 : 0;
}

}  // namespace
}  // namespace limitcurve::soak

int main(int argc, char** argv) {
  try {
    return limitcurve::soak::run(limitcurve::soak::read_settings(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "soak: error: " << error.what() << '\n';
    return 2;
  }
}
