// SPDX-License-Identifier: MIT
#include "fit/engine_coefficients.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitcurve::fit {

namespace {

/// Largest distance between the wrenches of two curves at the same twist, in the normalised plane of the exact one: over twists evenly
/// spaced in the normalised slip angle, and beside the twists where box and diamond jump between corners. A smooth maximum is found to
/// 1e-6.
template <class Model>
double wrench_error(const Model& model, const ExactCurve& exact) {
  constexpr int steps = 4000;
  constexpr double quarter_turn = 1.5707963267948966;
  constexpr double beside = 1e-9;
  const auto error_at = [&](double angle) {
    const SlipTwist twist{std::sin(angle), std::cos(angle) / exact.moment_ratio()};
    const UnitWrench a = model.wrench(twist);
    const UnitWrench b = exact.wrench(twist);
    return std::hypot(a.force - b.force, (a.moment - b.moment) / exact.moment_ratio());
  };
  double largest = 0.0;
  for (const double angle : {beside, 0.5 * quarter_turn - beside, 0.5 * quarter_turn + beside, quarter_turn - beside}) {
    largest = std::max(largest, error_at(angle));
  }
  for (int i = 0; i < steps; ++i) largest = std::max(largest, error_at(quarter_turn * (i + 0.5) / steps));
  return largest;
}

/// Measures the shape of `make(moment_max)`, in unit wrenches at the load of the translation. At another load the engine's moment limit
/// per newton is constant, while the contact's grows with a(P).
template <class MakeModel>
void measure(EngineContact& contact, const ExactCurve& exact, const RadiusLaw& radius_law, double load, LoadRange loads, MakeModel make) {
  contact.error = curve_error(make(exact.moment_ratio()), exact);
  contact.max_wrench_error = wrench_error(make(exact.moment_ratio()), exact);
  contact.max_error_over_loads = contact.error.max_error;
  // The error depends on the largest change of the radius; a measured law need not be monotone.
  double least = 1.0;
  double greatest = 1.0;
  constexpr int steps = 1024;
  for (int i = 0; i <= steps; ++i) {
    const double other = loads.low * std::pow(loads.high / loads.low, static_cast<double>(i) / steps);
    const double ratio = radius_law.radius(load) / radius_law.radius(other);
    least = std::min(least, ratio);
    greatest = std::max(greatest, ratio);
  }
  for (const double ratio : {least, greatest}) {
    if (ratio == 1.0) continue;
    const double worst = curve_error(make(exact.moment_ratio() * ratio), exact).max_error;
    contact.max_error_over_loads = std::max(contact.max_error_over_loads, worst);
  }
}

}  // namespace

std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load, LoadRange loads) {
  const auto require = [](const char* name, double value, const char* unit) {
    if (!(value > 0.0) || std::isinf(value)) throw out_of_range(name, value, unit, "> 0 and finite");
  };
  require("mu", mu, "1");
  require("load", load, "N");
  require("lowest load", loads.low, "N");
  if (!(loads.high >= loads.low) || std::isinf(loads.high)) throw out_of_range("highest load", loads.high, "N", ">= the lowest and finite");

  const ExactCurve exact(law);
  const double lever = exact.moment_ratio() * radius_law.radius(load);
  const double mu_r = mu * lever;
  constexpr double pi = 3.14159265358979323846;
  const double hertz_radius = 16.0 / (3.0 * pi) * lever;

  const EngineCoefficient sliding{"", mu, "1", "mu"};
  const auto named = [](EngineCoefficient coefficient, const char* parameter) {
    coefficient.parameter = parameter;
    return coefficient;
  };
  const EngineCoefficient torsional{"", mu_r, "m", "mu m0 a(P)"};

  const auto ellipse = [](double moment_max) { return Ellipse(1.0, moment_max); };
  const auto pyramid = [](double moment_max) { return diamond(1.0, moment_max); };
  const auto uncoupled = [](double moment_max) { return box(1.0, moment_max); };

  std::vector<EngineContact> contacts;
  const auto add = [&](EngineContact contact, auto make) {
    measure(contact, exact, radius_law, load, loads, make);
    contacts.push_back(std::move(contact));
  };

  const std::vector<EngineCoefficient> mujoco{
      {"geom.condim", 4.0, "1", "sliding and torsion"}, named(sliding, "geom.friction[0]"), named(torsional, "geom.friction[1]")};
  std::vector<EngineCoefficient> mujoco_elliptic = mujoco;
  mujoco_elliptic.push_back({"option.impratio", 10.0, "1", "advice: friction ten times as stiff as the normal constraint, against creep"});
  mujoco_elliptic.push_back({"option.cone", 1.0, "1", "mjCONE_ELLIPTIC; the default is pyramidal", "elliptic"});
  std::vector<EngineCoefficient> mujoco_pyramidal = mujoco;
  mujoco_pyramidal.push_back({"option.cone", 0.0, "1", "mjCONE_PYRAMIDAL, the default", "pyramidal"});
  add({"mujoco",
       "ellipse",
       mujoco_elliptic,
       {},
       0.0,
       0.0,
       "https://mujoco.readthedocs.io/en/stable/computation/index.html#friction-cones",
       "needs <option cone=\"elliptic\"/>; of two geoms the larger coefficient counts, so set both or the priority; the documentation "
       "calls friction[1] the diameter of the patch, but the moment's limit is friction[1] times the load"},
      ellipse);
  add({"mujoco",
       "diamond",
       mujoco_pyramidal,
       {},
       0.0,
       0.0,
       "https://mujoco.readthedocs.io/en/stable/computation/index.html#friction-cones",
       "the default <option cone=\"pyramidal\"/>; sliding is a pyramid too, weakest between its axes; keep impratio at 1; its friction is "
       "soft: slip of a few mm/s may meet only a third of the limit, where the elliptic cone with its impratio meets all of it"},
      pyramid);
  add({"chrono",
       "box",
       {named(sliding, "SetFriction"), named(torsional, "SetSpinningFriction")},
       {},
       0.0,
       0.0,
       "https://api.projectchrono.org/classchrono_1_1_ch_contact_material_n_s_c.html",
       "non-smooth contacts (NSC); the spinning moment is projected on its own, apart from sliding"},
      uncoupled);
  add({"gazebo",
       "box",
       {named(sliding, "surface/friction/ode/mu"),
        named(sliding, "surface/friction/ode/mu2"),
        named(sliding, "surface/friction/torsional/coefficient"),
        {"surface/friction/torsional/use_patch_radius", 1.0, "1", "true: a radius that does not follow the depth"},
        {"surface/friction/torsional/patch_radius", hertz_radius, "m", "16 m0 a(P)/(3 pi), which is a(P) for hertz"}},
       {},
       0.0,
       0.0,
       "https://classic.gazebosim.org/tutorials?tut=torsional_friction&cat=physics",
       "with the ODE engine only; it computes T = 3 pi/16 patch_radius coefficient N, a Hertzian contact's moment, whatever the law"},
      uncoupled);
  add({"physx",
       "box",
       {named(sliding, "PxMaterial.staticFriction"),
        named(sliding, "PxMaterial.dynamicFriction"),
        {"PxShape.minTorsionalPatchRadius", lever, "m", "m0 a(P)"},
        {"PxShape.torsionalPatchRadius", 0.0, "m", "0: else the lever grows as the root of radius times depth"}},
       {},
       0.0,
       0.0,
       "https://docs.rs/physx-sys/latest/physx_sys/fn.PxShape_setMinTorsionalPatchRadius_mut.html",
       "the lever is max(min, sqrt(depth torsionalPatchRadius)), times friction and load; only where the contact patch has a single point"},
      uncoupled);
  add({"bullet",
       "box",
       {named(sliding, "setFriction"),
        named(torsional, "setSpinningFriction"),
        {"setRollingFriction", 1e-3 * mu_r, "m", "any small number > 0: without rolling friction Bullet skips the spinning friction too"}},
       {},
       0.0,
       0.0,
       "https://github.com/bulletphysics/bullet3/blob/master/src/BulletCollision/CollisionDispatch/btManifoldResult.cpp",
       "the other body needs friction 1 and spinning friction 0: frictions multiply, and each spinning friction is multiplied by the "
       "other body's friction; without any rolling friction there is none about the normal; the impulse of a step must stay below 1 N s"},
      uncoupled);
  add({"ode",
       "box",
       {named(sliding, "surface.mu"),
        named(sliding, "surface.mu2"),
        {"surface.rho", 0.0, "m", "no rolling friction"},
        {"surface.rho2", 0.0, "m", "no rolling friction"},
        named(torsional, "surface.rhoN")},
       {},
       0.0,
       0.0,
       "http://ode-wiki.org/wiki/index.php?title=Manual:_Joint_Types_and_Functions",
       "mode needs dContactAxisDep (else rho serves for rhoN), dContactRolling and dContactApprox1 (else the limits are in N and N m, "
       "whatever the load); sliding is a pyramid"},
      uncoupled);
  return contacts;
}

std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load) {
  return translate(law, radius_law, mu, load, {0.25 * load, 4.0 * load});
}

}  // namespace limitcurve::fit
