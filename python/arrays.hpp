// SPDX-License-Identifier: MIT
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include "limitcurve/internal/range.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Texts from and to Python as os.fsencode and os.fsdecode have them, because many are or have names of files: bytes
/// that are not UTF-8 pass.
template <>
struct nanobind::detail::type_caster<std::string> {
  NB_TYPE_CASTER(std::string, const_name("str"))

  template <class Flags>
  bool from_python(handle text, Flags, cleanup_list*) noexcept {
    const object bytes = steal(PyUnicode_Check(text.ptr()) ? PyUnicode_EncodeFSDefault(text.ptr()) : nullptr);
    if (!bytes.is_valid()) {
      PyErr_Clear();
      return false;
    }
    value.assign(PyBytes_AsString(bytes.ptr()), static_cast<std::size_t>(PyBytes_Size(bytes.ptr())));
    return true;
  }
  static handle from_cpp(const std::string& text, rv_policy, cleanup_list*) noexcept {
    return PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size()));
  }
};

/// Conversion of numbers from and to Python: anything that NumPy accepts as real numbers, of any shape.
namespace limitcurve::python {

namespace nb = nanobind;

/// `numpy.NAME`, looked up once a name.
nb::handle numpy(const char* name);

/// Three numbers as a new array; without one Python's error is set.
nb::handle array_of(const Eigen::Vector3d& numbers) noexcept;

/// The caller's numbers, contiguous; copied only if they are not contiguous.
template <class Real>
struct Numbers {
  nb::object array;  ///< keeps the data alive
  const Real* data;
  std::size_t size;
  int dimensions;
};

/// Whether a mask leaves out some of the caller's numbers.
bool is_masked(nb::handle values);

/// Warns the caller; of lines that begin with "note: " or "warning: ", without that.
void warn(const std::string& text);
void warn(const std::vector<std::string>& remarks);

/// Whether the caller's numbers have single precision; results then have it, too.
bool is_single(nb::handle values);

/// The caller's values as an array of Real. ValueError with `name` if they are no real numbers, or if numbers alone
/// would lose their meaning: times, a unit, a mask.
template <class Real>
Numbers<Real> numbers_of(nb::handle values, const std::string& name);

/// Columns of one length, without the rows that are masked in one of them, which are said. With a `table` the names are
/// those of its columns. With `refused` a column that is none of numbers is empty, and its complaint there; else it is
/// thrown.
std::vector<Numbers<double>> columns_of(const std::string& table, const std::vector<std::string>& names,
                                        const nb::list& columns, std::vector<std::string>* refused = nullptr);

/// The same for several, broadcast against each other.
template <class Real>
std::vector<Numbers<Real>> broadcast(std::span<const nb::handle> values, std::span<const char* const> names);

/// Any number.
inline constexpr Range any{-ranges::infinite, ranges::infinite, "any"};

/// Throws for a number out of the range; NaN passes.
template <class Real>
void require(const Real* numbers, std::size_t size, const char* name, const Range& range);

/// A number of Python itself, or of NumPy in single precision: arrays would cost a hundred times what the result does.
std::optional<double> plain_number(nb::handle value);

/// A new array with the shape of another, and its numbers.
template <class Real>
struct Results {
  nb::object array;
  Real* data;
};
template <class Real>
Results<Real> results_like(const nb::object& array);

/// The result for the caller: a float for a scalar in double precision, otherwise an array or a scalar of NumPy.
template <class Real>
nb::object handed_over(const Results<Real>& results);

/// Calls `work` with a number of the caller's precision.
template <class Work>
nb::object in_precision(bool single, const Work& work) {
  return single ? work(float{}) : work(double{});
}

/// A number; `standard` for None. ValueError with `name` and the value if it is none.
double number_of(nb::handle value, std::string_view name);
double number_of(nb::handle value, std::string_view name, double standard);
/// A text; `standard` for None. ValueError likewise.
std::string string_of(nb::handle value, const std::string& name, const std::string& standard);
std::string string_of(nb::handle value, const std::string& name);
/// A value for an error message: its repr(), shortened.
std::string shown(nb::handle value);
/// Throws ValueError "NAME: got VALUE, expected EXPECTED".
[[noreturn]] void refuse(std::string_view name, nb::handle value, std::string_view expected);

/// What `bool(value)` is, of NumPy's truths too.
bool truth_of(nb::handle value);

/// Three numbers from a sequence or an array. ValueError with `name` if they are not.
Eigen::Vector3d three_numbers(nb::handle values, const char* name);
Eigen::Vector4d four_numbers(nb::handle values, const char* name);

/// Arguments of an overload for the usual kinds of value, which nanobind reads in half the time. They refuse any other
/// value without an error: the overload for all kinds, which comes after, takes it or says what is wrong.
struct PlainNumber {
  double value;  ///< of a float or an int
};
struct PlainVector {
  Eigen::Vector3d value;  ///< of a tuple of three of them, or an array in double precision
};
bool read(nb::handle from, PlainNumber& to) noexcept;
bool read(nb::handle from, PlainVector& to) noexcept;

/// str(object).
std::string text_of(const nb::object& object);

/// A path from a str or os.PathLike.
std::string path_of(nb::handle path);

/// Raises what Python's signal handlers raise (KeyboardInterrupt for Ctrl-C), at most twenty times a second: the
/// library calls it in long work, without the GIL.
inline void raise_signals() {
  using Clock = std::chrono::steady_clock;
  static thread_local Clock::time_point next{};
  if (Clock::now() < next) return;
  next = Clock::now() + std::chrono::milliseconds(50);
  const nb::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
}

/// Calls work(i) for each i < count, without the GIL. Ctrl-C ends it between two blocks, which are to take at most 0.1
/// s: the larger the less its clock costs.
template <std::size_t block = 16, class Work>
void for_each_point(std::size_t count, const Work& work) {
  const nb::gil_scoped_release release;
  for (std::size_t begin = 0; begin < count; begin += block) {
    raise_signals();
    for (std::size_t i = begin; i < (std::min)(begin + block, count); ++i) work(i);
  }
}

/// `at` of numbers that are broadcast against each other: it takes an array of `count` numbers and gives one of
/// `results`. A NaN gives NaN. In single precision if all numbers are. Sixteen results, or `block`, take less than 0.1
/// s.
template <std::size_t results, std::size_t block = 16, std::size_t count, class At>
nb::object of_numbers(const std::array<nb::handle, count>& values, const std::array<const char*, count>& names,
                      const std::array<Range, count>& ranges, const At& at) {
  const auto values_at = [&](const std::array<double, count>& numbers) {
    std::array<double, results> found;
    if (std::any_of(numbers.begin(), numbers.end(), [](double number) { return std::isnan(number); })) {
      found.fill(std::numeric_limits<double>::quiet_NaN());
    } else {
      found = at(numbers);
    }
    return found;
  };
  const auto handed = [](const auto& result) -> nb::object {
    return [&]<std::size_t... i>(std::index_sequence<i...>)->nb::object {
      if constexpr (results == 1)
        return result(0);
      else
        return nb::make_tuple(result(i)...);
    }
    (std::make_index_sequence<results>());
  };
  std::array<double, count> plain;
  std::size_t known = 0;
  for (std::optional<double> one; known < count && (one = plain_number(values[known])); ++known) plain[known] = *one;
  if (known == count) {
    for (std::size_t i = 0; i < count; ++i) require(&plain[i], 1, names[i], ranges[i]);
    const std::array<double, results> found = values_at(plain);
    const bool single =
        std::all_of(values.begin(), values.end(), [](nb::handle value) { return value.type().is(numpy("float32")); });
    return handed([&](std::size_t i) -> nb::object {
      return single ? numpy("float32")(static_cast<float>(found[i])) : nb::object(nb::float_(found[i]));
    });
  }
  return in_precision(std::all_of(values.begin(), values.end(), is_single), [&]<class Real>(Real) -> nb::object {
    const std::vector<Numbers<Real>> numbers = broadcast<Real>(values, names);
    for (std::size_t i = 0; i < count; ++i) require(numbers[i].data, numbers[i].size, names[i], ranges[i]);
    std::array<Results<Real>, results> found;
    for (Results<Real>& one : found) one = results_like<Real>(numbers[0].array);
    for_each_point<block>(numbers[0].size, [&](std::size_t i) {
      std::array<double, count> given;
      for (std::size_t j = 0; j < count; ++j) given[j] = static_cast<double>(numbers[j].data[i]);
      const std::array<double, results> values_here = values_at(given);
      for (std::size_t j = 0; j < results; ++j) found[j].data[i] = static_cast<Real>(values_here[j]);
    });
    return handed([&](std::size_t i) { return handed_over(found[i]); });
  });
}

}  // namespace limitcurve::python

/// nanobind's own takes eight times as long.
template <>
struct nanobind::detail::type_caster<Eigen::Vector3d> {
  NB_TYPE_CASTER(Eigen::Vector3d, const_name("numpy.typing.NDArray[numpy.float64]"))
  static handle from_cpp(const Eigen::Vector3d& numbers, rv_policy, cleanup_list*) noexcept {
    return limitcurve::python::array_of(numbers);
  }
};
template <class Plain>
requires std::is_same_v<Plain, limitcurve::python::PlainNumber> ||
    std::is_same_v<Plain, limitcurve::python::PlainVector>
struct nanobind::detail::type_caster<Plain> {
  NB_TYPE_CASTER(Plain, const_name("typing.Any"))
  template <class Flags>
  bool from_python(handle from, Flags, cleanup_list*) noexcept {
    return limitcurve::python::read(from, value);
  }
};
