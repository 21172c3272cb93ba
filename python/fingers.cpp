// SPDX-License-Identifier: MIT
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "godobject/soft_finger.hpp"
#include "godobject/surfaces/join.hpp"
#include "limitcurve/internal/number.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <stdexcept>

namespace limitcurve::python {

using namespace godobject;

namespace {

/// A finger with what it was made from.
struct PyFinger : SoftFinger {
  nb::object contact;
  nb::dict given;

  PyFinger(SoftFinger finger, nb::handle on, nb::dict keywords)
      : SoftFinger(std::move(finger)), contact(nb::borrow(on)), given(std::move(keywords)) {}
};

constexpr const char* any_vector = "collections.abc.Sequence[float] | numpy.typing.NDArray[typing.Any]";
constexpr const char* plain_vector = "tuple[float, float, float] | numpy.typing.NDArray[numpy.float64]";

/// A method that takes a contact with a depth or a load, and the device's twist or orientation.
std::string step_signature(const std::string& name, const char* depth_or_load, const std::string& held,
                           const std::string& vector = any_vector) {
  return "def " + name + "(self, point: " + vector + ", normal: " + vector + ", " + depth_or_load + ": float, " + held +
         ", dt: float = 0.0, landed: bool = False) -> FingerOutput";
}

Orientation orientation_of(nb::handle given) {
  const Eigen::Vector4d q = four_numbers(given, "orientation");
  return {q[0], q[1], q[2], q[3]};
}

/// A step with the device's twist, of plain values and of all kinds, and NAME_pose with its orientation.
template <class Self, class Step>
void define_step(nb::class_<PyFinger>& type, const std::string& name, const char* depth_or_load, const Step& step,
                 const char* doc, const char* pose_doc) {
  const char* const twist = "twist: float";
  type.def(
      name.c_str(),
      [step](Self self, const PlainVector& point, const PlainVector& normal, PlainNumber of, PlainNumber held,
             PlainNumber dt,
             bool landed) { return step(self, point.value, normal.value, of.value, held.value, dt.value, landed); },
      nb::arg("point"), nb::arg("normal"), nb::arg(depth_or_load), nb::arg("twist"), nb::arg("dt") = 0.0,
      nb::arg("landed") = false, nb::sig(step_signature(name, depth_or_load, twist, plain_vector).c_str()));
  const auto define_held = [&](const std::string& own_name, const std::string& held, const auto& held_of,
                               const char* own_doc) {
    define<Self>(
        type, step_signature(own_name, depth_or_load, held),
        [=](Self self, const BoundArguments& given) {
          return step(self, three_numbers(given[0], "point"), three_numbers(given[1], "normal"),
                      number_of(given[2], depth_or_load), held_of(given[3]), number_of(given[4], "dt", 0.0),
                      truth_of(given[5]));
        },
        own_doc);
  };
  define_held(
      name, twist, [](nb::handle given) { return number_of(given, "twist"); }, doc);
  define_held(name + "_pose", std::string("orientation: ") + any_vector, &orientation_of, pose_doc);
}

constexpr const char* update_doc =
    "One step. Input: the contact (surface point [m], outward normal, depth [m] below the surface, <= 0 outside), "
    "the\n"
    "device's twist [rad] about the normal, and the time dt [s] since the last step, for the dampers and max_speed. "
    "If dt is 0,\n"
    "dampers do not act, and a finger that moves farther than max_speed allows in 1 ms (5 mm by default) is taken for "
    "a jump.\n"
    "landed: the finger left the surface since the last step and landed on it anew, as from one wall to another; then "
    "it touches\n"
    "down. On another body call reset() before. Outside, point and normal must be good as well; if you have none, pass "
    "the normal\n"
    "(0, 0, 0), so that the finger is free.\n\n"
    "Bad input (not finite, a normal off unit length by more than 1e-2, a jump, dt < 0) raises nothing; it gives the "
    "state "
    "`invalid`, with\n"
    "the reason in `fault`: the last good output is held, and fades.";

constexpr const char* update_under_load_doc =
    "One step where a physics engine gives the load [N] and not a depth. point: where the finger is on the surface "
    "[m], whose\n"
    "motion friction sees. With a load <= 0 the finger is free, even if the contact is bad; one that is not finite is "
    "bad input.\n"
    "The output has that load, and NaN for the depth. Friction reaches its limit on a surface of any radius. The rest "
    "as in `update`.";

void change(PyFinger& finger, const BoundArguments& given) {
  nb::dict all = read_files(without(given.by_name, ""));
  if (finger.patch() != nullptr && all.contains("radius_law"))
    throw std::invalid_argument("radius_law: not with a Patch, which has its own size");
  const double moment_max = finger.patch() != nullptr ? 0.0 : finger.curve()->moment_max();
  const FingerParameters parameters = parameters_of(all, moment_max);
  if (const auto bad = finger.refusal(parameters)) throw out_of_range(bad->name, bad->value, bad->unit, bad->range);
  finger.change(parameters);
  for (const char* const kept : {"projection", "point_radius"}) {
    if (finger.given.contains(kept)) all[kept] = finger.given[kept];
  }
  finger.given = all;
}

void add_output(nb::module_& module) {
  nb::enum_<ContactState>(module, "ContactState", nb::is_arithmetic(),
                          "State of a contact. str() is the command line's name.")
      .value("free", ContactState::free, "not touching")
      .value("stick", ContactState::stick, "touching, the proxy rests")
      .value("slip", ContactState::slip, "touching, the proxy slid in this step")
      .value("invalid", ContactState::invalid, "the input was not usable: the last good output is held, and fades");
  nb::enum_<Fault>(module, "Fault", "Why a sample is `invalid`.")
      .value("none", Fault::none, "it is not")
      .value("not_finite", Fault::not_finite, "a NaN or an infinity in the point, the normal, the depth or the twist")
      .value("too_far", Fault::too_far, "one of them is beyond 1e6")
      .value("orientation", Fault::orientation, "the length of the device's orientation is off 1 by more than 1e-2")
      .value("normal", Fault::normal, "that of the normal is")
      .value("time_step", Fault::time_step, "dt is < 0 or not finite")
      .value("speed", Fault::speed, "faster than max_speed since the last good sample")
      .value("body", Fault::body, "the pose of the touched body is none")
      .value("force", Fault::force, "the force or the moment on the touched body is none");
  nb::class_<FingerOutput> type(
      module, "FingerOutput",
      R"(Result of a step. The user feels `whole_force` and `moment_vector`; after `update_under_load` apply
`force` and `moment_vector` alone, the engine pushes.)");
  pickle_plainly<FingerOutput>(type);
  type.def_ro("state", &FingerOutput::state, "ContactState")
      .def_prop_ro(
          "proxy", [](const FingerOutput& self) { return self.proxy; }, "where the proxy is [m]")
      .def_ro("angle", &FingerOutput::angle, "of the proxy [rad]")
      .def_ro("depth", &FingerOutput::depth, "[m]")
      .def_prop_ro(
          "normal", [](const FingerOutput& self) { return self.normal; }, "outward")
      .def_ro("load", &FingerOutput::load,
              "normal force on the user [N]: what bounds friction (k_l depth), and on a curved surface its own push")
      .def_prop_ro(
          "force", [](const FingerOutput& self) { return self.force; }, "friction on the user [N], tangential")
      .def_prop_ro("whole_force", &FingerOutput::whole_force, "on the user [N]: normal * load + force")
      .def_ro("moment", &FingerOutput::moment, "friction on the user about the normal [N m]")
      .def_prop_ro("moment_vector", &FingerOutput::moment_vector, "on the user [N m]: normal * moment")
      .def_ro("cor", &FingerOutput::cor, "distance of the slip's centre of rotation [m]; NaN unless it slips")
      .def_ro("slip_work", &FingerOutput::slip_work, "dissipated in this step [J], >= 0 if converged")
      .def_ro("converged", &FingerOutput::converged, "False: the search for a patch's closest point did not converge")
      .def_ro("fault", &FingerOutput::fault, "Fault: the reason for the state `invalid`")
      .def("__repr__", [](const FingerOutput& self) {
        if (self.state == ContactState::invalid) return "<invalid: " + std::string(to_string(self.fault)) + ">";
        return "<" + std::string(to_string(self.state)) + ", load " + format_number(self.load) + " N, friction " +
               format_number(self.force.norm()) + " N and " + format_number(self.moment) + " N m>";
      });
}

void add_finger_types(nb::module_& module) {
  const std::string of_patch =
      "def __init__(self, patch: Patch, *, point_radius: float = 0.0, " + parameters_signature(true) + ") -> None";
  const std::string of_curve = "def __init__(self, curve: Table | Curve, *, projection: str = 'closest-point', " +
                               parameters_signature() + ") -> None";
  nb::class_<PyFinger> type(
      module, "SoftFinger",
      "A soft-finger god-object: springs, dampers, and friction within a limit curve or the limit surface of a "
      "patch.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> finger = lc.SoftFinger(lc.Table('hertz'), mu=0.6, radius_law='constant:a=0.006', stiffness=1000)\n"
      ">>> out = finger.update((0, 0, 0), (0, 0, 1), 0.002, 0.0, 1e-3)\n"
      ">>> str(out.state), out.load\n"
      "('stick', 2.0)\n"
      ">>> finger = lc.SoftFinger(lc.Patch('rectangle:x=0.02,y=0.01'), mu=0.6)\n"
      ">>> str(finger.update((0, 0, 0), (0, 0, 1), 0.002, 0.0).state)\n"
      "'stick'\n");
  type.def("__repr__",
           [](const PyFinger& self) {
             return "<SoftFinger on " + nb::cast<std::string>(nb::repr(self.contact)) + ", mu " +
                    format_number(self.parameters().mu) + ">";
           })
      .def("__getstate__",
           [](const PyFinger& self) { return nb::make_tuple(self.contact, self.given, packed(self.state())); })
      .def("__setstate__", [](PyFinger& self, const nb::tuple& state) {
        const nb::object made = nb::type<PyFinger>()(state[0], **nb::cast<nb::dict>(state[1]));
        new (&self) PyFinger(nb::cast<const PyFinger&>(made));
        self.restore(unpacked<FingerState>(nb::cast<nb::tuple>(state[2])));
      });
  type.def(
      "__init__",
      [parameters = Parameters(of_patch)](PyFinger* self, nb::handle_t<PyPatch> patch, const nb::args& others,
                                          const nb::kwargs& given) {
        if (given.contains("radius_law") || given.contains("projection"))
          throw std::invalid_argument(
              "radius_law, projection: not with a Patch, which has its own size and the closest point");
        static_cast<void>(parameters.bind(nb::borrow<nb::args>(nb::make_tuple(patch) + others), given));
        warn_without_skin("SoftFinger", given, true);
        const auto& on = nb::cast<const PyPatch&>(patch);
        const nb::object radius = given.contains("point_radius") ? given["point_radius"] : nb::object(nb::float_(0.0));
        new (self) PyFinger(SoftFinger(on, parameters_of(given, on.moment_ratio()), number_of(radius, "point_radius")),
                            patch, given);
      },
      nb::arg("patch"), nb::arg("args"), nb::arg("kwargs"), nb::sig(of_patch.c_str()),
      "A finger whose contact is a patch, with the closest point and without a radius law. `point_radius` [m] is given "
      "to the points\n"
      "of a patch; 0 is the least.");
  define<PyFinger*>(
      type, of_curve,
      [](PyFinger* self, const BoundArguments& given) {
        const nb::dict all = read_files(without(given.by_name, "curve"));
        warn_without_skin("SoftFinger", all);
        FingerCurve on = curve_of<double>(given[0]);
        const FingerParameters parameters = parameters_of(all, on.moment_max());
        new (self) PyFinger(SoftFinger(std::move(on), parameters, projection_of(given[1])), given[0], all);
      },
      "A finger with a limit curve; parameter names of the C++ FingerParameters, SI units. Projections: "
      "'closest-point', 'radial',\n"
      "'c-curve'. ValueError names a parameter out of range.");
  using Vector = Eigen::Vector3d;
  define_step<PyFinger&>(
      type, "update", "depth",
      [](PyFinger& self, const Vector& point, const Vector& normal, double depth, const auto& held, double dt,
         bool landed) {
        return self.update({point, normal, depth, {}, landed}, held, dt);
      },
      update_doc,
      "The same with the device's orientation (w, x, y, z; finger to surface) in place of its twist about the normal.");
  define_step<const PyFinger&>(
      type, "preview", "depth",
      [](const PyFinger& self, const Vector& point, const Vector& normal, double depth, const auto& held, double dt,
         bool landed) {
        return self.preview({point, normal, depth, {}, landed}, held, dt);
      },
      "What `update` would give; nothing changes.", "What `update_pose` would give; nothing changes.");
  define<PyFinger&>(type, "def change(self, *, " + parameters_signature() + ") -> None", &change,
                    "Other parameters in the loop, as where the finger touches another material: those that are absent "
                    "have their default,\n"
                    "as in the constructor. Proxy, angle and `output` stay; the next step has the new springs at the "
                    "same deflection. Where\n"
                    "the limit fell below the force it slips. ValueError for a bad one; then nothing changes.");
  define<PyFinger&>(
      type, "def copy_state(self, other: SoftFinger) -> None",
      [](PyFinger& self, const BoundArguments& given) {
        const PyFinger* other = nullptr;
        if (!nb::try_cast(given[0], other) || other == nullptr) refuse("other", given[0], "a SoftFinger");
        self.restore(other->state());
      },
      "Takes the state of another finger: proxy, memories and output, not its parameters.");
  define_step<PyFinger&>(
      type, "update_under_load", "load",
      [](PyFinger& self, const Vector& point, const Vector& normal, double load, const auto& held, double dt,
         bool landed) { return self.update_under_load(point, normal, load, held, dt, landed); },
      update_under_load_doc, "The same with the device's orientation in place of its twist.");
  define<PyFinger&>(type, "def reset(self) -> None", &SoftFinger::reset, "Back to the state before any contact.");
  type.def_prop_ro(
      "output", [](const PyFinger& self) { return self.output(); }, "Result of the last step.");
  define<const PyFinger&>(type, "def margin(self) -> float", &SoftFinger::margin,
                          "Distance to slip, from 1 (no friction) to 0 (slips).");
  define<const PyFinger&>(type, "def load_to_hold(self) -> float", &SoftFinger::load_to_hold,
                          "The least `load` of the output [N] that would hold the present friction.");
  define<const PyFinger&>(type, "def centre_of_rotation(self) -> numpy.typing.NDArray[numpy.float64]",
                          &SoftFinger::centre_of_rotation,
                          "Centre of rotation of the slip [m]; inf for pure sliding, NaN unless it slips.");
  define<const PyFinger&>(type, "def spring_energy(self) -> float", &SoftFinger::spring_energy,
                          "Energy of the springs [J].");
  define<const PyFinger&>(
      type, "def copy(self) -> SoftFinger", [](const PyFinger& self) { return self; },
      "Another finger in the same state.");
}

void add_join(nb::module_& module) {
  const std::string vector = any_vector;
  define_static(
      module,
      "def join(contacts: collections.abc.Iterable[tuple[" + vector + ", " + vector +
          ", float]]) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64], float]",
      [](const BoundArguments& given) {
        std::vector<Contact> walls;
        for (const nb::handle wall : nb::iter(given[0])) {
          const std::string name = "contacts[" + std::to_string(walls.size()) + "]";
          nb::object parts[3];
          if (!nb::isinstance<nb::sequence>(wall) || nb::len(wall) != 3) refuse(name, wall, "(point, normal, depth)");
          for (int i = 0; i < 3; ++i) parts[i] = wall[i];
          walls.push_back({three_numbers(parts[0], (name + ": point").c_str()),
                           three_numbers(parts[1], (name + ": normal").c_str()),
                           number_of(parts[2], name + ": depth")});
        }
        const Contact joined = join(walls);
        return std::tuple(joined.point, joined.normal, joined.depth);
      },
      "Makes a single contact of all walls that a finger is in, each (point, normal, depth), so that the friction "
      "along "
      "a groove does\n"
      "not fade. All walls must have the same finger position, point - normal * depth. The result has the nearest "
      "point "
      "outside of all\n"
      "walls; if there is no such point, or if two walls meet at less than 90 degrees, it is the deepest contact. "
      "Without walls, depth\n"
      "and normal are 0, so that a finger is free. If the tip is round, move each point outward by the radius "
      "before.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> finger = lc.SoftFinger(lc.Table('hertz'), mu=0.5, stiffness=1000, twist_stiffness=0.025)\n"
      ">>> walls = [((0.001, 0, 0), (0, 0, 1), 0.002), ((0, 0, -0.002), (1, 0, 0), -0.001)]\n"
      ">>> str(finger.update(*lc.join(walls), twist=0.0, dt=1e-3).state)\n"
      "'stick'\n");
}

struct PyMemory {
  FrictionMemory<double> memory;
};

void add_friction(nb::module_& module) {
  nb::class_<PyMemory> memory_type(module, "FrictionMemory", "State of a contact's friction between two steps.");
  pickle_plainly<PyMemory>(memory_type);
  define<PyMemory*>(
      memory_type, "def __init__(self) -> None", [](PyMemory* self) { new (self) PyMemory(); },
      "Of a contact at rest.");
  memory_type
      .def_prop_ro(
          "force_slides", [](const PyMemory& self) { return self.memory.force_slides; },
          "whether the sliding limit acts; on a box, that of the force")
      .def_prop_ro(
          "moment_slides", [](const PyMemory& self) { return self.memory.moment_slides; },
          "on a box, whether that of the moment acts");
  nb::class_<FrictionResult<double>> result_type(module, "FrictionResult", "Effect of friction on a trial wrench.");
  pickle_plainly<FrictionResult<double>>(result_type);
  result_type.def_ro("slips", &FrictionResult<double>::slips, "in this step")
      .def_ro("force_fraction", &FrictionResult<double>::force_fraction,
              "what the limit leaves of the trial's force, in [0, 1]")
      .def_ro("moment_fraction", &FrictionResult<double>::moment_fraction, "likewise")
      .def_ro("cor", &FrictionResult<double>::cor, "of the slip [m], inf for pure sliding; NaN where it sticks");
  define_static(
      module,
      "def apply_friction(curve: Table | Curve, force: float, moment: float, *, limit: float, radius: float, "
      "stiffness_ratio: float, "
      "sliding_limit: float | None = None, sliding_radius: float | None = None, force_stick_fraction: float = 1.0, "
      "moment_stick_fraction: "
      "float = 1.0, memory: FrictionMemory | None = None, projection: str = 'closest-point') -> FrictionResult",
      [](const BoundArguments& given) {
        const double force = number_of(given[1], "force");
        const double moment = number_of(given[2], "moment");
        const double limit = number_of(given[3], "limit");
        const double radius = number_of(given[4], "radius");
        const double stiffness_ratio = number_of(given[5], "stiffness_ratio");
        const double sliding_force = number_of(given[6], "sliding_limit", limit);
        const double radius_of_slip = number_of(given[7], "sliding_radius", radius);
        const double force_stick_fraction = number_of(given[8], "force_stick_fraction", 1.0);
        const double moment_stick_fraction = number_of(given[9], "moment_stick_fraction", 1.0);
        PyMemory forgotten;
        PyMemory* memory = &forgotten;
        if (!given[10].is_none() && !nb::try_cast(given[10], memory)) refuse("memory", given[10], "a FrictionMemory");
        const Projection way = parse_projection(string_of(given[11], "projection", "closest-point"));
        const auto require = [](bool holds, const char* name, double value, const char* expected) {
          if (!holds) throw out_of_range(name, value, "1", expected);
        };
        const auto finite = [](double value) { return std::isfinite(value) && value >= 0.0; };
        require(std::isfinite(force), "force", force, "a finite number");
        require(std::isfinite(moment), "moment", moment, "a finite number");
        require(finite(limit), "limit", limit, "[0, inf)");
        require(finite(radius), "radius", radius, "[0, inf)");
        require(finite(stiffness_ratio) && stiffness_ratio > 0.0, "stiffness_ratio", stiffness_ratio, "(0, inf)");
        require(finite(sliding_force) && sliding_force <= limit, "sliding_limit", sliding_force, "[0, limit]");
        // The moments of a finger are products of rounded numbers.
        require(finite(radius_of_slip) && sliding_force * radius_of_slip <= limit * radius * (1.0 + 1e-12),
                "sliding_radius", radius_of_slip, "[0, limit/sliding_limit*radius]");
        require(force_stick_fraction >= 0.0 && force_stick_fraction <= 1.0, "force_stick_fraction",
                force_stick_fraction, "[0, 1]");
        require(moment_stick_fraction >= 0.0 && moment_stick_fraction <= 1.0, "moment_stick_fraction",
                moment_stick_fraction, "[0, 1]");
        const FingerCurve on = curve_of<double>(given[0]);
        check_projection(on, way);
        // In units of no moment at all a trial would be infinitely far out, and its force lost.
        const double acting_radius = radius_of_slip > 0.0 ? radius_of_slip : 1e-20;
        const FrictionLimits<double> limits{{limit, radius},       {sliding_force, acting_radius},
                                            stiffness_ratio,       force_stick_fraction,
                                            moment_stick_fraction, has_torsion(radius, stiffness_ratio)};
        return apply_friction(on.view(), way, limits, FrictionTrial<double>{force, moment}, memory->memory);
      },
      "The fraction of a trial force [N] and moment [N m], of any sign, within the friction limit: for simulators with "
      "springs of\n"
      "their own.\n\n"
      "limit is mu P [N], radius is a [m], stiffness_ratio is k_l/k_r of the springs [1/m^2]. The `sliding_` limits "
      "act while the\n"
      "contact slips; `memory` stores that. A sliding contact comes to rest within the sliding limit times the smaller "
      "of the two rest\n"
      "shares; on a box force and moment each have their own. The projection 'c-curve' is radial here.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> table = lc.Table('hertz')\n"
      ">>> result = lc.apply_friction(table, 2.4, 0.0, limit=1.2, radius=0.006, stiffness_ratio=25000)\n"
      ">>> result.slips, round(result.force_fraction, 12)\n"
      "(True, 0.5)\n");
}

}  // namespace

void add_fingers(nb::module_& module) {
  add_output(module);
  add_finger_types(module);
  add_join(module);
  add_friction(module);
}

}  // namespace limitcurve::python
