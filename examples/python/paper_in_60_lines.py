# SPDX-License-Identifier: MIT
"""The paper in 60 lines: eqs. (3), (5) and (7) to (23) for a finger on a plane, without the library. The end compares
them with `limitcurve replay`, to 1e-12."""

import csv
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from math import atan2, copysign, cos, hypot, pi, sin, sqrt
from pathlib import Path

Pose = tuple[float, float, float]  # x, y [m], angle [rad]
Sample = tuple[float, float, float, float, Pose]  # x_h, y_h, z_h, alpha_s of the device; the object

MU, K_L, K_R, A = 0.6, 1000.0, 0.036, 0.006  # mu_s = mu_d; springs [N/m], [N m/rad]; radius of the contact [m]
MU_R = MU * 3 * pi / 16 * A  # eq. (5), Hertz; eq. (18): F_fr = MU P, M_fr = MU_R P


def pressure(r: float) -> float:  # for P = 1, eq. (3)
    return 1.5 * sqrt(1 - (r / A) ** 2) / (pi * A**2)


def wrench(c: float, n: int = 400) -> tuple[float, float]:  # F_t, M for P = 1, turning by +1 about (c, 0); to 1e-4
    force = moment = 0.0
    for r in (A * (i + 0.5) / n for i in range(n)):
        for t in (2 * pi * (j + 0.5) / n for j in range(n)):
            distance = sqrt(r * r + c * c - 2 * c * r * cos(t))  # from the COR: eqs. (15), (16)
            traction = MU * pressure(r) / distance * (A / n) * (2 * pi / n)
            force -= traction * (r * cos(t) - c) * r  # eq. (17)
            moment -= traction * (r - c * cos(t)) * r * r
    return force, moment


def uncoupled(deflection: Pose, d: float) -> Pose:  # step b; x_p(k-1) - x_g(k), alpha_p(k-1) - alpha_g(k)
    x, y, alpha = deflection
    r, rho = hypot(x, y), abs(alpha)  # eq. (7)
    if r / (MU * d) >= 1:  # eq. (8): it slides
        x, y = x / r * MU * d, y / r * MU * d  # eqs. (10), (11)
    if K_R * rho / (K_L * MU_R * d) >= 1:  # eq. (9)
        alpha = copysign(K_L / K_R * MU_R * d, alpha)  # eqs. (10), (12)
    return x, y, alpha


def coupled(deflection: Pose, d: float) -> Pose:  # step b'
    x, y, alpha = deflection
    epsilon = (hypot(x, y) / (MU * d)) ** 2 + (K_R * abs(alpha) / (MU_R * K_L * d)) ** 2  # eqs. (19) to (21)
    keep = 1 if epsilon <= 1 else 1 / sqrt(epsilon)  # eq. (22), or r'/r = rho'/rho
    return x * keep, y * keep, alpha * keep  # eq. (23)


def god_object(samples: Iterable[Sample], step_b: Callable[[Pose, float], Pose]) -> Iterator[Pose]:
    pose, proxy = (0.0, 0.0, 0.0), None
    for x_h, y_h, z_h, alpha_s, body in samples:
        if proxy:  # steps d, e: x_c, alpha_c of eq. (14) are those of the material below; eq. (13), but with its sign
            turn, x, y = body[2] - pose[2], proxy[0] - pose[0], proxy[1] - pose[1]
            proxy = body[0] + x * cos(turn) - y * sin(turn), body[1] + x * sin(turn) + y * cos(turn), proxy[2] + turn
        pose, goal, d = body, (x_h, y_h, alpha_s), -z_h  # step a, on the plane z = 0; printed: alpha_s - alpha_0
        kept = 0.0, 0.0, 0.0
        if d > 0:
            x, y, alpha = proxy or goal  # or: touch-down
            kept = step_b((x - x_h, y - y_h, alpha - alpha_s), d)
        proxy = (goal[0] + kept[0], goal[1] + kept[1], goal[2] + kept[2]) if d > 0 else None
        yield K_L * kept[0], K_L * kept[1], K_R * kept[2]  # step c


def read(trace: Path) -> Iterator[Sample]:
    for row in csv.DictReader(line for line in trace.read_text().splitlines() if line[0] != "#"):
        bx, by, sine, cosine = (float(row.get(name, 0)) for name in ("bx", "by", "bqz", "bqw"))
        yield float(row["x"]), float(row["y"]), float(row["z"]), float(row["twist"]), (bx, by, 2 * atan2(sine, cosine))


def library(trace: Path, options: str) -> Iterator[dict[str, str]]:
    finger = f"--law hertz --radius-law constant:a={A} --mu {MU} --stiffness {K_L} --twist-stiffness {K_R} {options}"
    call = [sys.argv[1] if len(sys.argv) > 1 else "limitcurve", "replay", "--trace", str(trace), *finger.split()]
    yield from csv.DictReader(subprocess.run(call, check=True, capture_output=True, text=True).stdout.splitlines())


if __name__ == "__main__":
    data = Path(__file__).resolve().parents[2] / "data"
    for step_b, curve in ((uncoupled, "--curve box"), (coupled, "--curve ellipse --projection radial")):
        for trace, more in (("traces/slide_twist_load.csv", ""), ("scenes/turntable.csv", " --body trace")):
            pairs = list(zip(god_object(read(data / trace), step_b), library(data / trace, curve + more)))
            off = max(abs(a - float(row[name])) for here, row in pairs for a, name in zip(here, ("fx", "fy", "moment")))
            print(f"{step_b.__name__}, {trace}: {len(pairs)} samples, largest difference {off:.1g}")
            assert len(pairs) > 1000 and off < 1e-12
