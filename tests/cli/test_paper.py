# SPDX-License-Identifier: MIT
"""The corrections to the paper: results of its equations as printed, written out here, compared with what the command
gives."""

import importlib.util
import math
import subprocess
import sys
import unittest
from pathlib import Path

from command_line import DATA, EXECUTABLE, FINGER, MEASURED, CommandLineTest, data, rows

ROOT = Path(__file__).resolve().parents[2]
SIXTY_LINES = ROOT / "examples" / "python" / "paper_in_60_lines.py"
MU, MU_R = 1.67, 0.01011  # sandpaper


def replayed(name, *options):
    """A motion of data/ replayed by the finger."""
    return rows("replay", "--trace", DATA / name, *FINGER, *options)


def printed_equation_8(samples, mu_static, mu_dynamic):
    """Eqs. (7) to (11) as printed, with the static limit in every step: F/P of every sample in contact."""
    stiffness, proxy, ratios = 1000.0, None, []
    for sample in samples:
        depth = -sample["z"]
        if depth <= 0:
            proxy = None
            continue
        goal = (sample["x"], sample["y"])
        proxy = proxy or goal
        r = math.dist(goal, proxy)
        if r / (mu_static * depth) >= 1:
            proxy = tuple(g + (p - g) / r * mu_dynamic * depth for p, g in zip(proxy, goal))
        ratios.append(stiffness * math.dist(goal, proxy) / (stiffness * depth))
    return ratios


def regripped_block(carried):
    """A model of the block of `pivot`, regripped under 1 N at 30 degrees while it turns at 0.3 rad/s, about the grip
    alone: how far it has turned after 3 s [deg]. `carried` is by how much step e carries the proxy's angle with a
    velocity: eq. (13) or its correction."""
    mass, offset, time_step = 0.1, 0.005, 1e-3
    inertia = mass * (0.12**2 + 0.04**2) / 12 + mass * offset**2
    twist_stiffness = 1000 * (MU_R / MU) ** 2
    damping = 5 * twist_stiffness / 1000
    angle, velocity, proxy = math.radians(30), 0.3, 0.0  # the proxy's from the finger's
    for _ in range(3000):
        limit = MU_R * 1.0 / twist_stiffness
        proxy = max(-limit, min(limit, proxy))
        moment = mass * 9.81 * offset * math.cos(angle) - 2 * twist_stiffness * proxy - 2 * damping * velocity
        velocity += moment / inertia * time_step
        angle += velocity * time_step
        proxy += carried(velocity) * time_step
    return math.degrees(angle) - 30


def hertz(rho):
    return 1.5 * math.sqrt(1 - rho * rho) / math.pi


def uniform(rho):
    return 1 / math.pi


def hertz_radius(load):
    """a(P) of a ball of 8 mm, E* = 0.2 MPa [m]."""
    return (3 * load * 0.008 / (4 * 2e5)) ** (1 / 3)


def printed_equation_17(c, radius=1.0, pressure=hertz, n=300):
    """F_t and M of eq. (17), sign by sign, for mu P = 1 and a pressure on the disc of radius 1, by
    midpoints of theta and of r = a sin(phi)."""
    force = moment = 0.0
    for phi in (math.pi / 2 * (i + 0.5) / n for i in range(n)):
        rho, weight = math.sin(phi), math.cos(phi) * math.pi / 2 / n * 2 * math.pi / n
        r, traction = radius * rho, pressure(rho) / radius**2 * radius * weight
        for cosine in (math.cos(2 * math.pi * (j + 0.5) / n) for j in range(n)):
            root = math.sqrt(r * r + c * c - 2 * c * r * cosine)
            force += -traction * (r * cosine - c) * r / root
            moment += -traction * (r - c * cosine) * r * r / root
    return force, moment


def friction_on_a_finger(c, n=400):
    """Force, moment and power of friction on a Hertz finger of radius 1 that turns by +1 about
    C = (c, 0), Fig. 2, for mu P = 1: the traction -mu p v/|v| over squares of the pad."""
    force_x = force_y = moment = power = 0.0
    middles = [(2 * i + 1) / n - 1 for i in range(n)]
    for x in middles:
        for y in (y for y in middles if x * x + y * y < 1):
            load = hertz(math.hypot(x, y)) * (2 / n) ** 2
            vx, vy = -y, x - c
            speed = math.hypot(vx, vy)
            tx, ty = -load * vx / speed, -load * vy / speed
            force_x, force_y, moment, power = force_x + tx, force_y + ty, moment + x * ty - y * tx, power - load * speed
    return force_x, force_y, moment, power


class Corrections(CommandLineTest):
    """What docs/paper.md says of the equations as printed. Each is evaluated here by a sum of its own."""

    def test_equation_8_chatters_where_dynamic_friction_is_less(self):
        trace = "traces/slide_twist_load.csv"
        printed, both_alike = (printed_equation_8(data(trace), 0.6, dynamic) for dynamic in (0.3, 0.6))
        here, alike = ([math.hypot(row["fx"], row["fy"]) / row["load"]
                        for row in replayed(trace, "--curve", "box", *dynamic)
                        if row["load"] > 0] for dynamic in (("--mu-dynamic", "0.3"), ()))
        self.assertAlmostEqual(sum(printed) / len(printed), 0.319, delta=5e-4)
        self.assertLess(sum(here) / len(here), 0.23)
        for one, other in zip(both_alike, alike, strict=True):
            self.assertAlmostEqual(one, other, delta=1e-9)

    def test_angles_at_touch_down_preload_nothing(self):
        for alpha_0 in (0, 0.3):
            samples = [(i / 1000, min(i, 20) * 1e-4, alpha_0 + max(0, i - 50) * 1e-3) for i in range(-2, 100)]
            found = replayed(self.trace((time, 0, 0, -depth, alpha_s) for time, depth, alpha_s in samples))
            for row, (_, depth, alpha_s) in zip(found, samples, strict=True):
                # As printed alpha_p = alpha_0 at touch-down and alpha_g = alpha_s - alpha_0.
                printed = 0.036 * (alpha_0 - (alpha_s - alpha_0)) if depth > 0 else 0
                self.assertAlmostEqual(printed - row["moment"],
                                       0.036 * 0.3 if alpha_0 and depth > 0 else 0,
                                       delta=1e-15)

    def test_signs_of_equation_17(self):
        # The printed pair is that on the finger: F opposes v_y = -c, M opposes omega = 1, and they have
        # the power of friction.
        radius, load = 0.006, 2
        for c in (0.5, 1, 2):
            force, moment = printed_equation_17(c)
            *summed, power = friction_on_a_finger(c)
            for one, other in zip((0, force, moment, -c * force + moment), (*summed, power)):
                self.assertAlmostEqual(one, other, delta=1e-3)
            # `eval` tells magnitudes, `patch` what moves the patch: the opposite of friction.
            here = rows("eval", "--law", "hertz", "--c", c)[0]
            twist = self.csv("twist.csv", "vx,vy,omega", [(0, -c, 1)])
            patch = rows("patch", "--quiet", "--patch", "ellipse:law=hertz,a=1,b=1", "--twists", twist)[0]
            # A finger moved so settles at it, on its user.
            path = self.trace((i / 1000, 0, -c * radius * 0.02 * i, -load / 1000, 0.02 * i) for i in range(300))
            settled = replayed(path, "--projection", "closest-point")[-1]
            limit = 0.6 * load
            for found in ((here["force"], -here["moment"]), (-patch["fy"], -patch["moment"]),
                          (settled["fy"] / limit, settled["moment"] / (limit * radius))):
                for one, other in zip(found, (force, moment)):
                    self.assertAlmostEqual(one, other, delta=1e-4)
        self.assertEqual([round(value, 4) for value in printed_equation_17(1)], [0.8836, -0.2209])

    def test_quotients_that_are_0_by_0(self):
        # A pure twist has r = 0, a pure drag rho = 0: r'/r of eq. (23) is none.
        twist, drag = (replayed(f"traces/press_{motion}_release.csv") for motion in ("twist", "drag"))
        self.assertIn("slip", {row["state"] for row in twist} & {row["state"] for row in drag})
        self.assertEqual({(row["fx"], row["fy"]) for row in twist}, {(0, 0)})
        self.assertEqual({row["moment"] for row in drag}, {0})
        for row in twist + drag:
            self.assertFalse(any(math.isnan(row[name]) for name in ("px", "py", "angle", "fx", "fy", "moment")))

    def test_step_c_and_the_load_are_one_spring(self):
        # Round a loop on a ball, where x_g = R n: k_l (x_p - x_g) of step c and the load k_l d are
        # k_l (x_p - x_h), our choice, and no loop gains energy. The tangential part of x_p - x_g
        # alone would gain k_l s^2 (change of depth)/(2 R).
        ball, stiffness, turn, deep, shallow = 0.05, 1000, 0.1, 0.0025, 0.001
        corners = [(0, deep), (turn, deep), (turn, shallow), (0, shallow), (0, deep)]
        path = [
            tuple(p + (q - p) * i / 100
                  for p, q in zip(one, other))
            for one, other in zip(corners, corners[1:])
            for i in range(100)
        ] + [corners[-1]]
        fingers = [((ball - depth) * math.sin(angle), (ball - depth) * math.cos(angle)) for angle, depth in path]
        trace = self.trace((i / 1000, x, 0, z, 0) for i, (x, z) in enumerate(fingers))
        found = rows("replay", "--trace", trace, *FINGER[:4], "--mu", "50", "--stiffness", stiffness, *FINGER[8:],
                     "--surface", f"sphere:radius={ball}")
        self.assertEqual({row["state"] for row in found}, {"stick"})
        printed, tangential = [], []
        for row, (angle, depth) in zip(found, path, strict=True):
            normal = math.sin(angle), math.cos(angle)
            chord = -ball * normal[0], ball * (1 - normal[1])  # from x_g to x_p
            across = chord[0] * normal[0] + chord[1] * normal[1]
            printed.append([stiffness * (e + depth * n) for e, n in zip(chord, normal)])
            tangential.append([stiffness * (e - across * n + depth * n) for e, n in zip(chord, normal)])
            for value, friction, n in zip(printed[-1], (row["fx"], row["fz"]), normal):
                self.assertAlmostEqual(friction + row["load"] * n, value, delta=1e-12)

        def gain(forces):
            return sum((a + b) / 2 * (q - p)
                       for f, g, x, y in zip(forces, forces[1:], fingers, fingers[1:])
                       for a, b, p, q in zip(f, g, x, y))

        self.assertAlmostEqual(gain(printed), 0, delta=1e-15)
        self.assert_close(abs(gain(tangential)), stiffness * (ball * turn) ** 2 * (deep - shallow) / (2 * ball), 2e-3)

    def test_the_proxy_goes_where_the_bodys_material_goes(self):
        # A plate turns in place under a finger 5 mm beside its axis that sticks: its centre moves by 0, the place under
        # the finger by 4.75 mm.
        found = rows("replay", "--trace", DATA / "scenes" / "turntable.csv", "--body", "trace", *FINGER[:4],
                     "--mu", "1000", "--stiffness", "1000", "--twist-stiffness", "0.036")
        touch = next(row for row in found if row["state"] != "free")
        self.assertEqual({row["state"] for row in found[found.index(touch):]}, {"stick"})
        self.assertAlmostEqual(math.hypot(found[-1]["px"], found[-1]["py"]), 0.005, delta=1e-9)
        self.assertAlmostEqual(1e3 * math.dist((found[-1]["px"], found[-1]["py"]), (0.005, 0)), 4.75, delta=0.005)

    def test_the_sign_of_rotation(self):
        self.assertAlmostEqual(regripped_block(lambda velocity: velocity), 3.2, delta=0.1)
        self.assertAlmostEqual(regripped_block(abs) / 360, -21, delta=0.5)
        # The scene itself: regripped at 30 degrees, it stays there.
        found = rows("pivot", "--case", "coupled", "--operator", "target=30deg")
        self.assertLess(max(abs(math.degrees(row["angle"]) - 30) for row in found if row["time"] > 3.2), 3.2)

    def test_the_ratio_of_a_hertzian_contact_grows_with_the_load(self):
        # Eqs. (4), (5): mu_r/mu_l = 3 pi/16 a(P), twice as large at 8 N as at 1 N; eq. (2): constant.
        found = rows("p-curves", "--law", "hertz", "--radius-law", "hertz:R=0.008,E=2e5", "--mu", "1", "--loads", "1,8",
                     "--points", "2")
        first, second = (row["moment"] / row["load"] for row in found if row["c"] == 0)
        self.assert_close(first, -printed_equation_17(0, hertz_radius(1))[1], 1e-4)
        self.assert_close(second / first, 2, 1e-14)

    def test_adhesive_friction_of_a_growing_contact(self):
        # A traction of 10 kPa everywhere: F as P^(2/3), M as P, from 1 to 8 N.
        ends = []
        for load in (1, 8):
            mu = 1e4 * math.pi * hertz_radius(load) ** 2 / load
            twist, slide = rows("p-curves", "--law", "uniform", "--radius-law", "hertz:R=0.008,E=2e5", "--mu", mu,
                                "--loads", load, "--points", "2")
            ends.append((slide["force"], twist["moment"]))
        for one, other, growth in zip(*ends, (4, 8)):
            self.assert_close(other / one, growth, 1e-12)

    def test_c_curves_bend(self):
        call = ["c-curves", "--law", "hertz", "--mu", "0.6", "--cors", "0.005", "--loads", "1,4", "--radius-law"]
        for law, radius in (("constant:a=0.006", lambda load: 0.006), ("hertz:R=0.008,E=2e5", hertz_radius)):
            lines = [row["force"] / row["moment"] for row in rows(*call, law)]
            for line, load in zip(lines, (1, 4), strict=True):
                force, moment = printed_equation_17(0.005, radius(load))
                self.assert_close(line, -force / moment, 1e-3)
            # N m per N at 1 N over that at 4 N.
            self.assertAlmostEqual(lines[0] / lines[1], 1 if law[0] == "c" else 2.91, delta=0.01)

    def test_how_much_the_circle_over_estimates(self):
        found = {row["law"]: row for row in rows("validate") if row["model"] == "ellipse"}
        del found["uniform-wear"]  # infinite in the middle: README.md's figure does not show it
        for law, pressure in (("hertz", hertz), ("uniform", uniform)):
            largest = -printed_equation_17(0, pressure=pressure)[1]
            summed = (printed_equation_17(c, pressure=pressure, n=150) for c in (0.6, 0.65, 0.7, 0.75, 0.8))
            self.assertAlmostEqual(found[law]["max_over_estimate"],
                                   1 / min(math.hypot(f, m / largest) for f, m in summed) - 1,
                                   delta=2e-4)
        over = sorted(row["max_over_estimate"] for row in found.values())
        self.assertEqual((round(100 * over[0], 2), round(100 * over[-1], 2)), (4.25, 8.26))
        self.assertLess(max(row["max_under_estimate"] for row in found.values()), 1e-9)
        self.assertAlmostEqual(max(row["max_cor_error"] for row in found.values()), 0.85, delta=5e-3)
        peaked = next(row for row in rows("validate", "--law", "xydas-kao:k=0.2") if row["model"] == "ellipse")
        self.assertAlmostEqual(100 * peaked["max_under_estimate"], 1.6, delta=0.05)

    def test_a_steady_slip_by_equation_23_is_set_by_the_springs(self):
        # Eqs. (21) to (23) in units of mu P and mu_r P, a finger that turns about c = a until nothing
        # changes; k_r = kappa k_l (mu_r/mu)^2.
        true_force, true_moment = printed_equation_17(1)
        largest = -printed_equation_17(0)[1]
        for kappa, off in ((0.72, 0.040), (1, 0.134), (1 / largest**2, 0.615), (10, 0.941)):
            x = y = 0.0
            for _ in range(20000):
                x, y = x + 1e-3, y + 1e-3 * kappa * largest  # of dr = a drho
                keep = 1 / math.sqrt(max(1, x * x + y * y))
                x, y = keep * x, keep * y
            self.assertAlmostEqual(math.hypot(x - true_force, y + true_moment / largest), off, delta=1e-3)
            radius = 0.006
            finger = [
                "--law", "hertz", "--radius-law", f"constant:a={radius}", "--mu", "0.6", "--stiffness", "1000",
                "--twist-stiffness", kappa * 1000 * (largest * radius) ** 2, "--curve", "ellipse", "--projection",
                "radial", "--quiet"
            ]
            path = self.trace((i / 1000, 0, -radius * 0.01 * i, -0.002, 0.01 * i) for i in range(1500))
            settled = rows("replay", "--trace", path, *finger)[-1]
            self.assertAlmostEqual(settled["fy"] / 1.2, x, delta=1e-4)
            self.assertAlmostEqual(-settled["moment"] / (1.2 * radius * largest), y, delta=1e-4)

    def test_force_closure_by_two_soft_fingers(self):
        call = ["replay", "--trace", DATA / "scenes" / "pinch.csv", "--fingers", "2", "--surface",
                "box:x=0.12,y=0.04,z=0.04", "--body", "free:mass=0.1", "--damping", "2"]
        soft, point = ([math.degrees(
            2 * math.atan2(row["bqz"], row["bqw"])) for row in rows(*call, *more)] for more in (
                FINGER, ["--mu-r", "0", *MEASURED]))
        self.assertAlmostEqual(soft[-1], math.degrees(2 * math.atan(0.2)), delta=0.05)
        self.assertEqual(set(point), {0})


class SixtyLines(CommandLineTest):
    """The paper's equations in examples/python, without the library."""

    def setUp(self):
        super().setUp()
        spec = importlib.util.spec_from_file_location("paper_in_60_lines", SIXTY_LINES)
        self.paper = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.paper)

    def test_step_b_is_that_of_the_library(self):
        """The program compares both, to 1e-12."""
        done = subprocess.run([sys.executable, "-B", SIXTY_LINES, EXECUTABLE],
                              capture_output=True,
                              text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_equation_17_by_midpoints(self):
        radius, mu = self.paper.A, self.paper.MU
        for row in rows("eval", "--law", "hertz", "--c", "0,0.003,0.006,0.009", "--radius", radius, "--mu", mu):
            found = self.paper.wrench(row["c"])
            for value, printed, magnitude, unit in zip(found, printed_equation_17(row["c"], radius),
                                                       (row["force"], row["moment"]), (mu, mu * radius)):
                self.assertAlmostEqual(value, mu * printed, delta=1e-4 * unit)
                self.assertAlmostEqual(abs(value), magnitude, delta=1e-4 * unit)
        self.assert_close(self.paper.MU_R, -self.paper.wrench(0.0)[1], 1e-4)  # eqs. (4), (5)


if __name__ == "__main__":
    unittest.main()
