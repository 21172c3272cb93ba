# SPDX-License-Identifier: MIT
"""What a terminal gets: results in a table; on standard error progress (a bar there, lines elsewhere), colours, and
what was meant."""

import contextlib
import csv
import os
import pty
import re
import subprocess
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

from command_line import EXECUTABLE, FINGER, PROGRESS, CommandLineTest, run

EVAL = ["eval", "--law", "hertz", "--c", "1"]


def on_terminal(*arguments, results=True, environment=(), feed=None):
    """Exit status, what a terminal got from standard error (and standard output, with `results`), and what standard
    output got otherwise. `feed` writes standard input."""
    try:
        ours, theirs = pty.openpty()
    except OSError as error:  # as where /dev/pts is not mounted
        raise unittest.SkipTest(f"no pseudo-terminal: {error}") from error
    variables = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    variables |= {"TERM": "xterm", **dict(environment)}
    process = subprocess.Popen([EXECUTABLE, *map(str, arguments)],
                               stdin=subprocess.PIPE if feed else subprocess.DEVNULL,
                               stdout=theirs if results else subprocess.PIPE,
                               stderr=theirs,
                               env=variables)
    os.close(theirs)
    if feed:
        feed(process.stdin)
        process.stdin.close()
        process.stdin = None
    seen = b""
    with contextlib.suppress(OSError):  # the other end is closed
        while chunk := os.read(ours, 65536):
            seen += chunk
    os.close(ours)
    printed = process.communicate()[0] or b""
    return process.returncode, seen.decode().replace("\r\n", "\n"), printed.decode()


def shown(text):
    """The lines that stand on a terminal in the end: what follows a return writes over what was there."""
    lines = []
    for line in text.split("\n"):
        cells = []
        for part in line.split("\r"):
            cells[: len(part)] = part
        lines.append("".join(cells).rstrip())
    return lines


def slowly(*texts):
    """Writes standard input with a second and a half before each text but the first."""
    def feed(file):
        for i, text in enumerate(texts):
            if i:
                time.sleep(1.5)
            file.write(text.encode())
            file.flush()
    return feed


ROWS = "time,x,y,z,twist\n0,0,0,-0.001,0\n", "0.001,0,0,-0.001,0\n"
REPLAY = ["replay", "--trace", "-", *FINGER]


def on_pipes(*arguments, seconds, last=ROWS[1]):
    """Standard error and exit status of a replay whose last row comes after so many seconds."""
    with subprocess.Popen([EXECUTABLE, *REPLAY, *arguments],
                          stdin=subprocess.PIPE,
                          stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE,
                          text=True) as process:
        process.stdin.write(ROWS[0])
        process.stdin.flush()
        time.sleep(seconds)
        process.stdin.write(last)
        process.stdin.close()
        return process.stderr.read(), process.wait()


def after_a_while(*arguments, last=ROWS[1], **options):
    return on_terminal(*REPLAY, *arguments, feed=slowly(ROWS[0], last), **{"results": False, **options})


# Calls that wait, each for some seconds: all begin at once.
WAITING = {
    "bar": after_a_while, "beside results": lambda: after_a_while("--format", "csv", results=True),
    "short row": lambda: after_a_while(last="0.001,0,0,-0.001\n", environment={"NO_COLOR": "1"}),
    "bad number": lambda: after_a_while(last="0.001,0,0,x,0\n", environment={"NO_COLOR": "1"}),
    "quiet": lambda: after_a_while("--quiet"), "dumb": lambda: after_a_while(environment={"TERM": "dumb"}),
    "lines": lambda: on_pipes(seconds=7), "no lines": lambda: on_pipes("--quiet", seconds=7),
}


def setUpModule():
    pool = ThreadPoolExecutor(len(WAITING))
    unittest.addModuleCleanup(pool.shutdown)
    WAITING.update({name: pool.submit(call) for name, call in WAITING.items()})


@unittest.skipIf(sys.platform == "win32", "no pseudo-terminals")
class Bar(CommandLineTest):
    def test_a_bar_that_is_gone_at_the_end(self):
        status, seen, printed = WAITING["bar"].result()
        self.assertEqual((status, printed.count("\n")), (0, 3))
        self.assertRegex(seen, r"\rlimitcurve: replay: \[ *#+ *\] 1 s")
        self.assertEqual(shown(seen), [""])
        # Where the results come to the same terminal, they stand alone too.
        status, seen, _ = WAITING["beside results"].result()
        self.assertRegex(seen, r"\rlimitcurve: replay: \[ *#+ *\] 1 s")
        self.assertEqual(shown(seen), [*printed.split("\n")])

    def test_the_share_that_is_done(self):
        laws = [f"--law=xydas-kao:k={0.1 + 0.01 * i:.2f}" for i in range(24)]
        status, seen, printed = on_terminal("validate", *laws, results=False)
        self.assertEqual((status, printed), (0, run("validate", *laws).stdout))
        percents = [int(text) for text in re.findall(r"\rlimitcurve: validate: \[#* *\] (\d+) %, \d+ s", seen)]
        self.assertEqual(percents, sorted(percents))
        self.assertGreater(len(set(percents)), 1)
        self.assertEqual(shown(seen), [""])

    def test_one_line_of_error_stands(self):
        for call in "short row", "bad number":
            status, seen, _ = WAITING[call].result()
            self.assertEqual(status, 2)
            self.assertIn("replay: [", seen)
            self.assertRegex("\n".join(shown(seen)), r"\Alimitcurve: error: standard input:3:[^\n]+\n\Z")

    def test_no_bar(self):
        for call in "quiet", "dumb":
            status, seen, _ = WAITING[call].result()
            self.assertEqual((status, seen), (0, ""))


class Table(CommandLineTest):
    CALLS = [["validate", "--law", "hertz", "--law", "mix:0.7*hertz+0.3*uniform"],
             ["choose", "--law", "hertz", "--tolerance", "0.01"], ["fit", "ellipse", "--law", "hertz", "--quiet"],
             ["laws"], ["p-curves", *FINGER[:6], "--loads", "1,20", "--points", "500"],
             ["hold", *FINGER[:6], "--force", "1", "--moment", "0.002"]]

    @unittest.skipIf(sys.platform == "win32", "no pseudo-terminals")
    def test_a_table_on_a_terminal_and_csv_elsewhere(self):
        for call in self.CALLS:
            table, text = run(*call, "--format", "table").stdout, run(*call, "--format", "csv").stdout
            self.assertEqual((on_terminal(*call)[1], run(*call).stdout), (table, text))
            self.assertEqual(on_terminal(*call, "--format", "csv")[1], text)

    def test_it_has_the_cells_of_the_csv_rounded_and_aligned(self):
        for call in self.CALLS:
            names, *expected = csv.reader(run(*call).stdout.splitlines())
            lines = run(*call, "--format", "table").stdout.splitlines()
            self.assertLessEqual(max(map(len, lines)), 100, lines)
            starts = [match.start() for match in re.finditer(r"\S+", lines[0])]
            cells = [[line[begin:end] for begin, end in zip(starts, [*starts[1:], None])] for line in lines]
            head = len(lines) - len(expected) - sum(line.startswith("[") for line in lines)
            self.assertEqual(["".join(part[i].strip() for part in cells[:head]) for i in range(len(names))], names)
            for i, name in enumerate(names):
                numbers = [row[i].rstrip() for row in cells[head:][:len(expected)]]
                for shown_as, row in zip(numbers, expected):
                    self.assertEqual(shown_as.strip(), self.rounded(name, row[i], lines), (name, call))
                points = {re.search(r"[.e]|$", one).start() for one in numbers if re.fullmatch(r" *-?[\d.e+-]+", one)}
                self.assertLessEqual(len(points), 1, (name, call))

    def test_a_long_one_comes_in_parts(self):
        call = ["p-curves", *FINGER[:6], "--loads", "1,20,3", "--points", "1001", "--format"]
        cells = [line.split() for line in run(*call, "table").stdout.splitlines()]
        self.assertEqual([(row[0], len(row)) for row in cells],
                         [(line.split(",")[0], 4) for line in run(*call, "csv").stdout.splitlines()])

    @staticmethod
    def rounded(name, text, lines):
        if len(text) > 16 and " " in text:  # a remark, which stands below once
            (number,) = (line.split()[0] for line in lines if line.endswith("] " + text))
            return number
        try:
            return f"{float(text):.{6 if name in ('parameter', 'value', 'hold_load') else 4}g}"
        except ValueError:
            return text


@unittest.skipIf(sys.platform == "win32", "no pseudo-terminals")
class Colours(CommandLineTest):
    def test_an_error_in_red_on_a_terminal_alone(self):
        red, plain = "limitcurve: \x1b[31merror:\x1b[0m ", "limitcurve: error: "
        for environment, begin in [({}, red), ({"NO_COLOR": ""}, red), ({"NO_COLOR": "1"}, plain),
                                   ({"TERM": "dumb"}, plain)]:
            status, seen, _ = on_terminal("evil", environment=environment)
            self.assertEqual(status, 2)
            self.assertRegex(seen, rf"\A{re.escape(begin)}no subcommand 'evil'[^\n\x1b]+\n\Z")
        self.assertNotIn("\x1b", run("evil").stderr)
        self.assertNotIn("\x1b", on_terminal(*EVAL)[1])


class Lines(CommandLineTest):
    def test_a_line_now_and_then(self):
        said, status = WAITING["lines"].result()
        self.assertEqual(status, 0)
        self.assertRegex(said, r"\A(limitcurve: replay: \d+ s\n)+\Z")
        self.assertEqual(PROGRESS.sub("", said), "")
        self.assertEqual(WAITING["no lines"].result(), ("", 0))
        said, status = on_pipes("--quiet", seconds=0, last="0.001,0,0,x,0\n")
        self.assertEqual(status, 2)
        self.assertRegex(said, r"\Alimitcurve: error: [^\n]+\n\Z")

    def test_quiet_keeps_notes_back(self):
        for call in [["fit", "ellipse", "--law", "hertz"],
                     ["choose", "--law", "hertz", "--tolerance", "0.01", "--explain"],
                     ["p-curves", "--law", "hertz", "--radius-law", "constant:a=5", "--mu", "1", "--loads", "1"]]:
            loud, quiet = run(*call), run(*call, "--quiet")
            if "has no 'fit'" in loud.stderr:
                continue
            self.assertNotEqual(loud.stderr, "")
            self.assertEqual((quiet.stdout, quiet.stderr, quiet.returncode), (loud.stdout, "", 0))


class Meant(CommandLineTest):
    def test_nothing_is_near(self):
        for call in [["wobble"], ["eval", "--law", "x" * 100000, "--c", "1"], ["eval", "--law", "", "--c", "1"],
                     [*EVAL, "--sea", "1"], [*EVAL, "extra"], ["eval", "--law", "hertz:n=1", "--c", "1"],
                     ["validate", "--patch", "disc:a=1"]]:
            self.assert_fails(2, [], *call)
            self.assertNotIn("did you mean", run(*call).stderr, call)

    def test_what_to_do_instead(self):
        self.assertIn("python -m limitcurve.lint", run("lint", "scene.xml").stderr)
        webots = run("translate", "--law", "hertz", "--mu", "1", "--read", "webots.coulombFriction=-1")
        self.assertIn("leave out", webots.stderr)


if __name__ == "__main__":
    unittest.main()
