# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment with a reprojection error that is written with NumPy, and an edge that is a plain function.

import numpy as np

# The truth: 12 cameras on a circle around 300 points. A camera has 6 numbers: a rotation vector and a translation.
random = np.random.default_rng(2)
points = random.uniform(-1, 1, (300, 3))
angles = np.linspace(0, 2 * np.pi, 12, endpoint=False)
cameras = np.stack([0 * angles, angles, 0 * angles, 0 * angles, 0 * angles, 0 * angles + 6], axis=1)

# [edge]
from boxplus import BatchedEdge, Graph, Vector3, Vector6, optimize


class Reprojection(BatchedEdge):
    """A point in the image of a camera with a focal length of 500 pixels."""

    def error(self, camera, point, pixel):  # arrays (n, 6), (n, 3), (n, 2)
        rotation = camera[:, :3]
        angle = np.sqrt((rotation * rotation).sum(axis=1, keepdims=True) + 1e-24)
        axis = rotation / angle
        rotated = (np.cos(angle) * point + np.sin(angle) * np.cross(axis, point)
                   + (1 - np.cos(angle)) * (axis * point).sum(axis=1, keepdims=True) * axis)
        x = rotated + camera[:, 3:]
        return 500 * x[:, :2] / x[:, 2:] - pixel  # (n, 2)
# [/edge]


edge = Reprojection()
camera_of, point_of = (index.ravel() for index in np.meshgrid(np.arange(12), np.arange(300), indexing="ij"))
pixels = edge.error(cameras[camera_of], points[point_of], 0) + random.normal(size=(3600, 2))

# [graph]
graph = Graph()
camera_ids = graph.add_vertices(Vector6, None, cameras + 0.02 * random.normal(size=cameras.shape))
point_ids = graph.add_vertices(Vector3, None, points + 0.05 * random.normal(size=points.shape))
graph.add_edges(edge, camera_ids[camera_of], point_ids[point_of], measurements=pixels)
graph.add_edge(lambda camera: np.linalg.norm(camera[3:]) - 6, camera_ids[0], information=1e6)  # a known distance
for point in point_ids:
    graph.set_eliminated(point, True)
report = optimize(graph)
print(report)  # its last lines: what the functions of Python cost
# [/graph]

assert report.converged()
degrees = 2 * len(pixels) - 6 * 12 - 3 * 300 + 7
assert abs(report.chi2_final - degrees) < 5 * np.sqrt(2 * degrees), report.chi2_final
assert [cost.jacobians for cost in report.edge_functions] == ["exact", "numeric"]
