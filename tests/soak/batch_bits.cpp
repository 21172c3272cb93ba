// SPDX-License-Identifier: MIT
// Random batches of contacts, and a hash of the bits of all that comes out for each boundary: what scripts/bit_identity compares
// between compilers, vector lengths and processors. Arguments: rounds of 1001 contacts, and a folder of tables that soak wrote.
#include "godobject/batch.hpp"
#include "godobject/float_batch.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/quartic.hpp"
#include "tests/soak/boundaries.hpp"
#include "tests/soak/random_bits.hpp"

#include <array>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

constexpr std::size_t count = 1001;  // no multiple of a vector's length

template <class Real, class Batch, class Boundary, class Projection>
void print_bits(const char* name, const Boundary& boundary, Projection projection, int rounds) {
  FingerParameters parameters;
  parameters.mu = 0.6;
  const Friction friction(boundary, parameters, projection);
  std::array<std::vector<Real>, 12> arrays;
  for (auto& array : arrays) array.assign(count, Real(0));
  auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays;
  start.assign(count, Real(-2));
  soak::RandomBits random(5);
  std::uint64_t hash = 1;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      const double stride = random.scale(-24, -7);
      x[i] += static_cast<Real>(stride * random.uniform(-1.0, 1.0));
      y[i] += static_cast<Real>(stride * random.uniform(-1.0, 1.0));
      const double turn = random.scale(-17, -1);
      angle[i] += static_cast<Real>(turn * random.uniform(-1.0, 1.0));
      depth[i] = static_cast<Real>(random.uniform(-0.0005, 0.003));
    }
    step(friction, Batch{x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment});
    for (std::size_t array = 4; array < arrays.size(); ++array) {
      for (const Real value : arrays[array]) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(static_cast<double>(value))) * 0x9fb21c651e98df25U;
        hash ^= hash >> 32U;
      }
    }
  }
  std::printf("bits batch %s constant-radius %016" PRIx64 "\n", name, hash);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 100;
  const Ellipse ellipse = Ellipse::through_intercepts(0.5890486225480862);
  print_bits<double, ContactBatch>("ellipse-radial", ellipse, Radial{}, rounds);
  print_bits<double, ContactBatch>("ellipse-closest-point", ellipse, ClosestPoint{}, rounds);
  print_bits<double, ContactBatch>("box-closest-point", box(1.0, 0.5890486225480862), ClosestPoint{}, rounds);
  print_bits<double, ContactBatch>("quartic-closest-point", Quartic::through_intercepts(0.5890486225480862, 3.142), ClosestPoint{}, rounds);
  print_bits<float, FloatContactBatch>("float-ellipse-radial", ellipse, Radial{}, rounds);
  print_bits<float, FloatContactBatch>("float-box-closest-point", box(1.0, 0.5890486225480862), ClosestPoint{}, rounds);
  if (argc > 2) {
    const soak::Boundaries boundaries{std::filesystem::path(argv[2])};
    soak::RandomBits random(1);
    boundaries.visit(1, random, [&](const auto& boundary) {
      using Boundary = std::decay_t<decltype(boundary)>;
      if constexpr (std::is_same_v<Boundary, Table>) {
        print_bits<double, ContactBatch>("table-closest-point", boundary, ClosestPoint{}, rounds);
        print_bits<float, FloatContactBatch>(
            "float-table-closest-point", FloatTable(boundary, std::max(1e-6, 4.0 * boundary.certified_error())), ClosestPoint{}, rounds);
      }
    });
  }
  return 0;
}
