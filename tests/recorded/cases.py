# SPDX-License-Identifier: MIT
"""The cases that scripts/maintain/record runs (tests/README.md)."""

PAIRS = [(curve, projection) for curve in ("exact", "table", "ellipse")
         for projection in ("radial", "c-curve", "closest-point")] + [("box", "closest-point")]
LAWS = ["hertz", "uniform", "parabolic", "flat-punch", "cone", "power:n=2.3", "power:n=-0.25", "xydas-kao:k=3", "gaussian:sigma=0.4",
        "mix:0.7*hertz+0.3*uniform"]
FINGER = {"--law": "hertz", "--radius-law": "constant:a=0.006", "--mu": "0.6", "--stiffness": "1000", "--twist-stiffness": "0.036",
          "--tolerance": "1e-11"}
# What else a finger may be. Each meets every curve and every projection.
PARAMETERS = {
    "dampers": {"--damping": "2", "--twist-damping": "1e-4", "--details": None},
    "power-radius": {"--radius-law": "power:c=0.005,gamma=0.259"},
    "hertz-radius": {"--radius-law": "hertz:R=0.008,E=2e5", "--details": None},
    "damped-power-radius": {"--radius-law": "power:c=0.005,gamma=0.259", "--damping": "2", "--twist-damping": "1e-4"},
    "dynamic": {"--mu-dynamic": "0.45", "--details": None},
    "dynamic-power-radius": {"--mu-dynamic": "0.45", "--radius-law": "power:c=0.005,gamma=0.259"},
    "moment-coefficient": {"--mu-r": "0.003", "--mu-r-dynamic": "0.002"},
    "no-moment": {"--mu-r": "0", "--details": None},
    "stiff-twist": {"--twist-stiffness": "0.9"},
    "soft-twist": {"--twist-stiffness": "0.002"},
}
PINCH = {"--fingers": "2", "--damping": "2", "--mu": "0.02"}
SCENES = {
    "sphere": ("around_a_ball", {"--surface": "sphere:radius=0.05"}),
    "ball-mesh": ("around_a_ball", {"--surface": "mesh:data/meshes/ball.obj"}),
    "capsule": ("around_a_ball", {"--surface": "capsule:radius=0.045,length=0.01", "--details": None}),
    "turntable": ("turntable", {"--body": "trace"}),
    "turntable-details": ("turntable", {"--body": "trace", "--damping": "1", "--details": None}),
    "pinch-box": ("pinch", {**PINCH, "--surface": "box:x=0.12,y=0.04,z=0.04", "--body": "free:mass=0.1"}),
    "pinch-planar": ("pinch", {**PINCH, "--surface": "box:x=0.12,y=0.04,z=0.04", "--body": "planar:mass=0.1", "--twist-damping": "1e-4"}),
    "pinch-cylinder": ("pinch", {**PINCH, "--surface": "cylinder:radius=0.02,length=0.04", "--body": "free:mass=0.1,inertia=1e-4",
                                 "--radius-law": "power:c=0.004,gamma=0.259", "--details": None}),
    "pinch-mesh": ("pinch", {**PINCH, "--surface": "mesh:data/meshes/block.obj", "--body": "free:mass=0.1,inertia=1e-4",
                             "--mu-dynamic": "0.015"}),
    "pinch-plane-fixed": ("pinch", {"--fingers": "2", "--surface": "sphere:radius=0.02"}),
}
PIVOTS = {
    "release": {"--release": "from=1,to=0.2,over=4"},
    "operator": {"--operator": "target=30deg"},
    "dynamic": {"--mu-dynamic": "0.5", "--material": "suede"},
    "uniform": {"--law": "uniform", "--material": "rayon", "--operator": "target=20deg"},
}
# Of many contacts, and of what has no subcommand: tests/recorded/recorder.cpp says what the words mean.
BATCH_PARAMETERS = ["dynamic", "power-radius", "no-moment"]
FINGER_SCENARIOS = [("preview", "plain"), ("preview", "damped"), ("restore", "plain"), ("restore", "damped"), ("leaps", "small-leaps"),
                    ("faults", "soft-hold"), ("turns", "plain"), ("irregular", "damped")]
# Of every curve and of every projection at least one.
SOME_PAIRS = [("table", "closest-point"), ("table", "radial"), ("exact", "c-curve"), ("ellipse", "radial"), ("box", "closest-point")]


def words(options):
    return [word for name, value in options.items() for word in ([name] if value is None else [name, value])]


def all_cases():
    """Name, arguments and number of recorded rows (evenly spaced) of every case."""
    for curve, projection in PAIRS:
        pair = {"--curve": curve, "--projection": projection}
        replay = lambda trace, options: ["replay", "--trace", f"data/{trace}.csv", *words({**FINGER, **options, **pair})]
        for trace in ("press_drag_release", "press_twist_release", "slide_twist_load", "constant_twist"):
            yield f"plane/{trace}/{curve}/{projection}", replay(f"traces/{trace}", {}), 15
        for name, options in PARAMETERS.items():
            yield f"parameters/{name}/{curve}/{projection}", replay("traces/slide_twist_load", options), 7
        for name, (scene, options) in SCENES.items():
            # Every pair on every motion, and some on what else is touched.
            if name in ("sphere", "turntable", "pinch-box") or (curve, projection) in SOME_PAIRS:
                yield f"scenes/{name}/{curve}/{projection}", replay(f"scenes/{scene}", options), 4 if scene == "pinch" else 6
        yield f"library/double/plain/{curve}/{projection}", ["recorder", "double", "plain", curve, projection], 16
        yield f"library/float/plain/{curve}/{projection}", ["recorder", "float", "plain", curve, projection], 16
    for curve, projection in SOME_PAIRS:
        for name in BATCH_PARAMETERS:
            for real in ("double", "float"):
                yield f"library/{real}/{name}/{curve}/{projection}", ["recorder", real, name, curve, projection], 16
        for scenario, name in FINGER_SCENARIOS:
            yield f"library/{scenario}/{name}/{curve}/{projection}", ["recorder", scenario, name, curve, projection], 16
    for law in LAWS[1:]:
        for curve, projection in PAIRS:
            if (curve, projection) not in SOME_PAIRS or curve == "box":
                continue
            options = {**FINGER, "--law": law, "--curve": curve, "--projection": projection}
            yield f"laws/{law}/{curve}/{projection}", ["replay", "--trace", "data/traces/constant_twist.csv", *words(options)], 10
    for name, options in PIVOTS.items():
        for model in ("coupled", "uncoupled", "exact"):
            yield f"pivot/{name}/{model}", ["pivot", "--case", model, "--tolerance", "1e-11", *words(options)], 25
    for law in LAWS:
        yield f"curves/eval/{law}", ["eval", "--law", law, "--c", "0,1e-9,0.001,0.2,0.7,0.999999,1,1.000001,1.5,10,1e6,inf"], 1000
        yield f"curves/scaled/{law}", ["eval", "--law", law, "--c", "0,0.002,0.006,0.02", "--radius", "0.006", "--load", "3", "--mu", "0.6"], 1000
        yield f"curves/curve/{law}", ["curve", "--law", law, "--points", "9"], 1000
        yield f"curves/validate/{law}", ["validate", "--law", law], 1000
    yield "curves/translate/hertz", ["translate", "--law", "hertz", "--radius-law", "power:c=0.005,gamma=0.259", "--mu", "0.6", "--load", "3"], 1000
