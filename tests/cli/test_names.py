# SPDX-License-Identifier: MIT
"""One name for one thing in C++, C, Python and on the command line: data/names.csv has every name that stands in two of
them or more."""

import ast
import re
import unittest
from pathlib import Path

from command_line import DATA, FINGER, data, run

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = ("cpp", "c", "python", "option")


def text(*path):
    return ROOT.joinpath(*path).read_text(encoding="utf-8")


def fields(source, structure):
    """Names of the members of a structure: the last word of each declaration, without comments and initial values."""
    body = re.search(r"struct " + structure + r"(?: final)? \{(.*?)\n\}", source, re.DOTALL).group(1)
    body = re.sub(r"/\*.*?\*/|//[^\n]*", "", body, flags=re.DOTALL)
    declarations = [line for line in re.sub(r"\([^()]*\)|\{[^{}]*\}", "", body).split(";") if line.strip()]
    return {
        re.split(r"\s=", line)[0].split()[-1].lstrip("*").split("[")[0]
        for line in declarations
        if "return" not in line and "[[nodiscard]]" not in line
    }


def cpp_names():
    finger, friction, batch, contact = (text("godobject", name + ".hpp")
                                        for name in ("finger", "friction", "batch/batch", "contact"))
    found = set()
    for source, structures in ((finger, ("FingerParameters", "FingerOutput")),
                               (friction, ("FrictionLimits", "FrictionMemory", "FrictionResult")),
                               (batch, ("BasicContactBatch", )), (contact, ("Contact", ))):
        for structure in structures:
            found |= fields(source, structure)
    soft_finger = text("godobject", "soft_finger.hpp")
    found |= set(re.findall(r"\b(\w+)\([^)]*\) (?:const&? |& )?noexcept", soft_finger)) | set(
        re.findall(r"(?:double|Contact&) (\w+)[,)= ]", soft_finger))
    return found | fields(text("godobject", "scene", "replay.hpp"), "ReplayOptions")


def c_names():
    header = text("c", "limitcurve.h")
    found = set()
    for structure in re.findall(r"typedef struct (limitcurve_\w+) \{", header):
        found |= fields(header, structure)
    header = "".join(re.findall(r"limitcurve_(?:finger|batch)_\w+\(.*?\);", header, re.DOTALL))
    found |= set(re.findall(r"limitcurve_finger_(\w+)\(", header))
    return found | set(re.findall(r"(?:double|size_t|limitcurve_projection)\*? (\w+)(?:\[3\])?[,)]", header))


def python_names():
    sources = "".join(text("python", name) for name in ("fingers.cpp", "batches.cpp"))
    found = set(re.findall(r'(?:nb::arg|def_ro|def_prop_ro|add_view|\.def|step_signature)\(\s*"(\w+)"', sources))
    for name, number in re.findall(r'define_step<.*?>\(\s*type, "(\w+)", "(\w+)"', sources):
        found |= {name, name + "_pose", number}
    for name, signature in re.findall(r'"def (\w+)\((.*?)\) ->', re.sub(r'"\s*\n\s*"', "", sources)):
        found |= {name, *re.findall(r"(\w+): ", signature)}
    found |= set(re.findall(r"(\w+): ", re.search(r"string step_signature\(.*?\n\}", sources, re.DOTALL)[0]))
    found |= set(
        re.findall(r'\{"(\w+)",\s*&FingerParameters', text(
            "godobject", "finger", "finger_parameter_table.hpp"))) | {"radius_law", "projection"}
    for node in ast.parse(text("python", "limitcurve", "_tables.py")).body:
        if isinstance(node, ast.FunctionDef) and node.name in ("replay", "choose"):
            found |= {argument.arg for argument in node.args.args + node.args.kwonlyargs}
    return found


def option_names():
    return {
        name
        for subcommand in ("replay", "pivot", "choose")
        for name in re.findall(r"(--[a-z-]+)",
                               run(subcommand, "--help-all").stdout)
    }


@unittest.skipUnless((ROOT / "c").is_dir() and (ROOT / "python").is_dir(), "a language was deleted")
class Names(unittest.TestCase):
    def test_one_name_in_four_languages(self):
        present = dict(zip(LANGUAGES, (cpp_names(), c_names(), python_names(), option_names())))
        listed = data("names.csv")
        for row in listed:
            self.assertGreaterEqual(sum(bool(row[language]) for language in LANGUAGES), 2, row)
            for language in LANGUAGES:
                self.assertTrue(not row[language] or row[language] in present[language], f"{language}: {row[language]}")
        known = {language: {row[language] for row in listed} for language in LANGUAGES}
        for language in LANGUAGES:
            for name in present[language]:
                plain = name.lstrip("-").replace("-", "_")
                shared = sum(plain in {other.lstrip("-").replace("-", "_")
                                       for other in present[place]}
                             for place in LANGUAGES)
                self.assertTrue(shared < 2 or name in known[language],
                                f"{language}: {name} stands in {shared} languages, not in data/names.csv")

    def test_structs_for_c_sharp_have_the_members_of_c_in_its_order(self):
        sharp, header = text("examples", "limitcurve.cs"), re.sub(r"/\*.*?\*/",
                                                                  "",
                                                                  text("c", "limitcurve.h"),
                                                                  flags=re.DOTALL)
        for name, of_c in (("FingerParameters", "finger_parameters"), ("Contact", "contact"), ("FingerOutput",
                                                                                               "finger_output")):
            members = re.findall(r"(\w+)(?:\[3\])?;",
                                 re.search(rf"typedef struct limitcurve_{of_c} \{{(.*?)\n\}}", header, re.DOTALL)[1])
            body = re.search(rf"struct {name} \{{(.*?)\n\}}", sharp, re.DOTALL)[1]
            declared = [
                re.sub(r"\[3\]", "", one)
                for line in re.findall(r"public (?:fixed )?\w+ ([^;]+);", body)
                for one in line.split(", ")
            ]
            self.assertEqual(declared,
                             [re.sub(r"_(\w)", lambda letter: letter[1].upper(), member) for member in members], name)

    def test_values_may_have_underscores(self):
        call = ["replay", "--trace", DATA / "traces" / "slide_twist_load.csv", *FINGER, "--projection"]
        self.assertEqual(run(*call, "closest_point").stdout, run(*call, "closest-point").stdout)


if __name__ == "__main__":
    unittest.main()
