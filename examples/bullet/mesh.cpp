// SPDX-License-Identifier: MIT
// A soft finger on triangle meshes and other bodies that move, found by Bullet's collisions.
#include "godobject/godobject.hpp"
#include "godobject/surfaces/join.hpp"

#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;

static Eigen::Vector3d eigen(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
static god::BodyPose pose(const btTransform& at) {
  const btQuaternion q = at.getRotation();
  return {eigen(at.getOrigin()), god::Orientation(q.w(), q.x(), q.y(), q.z()).normalized()};
}

/// The walls that a ball is in: contacts of its centre with walls moved out by its radius, in the world's frame.
struct Walls : btCollisionWorld::ContactResultCallback {
  Walls(const btCollisionObject& ball, const btCollisionObject* touched) : tip(&ball), last(touched) {}
  const btCollisionObject *tip, *last;
  const btCollisionObject* object =
      nullptr;  ///< the last one while it is touched at all, otherwise that of the deepest
  double deepest = 0;
  std::vector<god::Contact> contacts;
  btScalar addSingleResult(btManifoldPoint& p, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    const bool swapped = b->getCollisionObject() == tip;  // with a compound shape
    const btCollisionObject* other = (swapped ? a : b)->getCollisionObject();
    const double depth = -p.getDistance();
    if (!other->hasContactResponse() || depth <= 0) return 0;
    const Eigen::Vector3d normal = eigen(swapped ? -p.m_normalWorldOnB : p.m_normalWorldOnB).normalized();
    contacts.push_back({eigen(tip->getWorldTransform().getOrigin()) + depth * normal, normal, depth});
    const bool stays = object != nullptr && object == last;
    if (other == last || (!stays && depth > deepest)) object = other;
    deepest = std::max(deepest, depth);
    return 0;
  }
};

/// A finger whose tip is a ball. It may sink in by half its radius: deeper, Bullet's contacts with edges are no walls.
class BallFinger {
 public:
  BallFinger(const god::SoftFinger& finger, double radius) : finger_(finger), ball_(btScalar(radius)) {
    tip_.setCollisionShape(&ball_);
  }

  /// One step: force and moment on the user in the world's frame.
  god::FingerOutput update(btCollisionWorld& world, const btTransform& device, double dt) {
    Walls walls(tip_, object_);
    tip_.setWorldTransform(device);
    world.contactTest(&tip_, walls);
    const bool changed = std::exchange(object_, walls.object) != walls.object;
    if (changed || walls.object == nullptr) finger_.reset();
    if (walls.object == nullptr) return {};
    const god::BodyPose body = pose(walls.object->getWorldTransform());
    god::Contact contact = to_body(body, god::join(walls.contacts));
    contact.landed = contact.normal.dot(finger_.output().normal) < 0;  // on a wall that faces the other way
    return to_world(body, finger_.update(contact, to_body(body, pose(device).orientation), dt));
  }

 private:
  god::SoftFinger finger_;
  btSphereShape ball_;
  btCollisionObject tip_;
  const btCollisionObject* object_ = nullptr;
};

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btTriangleMesh triangles;  // a floor, and a ceiling 30 mm above
  for (const btScalar z : {btScalar(0), btScalar(0.03)}) {
    const btVector3 a(-1, -1, z), b(1, -1, z), c(1, 1, z), d(-1, 1, z);
    triangles.addTriangle(a, b, c);
    triangles.addTriangle(a, c, d);
  }
  btBvhTriangleMeshShape shape(&triangles, true);
  btCollisionObject slot;
  slot.setCollisionShape(&shape);
  world.addCollisionObject(&slot);
  btBoxShape box({1, 1, 1});
  btCompoundShape shapes;
  shapes.addChildShape(btTransform(btQuaternion::getIdentity(), {0, 0, -1}), &box);
  btCollisionObject block;  // 5 m away, where floats tell 0.5 um apart
  block.setCollisionShape(&shapes);
  block.setWorldTransform(btTransform(btQuaternion::getIdentity(), {5, 0, 0}));
  world.addCollisionObject(&block);

  const god::FingerParameters skin{.mu = 0.6, .radius_law = lc::RadiusLaw::constant(0.006)};
  BallFinger finger(god::SoftFinger(lc::Table::build(lc::hertz(), 1e-8), skin), 0.005);
  const auto at = [](double x, double z) {
    return btTransform(btQuaternion::getIdentity(), {btScalar(x), 0, btScalar(z)});
  };
  const auto ratio = [](const god::FingerOutput& out) { return out.force.x() / (0.6 * out.load); };

  god::FingerOutput out;
  for (int i = 0; i < 1000; ++i) out = finger.update(world, at(2e-5 * i, 0.003), 1e-3);
  const double slide = ratio(out);
  for (int i = 0; i < 1000; ++i) {  // now the slot moves along, and faster
    slot.setWorldTransform(at(4e-5 * i, 0));
    world.updateSingleAabb(&slot);
    out = finger.update(world, at(0.02, 0.003), 1e-3);
  }
  const double carried = ratio(out);
  out = finger.update(world, at(0.02, 0.027), 1e-3);  // to the ceiling in one step
  std::printf("F/(mu P): slide %.6f, carried along %.6f, at another wall %.6f; load %.6f N\n", slide, carried,
              ratio(out), out.load);
  const bool lands = out.force.norm() == 0 && std::abs(out.load - 2) < 1e-4;
  out = finger.update(world, at(5, 0.003), 1e-3);
  const bool lands_far = out.force.norm() == 0 && (out.whole_force() - Eigen::Vector3d(0, 0, 2)).norm() < 1e-4;
  for (int i = 0; i < 1000; ++i) out = finger.update(world, at(5 + 2e-5 * i, 0.003), 1e-3);
  std::printf("          on another body %.6f\n", ratio(out));
  return std::abs(slide + 1) < 1e-5 && std::abs(carried - 1) < 1e-5 && lands && lands_far &&
                 std::abs(ratio(out) + 1) < 1e-4
             ? 0
             : 1;
}
