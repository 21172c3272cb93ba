// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/choice.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/soak/random_bits.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::soak {

/// Every kind of boundary, built once. Tables can be written to and read from a folder: what a table is built from, functions of
/// the mathematical library in extended precision, differs between machines.
class Boundaries {
 public:
  static constexpr std::array<const char*, 7> names{"exact", "table", "ellipse", "superellipse", "quartic", "box", "diamond"};
  static constexpr std::array<const char*, 3> projections{"radial", "c-curve", "closest-point"};

  Boundaries() {
    for (const auto& [law, tolerance] : recipes()) tables_.push_back(Table::build(parse_law(law), tolerance));
  }
  explicit Boundaries(const std::filesystem::path& folder) {
    for (std::size_t i = 0; i < recipes().size(); ++i) {
      const std::filesystem::path path = file(folder, i);
      std::ifstream stream(path);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      tables_.push_back(read_table_csv(text, path.string()));
    }
  }
  void write(const std::filesystem::path& folder) const {
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < tables_.size(); ++i) std::ofstream(file(folder, i)) << to_csv(tables_[i]);
  }

  /// Calls `body(boundary)` with one of the `kind`-th kind.
  template <class Body>
  void visit(std::size_t kind, RandomBits& random, Body&& body) const {
    const double moment_ratio = random.uniform(0.4, 0.8);
    switch (kind) {
      case 0:
        return body(exact_[static_cast<std::size_t>(random.below(static_cast<int>(exact_.size())))]);
      case 1:
        return body(tables_[static_cast<std::size_t>(random.below(static_cast<int>(tables_.size())))]);
      case 2:
        return body(Ellipse::through_intercepts(moment_ratio));
      case 3:
        return body(Superellipse::through_intercepts(moment_ratio, random.uniform(1.6, 2.2)));
      case 4:
        return body(Quartic::through_intercepts(moment_ratio, random.uniform(2.0, 5.0)));
      case 5:
        return body(box(1.0, moment_ratio));
      default:
        return body(diamond(1.0, moment_ratio));
    }
  }

 private:
  struct Recipe {
    const char* law;
    double tolerance;
  };
  static const std::vector<Recipe>& recipes() {
    static const std::vector<Recipe> result{{"hertz", 1e-6}, {"hertz", 1e-10},        {"uniform", 1e-8},           {"flat-punch", 1e-6},
                                            {"cone", 1e-2},  {"xydas-kao:k=3", 1e-8}, {"gaussian:sigma=0.4", 1e-6}};
    return result;
  }
  static std::filesystem::path file(const std::filesystem::path& folder, std::size_t i) { return folder / (std::to_string(i) + ".csv"); }

  std::vector<Table> tables_;
  std::array<ExactCurve, 5> exact_{ExactCurve(hertz()), ExactCurve(uniform()), ExactCurve(flat_punch()), ExactCurve(cone()),
                                   ExactCurve(parabolic())};
};

}  // namespace limitcurve::soak
