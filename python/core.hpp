// SPDX-License-Identifier: MIT
#pragma once

#include "python/arrays.hpp"

#include "cli/io/patch_argument.hpp"

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/measured/samples.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/version.hpp"

#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Shared by the sources of the module: the objects behind the Python classes, and a function a source that adds its
/// classes.
namespace limitcurve::python {

void add_laws(nb::module_& module);
void add_curves(nb::module_& module);
void add_fingers(nb::module_& module);
void add_passivity(nb::module_& module);
void add_batches(nb::module_& module);
void add_patches(nb::module_& module);
void add_commands(nb::module_& module);

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
  double force_max;
  double moment_max;
};

/// A patch with all that makes it: what its text or arrays said, and the factors of orthotropic friction since.
struct PyPatch : Patch {
  cli::PatchArgument made_of;
  std::vector<std::pair<double, double>> multiplied_by;

  explicit PyPatch(cli::PatchArgument argument) : Patch(argument.patch()), made_of(std::move(argument)) {}
  [[nodiscard]] PyPatch orthotropic(double mx, double my) const {
    PyPatch there = *this;
    static_cast<Patch&>(there) = Patch::orthotropic(mx, my);
    there.multiplied_by.emplace_back(mx, my);
    return there;
  }
  /// Its text, or what its arrays are.
  [[nodiscard]] std::string words() const;
};

/// Its name, `ellipse` or `box`, and its semi-axes or limits. ValueError if they are out of range.
PyCurve closed_curve(const std::string& name, double force_max, double moment_max);

/// `at` of COR distances c, of any sign.
template <std::size_t results, std::size_t block = 16, class At>
nb::object of_cors(nb::handle c, const At& at) {
  return of_numbers<results, block, 1>({c}, {"c"}, {ranges::signed_distance},
                                       [&](const std::array<double, 1>& s) { return at(s[0]); });
}

/// Force and moment, as results of of_numbers.
inline std::array<double, 2> components(const UnitWrench& wrench) {
  return {wrench.force, wrench.moment};
}

/// A curve is what never changes: its copy is itself.
template <class Class>
void copies_are_itself(Class& type) {
  type.def("__copy__", [](nb::handle self) { return nb::borrow(self); });
  type.def("__deepcopy__", [](nb::handle self, nb::handle) { return nb::borrow(self); });
}

/// Another dict with the same contents, but for one name.
nb::dict without(const nb::dict& all, const char* name);

/// Plain numbers for pickle: their bytes, which are those of one version of the library alone.
template <class Numbers>
nb::tuple packed(const Numbers& numbers) {
  return nb::make_tuple(nb::str(version.data(), version.size()), nb::bytes(&numbers, sizeof numbers));
}
template <class Numbers>
Numbers unpacked(const nb::tuple& state) {
  const auto made_by = nb::cast<std::string>(state[0]);
  const auto bytes = nb::cast<nb::bytes>(state[1]);
  if (made_by != version || bytes.size() != sizeof(Numbers))
    throw std::invalid_argument("pickled by limitcurve " + made_by + ", expected " + std::string(version));
  Numbers numbers;
  std::memcpy(static_cast<void*>(&numbers), bytes.c_str(), sizeof numbers);
  return numbers;
}
template <class Numbers, class Class>
void pickle_plainly(Class& type) {
  type.def("__getstate__", [](const Numbers& self) { return packed(self); });
  type.def("__setstate__",
           [](Numbers& self, const nb::tuple& state) { new (&self) Numbers(unpacked<Numbers>(state)); });
}

/// A law from a str or a Law.
Law law_of(nb::handle law);

/// Warns where the law's own error of samples is above that of the curve which holds.
void warn_of_samples(const std::string& law, double own_error, double error_of_curve);
/// The limit curve of a Table or of a Curve from `ellipse` or `box`.
template <class Real>
godobject::BasicFingerCurve<Real> curve_of(nb::handle curve);

/// With what a radius law's file holds in place of its name: (text, loads, values).
nb::dict read_files(nb::dict given);
/// Parameters by their C++ names; other names are passed over. `moment_max` is the curve's unit moment of a
/// pure twist, for a radius law from measured moments. ValueError for a bad number or radius law.
godobject::FingerParameters parameters_of(const nb::dict& given, double moment_max);
/// Warns, with what is assumed, if none of a finger's parameters is given; a patch has its own size.
void warn_without_skin(const char* type, const nb::dict& given, bool of_patch = false);
/// Warns of a radius law whose radius at 1 N is hardly in metres.
void ask_unit(const RadiusLaw& law);
/// These parameters as keywords of a Python function, with types and defaults; for a patch without those of a round
/// contact's moment.
std::string parameters_signature(bool of_patch = false);
/// The projection of a word; default closest point.
godobject::Projection projection_of(nb::handle word);

}  // namespace limitcurve::python
