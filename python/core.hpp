// SPDX-License-Identifier: MIT
#pragma once

#include "python/arrays.hpp"

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/patch.hpp"
#include "limitcurve/table.hpp"

#include <memory>
#include <string>
#include <vector>

/// Shared by the sources of the module: the objects behind the Python classes, and a function a source that adds its classes.
namespace limitcurve::python {

void add_curves(nb::module_& module);
void add_fingers(nb::module_& module);
void add_batches(nb::module_& module);
void add_patches(nb::module_& module);

/// A law with its origin: its text, and the samples of a measured profile, because their file may change.
struct PyLaw {
  Law law;
  std::string text;
  std::vector<PressureSample> profile = {};
};

/// An ellipse or a box in place of a table.
struct PyCurve {
  godobject::FingerCurve curve;
  godobject::BasicFingerCurve<float> single;
  std::string name;
};

/// A law from a str or a Law.
Law law_of(nb::handle law);
/// The limit curve of a Table or of a Curve from `ellipse` or `box`.
template <class Real>
godobject::BasicFingerCurve<Real> curve_of(nb::handle curve);

/// Parameters by their C++ names; `moment_ratio` is the curve's m₀, for a radius law from measured moments. TypeError for an unknown name,
/// ValueError for a bad number or radius law.
godobject::FingerParameters parameters_of(const nb::kwargs& given, double moment_ratio);
/// Removes the projection from the keywords and returns it; default closest point.
godobject::Projection take_projection(nb::kwargs& given);

}  // namespace limitcurve::python
