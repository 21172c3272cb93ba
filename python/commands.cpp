// SPDX-License-Identifier: MIT
// The command line in the interpreter's process: rows come back as arrays, errors as exceptions with the same message.
#include "cli/command_line.hpp"
#include "cli/report/share.hpp"

#include "python/arrays.hpp"

#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/vector.h>

#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

namespace limitcurve::python {

namespace {

using cli::Column;

/// A caller's columns as a CSV file for the command line, without a name in any directory.
class MemoryFile {
 public:
  /// `name` is the caller's name for it; columns of one length. Without header they are the columns of a matrix.
  MemoryFile(std::string name, const std::vector<std::pair<std::string, nb::object>>& columns, bool header)
      : name_(std::move(name)), descriptor_(::memfd_create("limitcurve", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error("no memory for " + name_);
    std::vector<Numbers> numbers;
    for (const auto& [column, array] : columns) {
      columns_.push_back(column);
      numbers.push_back(nb::cast<Numbers>(array));
    }
    write(numbers, header);
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  /// A message of the command line in the caller's terms: `trace['x'][17]` for `/proc/self/fd/5:19:8`.
  [[nodiscard]] std::string translated(std::string message) const {
    const std::string file = path();
    for (std::size_t at = message.find(file); at != std::string::npos; at = message.find(file, at + name_.size())) {
      std::size_t end = at + file.size();
      if (end < message.size() && message[end] >= '0' && message[end] <= '9') continue;  // another file's longer name
      std::string place = name_;
      std::size_t line = 0;
      std::size_t byte = 0;
      const char* const last = message.data() + message.size();
      if (end < message.size() && message[end] == ':') {
        const auto [after_line, fault] = std::from_chars(message.data() + end + 1, last, line);
        if (fault == std::errc() && after_line < last && *after_line == ':') {
          const auto [after_byte, other_fault] = std::from_chars(after_line + 1, last, byte);
          if (other_fault == std::errc()) {
            end = static_cast<std::size_t>(after_byte - message.data());
            place = place_of(line, byte);
          }
        }
      }
      message.replace(at, end - at, place);
    }
    return message;
  }

 private:
  using Numbers = nb::ndarray<const double, nb::c_contig, nb::ndim<1>>;

  void write(const std::vector<Numbers>& numbers, bool header) {
    const std::size_t rows = numbers.empty() ? 0 : numbers.front().size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i].size() == rows) continue;
      throw std::invalid_argument(name_ + "['" + columns_[i] + "']: got " + std::to_string(numbers[i].size()) + " numbers, expected " +
                                  std::to_string(rows) + " as in '" + columns_[0] + "'");
    }
    cli::OutputFile output(descriptor_, name_);
    header_lines_ = header ? 1 : 0;
    if (header) {
      std::string line;
      for (const std::string& column : columns_) line += (line.empty() ? "" : ",") + column;
      output.write(line + "\n");
    }
    std::array<char, 32> text{};
    for (std::size_t row = 0; row < rows; ++row) {
      raise_signals();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) output.write(",");
        const auto end = std::to_chars(text.data(), text.data() + text.size(), numbers[i].data()[row]).ptr;
        output.write({text.data(), static_cast<std::size_t>(end - text.data())});
      }
      output.write("\n");
    }
    output.flush();
  }

  /// Column and row, from 0, of a line and byte of the text, from 1.
  [[nodiscard]] std::string place_of(std::size_t line, std::size_t byte) const {
    if (line <= header_lines_) return name_;
    std::string text(1U << 16U, '\0');
    std::size_t current = 1;
    std::size_t column = 0;
    std::size_t at = 1;
    off_t offset = 0;
    for (ssize_t got = 0; current <= line && (got = ::pread(descriptor_, text.data(), text.size(), offset)) > 0; offset += got) {
      for (const char character : std::string_view(text.data(), static_cast<std::size_t>(got))) {
        if (current == line && at++ < byte && character == ',') ++column;
        if (character == '\n' && ++current > line) break;
      }
    }
    if (column >= columns_.size()) return name_;
    return name_ + "['" + columns_[column] + "'][" + std::to_string(line - header_lines_ - 1) + "]";
  }

  std::string name_;
  int descriptor_;
  std::vector<std::string> columns_;
  std::size_t header_lines_ = 0;
};

template <class Number>
nb::object array_of(const std::vector<double>& numbers) {
  auto* const data = new std::vector<Number>(numbers.begin(), numbers.end());
  const nb::capsule owner(data, [](void* pointer) noexcept { delete static_cast<std::vector<Number>*>(pointer); });
  return nb::cast(nb::ndarray<nb::numpy, Number>(data->data(), {data->size()}, owner));
}

nb::object array_of(const Column& column) {
  if (!column.numbers.empty() && !column.texts.empty()) throw std::logic_error("a column of numbers and texts: " + column.name);
  const nb::object asarray = nb::module_::import_("numpy").attr("asarray");
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

/// Calls `work` with errors in the caller's terms.
template <class Work>
void in_terms_of(const std::vector<const MemoryFile*>& files, const Work& work) {
  const auto translated = [&](std::string message) {
    for (const MemoryFile* const file : files) message = file->translated(std::move(message));
    return message;
  };
  try {
    work();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(translated(error.what()));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const nb::python_error&) {
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(translated(error.what()));
  }
}

/// Appends to `said` what the command says on standard error, also where it fails.
nb::dict run(const std::vector<std::string>& arguments, const std::vector<const MemoryFile*>& files, nb::list said) {
  std::vector<Column> columns;
  std::vector<std::string> lines;
  const auto hand_over_lines = [&] {
    for (std::string& line : lines) {
      for (const MemoryFile* const file : files) line = file->translated(std::move(line));
      said.append(line);
    }
  };
  try {
    in_terms_of(files, [&] {
      const nb::gil_scoped_release release;
      cli::OutputFile output(STDOUT_FILENO, "standard output");
      cli::Messages messages(lines);
      cli::run_command_line(arguments, {.output = output, .columns = &columns, .messages = &messages});
    });
  } catch (...) {
    hand_over_lines();
    throw;
  }
  hand_over_lines();
  nb::dict result;
  for (Column& column : columns) {
    for (std::string& text : column.texts) {
      for (const MemoryFile* const file : files) text = file->translated(std::move(text));
    }
    result[column.name.c_str()] = array_of(column);
  }
  return result;
}

/// Does the same as main().
int run_as_program(const std::vector<std::string>& arguments) {
  const nb::gil_scoped_release release;
  return cli::run_program(arguments);
}

}  // namespace

}  // namespace limitcurve::python

NB_MODULE(_commands, module) {
  using namespace limitcurve::python;
  // The package's folder is that of this module.
  if (Dl_info here{}; ::dladdr(reinterpret_cast<const void*>(&run_as_program), &here) != 0)
    limitcurve::cli::set_package_share(std::filesystem::absolute(here.dli_fname).parent_path() / "share");
  limitcurve::between_samples = raise_signals;
  module.doc() = "The command line, for `limitcurve`'s functions that return tables.";
  nb::class_<MemoryFile>(module, "MemoryFile", "Columns of numbers as a file that the command line reads.")
      .def(nb::init<std::string, const std::vector<std::pair<std::string, nb::object>>&, bool>(), nb::arg("name"), nb::arg("columns"),
           nb::arg("header") = true)
      .def_prop_ro("path", &MemoryFile::path);
  module.def(
      "run", &run, nb::arg("arguments"), nb::arg("files"), nb::arg("said"),
      "Runs `limitcurve ARGUMENTS` and returns its columns; appends to `said` what it says on standard error.",
      nb::sig(
          "def run(arguments: collections.abc.Sequence[str], files: collections.abc.Sequence[MemoryFile], said: list[str]) -> dict[str, "
          "numpy.typing.NDArray[typing.Any]]"));
  module.def("main", &run_as_program, nb::arg("arguments"), "Runs `limitcurve ARGUMENTS` as a program; returns its exit status.");
}
