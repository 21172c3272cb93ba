// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/limitcurve.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/soak/random_bits.hpp"
#include "tests/superellipse.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::soak {

/// Every kind of curve, built once. Tables can be written to and read from a folder: what a table is built from, functions of
/// the mathematical library in extended precision, differs between machines.
class Curves {
 public:
  static constexpr std::array<const char*, 4> names{"law", "superellipse", "ellipse", "box"};

  Curves() {
    for (const char* law : {"hertz", "uniform", "flat-punch", "cone", "xydas-kao:k=3", "gaussian:sigma=0.4"}) {
      for (const double tolerance : {1e-2, 1e-6, 1e-8, 1e-11}) tables_[0].push_back(Table::build(parse_law(law), tolerance));
    }
    for (const double exponent : {1.6, 1.9, 2.2}) {
      tables_[1].push_back(Table::build(test::Superellipse{1.0, 0.6, exponent}, 1e-8, {.name = "superellipse"}));
    }
  }
  explicit Curves(const std::filesystem::path& folder) {
    for (std::size_t kind = 0; kind < tables_.size(); ++kind) {
      for (std::size_t i = 0; std::filesystem::exists(file(folder, kind, i)); ++i) {
        std::ifstream stream(file(folder, kind, i));
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        tables_[kind].push_back(read_table_csv(text, file(folder, kind, i).string()));
      }
    }
  }
  void write(const std::filesystem::path& folder) const {
    std::filesystem::create_directories(folder);
    for (std::size_t kind = 0; kind < tables_.size(); ++kind) {
      for (std::size_t i = 0; i < tables_[kind].size(); ++i) std::ofstream(file(folder, kind, i)) << to_csv(tables_[kind][i]);
    }
  }

  /// A curve of that kind.
  [[nodiscard]] godobject::FingerCurve any(std::size_t kind, RandomBits& random) const {
    const double moment_ratio = random.uniform(0.4, 0.8);
    if (kind == 2) return Ellipse::through_intercepts(moment_ratio);
    if (kind == 3) return box(1.0, moment_ratio);
    return tables_[kind][static_cast<std::size_t>(random.below(static_cast<int>(tables_[kind].size())))];
  }

 private:
  static std::filesystem::path file(const std::filesystem::path& folder, std::size_t kind, std::size_t i) {
    return folder / (std::string(names[kind]) + '-' + std::to_string(i) + ".csv");
  }

  std::array<std::vector<Table>, 2> tables_;
};

}  // namespace limitcurve::soak
