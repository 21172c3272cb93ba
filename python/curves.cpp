// SPDX-License-Identifier: MIT
#include "python/core.hpp"

#include "cli/io/law_argument.hpp"
#include "cli/io/output_file.hpp"
#include "cli/io/stated_error.hpp"
#include "cli/io/table_reader.hpp"
#include "cli/io/table_writer.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/contact_radius.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::python {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Throws for a negative number, and for infinity if not allowed; NaN passes.
void require_non_negative(const Numbers<double>& numbers, const char* name, bool may_be_infinite) {
  const double largest = may_be_infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::max();
  const double* const end = numbers.data + numbers.size;
  const double* const bad = std::find_if(numbers.data, end, [&](double number) { return number < 0.0 || number > largest; });
  if (bad == end) return;
  const std::string place = numbers.size == 1 ? "" : "[" + std::to_string(bad - numbers.data) + "]";
  throw std::invalid_argument(name + place + ": got " + format_number(*bad) + ", expected " +
                              (may_be_infinite ? "a number >= 0, or inf" : "a finite number >= 0"));
}

/// Unit wrenches at COR distances: `wrench_at(s)` gives force and moment.
template <class WrenchAt>
nb::object evaluate(nb::handle c, const WrenchAt& wrench_at) {
  const Numbers<double> cors = numbers_of<double>(c, "c");
  require_non_negative(cors, "c", true);
  const Results forces = results_like(cors.array);
  const Results moments = results_like(cors.array);
  {
    const nb::gil_scoped_release release;
    for (std::size_t i = 0; i < cors.size; ++i) {
      const double s = cors.data[i];
      const UnitWrench wrench = std::isnan(s) ? UnitWrench{not_a_number, not_a_number} : wrench_at(s);
      forces.data[i] = wrench.force;
      moments.data[i] = wrench.moment;
    }
  }
  const bool single = is_single(c);
  return nb::make_tuple(handed_over(forces, single), handed_over(moments, single));
}

nb::object evaluate_with_errors(const PyLaw& law, nb::handle c) {
  const Numbers<double> cors = numbers_of<double>(c, "c");
  require_non_negative(cors, "c", true);
  const std::array<Results, 4> results{results_like(cors.array), results_like(cors.array), results_like(cors.array),
                                       results_like(cors.array)};
  {
    const nb::gil_scoped_release release;
    for (std::size_t i = 0; i < cors.size; ++i) {
      const double s = cors.data[i];
      const WrenchEstimate estimate = std::isnan(s) ? WrenchEstimate{{not_a_number, not_a_number}, {not_a_number, not_a_number}, 0.0}
                                                    : cli::in_units(law.law->evaluate(s), s, 1.0, 1.0);
      results[0].data[i] = estimate.wrench.force;
      results[1].data[i] = estimate.wrench.moment;
      results[2].data[i] = estimate.error.force;
      results[3].data[i] = estimate.error.moment;
    }
  }
  const bool single = is_single(c);
  return nb::make_tuple(handed_over(results[0], single), handed_over(results[1], single), handed_over(results[2], single),
                        handed_over(results[3], single));
}

/// One number for each pair of force and moment.
template <class Of>
nb::object of_wrenches(nb::handle force, nb::handle moment, const Of& of) {
  const std::vector<Numbers<double>> numbers = broadcast({force, moment}, {"force", "moment"});
  require_non_negative(numbers[0], "force", false);
  require_non_negative(numbers[1], "moment", false);
  const Results results = results_like(numbers[0].array);
  {
    const nb::gil_scoped_release release;
    for (std::size_t i = 0; i < numbers[0].size; ++i) {
      const double f = numbers[0].data[i];
      const double m = numbers[1].data[i];
      results.data[i] = std::isnan(f) || std::isnan(m) ? not_a_number : of(f, m);
    }
  }
  return handed_over(results, is_single(force) && is_single(moment));
}

template <class Curve>
nb::object loads_to_hold(const Curve& curve, nb::handle force, nb::handle moment, double mu, const std::string& radius_law) {
  const RadiusLaw radius = cli::read_radius_law(radius_law).of(mu, curve.moment_ratio());
  return of_wrenches(force, moment, [&](double f, double m) { return load_to_hold(curve, radius, mu, f, m); });
}

constexpr const char* evaluate_signature = "def evaluate(self, c: numpy.typing.ArrayLike) -> tuple[typing.Any, typing.Any]";
constexpr const char* gauge_signature = "def gauge(self, force: numpy.typing.ArrayLike, moment: numpy.typing.ArrayLike) -> typing.Any";
constexpr const char* hold_signature =
    "def load_to_hold(self, force: numpy.typing.ArrayLike, moment: numpy.typing.ArrayLike, *, mu: float, radius_law: str) -> typing.Any";
constexpr const char* hold_doc =
    "The least load [N] that holds friction forces [N] and moments [N m] >= 0, broadcast against each other.\n\n"
    "inf if no load does. `radius_law` gives the contact radius a(P), as on the command line.";

void add_laws(nb::module_& module) {
  nb::class_<PyLaw>(module, "Law",
                    "A pressure law under a soft finger, in the command line's grammar: 'hertz', 'power:n=2.3', 'samples:FILE.csv',\n"
                    "'mix:0.7*hertz+0.3*uniform'.\n\n"
                    ">>> import limitcurve as lc\n"
                    ">>> law = lc.Law('hertz')\n"
                    ">>> law.evaluate(float('inf'))\n"
                    "(1.0, 0.0)\n"
                    ">>> f, m = law.evaluate([0, 0.5, 1])\n"
                    ">>> [round(float(x), 6) for x in f]\n"
                    "[0.0, 0.552233, 0.883573]\n")
      .def(
          "__init__",
          [](PyLaw* self, const std::string& text) {
            std::vector<PressureSample> profile;
            Law law = cli::read_law(text, profile);
            new (self) PyLaw{std::move(law), text, std::move(profile)};
          },
          nb::arg("text"), "ValueError names the error in the text or in the file, and the expected input.")
      .def_static(
          "samples",
          [](nb::handle radius, nb::handle pressure, const std::string& source) {
            const auto all = columns_of("", {"radius", "pressure"}, nb::list(nb::make_tuple(radius, pressure)));
            std::vector<PressureSample> rows;
            for (std::size_t i = 0; i < all[0].size; ++i) rows.push_back({all[0].data[i], all[1].data[i]});
            Law law = samples(rows, source);
            std::string text = law->name();
            return PyLaw{std::move(law), std::move(text), std::move(rows)};
          },
          nb::arg("radius"), nb::arg("pressure"), nb::arg("source") = "arrays",
          nb::sig("def samples(radius: numpy.typing.ArrayLike, pressure: numpy.typing.ArrayLike, source: str = 'arrays') -> Law"),
          "A measured profile: pressures [any unit] at increasing radii [any unit]; the last radius is the edge of the contact.")
      .def(
          "evaluate",
          [](const PyLaw& self, nb::handle c, nb::handle error) {
            return truth_of(error) ? evaluate_with_errors(self, c) : evaluate(c, [&](double s) { return self.law->evaluate(s).wrench; });
          },
          nb::arg("c"), nb::kw_only(), nb::arg("error") = false,
          nb::sig("def evaluate(self, c: numpy.typing.ArrayLike, *, error: bool = False) -> tuple[typing.Any, ...]"),
          "Unit wrenches F/(mu P) and M/(mu P a) of a slip about centres of rotation at c contact radii, in [0, inf].\n\n"
          "The results have the shape of c; float32 gives float32; NaN gives NaN. With `error` also bounds of both absolute\n"
          "errors: (f, m, f_error, m_error). Relative error <= 1e-15 in closed form, <= 1e-14 by quadrature. Releases the GIL.")
      .def_prop_ro(
          "name", [](const PyLaw& self) { return self.law->name(); }, "The law in words.")
      .def_prop_ro(
          "moment_ratio", [](const PyLaw& self) { return self.law->moment_ratio(); }, "m0, the unit moment of a pure twist.")
      .def_prop_ro(
          "profile_error", [](const PyLaw& self) { return self.law->profile_error(); },
          "Error of f and m because the pressure is known only at samples; 0 for a formula.")
      .def_prop_ro(
          "arrays",
          [](nb::handle self) -> nb::object {
            const auto& profile = nb::cast<const PyLaw&>(self).profile;
            if (profile.empty()) return nb::none();
            const auto column = [&](const double& first) {
              return nb::ndarray<nb::numpy, const double>(&first, {profile.size()}, self, {sizeof(PressureSample) / sizeof(double)});
            };
            return nb::make_tuple(column(profile.front().radius), column(profile.front().pressure));
          },
          nb::sig("def arrays(self) -> typing.Any"),
          "(radius, pressure) of a measured profile, read-only, from arrays or as read from its file; None for other laws.")
      .def("__repr__", [](const PyLaw& self) { return "Law('" + self.text + "')"; });
}

void add_tables(nb::module_& module) {
  nb::class_<Table>(module, "Table",
                    "A limit curve as a lookup table, 1 to 96 KiB, with a certified error. It drives fingers and batches.\n\n"
                    ">>> import limitcurve as lc\n"
                    ">>> table = lc.Table('hertz', tolerance=1e-8)\n"
                    ">>> table.certified_error <= 1e-8, table.nbytes <= 4096\n"
                    "(True, True)\n")
      .def(
          "__init__",
          [](Table* self, nb::handle law, double tolerance, std::size_t bytes) {
            const Law of = law_of(law);
            const nb::gil_scoped_release release;
            new (self) Table(Table::build(of, tolerance, {.bytes = bytes}));
          },
          nb::arg("law"), nb::arg("tolerance") = 1e-6, nb::arg("bytes") = TableOptions{}.bytes,
          nb::sig("def __init__(self, law: str | Law, tolerance: float = 1e-06, bytes: int = 4096) -> None"),
          "The table of a law: |error| <= tolerance * max(1, m0) in f and m, tolerance in [1e-14, 0.1]. Its polynomials have the lowest\n"
          "degree, 3 to 5, with which nbytes <= bytes, else 6: the lowest is the fastest. Milliseconds for a law in closed form, up to\n"
          "seconds by quadrature. RuntimeError if the law does not allow that tolerance. Releases the GIL.")
      .def_static(
          "load", [](nb::handle path) { return cli::read_table(path_of(path)); }, nb::arg("path"),
          nb::sig("def load(path: str | os.PathLike[str]) -> Table"),
          "Reads a .csv or .json file that `save` or `limitcurve table` wrote. ValueError names file, line and column of the error.")
      .def(
          "save",
          [](const Table& self, nb::handle path, const std::string& name) {
            const std::string file = path_of(path);
            const cli::TableWriter text_of = cli::table_writer(file, "path", name);
            const nb::gil_scoped_release release;  // the reader of a pipe may be another thread
            cli::AtomicFile output(file);
            output.output().write(text_of(self));
            output.commit();
          },
          nb::arg("path"), nb::arg("name") = "", nb::sig("def save(self, path: str | os.PathLike[str], name: str = '') -> None"),
          "Writes the whole table or nothing; the extension selects .csv, .json, .h (C99) or .hpp (constexpr C++17).\n"
          "name: of the table in a header, NAME_wrench(slide, spin); if empty, one that no other table has.")
      .def(
          "evaluate",
          [](const Table& self, nb::handle c) { return evaluate(c, [&](double s) { return self.wrench({s, 1.0}); }); },
          nb::arg("c"), nb::sig(evaluate_signature),
          "Unit wrenches at COR distances of c contact radii, within certified_error. As Law.evaluate.")
      .def(
          "gauge",
          [](const Table& self, nb::handle force, nb::handle moment) {
            return of_wrenches(force, moment, [&](double f, double m) { return self.gauge({f, m}); });
          },
          nb::arg("force"), nb::arg("moment"), nb::sig(gauge_signature),
          "Distance of unit wrenches from the origin divided by that of the curve on the same ray: < 1 holds, > 1 slips. Broadcasts.")
      .def(
          "load_to_hold",
          [](const Table& self, nb::handle force, nb::handle moment, double mu, const std::string& radius_law) {
            return loads_to_hold(self, force, moment, mu, radius_law);
          },
          nb::arg("force"), nb::arg("moment"), nb::kw_only(), nb::arg("mu"), nb::arg("radius_law"), nb::sig(hold_signature), hold_doc)
      .def_prop_ro("certified_error", &Table::certified_error, "Bound of the absolute error of f and m against the law.")
      .def_prop_ro("profile_error", &Table::profile_error,
                   "Additional error because the pressure is known only at samples; 0 for a formula.")
      .def_prop_ro("tolerance", &Table::tolerance, "Requested tolerance.")
      .def_prop_ro("law_name", &Table::law_name, "The law in words.")
      .def_prop_ro("moment_ratio", &Table::moment_ratio, "m0, the unit moment of a pure twist.")
      .def_prop_ro("nbytes", &Table::bytes, "Bytes that a look-up may touch.")
      .def("__repr__",
           [](const Table& self) { return "<Table of " + self.law_name() + ", error <= " + format_number(self.certified_error()) + ">"; });
}

void add_closed_curves(nb::module_& module) {
  nb::class_<PyCurve>(module, "Curve", "An ellipse or a box; it can drive a finger in place of a table: see `ellipse` and `box`.")
      .def(
          "evaluate",
          [](const PyCurve& self, nb::handle c) {
            return evaluate(c, [&](double s) { return self.curve.wrench({s, 1.0}); });
          },
          nb::arg("c"), nb::sig(evaluate_signature), "Unit wrenches at COR distances of c contact radii. As Law.evaluate.")
      .def(
          "gauge",
          [](const PyCurve& self, nb::handle force, nb::handle moment) {
            return of_wrenches(force, moment, [&](double f, double m) { return self.curve.gauge({f, m}); });
          },
          nb::arg("force"), nb::arg("moment"), nb::sig(gauge_signature), "As Table.gauge.")
      .def(
          "load_to_hold",
          [](const PyCurve& self, nb::handle force, nb::handle moment, double mu, const std::string& radius_law) {
            return loads_to_hold(self.curve, force, moment, mu, radius_law);
          },
          nb::arg("force"), nb::arg("moment"), nb::kw_only(), nb::arg("mu"), nb::arg("radius_law"), nb::sig(hold_signature), hold_doc)
      .def_prop_ro(
          "moment_ratio", [](const PyCurve& self) { return self.curve.moment_ratio(); }, "m0, the unit moment of a pure twist.")
      .def("__repr__", [](const PyCurve& self) { return "<" + self.name + ">"; });
  module.def(
      "ellipse",
      [](double force_max, double moment_max) {
        const Ellipse ellipse(force_max, moment_max);
        return PyCurve{ellipse, ellipse, "ellipse"};
      },
      nb::arg("force_max"), nb::arg("moment_max"),
      "The ellipse with these semi-axes in unit wrenches; the usual one is ellipse(1, law.moment_ratio).");
  module.def(
      "box",
      [](double force_max, double moment_max) {
        const Box limits = box(force_max, moment_max);
        return PyCurve{limits, limits, "box"};
      },
      nb::arg("force_max"), nb::arg("moment_max"), "Separate limits of force and moment; only with projection='closest-point'.");
}

}  // namespace

Law law_of(nb::handle law) {
  if (nb::isinstance<PyLaw>(law)) return nb::cast<const PyLaw&>(law).law;
  if (nb::isinstance<nb::str>(law)) return cli::read_law(nb::cast<std::string>(law));
  throw std::invalid_argument("law: expected a text, such as 'hertz', or a Law");
}

template <>
godobject::BasicFingerCurve<double> curve_of(nb::handle curve) {
  if (nb::isinstance<Table>(curve)) return nb::cast<const Table&>(curve);
  if (nb::isinstance<PyCurve>(curve)) return nb::cast<const PyCurve&>(curve).curve;
  throw std::invalid_argument("curve: expected a Table, or what ellipse() or box() made");
}

template <>
godobject::BasicFingerCurve<float> curve_of(nb::handle curve) {
  if (nb::isinstance<PyCurve>(curve)) return nb::cast<const PyCurve&>(curve).single;
  if (!nb::isinstance<Table>(curve)) throw std::invalid_argument("curve: expected a Table, or what ellipse() or box() made");
  // From the table itself, not from its law: that is only a name in a file, and the file of a measured profile may have changed.
  const auto& table = nb::cast<const Table&>(curve);
  return FloatTable::build(table, std::max(table.tolerance() / 100, FloatTable::finest_tolerance), {.name = table.law_name()});
}

void add_curves(nb::module_& module) {
  add_laws(module);
  add_tables(module);
  add_closed_curves(module);
}

}  // namespace limitcurve::python
