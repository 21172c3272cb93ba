// SPDX-License-Identifier: MIT
#include "tests/fuzz/steps.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <map>
#include <random>
#include <string>
#include <vector>

// Random steps of the god-object, in episodes of one finger each: what fuzz's target `step` makes of random bytes, the
// same on every machine.
//
//     soak [--steps N] [--seed S] [--samples FILE] [--tables DIR]
//
// Prints how many steps there were, and by how much a wrench exceeded its limit. A failing episode is written up to the
// step that fails: a seed of the target. --samples writes some outputs, to compare builds (scripts/maintain/matrix);
// these read the same tables, in DIR.

namespace limitcurve::fuzz {
namespace {

constexpr std::size_t bytes_per_episode = 1U << 16U;
constexpr std::size_t steps_per_sample = 128;

/// A row: what the user feels, and the scale that an agreement of it is a share of: the limit, and 2⁻¹⁰ of what the
/// springs and dampers would make of the whole of the coordinates, so that 1e-12 of it has room for four roundings of
/// them.
void write_sample(std::ofstream& samples, const godobject::SoftFinger& finger, const Sample& sample) {
  const godobject::FingerOutput output = finger.output();
  if (output.state != godobject::ContactState::stick && output.state != godobject::ContactState::slip) return;
  const godobject::FingerParameters& parameters = finger.parameters();
  const godobject::FrictionLimit<double> limit = test::limits_of(finger).sticking;
  const double stiffness = parameters.stiffness + parameters.damping / sample.time_step;
  const double twist_stiffness = parameters.twist_stiffness + parameters.twist_damping / sample.time_step;
  const double place = output.proxy.norm() + sample.contact.point.norm();
  const double angle = std::fabs(output.angle) + std::fabs(sample.twist);
  samples << to_string(output.state) << ',' << output.force.x() << ',' << output.force.y() << ',' << output.force.z()
          << ',' << output.moment << ',' << limit.force + std::ldexp(stiffness * place, -10) << ','
          << limit.force * limit.radius + std::ldexp(twist_stiffness * angle, -10) << '\n';
}

int soak(std::map<std::string, std::string> settings) {
  kept_tables = settings.at("--tables");
  std::ofstream samples(settings.at("--samples"));
  samples << "state,force_x,force_y,force_z,moment,force_scale,moment_scale\n" << std::setprecision(17);
  std::mt19937_64 random(std::stoull(settings.at("--seed")));
  const std::uint64_t least_steps = std::stoull(settings.at("--steps"));
  std::vector<std::uint8_t> input(bytes_per_episode);
  std::array<std::uint64_t, 4> states{};
  std::uint64_t steps = 0;
  double excess = -1.0;
  std::string fault;
  while (steps < least_steps && fault.empty()) {
    for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random());
    Bytes bytes({reinterpret_cast<const char*>(input.data()), input.size()});
    run_steps(bytes, [&](const godobject::SoftFinger& finger, const Sample& sample, const test::StepCheck& check) {
      if (samples.is_open() && steps % steps_per_sample == 0) write_sample(samples, finger, sample);
      ++steps;
      ++states[static_cast<std::size_t>(finger.output().state)];
      excess = std::max(excess, check.excess);
      fault = check.fault;
    });
    if (!fault.empty()) {
      input.resize(input.size() - bytes.left());
      std::ofstream("soak-finding", std::ios::binary)
          .write(reinterpret_cast<const char*>(input.data()), std::ssize(input));
      std::printf("%s (%g above the limit), see soak-finding\n", fault.c_str(), excess);
    }
  }
  std::printf("%" PRIu64 " steps: free %" PRIu64 ", stick %" PRIu64 ", slip %" PRIu64 ", invalid %" PRIu64
              "; largest gauge 1 + %.3g\n",
              steps, states[0], states[1], states[2], states[3], excess);
  return fault.empty() ? 0 : 1;
}

}  // namespace
}  // namespace limitcurve::fuzz

int main(int argc, char** argv) {
  std::map<std::string, std::string> settings{
      {"--steps", "100000"}, {"--seed", "1"}, {"--samples", ""}, {"--tables", ""}};
  for (int i = 1; i + 1 < argc; i += 2) settings.at(argv[i]) = argv[i + 1];
  return limitcurve::fuzz::soak(settings);
}
