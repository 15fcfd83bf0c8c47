# SPDX-License-Identifier: BSD-3-Clause
"""The code that all tests of the boxplus command share. Each test is run as X_test.py PATH_OF_BOXPLUS DATA_FOLDER."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BOXPLUS, DATA = sys.argv[1], pathlib.Path(sys.argv[2])
TOWN = DATA / "01_town.g2o"

def run(*arguments, stdin="", environment=None):
    """Runs boxplus to its end, and returns its output as text. Adds `environment` to the environment of the test."""
    words = [BOXPLUS, *map(str, arguments)]
    return subprocess.run(words, input=stdin, capture_output=True, encoding="utf-8", check=False, timeout=300,
                          env={**os.environ, **(environment or {})})

def choices(command, option):
    """The values that the help of a command lists for an option or an argument."""
    text = " ".join(run(command, "--help").stdout.split())
    return re.search(rf" {option} .*?\(one of ([^;)]*)", text).group(1).split(", ")

class CommandCase(unittest.TestCase):
    """A test with its own empty folder, `self.path`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def written(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")
        return self.path / name

    def assert_refused(self, done, *texts):
        """Requires exit code 2, nothing on stdout, and one message that contains all texts."""
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertRegex(done.stderr, r"\Aboxplus: [^\n]*\n\Z")
        for text in texts:
            self.assertIn(text, done.stderr)

def main():
    unittest.main(argv=sys.argv[:1])
