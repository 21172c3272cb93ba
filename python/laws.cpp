// SPDX-License-Identifier: MIT
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "cli/io/law_argument.hpp"
#include "cli/io/stated_error.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/measured/samples.hpp"

#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::python {

namespace {

nb::object evaluate_with_errors(const PyLaw& law, nb::handle c, Method method) {
  return of_cors<4>(c, [&](double s) -> std::array<double, 4> {
    const WrenchEstimate estimate = cli::in_units(law.law->evaluate(s, method), s, 1.0, 1.0);
    return {estimate.wrench.force, estimate.wrench.moment, estimate.error.force, estimate.error.moment};
  });
}

PyLaw of_samples(std::vector<PressureSample> rows, const std::string& source, double rim) {
  Law law = samples(rows, source, rim);
  warn(law->remarks());
  std::string text = law->name();
  return {std::move(law), std::move(text), std::move(rows)};
}

/// The pressures at radii that are dense at the rim, where pressures are steep.
PyLaw of_function(nb::handle pressure) {
  constexpr int gaps = 5000;
  std::vector<PressureSample> rows;
  for (int i = 0; i <= gaps; ++i) {
    const double radius = std::sin(i * std::numbers::pi / (2 * gaps));
    try {
      rows.push_back({radius, number_of(pressure(radius), "pressure")});
    } catch (nb::python_error& error) {
      if (!error.matches(PyExc_ArithmeticError)) throw;
      throw std::invalid_argument("pressure at radius " + format_number(radius) + ": " +
                                  text_of(nb::borrow(error.value())) + ", expected a finite number");
    }
  }
  return of_samples(std::move(rows), "function",
                    1.0);  // the rim is named: there is no sensor whose noise could pass for it
}

}  // namespace

void add_laws(nb::module_& module) {
  nb::class_<PyLaw> type(
      module, "Law",
      "A pressure law under a soft finger, in the command line's grammar: 'hertz', 'power:n=2.3', 'samples:FILE.csv',\n"
      "'mix:0.7*hertz+0.3*uniform'.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> law = lc.Law('hertz')\n"
      ">>> law.evaluate(float('inf'))\n"
      "(1.0, 0.0)\n"
      ">>> f, m = law.evaluate([0, 0.5, 1])\n"
      ">>> [round(float(x), 6) for x in f]\n"
      "[0.0, 0.552233, 0.883573]\n");
  copies_are_itself(type);
  type.def("__getstate__",
           [](const PyLaw& self) {
             std::vector<double> radius;
             std::vector<double> pressure;
             for (const PressureSample& sample : self.profile) {
               radius.push_back(sample.radius);
               pressure.push_back(sample.pressure);
             }
             return std::tuple(self.text, radius, pressure);
           })
      .def("__setstate__",
           [](PyLaw& self, const std::tuple<std::string, std::vector<double>, std::vector<double>>& state) {
             const auto& [text, radius, pressure] = state;
             std::vector<PressureSample> rows;
             for (std::size_t i = 0; i < std::min(radius.size(), pressure.size()); ++i)
               rows.push_back({radius[i], pressure[i]});
             Law law = cli::law_of(text, rows);
             new (&self) PyLaw{std::move(law), text, std::move(rows)};
           })
      .def_prop_ro(
          "name", [](const PyLaw& self) { return self.law->name(); }, "The law in words.");
  define<PyLaw*>(
      type, "def __init__(self, text: str | collections.abc.Callable[[float], float]) -> None",
      [](PyLaw* self, const BoundArguments& given) {
        if (PyCallable_Check(given[0].ptr())) return static_cast<void>(new (self) PyLaw(of_function(given[0])));
        std::string text = string_of(given[0], "text");
        std::vector<PressureSample> profile;
        Law law = cli::read_law(text, profile);
        warn(law->remarks());
        new (self) PyLaw{std::move(law), std::move(text), std::move(profile)};
      },
      "From a text: ValueError names the error in it or in its file, and the expected input. From a function: its "
      "pressure [any unit] at\n"
      "radii from 0 to 1, the rim, at 5001 of them; to 1e-12 if it is smooth, and `profile_error` bounds the error.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> law = lc.Law(lambda radius: (1 - radius**2) ** 0.5)\n"
      ">>> abs(law.evaluate(1)[0] - lc.Law('hertz').evaluate(1)[0]) < 1e-12 < law.profile_error < 1e-9\n"
      "True\n");
  define_static(
      type,
      "def samples(radius: ArrayLike, pressure: ArrayLike, source: str = 'arrays', rim: float | None = None) "
      "-> Law",
      [](const BoundArguments& given) {
        const auto all = columns_of("", {"radius", "pressure"}, nb::list(nb::make_tuple(given[0], given[1])));
        std::vector<PressureSample> rows;
        for (std::size_t i = 0; i < all[0].size; ++i) rows.push_back({all[0].data[i], all[1].data[i]});
        return of_samples(std::move(rows), string_of(given[2], "source", "arrays"),
                          given[3].is_none() ? 0.0 : number_of(given[3], "rim"));
      },
      "A measured profile: pressures [any unit] at increasing radii [any unit]. `rim` is the radius, in that unit, "
      "that the contact\n"
      "radius stands for; without it the last radius with pressure. Negative pressures are noise, and tell its size. "
      "Warns of what was\n"
      "done, and where the last radius is probably not the rim.");
  define<const PyLaw&>(
      type, "def evaluate(self, c: ArrayLike, *, error: bool = False, method: str = 'auto') -> tuple[typing.Any, ...]",
      [](const PyLaw& self, const BoundArguments& given) {
        const Method method = method_of(*self.law, string_of(given[2], "method", "auto"));
        return truth_of(given[1])
                   ? evaluate_with_errors(self, given[0], method)
                   : of_cors<2>(given[0], [&](double s) { return components(self.law->evaluate(s, method).wrench); });
      },
      "Unit wrenches F/(mu P) and M/(mu P a) of a slip about centres of rotation at |c| contact radii.\n\n"
      "The results have the shape of c; float32 gives float32, whose rounding the bounds leave out; NaN gives NaN. "
      "With `error` also bounds of both "
      "absolute\n"
      "errors: (f, m, f_error, m_error). Relative error <= 1e-15 in closed form, <= 1e-14 by quadrature. `method`: "
      "auto, or one of\n"
      "closed, ring, punch, direct and boost that the law has. Arrays release the GIL.");
  type.def_prop_ro(
          "moment_ratio", [](const PyLaw& self) { return self.law->moment_ratio(); },
          "m0, the unit moment of a pure twist.")
      .def_prop_ro(
          "profile_error", [](const PyLaw& self) { return self.law->profile_error(); },
          "Error of f and m because the pressure is known only at samples; 0 for a formula.")
      .def_prop_ro(
          "rim", [](const PyLaw& self) { return self.law->rim(); },
          "Radius of a measured profile, in the unit of its samples, that the contact radius stands for; 0 for a "
          "formula.")
      .def_prop_ro(
          "arrays",
          [](nb::handle self) -> nb::object {
            const auto& profile = nb::cast<const PyLaw&>(self).profile;
            if (profile.empty()) return nb::none();
            const auto column = [&](const double& first) {
              return nb::ndarray<nb::numpy, const double>(&first, {profile.size()}, self,
                                                          {sizeof(PressureSample) / sizeof(double)});
            };
            return nb::make_tuple(column(profile.front().radius), column(profile.front().pressure));
          },
          nb::sig("def arrays(self) -> typing.Any"),
          "(radius, pressure) of a measured profile, read-only, from arrays or as read from its file; None for other "
          "laws.")
      .def("__repr__", [](const PyLaw& self) { return "Law('" + self.text + "')"; });
}

}  // namespace limitcurve::python
