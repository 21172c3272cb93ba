// SPDX-License-Identifier: MIT
// For hosts in C++11, 14 or 17: fingers over limitcurve.h, which has units and ranges. A constructor and `change` throw
// std::invalid_argument, or std::runtime_error where the job failed, with limitcurve_error(); what a loop calls does
// not throw. Link with liblimitcurve-c.
#ifndef LIMITCURVE11_HPP
#define LIMITCURVE11_HPP

#include "limitcurve.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>

namespace limitcurve11 {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // w, x, y, z

inline void check(limitcurve_status status) {
  if (status == LIMITCURVE_INVALID) throw std::invalid_argument(limitcurve_error());
  if (status != LIMITCURVE_OK) throw std::runtime_error(limitcurve_error());
}

/// The table of a law. Immutable; copies share it.
class Table {
 public:
  explicit Table(const std::string& law, double tolerance = 1e-8) {
    limitcurve_law* made = nullptr;
    check(limitcurve_law_parse(law.c_str(), &made));
    const std::unique_ptr<limitcurve_law, void (*)(limitcurve_law*)> owner(made, limitcurve_law_free);
    limitcurve_table* table = nullptr;
    check(limitcurve_table_build(made, tolerance, &table));
    handle_.reset(table, limitcurve_table_free);
  }
  const limitcurve_table* handle() const noexcept { return handle_.get(); }

 private:
  std::shared_ptr<limitcurve_table> handle_;
};

/// A finger; it moves, and what was moved from may only be destroyed or assigned to. `handle` is for the functions that
/// have no member here.
class Finger {
 public:
  Finger(const Table& table, const limitcurve_finger_parameters& skin,
         limitcurve_projection projection = LIMITCURVE_CLOSEST_POINT)
      : handle_(nullptr, limitcurve_finger_free) {
    limitcurve_finger* finger = nullptr;
    check(limitcurve_finger_new(table.handle(), &skin, projection, &finger));
    handle_.reset(finger);
  }
  limitcurve_finger_output update(const limitcurve_contact& contact, double time_step = 0) noexcept {
    limitcurve_finger_output output{};
    limitcurve_finger_update(handle(), &contact, time_step, &output);
    return output;
  }
  limitcurve_finger_output update(const limitcurve_contact& contact, const Quaternion& orientation,
                                  double time_step = 0) noexcept {
    limitcurve_finger_output output{};
    limitcurve_finger_update_pose(handle(), &contact, orientation.data(), time_step, &output);
    return output;
  }
  limitcurve_finger_output update_under_load(const limitcurve_contact& contact, double load,
                                             double time_step = 0) noexcept {
    limitcurve_finger_output output{};
    limitcurve_finger_update_under_load(handle(), &contact, load, time_step, &output);
    return output;
  }
  void change(const limitcurve_finger_parameters& skin) { check(limitcurve_finger_change(handle(), &skin)); }
  void reset() noexcept { limitcurve_finger_reset(handle()); }
  limitcurve_finger* handle() const noexcept { return handle_.get(); }

 private:
  std::unique_ptr<limitcurve_finger, void (*)(limitcurve_finger*)> handle_;
};

/// Force [N] and moment [N m] on the user. After an update under a load apply `force` and the moment alone.
inline Vector whole_force(const limitcurve_finger_output& out) noexcept {
  return {{out.normal[0] * out.load + out.force[0], out.normal[1] * out.load + out.force[1],
           out.normal[2] * out.load + out.force[2]}};
}
inline Vector moment_vector(const limitcurve_finger_output& out) noexcept {
  return {{out.normal[0] * out.moment, out.normal[1] * out.moment, out.normal[2] * out.moment}};
}

}  // namespace limitcurve11

#endif
