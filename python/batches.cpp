// SPDX-License-Identifier: MIT
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "godobject/batch/batch.hpp"
#include "limitcurve/internal/number.hpp"

#include <nanobind/stl/variant.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

namespace limitcurve::python {

using namespace godobject;

namespace {

/// A batch with its arrays; one thread at a time steps it.
template <class Real>
class Contacts {
 public:
  Contacts(nb::handle curve, std::size_t count, const FingerParameters& parameters, Projection projection)
      : batch_(curve_of<Real>(curve), parameters, projection), arrays_(count) {}

  void update(nb::handle x, nb::handle y, nb::handle depth, nb::handle twist) {
    const Input at_x = input(x, "x");
    const Input at_y = input(y, "y");
    const Input depths = input(depth, "depth");
    const Input angles = input(twist, "twist");
    const nb::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    BasicContactBatch<Real> contacts = arrays_.batch();
    contacts.x = all_of(at_x, arrays_.x());
    contacts.y = all_of(at_y, arrays_.y());
    contacts.twist = all_of(angles, arrays_.twist());
    contacts.depth = all_of(depths, arrays_.depth());
    batch_.step(contacts);
  }

  void reset() {
    const std::lock_guard lock(mutex_);
    // In place: the caller may hold views.
    const BasicContactBatch<Real> all = arrays_.batch();
    for_each_array(all, [](const auto array) { std::ranges::fill(array, std::remove_cvref_t<decltype(array[0])>{}); });
  }

  /// The bytes of all that a step changes.
  [[nodiscard]] nb::list state() {
    const std::lock_guard lock(mutex_);
    nb::list result;
    for_each_array(arrays_.batch(),
                   [&](const auto array) { result.append(nb::bytes(array.data(), array.size_bytes())); });
    return result;
  }
  void restore(const nb::list& state) {
    std::size_t i = 0;
    for_each_array(arrays_.batch(), [&](const auto array) {
      const auto bytes = nb::cast<nb::bytes>(state[i++]);
      if (bytes.size() != array.size_bytes()) throw std::invalid_argument("a pickled batch of another size");
      if (bytes.size() > 0) std::memcpy(array.data(), bytes.c_str(), bytes.size());
    });
  }

  [[nodiscard]] std::size_t size() const { return arrays_.size(); }
  [[nodiscard]] BasicContactBatch<Real> view() { return arrays_.batch(); }

 private:
  template <class Work>
  static void for_each_array(const BasicContactBatch<Real>& all, const Work& work) {
    for (const auto array :
         {all.proxy_x, all.proxy_y, all.proxy_angle, all.search_start, all.search_rate, all.fx, all.fy, all.moment})
      work(array);
    for (const auto array : {all.state, all.force_slides, all.moment_slides}) work(array);
  }

  /// The caller's array of numbers, one for each contact, or his single number for all of them.
  struct Input {
    std::span<const Real> numbers;
    nb::object array;
    Real single = 0;
  };
  /// One number for each contact: a single one fills the batch's own array.
  static std::span<const Real> all_of(const Input& input, std::span<Real> own) {
    if (input.array.is_valid()) return input.numbers;
    std::ranges::fill(own, input.single);
    return own;
  }
  [[nodiscard]] Input input(nb::handle values, const char* name) {
    const std::size_t count = arrays_.size();
    std::optional<double> single = plain_number(values);
    Numbers<Real> numbers{};
    if (!single) numbers = numbers_of<Real>(values, name);
    if (!single && numbers.dimensions == 0) single = numbers.data[0];
    if (single) return {{}, {}, static_cast<Real>(*single)};
    if (numbers.dimensions != 1 || numbers.size != count) {
      throw std::invalid_argument(std::string(name) + ": got the shape " + text_of(numbers.array.attr("shape")) +
                                  ", expected (" + std::to_string(count) + ",)");
    }
    // An input that overlaps the batch's results would change during the step.
    const BasicContactBatch<Real> own = arrays_.batch();
    const std::less<> before;
    if (count > 0 && !before(numbers.data, own.x.data()) && before(numbers.data, own.moment.data() + count))
      numbers = numbers_of<Real>(numbers.array.attr("copy")(), name);
    return {{numbers.data, count}, std::move(numbers.array)};
  }

  BasicBatch<Real> batch_;
  BasicContactArrays<Real> arrays_;
  std::mutex mutex_;
};

struct PyBatch {
  std::variant<std::unique_ptr<Contacts<double>>, std::unique_ptr<Contacts<float>>> contacts;
  nb::object curve;  ///< what it was made from
  nb::dict given;
};

bool is_single_precision(nb::handle dtype) {
  const nb::object type = numpy("dtype")(dtype);
  const std::string name = text_of(type);
  if (name == "float64" || name == "float32") return name == "float32";
  throw std::invalid_argument("dtype: got " + name + ", expected float64 or float32");
}

/// A read-only view of one of the batch's arrays, which keeps the batch alive.
template <class Select>
nb::object view_of(nb::handle self, const Select& select) {
  return std::visit(
      [&](const auto& contacts) -> nb::object {
        const auto array = select(contacts->view());
        using Element = typename decltype(array)::element_type;
        if constexpr (std::is_same_v<Element, ContactState>) {
          return nb::cast(nb::ndarray<nb::numpy, const std::uint8_t>(
              reinterpret_cast<const std::uint8_t*>(array.data()), {array.size()}, self));
        } else {
          return nb::cast(nb::ndarray<nb::numpy, const Element>(array.data(), {array.size()}, self));
        }
      },
      nb::cast<PyBatch&>(self).contacts);
}

}  // namespace

void add_batches(nb::module_& module) {
  nb::class_<PyBatch> batch(
      module, "Batch",
      R"(Many contacts in arrays. They share a limit curve and parameters; each is in its own tangent plane.

A batch does step b only: friction by the curve, springs, radius law, static and dynamic friction. Dampers, fading and
unwrapping of angles need a SoftFinger. A sample that is not usable (NaN, farther than 1e6 m), or a proxy that is NaN,
makes its contact `invalid`; the last output of that contact stays.

>>> import limitcurve as lc, numpy as np
>>> batch = lc.Batch(lc.Table('hertz', 1e-8), 3, mu=0.6)
>>> batch.update(0.0, 0.0, 0.002, 0.0)
>>> batch.update(np.array([0, 1e-3, 1e-2]), np.zeros(3), np.full(3, 0.002), np.zeros(3))
>>> [str(lc.ContactState(s)) for s in batch.state]
['stick', 'stick', 'slip']
>>> [round(float(f), 6) for f in batch.fx]
[0.0, -1.0, -1.2]
)");
  const std::string signature =
      "def __init__(self, curve: Table | Curve, n: int, *, dtype: numpy.typing.DTypeLike = 'float64', "
      "projection: str = 'closest-point', " +
      parameters_signature() + ") -> None";
  batch.def("__repr__", [](const PyBatch& self) {
    const std::size_t count = std::visit([](const auto& contacts) { return contacts->size(); }, self.contacts);
    return "<Batch of " + std::to_string(count) + " contacts on " + nb::cast<std::string>(nb::repr(self.curve)) +
           (self.contacts.index() == 1 ? ", float32>" : ">");
  });
  define<PyBatch*>(
      batch, signature,
      [](PyBatch* self, const BoundArguments& given) {
        const nb::handle curve = given[0];
        std::size_t n = 0;
        if (!nb::try_cast(given[1], n)) refuse("n", given[1], "a whole number >= 0");
        PyBatch made{.contacts = {}, .curve = given[0], .given = read_files(without(given.by_name, "curve"))};
        warn_without_skin("Batch", made.given);
        made.given["n"] = n;
        const Projection projection = projection_of(given[3]);
        const FingerParameters parameters = parameters_of(made.given, curve_of<double>(curve).moment_max());
        if (parameters.damping != 0.0 || parameters.twist_damping != 0.0)
          throw std::invalid_argument("damping, twist_damping: expected 0, a batch has no dampers");
        for (const char* const name : {"max_speed", "fault_decay"}) {
          if (made.given.contains(name))
            throw std::invalid_argument(name +
                                        std::string(": expected none, a batch refuses no jump and fades no output"));
        }
        if (is_single_precision(given[2])) {
          made.contacts = std::make_unique<Contacts<float>>(curve, n, parameters, projection);
        } else {
          made.contacts = std::make_unique<Contacts<double>>(curve, n, parameters, projection);
        }
        new (self) PyBatch(std::move(made));
      },
      R"(n free contacts at the origin; parameters as for SoftFinger, but no dampers, max_speed and fault_decay.
If contacts twist, mu_dynamic and mu_r_dynamic should not be 0: the other limit may then be exceeded, or its friction
lost. A SoftFinger takes any.
dtype float32 needs half the memory and time and resolves 6e-8 of a
coordinate; its table is that of the given one, to 5e-7 or 1 % of its tolerance.)");
  define<PyBatch&>(
      batch,
      "def update(self, x: ArrayLike, y: ArrayLike, depth: ArrayLike, twist: ArrayLike, dt: float = 0.0) -> "
      "None",
      [](PyBatch& self, const BoundArguments& given) {
        const double dt = number_of(given[4], "dt", 0.0);
        if (!(dt >= 0.0 && std::isfinite(dt))) throw out_of_range("dt", dt, "s", "[0, inf)");
        std::visit([&](const auto& contacts) { contacts->update(given[0], given[1], given[2], given[3]); },
                   self.contacts);
      },
      "Steps all contacts, in place: finger positions x, y [m] in the tangent plane, depths [m] (<= 0: free), twists "
      "[rad], unwrapped.\n"
      "Arrays of length n, or one number for all. Contiguous arrays of the batch's dtype are not copied; others are.\n"
      "dt [s] has no effect, for a batch has no dampers. A contact with NaN or a value beyond 1e6 holds its last "
      "output (`invalid`).\n"
      "Releases the GIL; calls from several threads wait for each other.");
  batch.def("__getstate__", [](const PyBatch& self) {
    return nb::make_tuple(self.curve, self.given,
                          std::visit([](const auto& contacts) { return contacts->state(); }, self.contacts));
  });
  batch.def("__setstate__", [](PyBatch& self, const nb::tuple& state) {
    const nb::object made = nb::type<PyBatch>()(state[0], **nb::cast<nb::dict>(state[1]));
    new (&self) PyBatch(std::move(nb::cast<PyBatch&>(made)));
    std::visit([&](const auto& contacts) { contacts->restore(nb::cast<nb::list>(state[2])); }, self.contacts);
  });
  define<PyBatch&>(
      batch, "def reset(self) -> None",
      [](PyBatch& self) { std::visit([](const auto& contacts) { contacts->reset(); }, self.contacts); },
      "All contacts free, at the origin.");
  batch.def("__len__", [](const PyBatch& self) {
    return std::visit([](const auto& contacts) { return contacts->size(); }, self.contacts);
  });
  const auto add_view = [&](const char* name, const char* doc, const auto& select) {
    batch.def_prop_ro(
        name, [select](nb::handle self) { return view_of(self, select); },
        nb::sig(("def " + std::string(name) + "(self) -> numpy.typing.NDArray[typing.Any]").c_str()), doc);
  };
  add_view("fx", "friction on the user along x [N]: a read-only view, as all that follow",
           [](const auto& all) { return all.fx; });
  add_view("fy", "friction on the user along y [N]", [](const auto& all) { return all.fy; });
  add_view("moment", "friction moment on the user [N m]", [](const auto& all) { return all.moment; });
  add_view("state", "ContactState, as uint8", [](const auto& all) { return all.state; });
  batch.def_prop_ro(
      "invalid",
      [](nb::handle self) {
        return nb::object(self.attr("state").attr("__eq__")(static_cast<int>(ContactState::invalid)));
      },
      nb::sig("def invalid(self) -> numpy.typing.NDArray[numpy.bool_]"),
      "Whether the last sample of each contact was not usable.");
  add_view("proxy_x", "where the proxies are [m]", [](const auto& all) { return all.proxy_x; });
  add_view("proxy_y", "where the proxies are [m]", [](const auto& all) { return all.proxy_y; });
  add_view("proxy_angle", "how the proxies are turned [rad]", [](const auto& all) { return all.proxy_angle; });
}

}  // namespace limitcurve::python
