# SPDX-License-Identifier: MIT
"""replay: accepts any order of columns, checks gains, streams."""

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

    def test_files_of_another_kind(self):
        self.assert_fails(2, ["absent.csv", "No such file"], "replay", "--trace", self.directory / "absent.csv",
                          *FINGER)
        self.assert_fails(2, "directory", "replay", "--trace", self.directory, *FINGER)
        endless = self.file("endless.csv", "x" * 3_000_000)
        self.assert_fails(2, ["endless.csv:1:", "million"], "replay", "--trace", endless, *FINGER)

    def test_gains_are_checked_as_replay_reads_the_trace(self):
        call = ["replay", "--trace", self.file("trace.csv", TRACE), *FINGER]
        plain = run(*call).stdout
        for device in ["b=0.51", "b=0.51,b_r=1.9e-5", "b=0.051,T=1e-4", "b=1.51,b_r=5.5e-5,delay=1"]:
            done = run(*call, "--check-gains", device)
            self.assertEqual((done.stdout, "the twist is not checked" in done.stderr), (plain, "b_r" not in device))
        # In units, with a header further down, through a pipe.
        text = "logged by a jig\ntime,x,y,z,twist\n" + "".join(f"{t},0,0,-1,0\n" for t in [0, 0.1, 10.1, 10.2])
        jitter = ["replay", *FINGER, "--units", "time=ms,length=mm", "--damping", "2", "--trace", "-", "--check-gains"]
        for device, status in (("b=15.2", 0), ("b=15", 2), ("b=2.6,T=0.001", 0)):
            self.assertEqual(run(*jitter, device, input=text).returncode, status)

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
