// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/batch/batch.hpp"
#include "tests/godobject/scene.hpp"

/// What the tests of batches share.
namespace limitcurve::godobject::test {

template <class Real>
struct Case {
  std::string name;
  BasicFingerCurve<Real> curve;
  FingerParameters with;
  Projection projection = Projection::closest_point;
};

/// Every curve and projection, and every parameter that changes the step.
template <class Real>
std::vector<Case<Real>> cases() {
  const double m0 = hertz()->moment_ratio();
  const auto table = BasicTable<Real>::build(hertz(), 1e-6);
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  soft.mu_dynamic = 0.5;
  FingerParameters without_torsion = parameters();
  without_torsion.mu_r = 0.0;
  FingerParameters with_coefficients = parameters();
  with_coefficients.mu_r = 0.002;
  with_coefficients.mu_r_dynamic = 0.001;
  FingerParameters growing = with_coefficients;
  growing.gamma = 0.259;
  std::vector<Case<Real>> result{
      {"box", box(1.0, m0), parameters()},
      {"table, stiff twist", table, parameters(0.6, 0.005, 1000.0, 0.4)},
      {"table, soft twist", table, parameters(0.6, 0.005, 1000.0, 0.001)},
      {"table, no torsion", table, without_torsion},
      {"table, two moment coefficients", table, with_coefficients},
      {"box, two moment coefficients", box(1.0, m0), with_coefficients},
      {"table, moment coefficients that grow with the load", table, growing},
      {"ellipse, moment coefficients that grow with the load", ellipse, growing, Projection::radial}};
  // A table with several cells in a bucket.
  const auto searched = BasicTable<Real>::build(uniform_wear(), sizeof(Real) == sizeof(float) ? 1e-6 : 1e-10);
  EXPECT_GT(searched.view().table.halvings, 0);
  result.push_back({"table with a search", searched, parameters()});
  for (const Projection projection : projections) {
    const std::string name(to_string(projection));
    result.push_back({"table, " + name, table, parameters(), projection});
    result.push_back({"table, soft finger, " + name, table, soft, projection});
    result.push_back({"ellipse, " + name, ellipse, parameters(), projection});
    result.push_back({"ellipse, soft finger, " + name, ellipse, soft, projection});
  }
  return result;
}

template <class Real>
void move_all(BasicContactArrays<Real>& arrays, Random& random, double longest) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const double stride = random.logarithmic(1e-7, longest);
    arrays.x()[i] += static_cast<Real>(random.uniform(-stride, stride));
    arrays.y()[i] += static_cast<Real>(random.uniform(-stride, stride));
    arrays.twist()[i] += static_cast<Real>(random.uniform(-200.0, 200.0) * stride);
    arrays.depth()[i] = static_cast<Real>(random.uniform(-0.0002, 0.003));
  }
}

/// Gives the contacts of `to` the places of those of `from`.
template <class From, class To>
void copy_places(BasicContactArrays<From>& from, BasicContactArrays<To>& to) {
  std::ranges::copy(from.x(), to.x().begin());
  std::ranges::copy(from.y(), to.y().begin());
  std::ranges::copy(from.twist(), to.twist().begin());
  std::ranges::copy(from.depth(), to.depth().begin());
}

/// All numbers of a batch that a step writes, one contact after the other.
template <class Real>
std::vector<Real> written(const BasicContactBatch<Real>& batch) {
  std::vector<Real> result;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    for (const auto& array : {batch.proxy_x, batch.proxy_y, batch.proxy_angle, batch.fx, batch.fy, batch.moment,
                              batch.search_start, batch.search_rate}) {
      result.push_back(array[i]);
    }
    result.push_back(static_cast<Real>(batch.state[i]));
  }
  return result;
}
inline constexpr std::size_t numbers_per_contact = 9;

}  // namespace limitcurve::godobject::test
