// SPDX-License-Identifier: MIT
#include "limitcurve/patch/half_spaces.hpp"

#include "patch_cases.hpp"

namespace limitcurve::test {
namespace {

/// A patch, and the shares of 8, 14, 32, 62, 128 rows: by a prototype in another language; 0 where it has none.
struct HalfSpaceCase {
  const char* name;
  Patch patch;
  std::array<double, 5> shares;
};

std::vector<HalfSpaceCase> half_space_cases() {
  const std::vector<PatchLoad> uneven{{0.1, 0.05, 1.0}, {0.1, -0.05, 2.0}, {-0.1, 0.02, 0.5}};
  return {{"disc", Patch::ellipse(hertz(), 1.0, 1.0), {0.612, 0.799, 0.902, 0.946, 0.972}},
          {"rectangle", Patch::rectangle(0.2, 0.1), {0.609, 0.790, 0.891, 0.937, 0.962}},
          {"L beside the origin", Patch::polygon(ell), {0, 0, 0, 0, 0}},
          {"uneven points", Patch::points(uneven), {0.502, 0.581, 0.701, 0.824, 0.895}},
          {"orthotropic", Patch::rectangle(0.2, 0.1).orthotropic(1.0, 0.5), {0, 0, 0.902, 0.946, 0}}};
}

double times(const HalfSpace& row, const PatchWrench& wrench) {
  return row.fx * wrench.fx + row.fy * wrench.fy + row.moment * wrench.moment;
}

/// In a random direction, by the patch's own proportions.
PatchWrench random_wrench(const Patch& patch, std::mt19937_64& bits) {
  std::normal_distribution<double> normal;
  PatchWrench wrench{normal(bits), normal(bits), normal(bits) * patch.moment_ratio()};
  wrench.moment += patch.centre().x * wrench.fy - patch.centre().y * wrench.fx;
  return wrench;
}

double largest(const HalfSpaces& half_spaces, const PatchWrench& wrench) {
  double most = 0.0;
  for (const HalfSpace& row : half_spaces.rows) most = std::max(most, times(row, wrench));
  return most;
}

// By the patch's own gauge. A million wrenches a patch by night.
TEST(HalfSpaces, NoWrenchInsideSlips) {
  const int wrenches = repetitions(studies_are_whole() ? 1000000 : 4000);
  for (const HalfSpaceCase& one : half_space_cases()) {
    const HalfSpaces inside = half_spaces(one.patch, 32);
    std::mt19937_64 bits(3);
    double slips = 0.0;
    for (int i = 0; i < wrenches; ++i) {
      PatchWrench w = random_wrench(one.patch, bits);
      const double size = largest(inside, w) / (i % 2 == 0 ? 1.0 : std::generate_canonical<double, 53>(bits));
      w = {w.fx / size, w.fy / size, w.moment / size};
      slips = std::max(slips, load_to_hold(one.patch, 1.0, w));
    }
    for (const PatchWrench& vertex : inside.vertices) slips = std::max(slips, load_to_hold(one.patch, 1.0, vertex));
    EXPECT_LE(slips, 1.0) << one.name;
    EXPECT_GE(slips, 0.95) << one.name;  // a vertex reaches the limit
  }
}

TEST(HalfSpaces, KeepTheStatedShareInEveryDirection) {
  for (const HalfSpaceCase& one : half_space_cases()) {
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t rows = std::array<std::size_t, 5>{8, 14, 32, 62, 128}[i];
      if (tests_are_short && rows > 32) continue;
      const HalfSpaces found = half_spaces(one.patch, rows + (i == 0 ? 5 : 0));
      EXPECT_EQ(found.rows.size(), rows);
      if (one.shares[i] > 0.0) {
        EXPECT_NEAR(found.share, one.shares[i], 6e-4) << one.name << rows;
      }
      // In no sampled direction less is kept, and in the direction of a row's own wrench no more.
      double least = inf;
      std::mt19937_64 bits(5);
      for (int k = 0; k < repetitions(1000); ++k) {
        const PatchWrench w = random_wrench(one.patch, bits);
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
  expect_mention(complaint([] { (void)half_spaces(Patch::rectangle(1.0, 1.0), 7); }), "rows");
  const Patch one = Patch::points(std::array{PatchLoad{0.1, 0.2, 1.0}});
  expect_mention(complaint([&] { (void)half_spaces(one); }), "single point");
}

}  // namespace
}  // namespace limitcurve::test
