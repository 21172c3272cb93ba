// SPDX-License-Identifier: MIT
#include "c/handles.hpp"

#include "godobject/finger/finger_parameter_table.hpp"
#include "godobject/friction.hpp"
#include "godobject/scene/passivity.hpp"
#include "godobject/surfaces/join.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

using namespace limitcurve;
using namespace limitcurve::c;
using namespace limitcurve::godobject;

namespace limitcurve::c {

namespace {

/// The members of the structure, in the order of `finger_parameter_table`.
using Parameters = limitcurve_finger_parameters;
constexpr std::array members{&Parameters::mu,
                             &Parameters::mu_dynamic,
                             &Parameters::mu_r,
                             &Parameters::gamma,
                             &Parameters::mu_r_dynamic,
                             &Parameters::stiffness,
                             &Parameters::twist_stiffness,
                             &Parameters::damping,
                             &Parameters::twist_damping,
                             &Parameters::rest_margin,
                             &Parameters::max_speed,
                             &Parameters::fault_decay};
static_assert(members.size() == finger_parameter_table.size());

}  // namespace

static_assert(static_cast<int>(Projection::closest_point) == LIMITCURVE_CLOSEST_POINT);
bool is_projection(limitcurve_projection projection) noexcept {
  return projection >= 0 && static_cast<std::size_t>(projection) < projection_names.size();
}

FingerParameters parameters_of(const limitcurve_finger_parameters& given, const RadiusLaw* otherwise) {
  // What no finger may have tells a structure of zero bytes, in which friction was never given.
  if (given.max_speed == 0.0)
    throw std::invalid_argument("max_speed: got 0, expected a number > 0; begin with limitcurve_finger_defaults()");
  if (given.radius_law != nullptr && !std::isnan(given.mu_r))
    throw std::invalid_argument("mu_r: not with radius_law, expected one of them: radius_law NULL, or mu_r NaN");
  if (given.radius_law == nullptr && std::isnan(given.mu_r) && otherwise == nullptr)
    throw std::invalid_argument("radius_law: got NULL, expected it, or mu_r");
  FingerParameters parameters;
  if (given.radius_law != nullptr) {
    parameters.radius_law = RadiusLaw::parse(given.radius_law);
  } else if (otherwise != nullptr) {
    parameters.radius_law = *otherwise;
  }
  auto member = members.begin();
  for_each_number(parameters, [&](const ParameterInfo&, auto& value) {
    const double number = given.**member++;
    // An absent number is NaN.
    if (std::is_same_v<decltype(value), double&> || !std::isnan(number)) value = number;
  });
  return parameters;
}

Projection projection_of(limitcurve_projection projection) {
  if (is_projection(projection)) return static_cast<Projection>(projection);
  throw std::invalid_argument("projection: got " + std::to_string(projection) + ", expected 0 to " +
                              std::to_string(projection_names.size() - 1));
}

}  // namespace limitcurve::c

namespace {

static_assert(static_cast<int>(Fault::none) == LIMITCURVE_FAULT_NONE &&
              static_cast<int>(Fault::force) == LIMITCURVE_FAULT_FORCE);

void copy(const Eigen::Vector3d& from, double (&to)[3]) noexcept {
  std::copy_n(from.data(), 3, to);
}

void write(const FingerOutput& step, limitcurve_finger_output& output) noexcept {
  copy(step.proxy, output.proxy);
  output.angle = step.angle;
  output.depth = step.depth;
  copy(step.normal, output.normal);
  output.load = step.load;
  copy(step.force, output.force);
  output.moment = step.moment;
  output.cor = step.cor;
  output.slip_work = step.slip_work;
  output.state = static_cast<limitcurve_state>(step.state);
  output.converged = step.converged ? 1 : 0;
  output.fault = static_cast<limitcurve_fault>(step.fault);
}

Contact contact_of(const limitcurve_contact& given) noexcept {
  return {Eigen::Vector3d(given.point), Eigen::Vector3d(given.normal), given.depth, {}, given.landed != 0};
}

limitcurve_contact contact_of(const Contact& joined, double twist) noexcept {
  limitcurve_contact result{{}, {}, joined.depth, twist, joined.landed ? 1 : 0};
  copy(joined.point, result.point);
  copy(joined.normal, result.normal);
  return result;
}

Orientation orientation_of(const double* given) noexcept {
  return {given[0], given[1], given[2], given[3]};
}

/// The parameters where no radius law is read: it may be NULL.
FingerParameters parameters_of_any(const limitcurve_finger_parameters& given) {
  const RadiusLaw unread = FingerParameters().radius_law;
  return parameters_of(given, &unread);
}

/// Writes a step's result, unless something is NULL. `held` is the orientation, or the contact again for its twist.
template <class Step>
limitcurve_status step(const limitcurve_finger* finger, const limitcurve_contact* contact, const void* held,
                       limitcurve_finger_output* output, const Step& take) {
  if (is_no_handle("finger", finger) || is_missing("contact", contact) || is_missing("orientation", held) ||
      is_missing("output", output))
    return LIMITCURVE_INVALID;
  write(take(), *output);
  return LIMITCURVE_OK;
}

bool is_limit(double force, double radius) noexcept {
  return force >= 0.0 && std::isfinite(force) && radius >= 0.0 && std::isfinite(radius);
}

/// Checks the friction limits; a static text names the error.
const char* fault_of(const limitcurve_limits& limits, double force, double moment,
                     const limitcurve_memory& memory) noexcept {
  if (!is_limit(limits.force, limits.radius) || !is_limit(limits.sliding_force, limits.sliding_radius))
    return "expected finite forces >= 0 and radii >= 0";
  // The moments of a finger are products of rounded numbers.
  constexpr double rounded = 1.0 + 1e-12;
  if (limits.sliding_force > limits.force ||
      limits.sliding_force * limits.sliding_radius > limits.force * limits.radius * rounded)
    return "sliding_force, and sliding_force times sliding_radius: expected not more than at rest";
  if (!(limits.stiffness_ratio > 0.0 && std::isfinite(limits.stiffness_ratio)))
    return "stiffness_ratio: expected a finite number > 0";
  const auto is_fraction = [](double fraction) { return fraction >= 0.0 && fraction <= 1.0; };
  if (!is_fraction(limits.force_stick_fraction) || !is_fraction(limits.moment_stick_fraction))
    return "force_stick_fraction and moment_stick_fraction: expected numbers from 0 to 1";
  if (!std::isfinite(force) || !std::isfinite(moment)) return "force and moment: expected finite numbers";
  if (!(memory.search_start >= 0.0 && memory.search_start <= 2.0 && std::fabs(memory.search_rate) <= 2.0))
    return "memory: expected all 0, or what the last step left";
  return nullptr;
}

}  // namespace

limitcurve_status limitcurve_apply_friction(const limitcurve_table* table, limitcurve_projection projection,
                                            const limitcurve_limits* limits, double force, double moment,
                                            limitcurve_memory* memory, limitcurve_friction* friction) {
  if (is_no_handle("table", table) || is_missing("limits", limits) || is_missing("memory", memory) ||
      is_missing("friction", friction))
    return LIMITCURVE_INVALID;
  if (!is_projection(projection)) return refuse("projection", "expected one of limitcurve_projection");
  if (table->curve.is_box() && projection != LIMITCURVE_CLOSEST_POINT)
    return refuse("projection", "a box goes with closest-point only");
  if (const char* const fault = fault_of(*limits, force, moment, *memory)) return refuse("friction", fault);
  // In units of no moment at all a trial would be infinitely far out, and its force lost.
  const double sliding_radius = limits->sliding_radius > 0.0 ? limits->sliding_radius : 1e-20;
  const FrictionLimits<double> acting{
      {limits->force, limits->radius}, {limits->sliding_force, sliding_radius},
      limits->stiffness_ratio,         limits->force_stick_fraction,
      limits->moment_stick_fraction,   has_torsion(limits->radius, limits->stiffness_ratio)};
  FrictionMemory<double> remembered{memory->force_slides != 0, memory->moment_slides != 0, memory->search_start,
                                    memory->search_rate};
  const auto result = apply_friction(table->curve.view(), static_cast<Projection>(projection), acting,
                                     FrictionTrial<double>{force, moment}, remembered);
  *memory = {remembered.search_start, remembered.search_rate, remembered.force_slides ? 1 : 0,
             remembered.moment_slides ? 1 : 0};
  *friction = {result.force_fraction, result.moment_fraction, result.cor, result.slips ? 1 : 0};
  return LIMITCURVE_OK;
}

limitcurve_finger_parameters limitcurve_finger_defaults(void) {
  limitcurve_finger_parameters result{};
  result.radius_law = "constant:a=0.005";
  auto member = members.begin();
  const FingerParameters standard;
  for_each_number(standard, [&](const ParameterInfo&, std::optional<double> value) {
    result.** member++ = value.value_or(std::numeric_limits<double>::quiet_NaN());
  });
  return result;
}

limitcurve_status limitcurve_finger_new(const limitcurve_table* table, const limitcurve_finger_parameters* parameters,
                                        limitcurve_projection projection, limitcurve_finger** finger) {
  if (is_no_handle("table", table) || is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  return make_handle(finger, [&] {
    return limitcurve_finger{SoftFinger(table->curve, parameters_of(*parameters), projection_of(projection))};
  });
}

limitcurve_status limitcurve_finger_new_patch(const limitcurve_patch* patch,
                                              const limitcurve_finger_parameters* parameters, double point_radius,
                                              limitcurve_finger** finger) {
  if (is_no_handle("patch", patch) || is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  limitcurve_finger_parameters own = *parameters;
  own.radius_law = nullptr;  // a patch has its own size
  return make_handle(finger,
                     [&] { return limitcurve_finger{SoftFinger(patch->patch, parameters_of_any(own), point_radius)}; });
}

void limitcurve_finger_free(limitcurve_finger* finger) {
  free_handle(finger);
}

namespace {

/// The caller's contacts as ours, without a copy of all: Clang 14 cannot compile std::views::transform.
struct Wall {
  using value_type = Contact;
  using difference_type = std::ptrdiff_t;

  const limitcurve_contact* given = nullptr;

  Contact operator*() const noexcept { return contact_of(*given); }
  Wall& operator++() noexcept {
    ++given;
    return *this;
  }
  Wall operator++(int) noexcept { return {given++}; }
  bool operator==(const Wall&) const = default;
};

struct Walls {
  Wall first;
  Wall last;

  [[nodiscard]] Wall begin() const noexcept { return first; }
  [[nodiscard]] Wall end() const noexcept { return last; }
};

}  // namespace

limitcurve_status limitcurve_join(const limitcurve_contact* contacts, size_t count, limitcurve_contact* joined) {
  if (is_missing("joined", joined) || (count > 0 && is_missing("contacts", contacts))) return LIMITCURVE_INVALID;
  const Walls walls{{contacts}, {contacts + count}};
  *joined = contact_of(join(walls), count > 0 ? contacts->twist : 0.0);
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_finger_update(limitcurve_finger* finger, const limitcurve_contact* contact,
                                           double time_step, limitcurve_finger_output* output) {
  return step(finger, contact, contact, output,
              [&] { return finger->finger.update(contact_of(*contact), contact->twist, time_step); });
}

limitcurve_status limitcurve_finger_update_pose(limitcurve_finger* finger, const limitcurve_contact* contact,
                                                const double orientation[4], double time_step,
                                                limitcurve_finger_output* output) {
  return step(finger, contact, orientation, output,
              [&] { return finger->finger.update(contact_of(*contact), orientation_of(orientation), time_step); });
}

limitcurve_status limitcurve_finger_preview(const limitcurve_finger* finger, const limitcurve_contact* contact,
                                            double time_step, limitcurve_finger_output* output) {
  return step(finger, contact, contact, output,
              [&] { return finger->finger.preview(contact_of(*contact), contact->twist, time_step); });
}

limitcurve_status limitcurve_finger_preview_pose(const limitcurve_finger* finger, const limitcurve_contact* contact,
                                                 const double orientation[4], double time_step,
                                                 limitcurve_finger_output* output) {
  return step(finger, contact, orientation, output,
              [&] { return finger->finger.preview(contact_of(*contact), orientation_of(orientation), time_step); });
}

limitcurve_status limitcurve_finger_update_under_load(limitcurve_finger* finger, const limitcurve_contact* contact,
                                                      double load, double time_step, limitcurve_finger_output* output) {
  return step(finger, contact, contact, output, [&] {
    const Contact touched = contact_of(*contact);
    return finger->finger.update_under_load(touched.point, touched.normal, load, contact->twist, time_step,
                                            touched.landed);
  });
}

limitcurve_status limitcurve_finger_update_under_load_pose(limitcurve_finger* finger, const limitcurve_contact* contact,
                                                           double load, const double orientation[4], double time_step,
                                                           limitcurve_finger_output* output) {
  return step(finger, contact, orientation, output, [&] {
    const Contact touched = contact_of(*contact);
    return finger->finger.update_under_load(touched.point, touched.normal, load, orientation_of(orientation), time_step,
                                            touched.landed);
  });
}

limitcurve_status limitcurve_finger_change(limitcurve_finger* finger, const limitcurve_finger_parameters* parameters) {
  if (is_no_handle("finger", finger) || is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  limitcurve_status status = LIMITCURVE_OK;
  const limitcurve_status read = guarded([&] {
    SoftFinger& changed = finger->finger;
    const FingerParameters& before = changed.parameters();
    const FingerParameters next = parameters_of(*parameters, before.mu_r ? nullptr : &before.radius_law);
    if (const auto bad = changed.refusal(next)) {
      status = refuse(bad->name, bad->value, bad->range);
    } else {
      changed.change(next);
    }
  });
  return read != LIMITCURVE_OK ? read : status;
}

limitcurve_status limitcurve_finger_copy_state(const limitcurve_finger* from, limitcurve_finger* to) {
  if (is_no_handle("from", from) || is_no_handle("to", to)) return LIMITCURVE_INVALID;
  to->finger.restore(from->finger.state());
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_finger_spring_energy(const limitcurve_finger* finger, double* spring_energy) {
  if (is_no_handle("finger", finger) || is_missing("spring_energy", spring_energy)) return LIMITCURVE_INVALID;
  *spring_energy = finger->finger.spring_energy();
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_finger_reset(limitcurve_finger* finger) {
  if (is_no_handle("finger", finger)) return LIMITCURVE_INVALID;
  finger->finger.reset();
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_finger_centre_of_rotation(const limitcurve_finger* finger, double centre_of_rotation[3]) {
  if (is_no_handle("finger", finger) || is_missing("centre_of_rotation", centre_of_rotation)) return LIMITCURVE_INVALID;
  const Eigen::Vector3d centre = finger->finger.centre_of_rotation();
  std::copy_n(centre.data(), 3, centre_of_rotation);
  return LIMITCURVE_OK;
}

limitcurve_status limitcurve_device_damping_needed(const limitcurve_finger_parameters* parameters, double sample_time,
                                                   int delay, double* sliding, double* twist) {
  if (is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  return guarded([&] {
    const DeviceDamping needed = device_damping_needed(parameters_of_any(*parameters), sample_time, delay);
    if (sliding != nullptr) *sliding = needed.sliding;
    if (twist != nullptr) *twist = needed.twist;
  });
}

limitcurve_status limitcurve_require_passive(const limitcurve_finger_parameters* parameters, double sample_time,
                                             int delay, double sliding, double twist) {
  if (is_missing("parameters", parameters)) return LIMITCURVE_INVALID;
  return guarded([&] { require_passive(parameters_of_any(*parameters), sample_time, {sliding, twist}, delay); });
}

limitcurve_status limitcurve_finger_margin(const limitcurve_finger* finger, double* margin, double* load_to_hold) {
  if (is_no_handle("finger", finger)) return LIMITCURVE_INVALID;
  if (margin != nullptr) *margin = finger->finger.margin();
  if (load_to_hold != nullptr) *load_to_hold = finger->finger.load_to_hold();
  return LIMITCURVE_OK;
}
