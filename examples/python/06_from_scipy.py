# SPDX-License-Identifier: BSD-3-Clause
# Two programs for scipy.optimize.least_squares in boxplus: a curve with outliers, and bundle adjustment.

import numpy as np

random = np.random.default_rng(6)
t = np.linspace(0, 10, 400)
y = 2 * np.exp(-0.2 * t) * np.cos(3 * t) + 0.05 * random.normal(size=t.size)
y[::20] += 1  # outliers

# [curve]
from boxplus import BatchedEdge, Graph, Vector3, covariance, optimize


class Oscillation(BatchedEdge):
    def error(self, x, data):  # x (n, 3): the same row for all; data (n, 2): t and y
        return x[:, 0] * np.exp(-x[:, 1] * data[:, 0]) * np.cos(x[:, 2] * data[:, 0]) - data[:, 1]


graph = Graph()
x = graph.add_vertex(Vector3(1, 0, 2.9))  # amplitude, decay, frequency
edges = graph.add_edges(Oscillation(), x, measurements=np.c_[t, y], informations=1 / 0.05**2)
graph.set_kernel(edges, "Huber", 1.345)
report = optimize(graph)
print(graph.estimate(x), np.sqrt(np.diag(covariance(graph, [x]).of(x))))
# [/curve]

assert report.converged()
np.testing.assert_allclose(graph.estimate(x), [2, 0.2, 3], atol=0.03)

# The truth: 12 cameras on a circle around 300 points. A camera has 9 numbers: a rotation vector, a translation in meters,
# the focal length in pixels, and two coefficients of radial distortion.
angles = np.linspace(0, 2 * np.pi, 12, endpoint=False)
cameras = np.c_[0 * angles, angles, np.tile([0, 0, 0, 6, 500, -0.1, 0.01], (12, 1))]
points = random.uniform(-1, 1, (300, 3))
camera_of, point_of = (index.ravel() for index in np.meshgrid(np.arange(12), np.arange(300), indexing="ij"))


# [project]
def project(camera, point):
    """The pixels (n, 2) of points (n, 3) in the images of cameras (n, 9)."""
    rotation = camera[:, :3]
    angle = np.sqrt((rotation * rotation).sum(axis=1, keepdims=True) + 1e-24)
    axis = rotation / angle
    rotated = (np.cos(angle) * point + np.sin(angle) * np.cross(axis, point)
               + (1 - np.cos(angle)) * (axis * point).sum(axis=1, keepdims=True) * axis)
    p = rotated + camera[:, 3:6]
    p = p[:, :2] / p[:, 2:]
    r2 = (p * p).sum(axis=1, keepdims=True)
    return camera[:, 6:7] * (1 + camera[:, 7:8] * r2 + camera[:, 8:9] * r2 * r2) * p
# [/project]


pixels = project(cameras[camera_of], points[point_of]) + 0.5 * random.normal(size=(len(point_of), 2))
noise = [0.02] * 3 + [0.05] * 3 + [5, 0.01, 0.001]
cameras_guess = cameras + noise * random.normal(size=cameras.shape)
points_guess = points + 0.05 * random.normal(size=points.shape)

# [bundle]
from boxplus import Vector9


class Reprojection(BatchedEdge):
    def error(self, camera, point, pixel):
        return project(camera, point) - pixel


graph = Graph()
camera_ids = graph.add_vertices(Vector9, None, cameras_guess)
point_ids = graph.add_vertices(Vector3, None, points_guess)
graph.add_edges(Reprojection(), camera_ids[camera_of], point_ids[point_of], measurements=pixels)
for point in point_ids:
    graph.set_eliminated(point, True)  # faster: the Schur complement
report = optimize(graph)
cameras_found, points_found = graph.estimates(Vector9)[1], graph.estimates(Vector3)[1]
# [/bundle]

print(report)
degrees = 2 * len(pixels) - 9 * 12 - 3 * 300 + 7  # a similarity of the world changes no pixel
assert report.converged()
assert abs(report.chi2_final / 0.5**2 - degrees) < 5 * np.sqrt(2 * degrees), report.chi2_final
assert [cost.jacobians for cost in report.edge_functions] == ["exact"]
