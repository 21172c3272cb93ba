// SPDX-License-Identifier: MIT
#include "limitcurve/export/header.hpp"
#include "tests/godobject/scene.hpp"
#include "tests/limitcurve/shared.hpp"

#ifndef _WIN32  // where there is no compiler
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace limitcurve::godobject::test {
namespace {

/// What a program in C or C++, made with the header of a table, prints of trials: gauge, closest point, and the wrench
/// of the slip twist with these components.
std::vector<std::array<double, 5>> by_header(const Table& table, const std::string& compiler,
                                             const std::vector<std::array<double, 3>>& trials) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("limitcurve_projection_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "thumb.h") << to_header(table, "thumb");
  std::ofstream(folder / "use.c") << R"(#include "thumb.h"
#include "thumb.h"
#include <stdio.h>
#ifdef __cplusplus
static_assert(thumb_wrench(1.0, 0.0).force == 1.0, "");
static_assert(thumb_wrench(0.0, 0.0).force == 0.0, "");
static_assert(thumb_wrench(0.0, 2.0).moment == thumb_moment_ratio, "");
#endif
int main(void) {
  double in[3];
  while (fread(in, sizeof in, 1, stdin) == 1) {
    const thumb_friction to = thumb_closest_point(in[0], in[1], in[2]);
    const thumb_friction at = thumb_wrench(in[0], in[1]);
    const double out[5] = {thumb_gauge(in[0], in[1]), to.force, to.moment, at.force, at.moment};
    fwrite(out, sizeof out, 1, stdout);
  }
  return 0;
}
)";
  std::vector<std::array<double, 5>> found(trials.size());
  const auto size = static_cast<std::streamsize>(found.size() * sizeof found[0]);
  std::ofstream(folder / "trials", std::ios::binary)
      .write(reinterpret_cast<const char*>(trials.data()),
             static_cast<std::streamsize>(trials.size() * sizeof trials[0]));
  const std::string command =
      "cd '" + folder.string() + "' && " + compiler + " -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror use.c -o use";
  EXPECT_EQ(std::system((command + " && ./use <trials >found").c_str()), 0);
  EXPECT_EQ(
      std::ifstream(folder / "found", std::ios::binary).read(reinterpret_cast<char*>(found.data()), size).gcount(),
      size);
  std::filesystem::remove_all(folder);
  return found;
}

// The header has a search of its own, without the library's guesses. Trials are slip twists, too.
TEST(ExportedHeader, ItsClosestPointIsTheLibrarys) {
  Random random(47);
  std::array<int, 7> of_degree{};
  const std::vector<Table> tables{Table::build(hertz(), 1e-2),
                                  Table::build(uniform(), 1e-4),
                                  Table::build(gaussian(0.4), 1e-7),
                                  Table::build(flat_punch(), 1e-8),
                                  Table::build(hertz(), 1e-12, {.preferred_bytes = 0}),
                                  Table({"cone", 1e-6, 1e-6}, FloatTable::build(cone(), 1e-6).cells())};
  for (const Table& table : tables) {
    ++of_degree[static_cast<std::size_t>(table.degree())];
    std::vector<std::array<double, 3>> trials{
        {0.0, 0.0, 1.0}, {2.0, 0.0, 1e-3}, {0.0, -2.0, 1e3}, {1e30, 1e30, 1.0}, {1e-30, 3.0, 7.0}};
    for (const SlipTwist twist : limitcurve::test::probes()) trials.push_back({twist.slide, twist.spin, 1.0});
    while (trials.size() < static_cast<std::size_t>(repetitions(20'000)))
      trials.push_back({random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.logarithmic(1e-3, 1e3)});
    for (const char* const compiler : {"cc -std=c99", "c++ -std=c++17 -x c++"}) {
      const auto found = by_header(table, compiler, trials);
      for (std::size_t i = 0; i < trials.size(); ++i) {
        const auto [force, moment, chi] = trials[i];
        const UnitTrial<double> trial{std::abs(force), std::abs(moment), chi, slip_onset<double>};
        const double gauge = table.gauge({trial.force, trial.moment});
        EXPECT_NEAR(found[i][0], gauge, 4e-15 * std::max(1.0, gauge)) << force << ' ' << moment;
        const auto own = project_on_to_closest_point(table.view(), trial, 0.0);
        const double kept_force = own.exceeds && force != 0.0 ? own.force_fraction : 1.0;
        const double kept_moment = own.exceeds && moment != 0.0 ? own.moment_fraction : 1.0;
        EXPECT_NEAR(found[i][1], force * kept_force, 2e-13) << force << ' ' << moment << ' ' << chi;
        EXPECT_NEAR(found[i][2], moment * kept_moment, 2e-13) << force << ' ' << moment << ' ' << chi;
        const UnitWrench wrench = table.wrench({trial.force, trial.moment});
        EXPECT_LE(limitcurve::test::apart(UnitWrench{found[i][3], found[i][4]}, wrench), 1e-15)
            << force << ' ' << moment;
        EXPECT_EQ(own.exceeds, found[i][1] != force || found[i][2] != moment);
      }
    }
  }
  for (std::size_t degree = 3; degree <= 6; ++degree) EXPECT_GT(of_degree[degree], 0) << degree;
}

}  // namespace
}  // namespace limitcurve::godobject::test
#endif
