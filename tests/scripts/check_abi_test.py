#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests scripts/check_abi.sh with small libraries."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts" / "check_abi.sh"
HEADER = """
struct Options { double tolerance; int iterations; };
int run(const Options& options);
int stop();
"""
SOURCE = """
struct Private { int first; };
static Private kept;
int run(const Options& options) { return options.iterations + kept.first; }
int stop() { return 0; }
int help_stop() { return 1; }
"""

@unittest.skipUnless(shutil.which("abidiff"), "abidiff is not installed (Debian's package abigail-tools)")
class CheckAbi(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.old = self.library("old")

    def library(self, name, header=HEADER, source=SOURCE):
        """Builds a library, and returns its path and that of the folder with its header."""
        folder = self.path / name
        folder.mkdir()
        (folder / "library.h").write_text(header)
        (folder / "library.cpp").write_text('#include "library.h"\n' + source)
        subprocess.run(["g++", "-shared", "-fPIC", "library.cpp", "-o", "library.so"], cwd=folder, check=True)
        return folder / "library.so", folder

    def compared(self, new, new_version="1.0.1"):
        command = [SCRIPT, "--libraries", self.old[0], new[0], "1.0.0", new_version, self.old[1], new[1]]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_two_equal_builds_do_not_differ(self):
        done = self.compared(self.library("new"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("can replace version 1.0.0", done.stdout)

    def test_new_functions_and_types_and_what_is_private_are_no_break(self):
        source = SOURCE.replace("int first;", "int first, second;").replace("help_stop", "help") + "int more() { return 1; }\n"
        header = HEADER + "struct More { int first; };\nint more();\n"
        self.assertEqual(self.compared(self.library("new", header, source)).returncode, 0)

    def test_a_removed_function_is_a_break(self):
        new = self.library("new", HEADER.replace("int stop();", ""), SOURCE.replace("int stop() { return 0; }", ""))
        done = self.compared(new)
        self.assertEqual(done.returncode, 1)
        self.assertIn("stop()", done.stdout)
        self.assertIn("break with version 1.0.1", done.stderr)

    def test_a_changed_layout_is_a_break(self):
        new = self.library("new", HEADER.replace("double tolerance; int iterations;", "int iterations; double tolerance;"))
        done = self.compared(new)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Options", done.stdout)

    def test_a_new_minor_version_announces_a_break(self):
        new = self.library("new", HEADER.replace("int stop();", ""), SOURCE.replace("int stop() { return 0; }", ""))
        self.assertEqual(self.compared(new, "1.1.0").returncode, 0)

    def test_wrong_arguments_are_refused(self):
        done = subprocess.run([SCRIPT, "--libraries", "one"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)

if __name__ == "__main__":
    unittest.main()
