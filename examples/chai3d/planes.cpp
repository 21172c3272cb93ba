// SPDX-License-Identifier: MIT
// CHAI3D's cursor with a soft finger on two planes: a slide, a twist, and both; a plane that moves; from one plane to
// the other.
#include "cAlgorithmSoftFinger.h"

#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include "devices/CGenericHapticDevice.h"
#include "graphics/CPrimitives.h"
#include "world/CMesh.h"
#include "world/CWorld.h"

#include <cmath>
#include <cstdio>

using namespace limitcurve;
using namespace limitcurve::chai;

static int wrong = 0;

static void expect(const char* what, double found, double expected) {
  std::printf("%-40s %9.6f\n", what, found);
  if (!(std::abs(found - expected) < 2e-6)) wrong += std::printf("  expected %.6f\n", expected);
}

int main() {
  cWorld world;
  const auto plane = [&world](double z, const cMatrix3d& rotation, double mu, double mu_dynamic) {
    auto* mesh = new cMesh();
    cCreatePlane(mesh, 1, 1, cVector3d(0, 0, z), rotation);
    mesh->createAABBCollisionDetector(0);
    mesh->m_material->setStiffness(1000);
    mesh->m_material->setStaticFriction(mu);
    mesh->m_material->setDynamicFriction(mu_dynamic);
    world.addChild(mesh);
    return mesh;
  };
  cMatrix3d down;
  down.setAxisAngleRotationRad(1, 0, 0, C_PI);
  cMesh* floor = plane(0, cIdentity3d(), 0.6, 0.7);  // CHAI3D allows more friction in motion than at rest
  cMesh* ceiling = plane(0.03, down, 0.4, 0.4);

  const double mu = 0.6, a = 0.006;
  const godobject::FingerParameters skin{.mu_r = mu * hertz()->moment_ratio() * a, .twist_stiffness = 0.036};
  cAlgorithmSoftFinger* finger = new cAlgorithmSoftFinger(Table::build(hertz(), 1e-8), skin);
  cToolSoftFinger tool(&world, finger);
  tool.setRadius(0);
  tool.initialize();

  cVector3d force, torque;
  const auto step = [&](double x, double z, double angle) {
    cMatrix3d rotation;
    rotation.setAxisAngleRotationRad(0, 0, 1, angle);
    world.computeGlobalPositions(true);
    tool.setDeviceGlobalPos(x, 0, z);
    tool.setDeviceGlobalRot(rotation);
    tool.computeInteractionForces();
    force = tool.getDeviceGlobalForce();
    torque = tool.getDeviceGlobalTorque();
  };
  // Presses, and goes on with these speeds for a second.
  const auto drag = [&](double speed, double rate) {
    for (int i = 0; i < 1200; ++i)
      step(speed * 1e-3 * std::max(0, i - 200), std::max(-0.002, 0.002 - 4e-5 * i), rate * 1e-3 * std::max(0, i - 200));
  };
  drag(0.02, 0);
  expect("slide: F/(mu P)", -force.x() / (mu * force.z()), 1);
  drag(0, 3);
  expect("twist: M/(mu P a)", -torque.z() / (mu * a * force.z()), 3 * C_PI / 16);
  drag(0.02, 0.02 / a);
  const auto exact = hertz()->forces(1);
  expect("both about a centre at a: F/(mu P)", -force.x() / (mu * force.z()), exact.force);
  expect("                          M/(mu P a)", -torque.z() / (mu * a * force.z()), exact.moment);
  for (int i = 0; i < 1000; ++i) {
    floor->setLocalPos(4e-5 * i, 0, 0);
    step(0.02, -0.002, 20 / a * 1e-3);
  }
  expect("the plane moves: F/(mu P)", force.x() / (mu * force.z()), 1);
  step(0.02, -0.002, 20 / a * 1e-3);
  step(0.02, 0.032, 20 / a * 1e-3);
  expect("on the other plane: F", force.x(), 0);
  expect("                    P", -force.z(), 1000 * (0.032 - finger->getProxyGlobalPosition().z()));
  for (int i = 0; i < 1000; ++i) step(0.02 + 2e-5 * i, 0.032, 20 / a * 1e-3);
  expect("                    F/(mu P)", force.x() / (0.4 * force.z()), 1);
  ceiling->m_material->setUseHapticFriction(false);
  step(0.04, 0.032, 20 / a * 1e-3);
  expect("friction is off: F", std::hypot(force.x(), force.y(), torque.z()), 0);
  expect("                 P", -force.z(), 1000 * (0.032 - finger->getProxyGlobalPosition().z()));
  ceiling->m_material->setStiffness(0);
  step(0.04, 0.032, 20 / a * 1e-3);
  expect("a material of stiffness 0: F", force.length(), 0);
  tool.setHapticDevice(cGenericHapticDevice::create());
  tool.setWorkspaceScaleFactor(20);
  drag(0, 3);
  expect("20 m of the world per m of the hand: M", -20 * torque.z() / (mu * a * force.z()), 3 * C_PI / 16);
  return wrong;
}
