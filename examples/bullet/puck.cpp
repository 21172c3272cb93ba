// SPDX-License-Identifier: MIT
// A puck in Bullet that slides and spins on one soft pad until it rests: Bullet's solver pushes, without friction;
// limitcurve brakes.
#include "godobject/godobject.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;

/// The pad of a body on the ground z = 0.
struct SoftPad {
  btRigidBody* body;
  god::SoftFinger finger;
  double angle = 0;

  /// Bullet calls it before each substep; a force would last until the last of them, an impulse does not.
  static void brake(btDynamicsWorld* world, btScalar dt) {
    auto& pad = *static_cast<SoftPad*>(world->getWorldUserInfo());
    double load = 0;  // by the last step's impulses
    for (int i = 0; i < world->getDispatcher()->getNumManifolds(); ++i) {
      const btPersistentManifold* touching = world->getDispatcher()->getManifoldByIndexInternal(i);
      for (int j = 0; j < touching->getNumContacts(); ++j)
        load += touching->getContactPoint(j).getAppliedImpulse() / dt;
    }
    const btVector3 x = pad.body->getWorldTransform().getOrigin();
    const btQuaternion q = pad.body->getWorldTransform().getRotation();
    const auto out = pad.finger.update_under_load({x.x(), x.y(), 0}, {0, 0, 1}, load,
                                                  god::Orientation(q.w(), q.x(), q.y(), q.z()), dt);
    pad.body->applyImpulse(dt * btVector3(btScalar(out.force.x()), btScalar(out.force.y()), 0), {0, 0, -x.z()});
    pad.body->applyTorqueImpulse({0, 0, dt * btScalar(out.moment)});
    pad.angle += dt * pad.body->getAngularVelocity().z();
  }
};

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, btScalar(-9.81)});
  btStaticPlaneShape plane({0, 0, 1}, 0);
  btRigidBody ground(0, nullptr, &plane);
  btCylinderShapeZ disc({btScalar(0.02), btScalar(0.02), btScalar(0.005)});
  btRigidBody::btRigidBodyConstructionInfo info(btScalar(0.2), nullptr, &disc,
                                                {btScalar(1e-4), btScalar(1e-4), btScalar(2e-6)});
  info.m_friction = 0;
  info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), {0, 0, btScalar(0.005)});
  btRigidBody puck(info);
  puck.setActivationState(DISABLE_DEACTIVATION);
  world.addRigidBody(&ground);
  world.addRigidBody(&puck);

  const god::FingerParameters skin{
      .mu = 0.6, .radius_law = lc::RadiusLaw::constant(0.006), .stiffness = 20000, .twist_stiffness = 0.72};
  SoftPad pad{&puck, god::SoftFinger(lc::Table::build(lc::hertz(), 1e-8), skin)};
  world.setInternalTickCallback(SoftPad::brake, &pad, true);

  const double dt = 2.5e-4;
  for (int i = 0; i < 800; ++i) world.stepSimulation(btScalar(dt), 1, btScalar(dt));  // settles
  const btVector3 from = puck.getWorldTransform().getOrigin();
  puck.setLinearVelocity({btScalar(0.3), 0, 0});
  puck.setAngularVelocity({0, 0, 80});
  pad.angle = 0;
  for (int i = 0; i < 300; ++i) world.stepSimulation(btScalar(4 * dt), 4, btScalar(dt));
  const double way = 1e3 * (puck.getWorldTransform().getOrigin().x() - from.x());
  std::printf("%.3f mm and %.4f rad; its equations of motion with the exact wrench: 10.602 mm and 2.5427 rad\n", way,
              pad.angle);
  return std::abs(way - 10.602) < 0.11 && std::abs(pad.angle - 2.5427) < 0.025 ? 0 : 1;
}
