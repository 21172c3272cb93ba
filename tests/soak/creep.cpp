// SPDX-License-Identifier: MIT
// Held fingers do not creep: a finger that trembles within the limit, or stays where it slipped last, keeps its proxy to the last bit.
//     creep [STEPS]
// A finger and a batch of each precision, STEPS (ten million) each. Exits with 1 if a proxy moves.
#include "godobject/batch/batch.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "tests/soak/random_bits.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace limitcurve::godobject {
namespace {

FingerParameters parameters() {
  return {.mu = 0.6, .radius_law = RadiusLaw::constant(0.005), .stiffness = 1000.0, .twist_stiffness = 0.04};
}

/// Up to 0.8 of the limit at the least load, which is 0.96 N and 0.8·0.589·1.2 N·5 mm.
struct Trembling {
  explicit Trembling(soak::RandomBits& random) {
    const std::uint64_t bits = random.bits();
    const auto part = [&](unsigned shift) { return static_cast<double>((bits >> shift) & 0xffffU) / 65536.0 - 0.5; };
    x = 0.1 + 0.0009 * part(0);
    y = 0.2 + 0.0009 * part(16);
    depth = 0.002 + 0.0004 * part(32);
    twist = 3.0 + 0.05 * part(48);
  }
  double x, y, depth, twist;
};

std::uint64_t moved_of_fingers(std::uint64_t steps) {
  const SoftFinger fresh(Table::build(hertz(), 1e-6), parameters());
  const auto at = [](double x, double y, double depth) { return Contact{{x, y, 0.0}, Eigen::Vector3d::UnitZ(), depth}; };
  SoftFinger trembling = fresh;
  trembling.update(at(0.1, 0.2, 0.002), 3.0);
  SoftFinger held = fresh;
  held.update(at(0.1, 0.2, 0.002), 3.0);
  if (held.update(at(0.104, 0.2, 0.002), 3.5).state != ContactState::slip) return steps;
  const FingerState rest = trembling.state();
  const FingerState slid = held.state();
  soak::RandomBits random(7);
  std::uint64_t moved = 0;
  for (std::uint64_t i = 0; i < steps; ++i) {
    const Trembling now(random);
    trembling.update(at(now.x, now.y, now.depth), now.twist);
    held.update(at(0.104, 0.2, 0.002), 3.5);
    for (const auto& [finger, before] : {std::pair(&trembling, &rest), std::pair(&held, &slid)}) {
      const FingerState& state = finger->state();
      moved += state.output.state != ContactState::stick || state.output.proxy != before->output.proxy ||
               state.output.angle != before->output.angle;
    }
  }
  return moved;
}

template <class Real>
std::uint64_t moved_of_batch(std::uint64_t steps) {
  const BasicBatch<Real> batch(BasicTable<Real>::build(hertz(), 1e-6), parameters());
  constexpr std::size_t count = 8;
  constexpr std::size_t trembling = 4;  // as many; the others are held where they slipped
  BasicContactArrays<Real> arrays(count);
  const BasicContactBatch<Real> contacts = arrays.batch();
  std::ranges::fill(arrays.x(), Real(0.1));
  std::ranges::fill(arrays.y(), Real(0.2));
  std::ranges::fill(arrays.twist(), Real(3));
  std::ranges::fill(arrays.depth(), Real(0.002));
  batch.step(contacts);
  for (std::size_t i = trembling; i < count; ++i) {
    arrays.x()[i] += Real(0.001) * static_cast<Real>(i);
    arrays.twist()[i] += Real(0.1) * static_cast<Real>(i);
  }
  batch.step(contacts);
  if (std::ranges::count(contacts.state, ContactState::slip) != static_cast<int>(count - trembling)) return steps;
  const std::vector<Real> x(contacts.proxy_x.begin(), contacts.proxy_x.end());
  const std::vector<Real> y(contacts.proxy_y.begin(), contacts.proxy_y.end());
  const std::vector<Real> angle(contacts.proxy_angle.begin(), contacts.proxy_angle.end());
  soak::RandomBits random(7);
  std::uint64_t moved = 0;
  for (std::uint64_t i = 0; i < steps; ++i) {
    for (std::size_t k = 0; k < trembling; ++k) {
      const Trembling now(random);
      arrays.x()[k] = static_cast<Real>(now.x);
      arrays.y()[k] = static_cast<Real>(now.y);
      arrays.twist()[k] = static_cast<Real>(now.twist);
      arrays.depth()[k] = static_cast<Real>(now.depth);
    }
    batch.step(contacts);
    for (std::size_t k = 0; k < count; ++k) {
      const bool rests = contacts.state[k] == ContactState::stick && contacts.proxy_x[k] == x[k] && contacts.proxy_y[k] == y[k] &&
                         contacts.proxy_angle[k] == angle[k];
      moved += rests ? 0U : 1U;
    }
  }
  return moved;
}

}  // namespace
}  // namespace limitcurve::godobject

int main(int argc, char** argv) {
  using namespace limitcurve::godobject;
  const std::uint64_t steps = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000'000;
  const std::uint64_t fingers = moved_of_fingers(steps);
  const std::uint64_t doubles = moved_of_batch<double>(steps);
  const std::uint64_t floats = moved_of_batch<float>(steps);
  std::printf("%llu steps; moved: fingers %llu, batch of double %llu, of float %llu\n", static_cast<unsigned long long>(steps),
              static_cast<unsigned long long>(fingers), static_cast<unsigned long long>(doubles), static_cast<unsigned long long>(floats));
  return steps > 0 && fingers + doubles + floats == 0 ? 0 : 1;
}
