// SPDX-License-Identifier: MIT
#include "limitcurve/export/single_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::table {

namespace {

constexpr double widest = 0.125;  // wider cells would round more: coefficients, and products with t

std::vector<TableCell> rounded(const std::vector<TableCell>& side) {
  std::vector<TableCell> cells;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const double width = (i + 1 < side.size() ? side[i + 1].x : 1.0) - side[i].x;
    const double parts = std::ceil(width / widest);
    for (int part = 0; part < parts; ++part) {
      TableCell cell = side[i];
      const double origin = static_cast<double>(static_cast<float>(cell.x + part * width / parts));
      auto& c = cell.coefficients;
      // Taylor's shift to the new origin.
      for (std::size_t j = 0; j + 1 < c.size(); ++j) {
        for (std::size_t k = c.size() - 1; k-- > j;) c[k] += (origin - cell.x) * c[k + 1];
      }
      cell.x = origin;
      for (double& coefficient : c) coefficient = static_cast<double>(static_cast<float>(coefficient));
      if (!cells.empty() && cells.back().x == origin) cells.pop_back();
      cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace

TableCells in_single_precision(const TableCells& cells) {
  return {cells.index_bits, cells.octaves, rounded(cells.inside), rounded(cells.outside)};
}

double rounding_in_single_precision(const TableCells& cells) {
  constexpr double unit = 0x1p-24;
  double worst = 0.0;
  for (const auto* side : {&cells.inside, &cells.outside}) {
    for (std::size_t i = 0; i < side->size(); ++i) {
      const double end = i + 1 < side->size() ? (*side)[i + 1].x : 1.0;
      const double t = end - (*side)[i].x;
      std::array<double, 2> sum{};    // |D|, |D′| at most
      std::array<double, 2> error{};  // of them
      for (std::size_t k = 7; k-- > 0;) {
        const double c = std::fabs((*side)[i].coefficients[k]);
        // t, the product and the sum are rounded; the coefficient of D was.
        error[1] = error[1] * t + 2 * unit * sum[1] * t + error[0];
        sum[1] = sum[1] * t + sum[0];
        error[1] += unit * sum[1];
        error[0] = error[0] * t + 2 * unit * sum[0] * t + unit * c;
        sum[0] = sum[0] * t + c;
        error[0] += unit * sum[0];
      }
      // D − xD′: product and difference, which is not larger than D.
      worst = std::max({worst, error[1], error[0] + end * error[1] + unit * (end * sum[1] + sum[0])});
    }
  }
  return worst;
}

}  // namespace limitcurve::table
