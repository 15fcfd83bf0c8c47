# SPDX-License-Identifier: BSD-3-Clause
# Generalized ICP, as a program for g2o's Python bindings: finds the motion between two scans of the same surface.

import g2o
import numpy as np

random = np.random.default_rng(3)
truth = g2o.Isometry3d(g2o.Quaternion(g2o.AngleAxis(0.1, np.array([0.6, 0, 0.8]))), np.array([0.3, -0.2, 0.1]))
xy = random.uniform(-5, 5, (500, 2))
points = np.c_[xy, np.sin(xy[:, 0]) + np.cos(xy[:, 1])]  # in the frame of the first scan
normals = np.c_[-np.cos(xy[:, 0]), np.sin(xy[:, 1]), np.ones(500)]
normals /= np.linalg.norm(normals, axis=1, keepdims=True)

# [program]
optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverDenseX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))

for i in range(2):
    vertex = g2o.VertexSE3()
    vertex.set_id(i)
    vertex.set_estimate(g2o.Isometry3d())
    vertex.set_fixed(i == 0)
    optimizer.add_vertex(vertex)

for point, normal in zip(points, normals):
    pair = g2o.EdgeGICP()
    pair.pos0, pair.normal0 = point + 0.01 * random.normal(size=3), normal
    pair.pos1, pair.normal1 = truth.inverse() * point + 0.01 * random.normal(size=3), truth.R.T @ normal
    edge = g2o.EdgeVVGicp()
    edge.set_vertex(0, optimizer.vertex(0))
    edge.set_vertex(1, optimizer.vertex(1))
    edge.set_measurement(pair)
    edge.set_information(pair.prec0(0.01))  # a point may slide along the surface
    optimizer.add_edge(edge)

optimizer.initialize_optimization()
optimizer.optimize(10)
motion = optimizer.vertex(1).estimate()
# [/program]

error = truth.inverse() * motion
print(f"error: {np.linalg.norm(error.t):.4f} m, {g2o.AngleAxis(error.orientation()).angle():.5f} rad")
assert np.linalg.norm(error.t) < 0.01 and g2o.AngleAxis(error.orientation()).angle() < 0.003

# The same with normals of both scans (plane to plane).
for edge in optimizer.edges():
    edge.pl_pl = True
    edge.cov0, edge.cov1 = edge.measurement().cov0(0.01), edge.measurement().cov1(0.01)
optimizer.vertex(1).set_estimate(g2o.Isometry3d())
optimizer.initialize_optimization()
optimizer.optimize(20)
error = truth.inverse() * optimizer.vertex(1).estimate()
assert np.linalg.norm(error.t) < 0.01

# And with a stereo camera at each pose that sees the points. Points of both scans are vertices.
g2o.VertexSCam.set_cam(500, 500, 320, 240, 0.1)
optimizer = g2o.SparseOptimizer()
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(g2o.BlockSolverSE3(g2o.LinearSolverEigenSE3())))
cameras = []
for i, pose in enumerate((g2o.Isometry3d(np.identity(3), [0, 0, -12]), g2o.Isometry3d(np.identity(3), [0, 0, -12]) * truth)):
    vertex = g2o.VertexSCam()
    vertex.set_id(i)
    vertex.set_estimate(pose)
    vertex.set_fixed(i == 0)
    vertex.set_all()
    optimizer.add_vertex(vertex)
    cameras.append(vertex)
for k, point in enumerate(points[:100]):
    vertex = g2o.VertexPointXYZ()
    vertex.set_id(10 + k)
    vertex.set_estimate(point + 0.1 * random.normal(size=3))
    vertex.set_marginalized(True)
    optimizer.add_vertex(vertex)
    for camera in cameras:
        edge = g2o.Edge_XYZ_VSC()
        edge.resize(2)
        edge.set_vertex(0, vertex)
        edge.set_vertex(1, camera)
        edge.set_measurement(camera.map_point(point) + 0.1 * random.normal(size=3))
        edge.set_information(np.identity(3) / 0.1**2)
        optimizer.add_edge(edge)
pose = cameras[1].estimate()
cameras[1].set_estimate(cameras[0].estimate())
optimizer.initialize_optimization()
optimizer.optimize(20)
rows = 3 * len(optimizer.edges()) - 6 - 3 * 100
assert 0.7 < optimizer.chi2() / rows < 1.3 and np.linalg.norm((pose.inverse() * cameras[1].estimate()).t) < 0.1
