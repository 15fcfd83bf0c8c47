# SPDX-License-Identifier: BSD-3-Clause
# A pose graph that grows, with an estimate after each motion, in g2o.

import worlds

world = worlds.online()

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
vertex = g2o.VertexSE2()
vertex.set_id(0)
vertex.set_fixed(True)
optimizer.add_vertex(vertex)
for k, z in enumerate(world.odometry, 1):
    vertex = g2o.VertexSE2()
    vertex.set_id(k)
    vertex.set_estimate(optimizer.vertex(k - 1).estimate() * g2o.SE2(z))
    optimizer.add_vertex(vertex)
    for i, measured in [(k - 1, z), *world.closures.get(k, ())]:
        edge = g2o.EdgeSE2()
        edge.set_vertex(0, optimizer.vertex(i))
        edge.set_vertex(1, vertex)
        edge.set_measurement(g2o.SE2(measured))
        edge.set_information(world.omega)
        optimizer.add_edge(edge)
    optimizer.initialize_optimization()
    optimizer.optimize(3)
poses = np.array([optimizer.vertex(id).estimate().to_vector() for id in range(len(world.truth))])
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.4
