// SPDX-License-Identifier: MIT
#include "work_precision_step.hpp"

#include "number_text.hpp"
#include "way.hpp"

#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/patch/patch_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::bench {
namespace {

using namespace limitcurve::godobject;

constexpr double depth = 0.002;

/// At 2 mm depth the load is 2 N.
FingerParameters parameters(double moment_ratio) {
  FingerParameters result;
  result.mu = 0.6;
  result.radius_law = RadiusLaw::constant(moment_ratio);
  result.stiffness = 1000.0;
  result.twist_stiffness = 2.0 * result.stiffness * moment_ratio * moment_ratio;
  return result;
}

/// As a tactile sensor sends it: two bumps that are not equally high, the second turned.
Patch image(std::size_t side) {
  std::vector<double> pressures;
  const double pixel = 0.016 / static_cast<double>(side);
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const double x = (static_cast<double>(column) + 0.5) * pixel - 0.008;
      const double y = 0.008 - (static_cast<double>(row) + 0.5) * pixel;
      const double first = 1.0 - std::pow((x + 0.002) / 0.004, 2) - std::pow(y / 0.006, 2);
      const double second = 0.5 - std::pow((x + y - 0.003) / 0.005, 2) - std::pow((x - y - 0.003) / 0.003, 2);
      pressures.push_back(std::sqrt(std::max(0.0, first)) + std::sqrt(std::max(0.0, second)));
    }
  }
  return Patch::image(pressures, side, pixel);
}

/// Twists about the centre of pressure: CORs in all directions, from a hundredth of m₀ to a hundred times as far.
std::vector<PatchTwist> twists(double moment_ratio) {
  std::vector<PatchTwist> result;
  for (const double u : spread(4096)) {
    const double distance = moment_ratio * std::pow(10.0, 4.0 * u - 2.0);
    const double direction = 2.0 * std::numbers::pi * 1597.0 * u;  // independent of u
    const double rate = 1.0 / std::hypot(distance, moment_ratio);
    result.push_back({rate * distance * std::cos(direction), rate * distance * std::sin(direction), rate});
  }
  return result;
}

/// The larger of |ΔF| and |ΔM|/m₀.
double difference(const PatchWrench& one, const PatchWrench& other, double moment_ratio) {
  return std::fmax(std::hypot(one.fx - other.fx, one.fy - other.fy),
                   std::fabs(one.moment - other.moment) / moment_ratio);
}

/// A slow motion of which every step slips. The friction on the user in units of μP after each.
class Stepper {
 public:
  Stepper(SoftFinger finger, double moment_ratio) : finger_(std::move(finger)), moment_ratio_(moment_ratio) {
    finger_.update(contact_, twist_);
  }

  PatchWrench step() {
    const double phase = 2.0 * std::numbers::pi * (++steps_ % period) / period;
    const double u = 0.5 - 0.45 * std::cos(phase);
    contact_.point += 1e-4 * (1.0 - u) * Eigen::Vector3d(std::cos(3.0 * phase), std::sin(3.0 * phase), 0.0);
    twist_ += 1e-4 * u / moment_ratio_;
    const FingerOutput& output = finger_.update(contact_, twist_);
    const double limit = 0.6 * output.load;
    return {output.force.x() / limit, output.force.y() / limit, output.moment / limit};
  }
  static constexpr int period = 4096;

 private:
  SoftFinger finger_;
  double moment_ratio_;
  Contact contact_{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), depth};
  double twist_ = 0.0;
  int steps_ = 0;
};

/// A way to the wrench of a patch, and a finger on it.
struct PatchWay {
  std::function<PatchWrench(const PatchTwist&)> wrench;
  SoftFinger finger;
  double bytes = 0.0;
};

void add(const std::string& name, const Patch& patch, const PatchWay& way, bool is_exact) {
  const double m0 = patch.moment_ratio();
  const std::vector<PatchTwist> inputs = twists(m0);
  // Sums have the error that they state; a finger on them has no more than what it smooths.
  const Patch smooth = patch.smoothed(1e-9 * m0);
  double wrench_error = 0.0;
  double step_error = 0.0;
  for (const PatchTwist& twist : inputs) {
    const PatchFriction exact = patch.about_origin(twist);  // the centre of pressure is the origin
    wrench_error = std::fmax(wrench_error, is_exact ? exact.error : difference(way.wrench(twist), exact.wrench, m0));
    if (is_exact) step_error = std::fmax(step_error, exact.error + difference(smooth.wrench(twist), exact.wrench, m0));
  }
  Stepper own(SoftFinger(patch, parameters(m0)), m0);
  Stepper other(way.finger, m0);
  for (int i = 0; i < Stepper::period && !is_exact; ++i)
    step_error = std::fmax(step_error, difference(own.step(), other.step(), m0));
  const auto add_timing = [&](const char* group, double error, auto call) {
    benchmark::RegisterBenchmark((group + name).c_str(),
                                 [=, bytes = way.bytes](benchmark::State& state) mutable {
                                   for (auto _ : state) benchmark::DoNotOptimize(call());
                                   state.counters["seconds"] = {1.0, benchmark::Counter::kIsIterationInvariantRate |
                                                                         benchmark::Counter::kInvert};
                                   state.counters["max_error"] = error;
                                   state.counters["bytes"] = bytes;
                                 })
        ->MinTime(0.01)
        ->Repetitions(9);
  };
  add_timing("patch/", wrench_error, [inputs, wrench = way.wrench, i = std::size_t{0}]() mutable {
    return wrench(inputs[i++ % inputs.size()]).moment;
  });
  add_timing("patch_step/", step_error,
             [stepper = Stepper(way.finger, m0)]() mutable { return stepper.step().moment; });
}

}  // namespace

void register_patches() {
  const std::pair<const char*, Patch> patches[] = {
      {"image 128 x 128", image(128)},
      {"image 32 x 32", image(32)},
      {"ellipse of power:n=2.3", Patch::ellipse(parse_law("power:n=2.3"), 0.008, 0.004)},
      {"ellipse of hertz", Patch::ellipse(hertz(), 0.008, 0.004)},
      {"rectangle", Patch::rectangle(0.016, 0.008)},
  };
  for (const auto& [name, patch] : patches) {
    const std::string prefix = std::string(name) + '/';
    const auto wrench_of = [](const Patch& of) { return [of](const PatchTwist& twist) { return of.wrench(twist); }; };
    const double m0 = patch.moment_ratio();
    add(prefix + "sums/", patch, {wrench_of(patch), SoftFinger(patch, parameters(m0))}, true);
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      std::optional<PatchTable> table;
      try {
        table = PatchTable::build(patch, tolerance);
      } catch (const std::invalid_argument&) {
        continue;  // its corners or pixels are too sharp for a table
      }
      add(prefix + "table/" + study::number_text(tolerance), patch,
          {wrench_of(*table), SoftFinger(*table, parameters(m0)), static_cast<double>(table->bytes())}, false);
    }
    // F² + (M/m₀)² = 1, and its finger.
    const auto ellipsoid = [m0](const PatchTwist& twist) {
      const double size = std::hypot(twist.vx, twist.vy, m0 * twist.omega);
      return PatchWrench{twist.vx / size, twist.vy / size, m0 * m0 * twist.omega / size};
    };
    const SoftFinger finger(Ellipse::through_intercepts(1.0), parameters(m0), Projection::closest_point);
    add(prefix + "ellipsoid/", patch, {ellipsoid, finger}, false);
  }
}

}  // namespace limitcurve::bench
