# SPDX-License-Identifier: BSD-3-Clause
# A robot drives along a square and returns to its start. README.md shows this program.

# [program]
import numpy as np
from boxplus import SE2, Between, Graph, optimize

graph = Graph()
a = graph.add_vertex(SE2(0, 0, 0))  # poses: x, y in meters, heading in radians
b = graph.add_vertex(SE2(0.9, 0.1, 1.4))
c = graph.add_vertex(SE2(1.2, 1.1, 3.0))
graph.fix(a)
graph.add_edge(Between(SE2(1, 0, np.pi / 2)), a, b, information=100)  # b relative to a; or a matrix
graph.add_edge(Between(SE2(1, 0, np.pi / 2)), b, c, information=100)
report = optimize(graph)
print(report, graph.estimate(c).vector())
# [/program]

assert report.converged()
np.testing.assert_allclose(graph.estimate(c).vector(), [1, 1, np.pi], atol=1e-9)
