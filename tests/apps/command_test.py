#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the boxplus command as users do, and looks at outputs and exit codes.

    command_test.py PATH_OF_BOXPLUS DATA_FOLDER
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

BOXPLUS, DATA = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*arguments):
    words = [BOXPLUS, *map(str, arguments)]
    return subprocess.run(words, capture_output=True, encoding="utf-8", check=False, timeout=300)


class CommandTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def written(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")
        return self.path / name

    def test_version_and_help_go_to_stdout(self):
        self.assertRegex(run("--version").stdout, r"^boxplus \d+\.\d+\.\d+")
        for words in (["--help"], ["optimize", "--help"], ["simulate", "--help"], ["plot", "--help"]):
            done = run(*words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("Usage", done.stdout)
        self.assertIn("Exit codes", run("--help").stdout)

    def test_wrong_usage_is_2(self):
        for words in ([], ["dance"], ["optimize"], ["simulate", "moon", "-o", "x"], ["optimize", "f", "--threads", "-1"]):
            done = run(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertNotEqual(done.stderr, "")

    def test_optimizes_the_sample(self):
        done = run("optimize", DATA / "01_town.g2o", "-o", self.path / "out.g2o", "--json", self.path / "out.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("chi2", done.stdout)
        report = json.loads((self.path / "out.json").read_text(encoding="utf-8"))
        self.assertEqual(report["status"], "converged")
        self.assertLess(report["chi2_final"], report["chi2_initial"])
        self.assertEqual(report["start"]["requested"], "automatic")
        for key in ("reason", "iterations", "gauge", "threads", "vertices", "edges"):
            self.assertIn(key, report)
        for key in ("load", "plan", "optimize", "total"):
            self.assertGreaterEqual(report["time_s"][key], 0)
        again = run("optimize", self.path / "out.g2o", "--quiet", "--json", self.path / "again.json")
        self.assertEqual((again.returncode, again.stdout), (0, ""))
        again = json.loads((self.path / "again.json").read_text(encoding="utf-8"))
        self.assertAlmostEqual(again["chi2_initial"] / report["chi2_final"], 1, places=12)

    def test_not_converged_is_1(self):
        run("simulate", "manhattan", "--poses", 200, "-o", self.path / "m.g2o")
        done = run("optimize", self.path / "m.g2o", "--iterations", 1, "--start", "current")
        self.assertEqual(done.returncode, 1)
        self.assertNotEqual(done.stderr, "")

    def test_bad_input_is_2_and_named(self):
        bad = self.written("bad.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 zero 0\n")
        done = run("optimize", bad)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("bad.g2o:2:16: expected y (a finite number), got 'zero'", done.stderr)
        self.assertEqual(run("optimize", self.path / "missing.g2o").returncode, 2)
        self.assertIn("skipped", run("optimize", bad, "--lenient").stderr)

    def test_results_do_not_depend_on_the_threads(self):
        run("simulate", "sphere", "--poses", 225, "-o", self.path / "s.g2o")
        for threads in (1, 2, 4):
            run("optimize", self.path / "s.g2o", "-o", self.path / f"{threads}.g2o", "--threads", threads)
        texts = {(self.path / f"{threads}.g2o").read_bytes() for threads in (1, 2, 4)}
        self.assertEqual(len(texts), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
