# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment with known intrinsics, in g2o.

import worlds

world = worlds.bundle()

# [program]
import g2o
import numpy as np

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE3(g2o.LinearSolverCholmodSE3())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
camera = g2o.CameraParameters(world.focal, world.center, 0)
camera.set_id(0)
optimizer.add_parameter(camera)
count = len(world.cameras_guess)
for i, pose in enumerate(world.cameras_guess):
    vertex = g2o.VertexSE3Expmap()
    vertex.set_id(i)
    vertex.set_estimate(g2o.SE3Quat(pose).inverse())
    vertex.set_fixed(i < 2)
    optimizer.add_vertex(vertex)
for k, point in enumerate(world.points_guess):
    vertex = g2o.VertexSBAPointXYZ()
    vertex.set_id(count + k)
    vertex.set_estimate(point)
    vertex.set_marginalized(True)
    optimizer.add_vertex(vertex)
for i, k, pixel in zip(world.camera, world.point, world.pixels):
    edge = g2o.EdgeProjectXYZ2UV()
    edge.set_vertex(0, optimizer.vertex(count + k))
    edge.set_vertex(1, optimizer.vertex(i))
    edge.set_measurement(pixel)
    edge.set_information(np.identity(2))
    edge.set_robust_kernel(g2o.RobustKernelHuber(2))
    edge.set_parameter_id(0, 0)
    optimizer.add_edge(edge)
optimizer.initialize_optimization()
optimizer.optimize(20)
found = np.array([optimizer.vertex(count + k).estimate() for k in range(len(world.points_guess))])
# [/program]

assert abs(found - world.points).max() < 0.05
