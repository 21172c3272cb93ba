# SPDX-License-Identifier: MIT
"""The functions that return tables give the command line's numbers, to the last bit, and its messages."""

import functools
import os
import pickle
import subprocess
import sys
import warnings

import numpy as np
import limitcurve as lc
import pandas as pd
import pytest

from conftest import SCENE, same


def columns(file):
    """The file as a user would read it, its numbers to the last bit."""
    table = pd.read_csv(file, comment="#", dtype=str)
    return table.map(float)


def words(options):
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        texts = value if isinstance(value, list) and isinstance(value[0], str) else [value]
        for text in texts:
            yield from [option] if text is True else [option, ",".join(map(str, text))] if isinstance(
                text, list) else [option, text]


@pytest.mark.parametrize(("name", "options"), [
    ("validate", {"law": ["hertz", "cone"]}),
    ("validate", {"patch": "rectangle:x=0.02,y=0.01"}),
    ("choose", {"law": "hertz", "tolerance": 0.01}),
    ("choose", {"law": "hertz", "tolerance": 0.01, "scene": True, "mu": 0.6, "loads": [0.5, 2], "stiffness": 1000,
                "twist_stiffness": 0.036}),
    ("translate", {"law": "hertz", "radius_law": "hertz:R=0.008,E=2e5", "mu": 0.6, "load": 2}),
    ("laws", {}),
    ("eval", {"law": "hertz", "c": [0.25, 0.5, np.inf]}),
    ("p-curves", {"law": "hertz", "radius_law": "constant:a=0.005", "mu": 0.5, "loads": [1, 2.5], "points": 5}),
])
def test_tables_are_the_commands(command_line, name, options):
    call = getattr(lc, name, functools.partial(lc.run, name))
    same(call(**options), command_line(name, *words(options)))


def test_fit_of_a_curve_and_of_data(command_line, data):
    same(lc.fit("ellipse", law="cone", criterion="inner"),
         command_line("fit", "ellipse", "--law", "cone", "--criterion", "inner"))
    slips = columns(data / "fit/slips.csv")
    expected = command_line("fit", "ratio", "--data", data / "fit/slips.csv")
    for given in (data / "fit/slips.csv", str(data / "fit/slips.csv"), slips, slips.to_dict("list"),
                  slips.to_records(index=False)):
        same(lc.fit("ratio", given, quiet=True), expected)


def test_what_a_fit_says(data, capfd):
    slips, model = columns(data / "fit/slips.csv"), {"fit_gamma": True, "loss": "cauchy"}
    with pytest.warns(UserWarning, match="far off the curve"):
        fitted = lc.fit("ratio", slips, **model)
    covariance = fitted.covariance
    assert list(fitted) == ["parameter", "value", "std_error", "unit", "note"] and fitted.note == fitted["note"][0]
    assert np.allclose(np.sqrt(np.diag(covariance)), fitted["std_error"], rtol=1e-12) and np.allclose(
        covariance, covariance.T, rtol=1e-12)
    assert any(note.startswith("for replay:") for note in fitted.notes)
    with pytest.warns(UserWarning, match="are the data in millimetres") as caught:
        lc.fit("ratio", {**slips, "moment": 1000 * slips["moment"]})
    assert caught[0].filename == __file__
    residuals = lc.fit("ellipse", slips, quiet=True, residuals=True)
    assert list(residuals) == ["residual", "row"] and residuals.covariance is None
    assert lc.fit("ratio", slips, quiet=True).notes == [] and lc.fit("ellipse", law="hertz").covariance is None
    assert capfd.readouterr().err == ""
    found = lc.run("fit", "ratio", data=slips, covariance=True, quiet=True, **model)
    assert [name for name in found if name.startswith("cov")] == [f"covariance_{name}" for name in fitted["parameter"]]


def test_replay(command_line, data):
    file = data / "traces/slide_twist_load.csv"
    expected = command_line("replay", "--trace", file, "--law", "hertz", *words(SCENE))
    trace = columns(file)
    for given in (file, trace, trace[["time", "x", "y", "z", "twist"]].to_numpy()):
        same(lc.replay(given, "hertz", **SCENE), expected)
    assert {"stick", "slip"} <= set(expected["state"])


def test_a_column_may_have_any_name():
    """A comma in it once made two of it."""
    data = {"load": [1, 2, 4.0], 'radius, "a" [mm]': np.zeros(3), "radius": [1, 2, 5.0]}
    with pytest.raises(ValueError,
                       match=r"^data\['radius'\]\[1\]: column 'radius': got 'inf', expected a finite number > 0$"):
        lc.fit("load", {**data, "radius": [1, np.inf, 5]})
    assert np.array_equal(
        lc.fit("load", data, quiet=True)["value"],
        lc.fit("load", {name: data[name]
                        for name in ("load", "radius")}, quiet=True)["value"])


def test_errors_have_the_command_line_words_and_the_caller_places():
    trace = {"time": [0.0, 1, 2], "x": [0.0, np.nan, 0], "y": np.zeros(3), "z": np.zeros(3), "twist": np.zeros(3)}
    with pytest.raises(ValueError, match=r"^trace\['x'\]\[1\]: .*got 'nan', expected a finite number$"):
        lc.replay(trace, "hertz", **SCENE)
    with pytest.raises(ValueError, match="^law: law 'hertzz': expected one of"):
        lc.validate("hertzz")
    with pytest.raises(ValueError, match="^trace: no column 'y'"):
        lc.replay({name: trace[name] for name in ("time", "x", "z", "twist")}, "hertz", **SCENE)
    with pytest.raises(ValueError, match=r"^data\['force'\]: got 1 numbers, expected 2 as in 'load'$"):
        lc.fit("law", {"load": [1, 2], "force": [1], "moment": [0, 1]})
    with pytest.raises(ValueError, match="expected columns|columns by name"):
        lc.fit("law", 3)
    with pytest.raises(ValueError, match="no subcommand"):
        lc.run("nonsense")


def test_files_of_any_option_may_be_columns(tmp_path):
    """`run` says that files may be columns; once only data, trace and twists could."""
    grip = tmp_path / "grip.csv"
    grip.write_text("time,load\n0,0.5\n0.1,0.4\n")
    from_file = lc.run("pivot", case="exact", material="sandpaper", grip=grip, duration=0.1)
    frame = pd.DataFrame({"time": [0, 0.1], "load": [0.5, 0.4]})
    for columns in (frame.to_dict("list"), frame, frame.to_records(index=False)):
        from_columns = lc.run("pivot", case="exact", material="sandpaper", grip=columns, duration=0.1)
        for name, column in from_file.items():
            np.testing.assert_array_equal(column, from_columns[name])
    c = pd.Series([0.1, 0.5])
    assert lc.run("eval", law="hertz", c=c)["c"].tolist() == c.tolist()  # numbers, not columns


def test_names_of_files_that_are_no_utf_8(tmp_path, data):
    """As on the command line, where a name is bytes."""
    folder = tmp_path / os.fsdecode(b"\xff\xe4")
    folder.mkdir()
    profile = folder / os.fsdecode(b"p\xfc.csv")
    profile.write_text("radius,pressure\n0,1\n1,0.9\n2,0.5\n3,0.1\n")
    law = lc.Law(f"samples:{profile}")
    assert law.name == f"samples:{profile}" and str(profile) in repr(law)
    assert set(lc.validate(law)["law"]) == set(lc.validate(law.name)["law"]) == {law.name}
    lc.Table(law, 1e-3).save(folder / "t.csv")
    assert lc.Table.load(os.fsencode(folder / "t.csv")).law_name == law.name
    with pytest.raises(ValueError, match="^path: the law's name is not UTF-8"):
        lc.Table(law, 1e-3).save(folder / "t.json")
    assert not (folder / "t.json").exists()
    slips = folder / "slips.csv"
    slips.write_bytes((data / "fit/slips.csv").read_bytes())
    assert lc.fit("ratio", slips, quiet=True)["value"].tolist() == lc.fit("ratio", data / "fit/slips.csv",
                                                                          quiet=True)["value"].tolist()
    for call in (lc.Law, lc.Table, lambda text: lc.run("eval", law=text, c=1)):
        with pytest.raises(ValueError, match="cannot read") as caught:
            call(f"samples:{profile}x")
        assert f"{profile}x" in str(caught.value)
    with pytest.raises(RuntimeError, match="cannot write") as caught:
        lc.Table("hertz", 1e-3).save(folder / "none" / "t.csv")
    assert str(folder) in str(caught.value)
    done = subprocess.run([sys.executable, "-m", "limitcurve", "eval", "--law", law.name, "--c", "0"],
                          capture_output=True,
                          check=True)
    assert done.stdout.startswith(b"c,force,moment")


def test_a_reader_that_leaves_ends_the_command_silently():
    call = f"{sys.executable} -m limitcurve curve --law hertz --points 200000 | head -1"
    done = subprocess.run(call, shell=True, capture_output=True, text=True, check=True)
    assert (done.stdout.count("\n"), done.stderr) == (1, "")


def test_rows_are_attributes_and_tables_print():
    fit = lc.fit("ratio", {
        "load": [1.0, 1, 2, 2],
        "force": [0.6, 0.02, 1.21, 0.03],
        "moment": [0, 2.1e-3, 0, 4.3e-3]
    },
                 law="hertz",
                 quiet=True)
    row = fit["parameter"].tolist().index("mu_r")
    for found in (fit, pickle.loads(pickle.dumps(fit))):
        assert (found.mu_r, found.mu_r.std_error, found.mu_r.unit) == (fit["value"][row], fit["std_error"][row], "m")
    assert type(fit.table) is dict and fit.table == dict(fit)
    lines = str(fit).splitlines()
    assert lines[0].split() == ["parameter", "value", "std_error", "unit"
                                ] and lines[1].split()[:2] == ["mu", f"{fit.mu:.4g}"] and lines[-1] == fit.note
    choice, engines = lc.choose("hertz", 0.1), lc.translate("hertz", lc.RadiusLaw.constant(0.006), mu=0.6, load=2)
    assert choice.chosen.error < 0.1 and choice.ellipse.error == lc.validate("hertz").ellipse.max_error
    assert choice.table.model == "table" and not isinstance(choice.table, float)
    assert set(engines.mujoco["engine"]) == {"mujoco"}
    assert choice == lc.choose("hertz", 0.1) != lc.choose("hertz", 0.2) and choice != engines
    with pytest.raises(AttributeError, match="^no 'nu', expected mu, mu_r"):
        fit.nu
    with pytest.raises(AttributeError, match="^'value' is a column"):
        fit.value


def test_objects_from_numbers_stand_for_texts():
    table = lc.Table("hertz", 1e-8)
    load = np.linspace(0.5, 4, 20)
    moment = 0.6 * table.moment_ratio * 0.002 * load**1.3
    power = "power:c=0.002,gamma=0.3"
    for law, text in ((lc.RadiusLaw.constant(0.006), "constant:a=0.006"),
                      (lc.RadiusLaw.hertz(0.008, E=2e5), "hertz:R=0.008,E=2e5"),
                      (lc.RadiusLaw.power(0.002, 0.3), power),
                      (lc.RadiusLaw.samples(load, 0.002 * load ** 0.3), power),
                      (lc.RadiusLaw.moments(load, moment), power)):
        holds = [table.load_to_hold(1.0, 2e-3, mu=0.6, radius_law=one) for one in (law, text)]
        assert holds[0] == pytest.approx(holds[1], rel=1e-4) and lc.SoftFinger(table, radius_law=law)
        assert lc.translate("hertz", law, mu=0.6, load=2)["value"] == pytest.approx(
            lc.translate("hertz", text, mu=0.6, load=2)["value"], rel=1e-4)
    assert repr(lc.Patch.rectangle(0.02, 0.01)) == repr(lc.Patch("rectangle:x=0.02,y=0.01"))
    push = {name: [1.0, 2, 3] for name in ("force_x", "force_y", "moment", "dx", "dy", "dtheta")}
    patch, text = lc.Patch.rectangle(0.02, 0.01).orthotropic(2, 0.5), "rectangle:x=0.02,y=0.01,mx=2,my=0.5"
    for call in (lambda one: lc.validate(patch=[one]), lambda one: lc.fit("friction", push, patch=one, quiet=True),
                 lambda one: lc.run("hold", patch=one, force=[1, 2], moment=1e-3, mu=0.6)):
        assert call(patch) == call(text)
    law = lc.Law(lambda radius: 1 - radius**2)
    assert np.abs(np.subtract(law.evaluate([0, 0.3, 1, 3]),
                              lc.Law("parabolic").evaluate([0, 0.3, 1, 3]))).max() < 1e-12 and law.profile_error < 1e-12
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        lc.Law(lambda radius: (1 - radius ** 2) ** 2.3)
    for wrong, told in (*((lambda a=a: lc.RadiusLaw.constant(a), f"^a: got {a!r}, expected a number")
                          for a in ("0.006", True, 10 ** 400)), (lambda: lc.Patch.rectangle(-1, 1), "x"),
                        (lambda: lc.Law(lambda radius: "x"), "^pressure: got 'x'"),
                        (lambda: lc.Law(lambda radius: 1 / radius), "^pressure at radius 0: .*division by zero"),
                        (lambda: lc.SoftFinger(table, radius_law=lc.RadiusLaw.samples([1, 1], [1, 2])),
                         "^samples: load of sample 2 = 1 N")):
        with pytest.raises(ValueError, match=told):
            wrong()
