// SPDX-License-Identifier: MIT
#pragma once

#include "tests/fit/engines/dragged.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace limitcurve::fit::engines {

/// A finger in Bullet; the wrench is from the velocity lost in the last step.
inline Measured drag_in_bullet(const EngineContact& contact, SlipTwist twist) {
  constexpr double gravity = 10.0;
  constexpr double step = 1e-3;
  constexpr double ball = 0.02;
  const double radius = radius_law().radius(load);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-gravity)));
  world.getSolverInfo().m_numIterations = 200;

  btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
  btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  ground.setFriction(1);
  world.addRigidBody(&ground);

  btSphereShape sphere{btScalar(ball)};
  const auto mass = static_cast<btScalar>(load / gravity);
  const auto inertia = static_cast<btScalar>(1e-4);
  btRigidBody finger(btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &sphere, btVector3(inertia, inertia, inertia)));
  btTransform start;
  start.setIdentity();
  start.setOrigin(btVector3(0, 0, btScalar(ball)));
  finger.setWorldTransform(start);
  finger.setFriction(btScalar(coefficient(contact, "setFriction")));
  finger.setSpinningFriction(btScalar(coefficient(contact, "setSpinningFriction")));
  finger.setRollingFriction(btScalar(coefficient(contact, "setRollingFriction")));
  // It slides along x and turns about the normal; sliding does not make it roll.
  finger.setLinearFactor(btVector3(1, 0, 1));
  finger.setAngularFactor(btVector3(0, 0, 1));
  finger.setActivationState(DISABLE_DEACTIVATION);
  world.addRigidBody(&finger);

  const btScalar speed(1.0);
  const btScalar slide = speed * btScalar(twist.slide);
  const btScalar spin = speed * btScalar(twist.spin / radius);
  double normal = 0.0;
  double force = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 300; ++i) {
    finger.setLinearVelocity(btVector3(slide, 0, finger.getLinearVelocity().z()));
    finger.setAngularVelocity(btVector3(0, 0, spin));
    world.stepSimulation(btScalar(step), 0, btScalar(step));
    force = std::fabs(static_cast<double>(finger.getLinearVelocity().x() - slide)) * load / gravity / step;
    moment = std::fabs(static_cast<double>(finger.getAngularVelocity().z() - spin)) * static_cast<double>(inertia) / step;
    normal = 0.0;
    for (int k = 0; k < dispatcher.getNumManifolds(); ++k) {
      const btPersistentManifold* const manifold = dispatcher.getManifoldByIndexInternal(k);
      for (int p = 0; p < manifold->getNumContacts(); ++p) {
        normal += static_cast<double>(manifold->getContactPoint(p).getAppliedImpulse()) / step;
      }
    }
  }
  world.removeRigidBody(&finger);
  world.removeRigidBody(&ground);
  return {{force / (friction * normal), moment / (friction * normal * radius)}, normal};
}

}  // namespace limitcurve::fit::engines
