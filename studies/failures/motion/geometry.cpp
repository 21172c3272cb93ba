// SPDX-License-Identifier: MIT
// Entry "geometry": angles and shapes.
#include "../failures.hpp"
#include "../numerics/sampling.hpp"

#include "../../../tests/touch.hpp"
#include "godobject/soft_finger.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using Eigen::Vector3d;

constexpr double stiffness = 1000.0;

/// The usual surface point nearest to a finger in a box: on the face that is nearest now.
Contact nearest_face(const Vector3d& half, const Vector3d& finger) {
  int axis = 0;
  const double depth = -(finger.cwiseAbs() - half).maxCoeff(&axis);
  Contact contact{finger, Vector3d::Zero(), depth};
  contact.normal[axis] = finger[axis] >= 0.0 ? 1.0 : -1.0;
  contact.point[axis] = contact.normal[axis] * half[axis];
  return contact;
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// The usual torsional friction: a spring from the proxy's angle to the device's, wrapped and clamped.
class CustomaryTwist {
 public:
  explicit CustomaryTwist(double largest_lag) : largest_lag_(largest_lag) {}

  /// The moment on the user over the limit.
  double update(double device) {
    const double lag = wrapped(proxy_ - device);
    const double held = std::clamp(lag, -largest_lag_, largest_lag_);
    if (held != lag) proxy_ = device + held;
    return held / largest_lag_;
  }

 private:
  double largest_lag_;
  double proxy_ = 0.0;
};

}  // namespace

Hazard half_a_turn() {
  Hazard found;
  Figure& figure = found.draw("turns_half");
  // A spring so soft that it slips after four radians. The device reports its angle within ±π.
  constexpr double largest_lag = 4.0;
  constexpr double limit = 0.002;  // [N m]
  CustomaryTwist customary(largest_lag);
  SoftFinger finger(Ellipse::through_intercepts(0.5),
                    {.mu = 1.0, .mu_r = limit, .stiffness = stiffness, .twist_stiffness = limit / largest_lag});
  const Contact contact{Vector3d::Zero(), Vector3d::UnitZ(), 1.0 / stiffness};
  finger.update(contact, 0.0);
  constexpr std::array series{"difference wrapped", "limitcurve"};
  std::array<double, 2> worst{};
  constexpr int steps = 800;
  for (int i = 1; i <= steps; ++i) {
    const double angle = 12.0 * i / steps;
    const double device = wrapped(angle);
    const std::array moments{customary.update(device), finger.update(contact, device).moment / limit};
    for (std::size_t j = 0; j < series.size(); ++j) {
      // Right friction: against the rotation, growing to the limit and staying there.
      raise(worst[j], std::fabs(moments[j] + std::min(angle / largest_lag, 1.0)));
      if (i % 5 == 0) figure.add("moment", series[j], angle, moments[j]);
    }
  }
  found.add("twist passes ±π", "spring, difference wrapped into ±π", "error of the moment / limit (slips after 4 rad)",
            worst[0], worst[1]);
  return found;
}

Hazard thin_plate() {
  Hazard found;
  const Vector3d half{0.03, 0.02, 0.0005};
  const BoxSurface box(half);
  ContactMemory memory;
  const auto push = [](const Contact& contact) {
    return stiffness * std::max(contact.depth, 0.0) * contact.normal.z();
  };
  std::array<double, 2> short_by{};
  for (int i = -20; i <= 300; ++i) {
    const double depth = 1e-5 * i;
    const Vector3d finger(0.003, 0.001, half.z() - depth);
    const std::array forces{push(nearest_face(half, finger)), push(touch(box, finger, memory))};
    for (std::size_t j = 0; j < forces.size(); ++j) {
      raise(short_by[j], std::max(stiffness * depth, 0.0) - forces[j]);
    }
  }
  found.add("thin plate", "nearest surface point (ours: box)",
            "k_l d minus the force towards the finger's side [N] (pressed 3 mm into 1 mm, 1000 N/m)", short_by[0],
            short_by[1]);
  return found;
}

Hazard normals_that_jump() {
  constexpr double mu = 0.8;
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  with.max_speed = 1e9;  // some jump
  SoftFinger finger(Ellipse::through_intercepts(hertz()->moment_ratio()), with);
  // Around a rod with eight edges, just below its surface.
  Vector3d proxy(0.0, 0.0, 0.0);
  bool touched = false;
  double customary = 0.0;
  double ours = 0.0;
  double work = 0.0;
  Hazard found;
  for (int i = 0; i < 4000; ++i) {
    const double angle = 0.002 * i;
    const double of_face = 0.25 * std::numbers::pi * std::round(angle / (0.25 * std::numbers::pi));
    const Vector3d normal(std::cos(of_face), std::sin(of_face), 0.0);
    const double inner = 0.02;
    const Vector3d place = 0.019 * Vector3d(std::cos(angle), std::sin(angle), 0.0);
    const double depth = inner - normal.dot(place);
    const Contact contact{place + normal * depth, normal, depth};
    // The usual method: a spring from the finger's point on the surface to the proxy, clamped to the limit.
    if (!touched) proxy = contact.point;
    touched = true;
    Vector3d pull = proxy - contact.point;
    const double most = mu * depth;
    if (pull.norm() > most) pull *= most / pull.norm();
    proxy = contact.point + pull;
    raise(customary, std::fabs(pull.dot(normal)) / most);
    const FingerOutput output = finger.update(contact, 0.0);
    raise(ours, std::fabs(output.force.dot(normal)) / (mu * output.load));
    work = std::min(work, output.slip_work);
  }
  found.add("normals that jump", "spring to the proxy, clamped to μP", "friction along the normal / μP (edges of 45°)",
            customary, std::max(ours, -work));
  return found;
}

}  // namespace limitcurve::stability
