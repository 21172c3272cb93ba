// SPDX-License-Identifier: MIT
#include "limitcurve/patch/half_spaces.hpp"

#include "limitcurve/laws.hpp"
#include "patch_cases.hpp"
#include "tests/complaint.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace limitcurve::test {
namespace {

/// A patch, and the power of a twist about the origin by brute force, which is accurate to `error`.
struct HalfSpaceCase {
  const char* name;
  Patch patch;
  std::function<double(const PatchTwist&)> power;
  double error;
  std::array<double, 5> shares;  ///< of 8, 14, 32, 62, 128 rows: by a prototype in another language
};

/// Points that have the power of pressures in small squares, by their sum.
std::function<double(const PatchTwist&)> sum_of(std::vector<PatchLoad> points) {
  double load = 0.0;
  for (const PatchLoad& point : points) load += point.load;
  return [points, load](const PatchTwist& t) {
    double sum = 0.0;
    for (const auto& [x, y, weight] : points) sum += weight * std::hypot(t.vx - t.omega * y, t.vy + t.omega * x);
    return sum / load;
  };
}

/// Squares of side `pitch` whose middles have a pressure.
std::vector<PatchLoad> squares(double x, double y, double pitch,
                               const std::function<double(double, double)>& pressure) {
  std::vector<PatchLoad> points;
  for (double u = -x + pitch / 2; u < x; u += pitch) {
    for (double v = -y + pitch / 2; v < y; v += pitch) {
      if (pressure(u, v) > 0.0) points.push_back({u, v, pressure(u, v)});
    }
  }
  return points;
}

std::vector<HalfSpaceCase> half_space_cases() {
  const std::vector<PatchLoad> uneven{{0.1, 0.05, 1.0}, {0.1, -0.05, 2.0}, {-0.1, 0.02, 0.5}};
  const auto in_ell = [](double x, double y) {
    return x > 0 && y > 0 && x < 4 && y < 3 && (x < 1 || y < 1) ? 1.0 : 0.0;
  };
  const auto everywhere = [](double, double) { return 1.0; };
  const auto hertzian = [](double x, double y) { return std::sqrt(std::max(0.0, 1.0 - x * x - y * y)); };
  const auto rectangle = sum_of(squares(0.1, 0.05, 0.2 / 120, everywhere));
  return {{"disc",
           Patch::ellipse(hertz(), 1.0, 1.0),
           sum_of(squares(1, 1, 1.0 / 60, hertzian)),
           2e-4,
           {0.612, 0.799, 0.902, 0.946, 0.972}},
          {"rectangle", Patch::rectangle(0.2, 0.1), rectangle, 2e-4, {0.609, 0.790, 0.891, 0.937, 0.962}},
          {"L beside the origin", Patch::polygon(ell), sum_of(squares(4, 4, 1.0 / 20, in_ell)), 1e-3, {0, 0, 0, 0, 0}},
          {"uneven points", Patch::points(uneven), sum_of(uneven), 1e-13, {0.502, 0.581, 0.701, 0.824, 0.895}},
          {"orthotropic",
           Patch::rectangle(0.2, 0.1).orthotropic(1.0, 0.5),
           [points = squares(0.1, 0.05, 0.2 / 120, everywhere)](const PatchTwist& t) {
             double sum = 0.0;
             for (const auto& [x, y, weight] : points)
               sum += std::hypot(t.vx - t.omega * y, 0.5 * (t.vy + t.omega * x));
             return sum / static_cast<double>(points.size());
           },
           2e-4,
           {0, 0, 0.902, 0.946, 0}}};
}

double times(const HalfSpace& row, const PatchWrench& wrench) {
  return row.fx * wrench.fx + row.fy * wrench.fy + row.moment * wrench.moment;
}

double largest(const HalfSpaces& half_spaces, const PatchWrench& wrench) {
  double most = 0.0;
  for (const HalfSpace& row : half_spaces.rows) most = std::max(most, times(row, wrench));
  return most;
}

// A wrench that satisfies the rows is within every tangent plane of the limit surface, whose powers are summed by brute
// force; and so it is by the patch's own gauge, exactly. A million wrenches a patch by night.
TEST(HalfSpaces, NoWrenchInsideSlips) {
  const int planes = repetitions(studies_are_whole() ? 2000 : 400, 50);
  const int wrenches = repetitions(studies_are_whole() ? 1000000 : 4000);
  for (const HalfSpaceCase& one : half_space_cases()) {
    const HalfSpaces inside = half_spaces(one.patch, 32);
    std::mt19937_64 bits(3);
    std::normal_distribution<double> normal;
    const PatchPoint centre = one.patch.centre();
    std::vector<HalfSpace> tangents;
    for (int i = 0; i < planes; ++i) {
      PatchTwist t{normal(bits), normal(bits), normal(bits) / one.patch.moment_ratio()};
      t = {t.vx + t.omega * centre.y, t.vy - t.omega * centre.x, t.omega};
      const double power = one.power(t);
      tangents.push_back({t.vx / power, t.vy / power, t.omega / power});
    }
    double beyond = 0.0;
    double slips = 0.0;
    for (int i = 0; i < wrenches; ++i) {
      PatchWrench w{normal(bits), normal(bits), normal(bits) * one.patch.moment_ratio()};
      w.moment += centre.x * w.fy - centre.y * w.fx;
      const double size = largest(inside, w) / (i % 2 == 0 ? 1.0 : std::generate_canonical<double, 53>(bits));
      w = {w.fx / size, w.fy / size, w.moment / size};
      for (const HalfSpace& tangent : tangents) beyond = std::max(beyond, times(tangent, w));
      slips = std::max(slips, load_to_hold(one.patch, 1.0, w));
    }
    for (const PatchWrench& vertex : inside.vertices) slips = std::max(slips, load_to_hold(one.patch, 1.0, vertex));
    EXPECT_LE(beyond, 1.0 + one.error) << one.name;
    EXPECT_LE(slips, 1.0) << one.name;
    EXPECT_GE(slips, 0.95) << one.name;  // a vertex reaches the limit
  }
}

TEST(HalfSpaces, KeepTheStatedShareInEveryDirection) {
  for (const HalfSpaceCase& one : half_space_cases()) {
    const PatchPoint centre = one.patch.centre();
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t rows = std::array<std::size_t, 5>{8, 14, 32, 62, 128}[i];
      if (tests_are_short && rows > 32) continue;
      const HalfSpaces found = half_spaces(one.patch, rows + (i == 0 ? 5 : 0));
      EXPECT_EQ(found.rows.size(), rows);
      if (one.shares[i] > 0.0) {
        EXPECT_NEAR(found.share, one.shares[i], 6e-4) << one.name << rows;
      }
      // In no sampled direction less is kept, and in the direction of a row's own wrench no more.
      double least = std::numeric_limits<double>::infinity();
      std::mt19937_64 bits(5);
      std::normal_distribution<double> normal;
      for (int k = 0; k < repetitions(1000); ++k) {
        PatchWrench w{normal(bits), normal(bits), normal(bits) * one.patch.moment_ratio()};
        w.moment += centre.x * w.fy - centre.y * w.fx;
        least = std::min(least, load_to_hold(one.patch, 1.0, w) / largest(found, w));
      }
      EXPECT_GE(least, found.share * (1.0 - 1e-9)) << one.name << rows;
      const PatchWrench touched =
          one.patch.about_origin({found.rows[0].fx, found.rows[0].fy, found.rows[0].moment}).wrench;
      EXPECT_NEAR(1.0 / largest(found, touched), found.share, 1e-9) << one.name << rows;
      // Rows and vertices describe the same polytope: each vertex is on three rows or more, and each row has three
      // vertices or more.
      for (const PatchWrench& vertex : found.vertices) {
        EXPECT_NEAR(largest(found, vertex), 1.0, 1e-8);
        EXPECT_GE(std::count_if(found.rows.begin(), found.rows.end(),
                                [&](const HalfSpace& row) { return times(row, vertex) > 1.0 - 1e-7; }),
                  3);
      }
      for (const HalfSpace& row : found.rows) {
        EXPECT_GE(std::count_if(found.vertices.begin(), found.vertices.end(),
                                [&](const PatchWrench& v) { return times(row, v) > 1.0 - 1e-7; }),
                  3)
            << one.name << rows;
      }
    }
  }
}

TEST(HalfSpaces, DivideByTheErrorOfAnImage) {
  // A picture of four pixels is a rectangle, whose power is known exactly; its own is not.
  const HalfSpaces found = half_spaces(Patch::image(std::array{1.0, 1.0, 1.0, 1.0}, 2, 0.1, 0.05), 32);
  const Patch exact = Patch::rectangle(0.2, 0.1);
  for (const PatchWrench& vertex : found.vertices) EXPECT_LE(load_to_hold(exact, 1.0, vertex), 1.0);
  EXPECT_LT(found.share, half_spaces(exact, 32).share);
}

TEST(HalfSpaces, RefuseWhatHasNone) {
  EXPECT_NE(complaint([] { (void)half_spaces(Patch::rectangle(1.0, 1.0), 7); }).find("rows"), std::string::npos);
  const Patch one = Patch::points(std::array{PatchLoad{0.1, 0.2, 1.0}});
  EXPECT_NE(complaint([&] { (void)half_spaces(one); }).find("single point"), std::string::npos);
}

}  // namespace
}  // namespace limitcurve::test
