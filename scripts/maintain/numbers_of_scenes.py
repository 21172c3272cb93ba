# SPDX-License-Identifier: MIT
"""Sentences of `check_numbers` about the block between two fingers, contacts that are not round, ratios of friction, and engines."""

import csv
import io
import itertools
import math
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def rows(executable, *arguments):
    done = subprocess.run([executable, *arguments], check=True, capture_output=True, text=True)
    return list(csv.DictReader(io.StringIO(done.stdout)))


def percents(fraction, digits):
    return f"{100 * fraction:.{digits}f} %"


def materials():
    with open(ROOT / "data" / "materials.csv", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def loads_of_materials(executable):
    """What a block between fingers of other materials needs, and what an open grip begins with."""
    needed, begun = [], []
    for material in ("rayon", "suede"):
        run = rows(executable, "pivot", "--case", "coupled", "--material", material)
        needed.append(f"{float(next(row['load'] for row in run if row['state'] == 'slip')):.2f}")
        begun.append(f"{float(run[0]['load']):g}")
    return [("godobject/README.md", f"need {needed[0]} and {needed[1]} N to hold it (coupled), begin with {begun[0]} and {begun[1]} N"),
            ("cli/README.md", f"(rayon {begun[0]} N, suede {begun[1]} N)")]


def operator(executable):
    runs = {case: rows(executable, "pivot", "--case", case, "--operator", "target=30deg") for case in ("coupled", "exact")}
    ends = [f"{math.degrees(float(run[-1]['angle'])):.1f}° ({case})" for case, run in runs.items()]
    slip = 1e3 * float(runs["coupled"][-1]["grip_slip"])
    return [("godobject/README.md", f"stops it at {ends[0]} and {ends[1]}"),
            ("docs/paper.md", f"the grip slips by {slip:.0f} mm over {float(ends[0].split('°')[0]):.0f}°")]


def beside_mujoco(executable):
    """examples/python/README.md: what `pivot` gives beside MuJoCo, under the grip of 8_mujoco_pivot.py."""
    found = []
    with tempfile.TemporaryDirectory() as scratch:
        grip = Path(scratch) / "grip.csv"
        grip.write_text("time,load\n0,0.5\n1,0.5\n8,0.3\n", encoding="utf-8")
        for case, label in (("exact", "exact curve"), ("coupled", "ellipse and radial (the paper's A)")):
            run = rows(executable, "pivot", "--case", case, "--material", "sandpaper", "--grip", str(grip), "--duration", "8")
            begins = next(float(row["time"]) for row in run if abs(math.degrees(float(row["angle"]))) > 1)
            found.append(("examples/python/README.md", f"| `pivot`, {label} | {begins:.2f} s | {math.degrees(float(run[-1]['angle'])):.1f}° | "
                          f"{1e3 * float(run[-1]['grip_slip']):.1f} mm |"))
    return found


def patches(executable):
    """How wrong the ellipsoid and the best disc are on an elliptic Hertz contact."""
    found = [rows(executable, "validate", "--patch", f"ellipse:law=hertz,a=0.005,b={b}") for b in ("0.005", "0.0025", "0.001")]
    ellipsoids, discs = ([f"{100 * float(next(row['max_error'] for row in run if row['model'].startswith(model))):.1f}".replace("0.0", "0")
                          for run in found] for model in ("ellipsoid", "disc:"))
    return [("limitcurve/README.md", f"{ellipsoids[0]}, {ellipsoids[1]} and {ellipsoids[2]} % too strong at a/b = 1, 2 and 5"),
            ("limitcurve/README.md", f"best disc is {discs[0]}, {discs[1]} and {discs[2]} %")]


def one_ratio(executable):
    """What `fit ratio` says of the published ratios, and of others with the same deviations."""
    value = {row["parameter"]: (float(row["value"]), float(row["std_error"]))
             for row in rows(executable, "fit", "ratio", "--data", str(ROOT / "data" / "materials.csv"))}
    mean, error = (1e3 * part for part in value["ratio"])
    deviations = sorted(float(row["ratio_sd"]) / float(row["ratio"]) for row in materials())
    with tempfile.TemporaryDirectory() as scratch:
        other = Path(scratch) / "ratios.csv"
        p_values = []
        for factors in itertools.permutations((0.7, 1, 1.3)):
            lines = [f"{1e-3 * mean * factor},{row['ratio_sd']}" for factor, row in zip(factors, materials())]
            other.write_text("ratio,ratio_sd\n" + "\n".join(lines) + "\n", encoding="utf-8")
            p_values.append(next(float(row["value"]) for row in rows(executable, "fit", "ratio", "--data", str(other)) if row["parameter"] == "p_value"))
    fitted = f"{mean:.2f} ± {error:.2f} mm"
    chi, p = value["chi_squared"][0], value["p_value"][0]
    return [("fit/README.md", f"{fitted}, χ² = {chi:.2f} with two degrees of freedom, p = {p:.2f}"),
            ("fit/README.md", f"({100 * deviations[0]:.0f} to {100 * deviations[-1]:.0f} %)"),
            ("fit/README.md", f"0.7, 1 and 1.3 times the mean either (p = {max(p_values):.2g})"),
            ("docs/paper.md", f"{fitted} for all, χ² = {chi:.2f}, p = {p:.2f}"),
            ("docs/paper.md", "ratios of 0.7 and 1.3 times the mean would pass")]


def engines(executable):
    """docs/which_number.md: what its sentences say beside the tables that scripts/maintain/engines/page.py writes."""
    given = ("--law", "hertz", "--radius-law", "constant:a=0.005", "--mu", "0.8", "--load", "3", "--engine", "mujoco")
    torsional = next(float(row["value"]) for row in rows(executable, "translate", *given) if row["formula"] == "mu_r")
    default = 0.005  # of a geom in MuJoCo
    radius = float(rows(executable, "translate", "--law", "hertz", "--mu", "1", "--read", f"mujoco.torsional={default}")[0]["radius"])
    ratio = {law: float(rows(executable, "eval", "--law", law, "--c", "0")[0]["moment"]) for law in ("hertz", "uniform")}
    return [("docs/which_number.md", f"{ratio['hertz']:.3f} for Hertz and {ratio['uniform']:.3f} for a uniform pressure"),
            ("docs/which_number.md", f"A plane has {default} by default, and gives this fingertip {1e3 * default * 3:g} mN m at 3 N in place of {1e3 * torsional * 3:.2f}"),
            ("docs/which_number.md", f"its moment is {1 / ratio['uniform']:.1f} times a uniform disc's"),
            ("docs/which_number.md", f"MuJoCo's default is a fingertip of {1e3 * radius:.1f} mm under μ = 1")]


def sentences(executable):
    makers = (loads_of_materials, operator, beside_mujoco, patches, one_ratio, engines)
    return [sentence for make in makers for sentence in make(executable)]
