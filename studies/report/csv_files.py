# SPDX-License-Identifier: MIT
"""The CSV files that the report is drawn from. One function for some of them; its docstring has
their columns, where `NAME` stands for those of that subcommand. Units are those of the subcommands:
SI, or unit wrenches."""

import csv
import io
import itertools
import math
import tempfile
from pathlib import Path

from .chart_style import write_whole
from .command import listed, numbers

DATA = Path(__file__).resolve().parents[2] / "data"

CASES = ("coupled", "uncoupled", "exact")
GROWING = "power:c=0.00207,gamma=0.259"
# The finger that the motions in data/ are made for.
FINGER = {"law": "hertz", "radius_law": "constant:a=0.006", "mu": 0.6, "stiffness": 1000, "twist_stiffness": 0.036}
# Dampers as quiet as a hand [N s/m]: on sandpaper the block's turn has a damping ratio of 1, on
# rayon of 1.2. Measured for digits of young adults: mostly above 1 (J. Park, N. Pazin, J. Friedman,
# V. M. Zatsiorsky, M. L. Latash, Clinical Biomechanics 29:129-137, 2014).
HAND = ("--damping", 86)


class CsvFiles:
    """The files in a folder, and the command that they come from."""

    def __init__(self, command, folder):
        self.command, self.folder = command, folder
        # Not that of pads worn in, which no fingertip has: its curve crosses the ellipse.
        self.moment_ratios = {
            row["law"]: float(row["moment_ratio"])
            for row in command.rows("laws")
            if row["law"] != "uniform-wear"
        }

    def write(self, name, rows):
        """NAME.csv; all rows have the keys of the first, in that order."""
        text = io.StringIO()
        writer = csv.DictWriter(text, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        write_whole(self.folder / f"{name}.csv", text.getvalue().encode("utf-8"))

    def gather(self, name, runs):
        """NAME.csv from several runs, each the cells that lead its rows and its arguments. Returns the
        rows of each run."""
        leading, calls = zip(*runs)
        tables = self.command.each(calls)
        self.write(name, [{**cells, **row} for cells, rows in zip(leading, tables) for row in rows])
        return tables


def read(path):
    """Rows of a file in data/, as texts."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def curves(files):
    """laws: `laws`, in the order of colours. curves: law, `curve`, evenly in the angle of the slip.
    validate: `validate`. ellipse_error: law; angle of the wrench in the normalised plane, 0 pure force
    [rad]; over_estimate, radius of the ellipse through the limits over that of the curve, less 1;
    cor_ratio, distance of the centre of rotation by the ellipse over the true one, nan at the ends."""
    files.write("laws", [row for row in files.command.rows("laws") if row["law"] in files.moment_ratios])
    laws = list(files.moment_ratios)
    points = files.gather("curves", [({"law": law}, ["curve", "--law", law, "--points", 181]) for law in laws])
    error = []
    for (law, moment_ratio), rows in zip(files.moment_ratios.items(), points):
        for c, force, moment, x, y in reversed(numbers(rows, "c", "force", "moment", "x", "y")):
            ratio = force / moment * moment_ratio**2 / c if 0 < c < math.inf else math.nan
            error.append({"law": law, "angle": math.atan2(y, x), "over_estimate": 1 / math.hypot(x, y) - 1,
                          "cor_ratio": ratio})
    files.write("ellipse_error", error)
    files.gather("validate", [({}, ["validate", "--law", law]) for law in laws])


def load_curves(files):
    """p_curves, c_curves: law, radius_law, mu, and `p-curves` or `c-curves`, with a radius that grows
    and one that does not, equal at 1.5 N."""
    runs = [({"law": "hertz", "radius_law": radius_law, "mu": 0.6},
             ["--law", "hertz", "--radius-law", radius_law, "--mu", 0.6])
            for radius_law in (f"constant:a={0.00207 * 1.5**0.259!r}", GROWING)]
    fine = listed([0.05 * i for i in range(61)])
    files.gather("p_curves", [(cells, ["p-curves", "--loads", "0.5,1,1.5,2,2.5", *words]) for cells, words in runs])
    cors = "0,0.0005,0.001,0.002,0.004,inf"
    files.gather("c_curves", [(cells, ["c-curves", "--loads", fine, "--cors", cors, *words]) for cells, words in runs])


def tables(files):
    """tables: `table` at tolerances from 1e-2 to 1e-10. materials: material, mu, mu_r, radius =
    mu_r/(mu m0), file, `table`: the tables of Table 1. table_error: law, tolerance, spin_fraction,
    force_error, moment_error: table less exact curve, between the nodes too."""
    with tempfile.TemporaryDirectory() as scratch:
        sizes = [(law, f"1e-{digits}") for law in files.moment_ratios for digits in range(2, 11)]
        files.gather("tables", [({}, ["table", "--law", law, "--tolerance", tolerance, "-o", f"{scratch}/{i}.csv"])
                                for i, (law, tolerance) in enumerate(sizes)])
        spins = [i / 4000 for i in range(4001)]
        places = listed([1 / u - 1 if u else math.inf for u in spins])
        error = []
        for law in ("hertz", "uniform"):
            table = f"{scratch}/{sizes.index((law, '1e-8'))}.csv"
            looked_up, exact = (numbers(files.command.rows(*of, "--c", places), "force", "moment")
                                for of in (("lookup", "--table", table), ("eval", "--law", law)))
            error += [{
                "law": law,
                "tolerance": 1e-8,
                "spin_fraction": u,
                "force_error": f - force,
                "moment_error": m - moment
            } for u, (f, m), (force, moment) in zip(spins, looked_up, exact)]
        files.write("table_error", error)
    runs = []
    for row in read(DATA / "materials.csv"):
        for law in ("hertz", "uniform"):
            name = f"table-{row['material']}-{law}.csv"
            radius = float(row["mu_r"]) / (float(row["mu"]) * files.moment_ratios[law])
            leading = {key: row[key] for key in ("material", "mu", "mu_r")} | {"radius": radius, "file": name}
            runs.append((leading, ["table", "--law", law, "--tolerance", "1e-6", "-o", files.folder / name]))
    files.gather("materials", runs)


def options(finger):
    return [word for name, value in finger.items() for word in (f"--{name.replace('_', '-')}", value)]


def replays(files):
    """replay: trace, boundary, projection, `replay`. replay_run: what these share. replay_limits: boundary,
    load, force, moment: its p-curves."""
    traces = ("press_drag_release", "press_twist_release", "slide_twist_load")
    kinds = [(trace, *kind) for trace in traces for kind in (("ellipse", "radial"), ("table", "closest-point"))]
    files.gather("replay", [({"trace": trace, "boundary": curve, "projection": projection},
                             ["replay", "--trace", DATA / "traces" / f"{trace}.csv", *options(FINGER),
                              "--curve", curve, "--projection", projection]) for trace, curve, projection in kinds])
    moment_ratio = files.moment_ratios["hertz"]
    files.write("replay_run", [FINGER])
    law = {name: FINGER[name] for name in ("law", "radius_law", "mu")}
    exact = numbers(files.command.rows("p-curves", *options(law), "--loads", "0.5,1,1.5,2,3"), "load", "force",
                    "moment")
    largest = {load: (0.6 * load, 0.6 * load * 0.006 * moment_ratio) for load, _, _ in exact}
    quarter = [math.pi / 2 * i / 90 for i in range(91)]
    ellipse = [(load, force * math.sin(t), moment * math.cos(t))
               for load, (force, moment) in largest.items()
               for t in quarter]
    files.write("replay_limits", [{
        "boundary": curve,
        "load": load,
        "force": force,
        "moment": moment
    } for curve, points in (("ellipse", ellipse), ("table", exact)) for load, force, moment in points])


def steady_twist(files):
    """steady_twist: law, boundary, projection, cor, stiffness_ratio, force, moment, exact_force,
    exact_moment, error: the unit wrench at which a finger settles that slides straight on and turns, v/ω = a, against
    k_r/(k_l (m0 a)^2). The error is the norm of the difference, each part over its limit."""
    m0 = files.moment_ratios["hertz"]
    [exact] = numbers(files.command.rows("eval", "--law", "hertz", "--c", 1), "force", "moment")
    kinds = [(curve, projection, 10 ** (i / 40 - 1))
             for curve in ("table", "ellipse") for projection in ("closest-point", "radial") for i in range(81)]
    with tempfile.TemporaryDirectory() as scratch:
        # Load, radius and friction are 1. A step is as long as the springs give: settled to rounding
        # well before the end.
        trace = Path(scratch) / "trace.csv"
        steps = (i / 1000 for i in range(501))
        trace.write_text("time,x,y,z,twist\n" + "".join(f"{x},{x},0,-0.001,{x}\n" for x in steps), encoding="utf-8")
        finger = options({"trace": trace, "law": "hertz", "radius_law": "constant:a=1", "mu": 1, "stiffness": 1000,
                          "tolerance": 1e-8})
        calls = [["replay", *finger, "--twist-stiffness", ratio * 1000 * m0 ** 2, "--curve", curve, "--projection",
                  projection] for curve, projection, ratio in kinds]
        last = files.command.each(calls, lambda run: list(run)[-1])
    rows = []
    for (curve, projection, ratio), (fx, fy, moment) in zip(kinds, numbers(last, "fx", "fy", "moment")):
        settled = math.hypot(fx, fy), abs(moment)
        rows.append({"law": "hertz", "boundary": curve, "projection": projection, "cor": 1, "stiffness_ratio": ratio,
                     "force": settled[0], "moment": settled[1], "exact_force": exact[0], "exact_moment": exact[1],
                     "error": math.hypot(settled[0] - exact[0], (settled[1] - exact[1]) / m0)})
    files.write("steady_twist", rows)


def fits(files):
    """fits: data, model, `fit`. fit_residuals: load, force, moment, sigma_force, sigma_moment, residual of
    the fit to data/fit/slips.csv."""
    slips = DATA / "fit" / "slips.csv"
    robust = ["fit", "law", "--data", slips, "--law", "hertz", "--loss", "cauchy", "--fit-gamma"]
    files.gather("fits", [({"data": "materials", "model": "ratio"}, ["fit", "ratio", "--data", DATA / "materials.csv"]),
                          ({"data": "slips", "model": "law"}, robust),
                          ({"data": "radii", "model": "load"}, ["fit", "load", "--data", DATA / "fit" / "radii.csv"])])
    residuals = files.command.rows(*robust, "--residuals")
    files.write("fit_residuals", [{**slip, **residual} for slip, residual in zip(read(slips), residuals, strict=True)])


def patches(files):
    """patch_pushes: data, share, exact, ellipsoid: of each push in data/measured its share of rotation,
    and its power over that of the patch and of the ellipsoid. patch_fits: data, `fit friction`.
    patch_errors: shape, aspect, `validate --patch`."""
    pushes, fitted = [], []
    for name in ("tripod_hardboard_a", "tripod_plywood_a"):
        file, points = DATA / "measured" / f"{name}.csv", DATA / "measured" / f"{name}_points.csv"
        loads = numbers(read(points), "x", "y", "load")
        total = sum(load for _, _, load in loads)
        centre = [sum(point[i] * point[2] for point in loads) / total for i in (0, 1)]
        m0 = sum(load * math.dist((x, y), centre) for x, y, load in loads) / total
        measured = numbers(read(file), "force_x", "force_y", "moment", "dx", "dy", "dtheta")
        with tempfile.TemporaryDirectory() as scratch:
            twists = Path(scratch) / "twists.csv"
            twists.write_text("vx,vy,omega\n" + "".join(f"{listed(push[3:])}\n" for push in measured), encoding="utf-8")
            powers = numbers(files.command.rows("patch", "--patch", f"points:{points}", "--twists", twists), "power")
        for (fx, fy, moment, dx, dy, turn), [power] in zip(measured, powers, strict=True):
            work, spin = fx * dx + fy * dy + moment * turn, m0 * turn
            ellipsoid = math.hypot(dx - turn * centre[1], dy + turn * centre[0], spin)
            pushes.append({
                "data": name,
                "share": abs(spin) / ellipsoid,
                "exact": work / power,
                "ellipsoid": work / ellipsoid
            })
        for row in files.command.rows("fit", "friction", "--patch", f"points:{points}", "--data", file):
            del row["note"]  # which has a path: the report is the same wherever the data lie
            fitted.append({"data": name, **row})
    files.write("patch_pushes", pushes)
    files.write("patch_fits", fitted)
    files.gather("patch_errors",
                 [({
                     "shape": shape,
                     "aspect": aspect
                 }, ["validate", "--patch", f"{patch}={aspect}"])
                  for aspect in ("1", "1.25", "1.5", "2", "3", "4", "5")
                  for shape, patch in (("hertz ellipse", "ellipse:law=hertz,b=1,a"), ("rectangle", "rectangle:y=1,x"))])


def pivot(files):
    """pivot: case, grip, `pivot`: a grip that eases by itself, without dampers, so that the god-object
    lies on the p-curves (release), and an operator. pivot_stiffness: case, ratio, angle: by how much the
    block turns before it has left the fingers, over k_r/(k_l (mu_r/mu)^2)."""
    release = ["--release", "from=0.5,to=0.25,over=10", "--damping", 0]
    operator = ["--operator", "target=30deg,speed=0.1,rate=0.1", *HAND, "--duration", 15]
    files.gather("pivot", [({
        "case": case,
        "grip": grip
    }, ["pivot", "--case", case, "--material", "sandpaper", "--every", 10, *words])
                           for case in CASES
                           for grip, words in (("release", release), ("operator", operator))])
    [sandpaper] = [row for row in read(DATA / "materials.csv") if row["material"] == "sandpaper"]
    radial_best = 1000 * (float(sandpaper["mu_r"]) / float(sandpaper["mu"])) ** 2
    scan = [(case, 10 ** (0.25 * i)) for case in ("coupled", "exact") for i in range(-4, 9)]
    calls = [["pivot", "--case", case, "--twist-stiffness", ratio * radial_best] for case, ratio in scan]
    turned = files.command.each(calls, lambda rows: max(float(row["angle"]) for row in held(rows)))
    files.write("pivot_stiffness", [{
        "case": case,
        "ratio": ratio,
        "angle": angle
    } for (case, ratio), angle in zip(scan, turned)])


def held(rows):
    """Those until the block has left the fingers."""
    return itertools.takewhile(lambda row: row["state"] != "free", rows)


def others(files):
    """translate: law, radius_law, mu, load, `translate`. engine_drag, work_precision_…:
    data/engines/drag*.csv and data/work_precision/, which were measured once (data/README.md)."""
    contacts = [{"law": law, "radius_law": GROWING, "mu": 0.6, "load": 2} for law in ("hertz", "uniform")]
    files.gather("translate", [(contact, ["translate", *options(contact)]) for contact in contacts])
    measured = [row for name in ("drag_pypi", "drag") for row in read(DATA / "engines" / f"{name}.csv")]
    files.write("engine_drag", [{name: row[name] for name in measured[-1]} for row in measured
                                if row["engine"] in ("mujoco", "bullet", "ode")
                                and row.get("contact", "ball") == "ball"])
    for name in ("wrench", "step", "patch"):
        write_whole(files.folder / f"work_precision_{name}.csv", (DATA / "work_precision" / f"{name}.csv").read_bytes())


PARTS = (curves, load_curves, tables, replays, steady_twist, fits, patches, pivot, others)
