// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The atlas of failure: where methods break, the customary ones and ours. Each entry of docs/stability.md has a file that
/// measures (ENTRY.cpp, a function a hazard), tests that hold the code to what was measured (ENTRY_test.cpp) and its figures.
/// The customary methods stand in the measuring files, short and as they are commonly written; truth comes from truth.hpp.
namespace limitcurve::stability {

/// A point of a figure: series `series` in panel `panel`.
struct Row {
  std::string panel;
  std::string series;
  double x;
  double value;
};

/// A figure's rows: NAME.csv, drawn as docs/stability/NAME.svg by scripts/figures/stability_figures.py.
struct Figure {
  std::string name;
  std::vector<Row> rows;
};

/// A line of the table that heads docs/stability.md: what a hazard does to a customary method and to ours, the same quantity
/// measured in the same way.
struct Finding {
  std::string hazard;
  std::string method;    ///< the customary one
  std::string quantity;  ///< what is measured, with its unit
  double breaks;         ///< its value for the customary method; inf, nan: it returned just that, or threw
  double stands;         ///< its value for ours
  std::string test;      ///< SUITE.NAME, in tests/stability
};

/// What was measured of one hazard.
struct Hazard {
  std::vector<Finding> findings;
  std::vector<Figure> figures;
};

/// An entry of the document, under the heading `name`. A hazard takes some seconds to measure, at most.
struct Entry {
  std::string name;
  std::vector<Hazard (*)()> hazards;
};

}  // namespace limitcurve::stability
