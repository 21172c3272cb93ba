# SPDX-License-Identifier: MIT
"""Files of tables: refused if truncated, edited or foreign; no incomplete file is left."""

import json
import unittest
from pathlib import Path

from command_line import CommandLineTest, rows

SEEDS = Path(__file__).resolve().parent.parent / "fuzz" / "seeds"


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
        for seed in ("table_csv/hertz", "table_json/hertz"):
            path = self.directory / seed.replace("table_", "seed.").split("/")[0]
            path.write_bytes((SEEDS / seed).read_bytes())
            rows("lookup", "--table", path, "--c", "1")


class Writing(CommandLineTest):
    CALL = ["table", "--law", "hertz", "--tolerance", "1e-4", "-o"]

    def test_an_old_file_is_replaced_whole(self):
        path = self.file("table.csv", "old")
        rows(*self.CALL, path)
        self.assertTrue(path.read_text().startswith("# limitcurve table"))
        self.assertEqual([entry.name for entry in self.directory.iterdir()], ["table.csv"])

    def test_where_nothing_can_be_written(self):
        self.assert_fails(1, ["absent/table.csv", "No such file"], *self.CALL, self.directory / "absent" / "table.csv")
        self.assert_fails(1, ["/dev/null/table.csv", "Not a directory"], *self.CALL, "/dev/null/table.csv")
        (self.directory / "table.csv").mkdir()
        self.assert_fails(1, "table.csv", *self.CALL, self.directory / "table.csv")
        self.assertEqual([entry.name for entry in self.directory.iterdir()], ["table.csv"])

    def test_a_failed_run_keeps_the_old_file(self):
        path = self.file("table.csv", "old")
        self.assert_fails(2, "--law", "table", "--law", "herz", "--tolerance", "1e-4", "-o", path)
        self.assertEqual(path.read_text(), "old")
        self.assertEqual([entry.name for entry in self.directory.iterdir()], ["table.csv"])


if __name__ == "__main__":
    unittest.main()
