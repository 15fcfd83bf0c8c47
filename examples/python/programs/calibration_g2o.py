# SPDX-License-Identifier: BSD-3-Clause
# The pose of a sensor on a robot, from landmarks that it sees from known poses, in g2o.

import worlds

world = worlds.sensor()

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverEigenX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
count = len(world.poses)
for id, pose in enumerate(world.poses):
    vertex = g2o.VertexSE2()
    vertex.set_id(id)
    vertex.set_estimate(g2o.SE2(pose))
    vertex.set_fixed(True)
    optimizer.add_vertex(vertex)
for k, point in enumerate(world.points_guess):
    vertex = g2o.VertexPointXY()
    vertex.set_id(count + k)
    vertex.set_estimate(point)
    optimizer.add_vertex(vertex)
sensor = g2o.VertexSE2()
sensor.set_id(count + len(world.points_guess))
sensor.set_estimate(g2o.SE2())
optimizer.add_vertex(sensor)
for pose, point, seen in zip(world.pose, world.point, world.seen):
    edge = g2o.EdgeSE2PointXYCalib()
    edge.set_vertex(0, optimizer.vertex(pose))
    edge.set_vertex(1, optimizer.vertex(count + point))
    edge.set_vertex(2, sensor)
    edge.set_measurement(seen)
    edge.set_information(np.identity(2))
    optimizer.add_edge(edge)
optimizer.initialize_optimization()
optimizer.optimize(20)
found = sensor.estimate()
# [/program]

np.testing.assert_allclose(found.to_vector(), world.truth, atol=0.02)
