# SPDX-License-Identifier: BSD-3-Clause
# Poses and landmarks from odometry, angles and distances, in g2o. It has no edge for a distance, so the two are converted to
# a position.

import worlds

world = worlds.landmarks()

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
count = len(world.guess)
for id, pose in enumerate(world.guess):
    vertex = g2o.VertexSE2()
    vertex.set_id(id)
    vertex.set_estimate(g2o.SE2(pose))
    vertex.set_fixed(id == 0)
    optimizer.add_vertex(vertex)
for k, point in enumerate(world.points_guess):
    vertex = g2o.VertexPointXY()
    vertex.set_id(count + k)
    vertex.set_estimate(point)
    optimizer.add_vertex(vertex)
for k, z in enumerate(world.odometry):
    edge = g2o.EdgeSE2()
    edge.set_vertex(0, optimizer.vertex(k))
    edge.set_vertex(1, optimizer.vertex(k + 1))
    edge.set_measurement(g2o.SE2(z))
    edge.set_information(world.omega)
    optimizer.add_edge(edge)
for k, l, angle, distance in zip(world.pose, world.point, world.angles, world.ranges):
    R = g2o.Rotation2d(angle).to_rotation_matrix()
    edge = g2o.EdgeSE2PointXY()
    edge.set_vertex(0, optimizer.vertex(k))
    edge.set_vertex(1, optimizer.vertex(count + l))
    edge.set_measurement(distance * R[:, 0])
    edge.set_information(R @ np.diag([1 / 0.1**2, 1 / (0.02 * distance)**2]) @ R.T)
    optimizer.add_edge(edge)
optimizer.initialize_optimization()
optimizer.optimize(20)
landmarks = np.array([optimizer.vertex(count + k).estimate() for k in range(len(world.points_guess))])
# [/program]

assert np.linalg.norm(landmarks - world.points, axis=1).max() < 0.5
