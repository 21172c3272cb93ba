// SPDX-License-Identifier: MIT
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "cli/io/output_file.hpp"
#include "cli/io/table_reader.hpp"
#include "cli/io/table_writer.hpp"
#include "limitcurve/accuracy.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/half_spaces.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace limitcurve::python {

namespace {

nb::object wrench(const PyPatch& patch, const BoundArguments& given) {
  const nb::handle twists = given[0];
  const double mu = number_of(given[1], "mu", 1.0);
  const double load = number_of(given[2], "load", 1.0);
  const bool with_error = truth_of(given[3]);
  if (!(mu > 0.0 && std::isfinite(mu))) throw out_of_range("mu", mu, "1", "(0, inf)");
  if (!(load > 0.0 && std::isfinite(load))) throw out_of_range("load", load, "N", "(0, inf)");
  return in_precision(is_single(twists), [&]<class Real>(Real) -> nb::object {
    const Numbers<Real> all = numbers_of<Real>(twists, "twists");
    const nb::tuple shape = all.array.attr("shape");
    if (nb::len(shape) == 0 || nb::cast<std::size_t>(shape[nb::len(shape) - 1]) != 3) {
      throw std::invalid_argument("twists: got the shape " + text_of(shape) + ", expected (…, 3): vx, vy, omega");
    }
    const Results<Real> wrenches = results_like<Real>(all.array);
    const nb::object first = all.array[nb::make_tuple(nb::ellipsis(), 0)];
    const Results<Real> powers = results_like<Real>(first);
    const Results<Real> errors = results_like<Real>(first);
    const double limit = mu * load;
    for_each_point(all.size / 3, [&](std::size_t i) {
      const Real* const twist = all.data + 3 * i;
      const PatchFriction friction = patch.about_origin(
          {static_cast<double>(twist[0]), static_cast<double>(twist[1]), static_cast<double>(twist[2])});
      wrenches.data[3 * i] = static_cast<Real>(limit * friction.wrench.fx);
      wrenches.data[3 * i + 1] = static_cast<Real>(limit * friction.wrench.fy);
      wrenches.data[3 * i + 2] = static_cast<Real>(limit * friction.wrench.moment);
      powers.data[i] = static_cast<Real>(limit * friction.power);
      errors.data[i] = static_cast<Real>(friction.error);
    });
    if (!with_error) return handed_over(wrenches);
    return nb::make_tuple(handed_over(wrenches), handed_over(powers), handed_over(errors));
  });
}

nb::object loads_to_hold_patch(const PyPatch& patch, const BoundArguments& given) {
  if (patch.made_of.kind == "ellipse") {
    const Law law = patch.round_measures().law;
    warn_of_samples(law->name(), law->profile_error(), accuracy::patch_ellipse_other);
  }
  return of_numbers<1, 16, 4>({given[0], given[1], given[2], given[3]}, {"fx", "fy", "moment", "mu"},
                              {ranges::finite, ranges::finite, ranges::finite, ranges::non_negative},
                              [&](const std::array<double, 4>& of) {
                                return std::array{load_to_hold(patch, of[3], {of[0], of[1], of[2]})};
                              });
}

/// The patch, with warnings of what is odd about it.
PyPatch asked(cli::PatchArgument argument) {
  PyPatch patch(std::move(argument));
  warn(patch.made_of.remarks(patch));
  return patch;
}

nb::object slips(const PyPatch& patch, const BoundArguments& given) {
  constexpr double much = 1e-6;
  std::atomic<double> worst = much;
  const nb::object found =
      of_numbers<4, 16, 3>({given[0], given[1], given[2]}, {"fx", "fy", "moment"}, {any, any, any},
                           [&](const std::array<double, 3>& wrench) {
                             const auto [twist, gauge, error] = patch.slip({wrench[0], wrench[1], wrench[2]});
                             // An image's own error is larger, and known from `wrench`.
                             double before = worst;
                             const bool counts = error > before && error > 10.0 * patch.about_origin(twist).error;
                             while (counts && error > before && !worst.compare_exchange_weak(before, error)) {
                             }
                             return std::array{twist.vx, twist.vy, twist.omega, error};
                           });
  const bool asked_for_errors = truth_of(given[3]);
  if (worst > much && !asked_for_errors)
    warn("slip: a twist needs a wrench that is off by up to " + format_number(worst) +
         " of the load: ask for the errors with error=True");
  const nb::object twists = numpy("stack")(nb::make_tuple(found[0], found[1], found[2]), -1);
  if (!asked_for_errors) return twists;
  return nb::make_tuple(twists, found[3]);
}

nb::object half_spaces_of(const PyPatch& patch, const BoundArguments& given) {
  const double rows = number_of(given[0], "rows", 32.0);
  if (!(rows >= 8.0) || rows != std::floor(rows)) throw out_of_range("rows", rows, "1", "a whole number >= 8");
  const HalfSpaces found = half_spaces(patch, static_cast<std::size_t>(std::min(rows, 1e6)));
  const auto array = [](const auto& vectors) {
    std::vector<std::tuple<double, double, double>> numbers;
    for (const auto& [fx, fy, moment] : vectors) numbers.emplace_back(fx, fy, moment);
    return numpy("array")(nb::cast(numbers));
  };
  return nb::make_tuple(array(found.rows), array(found.vertices), found.share);
}

/// Two lengths as they are typed.
std::string sides(nb::handle first, const char* first_name, nb::handle second, const char* second_name) {
  return std::string(first_name) + "=" + format_number(number_of(first, first_name)) + "," + second_name + "=" +
         format_number(number_of(second, second_name));
}

/// A kind of patch from columns of numbers.
PyPatch of_columns(const char* kind, const std::vector<std::string>& names, const BoundArguments& given) {
  nb::list columns;
  for (const nb::object& column : given) columns.append(column);
  const auto all = columns_of("", names, columns);
  cli::PatchArgument made{.kind = kind, .columns = all.size()};
  for (std::size_t row = 0; row < all[0].size; ++row) {
    for (const Numbers<double>& column : all) made.numbers.push_back(column.data[row]);
  }
  return asked(std::move(made));
}

PyPatch image(const BoundArguments& given) {
  const nb::handle pressures = given[0];
  const nb::handle pixel = given[1];
  std::tuple<double, double> spacing;
  if (pixel.is_none() == given[2].is_none()) throw std::invalid_argument("expected one of pixel and spacing");
  if (pixel.is_none() && !nb::try_cast(given[2], spacing)) refuse("spacing", given[2], "(dy, dx)");
  if (!pixel.is_none()) spacing = {number_of(pixel, "pixel"), number_of(pixel, "pixel")};
  const bool has_mask = is_masked(pressures);
  const Numbers<double> all =
      numbers_of<double>(has_mask ? pressures.attr("filled")(0.0) : nb::borrow(pressures), "pressures");
  const nb::tuple shape = all.array.attr("shape");
  if (nb::len(shape) != 2)
    throw std::invalid_argument("pressures: got the shape " + text_of(shape) + ", expected two dimensions");
  const auto [dy, dx] = spacing;
  cli::PatchArgument made{.kind = "image",
                          .numbers = {all.data, all.data + all.size},
                          .columns = nb::cast<std::size_t>(shape[1]),
                          .x = dx,
                          .y = dy};
  if (has_mask)
    made.without_sensor = nb::cast<std::size_t>(nb::module_::import_("numpy.ma").attr("count_masked")(pressures));
  for (double& pressure : made.numbers) {
    if (!std::isnan(pressure)) continue;
    pressure = 0.0;
    ++made.without_sensor;
  }
  if (!given[3].is_none()) made.floor = number_of(given[3], "floor");
  return asked(std::move(made));
}

using PatchTableState = std::tuple<std::string, int, std::vector<double>, nb::bytes>;

PatchTableState table_state_of(const PatchTable& table) {
  const PatchTableContents contents = table.contents();
  std::vector<double> numbers;
  for (const auto& [name, number] : numbers_of(contents)) numbers.push_back(*number);
  return {contents.name, contents.cells, numbers,
          nb::bytes(contents.nodes.data(), contents.nodes.size() * sizeof(PatchTableContents::Node))};
}

PatchTable patch_table_of(const PatchTableState& state) {
  const auto& [name, cells, numbers, nodes] = state;
  PatchTableContents contents;
  contents.name = name;
  contents.cells = cells;
  std::size_t i = 0;
  for (const auto& [key, number] : numbers_of(contents)) *number = numbers.at(i++);
  contents.nodes.resize(nodes.size() / sizeof(PatchTableContents::Node));
  std::memcpy(contents.nodes.data(), nodes.data(), nodes.size());
  return PatchTable(std::move(contents));
}

using PatchState =
    std::tuple<std::string, std::string, std::vector<double>, std::size_t, std::vector<double>, std::string,
               std::vector<double>, std::vector<std::pair<double, double>>, std::optional<PatchTableState>>;

PatchState state_of(const PyPatch& self) {
  const cli::PatchArgument& made = self.made_of;
  std::vector<double> profile;
  for (const PressureSample& sample : made.profile) profile.insert(profile.end(), {sample.radius, sample.pressure});
  std::vector<double> lengths{made.x, made.y, made.mx, made.my};
  if (made.floor) lengths.push_back(*made.floor);
  std::optional<PatchTableState> table;
  if (made.table) table = table_state_of(*made.table);
  return {made.kind, made.text, made.numbers, made.columns, lengths, made.law, profile, self.multiplied_by, table};
}

PyPatch patch_of(const PatchState& state) {
  const auto& [kind, text, numbers, columns, lengths, law, profile, multiplied_by, table] = state;
  cli::PatchArgument made{.kind = kind,
                          .text = text,
                          .numbers = numbers,
                          .columns = columns,
                          .x = lengths.at(0),
                          .y = lengths.at(1),
                          .law = law,
                          .mx = lengths.at(2),
                          .my = lengths.at(3)};
  if (lengths.size() > 4) made.floor = lengths[4];
  for (std::size_t i = 0; i + 1 < profile.size(); i += 2) made.profile.push_back({profile[i], profile[i + 1]});
  if (table) made.table = patch_table_of(*table);
  PyPatch patch(std::move(made));
  for (const auto& [mx, my] : multiplied_by) patch = patch.orthotropic(mx, my);
  return patch;
}

/// A table of a patch, which is a patch.
struct PyPatchTable : PyPatch {
  explicit PyPatchTable(PatchTable table)
      : PyPatch(cli::PatchArgument{.kind = "table", .text = table.name(), .table = std::move(table)}) {}
  [[nodiscard]] const PatchTable& table() const { return *made_of.table; }
};

void add_patch_tables(nb::module_& module) {
  nb::class_<PyPatchTable, PyPatch> type(
      module, "PatchTable",
      "The limit surface of any patch as a table with a checked error: a Patch whose wrench costs the same whatever "
      "its\n"
      "shape. Use it where a loop has a large image, or an ellipse of a law without closed form.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> table = lc.PatchTable('ellipse:law=cone,a=0.004,b=0.002', tolerance=1e-3)\n"
      ">>> table.checked_error <= 1e-3, table.nbytes <= 2**21\n"
      "(True, True)\n");
  copies_are_itself(type);
  type.def("__getstate__", [](const PyPatchTable& self) { return table_state_of(self.table()); })
      .def("__setstate__",
           [](PyPatchTable& self, const PatchTableState& state) { new (&self) PyPatchTable(patch_table_of(state)); });
  define<PyPatchTable*>(
      type, "def __init__(self, patch: str | Patch, tolerance: float = 0.001) -> None",
      [](PyPatchTable* self, const BoundArguments& given) {
        const PyPatch patch = nb::isinstance<PyPatch>(given[0]) ? nb::cast<const PyPatch&>(given[0])
                                                                : asked(cli::parse_patch(string_of(given[0], "patch")));
        const double tolerance = number_of(given[1], "tolerance", PatchTable::default_tolerance);
        const PatchTable table = [&] {
          const nb::gil_scoped_release release;
          return PatchTable::build(patch, tolerance, patch.words());
        }();
        new (self) PyPatchTable(table);
      },
      "The smallest table with an error of at most `tolerance`, in [1e-5, 0.1], of the force in units of mu P, and of "
      "the moment\n"
      "in units of the largest one. Up to seconds. ValueError names the finest tolerance that 2 MiB allow. Releases "
      "the "
      "GIL.");
  define_static(
      type, "def load(path: str | os.PathLike[str]) -> PatchTable",
      [](const BoundArguments& given) { return PyPatchTable(cli::read_patch_table(path_of(given[0]))); },
      "Reads a .csv or .json file that `save` or `limitcurve table --patch` wrote.");
  define<const PyPatchTable&>(
      type, "def save(self, path: str | os.PathLike[str]) -> None",
      [](const PyPatchTable& self, const BoundArguments& given) {
        const std::string file = path_of(given[0]);
        const cli::PatchTableWriter text_of = cli::patch_table_writer(file, "path");
        const nb::gil_scoped_release release;  // the reader of a pipe may be another thread
        cli::AtomicFile::write(file, text_of(self.table()));
      },
      "Writes the whole table or nothing; the extension selects .csv or .json.");
  type.def("__repr__",
           [](const PyPatchTable& self) {
             return "<PatchTable of " + self.words() + ", error <= " + format_number(self.table().checked_error()) +
                    ">";
           })
      .def_prop_ro(
          "checked_error", [](const PyPatchTable& self) { return self.table().checked_error(); },
          "Bound on the error of force and moment against the patch, whose own error `wrench` adds.")
      .def_prop_ro(
          "tolerance", [](const PyPatchTable& self) { return self.table().tolerance(); }, "Requested tolerance.")
      .def_prop_ro(
          "nbytes", [](const PyPatchTable& self) { return self.table().bytes(); }, "Memory of the table.");
}

}  // namespace

std::string PyPatch::words() const {
  std::string text = made_of.text.empty()
                         ? made_of.kind + " of " + std::to_string(made_of.numbers.size() / made_of.columns) + " rows"
                         : made_of.text;
  for (const auto& [mx, my] : multiplied_by) text += ",mx=" + format_number(mx) + ",my=" + format_number(my);
  return text;
}

void add_patches(nb::module_& module) {
  nb::class_<PyPatch> type(
      module, "Patch",
      "A contact of any shape, in the command line's grammar ('points:FILE.csv', 'polygon:FILE.csv',\n"
      "'rectangle:x=0.02,y=0.01', 'ellipse:law=hertz,a=0.004,b=0.002', 'image:FILE.csv,pixel=0.0005', each with "
      "',mx=…,my=…'), or\n"
      "from arrays. Lengths in metres.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> patch = lc.Patch('rectangle:x=0.02,y=0.01')\n"
      ">>> [round(float(x), 12) + 0.0 for x in patch.wrench([0.1, 0, 0])]\n"
      "[1.0, 0.0, 0.0]\n");
  copies_are_itself(type);
  type.def("__getstate__", &state_of).def("__setstate__", [](PyPatch& self, const PatchState& state) {
    new (&self) PyPatch(patch_of(state));
  });
  define<PyPatch*>(
      type, "def __init__(self, text: str) -> None",
      [](PyPatch* self, const BoundArguments& given) {
        new (self) PyPatch(asked(cli::parse_patch(string_of(given[0], "text"))));
      },
      "ValueError names the error in the text or in the file, and the expected input.");
  define_static(
      type, "def rectangle(x: float, y: float) -> Patch",
      [](const BoundArguments& given) {
        return PyPatch(cli::parse_patch("rectangle:" + sides(given[0], "x", given[1], "y")));
      },
      "Uniform pressure on a rectangle with these sides [m].");
  define_static(
      type, "def ellipse(law: str | Law, a: float, b: float) -> Patch",
      [](const BoundArguments& given) {
        const std::string semi_axes = sides(given[1], "a", given[2], "b");
        const bool is_law = nb::isinstance<PyLaw>(given[0]);
        const std::string law = is_law ? nb::cast<const PyLaw&>(given[0]).text : string_of(given[0], "law");
        cli::PatchArgument made = cli::parse_patch("ellipse:law=" + (is_law ? "hertz" : law) + "," + semi_axes);
        if (is_law) {
          made.law = law;
          made.profile = nb::cast<const PyLaw&>(given[0]).profile;
          made.text = "ellipse:law=" + law + "," + semi_axes;
        }
        return PyPatch(std::move(made));
      },
      "A pressure law stretched to an ellipse with these semi-axes [m].");
  define_static(
      type, "def points(x: ArrayLike, y: ArrayLike, load: ArrayLike) -> Patch",
      [](const BoundArguments& given) {
        return of_columns("points", {"x", "y", "load"}, given);
      },
      "Points [m] with loads >= 0 of any unit.");
  define_static(
      type, "def polygon(x: ArrayLike, y: ArrayLike) -> Patch",
      [](const BoundArguments& given) {
        return of_columns("polygon", {"x", "y"}, given);
      },
      "Uniform pressure on a simple polygon [m].");
  define_static(type,
                "def image(pressures: ArrayLike, pixel: float | None = None, *, spacing: tuple[float, float] | None = "
                "None, floor: float | None = None) -> Patch",
                &image,
                "A pressure image; the first row is at the largest y; pixels are squares of side `pixel` [m], or "
                "rectangles with the `spacing`\n"
                "(dy, dx) of rows and columns; the origin is the centre of pressure. A pixel that is masked or NaN has "
                "no sensor: it counts as\n"
                "without pressure, with a warning. Negative pressures are noise, and tell up to which pressure all "
                "count as 0; `floor` says it.");
  define<const PyPatch&>(
      type, "def orthotropic(self, mx: float, my: float) -> Patch",
      [](const PyPatch& self, const BoundArguments& given) {
        return self.orthotropic(number_of(given[0], "mx"), number_of(given[1], "my"));
      },
      "The same patch with orthotropic friction: mu times mx along x and times my along y.");
  define<const PyPatch&>(
      type,
      "def wrench(self, twists: ArrayLike, mu: float = 1.0, load: float = 1.0, *, error: bool = False) -> "
      "typing.Any",
      &wrench,
      "The wrenches (fx, fy, moment) [N, N m] about the origin that keep the patch sliding with "
      "twists (vx, vy, omega) [m/s, rad/s].\n\n"
      "Shape (…, 3) in and out. With `error` also the powers [W], and a bound of the largest of the "
      "power's relative error,\n"
      "|dF|/(mu P) and |dM|/(mu P m0). Releases the GIL.");
  define<const PyPatch&>(
      type, "def load_to_hold(self, fx: ArrayLike, fy: ArrayLike, moment: ArrayLike, *, mu: ArrayLike) -> typing.Any",
      &loads_to_hold_patch,
      "The least loads [N], of all points together, that hold friction wrenches [N, N m] about the "
      "origin, broadcast against each\n"
      "other and mu; inf if no load does. Releases the GIL.");
  define<const PyPatch&>(
      type, "def slip(self, fx: ArrayLike, fy: ArrayLike, moment: ArrayLike, *, error: bool = False) -> typing.Any",
      &slips,
      "The twists (vx, vy, omega) [m/s, rad/s] about the origin with which the patch slips under "
      "friction wrenches [N, N m], broadcast\n"
      "against each other: shape (…, 3). They have power 1 W against the wrench; NaN for wrench 0, "
      "and where no load holds. With `error`\n"
      "also a bound of the larger of |dF|/(mu P) and |dM|/(mu P m0), from the wrench at the "
      "load that just holds it to what the slip\n"
      "needs; it warns of more than 1e-6 that is not the patch's own. Releases the GIL.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> slip, error = lc.Patch.rectangle(0.02, 0.02).slip(0, 1, 0, error=True)\n"
      ">>> abs(slip - [0, 1, 0]).max() < 1e-9 and bool(error < 1e-12)\n"
      "True\n");
  define<const PyPatch&>(
      type, "def half_spaces(self, rows: int = 32) -> tuple[typing.Any, typing.Any, float]", &half_spaces_of,
      "Friction for a planner: A of shape (n, 3), V of shape (v, 3) and their share, inside the limit surface. A @ "
      "(fx, "
      "fy, moment) <= mu N\n"
      "holds, about the origin; so does V.T @ x with x >= 0 and sum(x) <= mu N. n is the largest of 8, 14, 32, 62, 128 "
      "that fits in `rows`.\n"
      "The share is the polytope's radius over the limit surface's, in the worst direction.");
  type.def("__repr__",
           [](const PyPatch& self) {
             return "<Patch " + self.words() + ", m0 " + format_number(self.moment_ratio()) + " m>";
           })
      .def_prop_ro("moment_ratio", &Patch::moment_ratio, "m0: the moment of a pure spin over mu P [m].")
      .def_prop_ro("radius", &Patch::radius, "Largest distance of a point from the centre of pressure [m].")
      .def_prop_ro(
          "centre", [](const PyPatch& self) { return nb::make_tuple(self.centre().x, self.centre().y); },
          nb::sig("def centre(self) -> tuple[float, float]"), "Centre of pressure [m].");
  add_patch_tables(module);
}

}  // namespace limitcurve::python
