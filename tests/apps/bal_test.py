#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that every sub-command that reads graphs works with problems of bundle adjustment (BAL)."""

import json
import math

from command_case import CommandCase, main, run

CAMERAS = [(0, 0), (1, 0), (0, 1)]
POINTS = [(x, y, -8 - x * y) for x in (-2, -1, 1, 2) for y in (-1, 0, 1)]

def problem():
    """Three cameras that look along -z from known places, and points in front of them. The first estimates are off."""
    observations = []
    for camera, (cx, cy) in enumerate(CAMERAS):
        for point, (x, y, z) in enumerate(POINTS):
            observations.append(f"{camera} {point} {-500 * (x - cx) / z!r} {-500 * (y - cy) / z!r}")
    cameras = [f"0.01\n0\n0\n{-cx}\n{-cy + 0.1}\n0\n500\n0\n0" for cx, cy in CAMERAS]
    points = [f"{x}\n{y}\n{z + 0.1}" for x, y, z in POINTS]
    header = f"{len(CAMERAS)} {len(POINTS)} {len(observations)}"
    return "\n".join([header, *observations, *cameras, *points]) + "\n"

def problem_with_a_long_focal_length():
    """A camera with a focal length of 1e18 pixels. Only its first estimate is so far off that BAL's rounding of poses is small."""
    x, y, z = 0.1, -0.2, 0.3
    angle = math.sqrt(x * x + y * y + z * z)
    s, c = math.sin(angle) / angle, (1 - math.cos(angle)) / angle ** 2
    W = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    R = [[(i == j) + s * W[i][j] + c * sum(W[i][k] * W[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    observations = []
    for point, place in enumerate(POINTS):
        X, Y, Z = (sum(R[i][k] * place[k] for k in range(3)) for i in range(3))
        observations.append(f"0 {point} {-1e18 * X / Z!r} {-1e18 * Y / Z!r}")
    values = [0.12345678912345, y, z, 0, 0, 0, 1e18, 0, 0] + [value for place in POINTS for value in place]
    return "\n".join([f"1 {len(POINTS)} {len(POINTS)}", *observations, *map(repr, values)]) + "\n"

class BalTest(CommandCase):
    def setUp(self):
        super().setUp()
        self.problem = self.written("problem-3-12-pre.txt", problem())

    def test_a_problem_is_optimized_and_written_as_bal(self):
        for name in ("out.bal", "out.txt", "out"):
            out = self.path / name
            done = run("optimize", self.problem, "-o", out, "--json", self.path / "report.json", "--quiet")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            report = json.loads((self.path / "report.json").read_text(encoding="utf-8"))
            self.assertLess(report["chi2_final"], 1e-6)
            lines = out.read_text(encoding="utf-8").splitlines()
            self.assertEqual((lines[0], len(lines)), ("3 12 36", 1 + 36 + 9 * 3 + 3 * 12))

    def test_a_result_that_bal_cannot_hold_is_written_as_json_with_its_report(self):
        problem = self.written("long.bal", problem_with_a_long_focal_length())
        out = self.path / "out.bal"
        arguments = ("optimize", problem, "--hold", "points,distortion", "-o", out)
        done = run(*arguments)
        self.assertIn("converged: chi2", done.stdout)
        self.assertIn("cannot write BAL's .bal: camera 0 and point", done.stderr)
        self.assertIn("out.bal.json instead", done.stderr)
        self.assertIn("out.bal.json.", done.stdout)
        self.assertEqual(done.returncode, 0)
        self.assertFalse(out.exists())
        self.assertEqual(run("info", self.path / "out.bal.json").returncode, 0)
        strict = run(*arguments, "--strict-output")
        self.assertIn("converged: chi2", strict.stdout)
        self.assertEqual(strict.returncode, 2)

    def test_the_optimized_problem_has_the_reported_chi2(self):
        done = run("optimize", self.problem, "-o", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("eliminated      12 vertices", done.stderr)
        again = run("optimize", "-", "--json", "-", stdin=done.stdout)
        self.assertLess(json.loads(again.stdout)["chi2_initial"], 1e-6)

    def test_a_converted_problem_has_the_same_observations(self):
        done = run("convert", self.problem, "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        values = [float(value) for value in done.stdout.split()]
        self.assertEqual(len(values), len(problem().split()))
        for a, b in zip(values, map(float, problem().split())):
            self.assertAlmostEqual(a, b, places=12)

    def test_a_problem_can_be_inspected_and_drawn(self):
        done = run("info", self.problem)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Product<SE3, BAL>", done.stdout)
        report = json.loads(run("info", self.problem, "--json", "-").stdout)
        for edge in report["worst_edges"]:
            camera, point = edge["vertices"]
            self.assertEqual(edge["line"], 2 + 12 * camera + point - 3)
        done = run("plot", self.problem, "-o", self.path / "out.svg")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_points_without_observations_are_noted_and_do_not_matter(self):
        text = problem().replace("3 12 36", "3 13 36") + "0\n0\n0\n"
        done = run("optimize", self.written("more.txt", text))
        self.assertEqual(done.returncode, 0)
        self.assertIn("more.txt: 1 point has no observations", done.stderr)

    def test_bad_input_is_refused(self):
        path = self.written("bad.txt", problem().replace("0 3 ", "0 12 "))
        for words in (["optimize", path], ["info", path], ["convert", path, self.path / "out.bal"]):
            self.assert_refused(run(*words), "bad.txt:5:3: expected the index of a point (an integer from 0 to 11), got '12'")

    def test_a_problem_cannot_be_written_as_g2o_nor_a_pose_graph_as_bal(self):
        for command in (["convert", self.problem], ["optimize", self.problem, "-o"]):
            self.assert_refused(run(*command, self.path / "out.g2o"), "no tag is registered")
        self.assertFalse((self.path / "out.g2o").exists())
        graph = self.written("graph.g2o", "VERTEX_SE2 0 0 0 0\n")
        self.assert_refused(run("convert", graph, self.path / "out.bal"), "got vertex 0 of type SE2")

if __name__ == "__main__":
    main()
