# SPDX-License-Identifier: MIT
"""table and lookup: within the tolerance, read back to the last bit, exported; files that were changed are refused, and
no incomplete file is left."""

import json
import math
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from command_line import DATA, CommandLineTest, header, numbers, rows, table

SEEDS = Path(__file__).resolve().parent.parent / "fuzz" / "seeds"

FORMS = ["csv", "json"]


class Tables(CommandLineTest):
    def build(self, law, tolerance, form="csv", name="table"):
        path = self.directory / f"{name}.{form}"
        return path, rows("table", "--law", law, "--tolerance", tolerance, "-o", path)[0]

    def test_columns(self):
        path, facts = self.build("hertz", 1e-6, name="日é")  # a name that no code page but UTF-8 has
        self.assertEqual(list(facts), ["law", "tolerance", "checked_error", "nodes", "bytes", "profile_error"])
        self.assertEqual((facts["law"], facts["tolerance"]), ("hertz", 1e-6))
        self.assertLessEqual(facts["checked_error"], 1e-6)
        self.assertEqual(header("lookup", "--table", path, "--c", "1"), "c,force,moment")

    def test_a_header_has_the_name_that_was_chosen(self):
        path = self.directory / "finger.h"
        rows("table", "--law", "hertz", "--tolerance", 1e-4, "--name", "left_thumb", "-o", path)
        self.assertIn("left_thumb_wrench(double slide, double spin)", path.read_text())

    def test_a_header_and_its_row_state_what_it_holds(self):
        for real, size in (("double", 8), ("float", 4)):
            path = self.directory / "thumb.h"
            facts, = rows("table", "--law", "hertz", "--tolerance", 1e-6, "--real", real, "--name", "thumb", "-o", path)
            text = path.read_text()
            sides = re.findall(r"thumb_(?:in|out)side\[(\d+)\]\[(\d+)\]", text)
            self.assertEqual(facts["nodes"], sum(int(count) for count, _ in sides))
            self.assertEqual(facts["bytes"], size * sum(int(count) * int(columns) for count, columns in sides))
            tolerance, checked = (float(re.search(rf"thumb_{name} = ([-+.\de]+)", text)[1])
                                  for name in ("tolerance", "checked_error"))
            self.assertEqual(tolerance, 1e-6)
            self.assertLessEqual(checked, tolerance)

    def test_a_measured_profile_states_its_own_error(self):
        rim = [(i / 20, math.sqrt(1 - (i / 20) ** 2)) for i in range(21)]
        profile = self.csv("profile.csv", "radius,pressure", rim)
        for form in [*FORMS, "h"]:
            path, facts = self.build(f"samples:{profile}", 1e-4, form)
            self.assertGreater(facts["profile_error"], 1e-4)
            self.assertRegex(path.read_text(), f'profile_error"?( =|:) {facts["profile_error"]}')
        self.assertEqual(self.build("hertz", 1e-4)[1]["profile_error"], 0)

    def test_a_byte_order_mark_is_no_part_of_a_table(self):
        for form in FORMS:
            path, _ = self.build("hertz", 1e-4, form)
            found = rows("lookup", "--table", path, "--c", "0,0.5,2")
            path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
            self.assertEqual(rows("lookup", "--table", path, "--c", "0,0.5,2"), found)

    @unittest.skipUnless(shutil.which("clang++"), "no clang++ on the PATH, which compiles CUDA")
    def test_the_header_compiles_for_cuda(self):
        self.build("hertz", 1e-6, "h")
        source = self.file(
            "use.cu", """
            #define __host__ __attribute__((host))
            #define __device__ __attribute__((device))
            #define __global__ __attribute__((global))
            #include "table.h"
            __global__ void step(double* f, double* m, double* g) {
              *g = NAME_gauge(*f, *m);
              *f = NAME_closest_point(*f, *m, 1.0).force;
              *m = NAME_wrench(*f, *m).moment;
            }
            int main() { return NAME_gauge(0.3, 0.1) > 1.0 || NAME_closest_point(2.0, 0.0, 1.0).force != 1.0; }
            """.replace("NAME",
                        re.search(r"(\w+)_wrench\(double", (self.directory / "table.h").read_text()).group(1)))
        subprocess.run([
            "clang++", "-std=c++17", "-nocudainc", "-nocudalib", "--cuda-gpu-arch=sm_70", "-Wall", "-Wextra", "-Werror",
            "-fsyntax-only", source
        ],
                       check=True)

    def test_json_has_the_rows_of_the_csv(self):
        path, facts = self.build("hertz", 1e-6, "json")
        whole = json.loads(path.read_text())
        # Beside the cells, the rim of each side.
        self.assertEqual(len(whole["inside"]) + len(whole["outside"]), facts["nodes"] + 2)
        lines = [list(row.values()) for row in table(self.build("hertz", 1e-6)[0].read_text())]
        for side in ["inside", "outside"]:
            self.assertEqual([numbers for name, *numbers in lines if name == side], whole[side])

    def test_the_reader_of_the_documentation(self):
        text = (DATA.parent / "limitcurve" / "README.md").read_text()
        reader = re.search(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)[1]
        places = [0, 1e-300, 0.1, 0.5, 1 - 1e-9, 1, 1 + 1e-9, 3, 1e300]
        for law in ["hertz", "flat-punch"]:
            path, _ = self.build(law, 1e-8)
            names = {}
            self.assertLessEqual(sum(bool(line) for line in reader.splitlines()), 10)
            exec(reader.replace("hertz.csv", str(path)), names)  # pylint: disable=exec-used
            for c, found in zip(places, rows("lookup", "--table", path, "--c", numbers(places))):
                force, moment = names["wrench"](c)
                self.assertAlmostEqual(force, found["force"], delta=1e-15)
                self.assertAlmostEqual(moment, found["moment"], delta=1e-15)

    def test_headers_in_single_precision(self):
        """Each wrench within its checked error of a fine table at the same ratio, closest points within 5e-6; no double
        in it. On 32-bit ARM the same numbers."""
        arm = [[
            "arm-linux-gnueabihf-gcc", "-static", "-O2", "-mfloat-abi=hard", "-mfpu=neon-vfpv4", "-ffp-contract=fast"
        ], ["arm-linux-gnueabi-gcc", "-static", "-mfloat-abi=soft"]]
        arm = [one for one in arm if shutil.which("qemu-arm") and shutil.which(one[0])]
        for law in ("hertz", "uniform", "power:n=-0.9"):
            facts = rows("table", "--law", law, "--tolerance", 5e-7, "--real", "float", "--name", "single", "-o",
                         self.directory / "single.h")[0]
            self.assertLessEqual(facts["checked_error"], 5e-7)
            rows("table", "--law", law, "--tolerance", 1e-10, "--name", "fine", "-o", self.directory / "fine.h")
            (self.directory / "single.c").write_text(SINGLE)
            (self.directory / "main.c").write_text(COMPARE)
            for compiler in [["cc"], *arm]:
                strict = [
                    "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Wdouble-promotion", "-Wunsuffixed-float-constants",
                    "-Werror", "-c"
                ]
                subprocess.run([*compiler, *strict, "single.c"], cwd=self.directory, check=True)
                subprocess.run([*compiler, "-std=c99", "single.o", "main.c", "-o", "main", "-lm"],
                               cwd=self.directory,
                               check=True)
                run = ["./main", "100000"] if compiler == ["cc"] else ["qemu-arm", "./main", "10000"]
                printed = subprocess.run(run, cwd=self.directory, check=True, capture_output=True, text=True).stdout
                wrench, closest, mean = map(float, printed.split())
                here = mean if compiler == ["cc"] else here
                self.assertAlmostEqual(mean, here, delta=1e-6, msg=compiler)
                self.assertLess(wrench, facts["checked_error"], f"{law} {compiler}")
                self.assertLess(closest, 5e-6, f"{law} {compiler}")


SINGLE = """#include "single.h"
float wrench_of(float slide, float spin, float *moment) {
  *moment = single_wrench(slide, spin).moment;
  return single_wrench(slide, spin).force;
}
float closest_to(float f, float m, float chi, float *moment) {
  *moment = single_closest_point(f, m, chi).moment;
  return single_closest_point(f, m, chi).force;
}
"""
COMPARE = """#include "fine.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
float wrench_of(float, float, float *), closest_to(float, float, float, float *);
static unsigned seed = 1;
static float any(void) { return (float)((seed = 1664525u * seed + 1013904223u) >> 8) / 16777216.0f; }
int main(int count, char **words) {
  double most[2] = {0, 0}, mean = 0;
  for (int i = 0; i < atoi(words[count - 1]); ++i) {
    float moment, x = i % 2 ? any() : 1.0f - (float)pow(10.0, -7.0 * any()), out = (float)(i % 3 == 0);
    float force = wrench_of(out != 0 ? 1.0f : x, out != 0 ? x : 1.0f, &moment);
    fine_friction to = fine_wrench(out != 0 ? 1.0f : x, out != 0 ? x : 1.0f);
    most[0] = fmax(most[0], fmax(fabs(force - to.force), fabs(moment - to.moment)));
    float f = i % 50 ? 2 * any() : 0, m = i % 51 ? 1.5f * any() : 0, chi = (float)pow(10.0, 6 * any() - 3);
    force = closest_to(-f, m, chi, &moment), to = fine_closest_point(-f, m, chi);
    double off = fmax(fabs(force - to.force), fabs(moment - to.moment));
    most[1] = fmax(most[1], fabs(fine_gauge(f, m) - 1) < 1e-5 ? 0 : off);
    if (i < 10000) mean += (force + moment) / 10000;
  }
  printf("%g %g %.9g\\n", most[0], most[1], mean);
  return 0;
}
"""


class BadTables(CommandLineTest):
    def test_a_json_file_that_was_changed(self):
        path = self.directory / "table.json"
        rows("table", "--law", "hertz", "--tolerance", "1e-2", "-o", path)
        for spoil in [
                lambda t: t["outside"].pop(), lambda t: t["inside"].__setitem__(0, None),
                lambda t: t["outside"][0].__setitem__(2, "1"), lambda t: t.pop("inside"),
                lambda t: t["inside"][1].__setitem__(0, 1e999), lambda t: t.update(index_bits=4.5),
                lambda t: t.update(octaves=1 << 40), lambda t: t.pop("linear_error"), lambda t: t["columns"].reverse(),
                lambda t: t["inside"][1].__setitem__(2, t["inside"][1][2] * (1 + 1e-9)), lambda t: t.update(law="cone")
        ]:
            table = json.loads(path.read_text())
            spoil(table)
            self.assert_fails(2, "spoilt.json", "lookup", "--table", self.file("spoilt.json", json.dumps(table)), "--c",
                              "1")
        self.assert_fails(2, "torn.json", "lookup", "--table", self.file("torn.json",
                                                                         path.read_text()[:-3]), "--c", "1")

    def test_rows_nested_as_deep_as_a_file_may_be(self):
        deep = "[" * 1000000 + "]" * 1000000
        sides = f'"inside": [{deep}], "outside": [{deep}]'
        text = '{"format": "limitcurve table 2", "law": "hertz", "tolerance": 1e-6, "checked_error": 1e-7, ' \
            '"index_bits": 4, "octaves": 4, ' \
            '"linear_error": 1, "profile_error": 0, "checksum": "0", ' + sides + "}"
        self.assert_fails(2, "row 1: got a nested array", "lookup", "--table", self.file("deep.json", text), "--c", "1")


class Seeds(CommandLineTest):
    def test_the_fuzzers_begin_with_whole_tables(self):
        for form in FORMS:
            seed = self.file(f"seed.{form}", (SEEDS / f"table_{form}" / "hertz").read_bytes())
            rows("lookup", "--table", seed, "--c", "1")


class Writing(CommandLineTest):
    CALL = ["table", "--law", "hertz", "--tolerance", "1e-4", "-o"]

    def alone(self):
        self.assertEqual([entry.name for entry in self.directory.iterdir()], ["table.csv"])

    def test_where_nothing_can_be_written(self):
        self.assert_fails(1, ["absent/table.csv", "No such file"], *self.CALL, self.directory / "absent" / "table.csv")
        self.assert_fails(1, ["/dev/null/table.csv", "Not a directory"], *self.CALL, "/dev/null/table.csv")
        (self.directory / "table.csv").mkdir()
        self.assert_fails(1, "table.csv", *self.CALL, self.directory / "table.csv")
        self.alone()

    def test_a_failed_run_keeps_the_old_file(self):
        path = self.file("table.csv", "old")
        self.assert_fails(2, "--law", "table", "--law", "herz", "--tolerance", "1e-4", "-o", path)
        self.assertEqual(path.read_text(), "old")
        self.alone()


if __name__ == "__main__":
    unittest.main()
