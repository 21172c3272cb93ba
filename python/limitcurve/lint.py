# SPDX-License-Identifier: MIT
"""python -m limitcurve.lint FILE: what the friction numbers of a scene mean, which are never used, and what to write
instead.

FILE is MJCF, URDF (with Bullet's or Gazebo's extensions), SDF or USDA. A CSV row for each place where a number is
written: file, line, what it belongs to, how many of them; the parameter, in the words of `limitcurve translate --read`,
and its value; the moment over the load and the contact radius that it stands for [m]; a verdict; with a contact
(--radius-law or --patch) the number to write; a note.

Verdicts: dead (never used), too large (more than twice the contact's), hidden (another geom's number counts), unused
(condim below 4), no contact, no moment, ok, note. Exit status: 0, or 1 if a number is dead or too large, or 2 if the
file cannot be read."""

import argparse
import csv
import math
import re
import sys
from collections import defaultdict
from functools import lru_cache
from pathlib import Path
from xml.parsers import expat

from . import translate

COLUMNS = "file,line,what,count,parameter,value,moment_per_load,radius,verdict,write,note".split(",")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,2})?")
FLAGS = ("condim", "priority", "contype", "conaffinity")
USD = ("newton:torsionalFriction", "physxCollision:minTorsionalPatchRadius", "physxCollision:torsionalPatchRadius")


class Element:
    """An element of an XML file, and its line."""

    def __init__(self, tag, attributes, file, line):
        self.tag, self.attributes, self.file, self.line, self.text, self.children = tag, attributes, file, line, "", []
        self.get = attributes.get

    def child(self, *tags):
        for tag in tags:
            self = next((c for c in self.children if c.tag == tag), None) if self else None
        return self

    def every(self, tag):
        return [found for child in self.children for found in [child] * (child.tag == tag) + child.every(tag)]

    def refuse(self, text):
        raise ValueError(f"{self.file}:{self.line}: <{self.tag}>: {text}")

    def numbers(self, key=None):
        """Of an attribute, or of the text."""
        words = (self.text if key is None else self.get(key, "")).split()
        if not words or not all(NUMBER.fullmatch(word) for word in words):
            hint = "; expand it first: xacro FILE.xacro > FILE.urdf" if "${" in "".join(words) else ""
            self.refuse(f"got '{' '.join(words)}', expected numbers{hint}")
        return [float(word) for word in words]


def read_xml(path):
    parser, stack = expat.ParserCreate(), [Element("", {}, path, 0)]

    def start(tag, attributes):
        stack.append(Element(tag, attributes, path, parser.CurrentLineNumber))
        if len(stack) > 200:
            stack[-1].refuse("nested in more than 200 elements")
        if tag.startswith("xacro:"):
            stack[-1].refuse(f"expand it first: xacro {path} > FILE.urdf")
        stack[-2].children.append(stack[-1])

    parser.buffer_text, parser.StartElementHandler, parser.EndElementHandler = True, start, lambda tag: stack.pop()
    parser.CharacterDataHandler = lambda data: setattr(stack[-1], "text", stack[-1].text + data)
    parser.EntityDeclHandler = lambda *_: stack[-1].refuse("entities are not read")
    try:
        parser.Parse(Path(path).read_bytes(), True)
    except expat.ExpatError as error:
        raise ValueError(f"{path}:{error.lineno}: not well-formed XML: {expat.errors.messages[error.code]}") from None
    return stack[0].children[0]


class Rows:
    """Collects numbers; `finish` says what they mean. `how`: the contact that they are for, as `translate` takes it, or
    nothing."""

    def __init__(self, law, mu, how):
        self.law, self.mu, self.how = law, mu, how
        self.wanted = lru_cache(None)(self.wanted)
        self.found = []  # a row, its friction, its engine's other numbers and the length of its unit

    def wanted(self, engine, mu):
        table = translate(mu=mu, engine=engine, **self.how)
        return dict(zip(table["parameter"], table["value"]))

    def add(self, at, what, parameter, value, mu=None, others=(), verdict="", note="", count=1, metre=1.0):
        """`at`: the element that states the number. Without a verdict the number is compared with the contact."""
        if not 0 <= value < math.inf:
            at.refuse(f"got {value:g}, expected a friction number >= 0")
        engine = re.split("[.:]", parameter)[0]
        mu = self.mu or mu
        others = [*others, *[f"friction={mu!r}"] * (mu is not None)]
        row = [at.file, at.line, what, count, parameter, value, math.nan, math.nan, verdict, math.nan, note]
        self.found.append(
            (row, mu or 1.0, [f"{parameter}={value * metre!r}", *(f"{engine}.{other}" for other in others)], metre))

    def finish(self, only=""):
        kept = [found for found in self.found if re.search(only, found[0][2])]
        for parameter in {row[4]
                          for row, *_ in kept
                          }:  # a contact's first number is that of its row: it begins a contact each time
            rows = [found for found in kept if found[0][4] == parameter]
            table = translate(self.law, mu=self.mu or 1.0, read=[text for _, _, texts, _ in rows for text in texts])
            place = 0
            for row, mu, texts, metre in rows:
                row[6], row[7] = float(table["moment_per_load"][place]), float(table["radius"][place])
                if self.how and row[6] == row[6]:
                    name = str(table["parameter"][place]).replace("pair.friction[2]", "geom.friction[1]")
                    row[9] = self.wanted(str(table["engine"][place]), mu).get(name, math.nan) / metre
                means = "no moment" if row[6] == 0 else "note" if not self.how or row[6] != row[
                    6] else "too large" if row[5] > 2 * row[9] else "ok"
                row[8] = row[8] or means
                place += len(texts)
        return [row for row, *_ in kept]


def include(element, main, seen):
    """MuJoCo's: beside the main file, else beside the file that includes."""
    children = []
    for child in element.children:
        if child.tag == "include":
            name = child.get("file", "")
            path = next((p for p in (main / name, Path(child.file).parent / name) if p.is_file()), None)
            if path is None or path.resolve() in seen:
                child.refuse(f"{name}: " + ("no such file" if path is None else "included twice"))
            seen.add(path.resolve())
            part = read_xml(path)
            include(part, main, seen)
            children += part.children
        else:
            include(child, main, seen)
            children.append(child)
    element.children = children


class Surface:
    """What a geom, a pair or a default class says; `at`: the element that states its torsional number."""

    def __init__(self, friction=None, other=None):
        self.friction, self.condim, self.priority, self.contype, self.conaffinity = friction, 3, 0, 1, 1
        self.at = self.condim_at = None
        self.__dict__.update(other.__dict__ if other else {})

    def state(self, element):
        if element.get("friction") is not None:
            stated = element.numbers("friction")
            if len(stated) > len(self.friction):
                element.refuse(f"friction has {len(stated)} numbers, expected at most {len(self.friction)}")
            self.friction = (*stated, *self.friction[len(stated):])
            self.at = element if len(stated) > len(self.friction) // 2 else self.at
        self.__dict__.update({key: int(element.numbers(key)[0]) for key in FLAGS if element.get(key) is not None})
        self.condim_at = element if element.get("condim") is not None else self.condim_at
        return self


class Mjcf:
    """The geoms (element, surface, body) and pairs of an MJCF file, resolved as MuJoCo does."""

    def __init__(self, root):
        include(root, Path(root.file).parent, {Path(root.file).resolve()})
        self.geoms, self.pairs, self.welds = [], [], [0]
        self.classes = {
            "geom": {
                "main": Surface((1.0, 0.005, 0.0001))
            },
            "pair": {
                "main": Surface((1.0, 1.0, 0.005, 0.0001, 0.0001))
            }
        }
        for flag in root.every("flag"):
            if flag.get("override") == "enable":
                flag.refuse("not read: override replaces the friction of every contact by o_friction")
        for top in (t for t in root.children if t.tag == "default"):
            self.default(top, "main")
        for top in (t for t in root.children if t.tag in ("worldbody", "contact")):
            self.body(top, "main", 0)

    def default(self, element, parent):
        name = element.get("class", "main")
        for kind, classes in self.classes.items():
            classes[name] = Surface(other=classes[parent])
            for child in (c for c in element.children if c.tag == kind):
                classes[name].state(child)
        for child in (c for c in element.children if c.tag == "default"):
            self.default(child, name)

    def of(self, element, otherwise):
        name = element.get("class", otherwise)
        if name not in self.classes["geom"]:
            element.refuse(f"unknown default class '{name}'")
        stated = any(element.get(key) is not None for key in ("friction", *FLAGS))
        return Surface(
            other=self.classes[element.tag][name]).state(element) if stated else self.classes[element.tag][name]

    def body(self, element, childclass, body):
        for child in element.children:
            if child.tag == "pair":
                self.pairs.append((child, self.of(child, childclass)))
            elif child.tag == "geom":
                self.geoms.append((child, self.of(child, childclass), body))
            elif child.tag in ("body", "frame", "replicate"):
                if child.tag == "body":
                    self.welds.append(
                        len(self.welds) if child.child("joint") or child.child("freejoint") else self.welds[body])
                self.body(child, child.get("childclass", childclass),
                          len(self.welds) - 1 if child.tag == "body" else body)
            elif child.tag in ("attach", "composite", "flexcomp"):
                child.refuse("not read: save the compiled model (mujoco.mj_saveLastXML) and read that")


def lint_mjcf(root, rows):
    scene, groups, kinds = Mjcf(root), defaultdict(list), defaultdict(lambda: defaultdict(list))
    for element, s, body in scene.geoms:
        kind, weld = (s.condim, s.priority, s.contype, s.conaffinity), scene.welds[body]
        groups[(id(s.at or s.condim_at), s.friction, kind)].append((element, s, weld))
        kinds[kind][weld].append(s.friction[1])
    # The smallest and the largest number of two bodies: one of the two is another body than that of a geom.
    ends = {
        kind: sorted((min(n), w)
                     for w, n in welds.items())[:2] + sorted((max(n), w)
                                                             for w, n in welds.items())[-2:]
        for kind, welds in kinds.items()
    }
    in_pair = {pair.get(key) for pair, _ in scene.pairs for key in ("geom1", "geom2")}
    torsion = any(s.condim > 3 for _, s in scene.pairs) or any(k[0] > 3 and (k[2] or k[3]) for k in kinds)
    for members in groups.values():
        element, s, weld = members[0]
        if s.at is None and s.condim < 4:
            continue
        own = {weld for _, _, weld in members}
        meets = [(*k[:2], number) for k, end in ends.items() if k[2] & s.conaffinity or s.contype & k[3]
                 for number, weld in end if own != {weld}]
        # The geom of the higher priority says condim and friction; of two alike the larger counts.
        turn = [
            k for k in meets
            if (max(k[0], s.condim) if k[1] == s.priority else k[0] if k[1] > s.priority else s.condim) > 3
        ]
        above = [k[1] for k in turn if k[1] > s.priority]
        larger = [k[2] for k in turn if k[1] == s.priority and k[2] > s.friction[1]]
        counts = len(turn) > len(above) + len(larger)
        verdict, note = "", "" if s.at else "the default, not written"
        if not (s.contype or s.conaffinity) and not any(m[0].get("name") in in_pair for m in members):
            verdict, note = "no contact", "contype and conaffinity 0"
        elif not torsion and s.friction[1] != 0.005:
            verdict, note = "dead" if rows.how else "unused", "no geom or pair here has condim 4 or 6"
        elif not turn and (meets or s.condim < 4):
            verdict, note = "unused", "no contact of it has condim 4 or 6"
        elif above and not counts and not larger:
            verdict, note = "hidden", f"beside geoms of priority {max(above)}: their numbers count"
        elif larger:
            verdict, note = "hidden" * (
                not counts), f'beside {max(larger):g} the larger counts; give priority="{s.priority + 1}" or a pair'
        elif s.friction[1] < 0.005 and s.priority == 0:
            note = "beside a geom with the default, 0.005, the larger counts"
        at, what = s.at or s.condim_at, f"geom {element.get('name') or element.get('class') or ''}".strip()
        rows.add(at, what, "mujoco.torsional", s.friction[1], s.friction[0], (), verdict, note, len(members))
    turning = {element.get("name") for element, s, _ in scene.geoms if s.condim > 3}
    for pair, s in scene.pairs:
        ends_torsion = not s.at and s.condim < 4 and bool(turning & {pair.get("geom1"), pair.get("geom2")})
        if s.at or s.condim > 3 or ends_torsion:
            dead = s.condim_at is None and (s.friction[2] != 0.005 or ends_torsion)
            at, what = s.at or s.condim_at or pair, f"pair {pair.get('geom1')} {pair.get('geom2')}"
            verdict, note = "dead" if dead else "unused" if s.condim < 4 else "", "a pair has condim 3 unless it says so, whatever its geoms have"
            rows.add(at, what, "mujoco.pair.torsional", s.friction[2], s.friction[0], (), verdict, note * dead)


def lint_urdf(root, rows):
    for link in root.every("link"):
        contact = link.child("contact")
        found = {c.tag: c for c in contact.children} if contact else {}
        if "spinning_friction" in found:
            mu = found["lateral_friction"].numbers("value")[0] if "lateral_friction" in found else 0.5
            note = "" if "rolling_friction" in found else "between rigid bodies (useMaximalCoordinates) it needs rolling_friction > 0, too"
            spinning = found["spinning_friction"]
            rows.add(spinning,
                     f"link {link.get('name')}",
                     "bullet.spinning_friction",
                     spinning.numbers("value")[0],
                     mu,
                     note=note)
    for gazebo in root.every("gazebo"):
        for mu in (c for c in gazebo.children if c.tag in ("mu1", "mu2")):
            rows.add(mu,
                     f"gazebo {gazebo.get('reference')}",
                     "gazebo.mu" + "2" * (mu.tag == "mu2"),
                     mu.numbers()[0],
                     verdict="no moment")
        lint_sdf(gazebo, rows)


def lint_sdf(root, rows):
    for collision in root.every("collision"):
        torsional, what = collision.child("surface", "friction",
                                          "torsional"), f"collision {collision.get('name', '')}".strip()
        at = {c.tag: c for c in torsional.children} if torsional else {}
        value = {tag: at[tag].numbers()[0] for tag in ("coefficient", "patch_radius", "surface_radius") if tag in at}
        patch = "use_patch_radius" not in at or at["use_patch_radius"].text.strip().lower() in ("1", "true")
        mu = value.get("coefficient", 1.0)
        if "patch_radius" in value:
            dead = value["patch_radius"] > 0 and not (patch and mu)
            note = "use_patch_radius is false" if not patch else f"with coefficient {mu:g}" + ", the default" * (
                "coefficient" not in value)
            others = [f"coefficient={mu}", f"use_patch_radius={int(patch)}"]
            rows.add(at["patch_radius"], what, "gazebo.patch_radius", value["patch_radius"], mu, others,
                     "dead" if dead else "", note)
        elif "coefficient" in value and patch:
            note = "patch_radius is 0 here: the other surface's counts"
            rows.add(at["coefficient"], what, "gazebo.coefficient", mu, verdict="no moment", note=note)
        if "surface_radius" in value:
            verdict = "dead" if patch and value["surface_radius"] else "note"
            note = "use_patch_radius is true: not read" if patch else "lever sqrt(value depth)"
            rows.add(at["surface_radius"],
                     what,
                     "gazebo.surface_radius",
                     value["surface_radius"],
                     verdict=verdict,
                     note=note)


def lint_usda(root, rows):
    text, number, prim = Path(root.file).read_text(encoding="utf-8",
                                                   errors="replace"), r"\s*=\s*([-+]?\.?\d[-+.\deE]*)", ""
    unit = re.search(r"^\s*metersPerUnit" + number, text, re.M)
    metre, frictions = float(unit[1]) if unit else 0.01, set(re.findall("physics:dynamicFriction" + number, text))
    mu, condim = float(*frictions) if len(frictions) == 1 else None, max(map(int,
                                                                             re.findall(r"mjc:condim\s*=\s*(\d)",
                                                                                        text)),
                                                                         default=3)
    for line, row in enumerate(text.splitlines(), 1):
        named = re.match(r'\s*(?:def|over|class)\s+(?:\w+\s+)?"([^"]*)"', row)
        prim = named[1] if named else prim
        found = re.match(r"\s*(?:custom\s+|uniform\s+)*(?:float|double|half)\s+([\w:]+)(\.timeSamples)?", row)
        if found and found[1] in USD:
            at, value = Element(f"prim {prim}", {}, root.file,
                                line), re.fullmatch(number,
                                                    re.split("[(#]", row[found.end(1):])[0].rstrip())
            if value is None:
                at.refuse(f"{found[1]}: expected a number")
            notes = [f"a unit is {metre:g} m" + ", for want of metersPerUnit" *
                     (unit is None)] if metre != 1 or not unit else []
            if found[1].endswith(":torsionalPatchRadius"):
                notes.append(
                    f"lever sqrt(value depth), {1e3 * math.sqrt(float(value[1]) * metre * 1e-4):.3g} mm at 0.1 mm")
            if found[1].startswith("newton") and condim < 4:
                notes.append("SolverMuJoCo needs mjc:condim 4")
            rows.add(at, at.tag, found[1], float(value[1]), mu, note="; ".join(notes), metre=metre)


def lint(path, rows):
    head = Path(path).read_bytes()[:4096]
    if b"\0" in head or head.startswith((b"PXR-USDC", b"PK")) or str(path).endswith((".xacro", ".erb")):
        raise ValueError(
            f"{path}: not plain XML or USDA; convert it first: usdcat {path} -o FILE.usda, or xacro {path} > FILE.urdf")
    root = Element("usda", {}, path, 1) if head.startswith(b"#usda") else read_xml(path)
    readers = {"usda": lint_usda, "mujoco": lint_mjcf, "robot": lint_urdf, "sdf": lint_sdf}
    if root.tag not in readers:
        root.refuse("a part of a scene? Give the file that includes it; expected <mujoco>, <robot>, <sdf> or #usda")
    readers[root.tag](root, rows)


def pattern(text):
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"got '{text}', expected a regular expression: {error}") from None


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="limitcurve.lint",
                                     description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--law", default="hertz", help="pressure law of the contact (default hertz)")
    parser.add_argument("--radius-law", help="the contact radius, for example constant:a=0.005; with --load")
    parser.add_argument("--load", type=float, help="normal load [N]")
    parser.add_argument("--patch", help="a contact that is not round, instead of law, radius law and load")
    parser.add_argument("--mu", type=float, help="friction coefficient, instead of the file's")
    parser.add_argument("--only",
                        default="",
                        type=pattern,
                        metavar="REGEX",
                        help="only geoms, links and prims whose column `what` matches")
    given = parser.parse_args(arguments)
    how = {"law": given.law, "radius_law": given.radius_law, "load": given.load} if given.radius_law else {}
    how = {"patch": given.patch} if given.patch else how
    rows = Rows(given.law, given.mu, how)
    try:
        if given.mu is not None and not given.mu > 0:
            raise ValueError(f"--mu: got {given.mu:g}, expected > 0")
        lint(given.file, rows)
        found = rows.finish(given.only)
    except (ValueError, OSError) as error:
        print(f"limitcurve.lint: error: {error}", file=sys.stderr)
        return 2
    cells = [["" if value != value else f"{value:.6g}" if isinstance(value, float) else value
              for value in row]
             for row in found]
    csv.writer(sys.stdout, lineterminator="\n").writerows([COLUMNS, *cells])
    return int(any(row[8] in ("dead", "too large") for row in found))


if __name__ == "__main__":
    sys.exit(main())
