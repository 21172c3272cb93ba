// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>  // without it a cast to a text compiles, but fails at run time

#include <Eigen/Core>

#include <array>
#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <vector>

/// Conversion of numbers from and to Python: anything that NumPy accepts as real numbers, of any shape.
namespace limitcurve::python {

namespace nb = nanobind;

/// The caller's numbers, contiguous; copied only if they are not contiguous.
template <class Real>
struct Numbers {
  nb::object array;  ///< keeps the data alive
  const Real* data;
  std::size_t size;
};

/// Whether the caller's numbers have single precision; results then have it, too.
bool is_single(nb::handle values);

/// The caller's values as an array of Real. ValueError with `name` if they are no real numbers.
template <class Real>
Numbers<Real> numbers_of(nb::handle values, const char* name);

/// The same for several, broadcast against each other.
std::vector<Numbers<double>> broadcast(std::initializer_list<nb::handle> values, std::initializer_list<const char*> names);

/// A new array of doubles with the shape of another, and its numbers.
struct Results {
  nb::object array;
  double* data;
};
Results results_like(const nb::object& array);

/// The result for the caller: a float for a scalar, otherwise an array in the caller's precision.
nb::object handed_over(const Results& results, bool single);

/// Three numbers from a sequence or an array. ValueError with `name` if they are not.
Eigen::Vector3d three_numbers(nb::handle values, const char* name);

/// str(object).
std::string text_of(const nb::object& object);

/// A path from a str or os.PathLike.
std::string path_of(nb::handle path);

/// Raises what Python's signal handlers raise (KeyboardInterrupt for Ctrl-C), at most twenty times a second: the library calls it in long work,
/// without the GIL.
inline void raise_signals() {
  using Clock = std::chrono::steady_clock;
  static thread_local Clock::time_point next{};
  if (Clock::now() < next) return;
  next = Clock::now() + std::chrono::milliseconds(50);
  const nb::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

}  // namespace limitcurve::python
