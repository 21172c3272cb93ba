// SPDX-License-Identifier: MIT
#include "patch_cases.hpp"

namespace limitcurve::test {
namespace {

TEST(PatchImage, IsTheSumOfItsSquaresToItsStatedError) {
  std::mt19937 bits(3);
  const auto uniform = [&bits] { return std::generate_canonical<double, 53>(bits); };
  std::vector<double> dense;
  for (int i = 0; i < 64 * 64; ++i) {
    const double x = (i % 64 - 31.5) / 32.0;
    const double y = (i / 64 - 31.5) / 32.0;
    dense.push_back(std::max(0.0, 1.0 - x * x - y * y) * (0.5 + uniform()));
  }
  std::vector<double> row(64, 0.0);
  for (std::size_t i = 0; i < 8; ++i) row[16 + i] = 1.0;
  const std::vector<double> lone{0, 0, 0, 0, 5, 0, 0, 0, 0};
  const std::vector<double> few{1, 2, 0, 4, 0, 0, 1, 1, 3, 0.5, 0, 2};
  const auto expect = [](const std::vector<double>& pressures, std::size_t columns, double least, double bound) {
    const Patch patch = Patch::image(pressures, columns, 0.0005);
    for (const PatchTwist& twist : twists(patch.radius(), 40, least, 1.0)) {
      EXPECT_LE(stated(patch, twist), bound);
      expect_exact(patch, twist, image_by_squares(pressures, columns, 0.0005, twist), 0.1 * bound);
    }
  };
  expect(dense, 64, -2.0, 1e-3);
  expect(row, 8, -2.0, 0.1);
  expect(lone, 3, -1.0, 0.1);
  expect(few, 4, -1.0, 0.1);
}

/// An even rectangle of full sides (x, y) under orthotropic friction by brute force: an isotropic one of the stretched
/// sides.
PatchFriction stretched_rectangle(double x, double y, double mx, double my, PatchTwist twist) {
  twist = {mx * twist.vx, my * twist.vy, twist.omega};
  PatchFriction friction = polygon_by_triangles(rectangle(my * x, mx * y), twist, {0, 0});
  friction.wrench.fx *= mx;
  friction.wrench.fy *= my;
  return friction;
}

TEST(PatchImage, OfOnesIsTheRectangleWithTheCorOnEdgesCornersAndMiddlesOfPixels) {
  // The middle of an edge is where a pixel's distance to the COR equals half its side: one place decides what is near.
  constexpr std::size_t columns = 3;
  constexpr std::size_t rows = 4;
  constexpr double pixel = 0.001;
  for (const auto& [mx, my] : {std::pair{1.0, 1.2}, {1.0, 1.0}, {0.1, 10.0}, {10.0, 0.3}, {0.7, 0.6}, {2e3, 1e-3}}) {
    const Patch image = Patch::image(std::vector<double>(columns * rows, 1.0), columns, pixel).orthotropic(mx, my);
    for (std::size_t i = 0; i <= 2 * columns; ++i) {
      for (std::size_t j = 0; j <= 2 * rows; ++j) {
        const PatchTwist twist =
            about({0.5 * pixel * (static_cast<double>(i) - columns), 0.5 * pixel * (static_cast<double>(j) - rows)},
                  j % 2 ? 1.0 : -3.0);
        SCOPED_TRACE(testing::Message() << mx << ' ' << my << ": " << i << ' ' << j);
        expect_exact(image, twist, stretched_rectangle(columns * pixel, rows * pixel, mx, my, twist), inf);
      }
    }
  }
}

TEST(PatchImage, UnderAnyRatioOfFrictionKeepsItsStatedError) {
  // Pixels 2e6 times as long as wide: the whole row of pixels is near.
  constexpr std::size_t columns = 40;
  for (const auto& [mx, my] : {std::pair{2.0, 1e-6}, {2e3, 1e-3}, {0.01, 1.0}, {1e-3, 2e3}}) {
    const Patch image = Patch::image(std::vector<double>(columns * 5, 1.0), columns, 0.001).orthotropic(mx, my);
    for (const PatchTwist& twist : twists(0.02, 40, -3.0, 1.0)) {
      const PatchFriction exact = stretched_rectangle(columns * 0.001, 0.005, mx, my, twist);
      const PatchFriction friction = image.about_origin(twist);
      EXPECT_LE(difference(friction, exact, image.moment_ratio()), friction.error) << mx << ' ' << my;
      EXPECT_LE(std::hypot(friction.wrench.fx / mx, friction.wrench.fy / my), 1.0 + friction.error / std::min(mx, my));
    }
  }
}

TEST(PatchImage, NegativePressuresAreNoiseThatTellsItsOwnSize) {
  std::vector<double> clean(64, 0.0);
  std::vector<double> noisy(64, -0.004);
  for (std::size_t i = 16; i < 48; ++i) {
    if (i % 8 > 1 && i % 8 < 6) clean[i] = noisy[i] = 1.0;
  }
  noisy[0] = 0.006;
  const double moment_ratio = Patch::image(clean, 8, 1e-3).moment_ratio();
  const Patch patch = Patch::image(noisy, 8, 1e-3).orthotropic(1.0, 2.0).orthotropic(1.0, 0.5);
  EXPECT_EQ(patch.moment_ratio(), moment_ratio);
  const std::vector<std::string> lines{
      "note: 47 pressures are negative, down to -0.004; 48 up to 0.006 count as 0, -1.2 % of the load"};
  EXPECT_EQ(patch.remarks(), lines);
  for (double& pressure : noisy) pressure = std::fabs(pressure);
  EXPECT_EQ(Patch::image(noisy, 8, 1e-3, 1e-3, 0.02).moment_ratio(), moment_ratio);
  EXPECT_THROW(Patch::image(noisy, 8, 1e-3, 1e-3, -0.02), std::invalid_argument);
}

TEST(PatchImage, AnOffsetIsToldFromNoiseAndFromAContactThatIsCutOff) {
  // Counts of a taxel array.
  std::mt19937 bits(4);
  std::normal_distribution<double> noise;
  const auto told = [&](double offset, double sigma, double radius, double floor, const char* what) {
    std::vector<double> counts;
    for (int i = 0; i < 32 * 32; ++i) {
      const double square = (std::pow(i % 32 - 15.5, 2) + std::pow(i / 32 - 15.5, 2)) / (radius * radius);
      const double pressure = 3000.0 * std::sqrt(std::max(0.0, 1.0 - square));
      counts.push_back(std::max(0.0, std::round(offset + pressure + sigma * noise(bits))));
    }
    const std::vector<std::string> remarks = Patch::image(counts, 32, 1e-3, 1e-3, floor).remarks();
    expect_mention(remarks.empty() ? "none" : remarks.back(), what);
  };
  for (const double offset : {100.0, 500.0, 1500.0, 8000.0, 60000.0}) {
    told(offset, 5.0, 10.0, 0.0, "subtract it from all pixels");
    told(offset, 5.0, 10.0, offset + 20.0, "subtract it from all pixels");
  }
  told(0.0, 60.0, 10.0, 0.0, "set floor=");
  for (const double radius : {18.0, 30.0, 100.0}) told(0.0, 5.0, radius, 0.0, "cut off?");
  told(0.0, 0.0, 15.3, 0.0, "none");  // it ends within the outer tenth
}

}  // namespace
}  // namespace limitcurve::test
