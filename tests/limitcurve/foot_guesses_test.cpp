// SPDX-License-Identifier: MIT
#include "limitcurve/foot_guesses.hpp"
#include "limitcurve/laws.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace limitcurve {
namespace {

/// Laws whose curves are smooth, singular at the rim, and steep there.
const std::vector<Law> laws{hertz(), uniform(), flat_punch(), power(2.3)};

double square_between(UnitWrench one, UnitWrench other, double chi) {
  const double force = one.force - other.force;
  const double moment = one.moment - other.moment;
  return force * force + chi * (moment * moment);
}

/// The square of the distance of the closest point that trying finds: so many of both sides, and then between the neighbours of the best.
double least_square_by_trying(const Table& table, UnitWrench trial, double chi) {
  double low = 0.0;
  double high = 2.0;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 8; ++round) {
    constexpr int count = 200;
    const double width = (high - low) / count;
    double best = low;
    for (int i = 0; i <= count; ++i) {
      const double place = low + width * i;
      const double square = square_between(trial, table.wrench(SlipTwist::at_place(place)), chi);
      if (square < least) {
        least = square;
        best = place;
      }
    }
    low = std::max(0.0, best - width);
    high = std::min(2.0, best + width);
  }
  return least;
}

/// A trial whose gauge is `gauge`, in a direction whose share of the moment crowds to both axes.
UnitWrench random_trial(const Table& table, std::mt19937_64& random, double gauge) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double near = std::pow(10.0, -8.0 * unit(random));
  const double share = unit(random) < 0.4 ? near : unit(random) < 0.5 ? 1.0 - near : unit(random);
  const UnitWrench direction{(1.0 - share) + 1e-300, share * table.moment_ratio() + 1e-300};
  const double scale = gauge / table.gauge(direction);
  return {direction.force * scale, direction.moment * scale};
}

Foot closest(const FootGuesses& guesses, const Table& table, UnitWrench trial) {
  const Pair parts{trial.force / table.wrench({1.0, 0.0}).force, trial.moment / table.wrench({0.0, 1.0}).moment};
  return guesses.closest(table, Pair{trial.force, trial.moment}, parts * parts);
}

TEST(FootGuesses, LeadToTheClosestPoint) {
  for (const Law& law : laws) {
    const Table table = Table::build(law, 1e-8);
    for (const double chi : {1e-3, 0.1, 0.625, 3.0, 1e3}) {
      const auto guesses = std::make_unique<FootGuesses>(table, chi);
      std::mt19937_64 random(7);
      for (int i = 0; i < 20; ++i) {
        const UnitWrench trial = random_trial(table, random, 1.0 + std::pow(10.0, -3.0 + 4.0 * i / 20.0));
        const Foot foot = closest(*guesses, table, trial);
        // A table's normals are the law's, its cubics' right to 1e-6 or so: of which a distance is off by the square.
        const double square = square_between(trial, foot.wrench, chi);
        EXPECT_LE(square, least_square_by_trying(table, trial, chi) + 1e-11 * (square + chi))
            << law->name() << " chi " << chi << " trial " << trial.force << ' ' << trial.moment;
        const UnitWrench at_place = table.wrench(foot.normal);
        EXPECT_NEAR(at_place.force, foot.wrench.force, 1e-15) << law->name() << " chi " << chi;
        EXPECT_NEAR(at_place.moment, foot.wrench.moment, 1e-15) << law->name() << " chi " << chi;
      }
    }
  }
}

// A metric six decades off either way, trials on both sides of the curve and far beyond it, next to both axes: whatever the guess.
TEST(FootGuesses, LeadWhereASearchFromAnywhereDoes) {
  for (const Law& law : laws) {
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      const Table table = Table::build(law, tolerance);
      for (const double chi : {1e-60, 1e-6, 1e-2, 0.625, 1e2, 1e6, 1e60}) {
        const auto guesses = std::make_unique<FootGuesses>(table, chi);
        std::mt19937_64 random(11);
        const int count = repetitions(300, 10);
        for (int i = 0; i < count; ++i) {
          const UnitWrench trial = random_trial(table, random, 1.0 + std::pow(10.0, -13.0 + 20.0 * i / count));
          const Foot foot = closest(*guesses, table, trial);
          const Foot from_anywhere = table.closest(trial, chi, 1.0 / chi, 1.0);
          EXPECT_NEAR(foot.place, from_anywhere.place, 1e-10) << law->name() << ' ' << tolerance << " chi " << chi;
          EXPECT_NEAR(foot.wrench.force, from_anywhere.wrench.force, 1e-10) << law->name() << ' ' << tolerance << " chi " << chi;
          EXPECT_NEAR(foot.wrench.moment, from_anywhere.wrench.moment, 1e-10) << law->name() << ' ' << tolerance << " chi " << chi;
          // Where the next search may look first.
          const TableSide& side = foot.place > 1.0 ? table.outside() : table.inside();
          ASSERT_LT(foot.piece, side.nodes().size() - 1);
          const double x = std::min(foot.normal.slide, foot.normal.spin);
          EXPECT_GE(x, side.nodes()[foot.piece].coordinate);
          EXPECT_LE(x, side.nodes()[foot.piece + 1].coordinate);
        }
      }
    }
  }
}

// The cell that a search looks at first saves time; no digit hangs on it.
TEST(TableClosest, IsTheSameForEveryPiece) {
  for (const Law& law : laws) {
    const Table table = Table::build(law, 1e-7);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> anywhere(-0.5, 2.5);
    const int count = repetitions(300, 10);
    for (int i = 0; i < count; ++i) {
      const double chi = std::pow(10.0, anywhere(random));
      const UnitWrench trial = random_trial(table, random, 0.8 + 0.001 * i);
      const Foot far = table.closest(trial, chi, 1.0 / chi, -1.0);
      // From near and from anywhere; the axes themselves, and beyond them; the rim.
      for (const double start : {far.place * (1.0 + 1e-6), far.place, anywhere(random), 0.0, 1.0, 2.0, -0.0}) {
        const Foot without = table.closest(trial, chi, 1.0 / chi, start, 0xFFFFFFFF);
        for (const std::uint32_t piece : {0U, 1U, 5U, far.piece, far.piece + 1, 1000000U}) {
          const Foot foot = table.closest(trial, chi, 1.0 / chi, start, piece);
          ASSERT_EQ(foot.wrench, without.wrench) << law->name() << " from " << start << " piece " << piece;
          ASSERT_EQ(foot.place, without.place);
          ASSERT_EQ(foot.piece, without.piece);
        }
        if (table.gauge(trial) > 1.0) {
          ASSERT_NEAR(without.place, far.place, 1e-9) << law->name() << " from " << start << " chi " << chi;
        }
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve
