// SPDX-License-Identifier: MIT
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "patch_cases.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace limitcurve::test {
namespace {

// One contact made in several ways, at random sizes, places, orthotropic friction and twists: a rectangle, the polygon of its corners and
// an image of ones; a disc and the curve of its law; the largest moments in closed form.
TEST(PatchStudy, OneContactMadeInSeveralWays) {
  std::mt19937_64 random(500);
  const auto uniform_in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const auto of_any_size = [&](double low, double high) { return low * std::pow(high / low, uniform_in(0.0, 1.0)); };
  const std::vector<Law> laws{hertz(), uniform(), flat_punch(), parabolic(), cone()};
  std::vector<ExactCurve> curves;
  for (const Law& law : laws) curves.emplace_back(law);
  const int cases = study_cases(500);
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const auto columns = static_cast<std::size_t>(uniform_in(1.0, 9.0));
    const auto rows = static_cast<std::size_t>(uniform_in(1.0, 9.0));
    const double pixel = of_any_size(1e-4, 1e-2);
    const double x = pixel * static_cast<double>(columns);
    const double y = pixel * static_cast<double>(rows);
    const double mx = i % 2 == 0 ? 1.0 : of_any_size(0.1, 10.0);
    const double my = i % 2 == 0 ? 1.0 : of_any_size(0.1, 10.0);
    const Patch whole = Patch::rectangle(x, y).orthotropic(mx, my);
    const std::vector<Patch> same{Patch::polygon(rectangle(x, y)).orthotropic(mx, my),
                                  Patch::image(std::vector<double>(columns * rows, 1.0), columns, pixel).orthotropic(mx, my)};
    if (i % 2 == 0) {
      const double diagonal = std::hypot(x, y);
      EXPECT_NEAR(whole.moment_ratio() / (diagonal / 6.0 + (x * x / y * std::asinh(y / x) + y * y / x * std::asinh(x / y)) / 12.0), 1.0,
                  1e-13);
    }
    const std::size_t law = static_cast<std::size_t>(i) % laws.size();
    const double a = of_any_size(1e-3, 1e-1);
    const Patch disc = Patch::ellipse(laws[law], a, a);
    const double b = a * uniform_in(0.2, 1.0);
    const double perimeter = 4.0 * a * boost::math::ellint_2(std::sqrt(1.0 - b * b / (a * a)));
    EXPECT_NEAR(Patch::ellipse(laws[law], a, b).moment_ratio() / (laws[law]->moment_ratio() * perimeter / (2.0 * std::numbers::pi)), 1.0,
                1e-11);
    for (int j = 0; j < 20; ++j) {
      const double angle = uniform_in(-std::numbers::pi, std::numbers::pi);
      const double cor = of_any_size(1e-3, 1e3) * std::max(x, y);
      const PatchTwist twist = about({cor * std::cos(angle), cor * std::sin(angle)}, uniform_in(-2.0, 2.0));
      const PatchFriction expected = whole.about_origin(twist);
      for (const Patch& other : same) {
        const PatchFriction found = other.about_origin(twist);
        EXPECT_LE(difference(found, expected, whole.moment_ratio()), found.error + expected.error + 1e-13);
      }
      const double round_cor = of_any_size(1e-3, 1e3);
      const PatchTwist slip = about({a * round_cor * std::cos(angle), a * round_cor * std::sin(angle)}, twist.omega);
      const UnitWrench on_curve = curves[law].wrench(SlipTwist::about_cor(round_cor));
      const PatchWrench on_disc = disc.wrench(slip);
      EXPECT_NEAR(std::hypot(on_disc.fx, on_disc.fy), on_curve.force, 1e-11) << laws[law]->name();
      EXPECT_NEAR(on_disc.moment, std::copysign(a * on_curve.moment, slip.omega), 1e-11 * a) << laws[law]->name();
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
