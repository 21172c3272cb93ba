// SPDX-License-Identifier: MIT
// The workloads of users: fingers on a plane, a grasp, batches, look-ups, construction
// of tables, patches. Alone it prints mean and worst of every workload on this machine;
// scripts/maintain/compare_speed compiles it against two commits and runs both in turn.
//
//     finger_bench [REGEX]   the workloads with matching names (default all), as CSV
//
// mean_ns: processor time of this process for a step (batches: a contact). worst_ns: a motion is timed in stretches of
// 128 steps (grasp: 32); this is the mean step of the slowest stretch, where each stretch counts with its fastest pass,
// so that interrupts are ignored. Empty if all stretches are alike. result: the mean of the steps' return values, to
// check that two commits do the same work.
#include <adaptor.hpp>  // of the commit that is measured
#include "motion.hpp"
#include "workload.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::bench {
namespace {

using Eigen::Vector3d;

constexpr double time_step = 1e-3;  // [s]

// ---- fingers

/// Contact and twist are given.
struct OnPlane {
  struct Input {
    Contact contact;
    double twist;
  };

  explicit OnPlane(Motion motion) {
    for (const Sample& s : move(motion)) inputs.push_back({{{s.x, s.y, 0.0}, Vector3d::UnitZ(), s.depth}, s.twist});
  }
  [[nodiscard]] const Contact& contact(std::size_t i) const { return inputs[i].contact; }
  [[nodiscard]] double twist(std::size_t i) const { return inputs[i].twist; }

  std::vector<Input> inputs;
};

/// The timed step.
template <bool cold, class Finger>
double take_step(Finger& finger, const OnPlane& place, std::size_t i) {
  if constexpr (cold) forget_closest_point(finger);
  return std::fabs(update(finger, place.contact(i), place.twist(i), time_step));
}

template <Model model, bool cold>
Pass one_finger(Skin skin, Motion motion) {
  return timed(samples / stretch_steps, stretch_steps,
               [finger = make_finger<model>(skin), place = OnPlane(motion)](std::size_t stretch) mutable {
                 double sum = 0.0;
                 for (std::size_t i = 0; i < stretch_steps; ++i) {
                   sum += take_step<cold>(finger, place, stretch * stretch_steps + i);
                 }
                 return sum;
               });
}

/// Fingers in turn, each at another point of the motion: a step need not wait for the finger's last one, as in a scene
/// with many fingers.
template <Model model, bool cold>
Pass sixteen_fingers(Skin skin, Motion motion) {
  constexpr std::size_t count = 16;
  const auto finger = make_finger<model>(skin);
  using Finger = std::remove_const_t<decltype(finger)>;
  return timed(samples * count / stretch_steps, stretch_steps,
               [fingers = std::vector<Finger>(count, finger), place = OnPlane(motion)](std::size_t stretch) mutable {
                 double sum = 0.0;
                 for (std::size_t i = 0; i < stretch_steps / count; ++i) {
                   for (std::size_t j = 0; j < count; ++j) {
                     const std::size_t at = (stretch * (stretch_steps / count) + i + j * (samples / count)) % samples;
                     sum += take_step<cold>(fingers[j], place, at);
                   }
                 }
                 return sum;
               });
}

// ---- a grasp: two fingers pinch a block; they carry it up and down (held), or they slide and turn on it, opposite
// ways (slip)

template <Model model>
Pass grasp(Skin skin, bool slips) {
  constexpr std::size_t steps = 32;
  constexpr std::size_t stretches = 16;
  const auto devices = [slips](std::size_t i) {
    const double phase = 2.0 * pi * static_cast<double>(i) / static_cast<double>(steps * stretches);
    const Vector3d middle = slips ? Vector3d(0.0, 0.0, 0.0) : Vector3d(0.0, 0.0, 0.01 * std::sin(phase));
    const Vector3d apart =
        slips ? Vector3d(0.01 * std::sin(phase), 0.005 * std::cos(phase), 0.018) : Vector3d(0.0, 0.0, 0.018);
    const double twist = slips ? std::sin(phase) : 0.0;
    return std::array<DevicePose, 2>{DevicePose{middle + apart, Eigen::Quaterniond::Identity(), twist},
                                     DevicePose{middle - apart, Eigen::Quaterniond::Identity(), twist}};
  };
  std::vector<std::array<DevicePose, 2>> inputs;
  for (std::size_t i = 0; i < steps * stretches; ++i) inputs.push_back(devices(i));
  return timed(stretches, steps, [body = make_grasp<model>(skin, 2, !slips), inputs](std::size_t stretch) mutable {
    // With sliding fingers the block drifts: it is put back before they lose it.
    if (stretch == 0) body.place(BodyState{}, inputs[0]);
    double sum = 0.0;
    for (std::size_t i = 0; i < steps; ++i) {
      body.step(inputs[stretch * steps + i], time_step);
      sum += body.body().position.z() + std::fabs(moment_of(body, 0));
    }
    return sum;
  });
}

// ---- batches: slip: every contact moves to and fro, each with its own centre of rotation; held, wild: as one finger

template <class Real>
struct Inputs {
  explicit Inputs(std::size_t count) : x(count), y(count), angle(count), depth(count) {}
  [[nodiscard]] BatchInput<Real> spans() const { return {x, y, angle, depth}; }

  std::vector<Real> x, y, angle, depth;
};

template <class Real>
std::vector<Inputs<Real>> batch_inputs(std::size_t count, Motion motion) {
  Random random;
  std::vector<Inputs<Real>> result(motion == Motion::slow ? 2 : 8, Inputs<Real>(count));
  const auto set = [](Inputs<Real>& input, std::size_t i, double x, double y, double angle, double depth) {
    input.x[i] = static_cast<Real>(x);
    input.y[i] = static_cast<Real>(y);
    input.angle[i] = static_cast<Real>(angle);
    input.depth[i] = static_cast<Real>(depth);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (motion == Motion::slow) {
      const double u = 0.5 + 0.45 * random(), direction = pi * random(), depth = 0.002 + 0.001 * random();
      for (const double sign : {1.0, -1.0}) {
        const double way = sign * 0.01 * (1.0 - u);
        set(result[sign < 0.0], i, way * std::cos(direction), way * std::sin(direction), sign * 1.2 * u, depth);
      }
    } else {
      const bool wild = motion == Motion::wild;
      const double reach = wild ? 0.01 : 5e-5, turn = wild ? 1.5 : 0.002, change = wild ? 0.001 : 1e-4;
      for (Inputs<Real>& input : result)
        set(input, i, reach * random(), reach * random(), turn * random(), 0.002 + change * random());
    }
  }
  return result;
}

template <Model model, class Real>
Pass batch(Skin skin, std::size_t count, Motion motion) {
  const auto stepped = std::make_shared<Batch<model, Real>>(skin, count);
  const auto inputs = std::make_shared<const std::vector<Inputs<Real>>>(batch_inputs<Real>(count, motion));
  // The first slips take longer than those after.
  for (std::size_t i = 0; i < 8; ++i) stepped->step((*inputs)[i % inputs->size()].spans());
  const std::size_t turns = std::max<std::size_t>(1, 4096 / count);
  const std::size_t steps = turns * inputs->size() * count;
  return timed(1, steps, [stepped, inputs, turns, steps, count](std::size_t) {
    for (std::size_t i = 0; i < turns; ++i) {
      for (const Inputs<Real>& input : *inputs) stepped->step(input.spans());
    }
    // The result of one contact stands for all: reading all would cost as much as stepping them.
    return std::fabs(static_cast<double>(stepped->moment()[count / 2])) * static_cast<double>(steps);
  });
}

// ---- tables

/// Twists in random order, evenly spaced from pure spin to pure slide, so that no branch predictor learns them.
Pass wrenches(const std::string& law, double tolerance) {
  constexpr std::size_t count = 1024;
  std::vector<std::array<double, 2>> twists;
  Random random;
  for (std::size_t i = 0; i < 4 * count; ++i) {
    const double u = 0.5 + 0.5 * random();
    twists.push_back({1.0 - u, u});
  }
  return timed(4, count, [table = build_table(law, tolerance), twists](std::size_t stretch) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [slide, spin] = twists[stretch * count + i];
      sum += wrench_sum(table, slide, spin);
    }
    return sum;
  });
}

/// Of a contact that is not round, about CORs in all directions, from `near` to `far` radii, evenly in the logarithm.
Pass wrenches(const Patch& patch, double near, double far) {
  constexpr std::size_t count = 1024;
  std::vector<PatchTwist> twists;
  Random random;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = patch.radius() * near * std::pow(far / near, 0.5 + 0.5 * random());
    const double direction = pi * random();
    twists.push_back({distance * std::cos(direction), distance * std::sin(direction), 1.0});
  }
  return timed(1, count, [patch, twists](std::size_t) {
    double sum = 0.0;
    for (const PatchTwist& twist : twists) sum += patch.evaluate(twist).wrench.moment;
    return sum;
  });
}

Pass building(const std::string& law, double tolerance) {
  return timed(1, 1, [law, tolerance](std::size_t) { return wrench_sum(build_table(law, tolerance), 0.5, 0.5); });
}

// ---- the list

std::vector<Workload> workloads() {
  std::vector<Workload> result;
  const auto add = [&](const std::string& name, std::function<Pass()> make) {
    result.emplace_back(name, std::move(make));
  };

  const std::array<std::pair<const char*, Skin>, 4> skins{
      {{"plain", {false, false}}, {"dampers", {true, false}}, {"a(P)", {false, true}}, {"dampers+a(P)", {true, true}}}};
  const auto add_fingers = [&]<Model model, bool cold>(const std::string& curve) {
    for (const auto& [skin_name, skin] : skins) {
      for (const auto& [motion, motion_name] : motions) {
        const std::string name = curve + '/' + skin_name + '/' + motion_name;
        add("finger/plane/one/" + name, [=] { return one_finger<model, cold>(skin, motion); });
        add("finger/plane/sixteen/" + name, [=] { return sixteen_fingers<model, cold>(skin, motion); });
      }
    }
  };
  add_fingers.operator()<Model::ellipse_radial, false>("ellipse-radial");
  add_fingers.operator()<Model::table_closest_point, false>("table-closest-warm");
  add_fingers.operator()<Model::table_closest_point, true>("table-closest-cold");
  add_fingers.operator()<Model::table_radial, false>("table-radial");

  const auto add_grasps = [&]<Model model>(const std::string& curve) {
    for (const auto& [skin_name, skin] : {skins.front(), skins.back()}) {
      for (const bool slips : {false, true}) {
        add("grasp/" + curve + '/' + skin_name + (slips ? "/slip" : "/held"),
            [=] { return grasp<model>(skin, slips); });
      }
    }
  };
  add_grasps.operator()<Model::ellipse_radial>("ellipse-radial");
  add_grasps.operator()<Model::table_closest_point>("table-closest");

  const auto add_batches = [&]<Model model, class Real>(const std::string& curve) {
    const auto add_batch = [&](Skin skin, const char* skin_name, std::size_t count, Motion motion,
                               const char* motion_name) {
      add("batch/" + curve + '/' + skin_name + '/' + motion_name + '/' + std::to_string(count),
          [=] { return batch<model, Real>(skin, count, motion); });
    };
    for (const std::size_t count : {64, 1024, 16384, 1000000, 10000000})
      add_batch(Skin{}, "plain", count, Motion::slow, "slip");
    add_batch(Skin{}, "plain", 1024, Motion::held, "held");
    add_batch(Skin{}, "plain", 1024, Motion::wild, "wild");
    add_batch(Skin{.radius_grows = true}, "a(P)", 1024, Motion::slow, "slip");
  };
  add_batches.operator()<Model::ellipse_radial, double>("double/ellipse-radial");
  add_batches.operator()<Model::table_closest_point, double>("double/table-closest");
  add_batches.operator()<Model::ellipse_radial, float>("float/ellipse-radial");
  add_batches.operator()<Model::table_closest_point, float>("float/table-closest");

  for (const char* law : {"hertz", "power:n=2.3"}) {
    for (const auto& [name, tolerance] : {std::pair{"1e-4", 1e-4}, std::pair{"1e-6", 1e-6}, std::pair{"1e-8", 1e-8},
                                          std::pair{"finest", finest_tolerance}}) {
      add(std::string("wrench/") + law + '/' + name, [=, tolerance = tolerance] { return wrenches(law, tolerance); });
    }
    add(std::string("build/") + law + "/1e-8", [=] { return building(law, 1e-8); });
  }
  std::vector<double> pressures;
  for (int i = 0; i < 64 * 64; ++i) pressures.push_back(1.0 + i % 7);
  for (const auto& [name, patch] : {std::pair{"rectangle", Patch::rectangle(0.02, 0.01)},
                                    std::pair{"elliptic hertz 2:1", Patch::ellipse(hertz(), 0.008, 0.004)},
                                    std::pair{"image 64 x 64", Patch::image(pressures, 64, 1e-3)}}) {
    add(std::string("patch/") + name + "/COR inside", [=, patch = patch] { return wrenches(patch, 0.01, 0.5); });
    add(std::string("patch/") + name + "/COR outside", [=, patch = patch] { return wrenches(patch, 1.01, 100.0); });
  }
  return result;
}

void print(const Round& round) {
  if (std::isnan(round.worst)) {
    std::printf("%.6g,,%.12g\n", round.mean, round.result);
  } else {
    std::printf("%.6g,%.6g,%.12g\n", round.mean, round.worst, round.result);
  }
}

/// The median round.
Round median_round(Workload& workload) {
  std::vector<Round> rounds;
  for (int i = 0; i < 5; ++i) rounds.push_back(workload.round());
  std::ranges::sort(rounds, {}, &Round::mean);
  return rounds[rounds.size() / 2];
}

int run(const std::vector<std::string>& arguments) {
  std::vector<Workload> all = workloads();
  const std::string first = arguments.empty() ? "" : arguments[0];
  const std::regex wanted(first);
  std::puts("workload,mean_ns,worst_ns,result");
  for (Workload& workload : all) {
    if (!std::regex_search(workload.name(), wanted)) continue;
    workload.start();
    std::printf("%s,", workload.name().c_str());
    print(median_round(workload));
    workload.stop();
  }
  return 0;
}

}  // namespace
}  // namespace limitcurve::bench

int main(int argc, char** argv) {
  try {
    return limitcurve::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "finger_bench: %s\n", error.what());
    return 2;
  }
}
