# SPDX-License-Identifier: MIT
"""limitcurve.lint: small scenes in the forms found in public, and MuJoCo's own reading of ten."""

import csv
import io
import os
import subprocess
import sys

import numpy as np
import pytest
from limitcurve import lint

FINGERTIP = ["--radius-law", "constant:a=0.005", "--load", "3"]
BALL = '<body name="{0}"><freejoint/><geom name="{0}" size="0.1" {1}/></body>'


def mjcf(body, before="", after=""):
    option = "" if "<option" in before else '<option cone="elliptic" noslip_iterations="3"/>'
    return (f'<mujoco>{option}{before}<worldbody><geom name="floor" type="plane" size="1 1 '
            f'1"/>{body}</worldbody>{after}</mujoco>')


FEATHER = """<physics type="ode"/><plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"><engine>
    <filename>gz-physics-bullet-featherstone-plugin</filename></engine></plugin>"""


def sdf(*torsional, world=""):
    """A model for each surface."""
    models = [f'<model><link name="l"><collision name="tip"><surface><friction><ode><mu>0.8</mu></ode>{one}</friction>'
              "</surface></collision></link></model>"
              for one in (f"<torsional>{one}</torsional>" * bool(one) for one in torsional)]
    return f"<sdf>{world}{''.join(models)}</sdf>"


def urdf(contact):
    return f'<robot name="r"><link name="tip"><contact>{contact}</contact></link></robot>'


def usda(body, unit="metersPerUnit = 1"):
    return (f'#usda 1.0\n(\n    {unit}\n)\ndef Material "rubber"\n{{\n    float physics:dynamicFriction = 0.8\n    '
            f'{body}\n}}\n')


FIRST = 'priority="1"'


def tip(friction, more=""):
    return BALL.format("tip", f'friction="{friction}" condim="4" {more}')


TIP = 'friction="0.8 0.0019" condim="4"'
PATCH = "<coefficient>0.8</coefficient><patch_radius>0.005</patch_radius>"
TORSIONAL = f"<torsional>{PATCH}</torsional>"
PALM = f'friction="1 0.05" condim="4" {FIRST}'
# Name, text, the verdicts of its rows without and with a fingertip of 5 mm (μ_r = 0.002356 m under μ = 0.8).
SCENES = [
    ("torsion_off.xml", mjcf(BALL.format("tip", 'friction="0.8 0.1 0.0001"')), ["unused"], ["unused"]),
    ("too_large.xml", mjcf(tip("0.8 0.1 0.0001")), ["note"], ["too large"]),
    ("bare_pair.xml",
     mjcf(tip("0.8 0.0024", FIRST), "",
          '<contact><pair geom1="tip" geom2="floor"/></contact>'), ["note", "dead"], ["note", "dead"]),
    ("zero.xml", mjcf(tip("0.8 0", FIRST)), ["no moment"], ["too small"]),
    ("order.xml",
     mjcf(BALL.format("tip", ""), "",
          '<contact><pair geom1="tip" geom2="floor" condim="6" friction="0.2 0.005 0.0001"/></contact>'),
     ["geom order"], ["geom order"]),
    ("two_fingers.xml", mjcf(BALL.format("a", TIP) + BALL.format("b", TIP)), ["note"] * 2, ["hidden"] * 2),
    ("palm.xml",
     mjcf(f'<body><freejoint/><geom {PALM}/><body><joint/><geom {TIP} {FIRST}/></body></body>'), ["note"] * 2,
     ["too large", "ok"]),
    ("excluded.xml",
     mjcf(BALL.format("palm", PALM) + tip("0.8 0.0019", FIRST), "",
          '<contact><exclude body1="palm" body2="tip"/></contact>'), ["note"] * 2, ["too large", "ok"]),
    ("impratio.xml",
     mjcf(tip("0.8 0.0019", FIRST), '<option impratio="10"/>'), ["creeps", "note"], ["creeps", "ok"]),
    ("bare.xml", mjcf(tip("0.8 1e-300", FIRST), "<option/>"), ["creeps", "note"], ["creeps", "too small"]),
    ("no_contacts.xml", mjcf(tip("0.8 0.0024", FIRST), '<option><flag contact="disable"/></option>'), ["dead"],
     ["dead"]),
    ("holds.xml",
     mjcf(tip("0.8 0.0019", FIRST), '<option impratio="10" cone="elliptic" noslip_iterations="3"/>'),
     ["note"], ["ok"]),
    ("alike.xml", mjcf(BALL.format("tip", ""),
                       '<default><geom friction="0.8 0.0024" condim="4"/></default>'), ["note"], ["ok"]),
    ("visual.xml", mjcf(BALL.format("tip", 'friction="1 0.3" contype="0" conaffinity="0" condim="4"')), ["no contact"],
     ["no contact"]),
    ("bullet.urdf", urdf('<lateral_friction value="0.8"/><spinning_friction value="0.1"/>'), ["note"], ["too large"]),
    ("gazebo.urdf", '<robot name="r"><gazebo reference="tip"><mu1 value="0.8"/><mu2>0.8</mu2></gazebo></robot>',
     ["no moment"] * 2, ["no moment"] * 2),
    ("default.sdf", "\n<?xml version='1.0'?><!-- a -- b -->" + sdf("<patch_radius>0.005</patch_radius>"), ["note"],
     ["ok"]),
    ("off.sdf",
     sdf("<use_patch_radius>0</use_patch_radius><patch_radius>0.005</patch_radius><surface_radius>0.02</surface_radius>"
         ), ["note", "dead"], ["note", "dead"]),
    ("dart.sdf", sdf(PATCH, world='<physics type="dart"/>'),
     ["dead", "dead"], ["dead", "dead"]),
    ("feather.sdf", sdf("<coefficient>0.002356</coefficient>", world=FEATHER), ["note"], ["ok"]),
    ("plain.sdf", sdf("<coefficient>0.0024</coefficient>", "", world=FEATHER), ["note"], ["hidden"]),
    ("later.sdf", sdf("<coefficient>0.002</coefficient>", world=FEATHER).replace(
        "</link>", f"<collision><surface><friction>{TORSIONAL}</friction></surface></collision></link>"),
     ["note", "dead", "dead"], ["ok", "dead", "dead"]),
    ("larger.sdf", sdf(PATCH, PATCH.replace("0.005", "0.5")), ["note"] * 2, ["hidden", "too large"]),
    ("smaller.sdf", sdf(PATCH, PATCH.replace("0.8", "0.01")), ["note"] * 2, ["hidden", "too small"]),
    ("both.sdf", sdf(PATCH, "<use_patch_radius>0</use_patch_radius>"), ["hidden"], ["hidden"]),
    ("surfaces.sdf", sdf(PATCH + "<surface_radius>0.3</surface_radius>",
                         "<use_patch_radius>0</use_patch_radius><surface_radius>0.3</surface_radius>", PATCH),
     ["note"] * 4, ["ok", "note", "note", "ok"]),
    ("neutral.sdf", sdf(PATCH, "<patch_radius>0</patch_radius>", ""), ["note"] * 2, ["ok"] * 2),
    ("misplaced.sdf", sdf("").replace("</ode>", f"{TORSIONAL}</ode>"), ["dead"] * 2, ["dead"] * 2),
    ("nowhere.urdf", f'<robot><link name="tip"/><gazebo reference="tap"><collision><surface><friction>{TORSIONAL}'
     "</friction></surface></collision></gazebo></robot>", ["dead"] * 2, ["dead"] * 2),
    ("bullet.sdf", "<sdf><link><contact><spinning_friction>0.1</spinning_friction></contact></link></sdf>", ["note"],
     ["too large"]),
    ("flex.xml", mjcf(tip("0.8 0.0024"), "", '<deformable><flex name="pad"><contact condim="4" friction="0.8 2.5"/>'
                      "</flex></deformable>"), ["hidden", "note"], ["hidden", "too large"]),
    ("right_by_priority.xml", mjcf(tip("0.8 0.0024", f'{FIRST} conaffinity="3"') +
                                   BALL.format("thing", f'{TIP} contype="2" conaffinity="0"')),
     ["note"] * 2, ["ok", "note"]),
    ("forgotten.xml", mjcf(tip("0.8 0.0024", FIRST) + BALL.format("finger2", 'friction="0.8 0.0024" condim="3"') +
                           BALL.format("thing", 'condim="3"')), ["note"] * 2, ["ok", "unused"]),
    ("newton.usda", usda("float newton:torsionalFriction = 0.25"), ["note"], ["too large"]),
    ("physx.usda", usda("float physxCollision:minTorsionalPatchRadius = 0.3",
                        "metersPerUnit = 0.01"), ["note"], ["ok"]),
    ("one_line.usda", usda("float physxCollision:minTorsionalPatchRadius = 0.003").replace("(\n    ", "( "),
     ["note"], ["ok"]),
]


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    """The rows, standard error and exit status of a call on files that are written first."""
    monkeypatch.chdir(tmp_path)

    def call(files, *arguments):
        for name, text in files.items():
            (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        status = lint.main([next(iter(files)), *arguments])
        told = capsys.readouterr()
        return list(csv.DictReader(io.StringIO(told.out))), told.err, status

    return call


@pytest.mark.parametrize(("name", "text", "alone", "fingertip"), SCENES, ids=[scene[0] for scene in SCENES])
def test_verdicts(run, name, text, alone, fingertip):
    for arguments, verdicts in (((), alone), (FINGERTIP, fingertip)):
        found, told, status = run({name: text}, *arguments)
        assert [row["verdict"] for row in found] == verdicts, (found, told)
        assert status == int(bool({"dead", "unused", "hidden", "geom order", "too large", "too small"} & {*verdicts}))


def test_meaning_and_what_to_write(run):
    (row, ), _, _ = run({"a.usda": usda("float physxCollision:minTorsionalPatchRadius = 0.3", "metersPerUnit = 0.01")},
                        *FINGERTIP)
    assert float(row["moment_per_load"]) == pytest.approx(0.8 * 0.003)
    assert float(row["write"]) == pytest.approx(0.2945, rel=1e-3)  # m0 a, in centimetres
    reference = ('<robot name="r"><gazebo reference="l2"><mu1>0.8</mu1><collision><surface><friction><torsional>'
                 "<patch_radius>0.005</patch_radius></torsional></friction></surface></collision></gazebo></robot>")
    (_, row), _, _ = run({"a.urdf": reference}, *FINGERTIP, "--only", "l2")
    assert float(row["moment_per_load"]) == pytest.approx(1.25 * 0.002356, rel=1e-3) and "write mu, 0.8" in row["note"]
    (row,), _, _ = run({"a.sdf": sdf("<coefficient>10</coefficient><patch_radius>0.02</patch_radius>")})
    assert float(row["moment_per_load"]) == pytest.approx(0.11781, rel=1e-4)
    found = run({"a.sdf": sdf("<use_patch_radius>0</use_patch_radius><surface_radius>0.04</surface_radius>")})[0]
    assert float(found[0]["moment_per_load"]) == pytest.approx(3 * np.pi / 16 * 0.002, rel=1e-5)
    two = usda("float newton:torsionalFriction = 0.002\n    float physics:dynamicFriction = {}\n    int mjc:condim = 4")
    for other, mu, note in (("0.80", 0.8, ""), ("0.4", 1.0, "mu 1 assumed")):
        (row,), _, _ = run({"a.usda": two.replace("{}", other)})
        assert float(row["radius"]) == pytest.approx(0.002 / mu * 16 / (3 * np.pi), rel=1e-5)
        assert row["note"].startswith(note) and bool(row["note"]) == bool(note)
    patch = ["--patch", "rectangle:x=0.02,y=0.01,mx=0.8,my=1.2"]  # of two frictions: for MuJoCo only a pair has them
    (row,), _, _ = run({"a.xml": mjcf(tip("0.8 0.0024", FIRST))}, *patch)
    assert float(row["write"]) > 0
    (row,), told, _ = run({"a.urdf": urdf('<spinning_friction value="0.0024"/>')}, *patch)
    assert row["write"] == "" and "bullet has one friction coefficient" in told
    scene = mjcf("".join(BALL.format(name, 'class="pad"') for name in ("left", "right")),
                 '<default><default class="pad"><geom condim="4" friction="1 0.1"/></default></default>')
    (row,), _, _ = run({"a.xml": scene}, "--only", "right")
    assert (row["what"], row["count"]) == ("geom right", "2")
    scene = mjcf(
        tip("0.8 0.1") + BALL.format("foot", 'friction="1 0.1" condim="4"'))
    (row,), _, _ = run({"a.xml": scene}, *FINGERTIP, "--only", "tip")
    assert float(row["write"]) == pytest.approx(0.002356, rel=1e-3)
    lines = {
        row["line"]: row["count"]
        for row in run({
            "a.xml": '<mujoco>\n<default>\n<geom friction="1 0.1" '
                     'condim="4"/></default><worldbody>\n'
                     '<geom/><replicate count="3"><geom/></replicate></worldbody></mujoco>'
        })[0]
    }
    assert lines == {"3": "4"}  # where the class writes it


@pytest.mark.parametrize(("name", "text", "told"),
                         [("a.xacro", "<robot/>", "xacro"),
                          ("a.urdf", urdf('<spinning_friction value="${mu}"/>'), "xacro"),
                          ("a.usda", b"PXR-USDC\0", "usdcat"), ("a.xml", "<mujocoinclude/>", "part of a scene"),
                          ("a.xml", "<mujoco>", "not well-formed"), ("a.wbt", "#VRML_SIM R2023b utf8", "#VRML_SIM"),
                          ("a.csv", "load,force\n1,2\n", "expected MJCF"), ("a.json", "", "expected MJCF"),
                          ("a.xml", mjcf("", '<include file="b.xml"/>'), "no such file"),
                          ("a.xml", mjcf(BALL.format("tip", 'class="soft"')), "unknown default class"),
                          ("a.xml", mjcf(BALL.format("tip", 'friction="1 nan"')), "a.xml:1"),
                          ("a.xml", mjcf(BALL.format("tip", 'friction="1 -0.1"')), "a.xml:1"),
                          ("a.xml", mjcf("", '<option><flag override="enable"/></option>'), "override"),
                          ("a.usda", usda("float newton:torsionalFriction.timeSamples = {"), "expected finite numbers"),
                          ("a.usda", usda("float newton:torsionalFriction = 1").replace("0.8", "-0.8"), "a.usda:8: "),
                          ("a.xml", mjcf(BALL.format("tip", 'friction="-0.8 0.05 0"')), "a.xml:1: <geom>"),
                          ("a.xml", mjcf(tip("1 1").replace('"4"', '"4.0"')), 'got condim="4.0"'),
                          ("a.xml", mjcf(tip("1 1"), '<option cone="Elliptic"/>'), "elliptic or pyramidal"),
                          ("a.xml", mjcf("", "", '<contact><pair geom1="floor" geom2="b"/></contact>'), "no geom 'b'"),
                          ("a.xml", f"<mujoco>{tip('1 1')}</mujoco>", "part of a scene"),
                          ("a.xml", f'<!DOCTYPE mujoco [<!ENTITY f "1">]>{mjcf("")}', "a.xml:1: <!ENTITY>"),
                          ("a.xml", mjcf('<composite type="cable"/>'), "mj_saveLastXML")])
def test_what_cannot_be_read_is_one_line(run, name, text, told):
    found, error, status = run({name: text})
    assert (found, status, error.count("\n")) == ([], 2, 1)
    assert told in error


PAIRS = ('<default><pair condim="4"/></default>',
         '<contact><pair geom1="a" geom2="b" friction="0.3"/><pair geom1="a" geom2="floor" condim="6"/>'
         '<pair geom1="b" geom2="floor" friction="1 2 3 4 5"/></contact>')
MUJOCO = [
    {
        "a.xml": mjcf(BALL.format("a", 'friction="0.5"') +
                      f"""<replicate count="3">{BALL.format("b", 'condim="6" priority="2"')}</replicate>""")
    },
    {
        "a.xml": mjcf(
            BALL.format("a", 'class="x"') + BALL.format("b", 'class="y" friction="2"'),
            '<default><geom friction="1 2 3"/><default class="x"><geom condim="4"/><default class="y"><geom '
            'friction="4 5"/></default></default></default>'
        )
    },
    {
        "a.xml": mjcf('<body childclass="tip"><geom size="1"/><body><geom size="1"/></body></body>',
                      '<include file="d.xml"/>'),
        "d.xml": '<mujocoinclude><default><default class="tip"><geom friction="0.1 '
                 '0.2"/></default></default></mujocoinclude>'
    },
    {
        "a.xml": mjcf('<frame childclass="tip"><geom size="1"/></frame><geom size="1"/>',
                      '<default><default class="tip"><geom condim="6"/></default></default>')
    },
    {
        "a.xml": mjcf(BALL.format("a", "") + BALL.format("b", ""), *PAIRS)
    },
    {
        "a.xml": mjcf(
            BALL.format("a", 'class="t"'),
            '<default><default class="t"><geom condim="4"/></default></default><default><geom friction="9 8 '
            '7"/></default>'
        )
    },
    {
        "a.xml": mjcf('<body childclass="v"><geom size="1" contype="0"/><geom class="main" size="1"/></body>',
                      '<default><default class="v"><geom conaffinity="0" priority="3"/></default></default>')
    },
    {
        "a.xml": mjcf(BALL.format("a", 'friction="0.5\n 0.25 \n0.125"'))
    },
    {
        "a.xml": mjcf('<include file="b.xml"/>'),
        "b.xml": "<mujocoinclude>" + BALL.format("a", 'friction="0.7 0.6"') + "</mujocoinclude>"
    },
    {
        "a.xml": mjcf(
            '<body><geom size="1"/><body childclass="c"><geom size="1"/><geom size="1" friction="3"/></body></body>',
            '<default><geom priority="1"/><default class="c"><geom friction="1 1 1" priority="0"/></default></default>')
    },
]


@pytest.mark.parametrize("files", MUJOCO)
def test_numbers_are_resolved_as_mujoco_does(files, tmp_path):
    mujoco = pytest.importorskip("mujoco")
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    model, scene = mujoco.MjModel.from_xml_path(str(tmp_path / "a.xml")), lint.Mjcf(lint.read_xml(tmp_path / "a.xml"))
    ours = [(*s.friction, s.condim, s.priority, s.contype, s.conaffinity)
            for s in (geom.surface for geom in sorted(scene.geoms, key=lambda geom: geom.body))]
    theirs = np.column_stack(
        [model.geom_friction, model.geom_condim, model.geom_priority, model.geom_contype, model.geom_conaffinity])
    assert np.array_equal(np.array(ours), theirs)
    theirs = sorted(
        (*friction, dim) for friction, dim in zip(model.pair_friction, model.pair_dim))  # MuJoCo sorts them by bodies
    assert sorted((*s.friction, s.condim) for _, s in scene.pairs) == theirs


@pytest.mark.parametrize("seed", range(60))
def test_what_mujocos_contacts_feel(run, seed):
    """Balls in one place, some of them children, some excluded: each verdict from the numbers of MuJoCo's contacts."""
    mujoco = pytest.importorskip("mujoco")
    rng, right = np.random.default_rng(seed), 3 * np.pi / 16 * 0.005
    numbers = iter(0.0012 + 0.002 * rng.permutation(9))

    def geom():
        flags = {"condim": [1, 3, 4, 6], "priority": [0, 0, 1, 2], "contype": [1, 1, 2, 3], "conaffinity": [1, 1, 2, 3]}
        stated = " ".join(f'{name}="{rng.choice(values)}"' for name, values in flags.items() if rng.random() < 0.5)
        return f'<geom size="0.05" friction="1 {next(numbers):.4f}" {stated}/>\n'

    def body(name, within=""):
        joint = ("<freejoint/>" if within else "<joint/>") if rng.random() < 0.8 else ""
        return f'<body name="{name}">{joint}{geom()}{geom() * (rng.random() < 0.5)}'

    bodies = f"{body('a', 'world')}{body('b')}</body></body>{body('c', 'world')}</body>"
    off = '<option><flag filterparent="disable"/></option>' * (rng.random() < 0.3)
    names = rng.choice([*"abc", "world"], 2, replace=False)
    text = f"""<mujoco>{off}<worldbody>\n{geom()}{bodies}</worldbody>
        <contact><exclude body1="{names[0]}" body2="{names[1]}"/></contact></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    felt = {}  # of a number: what acts in its contacts with torsion, and whether by priority
    for contact in data.contact:
        for one, other in (contact.geom, contact.geom[::-1]):
            beside = model.geom_priority[other] > model.geom_priority[one]
            if model.geom_bodyid[one] or model.geom_bodyid[other]:
                felt.setdefault(round(model.geom_friction[one][1], 6), []).extend(
                    [(contact.friction[2], beside)] * (contact.dim > 3))
    for row in run({"a.xml": text}, *FINGERTIP)[0]:
        number = float(row["value"])
        if number not in felt:
            continue
        acts = felt[number]
        least, most = (choose([act for act, _ in acts], default=0) for choose in (min, max))
        expected = ("unused" if not acts else
                    "note" if all(beside for _, beside in acts) and right / 2 <= least and most <= 2 * right else
                    "hidden" if all(act != number for act, _ in acts) else
                    "hidden" if max(act for act, beside in acts if not beside) > 2 * right and
                    number <= 2 * right else
                    "too large" if number > 2 * right else "too small" if number < right / 2 else "ok")
        assert row["verdict"] == expected, (row, text, acts)


def test_what_is_not_read_is_said(run):
    world = '<sdf version="1.9"><world name="w"><include><uri>model://hand</uri></include></world></sdf>'
    assert "model://hand" in run({"a.sdf": world})[1]
    assert "flatten" in run({"a.usda": usda("float newton:torsionalFriction = 0.25", 'subLayers = [@hand.usda@]')})[1]
    found, told, status = run({"a.sdf": sdf("<patch_radius>0.005</patch_radius>")}, "--only", "typ0")
    assert (found, status) == ([], 2) and "collision l tip" in told
    assert "no number" in run({"a.urdf": '<robot name="r"/>'})[1]
    assert "--law" in run({"a.sdf": sdf(PATCH)}, "--patch", "rectangle:x=0.02,y=0.01", "--law", "hertz")[1]
    assert "--radius-law" in run({"a.sdf": sdf(PATCH)}, "--load", "3")[1]


def test_a_closed_pipe_is_no_error(tmp_path):
    path = tmp_path / "a.xml"
    path.write_text(mjcf(tip("0.8 0.0019", FIRST)))
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([sys.executable, "-m", "limitcurve.lint", path], stdout=write, stderr=-1, text=True)
    os.close(write)
    assert (done.returncode, done.stderr) == (0, "")


def test_the_help_has_the_verdicts(capsys):
    with pytest.raises(SystemExit):
        lint.main(["--help"])
    told = capsys.readouterr().out
    assert all(f"  {name:10}  {status}  " in told for name, (status, _) in lint.VERDICTS.items())
