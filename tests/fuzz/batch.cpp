// SPDX-License-Identifier: MIT
#include "godobject/batch/batch.hpp"
#include "tests/fuzz/any_finger.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace limitcurve;
using namespace limitcurve::godobject;

namespace {

/// Moves the contacts anywhere.
template <class Real>
void move_all(fuzz::Bytes& bytes, BasicContactArrays<Real>& arrays) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const auto flags = bytes.take<std::uint8_t>();
    const auto raw = [&](unsigned bit) { return ((flags >> bit) & 1U) != 0; };
    const double last_angle = double{arrays.twist()[i]};
    arrays.x()[i] = static_cast<Real>(fuzz::any_double(bytes, raw(0), 0.02));
    if (raw(1)) arrays.y()[i] = static_cast<Real>(fuzz::any_double(bytes, raw(0), 0.02));
    arrays.depth()[i] = static_cast<Real>(fuzz::any_double(bytes, raw(2), 0.004));
    arrays.twist()[i] = static_cast<Real>(raw(3) ? fuzz::any_double(bytes, true, 1.0)
                                                 : last_angle + fuzz::any_double(bytes, raw(4), 3.0));
  }
}

/// No NaN, no proxy that moves while it sticks, and none that moves away from the finger.
template <class Real>
void run(fuzz::Bytes bytes) {
  const auto chosen = fuzz::any_curve<Real>(bytes);
  const FingerParameters parameters = fuzz::any_parameters(bytes);
  const std::size_t count = 1 + bytes.take<std::uint8_t>() % 11U;
  std::vector<BasicBatch<Real>> batch;
  if (fuzz::complaint_of([&] { batch.emplace_back(chosen.curve, parameters, chosen.projection); })) return;
  const bool has_torsion = parameters.mu > 0.0 && parameters.mu_r.value_or(1.0) > 0.0;
  BasicContactArrays<Real> arrays(count);
  const BasicContactBatch<Real> now = arrays.batch();
  while (bytes.left() > 0) {
    move_all(bytes, arrays);
    BasicContactArrays<Real> before_arrays = arrays;
    const BasicContactBatch<Real> before = before_arrays.batch();
    batch.front().step(now);
    for (std::size_t i = 0; i < count; ++i) {
      for (const Real value : {now.proxy_x[i], now.proxy_y[i], now.proxy_angle[i], now.fx[i], now.fy[i], now.moment[i],
                               now.search_start[i], now.search_rate[i]}) {
        fuzz::require(std::isfinite(value), "a number of a batch is not finite");
      }
      if (now.state[i] == ContactState::free || before.force_slides[i] == ContactState::free) continue;
      if (now.state[i] == ContactState::stick || now.state[i] == ContactState::invalid) {
        fuzz::require(now.proxy_x[i] == before.proxy_x[i] && now.proxy_y[i] == before.proxy_y[i],
                      "a proxy that sticks slides");
        fuzz::require(!has_torsion || now.proxy_angle[i] == before.proxy_angle[i], "a proxy that sticks turns");
      } else {
        fuzz::require(now.fx[i] * (now.proxy_x[i] - before.proxy_x[i]) <= Real(0), "a slip that gains energy along x");
        fuzz::require(now.fy[i] * (now.proxy_y[i] - before.proxy_y[i]) <= Real(0), "a slip that gains energy along y");
        fuzz::require(now.moment[i] * (now.proxy_angle[i] - before.proxy_angle[i]) <= Real(0),
                      "a slip that gains energy in the twist");
      }
    }
  }
}

}  // namespace

/// A batch of contacts in both precisions with arbitrary bits. Tests compare it with fingers on ordinary input.
static const fuzz::Target batch_target("batch", [](std::string_view input) {
  run<double>(fuzz::Bytes(input));
  run<float>(fuzz::Bytes(input));
});
