# SPDX-License-Identifier: BSD-3-Clause
"""The stubs of the module in mypy: a right program has no errors, and a wrong program has the expected ones."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import boxplus

MYPY = shutil.which("mypy")
if MYPY is None:
    print("SKIPPED: there is no mypy")
    sys.exit(77)

RIGHT = """
from typing import Any

import numpy as np
from boxplus import (SE2, SE3, BalCamera, BatchedEdge, Between, CalibratedReprojection, Constraint, Graph, Line3, Optimizer,
                     Options, PinholeCamera, Plane3, PlaneObservation3, PositionPrior, Prior, Reprojection, Sim3, StopFlag, Vector2, Vector3, VertexRef, certify, covariance, diagnose, find_outliers, load,
                     optimize, plot, rows, se3_sigmas, view)


class Distance(BatchedEdge):
    def error(self, a: Any, b: Any, z: Any) -> Any:
        return np.linalg.norm(a[:, :2] - b[:, :2], axis=1) - z[:, 0]


graph = Graph()
a: VertexRef = graph.add_vertex(SE2(0, 0, 0), id=0)
graph.add_vertex(Vector2(1, 2))
graph.add_vertex([1, 2])
numbers: np.ndarray[Any, np.dtype[np.float64]] = Vector3(1, 2, 3)
ids = graph.add_vertices(SE2, None, np.zeros((3, 3)))
graph.add_vertices(Vector3, np.arange(10, 12), np.zeros((2, 3)))
edge = graph.add_edge(Between(SE2(1, 0, 0)), a, 3, information=np.eye(3))
graph.add_edge(lambda x: x.theta(), 3)
graph.add_edges(Distance(), ids[:-1], ids[1:], measurements=np.ones(2), informations=3.0)
graph.add_edges(Between, ids[:-1], ids[1:], measurements=np.zeros((2, 3)))
graph.set_kernel([edge], "Huber", 1)
report = optimize(graph, Options(max_iterations=3), stop=StopFlag(), start="odometry")
total: float = report.chi2_final + Optimizer(graph).run().chi2_start()
found, poses = graph.estimates(SE2)
moved = rows.times(poses, poses)[:, 0] + covariance(graph, [a, 3]).of(a)[0, 0]
point = SE3().inverse_times([1.0, 2.0, 3.0]) + (SE3() * SE3()).translation()
plot.trajectory(graph)
camera = graph.add_vertex(PinholeCamera(fx=500, fy=500, cx=320, cy=240))
pixels = PinholeCamera(500, 500, 320, 240).project(np.ones((2, 3)))
graph.add_edges(Reprojection, 3, ids, camera, measurements=pixels)
scale: float = (Sim3() * Sim3()).scale() + graph.estimates((SE3, BalCamera))[1][0, 7] + certify(graph).bound
graph.add_vertices(Sim3, None, np.ones((1, 8)))
wall = graph.add_vertex(Plane3([1, 0, 0, -2], color=[1, 0, 0]))
graph.add_edge(PlaneObservation3(Plane3().seen_from(SE3())), 3, wall, information=np.eye(3))
graph.add_edge(Constraint(lambda x: x.theta()), 3)
graph.add_edge(Constraint(Between(SE2(1, 0, 0))), ids[0], ids[1])
graph.add_edges(Constraint(Distance()), ids[:-1], ids[1:], measurements=np.ones(2))
graph.add_edges(CalibratedReprojection, 3, ids, measurements=pixels, camera=PinholeCamera(500, 500, 320, 240))
with view(graph, name="walls") as viewer:
    address: str = viewer.url
graph.add_vertex((SE3(), Vector3(1, 0, 0)))
graph.add_vertices((SE3, Vector3), None, np.zeros((0, 10)))
graph.add_vertices(Line3, None, [Line3.through([1, 2, 3], [0, 0, 1]).vector()])
"""

WRONG = """
from boxplus import SE2, Graph, Vector2, optimize, rows
graph = Graph()
Vector2("x", 1)  # error: arg-type
graph.fix(SE2())  # error: arg-type
optimize(graph).chi2_finale  # error: attr-defined
graph.add_vertices(float, None, [])  # error: arg-type
rows.inverse(1)  # error: arg-type
graph.add_vertx(SE2())  # error: attr-defined
"""


def check(program):
    """The output of mypy for a program."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "program.py"
        path.write_text(program, encoding="utf-8")
        return subprocess.run([MYPY, "--strict", "--no-color-output", "--cache-dir", folder, path], capture_output=True, text=True,
                              check=False, env={**os.environ, "MYPYPATH": str(pathlib.Path(boxplus.__file__).parents[1])}).stdout


class Types(unittest.TestCase):
    def test_a_right_program_has_no_errors(self):
        self.assertIn("Success", check(RIGHT))

    def test_a_wrong_program_has_the_expected_errors(self):
        lines = WRONG.splitlines()
        expected = [(number, line.split("# error: ")[1]) for number, line in enumerate(lines, 1) if "# error: " in line]
        found = re.findall(r"^.*program\.py:(\d+): error: .*\[([\w-]+)\]$", check(WRONG), re.MULTILINE)
        self.assertEqual([(int(number), code) for number, code in found], expected)


if __name__ == "__main__":
    unittest.main()
