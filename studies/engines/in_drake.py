# SPDX-License-Identifier: MIT
"""Drake: hydroelastic contact, a field of pressure over a patch; and its point contact, which has no friction moment.

The field of a compliant ball on a rigid plane is parabolic, that of a rigid disc on a compliant half space uniform:
these are the exact curves they are compared with, as well as Hertz's. Radii are the geometry's: nothing is typed but
mu, the modulus and the mesh's size.
"""

import importlib.metadata
import math

import drag
import hold
from pydrake.geometry import (AddCompliantHydroelasticProperties, AddCompliantHydroelasticPropertiesForHalfSpace,
                              AddContactMaterial, AddRigidHydroelasticProperties, Box, Cylinder, HalfSpace,
                              ProximityProperties, Sphere)
from pydrake.math import RigidTransform
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, ContactModel, CoulombFriction
from pydrake.multibody.tree import FixedOffsetFrame, PlanarJoint, PrismaticJoint, SpatialInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

BALL, DEPTH = 0.02, 0.0006  # [m]: a patch of about 5 mm


def measure():
    version = importlib.metadata.version("drake")
    patch = math.sqrt(DEPTH * (2 * BALL - DEPTH))
    yield from drag.measure("drake", version, "ball", "point", lambda v, w: one("point", v, w), "hertz")
    for law in ("hertz", "parabolic"):
        yield from drag.measure("drake", version, "field", "field", lambda v, w: one("ball", v, w), law, patch)
    yield from drag.measure("drake", version, "field", "field", lambda v, w: one("disc", v, w), "uniform",
                            drag.DISC_RADIUS)


def one(contact, slide, spin):
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=0.0)  # continuous: friction of this very velocity
    plant.set_contact_model(ContactModel.kPoint if contact == "point" else ContactModel.kHydroelastic)
    plant.set_stiction_tolerance(1e-6)
    ground, finger = ProximityProperties(), ProximityProperties()
    for properties in (ground, finger):
        AddContactMaterial(properties=properties,
                           dissipation=0.0,
                           point_stiffness=1e4,
                           friction=CoulombFriction(drag.MU, drag.MU))
    if contact == "disc":
        shape, height = Cylinder(drag.DISC_RADIUS, 0.01), 0.005
        AddCompliantHydroelasticPropertiesForHalfSpace(0.01, 1e6, ground)
        AddRigidHydroelasticProperties(drag.DISC_RADIUS / 20, finger)
    else:
        shape, height = Sphere(BALL), BALL
        AddRigidHydroelasticProperties(ground)
        AddCompliantHydroelasticProperties(BALL / 20, 1e6, finger)
    plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "ground", ground)
    carriage = plant.AddRigidBody("carriage", SpatialInertia.SolidSphereWithMass(1.0, 0.1))
    body = plant.AddRigidBody("finger", SpatialInertia.SolidSphereWithMass(1.0, 0.1))
    plant.RegisterCollisionGeometry(body, RigidTransform(), shape, "finger", finger)
    planar = plant.AddJoint(PlanarJoint("drag", plant.world_frame(), carriage.body_frame()))
    press = plant.AddJoint(PrismaticJoint("press", carriage.body_frame(), body.body_frame(), [0, 0, 1]))
    plant.Finalize()
    diagram = builder.Build()
    context = diagram.CreateDefaultContext()
    state = plant.GetMyMutableContextFromRoot(context)
    press.set_translation(state, height - DEPTH)
    planar.set_translational_velocity(state, [slide, 0])
    planar.set_angular_velocity(state, spin)
    results = plant.get_contact_results_output_port().Eval(state)
    if contact == "point":
        force = results.point_pair_contact_info(0).contact_force()
        return force[0], 0.0, abs(force[2])
    info = results.hydroelastic_contact_info(0)
    force, moment = info.F_Ac_W().translational(), info.F_Ac_W().rotational()
    place = info.contact_surface().centroid()
    return force[0], moment[2] + place[0] * force[1] - place[1] * force[0], abs(force[2])


def held():
    yield "drake", importlib.metadata.version("drake"), "ball, hydroelastic, a = 10 mm", ("--law", "parabolic",
                                                                                          "--radius-law",
                                                                                          "constant:a=0.01"), gripped, 1


def gripped(offset):
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=1e-3)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
    hard, soft = ProximityProperties(), ProximityProperties()
    for properties in (hard, soft):
        AddContactMaterial(properties=properties, dissipation=1.0, friction=CoulombFriction(hold.MU, hold.MU))
    a = 0.01
    depth = a * a / (2 * BALL)  # where the grip is that of the pressure modulus depth/BALL (1 - (r/a)^2)
    AddRigidHydroelasticProperties(hard)
    AddCompliantHydroelasticProperties(BALL / 10, 2 * hold.GRIP * BALL / (math.pi * a * a * depth), soft)
    sides = [2 * half for half in hold.HALF]
    body = plant.AddRigidBody("body", SpatialInertia.SolidBoxWithMass(hold.MASS, *sides))
    plant.RegisterCollisionGeometry(body, RigidTransform(), Box(*sides), "body", hard)
    plant.SetDefaultFloatingBaseBodyPose(body, RigidTransform([-offset, 0, 0]))
    for way in (-1, 1):
        pad = plant.AddRigidBody(f"pad{way}", SpatialInertia.SolidSphereWithMass(hold.PAD_MASS, BALL))
        plant.RegisterCollisionGeometry(pad, RigidTransform(), Sphere(BALL), "ball", soft)
        place = plant.AddFrame(
            FixedOffsetFrame(f"at{way}", plant.world_frame(), RigidTransform([0, 0, -way * (hold.HALF[2] + BALL)])))
        plant.AddJoint(PrismaticJoint(f"slide{way}", place, pad.body_frame(), [0, 0, way], damping=hold.SLOWED))
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    state = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    force = [hold.GRIP] * plant.num_velocities()
    free = body.floating_velocities_start_in_v()

    def step(weight):
        force[free:free + 6] = 0, 0, 0, 0, -weight, 0
        plant.get_applied_generalized_force_input_port().FixValue(state, force)
        simulator.AdvanceTo(simulator.get_context().get_time() + 1e-3)
        pose = plant.EvalBodyPoseInWorld(state, body)
        turn = pose.rotation().matrix()
        return math.atan2(turn[1, 0], turn[0, 0]), pose.translation()[1]

    return step
