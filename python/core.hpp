// SPDX-License-Identifier: MIT
#pragma once

#include "python/arrays.hpp"

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"
#include "limitcurve/patch.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <memory>
#include <optional>
#include <string>

/// What the sources of the module share: the objects behind the Python classes, and what each adds to the module.
namespace limitcurve::python {

void add_curves(nb::module_& module);
void add_fingers(nb::module_& module);
void add_batches(nb::module_& module);
void add_patches(nb::module_& module);

/// A law, and where it came from: its text, or the arrays of a measured profile.
struct PyLaw {
  Law law;
  std::string text;
  nb::object samples = nb::none();  ///< (radii, pressures) where it was made from arrays
};

/// A table, and its law if it was built from one: single precision has a table of its own.
struct PyTable {
  Table table;
  Law law = {};
};

/// An ellipse or a box in a table's place.
struct PyCurve {
  godobject::FingerCurve curve;
  godobject::BasicFingerCurve<float> single;
  std::string name;
};

/// A law from a str or a Law.
Law law_of(nb::handle law);
/// The limit curve of a Table, or of what `ellipse` or `box` made.
template <class Real>
godobject::BasicFingerCurve<Real> curve_of(nb::handle curve);

/// Parameters by the names of the C++ ones; `moment_ratio` is the curve's m₀, for a radius law from measured moments. Throws TypeError for an unknown name; ValueError for what is no number or radius law.
godobject::FingerParameters parameters_of(const nb::kwargs& given, double moment_ratio);
/// The projection among the keywords, which it takes out; by default the closest point.
godobject::Projection take_projection(nb::kwargs& given);

}  // namespace limitcurve::python
