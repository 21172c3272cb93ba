// SPDX-License-Identifier: MIT
// How wrong the models are. Each figure has two witnesses: a closed form or the literature, and brute force here.
#include "limitcurve/validate/validate.hpp"
#include "tests/limitcurve/shared.hpp"
#include "tests/superellipse.hpp"

namespace limitcurve::test {

namespace {

/// Extremes of model radius/exact radius, and its mean square, by plain counting over CORs from 0 on.
struct Counted {
  double over = 0.0;
  double under = 0.0;
  double rms = 0.0;
};

template <class Model, class Cor>
Counted count_errors(const Model& model, const PressureLaw& law, int steps, const Cor& cor) {
  const double m0 = law.moment_ratio();
  Counted counted;
  double squares = 0.0;
  double last_angle = 0.5 * std::numbers::pi;
  double last_error = 0.0;
  for (int i = 0; i < steps; ++i) {
    const UnitForces<double> forces = law.forces(cor((i + 0.5) / steps));
    const double error = 1.0 / model.gauge({forces.force, forces.moment}) - 1.0;
    counted.over = std::max(counted.over, error);
    counted.under = std::max(counted.under, -error);
    const double angle = std::atan2(forces.moment / m0, forces.force);
    squares += 0.5 * (error * error + last_error * last_error) * (last_angle - angle);
    last_angle = angle;
    last_error = error;
  }
  counted.rms = std::sqrt(squares / (0.5 * std::numbers::pi));
  return counted;
}

TEST(CurveError, OfTheEllipseIsAsPublished) {
  for (const auto& [name, over] :
       {std::pair{"flat-punch", 8.26}, {"uniform", 7.04}, {"hertz", 6.38}, {"parabolic", 5.97}}) {
    const ExactCurve exact(parse_law(name));
    const CurveError error = curve_error(Ellipse::through_intercepts(exact.moment_ratio()), exact);
    EXPECT_NEAR(100.0 * error.max_over_estimate, over, 0.005) << name;
    EXPECT_LE(error.max_under_estimate, 1e-15) << name;
    EXPECT_EQ(error.max_error, error.max_over_estimate) << name;
  }
}

/// Towards the ends the COR of the ellipse is off by f′(0) m₀ and by 2m₀²/⟨ρ²⟩: for (1−ρ²)ⁿ (n + 3/2)m₀², 2(n + 2)m₀².
TEST(CurveError, OfTheEllipseInTheCentreOfRotation) {
  for (const double n : {-0.5, 0.0, 0.5, 1.0, 3.0}) {
    const ExactCurve exact(power(n));
    const double m0 = exact.moment_ratio();
    const CurveError error = curve_error(Ellipse::through_intercepts(m0), exact);
    EXPECT_NEAR(error.min_cor_ratio, (n + 1.5) * m0 * m0, 1e-8) << n;
    EXPECT_NEAR(error.max_cor_ratio, 2.0 * (n + 2.0) * m0 * m0, 1e-8) << n;
    EXPECT_NEAR(error.max_cor_error, 2.0 * (n + 2.0) * m0 * m0 - 1.0, 1e-8) << n;
  }
}

/// ∫ ρʲ (1 − ρᵏ)^{1/k} dρ.
double xydas_kao_moment(double k, double j) {
  return std::beta((j + 1.0) / k, 1.0 / k + 1.0) / k;
}

// A pressure that is infinite at the centre: the true COR over that of the wrench on an ellipse falls as
// 1/log(1/s).
TEST(CurveError, OfTheCentreOfRotationHasNoBoundWhereThePressureIsInfinite) {
  for (const char* name : {"uniform-wear", "mix:0.1*uniform-wear+0.9*hertz"}) {
    const ExactCurve exact(parse_law(name));
    const Ellipse ellipse = Ellipse::through_intercepts(exact.moment_ratio());
    const auto ratio = [&](double s) { return ellipse.along(exact.wrench(SlipTwist::about_cor(s))).normal.cor() / s; };
    EXPECT_GT(ratio(1e-40) / ratio(1e-20), 1.5) << name;
    EXPECT_GT(ratio(1e-80) / ratio(1e-40), 1.7) << name;
    EXPECT_EQ(curve_error(ellipse, exact).max_cor_error, inf) << name;
    EXPECT_NEAR(curve_error(exact, exact).max_cor_ratio, 1.0, 1e-12) << name;
    EXPECT_EQ(pade_model(exact).force_cor(), 0.0) << name;
    EXPECT_EQ(curve_error(pade_model(exact), exact).max_error, inf) << name;
  }
}

TEST(CurveError, DoesNotDependOnUnitsOfLength) {
  const auto error_of = [](const Law& law) {
    return curve_error(Ellipse::through_intercepts(law->moment_ratio()), ExactCurve(law));
  };
  const CurveError metre = error_of(gaussian(1.0));
  for (const double sigma : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const CurveError error = error_of(gaussian(sigma));
    EXPECT_NEAR(error.max_over_estimate, metre.max_over_estimate, 1e-8) << sigma;
    EXPECT_NEAR(error.rms_error, metre.rms_error, 1e-8) << sigma;
    EXPECT_NEAR(error.max_cor_error, 0.5 * std::numbers::pi - 1.0, 1e-9) << sigma;
    EXPECT_NEAR(error.min_cor_ratio, 0.25 * std::numbers::pi, 1e-9) << sigma;
  }
  for (const double k : {0.1, 0.09, 0.07, 0.05, 0.03, 0.01}) {
    const double load = 2.0 * xydas_kao_moment(k, 1.0);
    const double m0 = 2.0 * xydas_kao_moment(k, 2.0) / load;
    const CurveError error = error_of(xydas_kao(k));
    const double near_spin = m0 * xydas_kao_moment(k, 0.0) / load;
    EXPECT_NEAR(error.max_cor_ratio / near_spin, 1.0, 1e-9) << k;
  }
}

// The same: where the normals turn at once, rays even in them lie far from each other, and the mean was off by 6e-3.
TEST(CurveError, MeanIsRightToWhatItStates) {
  for (const double k : {0.01, 0.1, 1.0}) {
    const Law law = xydas_kao(k);
    const ExactCurve exact(law);
    const double m0 = exact.moment_ratio();
    const Ellipse model = Ellipse::through_intercepts(m0);
    const Counted counted =
        count_errors(model, *law, 20000, [&](double u) { return m0 * std::pow(10.0, -30.0 + 50.0 * u); });
    EXPECT_NEAR(curve_error(model, exact).rms_error, counted.rms, 1e-6) << k;
  }
}

TEST(CurveError, IsWhatCountingFinds) {
  for (const char* name : {"hertz", "uniform", "flat-punch", "cone"}) {
    const Law law = parse_law(name);
    const ExactCurve exact(law);
    const double m0 = exact.moment_ratio();
    const auto check = [&](const char* what, const auto& model) {
      const CurveError error = curve_error(model, exact);
      const Counted counted =
          count_errors(model, *law, 40000, [](double u) { return std::tan(0.5 * std::numbers::pi * u); });
      EXPECT_NEAR(error.max_over_estimate, counted.over, 1e-7) << name << ' ' << what;
      EXPECT_NEAR(error.max_under_estimate, counted.under, 1e-7) << name << ' ' << what;
      EXPECT_NEAR(error.rms_error, counted.rms, 1e-5 * counted.rms + 1e-12) << name << ' ' << what;
      // Refined: never less than what counting finds.
      EXPECT_GE(error.max_over_estimate, counted.over - 1e-12) << name << ' ' << what;
    };
    check("ellipse", Ellipse::through_intercepts(m0));
    check("superellipse", Superellipse{1.0, m0, 1.6});
  }
}

/// A box meets the diagonal at √2, the exact curve there at a little less than 1: some 1.5 times too strong.
TEST(CurveError, OfTheBox) {
  const ExactCurve exact(hertz());
  const double m0 = exact.moment_ratio();
  const UnitWrench diagonal = exact.along({1.0, m0}).wrench;
  const CurveError error = curve_error(box(1.0, m0), exact);
  EXPECT_NEAR(error.max_over_estimate, 1.0 / diagonal.force - 1.0, 1e-8);
  EXPECT_NEAR(error.max_over_estimate, 0.5027, 5e-5);
  EXPECT_EQ(error.max_cor_error, inf);
  EXPECT_EQ(error.min_cor_ratio, 0.0);
  EXPECT_EQ(error.max_cor_ratio, inf);
}

/// Zhuravlev's two numbers for Hertz, written out; the model's twist on the ray of an exact wrench by bisection.
TEST(CurveError, OfThePadeModelIsThatOfItsOwnTwist) {
  const double m0 = 3.0 * std::numbers::pi / 16.0;
  const auto model = [&](double s) {
    return UnitWrench{s / (s + 8.0 / (3.0 * std::numbers::pi)), m0 / (1.0 + 15.0 * std::numbers::pi / 16.0 * s)};
  };
  const ExactCurve curve(hertz());
  double worst = 0.0;
  double least = 1.0;
  double most = 1.0;
  double force = 0.0;
  double moment = 0.0;
  for (int i = -120; i <= 120; ++i) {
    const double s = std::pow(10.0, i / 40.0);
    const UnitWrench truth = curve.wrench(SlipTwist::about_cor(s));
    double low = 0.0;
    double high = 1e6;
    for (int j = 0; j < 100; ++j) {
      const double middle = 0.5 * (low + high);
      (model(middle).force * truth.moment < model(middle).moment * truth.force ? low : high) = middle;
    }
    worst = std::max(worst, 1.0 - model(low).force / truth.force);
    least = std::min(least, low / s);
    most = std::max(most, low / s);
    force = std::max(force, truth.force - model(s).force);
    moment = std::max(moment, (truth.moment - model(s).moment) / m0);
  }
  const CurveError error = curve_error(pade_model(curve), curve);
  EXPECT_NEAR(error.max_error, worst, 2e-4);
  EXPECT_NEAR(error.min_cor_ratio, least, 2e-4);
  EXPECT_NEAR(error.max_cor_ratio, most, 2e-4);
  EXPECT_EQ(error.max_over_estimate, 0.0);
  EXPECT_NEAR(error.max_error, 0.418, 5e-4);
  EXPECT_NEAR(error.max_cor_error, 0.200, 5e-4);
  EXPECT_NEAR(force, 0.34, 5e-3);
  EXPECT_NEAR(moment, 0.39, 5e-3);
}

/// A model scaled by 1.1 is 10 % too strong on every ray; one scaled by 0.9 is 10 % too weak.
TEST(CurveError, OfAScaledCurveIsTheScale) {
  const Ellipse exact(1.0, 0.6);
  const CurveError strong = curve_error(Ellipse(1.1, 0.66), exact);
  EXPECT_NEAR(strong.max_over_estimate, 0.1, 1e-14);
  EXPECT_NEAR(strong.rms_error, 0.1, 1e-14);
  EXPECT_EQ(strong.max_under_estimate, 0.0);
  EXPECT_NEAR(strong.max_cor_error, 0.0, 1e-14);
  const CurveError weak = curve_error(Ellipse(0.9, 0.54), exact);
  EXPECT_NEAR(weak.max_under_estimate, 0.1, 1e-14);
  EXPECT_EQ(weak.max_over_estimate, 0.0);
  EXPECT_NEAR(weak.max_error, 0.1, 1e-14);
}

/// Superellipse against ellipse is known on the diagonal: 2^{1/2 − 1/n}.
TEST(CurveError, OfASuperellipseAgainstAnEllipse) {
  const CurveError error = curve_error(Superellipse{1.0, 0.6, 2.5}, Ellipse(1.0, 0.6));
  EXPECT_NEAR(error.max_over_estimate, std::pow(2.0, 0.5 - 1.0 / 2.5) - 1.0, accuracy::curve_error);
}

/// Inside, and no other ellipse inside has a smaller largest error: of those nearby each sticks
/// out or is weaker somewhere.
TEST(InnerEllipse, IsInsideWithTheLeastLargestError) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> factor(-0.02, 0.02);
  for (const char* name : {"hertz", "uniform", "flat-punch", "gaussian:sigma=0.4", "power:n=1000", "xydas-kao:k=0.2"}) {
    const Law law = parse_law(name);
    const double m0 = law->moment_ratio();
    std::vector<UnitWrench> points{{1.0, 0.0}, {0.0, m0}};
    for (int i = 0; i < 4000; ++i) {
      const UnitForces<double> forces = law->forces(m0 * std::tan(0.5 * std::numbers::pi * (i + 0.5) / 4000));
      points.push_back({forces.force, forces.moment});
    }
    // Largest and smallest model radius/exact radius.
    const auto extremes = [&](const Ellipse& ellipse) {
      std::pair<double, double> result{0.0, inf};
      for (const UnitWrench& point : points) {
        const double ratio = 1.0 / ellipse.gauge(point);
        result = {std::max(result.first, ratio), std::min(result.second, ratio)};
      }
      return result;
    };
    const Ellipse inner = inner_ellipse(ExactCurve(law));
    const double weakest = extremes(inner).second;
    EXPECT_LE(extremes(inner).first, 1.0 + 1e-12) << name;
    for (int i = 0; i < 300; ++i) {
      const double size = std::pow(10.0, -3.0 * i / 300.0);
      const Ellipse other(inner.force_max() * std::exp(size * factor(random)),
                          inner.moment_max() * std::exp(size * factor(random)));
      const auto [strong, weak] = extremes(other);
      EXPECT_TRUE(strong > 1.0 + 1e-7 || weak < weakest + 1e-6)
          << name << ' ' << other.force_max() << ' ' << other.moment_max();
    }
  }
}

/// Where the curve lies within the ellipse through the intercepts, that ellipse shrunk by its
/// over-estimate touches it, and the ends are the weakest. Hertz: 1/1.0638.
TEST(InnerEllipse, IsTheOneThroughTheInterceptsShrunk) {
  for (const char* name : {"hertz", "uniform", "flat-punch", "parabolic", "cone", "gaussian:sigma=0.4"}) {
    const ExactCurve exact(parse_law(name));
    const Ellipse inner = inner_ellipse(exact);
    const double shrunk =
        1.0 / (1.0 + curve_error(Ellipse::through_intercepts(exact.moment_ratio()), exact).max_over_estimate);
    EXPECT_NEAR(inner.force_max(), shrunk, 1e-7) << name;
    EXPECT_NEAR(inner.moment_max() / exact.moment_ratio(), shrunk, 1e-7) << name;
    EXPECT_NEAR(curve_error(inner, exact).max_under_estimate, 1.0 - shrunk, 1e-7) << name;
  }
  EXPECT_NEAR(inner_ellipse(ExactCurve(hertz())).force_max(), 0.940, 5e-5);
}

TEST(InnerEllipse, OfAnEllipseIsItself) {
  const Ellipse inner = inner_ellipse(Ellipse(1.3, 0.4));
  EXPECT_NEAR(inner.force_max(), 1.3, 1e-7);
  EXPECT_NEAR(inner.moment_max(), 0.4, 1e-7);
  // Inside a curve that bulges out of the ellipse: the ellipse through the intercepts.
  const Ellipse within = inner_ellipse(Superellipse{1.0, 0.5, 3.0});
  EXPECT_NEAR(within.force_max(), 1.0, 1e-7);
  EXPECT_NEAR(within.moment_max(), 0.5, 1e-7);
}

}  // namespace

}  // namespace limitcurve::test
