# SPDX-License-Identifier: MIT
"""The package: its docstrings run, its import is fast, its stubs exist, and it installs the command."""

import doctest
import importlib.resources
import importlib.util
import inspect
import subprocess
import sys

import limitcurve as lc
import limitcurve.arrays
import limitcurve.plot
import pytest

MODULES = [lc, lc.plot, lc.arrays, sys.modules["limitcurve._tables"]]
if importlib.util.find_spec("warp"):
    MODULES.append(importlib.import_module("limitcurve.warp"))
    MODULES[-1].wp.config.log_level = MODULES[-1].wp.LOG_WARNING


def documented():
    """Everything public with a docstring: name and text."""
    for module in MODULES:
        yield module.__name__, inspect.getdoc(module)
        names = getattr(module, "__all__", None) or [name for name in vars(module) if not name.startswith("_")]
        for name in names:
            thing = getattr(module, name)
            if module is lc or getattr(thing, "__module__", "") == module.__name__:
                yield f"{module.__name__}.{name}", inspect.getdoc(thing)
                for member in vars(thing) if inspect.isclass(thing) else ():
                    yield f"{module.__name__}.{name}.{member}", inspect.getdoc(getattr(thing, member))


@pytest.mark.parametrize(("name", "text"), [(name, text) for name, text in documented() if text and ">>>" in text],
                         ids=lambda value: value[:40])
def test_examples_in_docstrings_run(name, text):
    example = doctest.DocTestParser().get_doctest(text, {}, name, None, 0)
    result = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(example)
    assert result.attempted > 0 and result.failed == 0


def test_every_public_name_says_what_it_is():
    for name in lc.__all__:
        if name != "__version__":
            assert inspect.getdoc(getattr(lc, name)), name


def again(code):
    done = subprocess.run([sys.executable, "-c", "import limitcurve, sys\nlaw = limitcurve.Law('hertz')\n" + code],
                          capture_output=True,
                          text=True,
                          check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("names", ["limitcurve", "limitcurve._core"])
def test_importing_twice_keeps_the_types_of_the_first(names):
    again(
        f"for k in [k for k in sys.modules if k.startswith('{names}')]: del sys.modules[k]\n"
        "import limitcurve as second, limitcurve._core as core\n"
        "assert second.Law is core.Law is type(law) and second.Table(law).wrench(1, 1) == "
        "core.Table('hertz').wrench(1, 1)\n"
        "assert second.__version__ and law.evaluate([0.5])[0] > 0")


def test_another_interpreter_is_told_so_and_the_first_goes_on():
    interpreters = "_xxsubinterpreters" if sys.version_info < (3, 13) else "_interpreters"
    if importlib.util.find_spec(interpreters) is None:
        pytest.skip("no interpreters")
    # The module itself, too: of the package NumPy may be refused first.
    again(
        f"import {interpreters} as other, limitcurve._core as core\n"
        "alone = f'import importlib.util as u; u.module_from_spec(u.spec_from_file_location(\"limitcurve._core\", "
        "{core.__file__!r}))'\n"
        "for code in (alone, 'import limitcurve'):\n"
        "    try:\n        failed = other.run_string(other.create(), code)\n    except Exception as error:\n        "
        "failed = error\n"
        "    assert 'ImportError' in repr(failed), failed\n"
        "    assert repr(law).startswith('Law') and law.evaluate([0.5])[0] == "
        "limitcurve.Law('hertz').evaluate([0.5])[0] > 0\n"
        "    assert limitcurve.SoftFinger(limitcurve.Table(law, 1e-4), mu=1).update((0, 0, 0), (0, 0, 1), 0.001, 0)"
        ".load == 1\n"
        "    try:\n        limitcurve.Law('herz')\n    except ValueError as error:\n        assert 'herz' in "
        "str(error)\n"
        "    else:\n        assert False\n")


def test_stubs_are_installed():
    files = {entry.name for entry in importlib.resources.files("limitcurve").iterdir()}
    assert {"py.typed", "_core.pyi"} <= files


def test_the_command_is_installed():
    done = subprocess.run([sys.executable, "-m", "limitcurve", "laws"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("law,moment_ratio,method,error\nhertz,0.58904862254808")
    done = subprocess.run([sys.executable, "-m", "limitcurve", "eval", "--law", "hertzz", "--c", "1"],
                          capture_output=True,
                          text=True,
                          check=False)
    assert done.returncode == 2 and done.stderr.startswith("limitcurve: error: --law: law 'hertzz'")
