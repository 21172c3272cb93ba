# SPDX-License-Identifier: MIT
"""PhysX 5, by SAPIEN, which is what Isaac Sim has underneath too."""

import sapien

import drag


def measure():
    physx = sapien.physx.version().split("physx-")[-1].removesuffix(".patch0")
    version = f"{physx} by SAPIEN {sapien.__version__}"
    given = drag.translated("physx")
    for contact, model in (("ball", "box"), ("disc", "points")):
        yield from drag.measure("physx",
                                version,
                                contact,
                                model,
                                lambda v, w, contact=contact: one(given, contact, v, w))


def one(given, contact, slide, spin):
    sapien.physx.set_scene_config(gravity=[0, 0, -drag.GRAVITY])
    scene = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    scene.set_timestep(drag.DT)
    material = sapien.physx.PhysxMaterial(given["PxMaterial.staticFriction"], given["PxMaterial.dynamicFriction"], 0.0)
    ground = sapien.Entity()
    floor = sapien.physx.PhysxRigidStaticComponent()
    floor.attach(sapien.physx.PhysxCollisionShapeBox([1, 1, 0.1], material))
    ground.add_component(floor)
    ground.set_pose(sapien.Pose([0, 0, -0.1]))
    scene.add_entity(ground)

    body = sapien.physx.PhysxRigidDynamicComponent()
    if contact == "ball":
        shape = sapien.physx.PhysxCollisionShapeSphere(drag.BALL_RADIUS, material)
        shape.set_min_patch_radius(given["PxShape.minTorsionalPatchRadius"])
        shape.set_patch_radius(given["PxShape.torsionalPatchRadius"])
        height = drag.BALL_RADIUS
    else:
        shape = sapien.physx.PhysxCollisionShapeCylinder(drag.DISC_RADIUS, drag.DISC_HEIGHT / 2, material)
        shape.set_local_pose(sapien.Pose(q=[0.5**0.5, 0, 0.5**0.5, 0]))
        height = drag.DISC_HEIGHT / 2
    body.attach(shape)
    body.set_mass(drag.MASS)
    body.set_inertia([drag.INERTIA] * 3)
    body.set_angular_damping(0)
    body.set_linear_damping(0)
    body.set_max_angular_velocity(1e4)
    body.set_solver_position_iterations(50)
    body.set_solver_velocity_iterations(10)
    body.set_sleep_threshold(0)
    finger = sapien.Entity()
    finger.add_component(body)
    finger.set_pose(sapien.Pose([0, 0, height]))
    scene.add_entity(finger)

    def set_motion(v, w):
        # Where it started, so that edges stay where they are.
        z = finger.get_pose().p[2]
        finger.set_pose(sapien.Pose([0, 0, z]))
        body.set_linear_velocity([v, 0, body.get_linear_velocity()[2]])
        body.set_angular_velocity([0, 0, w])

    def motion():
        v, w = body.get_linear_velocity(), body.get_angular_velocity()
        return float(v[0]), float(v[2]), float(w[2])

    return drag.drag_free_body(set_motion, scene.step, motion, slide, spin)
