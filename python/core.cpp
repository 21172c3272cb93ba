// SPDX-License-Identifier: MIT
#include "python/core.hpp"

#include "cli/io/memory_columns.hpp"
#include "godobject/finger/finger_parameter_table.hpp"
#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"

#include <nanobind/stl/vector.h>

#include <algorithm>
#include <exception>

namespace limitcurve::python {

namespace {

/// Lets pass what is no error of the caller's values: Ctrl-C inside them, no memory.
void rethrow_unless_of_values(nb::python_error& error) {
  if (!error.matches(PyExc_Exception) || error.matches(PyExc_MemoryError)) throw error;
}

/// An array made by NumPy; ValueError if it cannot, or if it would lose a unit or a mask.
nb::object as_array(nb::handle values, const std::string& name) {
  nb::object array;
  const auto kind = [&] { return nb::cast<std::string>(array.attr("dtype").attr("kind")); };
  try {
    array = numpy("asarray")(values);
    if (kind() == "O") array = numpy("asarray")(array.attr("tolist")());  // of what kind are the objects?
  } catch (nb::python_error& error) {
    rethrow_unless_of_values(error);
    throw std::invalid_argument(name + ": expected numbers, got " + error.what());
  }
  if (kind().find_first_of("mM") == 0) {
    throw std::invalid_argument(name + ": got times of " + text_of(array.attr("dtype")) +
                                ", expected numbers in seconds: (t - t[0]) / numpy.timedelta64(1, 's')");
  }
  if (kind().find_first_of("fiub") != 0) {
    throw std::invalid_argument(name + ": got an array of " + text_of(array.attr("dtype")) + ", expected real numbers");
  }
  if (values.type().is(numpy("ndarray"))) return array;
  if (is_masked(values))
    throw std::invalid_argument(name + ": got masked numbers, expected none: fill or compress them");
  for (const char* const unit : {"unit", "units"}) {
    if (nb::isinstance(values, numpy("ndarray")) && nb::hasattr(values, unit))
      throw std::invalid_argument(name + ": got numbers in " + text_of(values.attr(unit)) +
                                  ", expected plain numbers in SI units");
  }
  return array;
}

template <class Real>
constexpr const char* dtype_of = sizeof(Real) == sizeof(float) ? "float32" : "float64";

/// The numbers of a plain array if they are contiguous and of this type.
template <class Real>
std::optional<Numbers<Real>> in_place(nb::handle array) {
  Py_buffer buffer;
  if (!array.type().is(numpy("ndarray"))) return std::nullopt;
  if (PyObject_GetBuffer(array.ptr(), &buffer, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) {
    PyErr_Clear();
    return std::nullopt;
  }
  std::optional<Numbers<Real>> numbers;
  if (std::string_view(buffer.format) == (sizeof(Real) == sizeof(double) ? "d" : "f"))
    numbers = {nb::borrow(array), static_cast<const Real*>(buffer.buf),
               static_cast<std::size_t>(buffer.len) / sizeof(Real), buffer.ndim};
  PyBuffer_Release(&buffer);
  return numbers;
}

template <class Real>
Numbers<Real> contiguous(const nb::object& array) {
  const nb::object converted = numpy("asarray")(array, nb::arg("dtype") = dtype_of<Real>, nb::arg("order") = "C");
  const std::optional<Numbers<Real>> numbers = in_place<Real>(converted);
  return numbers ? *numbers : in_place<Real>(converted.attr("copy")()).value();  // it was not aligned
}

}  // namespace

nb::handle numpy(const char* name) {
  static std::vector<std::pair<const char*, nb::handle>> known;  // by the literals' addresses; the GIL guards it
  for (const auto& [known_name, value] : known)
    if (known_name == name) return value;
  const nb::handle value = nb::object(nb::module_::import_("numpy").attr(name)).release();
  return known.emplace_back(name, value).second;
}

nb::handle array_of(const Eigen::Vector3d& numbers) noexcept {
  try {
    nb::object array = numpy("empty")(3);
    Py_buffer buffer;
    if (PyObject_GetBuffer(array.ptr(), &buffer, PyBUF_WRITABLE) != 0) return {};
    std::memcpy(buffer.buf, numbers.data(), sizeof numbers);
    PyBuffer_Release(&buffer);
    return array.release();
  } catch (nb::python_error& error) {
    error.restore();
    return {};
  }
}

bool is_masked(nb::handle values) {
  return nb::cast<bool>(nb::bool_(nb::module_::import_("numpy.ma").attr("is_masked")(values)));
}

void warn(const std::string& text) {
  // Not by PyErr_WarnEx, which takes UTF-8 alone: a text may have the name of a file.
  nb::module_::import_("warnings").attr("warn")(text, nb::handle(PyExc_UserWarning));
}

void warn(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) warn(remark.substr(remark.find(": ") + 2));
}

bool is_single(nb::handle values) {
  return nb::hasattr(values, "dtype") && text_of(values.attr("dtype")) == "float32";
}

template <class Real>
Numbers<Real> numbers_of(nb::handle values, const std::string& name) {
  if (std::optional<Numbers<Real>> numbers = in_place<Real>(values)) return *std::move(numbers);
  return contiguous<Real>(as_array(values, name));
}
template Numbers<double> numbers_of(nb::handle values, const std::string& name);
template Numbers<float> numbers_of(nb::handle values, const std::string& name);

std::vector<Numbers<double>> columns_of(const std::string& table, const std::vector<std::string>& names,
                                        const nb::list& columns, std::vector<std::string>* refused) {
  const auto place = [&](std::size_t i) { return table.empty() ? names[i] : table + "['" + names[i] + "']"; };
  const nb::module_ masks = nb::module_::import_("numpy.ma");
  std::vector<Numbers<double>> result;
  nb::object masked = nb::none();
  std::string with_masks;
  std::size_t first = names.size();  // that has numbers
  if (refused != nullptr) refused->assign(names.size(), "");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool has_mask = is_masked(columns[i]);
    try {
      result.push_back(
          numbers_of<double>(has_mask ? masks.attr("getdata")(columns[i]) : nb::object(columns[i]), place(i)));
      if (!table.empty() && result[i].dimensions != 1) {
        throw std::invalid_argument(place(i) + ": got the shape " + text_of(result[i].array.attr("shape")) +
                                    ", expected one dimension");
      }
    } catch (const std::invalid_argument& error) {
      if (refused == nullptr) throw;
      (*refused)[i] = error.what();
      result.resize(i);
      result.push_back(numbers_of<double>(nb::list(), place(i)));
      continue;
    }
    first = std::min(first, i);
    if (result[i].size != result[first].size) {
      throw std::invalid_argument(place(i) + ": got " + std::to_string(result[i].size) + " numbers, expected " +
                                  std::to_string(result[first].size) + " as in '" + names[first] + "'");
    }
    if (!has_mask) continue;
    with_masks += (with_masks.empty() ? "" : ", ") + names[i];
    const nb::object mask = masks.attr("getmaskarray")(columns[i]).attr("reshape")(-1);
    masked = masked.is_none() ? mask : numpy("logical_or")(masked, mask);
  }
  if (masked.is_none()) return result;
  for (Numbers<double>& column : result) {
    if (column.size == 0) continue;
    column = contiguous<double>(column.array.attr("reshape")(-1)[numpy("logical_not")(masked)]);
  }
  warn((table.empty() ? with_masks : table) + ": rows with a masked number are left out, " +
       std::to_string(nb::cast<std::size_t>(numpy("count_nonzero")(masked))) + " of " +
       std::to_string(nb::len(masked)));
  return result;
}

template <class Real>
std::vector<Numbers<Real>> broadcast(std::span<const nb::handle> values, std::span<const char* const> names) {
  nb::list arrays;
  const char* const* name = names.data();
  for (const nb::handle one : values) arrays.append(as_array(one, *name++));
  std::vector<Numbers<Real>> result;
  for (const nb::handle one : numpy("broadcast_arrays")(*arrays)) result.push_back(contiguous<Real>(nb::borrow(one)));
  return result;
}
template std::vector<Numbers<double>> broadcast(std::span<const nb::handle> values, std::span<const char* const> names);
template std::vector<Numbers<float>> broadcast(std::span<const nb::handle> values, std::span<const char* const> names);

template <class Real>
void require(const Real* numbers, std::size_t size, const char* name, const Range& range) {
  const Real* const end = numbers + size;
  const Real* const bad = std::find_if(
      numbers, end, [&](Real number) { return double{number} < range.least || double{number} > range.most; });
  if (bad == end) return;
  const std::string place = size == 1 ? "" : "[" + std::to_string(bad - numbers) + "]";
  throw std::invalid_argument(name + place + ": got " + format_number(double{*bad}) + ", expected " +
                              std::string(range.text));
}
template void require(const double* numbers, std::size_t size, const char* name, const Range& range);
template void require(const float* numbers, std::size_t size, const char* name, const Range& range);

/// -1 with an error if it is none. Of an int PyFloat_AsDouble would make a float first.
static double as_double(nb::handle value) {
  return PyLong_CheckExact(value.ptr()) ? PyLong_AsDouble(value.ptr()) : PyFloat_AsDouble(value.ptr());
}

std::optional<double> plain_number(nb::handle value) {
  if (PyFloat_Check(value.ptr())) return PyFloat_AsDouble(value.ptr());
  if (!PyLong_CheckExact(value.ptr()) && !value.type().is(numpy("float32"))) return std::nullopt;
  const double number = as_double(value);
  if (number != -1.0 || PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();  // too large: said as of arrays
  return std::nullopt;
}

template <class Real>
Results<Real> results_like(const nb::object& array) {
  const nb::object made = numpy("empty")(array.attr("shape"), dtype_of<Real>);
  return {made, nb::cast<nb::ndarray<Real, nb::c_contig, nb::ndim<1>>>(made.attr("reshape")(-1)).data()};
}
template Results<double> results_like(const nb::object& array);
template Results<float> results_like(const nb::object& array);

template <class Real>
nb::object handed_over(const Results<Real>& results) {
  if (nb::cast<int>(results.array.attr("ndim")) != 0) return results.array;
  return sizeof(Real) == sizeof(double) ? nb::object(nb::float_(results.data[0])) : results.array[nb::make_tuple()];
}
template nb::object handed_over(const Results<double>& results);
template nb::object handed_over(const Results<float>& results);

/// As of arrays: times and complex numbers are none, nor is what a mask hides.
static bool is_of_numbers(nb::handle value) {
  if (PyFloat_Check(value.ptr()) || PyLong_CheckExact(value.ptr()) || !nb::hasattr(value, "dtype")) return true;
  const std::string kind = text_of(nb::getattr(value.attr("dtype"), "kind", nb::str("f")));
  return kind.find_first_of("mMc") == std::string::npos && !truth_of(nb::getattr(value, "mask", nb::bool_(false)));
}

double number_of(nb::handle value, std::string_view name) {
  const double number = as_double(value);
  if (PyErr_Occurred() == nullptr) {
    if (is_of_numbers(value)) return number;
  } else {
    nb::python_error error;
    rethrow_unless_of_values(error);
  }
  refuse(name, value, "a number");
}

double number_of(nb::handle value, std::string_view name, double standard) {
  return value.is_none() ? standard : number_of(value, name);
}

std::string string_of(nb::handle value, const std::string& name) {
  std::string text;
  if (!nb::try_cast(value, text)) refuse(name, value, "a str");
  return text;
}

std::string string_of(nb::handle value, const std::string& name, const std::string& standard) {
  return value.is_none() ? standard : string_of(value, name);
}

void refuse(std::string_view name, nb::handle value, std::string_view expected) {
  throw std::invalid_argument(std::string(name) + ": got " + shown(value) + ", expected " + std::string(expected));
}

std::string shown(nb::handle value) {
  constexpr std::size_t most = 60;
  try {
    std::string text = nb::cast<std::string>(nb::repr(value));
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.size() <= most ? text : text.substr(0, most) + "…";
  } catch (nb::python_error& error) {
    rethrow_unless_of_values(error);
    return nb::cast<std::string>(nb::inst_name(value));
  }
}

bool truth_of(nb::handle value) {
  const int truth = PyObject_IsTrue(value.ptr());
  if (truth < 0) throw nb::python_error();
  return truth == 1;
}

/// As many numbers as the vector has.
template <class Vector>
static Vector vector_of(nb::handle values, const char* name, const char* expected) {
  constexpr std::size_t size = Vector::SizeAtCompileTime;
  nb::object items = nb::borrow(values);
  if (!nb::isinstance<nb::list>(items) && !nb::isinstance<nb::tuple>(items)) {
    const std::optional<Numbers<double>> numbers = in_place<double>(values);
    if (numbers && numbers->dimensions == 1 && numbers->size == size) return Vector(numbers->data);
    if (!items.type().is(numpy("ndarray"))) items = numbers_of<double>(values, name).array;
    items = items.attr("tolist")();
    if (!nb::isinstance<nb::list>(items))
      throw std::invalid_argument(std::string(name) + ": got one number, expected " + expected);
  }
  const nb::tuple all(items);  // a copy: converting a number may change a list
  Vector vector;
  if (nb::len(all) != size)
    throw std::invalid_argument(std::string(name) + ": got " + std::to_string(nb::len(all)) + " numbers, expected " +
                                expected);
  for (std::size_t i = 0; i < size; ++i) vector[static_cast<Eigen::Index>(i)] = number_of(all[i], name);
  return vector;
}

Eigen::Vector3d three_numbers(nb::handle values, const char* name) {
  return vector_of<Eigen::Vector3d>(values, name, "three");
}

Eigen::Vector4d four_numbers(nb::handle values, const char* name) {
  return vector_of<Eigen::Vector4d>(values, name, "four");
}

bool read(nb::handle from, PlainNumber& to) noexcept {
  if (!PyFloat_Check(from.ptr()) && !PyLong_CheckExact(from.ptr())) return false;
  to.value = as_double(from);
  if (to.value != -1.0 || PyErr_Occurred() == nullptr) return true;
  PyErr_Clear();
  return false;
}

bool read(nb::handle from, PlainVector& to) noexcept {
  if (!PyTuple_CheckExact(from.ptr())) {
    const std::optional<Numbers<double>> numbers = in_place<double>(from);
    if (!numbers || numbers->dimensions != 1 || numbers->size != 3) return false;
    to.value = Eigen::Vector3d(numbers->data);
    return true;
  }
  PlainNumber number;
  for (int i = 0; i < 3; ++i) {
    if (PyTuple_Size(from.ptr()) != 3 || !read(PyTuple_GetItem(from.ptr(), i), number)) return false;
    to.value[i] = number.value;
  }
  return true;
}

std::string text_of(const nb::object& object) {
  return nb::cast<std::string>(nb::str(object));
}

std::string path_of(nb::handle path) {
  try {
    return nb::cast<std::string>(nb::module_::import_("os").attr("fsdecode")(path));
  } catch (nb::python_error& error) {
    rethrow_unless_of_values(error);
    refuse("path", path, "a file's name");
  }
}

/// As nanobind does, but with names of files that are not UTF-8.
void translate(const std::exception_ptr& thrown, void*) {
  const auto raise = [](PyObject* type, const char* message) {
    PyErr_SetObject(type, nb::cast(cli::MemoryColumns::named(message)).ptr());
  };
  try {
    std::rethrow_exception(thrown);
  } catch (const nb::builtin_exception&) {
    throw;
  } catch (const std::invalid_argument& error) {
    raise(PyExc_ValueError, error.what());
  } catch (const std::runtime_error& error) {
    raise(PyExc_RuntimeError, error.what());
  }
}

}  // namespace limitcurve::python

static bool is_registered = false;

/// The module of the first import in this interpreter; null if there is none. Borrowed.
static PyObject* first_module() {
  return PyDict_GetItemString(PyInterpreterState_GetDict(PyInterpreterState_Get()), "limitcurve._core");
}

#define PyInit__core init_by_nanobind
NB_MODULE(_core, module) {
#undef PyInit__core
  using namespace limitcurve::python;
  // Types are registered once a process: imported again, for example by an add-on's reloader, the module has those of
  // the first.
  if (PyObject* const first = first_module()) {
    nb::cast<nb::dict>(module.attr("__dict__")).update(nb::cast<nb::dict>(nb::handle(first).attr("__dict__")));
    return;
  }
  is_registered = true;
  nb::borrow<nb::dict>(PyInterpreterState_GetDict(PyInterpreterState_Get()))["limitcurve._core"] = module;
  module.doc() =
      "Laws, tables, fingers, batches, patches and the command line: the C++ library. Use it as `limitcurve`.";
  nb::register_exception_translator(translate);
  module.attr("version") = nb::str(limitcurve::version.data(), limitcurve::version.size());
  limitcurve::between_samples = raise_signals;
  add_laws(module);
  add_curves(module);
  add_fingers(module);
  add_passivity(module);
  add_batches(module);
  add_patches(module);
  add_commands(module);
  module.def(
      "columns_of",
      [](const std::string& table, const std::vector<std::string>& names, const nb::list& columns) {
        nb::list result;
        std::vector<std::string> refused;
        for (const Numbers<double>& column : columns_of(table, names, columns, &refused)) result.append(column.array);
        return nb::make_tuple(result, refused);
      },
      nb::arg("table"), nb::arg("names"), nb::arg("columns"),
      nb::sig("def columns_of(table: str, names: collections.abc.Sequence[str], columns: list[typing.Any]) -> "
              "tuple[list[numpy.typing.NDArray[numpy.float64]], list[str]]"),
      "A table's columns as arrays of one length, without masked rows; and of each what is wrong with it, '' if it has "
      "numbers.");
  nb::list names;
  for (const auto& number : limitcurve::godobject::finger_parameter_table)
    names.append(nb::str(number.name.data(), number.name.size()));
  module.attr("finger_parameter_table") = names;
  module.def(
      "numbers_of", [](nb::handle values, const std::string& name) { return numbers_of<double>(values, name).array; },
      nb::arg("values"), nb::arg("name"),
      nb::sig("def numbers_of(values: numpy.typing.ArrayLike, name: str) -> numpy.typing.NDArray[numpy.float64]"),
      "An array of numbers. ValueError with their name if they are none.");
}

/// Refuses another interpreter before nanobind, whose own initialisation would take the types from the first.
extern "C" NB_EXPORT PyObject* PyInit__core() {
  if (!is_registered || first_module() != nullptr) return init_by_nanobind();
  PyErr_SetString(PyExc_ImportError,
                  "limitcurve._core: another interpreter of this process has imported it, expected one");
  return nullptr;
}
