// SPDX-License-Identifier: MIT
// Drives a finger at 1 kHz in its own thread, as a haptic device needs it, while the main thread draws at 60 Hz. The
// state passes between the threads without a lock: neither waits for the other. At the end it prints the delay of the
// wake-ups and the time of the steps.
//     example_servo_thread [SECONDS]
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;
using Clock = std::chrono::steady_clock;

/// Passes the latest value from one writing thread to one reading thread. It has three slots: the writer's, the
/// reader's and one between. Each side exchanges its slot with the one between in a single atomic step, so neither
/// waits.
template <class Value>
class Latest {
 public:
  void write(const Value& value) noexcept {
    values_[back_] = value;
    back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }
  /// Takes the latest value; false if there is no new one.
  bool read(Value& value) noexcept {
    if ((middle_.load(std::memory_order_relaxed) & fresh) == 0U) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~fresh;
    value = values_[front_];
    return true;
  }

 private:
  static constexpr unsigned fresh = 4U;
  std::array<Value, 3> values_{};
  std::atomic<unsigned> middle_{1U};
  unsigned back_ = 0U;   // the writer's
  unsigned front_ = 2U;  // the reader's
};

/// The state to draw: a plain value.
struct Snapshot {
  long step = 0;
  god::FingerState state;
};

struct Timing {
  std::vector<double> late;   // after the due time [us]
  std::vector<double> taken;  // by the step [us]
};

// A finger that slides and twists about a centre of rotation at c = 5 mm on a plane, with a load of 2 N.
constexpr double depth = 0.002;
constexpr double cor = 0.005;

void print(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("%-22s median %7.2f  99 %% %7.2f  99.9 %% %7.2f  worst %7.2f us\n", what, at(0.5), at(0.99), at(0.999),
              at(1.0));
}

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 1.0;
  constexpr std::chrono::milliseconds period{1};
  const long steps = std::lround(1000.0 * std::clamp(seconds, 0.2, 3600.0));

  const god::FingerParameters parameters{
      .mu = 0.6, .radius_law = lc::RadiusLaw::constant(0.005), .stiffness = 1000.0, .twist_stiffness = 0.025};
  // Construct tables and fingers before the loop: only construction allocates.
  god::SoftFinger finger(lc::Table::build(lc::hertz(), 1e-6), parameters);

  Latest<Snapshot> latest;
  Timing timing;
  timing.late.reserve(static_cast<std::size_t>(steps));
  timing.taken.reserve(static_cast<std::size_t>(steps));
  std::atomic<bool> done = false;

  // The thread owns the finger. (A real loop sets a real-time priority here: pthread_setschedparam, SCHED_FIFO.)
  std::jthread servo([&](std::stop_token stop) {
    Clock::time_point due = Clock::now();
    for (long step = 0; step < steps && !stop.stop_requested(); ++step) {
      // The next due time counts from the last due time, not from the wake-up, so it does not drift.
      due += period;
      std::this_thread::sleep_until(due);
      const Clock::time_point begin = Clock::now();
      const double slid = 0.02e-3 * static_cast<double>(step);  // 20 mm/s
      finger.update({{slid, 0.0, 0.0}, {0.0, 0.0, 1.0}, depth}, slid / cor, 1e-3);
      latest.write({step, finger.state()});
      const Clock::time_point end = Clock::now();
      timing.late.push_back(std::chrono::duration<double, std::micro>(begin - due).count());
      timing.taken.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }
    done = true;
  });

  // Drawing, at its own rate: it gets complete states only, and never an older one.
  Snapshot seen;
  long pictures = 0;
  bool right = true;
  const auto look = [&] {
    const long before = seen.step;
    if (!latest.read(seen)) return;
    ++pictures;
    // Force and proxy belong to the same step.
    const god::FingerState& state = seen.state;
    right =
        right && (parameters.stiffness * (state.output.proxy - state.sample.goal) - state.output.force).norm() < 1e-9;
    right = right && seen.step >= before;
  };
  while (!done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
    look();
  }
  servo.join();
  look();
  right = right && seen.step == steps - 1;

  print("woke late by", timing.late);
  print("step and hand-over took", timing.taken);
  const auto exact = lc::hertz()->forces(cor / 0.005);
  const god::FingerOutput felt = finger.output();
  std::printf("%ld steps, %ld pictures; felt %.6f N and %.6f N mm, eq. (17) says %.6f N and %.6f N mm\n", steps,
              pictures, felt.force.norm(), 1e3 * std::abs(felt.moment), 1.2 * exact.force,
              1e3 * 1.2 * 0.005 * exact.moment);
  right = right && felt.state == god::ContactState::slip;
  if (steps >= 1000) right = right && std::abs(felt.force.norm() - 1.2 * exact.force) < 1e-4;
  return right ? 0 : 1;
}
