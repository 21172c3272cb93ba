# SPDX-License-Identifier: MIT
"""python -m limitcurve.lint FILE: what the friction numbers of a scene mean, which of them never act, and what to write
instead.

FILE is MJCF, URDF (with Bullet's or Gazebo's extensions), SDF or USDA. The result is CSV, with a row for each place
where a number is written: file, line, what it belongs to, how many of them; the parameter, in the words of `limitcurve
translate --read`, and its value; the moment over the load and the contact radius that it stands for [m]; a verdict; if
a contact is given (--radius-law or --patch), the number to write; a note. Parts that are not read, such as the includes
of SDF, are named on standard error."""

import argparse
import csv
import math
import os
import re
import sys
from collections import defaultdict
from dataclasses import astuple, dataclass
from functools import lru_cache
from pathlib import Path
from xml.parsers import expat

from . import translate

# How far a number may be from the contact's, and how many times a pair's two sliding coefficients may differ.
FACTOR = 2
ANISOTROPY = 5
# Verdicts, with the exit status. Code, help and docs/which_number.md read this table.
VERDICTS = {
    "dead": (1, "never acts, because the file switches it off, or no engine reads it there"),
    "unused": (1, "never acts, because no contact of the geom has condim 4 or 6"),
    "hidden": (1, "another number acts instead: always, or such that the moment is more than {FACTOR} times off"),
    "geom order": (1, "a pair's numbers in a geom's order: sliding differs more than {ANISOTROPY} times"),
    "too large": (1, "more than {FACTOR} times the contact's moment"),
    "too small": (1, "less than 1/{FACTOR} of the contact's moment"),
    "creeps": (0, "the options let a held object turn or sink"),
    "no contact": (0, "the geom touches nothing"),
    "no moment": (0, "the number sets no moment about the normal"),
    "note": (0, "no contact is given to compare the number with, or a priority or a pair sets another"),
    "ok": (0, "within these bounds"),
}
ERROR = 2  # exit status if the file or the arguments cannot be read
FLAGS = ("condim", "priority", "contype", "conaffinity")
USD = ("newton:torsionalFriction", "physxCollision:minTorsionalPatchRadius", "physxCollision:torsionalPatchRadius")
DEFAULT = (1.0, 0.005, 0.0001)  # MuJoCo's friction of a geom
PART = "a part of a scene? Give the file that includes it"
TORSIONAL = ("coefficient", "patch_radius", "surface_radius")


def verdicts():
    """The table of verdicts, as lines of text."""
    names = {"FACTOR": FACTOR, "ANISOTROPY": ANISOTROPY}
    return "\n".join(f"  {name:10}  {status}  {text.format(**names)}" for name, (status, text) in VERDICTS.items())


class Element:
    """An element of an XML file, and its line."""

    def __init__(self, tag, attributes, file, line):
        self.tag, self.attributes, self.file, self.line, self.text, self.children = tag, attributes, file, line, "", []
        self.get, self.is_read = attributes.get, False

    def child(self, *tags):
        for tag in tags:
            self = next((c for c in self.children if c.tag == tag), None) if self else None
        return self

    def every(self, tag):
        return [found for child in self.children for found in [child] * (child.tag == tag) + child.every(tag)]

    def refuse(self, text):
        raise ValueError(f"{self.file}:{self.line}: <{self.tag}>: {text}")

    def numbers(self, key=None, least=0.0):
        """Finite, and not below `least`: of an attribute, or of the text."""
        words, self.is_read = (self.text if key is None else self.get(key, "")).split(), True
        try:
            numbers = [float(word) for word in words]
        except ValueError:
            numbers = []
        if not numbers or not all(least <= number < math.inf for number in numbers):
            hint = "; expand it first: xacro FILE.xacro > FILE.urdf" if "${" in "".join(words) else ""
            self.refuse(f"got '{' '.join(words)}', expected finite numbers{' >= 0' * (least == 0)}{hint}")
        return numbers

    def number(self):
        """Of an extension to URDF: `value`, or else the text."""
        return self.numbers(None if self.get("value") is None else "value")[0]



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
    parser.EntityDeclHandler = lambda name, *_: Element("!ENTITY", {}, path, parser.CurrentLineNumber).refuse(
        f"not read: write its text in place of &{name};")
    # Engines take what XML forbids: "--" in a comment, and space before the declaration.
    text = re.sub(rb"(?s)<!--.*?-->|\A\s+<\?xml.*?\?>", lambda part: b"\n" * part[0].count(b"\n"),
                  Path(path).read_bytes())
    try:
        parser.Parse(text, True)
    except expat.ExpatError as error:
        raise ValueError(f"{path}:{error.lineno}: not well-formed XML: {expat.errors.messages[error.code]}") from None
    return stack[0].children[0]


@dataclass
class Row:
    """The columns, and what `finish` needs to judge the number."""
    file: str
    line: int
    what: str
    count: int
    parameter: str
    value: float
    moment_per_load: float = math.nan
    radius: float = math.nan
    verdict: str = ""
    write: float = math.nan
    note: str = ""
    mu: float = 1.0
    read: tuple = ()  # the number and those beside it, as `translate` reads them
    metre: float = 1.0  # length of the file's unit
    acts: tuple = ()
    idle: bool = False  # it would act in contacts that have no torsion
    names: tuple = ()  # what else the number belongs to


COLUMNS = list(Row.__dataclass_fields__)[:11]


class Rows:
    """Collects numbers; `finish` says what they mean. `how`: the contact that they are for, as `translate` takes it, or
    nothing."""

    def __init__(self, law, mu, how):
        self.law, self.mu, self.how = law, mu, how
        self.wanted = lru_cache(None)(self.wanted)
        self.found, self.notes, self.engine = [], [], "the engine"

    def wanted(self, engine, mu):
        try:
            table = translate(mu=mu, engine=engine, **self.how)
        except ValueError as error:  # a patch with two frictions has no numbers for an engine with one
            why = str(error).partition("engine: ")[2]
            if not why:
                raise
            if why not in self.notes:
                self.notes.append(why)
            return {}
        return dict(zip(table["parameter"], table["value"]))

    def not_read(self, at, text):
        self.notes.append(f"{at.file}:{at.line}: {text}")

    def add(self, at, what, parameter, value, mu=None, others=(), verdict="", note="", count=1, metre=1.0, acts=(),
            idle=False, names=()):
        """`at`: the element that states the number. Without a verdict its moment, or those of `acts`, the numbers that
        act in the scene, are compared with the contact's."""
        mu = self.mu or (1.0 if mu is None else mu)
        if mu < 0:
            at.refuse(f"got friction {mu:g}, expected >= 0")
        engine = re.split("[.:]", parameter)[0]
        # A moment is proportional to its number, but 0 does not tell the factor.
        read = (f"{parameter}={(value or 1.0) * metre!r}",
                *(f"{engine}.{other}" for other in (*others, f"friction={mu!r}")))
        self.found.append(
            Row(at.file, at.line, what, count, parameter, value, verdict=verdict, note=note, mu=mu or 1.0, read=read,
                metre=metre, acts=acts, idle=idle, names=names))

    def finish(self, only=""):
        kept = []
        for row in self.found:
            matching = [name for name in (row.what, *row.names) if re.search(only, name)]
            if matching:
                row.what = matching[0]
                kept.append(row)
        if self.found and not kept:
            names = ", ".join(dict.fromkeys(name for row in self.found for name in (row.what, *row.names)))
            raise ValueError(f"--only: got '{getattr(only, 'pattern', only)}', expected a part of one of: {names}")
        # One call for each parameter: a number of a parameter that was given already begins another contact.
        for parameter in {row.parameter for row in kept}:
            rows = [row for row in kept if row.parameter == parameter]
            table = translate(self.law, read=[text for row in rows for text in row.read])
            place = 0
            for row in rows:
                self.judge(row, **{name: table[name][place] for name in table})
                place += len(row.read)
        return kept

    def judge(self, row, engine, parameter, moment_per_load, radius, **_):
        own, row.radius = (float(number) * (row.value != 0) for number in (moment_per_load, radius))
        acts = [float(moment_per_load) / (row.value or 1.0) * number for number in row.acts]
        row.moment_per_load = own
        if self.how and not math.isnan(own):
            wanted = self.wanted(str(engine), row.mu)
            # The same number, of a pair if friction along x and y differs.
            same = {"geom.friction[1]", "pair.friction[2]"}
            names = same if parameter in same else {parameter}
            row.write = next((wanted[name] for name in names if name in wanted), math.nan) / row.metre
        if row.verdict and not acts:
            return
        right = float(self.wanted("ode", row.mu)["surface.rhoN"]) if self.how else math.nan  # moment over load

        def side(moment):
            return (moment > FACTOR * right) - (moment * FACTOR < right)

        off = next(filter(side, sorted(acts or [own], reverse=True)), None)
        if off is not None:
            row.verdict = "hidden" if row.verdict or side(own) != side(off) else ("too large", "too small")[off < right]
        elif not row.verdict:
            row.verdict = "no moment" if not any(acts or [own]) else "ok" if self.how else "note"
        if self.how and row.idle and off is None and not side(own):  # meant for the contact, but condim is forgotten
            row.verdict, row.note = "unused", f"without condim 4 it never acts ({row.note})"
        if row.verdict == "hidden":
            row.note += f"; what acts is {off / right:.2g} times the contact's"


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
        self.at = self.condim_at = self.friction_at = None
        self.__dict__.update(other.__dict__ if other else {})

    def state(self, element):
        if element.get("friction") is not None:
            stated = element.numbers("friction")
            if len(stated) > len(self.friction):
                element.refuse(f"friction has {len(stated)} numbers, expected at most {len(self.friction)}")
            self.friction, self.friction_at = (*stated, *self.friction[len(stated):]), element
            self.at = element if len(stated) > len(self.friction) // 2 else self.at
        for key in (key for key in FLAGS if element.get(key) is not None):
            if not re.fullmatch(r"\s*[1346]\s*" if key == "condim" else r"\s*[-+]?\d+\s*", element.get(key)):
                element.refuse(f'got {key}="{element.get(key)}", expected an integer, a condim 1, 3, 4 or 6')
            setattr(self, key, int(element.get(key)))
        self.condim_at = element if element.get("condim") is not None else self.condim_at
        return self


@dataclass
class Geom:
    element: Element
    surface: Surface
    body: int


class Mjcf:
    """The geoms and pairs of an MJCF file, and which bodies meet, resolved as MuJoCo does."""

    def __init__(self, root):
        include(root, Path(root.file).parent, {Path(root.file).resolve()})
        self.geoms, self.pairs = [], []
        self.names, self.welds, self.parents = ["world"], [0], [0]  # of bodies; parents: the weld that a weld hangs on
        self.classes = {"geom": {"main": Surface(DEFAULT)},
                        "pair": {"main": Surface((1.0, 1.0, 0.005, 0.0001, 0.0001))}}
        flags = {key: value for flag in root.every("flag") for key, value in flag.attributes.items()}
        if flags.get("override") == "enable":
            root.refuse("not read: <flag override> replaces the friction of every contact by o_friction")
        self.off = next((key for key in ("contact", "constraint") if flags.get(key) == "disable"), None)
        self.filters_parents = flags.get("filterparent") != "disable"
        self.options = {key: option for option in root.every("option") for key in option.attributes}
        self.excludes = {frozenset((e.get("body1"), e.get("body2"))) for e in root.every("exclude")}
        for top in (t for t in root.children if t.tag == "default"):
            self.default(top, "main")
        for top in (t for t in root.children if t.tag in ("worldbody", "contact")):
            self.body(top, "main", 0)
        for flex in root.every("flex"):
            self.flex(flex)
        self.paired = {frozenset((pair.get("geom1"), pair.get("geom2"))): pair for pair, _ in self.pairs}
        for names, pair in self.paired.items():
            missing = names - {geom.element.get("name") for geom in self.geoms}
            if missing and not root.every("replicate"):  # it adds a number to the names
                pair.refuse(f"there is no geom '{min(map(str, missing))}'; {PART}")

    def default(self, element, parent):
        name = element.get("class", "main")
        for kind, classes in self.classes.items():
            classes[name] = Surface(other=classes[parent])
            for child in (c for c in element.children if c.tag == kind):
                classes[name].state(child)
        for child in (c for c in element.children if c.tag == "default"):
            self.default(child, name)

    def of(self, element, otherwise):
        name, classes = element.get("class", otherwise), self.classes[element.tag]
        if name not in classes:
            element.refuse(f"unknown default class '{name}'")
        stated = any(element.get(key) is not None for key in ("friction", *FLAGS))
        return Surface(other=classes[name]).state(element) if stated else classes[name]

    def flex(self, flex):
        """Its <contact> is like a geom without a class on a body of its own."""
        contact = flex.child("contact") or flex
        contact.attributes["name"] = flex.get("name")
        self.names.append(None)
        self.parents.append(0)
        self.welds.append(len(self.welds))
        self.geoms.append(Geom(contact, Surface(DEFAULT).state(contact), len(self.welds) - 1))

    def body(self, element, childclass, body):
        for child in element.children:
            within = child.get("childclass", childclass)
            if child.tag == "pair":
                self.pairs.append((child, self.of(child, childclass)))
            elif child.tag == "geom":
                self.geoms.append(Geom(child, self.of(child, childclass), body))
            elif child.tag == "body":
                self.names.append(child.get("name"))
                self.parents.append(self.welds[body])
                self.welds.append(len(self.welds) if moves(child) else self.welds[body])
                self.body(child, within, len(self.welds) - 1)
            elif child.tag in ("frame", "replicate"):
                for _ in range(int(child.numbers("count")[0]) if child.tag == "replicate" else 1):
                    self.body(child, within, body)
            elif child.tag == "flexcomp":
                self.flex(child)
            elif child.tag in ("attach", "composite"):
                child.refuse("not read: save the compiled model (mujoco.mj_saveLastXML) and read that")

    def meet(self, *geoms):
        """Whether two geoms, each as its body and name, may touch without a pair."""
        (one, other), names = zip(*geoms)
        if frozenset(names) in self.paired:
            return False
        a, b = self.welds[one], self.welds[other]
        related = self.filters_parents and a and b and (a == self.parents[b] or b == self.parents[a])
        return a != b and not related and frozenset((self.names[one], self.names[other])) not in self.excludes


def moves(body):
    """Whether a body has a joint of its own."""
    return any(c.tag in ("joint", "freejoint") or c.tag == "frame" and moves(c) for c in body.children)


def lint_mjcf(root, rows):
    scene = Mjcf(root)
    groups, kinds = defaultdict(list), defaultdict(list)  # alike geoms; torsional numbers by their flags
    for geom in scene.geoms:
        s = geom.surface
        kind = (s.condim, s.priority, s.contype, s.conaffinity)
        groups[(id(s.at or s.condim_at), s.friction, kind)].append(geom)
        kinds[kind].append((s.friction[1], (geom.body, geom.element.get("name") or ""), s.at is None))
    for numbers in kinds.values():
        numbers[:] = sorted(set(numbers))
    torsion = any(s.condim > 3 for _, s in scene.pairs) or any(k[0] > 3 and (k[2] or k[3]) for k in kinds)
    if torsion and not scene.off and len(scene.names) > 1:
        lint_options(root, scene.options, rows)
    for members in groups.values():
        s = members[0].surface
        if s.at or s.condim > 3:
            lint_geoms(scene, members, kinds, torsion, rows)
    turning = {geom.element.get("name") for geom in scene.geoms if geom.surface.condim > 3}
    for pair, s in scene.pairs:
        lint_pair(pair, s, not s.at and s.condim < 4 and bool(turning & {pair.get("geom1"), pair.get("geom2")}), rows)
    for row in rows.found if scene.off else ():
        row.verdict, row.acts = "dead", ()
        row.note = f'<flag {scene.off}="disable"/>: nothing touches'


def lint_options(root, options, rows):
    """What the solver's options, or their defaults, do to contacts with torsion."""
    stated = [options[key] for key in ("cone", "impratio", "noslip_iterations") if key in options]
    impratio, noslip = (options[key].numbers(key)[0] if key in options else default
                        for key, default in (("impratio", 1.0), ("noslip_iterations", 0.0)))
    cone, note = options["cone"].get("cone") if "cone" in options else "", ""
    if cone not in ("", "pyramidal", "elliptic"):
        options["cone"].refuse(f"cone: got '{cone}', expected elliptic or pyramidal")
    if cone != "elliptic":
        note = f"a pyramidal cone{', the default' * (not cone)}: "
        note += f"{'friction of a mixed slip falls, and ' * (impratio > 1)}a held object turns"
    elif noslip < 1 and impratio < 1000:
        note = "without noslip_iterations a held object turns"
    if note:
        note += '; write cone="elliptic" impratio="10" noslip_iterations="3"'
        rows.add((stated or [root])[0], "option", "mujoco.impratio", impratio, verdict="creeps", note=note)


def lint_geoms(scene, members, kinds, torsion, rows):
    """Geoms that say the same."""
    s = members[0].surface
    own = {(geom.body, geom.element.get("name") or "") for geom in members}
    number, meets = s.friction[1], []
    for (condim, priority, contype, conaffinity), numbers in kinds.items():
        if contype & s.conaffinity or s.contype & conaffinity:
            # Of each kind the smallest and the largest number that they meet: if one of the two loses, or wins, all do.
            for ordered in (numbers, reversed(numbers)):
                meets += next(([(condim, priority, other, default)] for other, geom, default in ordered
                               if any(scene.meet(one, geom) for one in own)), [])
    # The geom of the higher priority says condim and friction; of two alike the larger counts.
    turn = [m for m in meets
            if (max(m[0], s.condim) if m[1] == s.priority else m[0] if m[1] > s.priority else s.condim) > 3]
    above = [m[1:3] for m in turn if m[1] > s.priority]
    larger = [m[2:] for m in turn if m[1] == s.priority and m[2] > number]
    counts = len(turn) > len(above) + len(larger)
    verdict, note, acts, idle = "", "" if s.at else "the default, not written", (), False
    if not meets and frozenset().union(*scene.paired).issuperset(name for _, name in own):
        verdict, note = "note", "the numbers of its pairs count"
    elif not (s.contype or s.conaffinity):
        verdict, note = "no contact", "contype and conaffinity 0"
    elif not torsion:
        verdict, note = "unused", "no geom or pair here has condim 4 or 6"
    elif not turn and (meets or s.condim < 4):
        verdict, note = "unused", "no contact of it has condim 4 or 6"
    elif above and not counts and not larger:
        verdict, note = "note", f"beside geoms of priority {max(above)[0]}: their numbers count"
        acts = [other for _, other in above]
        idle = bool(s.at) and any(m not in turn and m[1] <= s.priority for m in meets)
    elif larger:
        rival, default = max(larger)
        verdict = "" if counts else "hidden" if s.at else "note"
        acts = [number] * counts + [rival] * (verdict != "hidden")
        note = f"beside {rival:g}{', a default,' * default} the larger counts"
        note += f'; give priority="{s.priority + 1}" or a pair'
    elif number < DEFAULT[1] and s.priority == 0:
        note = f"beside a geom with the default, {DEFAULT[1]}, the larger counts"
    what, *names = dict.fromkeys(f"geom {e.get('name') or e.get('class') or ''}".strip()
                                 for e in (geom.element for geom in members))
    rows.add(s.at or s.condim_at, what, "mujoco.torsional", number, s.friction[0], (), verdict, note, len(members),
             acts=acts, idle=idle, names=names)


def lint_pair(pair, s, geoms_turn, rows):
    """`geoms_turn`: a geom of the pair has torsion, the pair says nothing."""
    slide, second, torsional, *_ = s.friction
    what, verdict, note = f"pair {pair.get('geom1')} {pair.get('geom2')}", "", ""
    if second * ANISOTROPY < slide:
        verdict = "geom order"
        note = (f"a pair has two sliding numbers first: along y it holds {second:g}; "
                f'write friction="{slide:g} {slide:g} {second:g} {torsional:g} {torsional:g}"')
    elif not (s.at or s.condim > 3 or geoms_turn):
        return
    elif s.condim < 4:
        verdict = "unused" if s.condim_at else "dead"
        note = f"the pair has condim {s.condim}" + ", the default, whatever its geoms have" * (not s.condim_at)
    at = (s.friction_at if verdict == "geom order" else s.at) or s.condim_at or pair
    rows.add(at, what, "mujoco.pair.torsional", torsional, slide, (), verdict, note)


def lint_contact(link, key, rows):
    """Bullet reads the first <contact> of a link: attributes (`key`: "value") in a URDF, text in SDF."""
    contact = link.child("contact")
    found = {c.tag: c for c in reversed(contact.children)} if contact else {}
    if "spinning_friction" in found:
        value = {tag: found[tag].numbers(key)[0] for tag in found if re.match("(later|spinn|roll).+_friction", tag)}
        rolls = value.get("rolling_friction", 0) > 0
        rows.add(found["spinning_friction"], f"link {link.get('name')}", "bullet.spinning_friction",
                 value["spinning_friction"], value.get("lateral_friction", 0.5),
                 note="" if rolls else "two rigid bodies (useMaximalCoordinates) also need rolling_friction > 0")


def lint_urdf(root, rows):
    links = [link.get("name") for link in root.every("link")]
    for link in root.every("link"):
        lint_contact(link, "value", rows)
    for gazebo in root.every("gazebo"):
        if links and gazebo.get("reference", links[0]) not in links:
            continue
        for mu in (c for c in gazebo.children if c.tag in ("mu1", "mu2")):
            rows.add(mu, f"gazebo {gazebo.get('reference')}", "gazebo.mu" + "2" * (mu.tag == "mu2"), mu.number(),
                     verdict="no moment")
        lint_sdf(gazebo, rows)


def engine_of(root):
    """The physics engine that an SDF file names."""
    for plugin in root.every("plugin"):
        if "physics-system" in plugin.get("filename", ""):  # gz-sim's, for which the type of <physics> is nothing
            engine = plugin.child("engine", "filename")
            return engine.text.strip() if engine else "gz-sim's default, DART,"
    physics = sorted(root.every("physics"), key=lambda one: one.get("default") not in ("1", "true"))
    return physics[0].get("type", "ode") if physics else "ode"


class Collision:
    """What a collision of SDF says."""

    def __init__(self, element, link, model, length, rows):
        friction = element.child("surface", "friction")
        torsional = friction and friction.child("torsional")
        at = self.at = {c.tag: c for c in reversed(torsional.children)} if torsional else {}
        name = f"{link.get('name') or link.get('reference', '')} {element.get('name', '')}"
        self.model, self.what = model, f"collision {name.strip()}".strip()
        self.patch = "use_patch_radius" not in at or at["use_patch_radius"].text.strip().lower() in ("1", "true")
        self.coefficient = at["coefficient"].numbers()[0] if "coefficient" in at else 1.0
        self.radius = at["patch_radius"].numbers()[0] if self.patch and "patch_radius" in at and not length else 0.0
        sliding = ("bullet", "friction") if length else ("ode", "mu")
        sliding = friction and friction.child(*sliding) or link.child("mu1")
        self.mu = rows.mu or (sliding.number() if sliding else 1.0)


def lint_sdf(root, rows):
    for part in root.every("include"):
        uri = part.child("uri")
        rows.not_read(part, f"<include> of {uri.text.strip() if uri else '?'} is not read: check that file too")
    rows.engine, found = engine_of(root), []
    length = "bullet-featherstone" in rows.engine  # which has a surface for each link, that of its first collision
    for model in [m for top in (root, *root.every("world")) for m in top.children if m.tag == "model"] or [root]:
        for link in model.every("link") or [model]:
            if link.tag == "link":
                lint_contact(link, None, rows)
            if length or rows.engine == "ode":
                collisions = [c for c in link.children if c.tag == "collision"][:1 if length else None]
                found += [Collision(c, link, model, length, rows) for c in collisions]
    for one in found:
        others = [other for other in found if other.model is not one.model]
        if not length:
            lint_patch(one, others, rows)
        elif "coefficient" in one.at:
            acts = {one.coefficient * other.mu + other.coefficient * one.mu for other in others}
            rows.add(one.at["coefficient"], one.what, "gz-sim-bullet.coefficient", one.coefficient, one.mu, acts=acts,
                     note="a length, to which the other body's is added: 1 m if not written")


def lint_patch(one, others, rows):
    """Of ODE in Gazebo classic, where the surface radii act unless both surfaces say use_patch_radius."""
    alike = [other for other in others if one.patch and other.patch]
    mixed = not one.patch or len(alike) < len(others)
    beside = [f"coefficient={one.coefficient}"]
    radii = {*["patch_radius"] * one.patch, *["surface_radius"] * mixed} & one.at.keys()
    if not radii and "coefficient" in one.at:
        rows.add(one.at["coefficient"], one.what, "gazebo.coefficient", one.coefficient, one.mu, verdict="no moment",
                 note="no radius here: the other surface's counts")
    if "patch_radius" in radii:
        note = f"with coefficient {one.coefficient:g}" + ", the default" * ("coefficient" not in one.at)
        note += f"; write mu, {one.mu:g}" * (one.coefficient != one.mu)
        # As a radius with this coefficient.
        acts = {max(one.radius, other.radius) * min(1, other.coefficient / (one.coefficient or math.inf))
                for other in alike if one.radius or other.radius}
        note += "; beside another surface: larger radius, smaller coefficient" * bool(acts - {one.radius})
        note += "; beside use_patch_radius false the surface radii act" * mixed
        rows.add(one.at["patch_radius"], one.what, "gazebo.patch_radius", one.radius, one.mu, beside,
                 "hidden" * (mixed and not alike), note, acts=acts)
    if "surface_radius" in radii:
        note = "lever sqrt(value depth): at 0.1 mm; 1/value of two surfaces adds"
        rows.add(one.at["surface_radius"], one.what, "gazebo.surface_radius", one.at["surface_radius"].numbers()[0],
                 one.mu, [*beside, "use_patch_radius=0"], "note", note)


def lint_usda(root, rows):
    text, number = Path(root.file).read_text(encoding="utf-8", errors="replace"), r"\s*=\s*([-+]?\.?\d[-+.\deE]*)"
    unit = re.search(r"^[\s(]*metersPerUnit" + number, text, re.M)
    metre = float(unit[1]) if unit else 0.01
    frictions = set(map(float, re.findall("physics:dynamicFriction" + number, text)))
    mu = min(frictions) if len(frictions) == 1 else None
    condim = max(map(int, re.findall(r"mjc:condim\s*=\s*(\d)", text)), default=3)
    prim = ""
    for line, row in enumerate(text.splitlines(), 1):
        named = re.match(r'\s*(?:def|over|class)\s+(?:\w+\s+)?"([^"]*)"', row)
        prim = named[1] if named else prim
        at = Element(f"prim {prim}", {}, root.file, line)
        part = re.search(r"\b(subLayers|references|payload)\s*=", row)
        if part:
            rows.not_read(at, f"{part[1]} are not read: flatten the stage first, usdcat --flatten -o FILE.usda")
        found = re.match(r"\s*(?:custom\s+|uniform\s+)*(?:float|double|half)\s+([\w:]+)(\.timeSamples)?", row)
        if not found or found[1] not in USD:
            continue
        at.text = re.split("[(#]", row.partition("=")[2])[0]
        notes = ["mu 1 assumed, because the materials differ: give --mu"] * (len(frictions) > 1 and not rows.mu)
        if metre != 1:
            notes.append(f"a unit is {metre:g} m" + ", for want of metersPerUnit" * (unit is None))
        if found[1].startswith("newton") and condim < 4:
            notes.append("SolverMuJoCo needs mjc:condim 4")
        grows = found[1].endswith(":torsionalPatchRadius")
        notes += ["lever sqrt(value depth): at 0.1 mm"] * grows
        rows.add(at, at.tag, found[1], at.numbers()[0], mu, (), "note" * grows, "; ".join(notes), metre=metre)


def unread(element, what=""):
    """The numbers of friction with a moment that no reader took, and what they belong to."""
    for child in element.children:
        name = f"{what} {child.get('name') or child.get('reference') or ''}".strip()
        if not child.is_read and (child.tag in ("geom", "pair") and child.get("friction") is not None or child.tag in (
                "spinning_friction", "torsional_friction") or element.tag == "torsional" and child.tag in TORSIONAL):
            yield child, f"{child.tag} {name}".strip()
        yield from unread(child, name)


READERS = {"usda": lint_usda, "mujoco": lint_mjcf, "robot": lint_urdf, "sdf": lint_sdf}


def lint(path, rows):
    head = Path(path).read_bytes()[:4096]
    if b"\0" in head or head.startswith((b"PXR-USDC", b"PK")) or str(path).endswith((".xacro", ".erb")):
        raise ValueError(
            f"{path}: not plain XML or USDA; convert it first: usdcat {path} -o FILE.usda, or xacro {path} > FILE.urdf")
    begin = head.decode("utf-8", "replace").lstrip("\ufeff \t\r\n")
    if not begin.startswith(("<", "#usda")):
        raise ValueError(f"{path}: begins with {begin[:20]!r}, expected MJCF, URDF, SDF or USDA")
    root = Element("usda", {}, path, 1) if begin.startswith("#usda") else read_xml(path)
    if root.tag not in READERS:
        root.refuse(PART + "; expected <mujoco>, <robot>, <sdf> or #usda")
    READERS[root.tag](root, rows)
    for element, what in unread(root):
        if root.tag == "mujoco":
            element.refuse(f"MuJoCo does not read it here; {PART}")
        parameter = f"gazebo.{element.tag}" if element.tag in TORSIONAL else "bullet.spinning_friction"
        value = element.number()
        rows.add(element, what, parameter, value, verdict="dead" if value else "no moment",
                 note=f"{rows.engine} does not read it here")
    if not rows.found:
        rows.not_read(root, "no number of friction with a moment is written here")


def pattern(text):
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"got '{text}', expected a regular expression: {error}") from None


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="limitcurve.lint", formatter_class=argparse.RawDescriptionHelpFormatter,
        description=f"{__doc__}\n\nVerdicts, with the exit status; {ERROR} if the file cannot be read:\n{verdicts()}")
    parser.add_argument("file")
    parser.add_argument("--law", help="pressure law of the contact (default hertz)")
    parser.add_argument("--radius-law", help="the contact radius, for example constant:a=0.005; with --load")
    parser.add_argument("--load", type=float, help="normal load [N]")
    parser.add_argument("--patch", help="a contact that is not round, instead of law, radius law and load")
    parser.add_argument("--mu", type=float, help="friction coefficient, instead of the file's")
    parser.add_argument("--only", default="", type=pattern, metavar="REGEX",
                        help="only geoms, links and prims whose column `what` matches")
    given = parser.parse_args(arguments)
    law = given.law or "hertz"
    how = {"law": law, "radius_law": given.radius_law, "load": given.load} if given.radius_law else {}
    how = {"patch": given.patch} if given.patch else how
    rows = Rows(law, given.mu, how)
    try:
        if given.patch and not given.law is given.radius_law is given.load is None:
            raise ValueError("--law, --radius-law and --load have no effect with --patch: leave them out")
        if not given.radius_law and given.load is not None:
            raise ValueError("--load has no effect without --radius-law")
        if given.mu is not None and not given.mu > 0:
            raise ValueError(f"--mu: got {given.mu:g}, expected > 0")
        lint(given.file, rows)
        found = rows.finish(given.only)
        for note in rows.notes:
            print(f"limitcurve.lint: note: {note}", file=sys.stderr)
        cells = [["" if value != value else f"{value:.6g}" if isinstance(value, float) else value
                  for value in astuple(row)[:len(COLUMNS)]] for row in found]
        csv.writer(sys.stdout, lineterminator="\n").writerows([COLUMNS, *cells])
        sys.stdout.flush()
    except BrokenPipeError:  # the reader has seen enough: the verdict stands
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except (ValueError, OSError) as error:
        print(f"limitcurve.lint: error: {error}", file=sys.stderr)
        return ERROR
    return max((VERDICTS[row.verdict][0] for row in found), default=0)


if __name__ == "__main__":
    sys.exit(main())
