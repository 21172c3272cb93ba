// SPDX-License-Identifier: MIT
#include "fit/internal/contact_residuals.hpp"

#include "tests/fit/synthetic.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace limitcurve::fit::internal {
namespace {

struct Case {
  const char* name;
  std::unique_ptr<UnitCurve> (*make)();
};

const std::vector<Case> cases{
    {"ellipse", make_ellipse},
    {"flexible", make_flexible},
    {"hertz", [] { return make_law(*hertz()); }},
    {"gaussian", [] { return make_law(*gaussian(1.0)); }},
    {"power", [] { return make_family(ShapeFamily::power(), "n", 0.5); }},
    {"xydas-kao", [] { return make_family(ShapeFamily::xydas_kao(), "k", 2.0); }},
};

std::vector<WeightedSample> some_samples(Random& random) {
  std::vector<WeightedSample> samples;
  for (int i = 0; i < 40; ++i) {
    const double angle = random.uniform(0.0, 1.5707963);
    const double radius = random.uniform(0.8, 1.2);
    const double load = random.uniform(0.5, 5.0);
    samples.push_back({20.0 * load * radius * std::cos(angle), 30.0 * load * radius * std::sin(angle), 20.0 * load,
                       30.0 * load, std::log(load)});
  }
  // On the axes, where the closest point may be an end of the curve.
  samples.push_back({20.0, 0.0, 20.0, 30.0, 0.0});
  samples.push_back({0.0, 30.0, 20.0, 30.0, 0.0});
  return samples;
}

std::vector<double> some_parameters(const UnitCurve& curve, Random& random) {
  std::vector<double> parameters{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
  if (!curve.shape_name().empty()) {
    parameters.push_back(curve.low() + (curve.high() - curve.low()) * random.uniform(0.2, 0.8));
  }
  parameters.push_back(random.uniform(0.0, 0.05));
  return parameters;
}

/// The least distance of a sample from the curve, its limits `force` and `moment`, by a scan.
double scanned(const UnitCurve& curve, const WeightedSample& sample, double force, double moment) {
  double least = 1e300;
  for (int k = 0; k <= 4000; ++k) {
    const PlanePoint point = curve.at(k / 4000.0).point;
    least = std::min(least, std::hypot(sample.force - force * point.x, sample.moment - moment * point.y));
  }
  return least;
}

// Well inside the curve the distance has two minima. A search that returns either makes the cost depend on the path.
TEST(ContactResiduals, AreTheLeastDistanceWhereverTheSearchBegan) {
  for (const Case& item : cases) {
    Random random(12);
    const std::unique_ptr<UnitCurve> curve = item.make();
    std::vector<WeightedSample> samples = some_samples(random);
    for (int i = 0; i < 40; ++i)
      samples.push_back({random.uniform(0.0, 18.0), random.uniform(0.0, 27.0), 20.0, 30.0, 0.0});
    const ContactLayout layout{!curve->shape_name().empty(), true, 0.0};
    const ContactResiduals residuals(samples, *curve, layout);
    const std::vector<double> at = some_parameters(*curve, random);
    for (const double before : {-1.5, 1.5, 0.0}) {
      for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<double> elsewhere = at;
        elsewhere[1] += before;
        double residual = 0.0;
        ASSERT_TRUE(residuals.evaluate(i, elsewhere, residual, nullptr));
        ASSERT_TRUE(residuals.evaluate(i, at, residual, nullptr));
        const double least = scanned(*curve, samples[i], std::exp(at[0]) * samples[i].load_force,
                                     std::exp(at[1] + at.back() * samples[i].log_load) * samples[i].load_moment);
        // The scan's own error is second order in its step where the distance is not small.
        EXPECT_NEAR(std::fabs(residual), least, least > 1.0 ? 1e-3 : 0.05) << item.name << ' ' << i << ' ' << before;
        EXPECT_LE(std::fabs(residual), least + 1e-9) << item.name << ' ' << i << ' ' << before;
      }
    }
  }
}

TEST(ContactResiduals, GradientsAgreeWithDifferences) {
  for (const Case& item : cases) {
    Random random(11);
    const std::unique_ptr<UnitCurve> curve = item.make();
    const std::vector<WeightedSample> samples = some_samples(random);
    const ContactLayout layout{!curve->shape_name().empty(), true, 0.0};
    const ContactResiduals model(samples, *curve, layout);
    for (int trial = 0; trial < 5; ++trial) {
      const std::vector<double> at = some_parameters(*curve, random);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        double residual = 0.0;
        std::vector<double> gradient(layout.size());
        ASSERT_TRUE(model.evaluate(i, at, residual, gradient.data()));
        for (std::size_t j = 0; j < layout.size(); ++j) {
          // Fourth-order central difference.
          constexpr double step = 2e-4;
          const auto shifted = [&](double by) {
            std::vector<double> there = at;
            there[j] += by;
            double value = 0.0;
            model.evaluate(i, there, value, nullptr);
            return value;
          };
          const double difference =
              (8.0 * (shifted(step) - shifted(-step)) - (shifted(2 * step) - shifted(-2 * step))) / (12.0 * step);
          // Residuals are of the size of load_moment, their third derivatives of some hundred times that near the rim.
          EXPECT_NEAR(gradient[j], difference, 1e-6 * samples[i].load_moment)
              << item.name << " sample " << i << " parameter " << j;
        }
      }
    }
  }
}

TEST(ChebyshevCurve, FamiliesFollowTheirLaws) {
  Random random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const bool is_power = trial % 2 == 0;
    const ShapeFamily& family = is_power ? ShapeFamily::power() : ShapeFamily::xydas_kao();
    const double coordinate = random.uniform(family.low(), family.high());
    const Law law = is_power ? power(family.parameter(coordinate)) : xydas_kao(family.parameter(coordinate));
    const ChebyshevCurve curve = family.member(coordinate);
    const double u = trial % 10 < 8 ? random.uniform(0.0, 1.0) : 0.5 + random.uniform(-1e-4, 1e-4);
    const WrenchEstimate exact = law->evaluate((1.0 - u) / u);
    EXPECT_NEAR(curve.moment_ratio(), law->moment_ratio(), 1e-11);
    EXPECT_NEAR(curve.at(u).x, exact.wrench.force, 1e-11) << law->name() << " u = " << u;
    EXPECT_NEAR(curve.at(u).y, exact.wrench.moment / law->moment_ratio(), 1e-11) << law->name() << " u = " << u;
  }
}

}  // namespace
}  // namespace limitcurve::fit::internal
