// SPDX-License-Identifier: MIT
#include "tests/soak/boundaries.hpp"
#include "tests/soak/step_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

// Random steps of the god-object, in episodes of one finger each: no NaN, no infinity, no wrench outside its limit, no negative
// slip work, no proxy that moves while it sticks.
//
//     soak [--steps N] [--seed S] [--log FILE] [--tables DIR | --write-tables DIR] [--episode E]
//
// An episode is drawn from the seed and its number alone, so that one that fails can be run by itself (--episode). The log has a
// line every ten million steps; when it exists the soak goes on where its last line ends, if the seed is the same.
// Prints how many steps there were, how far above its limit a wrench came, and a hash of the bits of every output for each
// boundary, projection and way the radius depends on the load.

namespace limitcurve::soak {
namespace {

struct Settings {
  std::uint64_t steps = 100'000;
  std::uint64_t seed = 1;
  std::string log;
  std::string tables;
  std::string tables_to_write;
  std::optional<std::uint64_t> episode;
};

constexpr std::size_t kinds = Boundaries::names.size();
constexpr std::size_t projections = Boundaries::projections.size();
constexpr std::size_t families = kinds * projections * 2;

/// What a soak has seen so far: all that a line of the log holds.
struct Totals {
  std::uint64_t episodes = 0;
  std::uint64_t steps = 0;
  std::array<std::uint64_t, 4> states{};        ///< free, stick, slip, invalid
  std::array<double, kinds> excess_slipping{};  ///< largest gauge − 1 in units of 2⁻⁵², by boundary
  std::array<double, kinds> excess_sticking{};
  std::array<std::uint64_t, families> hashes{};
};

void write_line(std::ostream& out, std::uint64_t seed, const Totals& totals) {
  std::ostringstream line;
  line << "seed " << seed << " episodes " << totals.episodes << " steps " << totals.steps << " states";
  for (const std::uint64_t count : totals.states) line << ' ' << count;
  line.precision(6);
  line << " slipping";
  for (const double excess : totals.excess_slipping) line << ' ' << excess;
  line << " sticking";
  for (const double excess : totals.excess_sticking) line << ' ' << excess;
  line << " hashes" << std::hex;
  for (const std::uint64_t hash : totals.hashes) line << ' ' << hash;
  out << line.str() << std::endl;
}

/// The last whole line of a log; nothing if there is none of this seed.
Totals read_totals(const std::string& file, std::uint64_t seed) {
  Totals totals;
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);) {
    std::istringstream line(text);
    std::string word;
    std::uint64_t its_seed = 0;
    Totals read;
    line >> word >> its_seed >> word >> read.episodes >> word >> read.steps >> word;
    for (std::uint64_t& count : read.states) line >> count;
    line >> word;
    for (double& excess : read.excess_slipping) line >> excess;
    line >> word;
    for (double& excess : read.excess_sticking) line >> excess;
    line >> word >> std::hex;
    for (std::uint64_t& hash : read.hashes) line >> hash;
    if (line && its_seed == seed) totals = read;
  }
  return totals;
}

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
  Soak(const Settings& settings, const Boundaries& boundaries, const Totals& totals)
      : settings_(settings), boundaries_(boundaries), totals_(totals) {}

  [[nodiscard]] const Totals& totals() const { return totals_; }
  [[nodiscard]] bool failed() const { return failed_; }

  void run_episode(std::uint64_t episode) {
    RandomBits random(settings_.seed * 0x9e3779b97f4a7c15U + episode);
    const auto kind = static_cast<std::size_t>(random.below(kinds));
    const auto projection = static_cast<std::size_t>(random.below(projections));
    const bool plain = random.one_in(2);
    const std::size_t family = (kind * projections + projection) * 2 + (plain ? 0 : 1);
    boundaries_.visit(kind, random, [&](const auto& boundary) {
      godobject::visit_projection(static_cast<godobject::ProjectionKind>(projection), [&](auto rule) {
        const godobject::FingerParameters parameters = any_finger(random, plain);
        godobject::SoftFinger<std::decay_t<decltype(boundary)>, decltype(rule)> finger(boundary, parameters, rule);
        run(finger, random, episode, kind, family, kind == 0 ? 512 : 4096);
      });
    });
    totals_.episodes = episode + 1;
  }

 private:
  template <class Finger>
  void run(Finger& finger, RandomBits& random, std::uint64_t episode, std::size_t kind, std::size_t family, int steps) {
    Motion motion(random);
    OutputHash hash;
    for (int i = 0; i < steps; ++i) {
      const Sample& sample = motion.next(random);
      const godobject::FingerState before = finger.state();
      finger.update(sample.contact, sample.twist, sample.time_step);
      StepCheck check = check_step(finger, before, sample);
      hash.add(finger.output());
      ++totals_.states[static_cast<std::size_t>(check.state)];
      if (check.counted) {
        const bool slips = check.state == godobject::ContactState::slip;
        double& largest = (slips ? totals_.excess_slipping : totals_.excess_sticking)[kind];
        // Also true of what is no number.
        if (!(check.excess <= most_excess) && check.fault.empty()) check.fault = "a wrench outside its limit";
        if (settings_.episode && check.excess > largest) std::printf("  %d: %g ulp above the limit\n", i, check.excess);
        largest = std::max(largest, check.excess);
      }
      if (check.fault.empty()) continue;
      failed_ = true;
      std::printf("episode %" PRIu64 " of seed %" PRIu64 ", %s with %s, step %d: %s (%g)\n", episode, settings_.seed,
                  Boundaries::names[kind], Boundaries::projections[family / 2 % projections], i, check.fault.c_str(), check.excess);
      print_sample(sample);
      print_output(before.output);
      print_output(finger.output());
      break;
    }
    totals_.steps += static_cast<std::uint64_t>(steps);
    totals_.hashes[family] = (totals_.hashes[family] ^ hash.value()) * 0x9fb21c651e98df25U;
  }

  static constexpr double most_excess = 4.0;  ///< in units of 2⁻⁵²

  const Settings& settings_;
  const Boundaries& boundaries_;
  Totals totals_;
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
    } else if (name == "--log") {
      result.log = value;
    } else if (name == "--tables") {
      result.tables = value;
    } else if (name == "--write-tables") {
      result.tables_to_write = value;
    } else if (name == "--episode") {
      result.episode = read_count(value);
    } else {
      throw std::invalid_argument(name + ": expected --steps, --seed, --log, --tables, --write-tables or --episode");
    }
  }
  return result;
}

void print_totals(const Settings& settings, const Totals& totals) {
  std::printf("%" PRIu64 " steps in %" PRIu64 " episodes of seed %" PRIu64 ": free %" PRIu64 ", stick %" PRIu64 ", slip %" PRIu64
              ", invalid %" PRIu64 "\n",
              totals.steps, totals.episodes, settings.seed, totals.states[0], totals.states[1], totals.states[2], totals.states[3]);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    std::printf("largest gauge, %s: slipping 1 + %.4g ulp, sticking 1 + %.4g ulp\n", Boundaries::names[kind], totals.excess_slipping[kind],
                totals.excess_sticking[kind]);
  }
  for (std::size_t family = 0; family < families; ++family) {
    std::printf("bits %s %s %s %016" PRIx64 "\n", Boundaries::names[family / 2 / projections],
                Boundaries::projections[family / 2 % projections], family % 2 == 0 ? "constant-radius" : "power-radius",
                totals.hashes[family]);
  }
}

int run(const Settings& settings) {
  if (!settings.tables_to_write.empty()) {
    Boundaries().write(settings.tables_to_write);
    return 0;
  }
  const Boundaries boundaries = settings.tables.empty() ? Boundaries() : Boundaries(settings.tables);
  const bool logged = !settings.log.empty() && !settings.episode;
  Soak soak(settings, boundaries, logged ? read_totals(settings.log, settings.seed) : Totals{});
  if (settings.episode) {
    soak.run_episode(*settings.episode);
  } else {
    constexpr std::uint64_t steps_per_line = 10'000'000;
    std::uint64_t lines = soak.totals().steps / steps_per_line;
    while (soak.totals().steps < settings.steps && !soak.failed()) {
      soak.run_episode(soak.totals().episodes);
      if (!logged || (soak.totals().steps / steps_per_line == lines && soak.totals().steps < settings.steps)) continue;
      lines = soak.totals().steps / steps_per_line;
      std::ofstream log(settings.log, std::ios::app);
      write_line(log, settings.seed, soak.totals());
    }
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
