// SPDX-License-Identifier: MIT
// A soft finger as a force algorithm of CHAI3D 3.3, and a cursor that carries its torque.
#pragma once

#include "godobject/godobject.hpp"

#include "math/CQuaternion.h"
#include "tools/CToolCursor.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace limitcurve::chai {

using namespace chai3d;
using namespace godobject;

/// CHAI3D's proxy, without its friction, finds the contact. Friction and stiffness are those of the touched object's
/// material; radius law, twist stiffness and dampers those of the finger, which with dampers needs the `timeStep` [s].
/// Lengths are those of the world, the hand's times the tool's workspace scale: the tool divides the torque by it.
class cAlgorithmSoftFinger : public cAlgorithmFingerProxy {
 public:
  cAlgorithmSoftFinger(const FingerCurve& curve, const FingerParameters& skin, double timeStep = 0)
      : m_finger(curve, skin), m_skin(skin), m_timeStep(timeStep) {
    m_useDynamicProxy = true;  // otherwise CHAI3D finds one wall a step, and in a corner another one each time
  }

  cMatrix3d m_deviceRot = cIdentity3d();  ///< in the world's frame, to be set before each step
  cVector3d m_torque{0, 0, 0};            ///< on the user, in the world's frame
  const SoftFinger& finger() const { return m_finger; }

  cVector3d computeForces(const cVector3d& toolPos, const cVector3d& toolVel) override {
    cAlgorithmFingerProxy::computeForces(toolPos, toolVel);
    // The object stays while it is touched at all: another one has another frame.
    cGenericObject* object = m_numCollisionEvents > 0 ? m_collisionEvents[0]->m_object : nullptr;
    for (unsigned int i = 0; i < m_numCollisionEvents; ++i)
      if (m_collisionEvents[i]->m_object == m_object) object = m_object;
    const bool changed = std::exchange(m_object, object) != object;
    if (object == nullptr || !m_finger.change(touching(*object->m_material))) {  // free, or a material of stiffness 0
      m_finger.reset();
      m_torque.zero();
      m_lastGlobalForce.zero();
      return m_lastGlobalForce;
    }
    // The walls pass through the proxy, which is the tip's centre.
    std::array<Contact, 3> walls;
    for (unsigned int i = 0; i < m_numCollisionEvents; ++i) {
      const cVector3d normal = cNormalize(m_collisionEvents[i]->m_globalNormal);
      const double depth = cDot(m_proxyGlobalPos - toolPos, normal);
      walls[i] = {(toolPos + depth * normal).eigen(), normal.eigen(), depth};
    }
    const BodyPose body{object->getGlobalPos().eigen(), orientation(object->getGlobalRot())};
    Contact contact = to_body(body, join(std::span(walls).first(m_numCollisionEvents)));
    if (changed) m_finger.reset();
    contact.landed = contact.normal.dot(m_finger.output().normal) < 0;  // on a wall that faces the other way
    const FingerOutput out =
        to_world(body, m_finger.update(contact, to_body(body, orientation(m_deviceRot)), m_timeStep));
    m_torque = out.moment_vector();
    return m_lastGlobalForce = out.whole_force();
  }

 protected:
  void testFrictionAndMoveProxy(const cVector3d& goal, const cVector3d&, cVector3d&, cGenericObject*) override {
    m_nextBestProxyGlobalPos = goal;
  }

 private:
  static Orientation orientation(const cMatrix3d& rotation) {
    cQuaternion q;
    q.fromRotMat(rotation);
    return Orientation(q.w, q.x, q.y, q.z).normalized();
  }
  FingerParameters touching(const cMaterial& material) const {
    FingerParameters skin = m_skin;
    skin.mu = material.getUseHapticFriction() ? material.getStaticFriction() : 0;
    skin.mu_dynamic = std::min(material.getDynamicFriction(), skin.mu);
    if (skin.mu == 0) skin.mu_r = skin.mu_r_dynamic = 0;  // without friction there is no moment
    skin.stiffness = material.getStiffness();
    return skin;
  }

  SoftFinger m_finger;
  FingerParameters m_skin;
  cGenericObject* m_object = nullptr;
  double m_timeStep;
};

/// CHAI3D's force algorithms get no rotation and return no torque: the tool carries both.
class cToolSoftFinger : public cToolCursor {
 public:
  cToolSoftFinger(cWorld* world, cAlgorithmSoftFinger* algorithm) : cToolCursor(world), m_algorithm(algorithm) {
    delete m_hapticPoint->m_algorithmFingerProxy;
    m_hapticPoint->m_algorithmFingerProxy = algorithm;  // the point deletes it
  }
  void computeInteractionForces() override {
    m_algorithm->m_deviceRot = m_deviceGlobalRot;
    cToolCursor::computeInteractionForces();
    setDeviceGlobalTorque(m_algorithm->m_torque / getWorkspaceScaleFactor());
  }

 private:
  cAlgorithmSoftFinger* m_algorithm;
};

}  // namespace limitcurve::chai
