# SPDX-License-Identifier: MIT
"""data/engines/engines.csv: what each engine measured has, from the points in drag.csv and drag_pypi.csv. (read.csv, by hand, has what was only read.)"""

import csv
import sys

import drag

FIELDS = ["engine", "version", "package", "contact", "model", "parameter", "unit", "law", "max_error", "cor_error", "how", "ignores", "link"]
BALL_POINT = "friction moment: none at a contact point"
RIM = "pressure between the points: they stand at the rim, so the moment is 1.5 times the uniform disc's"
MUJOCO = "https://mujoco.readthedocs.io/en/stable/computation/index.html#friction-cones"
PHYSX = "https://nvidia-omniverse.github.io/PhysX/physx/5.6.1/_api_build/structPxFrictionType.html"

# engine, package, contact, model, parameter, unit, what it ignores, link
MEASURED = [
    ("mujoco", "PyPI mujoco", "ball", "ellipse", "geom.condim = 4; geom.friction[0]; geom.friction[1]; option.impratio; option.cone = elliptic", "1; 1; m; 1; 1",
     "pressure law, load's radius; creeps unless noslip_iterations > 0", MUJOCO),
    ("mujoco", "PyPI mujoco", "ball", "diamond", "geom.condim = 4; geom.friction[0]; geom.friction[1]", "1; 1; m", "pressure law, load's radius; default cone, creeps", MUJOCO),
    ("mujoco", "PyPI mujoco", "disc", "points", "geom.friction[0]", "1", RIM, MUJOCO),
    ("bullet", "PyPI pybullet", "ball", "box", "lateralFriction; spinningFriction; rollingFriction (any > 0)", "1; m; m", "coupling of force and moment, load's radius",
     "https://github.com/bulletphysics/bullet3/blob/master/src/BulletCollision/CollisionDispatch/btManifoldResult.cpp"),
    ("physx", "PyPI sapien", "ball", "box", "PxMaterial.staticFriction; PxMaterial.dynamicFriction; PxShape.minTorsionalPatchRadius; PxShape.torsionalPatchRadius = 0",
     "1; 1; m; m", "coupling of force and moment", PHYSX),
    ("physx", "PyPI sapien", "disc", "points", "PxMaterial.dynamicFriction", "1", RIM, PHYSX),
    ("dart", "PyPI dartpy", "ball", "point", "DynamicsAspect.setFrictionCoeff", "1", BALL_POINT, "https://github.com/dartsim/dart/blob/00fa17117aaf0ceefeadb11d64c6bc3aae80fdd8/dart/constraint/ContactConstraint.cpp"),
    ("drake", "PyPI drake", "ball", "point", "CoulombFriction", "1", BALL_POINT, "https://drake.mit.edu/doxygen_cxx/group__friction__model.html"),
    ("drake", "PyPI drake", "field", "field", "CoulombFriction; hydroelastic_modulus; resolution_hint", "1; Pa; m",
     "nothing: a field of pressure, off by its mesh; its radius is the geometry's (for a ball sqrt(2 R d), Hertz has sqrt(R d)), its law parabolic on a ball, uniform under a flat",
     "https://drake.mit.edu/doxygen_cxx/group__hydroelastic__user__guide.html"),
    ("newton-xpbd", "PyPI newton", "ball", "box", "ShapeConfig.mu; ShapeConfig.mu_torsional", "1; m", "coupling of force and moment, load's radius",
     "https://github.com/newton-physics/newton/blob/main/newton/_src/solvers/xpbd/kernels.py"),
    ("ode", "Debian libode-dev", "ball", "box", "surface.mu; surface.mu2; surface.rhoN", "1; 1; m", "coupling of force and moment, load's radius",
     "http://ode-wiki.org/wiki/index.php?title=Manual:_Joint_Types_and_Functions"),
]
points = []
for path in sys.argv[1:]:
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            # engine_drag's file has no last columns: its finger is the ball of Hertz.
            points.append(row | {"law": row.get("law") or "hertz", "contact": row.get("contact") or "ball"})


def found(engine, contact, model):
    """Points by version and law."""
    chosen = [r for r in points if (r["engine"], r["contact"], r["model"]) == (engine, contact, model)]
    # Debian's MuJoCo and Bullet are older: PyPI's stand last.
    last = chosen[-1]["version"]
    by_law = {}
    for row in chosen:
        if row["version"] == last:
            by_law.setdefault(row["law"], []).append(row)
    return last, by_law


writer = csv.DictWriter(sys.stdout, FIELDS, lineterminator="\n")
print("# Made by scripts/maintain/measure_engines. max_error: of the limit curve's radius; cor_error: of the wrench at the same centre of rotation, over the limits.")
writer.writeheader()
for engine, package, contact, model, parameter, unit, ignores, link in MEASURED:
    version, by_law = found(engine, contact, model)
    for law, rows in by_law.items():
        radial, apart = drag.errors(rows)
        writer.writerow(dict(zip(FIELDS, (engine, version, package, contact, model, parameter, unit, law, f"{radial:.3f}", f"{apart:.3f}", "measured", ignores, link))))
