# SPDX-License-Identifier: MIT
"""An independent reference: the definitions of friction, by plain quadrature, bisection and brute force.

It shares no formula and no code with the library. Round contacts have radius 1, load 1 and mu = 1, and turn about a
centre of rotation (COR) at the distance s; each point resists with its pressure, against its velocity. Errors: EXACT.
"""
import mpmath
import numpy as np

EXACT = 1e-9
_T = np.arange(-78, 79) / 16
LOW, HIGH = 1 / (1 + np.exp(-np.pi * np.sinh(_T))), 1 / (1 + np.exp(np.pi * np.sinh(_T)))  # on (0, 1): from 0, from 1
WEIGHT = np.pi / 16 * np.cosh(_T) * LOW * HIGH  # the double-exponential rule: the ends may be singular


def panels(edges):
    """Nodes, their distances from the last edge, and weights on the intervals between edges."""
    edges = np.array(sorted(set(edges)))
    a, b = edges[:-1, None], edges[1:, None]
    nodes = np.where(LOW < 0.5, a + (b - a) * LOW, b - (b - a) * HIGH)
    return nodes.ravel(), (edges[-1] - b + (b - a) * HIGH).ravel(), ((b - a) * WEIGHT).ravel()


def root(rises, low, high, width=1e-15):
    """Where a function passes from below 0 to above: bisection, with secants inside the bracket."""
    left, right = rises(low), rises(high)
    if left >= 0 or right <= 0:
        return low if left >= 0 else high
    while high - low > width * max(1.0, abs(low)):
        secant, aside = high - right * (high - low) / (right - left), (high - low) * 1e-3
        for at in (secant - aside, secant + aside, (low + high) / 2):
            if low < at < high:
                value = rises(at)
                low, left, high, right = (low, left, at, value) if value > 0 else (at, value, high, right)
    return (low + high) / 2


def elliptic(near):
    """The complete elliptic integrals E and K of the parameter 1 - near, by arithmetic and geometric means."""
    a, b, c, power, total = np.ones_like(near), np.sqrt(near), np.sqrt(1 - near), 0.5, (1 - near) / 2
    while np.max(np.abs(c)) > 1e-16:
        a, b, c, power = (a + b) / 2, np.sqrt(a * b), (a - b) / 2, 2 * power
        total = total + power * c * c
    return np.pi / (2 * a) * (1 - total), np.pi / (2 * a)


def quantile(chance, freedom):
    """Of Student's distribution: the value that a standardised error passes with this chance, at either side."""
    below = lambda log: freedom / (freedom + np.exp(2 * log))
    tail = lambda log: float(mpmath.betainc(freedom / 2, 0.5, 0, below(log), regularized=True))
    return np.exp(root(lambda log: chance - tail(log), -5, 60, 1e-6))


# ---- Round contacts ----

class Round:
    """The limit curve of a radial pressure: `pressure(r, gap)`, at the radius and the distance from the rim; bends."""

    def __init__(self, pressure, bends=(), rim=1.0):
        self.pressure, self.bends, self.rim = pressure, bends, rim
        r, gap, weight = panels([0, *bends, rim])
        self.load = np.sum(weight * r * pressure(r, gap))
        self.m0, self.square = (np.sum(weight * r**n * pressure(r, gap)) / self.load for n in (2, 3))

    def unit(self, s):
        """F/(mu P) and M/(mu P a): the mean over each ring of the friction's component, by elliptic integrals."""
        if s == 0 or s > 1e3 * self.rim:  # far away: the first terms in 1/s
            return np.array((0.0, self.m0) if s == 0 else (1 - self.square / (4 * s * s), self.square / (2 * s)))
        r, gap, weight = panels([0, *self.bends, self.rim, *([s] if s < self.rim else [])])
        E, K = elliptic(np.maximum(((r - s) / (r + s))**2, 1e-300))
        weight = weight * r * self.pressure(r, gap) / self.load
        outer, inner = (r + s) * E, (r - s) * K
        return np.array([np.sum(weight * (outer - inner)) / (np.pi * s), np.sum(weight * (outer + inner)) / np.pi])

    def at(self, angle):
        return self.unit(np.tan(angle)) if angle < np.pi / 2 else np.array([1.0, 0.0])

    def polyline(self, n):
        return np.array([self.at(angle) for angle in np.linspace(0, np.pi / 2, n)])

    def on_ray(self, force, moment):
        return self.at(root(lambda angle: self.at(angle) @ (moment, -force), 0, np.pi / 2))

    def gauge(self, force, moment):
        """Size of a unit wrench over that of the curve on its ray."""
        if force == 0 or moment == 0:
            return force + moment / self.m0
        f, m = self.on_ray(force, moment)
        return force / f if force > moment / self.m0 else moment / m

    def closest(self, force, moment, chi):
        """The point of the curve nearest to a unit wrench, where moments count sqrt(chi) times as much as forces."""
        def turn(angle):
            f, m = self.at(angle)
            return chi * (moment - m) * np.sin(angle) - (force - f) * np.cos(angle)
        return self.at(root(turn, 0, np.pi / 2))


class Ellipse(Round):
    rim = 1.0

    def __init__(self, m0):
        self.m0 = m0

    def unit(self, s):
        return np.array([s, self.m0**2]) / np.hypot(s, self.m0)


class Mixed(Round):
    """Shares of the load under several pressures."""

    def __init__(self, parts):
        total = sum(share for share, _ in parts)
        self.parts = [(share / total, curve) for share, curve in parts]
        self.m0 = sum(share * curve.m0 for share, curve in self.parts)

    def unit(self, s):
        return sum(share * curve.unit(s) for share, curve in self.parts)


PRESSURES = {
    "hertz": lambda r, gap: np.sqrt(gap * (1 + r)), "uniform": lambda r, gap: 1 + 0 * r,
    "parabolic": lambda r, gap: gap * (1 + r), "flat-punch": lambda r, gap: 1 / np.sqrt(gap * (1 + r)),
    "cone": lambda r, gap: np.arccosh(1 / r), "uniform-wear": lambda r, gap: 1 / r}


def law(text):
    """The named laws, from their definitions."""
    name, _, rest = text.partition(":")
    if name == "mix":
        return Mixed([(float(part.split("*")[0]), law(part.split("*")[1])) for part in rest.split("+")])
    value = float(rest.partition("=")[2] or 0)
    if name == "power":
        return Round(lambda r, gap: (gap * (1 + r))**value)
    if name == "xydas-kao":
        return Round(lambda r, gap: (-np.expm1(value * np.log1p(-gap)))**(1 / value))
    if name == "gaussian":
        return Round(lambda r, gap: np.exp(-((r / value)**2) / 2), [value, 3 * value, 6 * value], 12 * value)
    return Round(PRESSURES[name])


def radius(text):
    """a(P) of a radius law."""
    name, _, rest = text.partition(":")
    value = {key: float(number) for key, number in (item.split("=") for item in rest.split(","))}
    if name == "hertz":
        return lambda load: (3 * load * value["R"] / (4 * value["E"]))**(1 / 3)
    return lambda load: value["a"] if name == "constant" else value["c"] * load**value["gamma"]


def hold(curve, mu, radius_of, force, moment):
    """The least load that carries a wrench: by bisection."""
    def lack(log):
        load = np.exp(log)
        return -np.log(curve.gauge(force / (mu * load), moment / (mu * load * radius_of(load))))
    return np.exp(root(lack, np.log(force / mu + 1e-30), 30.0, 1e-14)) if force or moment else 0.0


# ---- A finger: the paper's steps a to c, with dampers, static and dynamic friction, on a plane or a ball ----

class Finger:
    """Steps of one finger; `radius_of` is a(P), and `clear` how far its decisions were from other ones."""

    def __init__(self, curve, radius_of, *, mu, mu_dynamic=None, mu_r=1.0, mu_r_dynamic=None, stiffness, box=False,
                 twist_stiffness, damping=0.0, twist_damping=0.0, rest_margin=0.0, projection="closest-point"):
        self.curve, self.radius_of, self.mu, self.mu_d = curve, radius_of, mu, mu if mu_dynamic is None else mu_dynamic
        slower = [self.mu_d / mu, self.mu_d / mu if mu_r_dynamic is None else mu_r_dynamic / mu_r]
        self.turning, self.within = slower[1] / slower[0], [1 / (1 + rest_margin * (1 / part - 1)) for part in slower]
        self.k, self.kr, self.b, self.br = stiffness, twist_stiffness, damping, twist_damping
        self.projection, self.box, self.touches, self.clear = projection, box, False, np.inf

    def decide(self, value, limit):
        self.clear = min(self.clear, abs(value - limit))
        return value > limit

    def limits(self, load, slides):
        force = (self.mu_d if slides else self.mu) * load
        return np.array([force, force * self.radius_of(load) * (self.turning if slides else 1)])

    def kept(self, trial, load, ratio):
        """Of the sizes of force and moment, what friction leaves."""
        if self.box:
            both = np.array(trial)
            for i, unit in enumerate((1, self.curve.m0)):
                rest, slide = (self.limits(load, slides)[i] * unit for slides in (False, True))
                if self.decide(trial[i], slide if self.slides[i] else rest):
                    self.slides[i], both[i] = True, min(slide, trial[i])
                elif self.slides[i]:
                    self.slides[i] = self.within[i] < 1 and self.decide(trial[i] / slide, self.within[i])
            return both
        size = self.curve.gauge(*(trial / self.limits(load, self.slides[0])))
        if not self.decide(size, 1):
            self.slides[0] = self.slides[0] and min(self.within) < 1 and self.decide(size, min(self.within))
            return trial
        self.slides[0] = True
        scale = self.limits(load, True)
        f, m = trial / scale
        grows = lambda by: self.radius_of(by * load) / self.radius_of(load)
        if self.projection == "closest-point":
            return scale * self.curve.closest(f, m, (scale[1] / scale[0])**2 * ratio)
        if self.projection == "radial" or grows(2) == 1:
            return scale * self.curve.on_ray(f, m)
        size = lambda by: self.curve.gauge(f / by, m / by / grows(by))
        by = np.exp(root(lambda log: 1 - size(np.exp(log)), 0, 60))
        angle = root(lambda at: self.curve.at(at) @ (m / grows(by), -f), 0, np.pi / 2)
        return scale * self.curve.at(np.arctan2(np.sin(angle) * grows(by), np.cos(angle)))

    def step(self, goal, normal, depth, twist, dt):
        """(force, moment, load, slips) of a sample; the twist may wrap around."""
        goal, normal = np.array(goal, float), np.array(normal, float)
        finger, flat = goal - depth * normal, lambda vector: vector - vector @ normal * normal
        if depth <= 0:
            self.touches = False
            return np.zeros(3), 0.0, 0.0, False
        if not self.touches:  # touch-down: relaxed springs
            self.touches, self.slides, self.proxy, self.angle = True, [False, False], goal, twist
            self.last = goal, twist, 0.0
        before, turned, last_depth = self.last
        twist = turned + np.remainder(twist - turned + np.pi, 2 * np.pi) - np.pi
        b, br = (self.b / dt, self.br / dt) if dt > 0 else (0.0, 0.0)
        stretch, was = self.proxy - finger, self.proxy - before
        pull = (self.k + b) * flat(stretch) - b * flat(was)
        turn = (self.kr + br) * (self.angle - twist) - br * (self.angle - turned)
        load = max(self.k * depth + b * (depth - last_depth), 0.0)
        trial = np.array([np.linalg.norm(pull), abs(turn)])
        if load > 0:
            kept = self.kept(trial, load, (self.k + b) / (self.kr + br))
        else:  # nothing is kept without a load
            kept, self.slides = 0 * trial, [trial[0] > 0 or not self.box and trial[1] > 0, trial[1] > 0]
            self.clear = min(self.clear, max(trial))
        force, moment = (whole * (left / size if size > 0 else 0.0)
                         for whole, left, size in zip((pull, turn), kept, trial))
        up = stretch @ normal
        if kept[0] < trial[0]:  # the proxy follows on the plane, or on the paraboloid about the goal
            left = (b * flat(was) + force) / (self.k + b)
            old, new, rise = flat(stretch) @ flat(stretch), left @ left, up - depth
            if rise != 0 and new < old:
                rise = min(rise * new / old, np.sqrt(up * up + old - new) - depth)
            up = depth + rise
            self.proxy = goal + left + rise * normal
        if kept[1] < trial[1]:
            self.angle = twist + (moment + br * (self.angle - turned)) / (self.kr + br)
        self.last = finger, twist, depth
        whole = (self.k + b) * up - b * (was @ normal)
        return force, moment, max(whole, 0.0) if b > 0 else whole, bool(np.any(kept < trial))


# ---- Contacts of any shape: wrenches of twists (vx, vy, omega), both about the origin ----

def sums(twist, x, y, load, mx=1.0, my=1.0):
    """Of points with friction mx along x and my along y: each resists by what dissipates most within that ellipse."""
    u, v = mx * (twist[0] - twist[2] * y), my * (twist[1] + twist[2] * x)
    speed = np.hypot(u, v)
    fx, fy = (load * np.divide(part, speed, out=np.zeros_like(part), where=speed > 0) for part in (mx * u, my * v))
    return np.array([fx.sum(), fy.sum(), x @ fy - y @ fx])


class Points:
    def __init__(self, x, y, load, mx=1.0, my=1.0):
        self.x, self.y, self.load = np.asarray(x, float), np.asarray(y, float), np.asarray(load, float) / np.sum(load)
        self.friction = mx, my
        self.centre, self.corners = np.array([self.load @ self.x, self.load @ self.y]), list(zip(self.x, self.y))
        spin = np.array([self.centre[1], -self.centre[0], 1])
        self.m0 = spin @ self.wrench(spin)

    def wrench(self, twist):
        return sums(twist, self.x, self.y, self.load, *self.friction)


class Polygons:
    """Polygons (vertices, load) of uniform pressure: triangles between each edge and a point, with a sign."""

    corners = ()

    def __init__(self, polygons):
        edges, self.centre, total = [], np.zeros(2), sum(load for _, load in polygons)
        for vertices, load in polygons:
            p, q = np.asarray(vertices, float), np.roll(np.asarray(vertices, float), -1, axis=0)
            cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
            density = load / total / (cross.sum() / 2)
            edges += [(a, b, density) for a, b in zip(p, q)]
            self.centre = self.centre + density * ((p + q) * cross[:, None]).sum(0) / 6
        self.start, self.end, self.density = (np.array(column) for column in zip(*edges))
        self.m0 = self.about(self.centre)[1]
        at, share = np.polynomial.legendre.leggauss(12)  # nodes on the triangles with the centre, for a COR far away
        at, share, p, q = (at + 1) / 2, share / 2, self.start - self.centre, self.end - self.centre
        place = at[:, None, None, None] * (p + at[:, None, None] * (q - p))[None]
        weight = (share * at)[:, None, None] * share[:, None] * self.density * (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0])
        self.nodes = place[..., 0].ravel() + self.centre[0], place[..., 1].ravel() + self.centre[1], weight.ravel()
        self.reach = 3 * np.max(np.hypot(*p.T))

    def about(self, centre):
        """Force and moment of a spin about a centre: triangles with it, edges split at the perpendicular's foot."""
        p, d = self.start - centre, self.end - self.start
        foot = np.clip(-np.sum(p * d, 1) / np.sum(d * d, 1), 0, 1)[:, None]
        tau, weight = np.hstack([foot * LOW, 1 - (1 - foot) * HIGH]), np.hstack([foot * WEIGHT, (1 - foot) * WEIGHT])
        x, y = (p[:, i, None] + d[:, i, None] * tau for i in (0, 1))
        rho = np.maximum(np.hypot(x, y), 1e-300)
        share = self.density * (p[:, 0] * d[:, 1] - p[:, 1] * d[:, 0])
        force = np.array([-(share @ np.sum(weight * y / rho, 1)), share @ np.sum(weight * x / rho, 1)])
        return force / 2, share @ np.sum(weight * rho, 1) / 3

    def wrench(self, twist):
        vx, vy, omega = twist
        if np.hypot(vx - omega * self.centre[1], vy + omega * self.centre[0]) > self.reach * abs(omega):
            return sums(twist, *self.nodes)
        x, y = -vy / omega, vx / omega
        (fx, fy), moment = self.about(np.array([x, y]))
        return np.sign(omega) * np.array([fx, fy, moment + x * fy - y * fx])


def rectangle(x, y, centre=(0, 0), load=1.0):
    return [(centre[0] + sx * x / 2, centre[1] + sy * y / 2) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))], load


def image(pressures, pixel):
    """Pixels as squares; the origin is the centre of pressure."""
    made = lambda cx, cy: Polygons([rectangle(pixel, pixel, (j * pixel - cx, -i * pixel - cy), pressure) for i, row in
                                    enumerate(pressures) for j, pressure in enumerate(row) if pressure > 0])
    return made(*made(0, 0).centre)


def patch_hold(patch, mu, wrench):
    """The least load of a patch: the wrench's power over the least of friction, by cutting ellipses."""
    cx, cy = patch.centre
    scale = np.array([1, 1, patch.m0])
    target = np.array([*wrench[:2], wrench[2] - cx * wrench[1] + cy * wrench[0]]) / scale
    size = np.linalg.norm(target)
    along, across = target / size, np.linalg.svd(target[None, :] / size)[2][1:]
    def about(parameters):  # the power of a twist of power 1, and its gradient
        vx, vy, spin = along + parameters @ across
        twist = np.array([vx + spin / patch.m0 * cy, vy - spin / patch.m0 * cx, spin / patch.m0])
        found = patch.wrench(twist)
        return twist @ found, across @ (np.array([*found[:2], found[2] - cx * found[1] + cy * found[0]]) / scale)
    at, shape, best, floor = np.zeros(2), np.eye(2) * 1e4, about(np.zeros(2))[0], 0.0
    for x, y in patch.corners:  # the least power may be at a kink: about a point of the patch
        twist = np.array([y - cy, cx - x, patch.m0])
        if abs(twist @ along) > 1e-12:
            best = min(best, about(across @ twist / (twist @ along))[0])
    while best - floor > 1e-10 * best:
        power, slope = about(at)
        best = min(best, power)
        wide = np.sqrt(slope @ shape @ slope)
        floor = max(floor, power - wide)
        if not wide > 1e-14 * best or np.trace(shape) < 1e-26:
            break
        deep = min((power - best) / wide, 0.99)  # of the half-plane that holds the least
        step = shape @ slope / wide
        at = at - (1 + 2 * deep) / 3 * step
        shape = 4 / 3 * (1 - deep**2) * (shape - 2 * (1 + 2 * deep) / (3 * (1 + deep)) * np.outer(step, step))
    return size / (mu * best)


# ---- A fit ----

def fit(curve, load, force, moment, sigma_force, sigma_moment, gamma=0.0):
    """(mu, mu_r) and standard errors: least squares of the distances from the curve, in standard deviations."""
    line, power = curve.polyline(300) / [1, curve.m0], load**(1 + gamma)
    at = np.array([force / sigma_force, moment / sigma_moment]).T[:, None]
    def distances(logs):
        mu, mu_r = np.exp(logs)
        points = line[None] * np.array([mu * load / sigma_force, mu_r * power / sigma_moment]).T[:, None]
        points = np.concatenate([points, points[:, -1:] - [0, 1]], 1)  # moments below 0, beyond a pure slide
        step, rest = np.diff(points, axis=1), at - points[:, :-1]
        share = np.clip(np.sum(rest * step, 2) / np.sum(step * step, 2), 0, 1)
        away = rest - share[..., None] * step
        row = np.arange(len(load))
        best = np.argmin(np.sum(away**2, 2), 1)
        away, step = away[row, best], step[row, best]
        return np.hypot(*away.T) * np.sign(step[:, 0] * away[:, 1] - step[:, 1] * away[:, 0])
    logs, mild = np.log([np.max(force / load) + 1e-9, np.max(moment / power) + 1e-12]), 1e-3
    here = distances(logs)
    for _ in range(200):  # Levenberg's steps, until they no longer matter
        slope = np.array([(distances(logs + d) - distances(logs - d)) / 2e-6 for d in 1e-6 * np.eye(2)]).T
        normal = slope.T @ slope
        step = -np.linalg.lstsq(normal + mild * np.diag(np.diag(normal) + 1e-9), slope.T @ here, rcond=None)[0]
        there = distances(logs + step)
        if there @ there <= here @ here:
            logs, here, mild = logs + step, there, mild / 5
        else:
            mild *= 7
        if np.max(np.abs(step)) < 1e-10 or mild > 1e12:
            break
    return np.exp(logs), np.exp(logs) * np.sqrt(np.maximum(np.diag(np.linalg.pinv(normal)), 0)), here
