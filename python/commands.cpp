// SPDX-License-Identifier: MIT
// The command line in the interpreter's process: rows come back as arrays, errors as exceptions with the same message.
#include "cli/command_line.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/memory_columns.hpp"

#include "python/core.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::python {

namespace {

using cli::Column;

using NamedArrays = std::vector<std::pair<std::string, nb::ndarray<const double, nb::c_contig, nb::ndim<1>>>>;

/// A caller's columns, of one length, which the command line reads as a file.
class PyColumns : public cli::MemoryColumns {
 public:
  PyColumns(std::string name, const NamedArrays& columns, std::vector<std::string> refused)
      : MemoryColumns(std::move(name), names(columns), numbers(columns), std::move(refused)), columns_(columns) {}

 private:
  static std::vector<std::string> names(const NamedArrays& columns) {
    std::vector<std::string> result;
    for (const auto& [name, array] : columns) result.push_back(name);
    return result;
  }
  static std::vector<std::span<const double>> numbers(const NamedArrays& columns) {
    std::vector<std::span<const double>> result;
    for (const auto& [name, array] : columns) result.emplace_back(array.data(), array.size());
    return result;
  }

  NamedArrays columns_;  ///< keeps the numbers alive
};

template <class Number>
nb::object array_of(const std::vector<double>& numbers) {
  auto* const data = new std::vector<Number>(numbers.begin(), numbers.end());
  const nb::capsule owner(data, [](void* pointer) noexcept { delete static_cast<std::vector<Number>*>(pointer); });
  return nb::cast(nb::ndarray<nb::numpy, Number>(data->data(), {data->size()}, owner));
}

nb::object array_of(const Column& column) {
  if (!column.numbers.empty() && !column.texts.empty())
    throw std::logic_error("a column of numbers and texts: " + column.name);
  const nb::handle asarray = numpy("asarray");
  if (!column.texts.empty()) return asarray(nb::cast(column.texts), nb::arg("dtype") = "str");
  switch (column.kind) {
    case Column::Kind::integer:
      return array_of<std::int64_t>(column.numbers);
    case Column::Kind::truth:
      return asarray(array_of<double>(column.numbers), nb::arg("dtype") = "bool");
    default:
      return array_of<double>(column.numbers);
  }
}

/// Appends to `said` what the command says on standard error, also where it fails.
nb::dict run(const std::vector<std::string>& arguments, nb::list said) {
  const auto named = &cli::MemoryColumns::named;
  std::vector<Column> columns;
  std::vector<std::string> lines;
  const auto hand_over_lines = [&] {
    for (std::string& line : lines) said.append(named(std::move(line)));
    lines.clear();
  };
  try {
    const nb::gil_scoped_release release;
    cli::OutputFile output(cli::descriptor::standard_output, "standard output");
    cli::Messages messages(lines);
    cli::run_command_line(arguments, {.output = output, .columns = &columns, .messages = &messages});
  } catch (const std::exception& error) {
    hand_over_lines();
    if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr ||
        dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
        dynamic_cast<const nb::python_error*>(&error) != nullptr) {
      throw;
    }
    throw std::runtime_error(error.what());
  }
  hand_over_lines();
  nb::dict result;
  for (Column& column : columns) {
    for (std::string& text : column.texts) text = named(std::move(text));
    result[column.name.c_str()] = array_of(column);
  }
  return result;
}

/// All that makes a patch; its units have been asked.
cli::PatchArgument of_numbers(const PyPatch& patch) {
  cli::PatchArgument made = patch.made_of;
  made.text.clear();
  for (const auto& [mx, my] : patch.multiplied_by) {
    made.mx *= mx;
    made.my *= my;
  }
  return made;
}

}  // namespace

void add_commands(nb::module_& module) {
  nb::class_<PyColumns>(module, "MemoryColumns",
                        "Columns of numbers that the command line reads as a file of that path.")
      .def(nb::init<std::string, const NamedArrays&, std::vector<std::string>>(), nb::arg("name"), nb::arg("columns"),
           nb::arg("refused"))
      .def_prop_ro("path", &PyColumns::path);
  nb::class_<cli::MemoryPatch>(module, "MemoryPatch",
                               "A patch that the command line reads as a description of that path.")
      .def("__init__", [](cli::MemoryPatch* self,
                          const PyPatch& patch) { new (self) cli::MemoryPatch(patch.words(), of_numbers(patch)); })
      .def_prop_ro("path", &cli::MemoryPatch::path);
  module.def("run", &run, nb::arg("arguments"), nb::arg("said"),
             "Runs `limitcurve ARGUMENTS` and returns its columns; appends to `said` what it says on standard error.",
             nb::sig("def run(arguments: collections.abc.Sequence[str], said: list[str]) -> dict[str, "
                     "numpy.typing.NDArray[typing.Any]]"));
  module.def("main", &cli::run_program, nb::call_guard<nb::gil_scoped_release>(), nb::arg("arguments"),
             "Runs `limitcurve ARGUMENTS` as a program; returns its exit status.");
}

}  // namespace limitcurve::python
