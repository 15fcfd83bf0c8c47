# SPDX-License-Identifier: BSD-3-Clause
# Four poses on a square, as a program for g2o's Python bindings. docs/from_python.md shows the same with boxplus.

import os
import tempfile

os.chdir(tempfile.mkdtemp())

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))

for i, (x, y, theta) in enumerate([(0, 0, 0), (1.9, 0.2, 1.4), (2.1, 2.2, 3.0), (0.3, 1.8, -1.7)]):
    vertex = g2o.VertexSE2()
    vertex.set_id(i)
    vertex.set_estimate(g2o.SE2(x, y, theta))
    vertex.set_fixed(i == 0)
    optimizer.add_vertex(vertex)

for i in range(4):
    edge = g2o.EdgeSE2()
    edge.set_vertex(0, optimizer.vertex(i))
    edge.set_vertex(1, optimizer.vertex((i + 1) % 4))
    edge.set_measurement(g2o.SE2(2, 0, np.pi / 2))
    edge.set_information(np.diag([100, 100, 400]))
    edge.set_robust_kernel(g2o.RobustKernelHuber(1.345))
    optimizer.add_edge(edge)

optimizer.initialize_optimization()
optimizer.optimize(20)
optimizer.save("square.g2o")
print(optimizer.vertex(3).estimate().to_vector(), optimizer.chi2())
# [/program]

np.testing.assert_allclose(optimizer.vertex(3).estimate().to_vector(), [0, 2, -np.pi / 2], atol=1e-6)
other = g2o.SparseOptimizer()
assert other.load("square.g2o") and other.chi2() == optimizer.chi2()
