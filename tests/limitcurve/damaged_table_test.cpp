// SPDX-License-Identifier: MIT
// Tables made of cells that a file may hold: what is whole is taken, what is not is refused by name.

#include "tests/limitcurve/shared.hpp"

namespace limitcurve {
namespace {

using test::complaint;
using test::expect_mention;

class DamagedTable : public testing::Test {
 protected:
  [[nodiscard]] std::string complaint_of(const TableCells& cells) const {
    return complaint([&] { Table(facts_, cells); });
  }
  const Table table_ = Table::build(uniform(), 1e-8, {.preferred_bytes = 0});
  TableFacts facts_{"uniform", 1e-8, 1e-8};
  TableCells cells_ = table_.cells();
};

TEST_F(DamagedTable, WhatIsWholeIsTaken) {
  EXPECT_EQ(complaint_of(cells_), "none");
}

TEST_F(DamagedTable, IsRefusedForItsFacts) {
  for (const double error : {-1.0, 1.1e-8, test::nan}) {
    facts_.checked_error = error;
    expect_mention(complaint_of(cells_), "checked_error");
  }
  facts_ = {"uniform", test::nan, 1e-8};
  expect_mention(complaint_of(cells_), "tolerance");
  facts_ = {"uni\nform", 1e-8, 1e-8};
  expect_mention(complaint_of(cells_), "control character");
}

TEST_F(DamagedTable, IsRefusedForItsIndex) {
  for (const int bits : {-1, 0, 2, 12, 1000000}) {
    TableCells damaged = cells_;
    damaged.index_bits = bits;
    expect_mention(complaint_of(damaged), "index_bits");
  }
  for (const int octaves : {-7, 0, 50, 1000000000}) {
    TableCells damaged = cells_;
    damaged.octaves = octaves;
    expect_mention(complaint_of(damaged), "octaves");
  }
  TableCells damaged = cells_;
  damaged.index_bits = 11;
  damaged.octaves = 41;
  expect_mention(complaint_of(damaged), "bytes");
}

TEST_F(DamagedTable, IsRefusedForItsEdges) {
  TableCells damaged = cells_;
  damaged.inside.erase(damaged.inside.begin());
  expect_mention(complaint_of(damaged), "inside, cell 1");
  damaged = cells_;
  damaged.outside.clear();
  expect_mention(complaint_of(damaged), "outside: no cells");
  damaged = cells_;
  std::swap(damaged.inside[1], damaged.inside[2]);
  expect_mention(complaint_of(damaged), "increases");
  for (const double x : {test::nan, 1.0, 2.0, -0.5}) {
    damaged = cells_;
    damaged.inside.back().x = x;
    expect_mention(complaint_of(damaged), "expected x in [0, 1)");
  }
  damaged = cells_;
  damaged.inside.back().x = std::nextafter(damaged.inside[damaged.inside.size() - 2].x, 1.0);
  EXPECT_NE(complaint_of(damaged), "none");
  damaged = cells_;
  damaged.inside.erase(damaged.inside.begin() + 1);
  EXPECT_NE(complaint_of(damaged), "none");
}

TEST_F(DamagedTable, IsRefusedForEveryCoefficientThatIsWrong) {
  for (std::vector<TableCell> TableCells::*side : {&TableCells::inside, &TableCells::outside}) {
    for (std::size_t i = 0; i < (cells_.*side).size(); ++i) {
      for (std::size_t k = 0; k < 7; ++k) {
        for (const double factor : {-1.0, 1e300, test::inf, test::nan, 1.001}) {
          TableCells damaged = cells_;
          double& c = (damaged.*side)[i].coefficients[k];
          c = c * factor + (factor == 1e300 ? factor : factor == 1.001 ? 1e-3 : 0.0);
          if (c == (cells_.*side)[i].coefficients[k]) continue;
          EXPECT_NE(complaint_of(damaged), "none") << i << ' ' << k << ' ' << factor;
        }
      }
    }
  }
}

TEST_F(DamagedTable, IsRefusedForAMomentThatNoPressureHas) {
  // Scaled so that it is whole otherwise.
  for (std::vector<TableCell>* side : {&cells_.inside, &cells_.outside}) {
    for (TableCell& cell : *side) {
      for (double& c : cell.coefficients) c *= 0x1p200;
    }
  }
  expect_mention(complaint_of(cells_), "largest force or moment");
}

}  // namespace
}  // namespace limitcurve
