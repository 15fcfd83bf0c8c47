#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that every sub-command that reads graphs works with logs of CARMEN, Gm2dl files and iSAM files."""

import json
import math

from command_case import CommandCase, main, run

STAMP = "1 host 2"
SCAN = f"ROBOTLASER1 0 -1 2 1 10 0 0 3 1 2 1 0 1 0 0.5 1 0 0.5 0 0 0 0 0 {STAMP}\n"
CARMEN = f"ODOM 0 0 0 0.5 0 0 {STAMP}\n{SCAN}ODOM 2 0.5 1 0.5 0 0 {STAMP}\n"
GM2DL = f"VERTEX 0 0 0 0\n{SCAN}VERTEX 1 1 0 0.5\nEDGE 0 1 1.1 0 0.5 4 1 3 2 0 0.5\n"
# A square of 2 m, and a landmark in its center.
ISAM = "".join(f"ODOMETRY {i} {(i + 1) % 4} 2 0 {math.pi / 2} 10 0 0 10 0 20\nLANDMARK {i} 0 1 1 10 0 10\n"
               for i in range(4))
TEXTS = {"log.clf": CARMEN, "graph.gm2dl": GM2DL, "graph.isam": ISAM}

class LogsTest(CommandCase):
    def test_a_log_is_converted_with_its_scans(self):
        done = run("convert", self.written("log.clf", CARMEN), "-")
        self.assertEqual(done.returncode, 0)
        lines = done.stdout.splitlines(keepends=True)
        self.assertEqual([line.split()[0] for line in lines],
                         ["VERTEX_SE2", "VERTEX_SE2", "ROBOTLASER1", "VERTEX_SE2", "EDGE_SE2", "EDGE_SE2"])
        self.assertEqual(lines[2], SCAN)
        self.assertIn("covariances: they are assumed for 2 edges of the odometry", done.stderr)

    def test_an_isam_file_is_optimized_from_an_initial_guess(self):
        path = self.written("graph.isam", ISAM)
        done = run("optimize", path, "-o", self.path / "out.g2o", "--json", self.path / "report.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("landmark n became vertex 10 + n", done.stderr)
        self.assertLess(json.loads((self.path / "report.json").read_text(encoding="utf-8"))["chi2_final"], 1e-12)
        lines = (self.path / "out.g2o").read_text(encoding="utf-8").splitlines()
        self.assertEqual([line.split()[:2] for line in lines if line.startswith("VERTEX_XY")], [["VERTEX_XY", "10"]])

    def test_graphs_can_be_optimized_inspected_and_drawn(self):
        for name, text in TEXTS.items():
            path = self.written(name, text)
            for words in (["optimize", path, "-o", self.path / "out.g2o"], ["info", path],
                          ["plot", path, "-o", self.path / "out.svg"]):
                done = run(*words)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(run("info", "-", stdin=text).returncode, 0)

    def test_the_worst_edges_of_an_isam_file_are_named_with_their_lines(self):
        text = "# a comment\n" + ISAM.replace("LANDMARK 2 0 1 1 ", "LANDMARK 2 0 1 9 ")
        report = json.loads(run("info", "-", "--json", "-", stdin=text).stdout)
        lines = {tuple(edge["vertices"]): edge["line"] for edge in report["worst_edges"]}
        self.assertEqual(lines[2, 10], 7)

    def test_a_trajectory_is_compared(self):
        log = self.written("log.clf", CARMEN)
        run("convert", log, self.path / "truth.g2o")
        done = run("compare", log, self.path / "truth.g2o")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_bad_input_is_refused(self):
        cases = {"log.clf": ("ODOM 1 x\n", "log.clf:4:8: expected the pose of the robot (a finite number), got 'x'"),
                 "graph.gm2dl": ("EDGE 0 7 1 0 0 1 0 1 1 0 0\n", "graph.gm2dl:5:8: expected the id of a vertex"),
                 "graph.isam": ("LANDMARK 0 1 2\n", "graph.isam:9:15: expected a coordinate of the landmark")}
        for name, (bad, complaint) in cases.items():
            path = self.written(name, TEXTS[name] + bad)
            for words in (["optimize", path], ["info", path], ["convert", path, self.path / "out.g2o"],
                          ["plot", path, "-o", self.path / "out.svg"], ["view", path]):
                self.assert_refused(run(*words), complaint)
            self.assertEqual(run("info", path, "--lenient").returncode, 0)

    def test_graphs_cannot_be_written_in_some_of_these_formats(self):
        path = self.written("log.clf", CARMEN)
        for name in ("log.clf", "graph.isam"):
            done = run("convert", path, self.path / f"out_{name}")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("as output, because boxplus can only read", done.stderr)

if __name__ == "__main__":
    main()
