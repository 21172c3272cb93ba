// SPDX-License-Identifier: MIT
// Many contacts on all cores: each thread steps its own part of the arrays with one call of the batch. Prints contacts
// a second for 1, 2, 4 … threads, and checks that the bits equal those of a single thread.
//     example_all_cores [CONTACTS [STEPS]]      ten million contacts: example_all_cores 1e7, 1 GB
#include "godobject/batch/batch.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <barrier>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;
using Clock = std::chrono::steady_clock;

/// Moves the fingers of some contacts to their positions at a step: they slide and twist, each a little differently, at
/// a depth of 0.1 to 0.2 mm.
void move(god::ContactArrays& contacts, std::size_t begin, std::size_t end, int step) {
  const auto x = contacts.x();
  const auto angle = contacts.twist();
  const auto depth = contacts.depth();
  for (std::size_t i = begin; i < end; ++i) {
    const double own = static_cast<double>(i % 1000) * 1e-3;
    x[i] = 1e-5 * step * (0.5 + own);
    angle[i] = 5e-3 * step * (1.5 - own);
    depth[i] = 1e-4 * (1.0 + own);
  }
}

/// Seconds for all steps, with the motion of the fingers, on a number of threads.
double run(const god::Batch& friction, god::ContactArrays& contacts, int steps, unsigned threads) {
  const std::size_t count = contacts.size();
  std::barrier ready(static_cast<std::ptrdiff_t>(threads) + 1);
  Clock::time_point start;
  {
    std::vector<std::jthread> team;
    for (unsigned t = 0; t < threads; ++t) {
      // Parts begin at multiples of 8, so that each fills whole SIMD vectors.
      const std::size_t begin = count * t / threads / 8 * 8;
      const std::size_t end = t + 1 == threads ? count : count * (t + 1) / threads / 8 * 8;
      team.emplace_back([&, begin, end] {
        const god::ContactBatch batch = contacts.batch().part(begin, end - begin);
        ready.arrive_and_wait();
        // The threads share the constant friction parameters; none waits.
        for (int step = 0; step < steps; ++step) {
          move(contacts, begin, end, step);
          friction.step(batch);
        }
      });
    }
    ready.arrive_and_wait();
    start = Clock::now();
  }  // joins
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int main(int argc, char** argv) {
  const double wanted = argc > 1 ? std::strtod(argv[1], nullptr) : 2e4;
  const double steps_wanted = argc > 2 ? std::strtod(argv[2], nullptr) : 30.0;
  if (!(wanted >= 1.0 && wanted <= 1e9 && steps_wanted >= 1.0 && steps_wanted <= 1e6)) {
    std::fprintf(stderr, "example_all_cores: error: expected CONTACTS from 1 to 1e9 and STEPS from 1 to 1e6\n");
    return 2;
  }
  const auto count = static_cast<std::size_t>(wanted);
  const int steps = static_cast<int>(steps_wanted);

  const god::FingerParameters skin{
      .mu = 0.6, .radius_law = lc::RadiusLaw::constant(0.005), .stiffness = 1000.0, .twist_stiffness = 0.01};
  const god::Batch friction(lc::Table::build(lc::hertz(), 1e-6), skin);

  const unsigned cores = std::max(std::thread::hardware_concurrency(), 1U);
  std::vector<unsigned> teams;
  for (unsigned threads = 1; threads < cores; threads *= 2) teams.push_back(threads);
  teams.push_back(cores);

  std::vector<double> forces;
  std::vector<double> moments;
  bool right = true;
  double alone = 0.0;
  std::printf("%zu contacts, %d steps, table of 1e-6 and closest point\n", count, steps);
  for (const unsigned threads : teams) {
    god::ContactArrays contacts(count);
    const double seconds = run(friction, contacts, steps, threads);
    const double rate = static_cast<double>(count) * steps / seconds;
    const god::ContactBatch felt = contacts.batch();
    if (forces.empty()) {
      alone = rate;
      forces.assign(felt.fx.begin(), felt.fx.end());
      moments.assign(felt.moment.begin(), felt.moment.end());
    }
    right = right && std::ranges::equal(felt.fx, forces) && std::ranges::equal(felt.moment, moments);
    std::printf("%3u threads: %7.2f million contacts a second, %.2f times one thread\n", threads, 1e-6 * rate,
                rate / alone);
  }
  // All contacts slip by now, and none exceeds its limit.
  const double limit = 0.6 * 1000.0 * 2e-4 * (1.0 + 1e-9);
  right = right && std::all_of(forces.begin(), forces.end(), [&](double force) { return std::fabs(force) <= limit; });
  const bool slipped = std::any_of(moments.begin(), moments.end(), [](double moment) { return moment != 0.0; });
  return right && slipped ? 0 : 1;
}
