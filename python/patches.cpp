// SPDX-License-Identifier: MIT
#include "python/core.hpp"

#include "cli/io/patch_argument.hpp"
#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::python {

namespace {

nb::object wrench(const Patch& patch, nb::handle twists, double mu, double load, nb::handle error) {
  if (!(mu > 0.0 && std::isfinite(mu))) throw out_of_range("mu", mu, "1", "(0, inf)");
  if (!(load > 0.0 && std::isfinite(load))) throw out_of_range("load", load, "N", "(0, inf)");
  const Numbers<double> given = numbers_of<double>(twists, "twists");
  const nb::tuple shape = given.array.attr("shape");
  if (nb::len(shape) == 0 || nb::cast<std::size_t>(shape[nb::len(shape) - 1]) != 3) {
    throw std::invalid_argument("twists: got the shape " + text_of(shape) + ", expected (…, 3): vx, vy, omega");
  }
  const std::size_t count = given.size / 3;
  const Results wrenches = results_like(given.array);
  const nb::object first = given.array[nb::make_tuple(nb::ellipsis(), 0)];
  const Results powers = results_like(first);
  const Results errors = results_like(first);
  {
    const nb::gil_scoped_release release;
    const double limit = mu * load;
    for (std::size_t i = 0; i < count; ++i) {
      const double* const twist = given.data + 3 * i;
      const PatchFriction friction = patch.about_origin({twist[0], twist[1], twist[2]});
      wrenches.data[3 * i] = limit * friction.wrench.fx;
      wrenches.data[3 * i + 1] = limit * friction.wrench.fy;
      wrenches.data[3 * i + 2] = limit * friction.wrench.moment;
      powers.data[i] = limit * friction.power;
      errors.data[i] = friction.error;
    }
  }
  const bool single = is_single(twists);
  if (!truth_of(error)) return handed_over(wrenches, single);
  return nb::make_tuple(handed_over(wrenches, single), handed_over(powers, single), handed_over(errors, single));
}

nb::object loads_to_hold(const Patch& patch, nb::handle fx, nb::handle fy, nb::handle moment, double mu) {
  const std::vector<Numbers<double>> numbers = broadcast({fx, fy, moment}, {"fx", "fy", "moment"});
  const Results loads = results_like(numbers[0].array);
  {
    const nb::gil_scoped_release release;
    for (std::size_t i = 0; i < numbers[0].size; ++i) {
      const PatchWrench wrench{numbers[0].data[i], numbers[1].data[i], numbers[2].data[i]};
      const bool is_number = !std::isnan(wrench.fx) && !std::isnan(wrench.fy) && !std::isnan(wrench.moment);
      loads.data[i] = is_number ? load_to_hold(patch, mu, wrench) : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return handed_over(loads, is_single(fx) && is_single(fy) && is_single(moment));
}

}  // namespace

void add_patches(nb::module_& module) {
  nb::class_<Patch>(
      module, "Patch",
      "A contact of any shape, in the command line's grammar ('points:FILE.csv', 'polygon:FILE.csv',\n"
      "'rectangle:x=0.02,y=0.01', 'ellipse:law=hertz,a=0.004,b=0.002', 'image:FILE.csv,pixel=0.0005', each with ',mx=…,my=…'), or\n"
      "from arrays. Lengths in metres.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> patch = lc.Patch('rectangle:x=0.02,y=0.01')\n"
      ">>> [round(float(x), 12) + 0.0 for x in patch.wrench([0.1, 0, 0])]\n"
      "[1.0, 0.0, 0.0]\n")
      .def(
          "__init__", [](Patch* self, const std::string& text) { new (self) Patch(cli::read_patch(text)); }, nb::arg("text"),
          "ValueError names the error in the text or in the file, and the expected input.")
      .def_static(
          "points",
          [](nb::handle x, nb::handle y, nb::handle load) {
            const auto all = columns_of("", {"x", "y", "load"}, nb::list(nb::make_tuple(x, y, load)));
            std::vector<PatchLoad> points;
            for (std::size_t i = 0; i < all[0].size; ++i) points.push_back({all[0].data[i], all[1].data[i], all[2].data[i]});
            return Patch::points(points);
          },
          nb::arg("x"), nb::arg("y"), nb::arg("load"),
          nb::sig("def points(x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike, load: numpy.typing.ArrayLike) -> Patch"),
          "Points [m] with loads >= 0 of any unit.")
      .def_static(
          "polygon",
          [](nb::handle x, nb::handle y) {
            const auto all = columns_of("", {"x", "y"}, nb::list(nb::make_tuple(x, y)));
            std::vector<PatchPoint> vertices;
            for (std::size_t i = 0; i < all[0].size; ++i) vertices.push_back({all[0].data[i], all[1].data[i]});
            return Patch::polygon(vertices);
          },
          nb::arg("x"), nb::arg("y"), nb::sig("def polygon(x: numpy.typing.ArrayLike, y: numpy.typing.ArrayLike) -> Patch"),
          "Uniform pressure on a simple polygon [m].")
      .def_static(
          "image",
          [](nb::handle pressures, double pixel) {
            const bool has_mask = is_masked(pressures);
            if (has_mask) warn("pressures: masked pixels have no sensor, and count as without pressure");
            const Numbers<double> all = numbers_of<double>(has_mask ? pressures.attr("filled")(0.0) : nb::borrow(pressures), "pressures");
            const nb::tuple shape = all.array.attr("shape");
            if (nb::len(shape) != 2) {
              throw std::invalid_argument("pressures: got the shape " + text_of(shape) + ", expected two dimensions");
            }
            return Patch::image(std::span(all.data, all.size), nb::cast<std::size_t>(shape[1]), pixel);
          },
          nb::arg("pressures"), nb::arg("pixel"), nb::sig("def image(pressures: numpy.typing.ArrayLike, pixel: float) -> Patch"),
          "A pressure image; the first row is at the largest y; pixels are squares of side `pixel` [m]; the origin is the centre of "
          "pressure.\nA masked pixel counts as without pressure, with a warning.")
      .def("orthotropic", &Patch::orthotropic, nb::arg("mx"), nb::arg("my"),
           "The same patch with orthotropic friction: mu times mx along x and times my along y.")
      .def("moved", &Patch::moved, nb::arg("x"), nb::arg("y"), "The same patch, moved by (x, y) [m].")
      .def(
          "wrench", &wrench, nb::arg("twists"), nb::arg("mu") = 1.0, nb::arg("load") = 1.0, nb::kw_only(), nb::arg("error") = false,
          nb::sig(
              "def wrench(self, twists: numpy.typing.ArrayLike, mu: float = 1.0, load: float = 1.0, *, error: bool = False) -> typing.Any"),
          "The wrenches (fx, fy, moment) [N, N m] about the origin that keep the patch sliding with twists (vx, vy, omega) [m/s, "
          "rad/s].\n\n"
          "Shape (…, 3) in and out. With `error` also the powers [W], and a bound of the largest of the power's relative error,\n"
          "|dF|/(mu P) and |dM|/(mu P m0). Releases the GIL.")
      .def("load_to_hold", &loads_to_hold, nb::arg("fx"), nb::arg("fy"), nb::arg("moment"), nb::kw_only(), nb::arg("mu"),
           nb::sig("def load_to_hold(self, fx: numpy.typing.ArrayLike, fy: numpy.typing.ArrayLike, moment: numpy.typing.ArrayLike, *, "
                   "mu: float) -> typing.Any"),
           "The least loads [N] that hold friction wrenches [N, N m] about the origin, broadcast against each other; inf if no load does.\n"
           "Releases the GIL.")
      .def_prop_ro("moment_ratio", &Patch::moment_ratio, "m0: the moment of a pure spin over mu P [m].")
      .def_prop_ro("radius", &Patch::radius, "Largest distance of a point from the centre of pressure [m].")
      .def_prop_ro(
          "centre", [](const Patch& self) { return nb::make_tuple(self.centre().x, self.centre().y); },
          nb::sig("def centre(self) -> tuple[float, float]"), "Centre of pressure [m].");
}

}  // namespace limitcurve::python
