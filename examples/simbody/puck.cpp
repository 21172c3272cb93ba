// SPDX-License-Identifier: MIT
// A puck in Simbody that slides and spins on one soft pad until it rests. Simbody's headers are not C++20:
// limitcurve11.hpp.
#include "limitcurve11.hpp"

#include <Simbody.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace SimTK;

/// The soft pad at a body's origin as a force element. The ground has walls, each with a point and the outward normal.
/// An integrator asks for forces as often as it likes, so that they are previews; `commit` makes a step.
class SoftPad : public Force::Custom::Implementation {
 public:
  SoftPad(const MobilizedBody& body, const limitcurve11::Finger& finger, const std::vector<limitcurve_contact>& walls)
      : body_(body), finger_(finger.handle()), walls_(walls) {}

  void calcForce(const State& s, Vector_<SpatialVec>& forces, Vector_<Vec3>&, Vector&) const override {
    const Sample at = sample(s);
    limitcurve_finger_output out;
    limitcurve_finger_preview_pose(finger_, &at.contact, &at.orientation[0], 0, &out);
    body_.applyForceToBodyPoint(s, Vec3(0), Vec3(&limitcurve11::whole_force(out)[0]), forces);
    body_.applyBodyTorque(s, Vec3(&limitcurve11::moment_vector(out)[0]), forces);
  }
  Real calcPotentialEnergy(const State&) const override {  // of the last commit
    double energy;
    limitcurve_finger_spring_energy(finger_, &energy);
    return energy;
  }
  void commit(const State& s) {
    const Sample at = sample(s);
    limitcurve_finger_output out;
    limitcurve_finger_update_pose(finger_, &at.contact, &at.orientation[0], 0, &out);
  }

 private:
  struct Sample {
    limitcurve_contact contact;
    Vec4 orientation;
  };
  Sample sample(const State& s) const {
    const Vec3 p = body_.getBodyOriginLocation(s);
    std::vector<limitcurve_contact> walls = walls_;
    for (limitcurve_contact& wall : walls) {
      const Vec3 normal(wall.normal);
      wall.depth = dot(normal, Vec3(wall.point) - p);
      Vec3::updAs(wall.point) = p + wall.depth * normal;
    }
    Sample result;
    limitcurve_join(walls.data(), walls.size(), &result.contact);
    result.orientation = body_.getBodyRotation(s).convertRotationToQuaternion().asVec4();
    return result;
  }
  const MobilizedBody& body_;
  limitcurve_finger* finger_;
  std::vector<limitcurve_contact> walls_;
};

/// Commits every millisecond.
class Commit : public PeriodicEventHandler {
 public:
  Commit(const MultibodySystem& system, SoftPad& pad) : PeriodicEventHandler(1e-3), system_(system), pad_(pad) {}
  void handleEvent(State& s, Real, bool&) const override {
    system_.realize(s, Stage::Position);
    pad_.commit(s);
  }

 private:
  const MultibodySystem& system_;
  SoftPad& pad_;
};

int main() {
  limitcurve_finger_parameters skin = limitcurve_finger_defaults();
  skin.mu = 0.6;
  skin.radius_law = "constant:a=0.006";
  skin.stiffness = 20000;
  skin.twist_stiffness = 0.72;
  limitcurve11::Finger finger(limitcurve11::Table("hertz"), skin);

  const double mass = 0.2;
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  GeneralForceSubsystem forces(system);
  Force::Gravity(forces, matter, -ZAxis, 9.81);
  MobilizedBody::Translation carriage(matter.Ground(), Body::Massless());
  MobilizedBody::Pin puck(carriage, Body::Rigid(MassProperties(mass, Vec3(0), Inertia(1e-4, 1e-4, 2e-6))));
  auto* pad = new SoftPad(puck, finger, {{{0, 0, 0}, {0, 0, 1}, 0, 0, 0}, {{0.1, 0, 0}, {-1, 0, 0}, 0, 0, 0}});
  Force::Custom(forces, pad);  // owns it
  Force::MobilityLinearDamper(forces, carriage, MobilizerUIndex(2), 20);
  system.addEventHandler(new Commit(system, *pad));
  State s = system.realizeTopology();
  carriage.setQ(s, Vec3(0, 0, -mass * 9.81 / skin.stiffness));
  carriage.setU(s, Vec3(0.3, 0, 0));
  puck.setRate(s, 80);
  system.realize(s, Stage::Position);
  pad->commit(s);
  RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(1e-5);
  TimeStepper stepper(system, integrator);
  stepper.initialize(s);
  stepper.stepTo(0.5);

  const double way = 1e3 * stepper.getState().getQ()[0], angle = stepper.getState().getQ()[3];
  std::printf("%.3f mm and %.4f rad; its equations of motion with the exact wrench: 10.602 mm and 2.5427 rad\n", way,
              angle);
  return std::abs(way - 10.602) < 0.05 && std::abs(angle - 2.5427) < 0.02 ? 0 : 1;
}
