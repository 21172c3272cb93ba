// SPDX-License-Identifier: MIT
#include "python/core.hpp"

#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/version.hpp"

#include <cmath>
#include <string>

namespace limitcurve::python {

namespace {

nb::object numpy(const char* name) {
  return nb::module_::import_("numpy").attr(name);
}

/// An array made by NumPy; ValueError if it cannot.
nb::object as_array(nb::handle values, const char* name) {
  nb::object array;
  try {
    array = numpy("asarray")(values);
  } catch (nb::python_error& error) {
    throw std::invalid_argument(std::string(name) + ": expected numbers, got " + error.what());
  }
  const std::string kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
  if (kind.find_first_of("fiub") != 0) {
    throw std::invalid_argument(std::string(name) + ": got an array of " + text_of(array.attr("dtype")) + ", expected real numbers");
  }
  return array;
}

template <class Real>
Numbers<Real> contiguous(const nb::object& array) {
  const nb::object converted =
      numpy("asarray")(array, nb::arg("dtype") = sizeof(Real) == sizeof(float) ? "float32" : "float64", nb::arg("order") = "C");
  const auto view = nb::cast<nb::ndarray<const Real, nb::c_contig, nb::ndim<1>>>(converted.attr("reshape")(-1));
  return {converted, view.data(), view.size()};
}

}  // namespace

bool is_single(nb::handle values) {
  return nb::hasattr(values, "dtype") && text_of(values.attr("dtype")) == "float32";
}

template <class Real>
Numbers<Real> numbers_of(nb::handle values, const char* name) {
  return contiguous<Real>(as_array(values, name));
}
template Numbers<double> numbers_of(nb::handle values, const char* name);
template Numbers<float> numbers_of(nb::handle values, const char* name);

std::vector<Numbers<double>> broadcast(std::initializer_list<nb::handle> values, std::initializer_list<const char*> names) {
  nb::list arrays;
  const char* const* name = names.begin();
  for (const nb::handle one : values) arrays.append(as_array(one, *name++));
  std::vector<Numbers<double>> result;
  for (const nb::handle one : numpy("broadcast_arrays")(*arrays)) result.push_back(contiguous<double>(nb::borrow(one)));
  return result;
}

Results results_like(const nb::object& array) {
  const nb::object made = numpy("empty")(array.attr("shape"));
  return {made, nb::cast<nb::ndarray<double, nb::c_contig, nb::ndim<1>>>(made.attr("reshape")(-1)).data()};
}

nb::object handed_over(const Results& results, bool single) {
  if (nb::cast<int>(results.array.attr("ndim")) == 0 && !single) return nb::float_(results.data[0]);
  // An array without dimensions becomes a scalar.
  return single ? nb::object(results.array.attr("astype")("float32")[nb::make_tuple()]) : results.array;
}

Eigen::Vector3d three_numbers(nb::handle values, const char* name) {
  const nb::object items = nb::steal(PySequence_Fast(values.ptr(), "expected three numbers"));
  if (!items.is_valid()) {
    PyErr_Clear();
    throw std::invalid_argument(std::string(name) + ": expected three numbers");
  }
  const Py_ssize_t length = PySequence_Fast_GET_SIZE(items.ptr());
  if (length != 3) throw std::invalid_argument(std::string(name) + ": got " + std::to_string(length) + " numbers, expected three");
  Eigen::Vector3d result;
  for (Py_ssize_t i = 0; i < 3; ++i) {
    result[i] = PyFloat_AsDouble(PySequence_Fast_GET_ITEM(items.ptr(), i));
    if (result[i] == -1.0 && PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw std::invalid_argument(std::string(name) + ": expected three numbers");
    }
  }
  return result;
}

std::string text_of(const nb::object& object) {
  return nb::cast<std::string>(nb::str(object));
}

std::string path_of(nb::handle path) {
  return nb::cast<std::string>(nb::module_::import_("os").attr("fsdecode")(path));
}

}  // namespace limitcurve::python

NB_MODULE(_core, module) {
  using namespace limitcurve::python;
  module.doc() = "Laws, tables, fingers, batches and patches: the C++ library. Use it as `limitcurve`.";
  module.attr("version") = nb::str(limitcurve::version.data(), limitcurve::version.size());
  limitcurve::between_samples = raise_signals;
  add_curves(module);
  add_fingers(module);
  add_batches(module);
  add_patches(module);
}
