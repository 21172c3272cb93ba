// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>  // wherever it is not seen, a cast to a text compiles, and fails when it runs

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

/// How the Python package takes and gives numbers: anything that NumPy takes for real numbers, of any shape.
namespace limitcurve::python {

namespace nb = nanobind;

/// Numbers of the caller, contiguous; copied only where they are not.
template <class Real>
struct Numbers {
  nb::object array;  ///< keeps the data alive
  const Real* data;
  std::size_t size;
};

/// Whether a caller's numbers are of single precision: results are, then, too.
bool is_single(nb::handle values);

/// The caller's values as an array of Real. Throws ValueError for what are no real numbers; `name` says whose.
template <class Real>
Numbers<Real> numbers_of(nb::handle values, const char* name);

/// The same for several, broadcast against each other.
std::vector<Numbers<double>> broadcast(std::initializer_list<nb::handle> values, std::initializer_list<const char*> names);

/// A new array of doubles of the shape of another (with `columns` > 0 in place of the last length), and its numbers.
struct Results {
  nb::object array;
  double* data;
};
Results results_like(const nb::object& array);

/// What the caller gets: a float of a scalar, an array in the caller's precision else.
nb::object handed_over(const Results& results, bool single);

/// Three numbers from a sequence or an array. Throws ValueError naming what they are.
Eigen::Vector3d three_numbers(nb::handle values, const char* name);

/// str(object).
std::string text_of(const nb::object& object);

/// A path in the caller's words: str or os.PathLike.
std::string path_of(nb::handle path);

}  // namespace limitcurve::python
