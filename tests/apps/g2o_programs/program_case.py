# SPDX-License-Identifier: BSD-3-Clause
"""The code that the tests of the programs with g2o's switches share. Each test is run as X_test.py FOLDER, the folder
of the programs."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv[1])

def run(program, *arguments, stdin="", environment=None):
    """Runs a program to its end, and returns its output as text."""
    return subprocess.run([FOLDER / program, *map(str, arguments)], input=stdin, capture_output=True, encoding="utf-8",
                          check=False, timeout=300, env=environment)

def final_chi2(done):
    return float(re.search(r"^# final chi2 = (\S+)$", done.stderr, re.MULTILINE).group(1))

class ProgramCase(unittest.TestCase):
    """A test with its own empty folder, `self.path`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def written(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")
        return self.path / name

    def assert_switches(self, program, names):
        """Requires that the help lists exactly these switches, and that -h, -help and --help print it."""
        for switch in ("-h", "-help", "--help"):
            done = run(program, switch)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            listed = re.findall(r"^-(\w+) ", done.stdout, re.MULTILINE)
            self.assertEqual(sorted(listed), sorted([*names, "help"]))

    def assert_refused(self, done, code, *texts):
        """Requires an exit code, nothing on stdout, and a message with all texts."""
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        for text in texts:
            self.assertIn(text, done.stderr)

def main():
    unittest.main(argv=sys.argv[:1])
