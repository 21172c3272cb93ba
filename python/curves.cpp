// SPDX-License-Identifier: MIT
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "cli/io/law_argument.hpp"
#include "cli/io/output_file.hpp"
#include "cli/io/table_reader.hpp"
#include "cli/io/table_writer.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/validate/tangent_ellipse.hpp"

#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace limitcurve::python {

namespace {

const Table& curve_in(const Table& table) {
  return table;
}
const godobject::FingerCurve& curve_in(const PyCurve& curve) {
  return curve.curve;
}

template <class Curve>
nb::object loads_to_hold(const Curve& curve, const BoundArguments& given) {
  if constexpr (std::is_same_v<Curve, Table>)
    warn_of_samples(curve.law_name(), curve.profile_error(), curve.checked_error());
  const nb::handle force = given[0];
  const nb::handle moment = given[1];
  const nb::handle mu = given[2];
  const nb::handle radius_law = given[3];
  const nb::handle mu_r = given[4];
  const nb::object gamma = given[5].is_none() ? nb::float_(0.0) : given[5];
  if (radius_law.is_none() == mu_r.is_none())
    throw std::invalid_argument(std::string("radius_law, mu_r: got ") + (mu_r.is_none() ? "none" : "both") +
                                ", expected one of them");
  const auto least = [&](const ContactFriction& contact, double f, double m) {
    return std::array{load_to_hold(curve, contact, f, m)};
  };
  if (mu_r.is_none()) {
    const cli::RadiusLawArgument argument = cli::read_radius_law(string_of(radius_law, "radius_law"));
    ContactFriction contact{.mu = -1.0, .gamma = number_of(gamma, "gamma")};
    nb::object result = of_numbers<1, 16, 3>(
        {force, moment, mu}, {"force", "moment", "mu"}, {any, any, ranges::non_negative}, [&](const auto& of) {
          // Measured moments make another radius law for each mu; without friction none matters.
          if (of[2] != contact.mu)
            contact.radius_law =
                of[2] > 0.0 ? argument.of(of[2], curve.wrench({0.0, 1.0}).moment) : RadiusLaw::constant(1e-3);
          contact.mu = of[2];
          return least(contact, of[0], of[1]);
        });
    if (contact.radius_law) ask_unit(*contact.radius_law);
    return result;
  }
  constexpr Range exponent{-0.5, 1.0, "a number from -0.5 to 1"};
  return of_numbers<1, 16, 5>({force, moment, mu, mu_r, gamma}, {"force", "moment", "mu", "mu_r", "gamma"},
                              {any, any, ranges::non_negative, ranges::non_negative, exponent}, [&](const auto& of) {
                                return least({.mu = of[2], .mu_r = of[3], .gamma = of[4]}, of[0], of[1]);
                              });
}

/// The gauges of arrays of wrenches by a table, in blocks, which are computed in packs.
nb::object gauges(const Table& table, const std::array<nb::handle, 2>& wrenches) {
  return in_precision(std::all_of(wrenches.begin(), wrenches.end(), is_single), [&]<class Real>(Real) -> nb::object {
    constexpr std::size_t block = 64;
    const std::vector<Numbers<Real>> numbers = broadcast<Real>(wrenches, std::array{"force", "moment"});
    const std::size_t size = numbers[0].size;
    const Results<Real> found = results_like<Real>(numbers[0].array);
    for_each_point((size + block - 1) / block, [&](std::size_t i) {
      const std::size_t begin = i * block;
      const std::size_t count = std::min(block, size - begin);
      std::array<UnitWrench, block> given;
      std::array<double, block> gauge;
      for (std::size_t j = 0; j < count; ++j)
        given[j] = {static_cast<double>(numbers[0].data[begin + j]), static_cast<double>(numbers[1].data[begin + j])};
      table.gauge(std::span(given).first(count), gauge);
      for (std::size_t j = 0; j < count; ++j) found.data[begin + j] = static_cast<Real>(gauge[j]);
    });
    return handed_over(found);
  });
}

/// The methods of a table, an ellipse or a box.
template <class Class>
void add_limit_curve(nb::class_<Class>& type) {
  define<const Class&>(
      type, "def evaluate(self, c: ArrayLike) -> tuple[typing.Any, typing.Any]",
      [](const Class& self, const BoundArguments& given) {
        return of_cors<2, 256>(given[0], [&](double s) { return components(curve_in(self).wrench({s, 1.0})); });
      },
      "Unit wrenches at COR distances of c contact radii; of a table within checked_error. As Law.evaluate.");
  define<const Class&>(
      type, "def wrench(self, slide: ArrayLike, spin: ArrayLike) -> tuple[typing.Any, typing.Any]",
      [](const Class& self, const BoundArguments& given) {
        return of_numbers<2, 256, 2>({given[0], given[1]}, {"slide", "spin"}, {any, any},
                                     [&](const std::array<double, 2>& twist) {
                                       return components(curve_in(self).wrench({twist[0], twist[1]}));
                                     });
      },
      "Unit wrenches of slips with speeds |v| and rim speeds a|omega|, of which only the ratio counts, without signs; "
      "no slip gives 0.\n"
      "Broadcasts; else as evaluate(slide / spin).");
  define<const Class&>(
      type, "def gauge(self, force: ArrayLike, moment: ArrayLike) -> typing.Any",
      [](const Class& self, const BoundArguments& given) {
        if constexpr (std::is_same_v<Class, Table>) {
          if (!plain_number(given[0]) || !plain_number(given[1])) return gauges(self, {given[0], given[1]});
        }
        return of_numbers<1, 16, 2>({given[0], given[1]}, {"force", "moment"}, {any, any},
                                    [&](const std::array<double, 2>& wrench) {
                                      return std::array{curve_in(self).gauge({wrench[0], wrench[1]})};
                                    });
      },
      "Distance of unit wrenches from the origin divided by that of the curve on the same ray: < 1 holds, > 1 slips. "
      "Signs do not\n"
      "count. Broadcasts.");
  define<const Class&>(
      type,
      "def load_to_hold(self, force: ArrayLike, moment: ArrayLike, *, mu: ArrayLike, radius_law: str | None = "
      "None, mu_r: ArrayLike | None = None, gamma: ArrayLike = 0.0) -> typing.Any",
      [](const Class& self, const BoundArguments& given) { return loads_to_hold(curve_in(self), given); },
      "The least load [N] that holds friction forces [N] and moments [N m], of any sign; inf if no load does. All "
      "numbers broadcast.\n\n"
      "`radius_law` gives the contact radius a(P), as on the command line; or `mu_r` [m/N^gamma] is given as measured, "
      "and the moment\n"
      "limit is mu_r P^(1+gamma): radii a [m] of many contacts are mu_r = mu * wrench(0, 1)[1] * a. Of a measured "
      "pressure\n"
      "lc.hold(...) estimates the error, hold_error.");
  type.def_prop_ro(
      "moment_ratio", [](const Class& self) { return curve_in(self).moment_ratio(); },
      "m0, the moment of a pure twist over the force of a pure slide, both in unit wrenches.");
}

constexpr std::size_t cell_columns = 9;

nb::object cells_of(const Table& table) {
  const std::size_t count = table.cell_count();
  auto rows = std::make_unique<double[]>(count * cell_columns);
  double* next = rows.get();
  const auto add = [&next](double side, const TableCell& cell) {
    *next++ = side;
    *next++ = cell.x;
    next = std::copy(cell.coefficients.begin(), cell.coefficients.end(), next);
  };
  for (const TableCell& cell : table.cells().inside) add(0.0, cell);
  std::for_each(table.cells().outside.rbegin(), table.cells().outside.rend(),
                [&](const TableCell& cell) { add(1.0, cell); });
  double* const data = rows.release();
  const nb::capsule owner(data, [](void* numbers) noexcept { delete[] static_cast<double*>(numbers); });
  return nb::cast(nb::ndarray<nb::numpy, double>(data, {count, cell_columns}, owner));
}

/// Whether two tables have the same numbers, whatever they were made from.
bool same(const Table& one, const Table& other) {
  const auto equal = [](const std::vector<TableCell>& a, const std::vector<TableCell>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TableCell& c, const TableCell& d) {
      return c.x == d.x && c.coefficients == d.coefficients;
    });
  };
  return one.checked_error() == other.checked_error() && equal(one.cells().inside, other.cells().inside) &&
         equal(one.cells().outside, other.cells().outside);
}

nb::object tangent_ellipses(const Table& self, const BoundArguments& given) {
  const auto has = [&](std::size_t i) { return !given[i].is_none(); };
  const auto axes = [](const TangentEllipse& ellipse) { return std::array{ellipse.p, ellipse.q}; };
  if (has(0) != has(1) || has(0) == has(4) || has(2) != has(3) || (has(2) && !has(0)))
    throw std::invalid_argument("tangent_ellipse: expected force and moment, or these with p and q, or slip=(v, u)");
  if (const nb::object& slip = given[4]; has(4)) {
    if (!nb::isinstance<nb::sequence>(slip) || nb::len(slip) != 2) refuse("slip", slip, "(v, u)");
    const nb::object slide = slip[0];
    const nb::object spin = slip[1];
    return of_numbers<2, 16, 2>({slide, spin}, {"slip[0]", "slip[1]"}, {any, any},
                                [&](const std::array<double, 2>& twist) {
                                  return axes(tangent_ellipse(self, SlipTwist{twist[0], twist[1]}));
                                });
  }
  if (!has(2)) {
    return of_numbers<2, 16, 2>(
        {given[0], given[1]}, {"force", "moment"}, {any, any},
        [&](const std::array<double, 2>& wrench) { return axes(tangent_ellipse(self, wrench[0], wrench[1])); });
  }
  return of_numbers<2, 16, 4>(
      {given[0], given[1], given[2], given[3]}, {"force", "moment", "p", "q"}, {any, any, any, any},
      [&](const std::array<double, 4>& of) { return axes(tangent_ellipse(self, of[0], of[1], of[2], of[3])); });
}

void add_tables(nb::module_& module) {
  nb::class_<Table> type(module, "Table",
                         R"(A limit curve as a lookup table with a checked error. It drives fingers and batches.

>>> import limitcurve as lc
>>> table = lc.Table('hertz', tolerance=1e-8)
>>> table.checked_error <= 1e-8, table.nbytes <= 4096
(True, True)
)");
  copies_are_itself(type);
  add_limit_curve(type);
  type.def("__getstate__",
           [](const Table& self) {
             return nb::make_tuple(self.law_name(), self.tolerance(), self.checked_error(), self.profile_error(),
                                   self.cells().index_bits, self.cells().octaves, cells_of(self));
           })
      .def("__setstate__", [](Table& self, const nb::tuple& state) {
        const auto number = [&](std::size_t i) { return nb::cast<double>(state[i]); };
        TableCells cells{nb::cast<int>(state[4]), nb::cast<int>(state[5]), {}, {}};
        const Numbers<double> rows = numbers_of<double>(state[6], "cells");
        for (const double* row = rows.data; row < rows.data + rows.size; row += cell_columns) {
          TableCell& cell = (row[0] == 0.0 ? cells.inside : cells.outside).emplace_back(TableCell{row[1], {}});
          std::copy_n(row + 2, cell.coefficients.size(), cell.coefficients.begin());
        }
        std::reverse(cells.outside.begin(), cells.outside.end());
        new (&self) Table(TableFacts{nb::cast<std::string>(state[0]), number(1), number(2), number(3)}, cells);
      });
  define<Table*>(
      type, "def __init__(self, law: str | Law, tolerance: float = 1e-08, preferred_bytes: int = 4096) -> None",
      [](Table* self, const BoundArguments& given) {
        const Law of = law_of(given[0]);
        const double tolerance = number_of(given[1], "tolerance", Table::default_tolerance);
        TableOptions options;
        if (!given[2].is_none() && !nb::try_cast(given[2], options.preferred_bytes))
          refuse("preferred_bytes", given[2], "a whole number");
        const nb::gil_scoped_release release;
        new (self) Table(Table::build(of, tolerance, options));
      },
      "The table of a law: |error| <= tolerance * max(1, m0) in f and m, tolerance in [1e-14, 0.1]. Its cells "
      "have the lowest\n"
      "degree, 3 to 5, with which nbytes <= preferred_bytes, else 6: the lowest is the fastest. Milliseconds in closed "
      "form, up to "
      "seconds\n"
      "by quadrature. RuntimeError if the law does not allow that tolerance. Releases the GIL.");
  define_static(
      type, "def load(path: str | os.PathLike[str]) -> Table",
      [](const BoundArguments& given) { return cli::read_table(path_of(given[0])); },
      "Reads a .csv or .json file that `save` or `limitcurve table` wrote. ValueError names file, line and column of "
      "the error.");
  define<const Table&>(
      type, "def save(self, path: str | os.PathLike[str], name: str = '') -> None",
      [](const Table& self, const BoundArguments& given) {
        const std::string file = path_of(given[0]);
        const cli::TableWriter text_of = cli::table_writer(file, "path", string_of(given[1], "name", ""));
        const nb::gil_scoped_release release;  // the reader of a pipe may be another thread
        cli::AtomicFile::write(file, text_of(self));
      },
      R"(Writes the whole table or nothing; the extension selects .csv, .json, .h (C99) or .hpp (constexpr C++17).
name: of the table in a header, NAME_wrench(slide, spin); if empty, one that no other table has.)");
  type.def("__eq__",
           [](const Table& self, nb::handle other) {
             return nb::isinstance<Table>(other) && same(self, nb::cast<const Table&>(other));
           })
      .def("__hash__", [](const Table& self) { return std::hash<double>()(self.checked_error()); });
  define<const Table&>(
      type,
      "def tangent_ellipse(self, force: ArrayLike | None = None, moment: ArrayLike | None = None, p: ArrayLike "
      "| None = None, q: ArrayLike | None = None, *, slip: tuple[ArrayLike, ArrayLike] | None = None) -> "
      "tuple[typing.Any, typing.Any]",
      &tangent_ellipses,
      "Semi-axes (p, q) with which an engine's elliptic cone, coefficients mu p and mu a q, finds the exact curve: of "
      "the ellipse "
      "that\n"
      "touches it. Give the engine's last unit wrench (F/(mu P), M/(mu P a)) and the p and q it was found with, after "
      "each step: they\n"
      "converge. Without p and q it touches on the wrench's ray; slip=(|v|, a|omega|): at a known slip. Signs are "
      "ignored; no wrench\n"
      "or slip gives the usual ellipse (1, m0), NaN gives NaN. Broadcasts.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> table = lc.Table('hertz', tolerance=1e-8)\n"
      ">>> p, q = table.tangent_ellipse(slip=(1, 1))\n"
      ">>> f, m = lc.ellipse(p, q).wrench(1, 1)  # what the engine finds\n"
      ">>> abs(f - table.wrench(1, 1)[0]) < 1e-15\n"
      "True\n");
  type.def_prop_ro("cells", &cells_of, nb::sig("def cells(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "The cells as rows (side, x, c0 ... c6), in the order of a file: D(t) = sum ci (t - x)^i from t = x "
                   "to the next larger x of its\n"
                   "side, or to 1. On side 0, inside the rim, t = c/a, and (D', D - t D') is force and moment; on side "
                   "1, outside, t = a/c, and\n"
                   "it is moment and force.")
      .def_prop_ro("checked_error", &Table::checked_error, "Bound on the absolute error of f and m against the law.")
      .def_prop_ro("profile_error", &Table::profile_error,
                   "Additional error because the pressure is known only at samples; 0 for a formula.")
      .def_prop_ro("tolerance", &Table::tolerance, "Requested tolerance.")
      .def_prop_ro("law_name", &Table::law_name, "The law in words.")
      .def_prop_ro("nbytes", &Table::bytes, "Bytes that a look-up may touch.")
      .def("__repr__", [](const Table& self) {
        const double own = self.profile_error();
        return "<Table of " + self.law_name() + ", error <= " + format_number(self.checked_error()) +
               (own > self.checked_error() ? " from a law known to " + format_number(own, 2) : "") + ">";
      });
}

void add_closed_curves(nb::module_& module) {
  nb::class_<PyCurve> type(module, "Curve",
                           "An ellipse or a box; it can drive a finger in place of a table: see `ellipse` and `box`.");
  copies_are_itself(type);
  add_limit_curve(type);
  type.def("__getstate__", [](const PyCurve& self) { return std::tuple(self.name, self.force_max, self.moment_max); })
      .def("__setstate__",
           [](PyCurve& self, const std::tuple<std::string, double, double>& state) {
             new (&self) PyCurve(std::apply(closed_curve, state));
           })
      .def("__repr__", [](const PyCurve& self) { return "<" + self.name + ">"; });
  const auto add = [&](const std::string& name, const char* doc) {
    define_static(
        module, "def " + name + "(force_max: float, moment_max: float) -> Curve",
        [name](const BoundArguments& given) {
          return closed_curve(name, number_of(given[0], "force_max"), number_of(given[1], "moment_max"));
        },
        doc);
  };
  add("ellipse", "The ellipse with these semi-axes in unit wrenches; the usual one is ellipse(1, law.moment_ratio).");
  add("box", "Separate limits of force and moment; only with projection='closest-point'.");
}

}  // namespace

PyCurve closed_curve(const std::string& name, double force_max, double moment_max) {
  if (name == "ellipse") {
    const Ellipse ellipse(force_max, moment_max);
    return {ellipse, ellipse, name, force_max, moment_max};
  }
  const Box limits = box(force_max, moment_max);
  return {limits, limits, name, force_max, moment_max};
}

void warn_of_samples(const std::string& law, double own_error, double error_of_curve) {
  if (own_error > error_of_curve)
    warn("load_to_hold: the unit wrenches of " + law + " may be off by " + format_number(own_error, 2) +
         ", because the pressure is known only at samples: see hold_error of lc.hold(...)");
}

Law law_of(nb::handle law) {
  if (nb::isinstance<PyLaw>(law)) return nb::cast<const PyLaw&>(law).law;
  if (nb::isinstance<nb::str>(law)) return cli::read_law(nb::cast<std::string>(law));
  refuse("law", law, "a str, such as 'hertz', or a Law");
}

template <>
godobject::BasicFingerCurve<double> curve_of(nb::handle curve) {
  if (nb::isinstance<Table>(curve)) return nb::cast<const Table&>(curve);
  if (nb::isinstance<PyCurve>(curve)) return nb::cast<const PyCurve&>(curve).curve;
  refuse("curve", curve, "a Table, or what ellipse() or box() made");
}

template <>
godobject::BasicFingerCurve<float> curve_of(nb::handle curve) {
  if (nb::isinstance<PyCurve>(curve)) return nb::cast<const PyCurve&>(curve).single;
  if (!nb::isinstance<Table>(curve)) refuse("curve", curve, "a Table, or what ellipse() or box() made");
  // From the table itself, not from its law: that is only a name in a file, and the file of a measured profile may have
  // changed.
  const auto& table = nb::cast<const Table&>(curve);
  return FloatTable::build(table, std::max(table.tolerance() / 100, FloatTable::finest_tolerance),
                           {.name = table.law_name()});
}

void add_curves(nb::module_& module) {
  add_tables(module);
  add_closed_curves(module);
}

}  // namespace limitcurve::python
