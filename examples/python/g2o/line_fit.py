# SPDX-License-Identifier: BSD-3-Clause
# A line through points, with a vertex and an edge that are written in Python, as a program for g2o's Python bindings.

import g2o
import numpy as np

random = np.random.default_rng(8)
xs = np.linspace(0, 10, 50)
ys = 2.5 * xs - 1 + 0.1 * random.normal(size=50)

# [program]
class Line(g2o.VectorXVertex):
    def __init__(self):
        super().__init__()
        self.set_dimension(2)
        self.set_estimate([0, 0])

    def oplus_impl(self, step):
        self.set_estimate(self.estimate() + step)


class PointOnLine(g2o.VariableVectorXEdge):
    def __init__(self, line, point):
        super().__init__()
        self.set_dimension(1)
        self.resize(1)
        self.set_vertex(0, line)
        self.set_measurement(point)
        self.set_information(np.eye(1) / 0.1**2)

    def compute_error(self):
        slope, intercept = self.vertex(0).estimate()
        x, y = self.measurement()
        return [slope * x + intercept - y]


optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverDenseX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
line = Line()
line.set_id(0)
optimizer.add_vertex(line)
for point in zip(xs, ys):
    optimizer.add_edge(PointOnLine(line, point))
optimizer.initialize_optimization()
optimizer.optimize(10)
print(line.estimate())
# [/program]

np.testing.assert_allclose(line.estimate(), np.polyfit(xs, ys, 1), atol=1e-6)
