// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

/// The atlas of failure: where methods break, the customary ones and ours. Each entry of docs/stability.md has a file that
/// measures (ENTRY.cpp), a test that holds the code to what was measured (ENTRY_test.cpp) and its figures. The customary
/// methods stand in the measuring files, short and as they are commonly written; truth comes from truth.hpp.
namespace limitcurve::stability {

/// A point of a figure: series `series` in panel `panel`.
struct Row {
  std::string panel;
  std::string series;
  double x;
  double value;
};

/// A figure's rows: FIGURE.csv, drawn as docs/stability/FIGURE.svg by scripts/stability_figures.py.
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

/// An entry of the atlas.
struct Entry {
  std::string name;  ///< quadrature, tables, fits, …
  std::vector<Finding> findings;
  std::vector<Figure> figures;
};

/// The findings of an entry that `test` answers for; throws std::logic_error if there are none, so that no test can pass by
/// looking at nothing.
std::vector<Finding> findings_of(const Entry& entry, const std::string& test);

/// Measured once a process, some seconds each at most.
const Entry& quadrature();

}  // namespace limitcurve::stability
