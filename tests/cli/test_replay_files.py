# SPDX-License-Identifier: MIT
"""replay: accepts any order of columns, refuses a bad trace or option with its place, streams."""

import os
import subprocess
import unittest

from command_line import EXECUTABLE, CommandLineTest, run
from recorded_finger import FINGER, TRACE


class Files(CommandLineTest):
    def replayed(self, text, name="trace.csv"):
        path = self.directory / name
        path.write_bytes(text.encode())
        return run("replay", "--trace", path, *FINGER)

    def test_forms_that_mean_the_same(self):
        plain = self.replayed(TRACE)
        self.assertEqual(plain.returncode, 0, plain.stderr)
        table = [line.split(",") for line in TRACE.splitlines()]
        forms = {
            "comments": "# made by hand\n" + TRACE.replace("\n0.002", "\n  # a remark, with a comma\n\n0.002"),
            "carriage returns": TRACE.replace("\n", "\r\n"),
            "byte order mark": "\ufeff" + TRACE,
            "no last line end": TRACE[:-1],
            "blanks": TRACE.replace(",", " , "),
            "quotes": "\n".join(",".join(f'"{field}"' for field in row) for row in table) + "\n",
            "another order": "\n".join(",".join(reversed(row)) for row in table) + "\n",
            "more columns": "\n".join(",".join(["note", *row, "z2"] if i == 0 else ['"a, b ""c"""', *row, "nan"])
                                      for i, row in enumerate(table)) + "\n",
        }
        for form, text in forms.items():
            done = self.replayed(text)
            self.assertEqual((done.returncode, done.stdout), (0, plain.stdout), f"{form}: {done.stderr}")

    def test_standard_input(self):
        piped = run("replay", "--trace", "-", *FINGER, input=TRACE)
        self.assertEqual(piped.stdout, self.replayed(TRACE).stdout)

    def test_what_is_wrong_is_told_by_place(self):
        cases = [
            ("", "bad.csv:1:1:", "empty"),
            ("# nothing\n", "bad.csv:1:1:", "empty"),
            ("time,x,y,z,twist\n", "bad.csv:2:1:", "no rows"),
            ("time,x,y,twist\n0,0,0,0\n", "bad.csv:1:1:", "'z'"),
            ("0,0,0,0,0\n", "bad.csv:1:1:", "'time'"),
            ("time,x,y,z,qw\n0,0,0,0,1\n", "bad.csv:1:1:", "'twist'"),
            ("time,x,y,z,twist,x\n0,0,0,0,0,0\n", "bad.csv:1:18:", "'x' twice"),
            (TRACE + "0.004,0.01,0,-0.0", "bad.csv:6:18:", "4 fields"),
            (TRACE + "0.004", "bad.csv:6:6:", "1 field,"),
            (TRACE + "0.004,0,0,0,0,0\n", "bad.csv:6:16:", "6 fields"),
            (TRACE + "0.004,nan,0,0,0\n", "bad.csv:6:7:", "'nan'"),
            (TRACE + "0.004,0,inf,0,0\n", "bad.csv:6:9:", "'inf'"),
            (TRACE + "0.004,0,,0,0\n", "bad.csv:6:9:", "''"),
            (TRACE + "0.004,0,0,0.1.2,0\n", "bad.csv:6:11:", "'0.1.2'"),
            (TRACE + "0.004,0,0,0x1,0\n", "bad.csv:6:11:", "'0x1'"),
            (TRACE.replace("0.002", '"0.002'), "bad.csv:4:1:", "quote"),
            ("\0\1\2\3", "bad.csv:1:1:", "a byte 0"),
        ]
        for text, place, what in cases:
            self.replayed(text, "bad.csv")
            self.assert_fails(2, [place, what, "expected"] if what != "quote" else [place, what], "replay", "--trace",
                              self.directory / "bad.csv", *FINGER)

    def test_files_of_another_kind(self):
        self.assert_fails(2, ["absent.csv", "No such file"], "replay", "--trace", self.directory / "absent.csv",
                          *FINGER)
        self.assert_fails(2, "directory", "replay", "--trace", self.directory, *FINGER)
        endless = self.directory / "endless.csv"
        endless.write_bytes(b"x" * 3_000_000)
        self.assert_fails(2, ["endless.csv:1:", "million"], "replay", "--trace", endless, *FINGER)

    def test_options_out_of_range(self):
        path = self.file("trace.csv", TRACE)
        for option in ["--mu", "--stiffness", "--twist-stiffness", "--mu-dynamic", "--mu-r", "--tolerance"]:
            call = ["replay", "--trace", path, *FINGER]
            if option in call:
                del call[call.index(option):call.index(option) + 2]
            for value in ["-1", "nan", "inf", "x"]:
                self.assert_fails(2, [option, "expected"], *call, option, value)
        for option in ["--stiffness", "--twist-stiffness", "--mu", "--law"]:
            call = list(FINGER)
            del call[call.index(option):call.index(option) + 2]
            self.assert_fails(2, option, "replay", "--trace", path, *call)
        for option, values, told in [("--max-speed", ["0", "-0.01", "nan", "x",
                                                             ""], "expected a number > 0, or inf"),
                                     ("--fault-decay", ["-0.1", "1.1", "nan", "inf",
                                                        "x"], "expected a number from 0 to 1")]:
            for value in values:
                self.assert_fails(2, [option, told], "replay", "--trace", path, *FINGER, option, value)
        self.assert_fails(2, ["--curve", "triangle", "ellipse"], "replay", "--trace", path, *FINGER, "--curve",
                          "triangle")
        self.assert_fails(2, ["--projection", "c-curve"], "replay", "--trace", path, *FINGER, "--projection", "oblique")
        self.assert_fails(2, ["mu_dynamic"], "replay", "--trace", path, *FINGER, "--mu-dynamic", "0.7")
        self.assert_fails(2, ["tolerance"], "replay", "--trace", path, *FINGER, "--tolerance", "0")

    def test_gains_that_are_not_passive_are_refused(self):
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER]
        plain = run(*call).stdout
        # 1000 N/m at 1 ms need 0.5 N s/m, and 0.036 N m/rad need 1.8e-5 N m s/rad.
        for device in ["b=0.51", "b=0.51,b_r=1.9e-5", "b=0.051,T=1e-4"]:
            self.assertEqual(run(*call, "--check-gains", device).stdout, plain, device)
        self.assert_fails(2, ["not passive", "0.5 N s/m", "got 0.49"], *call, "--check-gains", "b=0.49")
        self.assert_fails(2, ["not passive", "twist"], *call, "--check-gains", "b=1,b_r=1.7e-5")
        self.assert_fails(2, ["not passive", "0.9 N s/m"], *call, "--check-gains", "b=0.8", "--damping", "0.4")
        self.assert_fails(2, ["--check-gains", "expected b=NUMBER"], *call, "--check-gains", "0.5")
        self.assert_fails(2, ["--check-gains", "'T'"], *call, "--check-gains", "b=0.5,T=0")
        # A sample late: 1.5 kT, and less where a damper helps.
        self.assert_fails(2, ["a delay of 1 sample need", "1.5 N s/m"], *call, "--check-gains", "b=1.49,delay=1")
        self.assert_fails(2, ["1.2125 N s/m"], *call, "--check-gains", "b=1.2,delay=1", "--damping", "0.4")
        # Units, a header further down, and a pipe, as replay reads them.
        text = "time,x,y,z,twist\n" + "".join(f"{t},0,0,-1,0\n" for t in [0, 0.1, 10.1, 10.2])
        jitter = ["replay", *FINGER, "--units", "time=ms,length=mm", "--damping", "2", "--trace"]
        late = "logged by a jig\n" + text
        self.assertEqual(run(*jitter, "-", "--check-gains", "b=15.2", input=late).returncode, 0)
        for trace, given in [(self.file("jitter.csv", text), None), ("-", text)]:
            self.assert_fails(2, ["not passive", "in steps of 0.0001 to 0.01 s", "15.1 N s/m"], *jitter, trace,
                              "--check-gains", "b=15", input=given)
            self.assertEqual(run(*jitter, trace, "--check-gains", "b=2.6,T=0.001", input=given).returncode, 0)
        again = self.file("again.csv", TRACE + "0.003,0.005,0,-0.001,0\n")
        self.assert_fails(2, ["again.csv:6:1", "T=SECONDS"], "replay", "--trace", again, *FINGER, "--check-gains",
                          "b=0.51")
        self.assertEqual(run(*call, "--check-gains", "b=1.51,b_r=5.5e-5,delay=1").stdout, plain)
        for delay in ["-1", "0.5", "1001", "x"]:
            self.assert_fails(2, ["--check-gains", "whole samples"], *call, "--check-gains", f"b=9,delay={delay}")
        # Without b_r a note, and the sample time is the trace's.
        self.assertIn("the twist is not checked", run(*call, "--check-gains", "b=0.51").stderr)
        self.assertNotIn("the twist is not checked", run(*call, "--check-gains", "b=0.51,b_r=1").stderr)
        slow = self.file(
            "slow.csv",
            "time,x,y,z,twist\n0,0,0,-0.001,0\n0.002,0,0,-0.001,0\n0.012,0,0,-0.001,0\n0.013,0,0,-0.001,0\n")
        self.assert_fails(2, ["5 N s/m", "0.01 s"], "replay", "--trace", slow, *FINGER, "--check-gains", "b=4.9")
        self.assertEqual(run("replay", "--trace", slow, *FINGER, "--check-gains", "b=5.1").returncode, 0)

    def test_a_long_trace_is_streamed(self):
        def peak(samples):
            path = self.directory / "long.csv"
            with open(path, "w", encoding="ascii") as file:
                file.write("time,x,y,z,twist\n")
                for i in range(samples):
                    file.write(f"{i / 1000},{1e-6 * i},0,-0.0012345678901234,{1e-5 * i}\n")
            # In a build with the address sanitizer, freed memory is not to be kept.
            environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1:thread_local_quarantine_size_kb=64"}
            with open(os.devnull, "wb") as sink, subprocess.Popen([EXECUTABLE, "replay", "--trace", path, *FINGER],
                                                                  stdout=sink,
                                                                  env=environment) as process:
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            return usage.ru_maxrss  # KiB

        # Of a file of some 20 MB.
        self.assertLess(peak(400_000), peak(100) + 8192)


if __name__ == "__main__":
    unittest.main()
