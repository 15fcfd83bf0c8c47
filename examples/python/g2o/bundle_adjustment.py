# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment with outliers, as a program for g2o's Python bindings: cameras along a line look at points.

import g2o
import numpy as np

random = np.random.default_rng(2)
points = np.c_[random.uniform(-1.5, 1.5, 200), random.uniform(-0.5, 0.5, 200), random.uniform(3, 4, 200)]

# [program]
optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverSE3(g2o.LinearSolverCholmodSE3())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))

camera = g2o.CameraParameters(500, (320, 240), 0)
camera.set_id(0)
optimizer.add_parameter(camera)

poses = [g2o.SE3Quat(np.identity(3), [0.08 * i - 0.6, 0, 0]) for i in range(15)]
for i, pose in enumerate(poses):
    vertex = g2o.VertexSE3Expmap()
    vertex.set_id(i)
    vertex.set_estimate(pose if i < 2 else g2o.SE3Quat.exp(0.01 * random.normal(size=6)) * pose)
    vertex.set_fixed(i < 2)
    optimizer.add_vertex(vertex)

for k, point in enumerate(points):
    vertex = g2o.VertexSBAPointXYZ()
    vertex.set_id(len(poses) + k)
    vertex.set_marginalized(True)
    vertex.set_estimate(point + 0.1 * random.normal(size=3))
    optimizer.add_vertex(vertex)
    for i, pose in enumerate(poses):
        pixel = camera.cam_map(pose * point) + random.normal(size=2)
        if random.random() < 0.05:
            pixel = random.uniform([0, 0], [640, 480])  # an outlier
        edge = g2o.EdgeProjectXYZ2UV()
        edge.set_vertex(0, vertex)
        edge.set_vertex(1, optimizer.vertex(i))
        edge.set_measurement(pixel)
        edge.set_information(np.identity(2))
        edge.set_robust_kernel(g2o.RobustKernelHuber(np.sqrt(5.991)))
        edge.set_parameter_id(0, 0)
        optimizer.add_edge(edge)

# Optimizes with the kernel, sets the outliers aside, and optimizes again.
optimizer.initialize_optimization()
optimizer.optimize(10)
outliers = 0
for edge in optimizer.edges():
    if edge.chi2() > 5.991:
        edge.set_level(1)
        outliers += 1
    edge.set_robust_kernel(None)
optimizer.initialize_optimization(0)
optimizer.optimize(10)
# [/program]

errors = [np.linalg.norm(optimizer.vertex(len(poses) + k).estimate() - point) for k, point in enumerate(points)]
print(f"{outliers} of {len(optimizer.edges())} observations are outliers; median error of a point: {np.median(errors):.4f} m")
rows = 2 * len(optimizer.active_edges()) - 6 * (len(poses) - 2) - 3 * len(points)
assert 0.8 < optimizer.active_chi2() / rows < 1.1 and np.median(errors) < 0.1
