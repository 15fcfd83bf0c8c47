# SPDX-License-Identifier: BSD-3-Clause
# A pose graph, a file and a custom edge, as in programs for g2o's Python modules.

import pathlib
import tempfile

folder = tempfile.TemporaryDirectory()
path = pathlib.Path(folder.name) / "square.g2o"

# [graph]
import numpy as np
from boxplus import SE2, Between, Graph, optimize

graph = Graph()
for i, (x, y, theta) in enumerate([(0, 0, 0), (1.9, 0.2, 1.4), (2.1, 2.2, 3.0), (0.3, 1.8, -1.7)]):
    graph.add_vertex(SE2(x, y, theta), id=i)
graph.fix(0)
for i in range(4):
    edge = graph.add_edge(Between(SE2(2, 0, np.pi / 2)), i, (i + 1) % 4, information=np.diag([100, 100, 400]))
    graph.set_kernel(edge, "Huber", 1.345)

optimize(graph, algorithm="levenberg-marquardt", max_iterations=20)
graph.save(path)
print(graph.estimate(3), graph.chi2())
# [/graph]

import boxplus

np.testing.assert_allclose(graph.estimate(3).vector(), [0, 2, -np.pi / 2], atol=1e-6)
np.testing.assert_array_equal(boxplus.load(path).estimate(3).vector(), graph.estimate(3).vector())

random = np.random.default_rng(8)
xs = np.linspace(0, 10, 50)
ys = 2.5 * xs - 1 + 0.1 * random.normal(size=50)

# [line]
from boxplus import BatchedEdge, Vector2


class PointOnLine(BatchedEdge):
    def error(self, line, point):  # line (n, 2): the same slope and intercept for all; point (n, 2)
        return line[:, 0] * point[:, 0] + line[:, 1] - point[:, 1]


graph = Graph()
line = graph.add_vertex(Vector2(0, 0))
graph.add_edges(PointOnLine(), line, measurements=np.c_[xs, ys], informations=1 / 0.1**2)
optimize(graph)
print(graph.estimate(line))
# [/line]

np.testing.assert_allclose(graph.estimate(line), np.polyfit(xs, ys, 1), atol=1e-9)
