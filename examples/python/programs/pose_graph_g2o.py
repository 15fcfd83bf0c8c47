# SPDX-License-Identifier: BSD-3-Clause
# A pose graph from arrays, in g2o.

import worlds

world = worlds.pose_graph()

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
for id, pose in enumerate(world.guess):
    vertex = g2o.VertexSE2()
    vertex.set_id(id)
    vertex.set_estimate(g2o.SE2(pose))
    vertex.set_fixed(id == 0)
    optimizer.add_vertex(vertex)
for i, j, z in zip(world.i, world.j, world.z):
    edge = g2o.EdgeSE2()
    edge.set_vertex(0, optimizer.vertex(i))
    edge.set_vertex(1, optimizer.vertex(j))
    edge.set_measurement(g2o.SE2(z))
    edge.set_information(world.omega)
    optimizer.add_edge(edge)
optimizer.initialize_optimization()
optimizer.optimize(20)
poses = np.array([optimizer.vertex(id).estimate().to_vector() for id in range(len(world.guess))])
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.4
