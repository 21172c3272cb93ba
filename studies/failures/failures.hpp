// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// Where methods break, the usual ones and ours. Each entry of docs/stability.md has a file with its
/// measurements (a function for each hazard) and its figures; studies/failures/measure --check measures them anew and compares.
/// The measuring files contain the usual methods in their common form; truth.hpp has the true values.
namespace limitcurve::stability {

/// A point of a figure: series `series` in panel `panel`.
struct Row {
  std::string panel;
  std::string series;
  double x;
  double value;
};

/// A figure's rows: NAME.csv, drawn as docs/stability/NAME.svg by studies/failures/figures.py.
struct Figure {
  std::string name;
  std::vector<Row> rows;
};

/// A line of the table at the top of docs/stability.md: the effect of a hazard on a usual method and on ours, the same quantity
/// measured in the same way.
struct Finding {
  std::string hazard;
  std::string method;    ///< the usual one
  std::string quantity;  ///< the measured quantity, with its unit
  double breaks;         ///< its value for the usual method; inf, nan: it returned this, or threw
  double stands;         ///< its value for ours
};

/// The measurements of one hazard.
struct Hazard {
  std::vector<Finding> findings;
  std::vector<Figure> figures;
};

/// An entry of the document, under the heading `name`. Measuring a hazard takes at most some seconds.
struct Entry {
  std::string name;
  std::vector<Hazard (*)()> hazards;
};

}  // namespace limitcurve::stability
