# SPDX-License-Identifier: MIT
"""Hostile conditions: a kill at any moment, a full disk, a folder without permission, a closed pipe, bulk input."""

import contextlib
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from command_line import EXECUTABLE, FINGER, CommandLineTest, run

BULK = 64  # megabytes
MEGABYTE = 1 << 20
# Of shadow memory and redzones; a sanitizer's program also reserves more than it uses.
SANITIZED = bool(os.environ.get("LIMITCURVE_SANITIZED"))
TABLE = ["table", "--law", "uniform", "--tolerance", "1e-14", "-o"]
REPLAY = ["replay", *FINGER, "--curve", "ellipse", "--projection", "radial", "--quiet", "--trace", "-"]


class KilledTable(CommandLineTest):
    def test_a_table_is_whole_or_not_there(self):
        path = self.directory / "table.csv"
        call = [EXECUTABLE, *TABLE, str(path)]
        durations = []  # the quickest counts: with the time of one that had waited for others most would end unkilled
        for _ in range(3):
            begin = time.monotonic()
            subprocess.run(call, stdout=subprocess.DEVNULL, check=True)
            durations.append(time.monotonic() - begin)
        whole = path.read_bytes()
        generator = random.Random(11)
        killed = 0
        for _ in range(60):
            path.unlink(missing_ok=True)
            with subprocess.Popen(call, stdout=subprocess.DEVNULL) as process:
                time.sleep(generator.uniform(0, min(durations)))
                process.kill()
            killed += process.returncode == -signal.SIGKILL
            if path.exists():
                self.assertEqual(path.read_bytes(), whole)
        self.assertGreaterEqual(killed, 7)


class Refused(CommandLineTest):
    def test_a_limit_of_file_size(self):
        # A shell ignores the signal; then it is like a disk that is full in the middle of a file.
        limited = ["sh", "-c", 'ulimit -f 1; trap "" XFSZ; exec "$0" "$@"', EXECUTABLE]
        for name in ["table.csv", "table.json", "table.hpp"]:
            path = self.file(name, "old")
            self.assert_fails(1, [name, "File too large"], *TABLE, path, command=limited)
            self.assertEqual(path.read_text(), "old")

    def mounted(self, options):
        """A file system of our own, where that is allowed."""
        folder = self.directory / "mounted"
        folder.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], capture_output=True,
                          check=False).returncode != 0:
            self.skipTest("not allowed to mount")
        self.addCleanup(subprocess.run, ["umount", folder], check=True)
        return folder

    def test_a_full_disk(self):
        folder = self.mounted("size=16k")
        (folder / "table.csv").write_text("old")
        self.assert_fails(1, ["table.csv", "No space left on device"], *TABLE, folder / "table.csv")
        self.assertEqual([(path.name, path.read_text()) for path in folder.iterdir()], [("table.csv", "old")])

    def test_a_folder_that_cannot_be_written(self):
        folder = self.mounted("ro,size=1m")
        self.assert_fails(1, ["table.csv", "Read-only file system"], *TABLE, folder / "table.csv")

    def test_a_folder_without_permission(self):
        folder, executable, options = self.directory / "locked", EXECUTABLE, {}
        if os.getuid() == 0:
            # To root everything is permitted: be nobody, who may not enter every folder of root's. So the executable
            # lies beside.
            os.chmod(self.directory, 0o755)
            executable = shutil.copy(EXECUTABLE, self.directory)
            options = {"user": 65534, "group": 65534, "extra_groups": [], "cwd": self.directory}
            try:
                subprocess.run([executable, "--version"], capture_output=True, check=True, **options)
            except (OSError, subprocess.CalledProcessError) as error:
                self.skipTest(f"nobody may not run the executable: {error}")
        folder.mkdir(mode=0o555)
        self.assert_fails(1, ["table.csv", "Permission denied"], *TABLE, folder / "table.csv", command=[executable],
                          **options)

    def test_a_pipe_that_closes(self):
        for call in ["curve --law hertz --points 200000", "replay --trace long.csv " + " ".join(REPLAY[1:-2])]:
            (self.directory / "long.csv").write_text("time,x,y,z,twist\n" + "0,0,0,-0.001,0\n" * 50000)
            head = ["bash", "-c", '"$0" "$@" | head -1; exit ${PIPESTATUS[0]}', EXECUTABLE]
            done = run(*call.split(), command=head, cwd=self.directory)
            self.assertEqual((done.returncode, done.stdout.count("\n"), done.stderr), (1, 1, ""), call)


class Bulk(unittest.TestCase):
    """Standard input of any length, and how much memory a run takes at most."""

    def stream(self, arguments, header, line, megabytes):
        """Exit status, standard error, rows fed and the largest memory [MB] of a run that is fed so much of one
        line."""
        block = line * (MEGABYTE // len(line))
        # In a build with the address sanitizer, freed memory is not to be kept.
        environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1:thread_local_quarantine_size_kb=64"}
        complaint = tempfile.TemporaryFile()
        self.addCleanup(complaint.close)
        process = subprocess.Popen([EXECUTABLE, *arguments],
                                   stdin=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL,
                                   stderr=complaint,
                                   env=environment)

        def feed():
            with contextlib.suppress(BrokenPipeError), process.stdin:
                process.stdin.write(header)
                for _ in range(megabytes):
                    process.stdin.write(block)

        feeder = threading.Thread(target=feed)
        feeder.start()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        feeder.join()
        complaint.seek(0)
        return (process.returncode, complaint.read().decode(), megabytes * (len(block) // len(line)),
                usage.ru_maxrss / 1024)

    def test_a_long_trace_is_streamed(self):
        few, many = (self.stream(REPLAY, b"time,x,y,z,twist\n", b"0,1e-6,0,-0.0012345678901234,0\n", megabytes)
                     for megabytes in (1, 20))
        self.assertEqual((few[:2], many[:2]), ((0, ""), (0, "")))
        self.assertLess(many[3], few[3] + 8)

    def test_a_fit_holds_its_numbers_and_no_more(self):
        # A fit goes over its data many times, and must hold them; but not what else a row has.
        rest = b"," + b"-" * 20000 + b"\n"
        line = b"2,1,0" + rest + b"2,0,0.005" + rest + b"2,0.7,0.0037" + rest
        header = b"load,force,moment,remark\n"
        fit = ["fit", "ellipse", "--quiet", "--data", "-"]
        status, complaint, _, little = self.stream(fit, header, line, 4)
        self.assertEqual((status, complaint), (0, ""))
        status, complaint, count, much = self.stream(fit, header, line, BULK)
        count *= 3
        self.assertEqual((status, complaint), (0, ""))
        self.assertLess(much - little,
                        4 + count * 1000 / MEGABYTE * (12 if SANITIZED else 1))  # freed memory is kept back there
        print(f"fit of {BULK} MB, {count} rows: {much:.0f} MB", file=sys.stderr)

    def test_what_is_no_csv_is_refused_at_its_beginning(self):
        by_name = [["eval", "--law", "samples:/dev/stdin", "--c", "1"]] if os.path.exists("/dev/stdin") else [
        ]  # it needs /proc
        for arguments in [REPLAY, ["fit", "ratio", "--data", "-"], *by_name]:
            status, complaint, _, much = self.stream(arguments, b"", bytes(1024), BULK)
            self.assertEqual(status, 2, complaint)
            self.assertRegex(complaint, r"\Alimitcurve: error: [^\n]*more than a million characters[^\n]*\n\Z")
            self.assertLess(much, 1024 if SANITIZED else 64)

    def test_a_gigabyte_is_no_table(self):
        with tempfile.NamedTemporaryFile(suffix=".csv") as file:
            file.truncate(1 << 30)  # sparse
            done = run("lookup", "--table", file.name, "--c", "1")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]*not a table: longer than any[^\n]*\n\Z")


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    unittest.main()
