# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment: the poses of a camera, points, and the intrinsic parameters, which are the same in all images.

import numpy as np

from boxplus import SE3, SO3, PinholeCamera, Vector3

# The truth: 12 poses (T_world_camera) around 300 points, which they look at. If the camera only turned around one axis, its
# parameters would not be determined.
random = np.random.default_rng(2)
true_points = random.uniform(-1, 1, (300, 3))
turns = [SO3.from_rotation_vector([0, angle, 0]) * SO3.from_rotation_vector([0.5 * np.sin(2 * angle), 0, angle])
         for angle in np.linspace(0, 2 * np.pi, 12, endpoint=False)]
true_poses = [SE3(turn * [0, 0, -6], turn) for turn in turns]
true_camera = PinholeCamera(500, 505, 320, 240)

pose_of, point_of = (index.ravel() for index in np.meshgrid(np.arange(12), np.arange(300), indexing="ij"))
pixels = np.concatenate([true_camera.project([pose.inverse_times(point) for point in true_points]) for pose in true_poses])
pixels += random.normal(size=pixels.shape)
poses = np.array([pose.oplus(0.01 * random.normal(size=6)).vector() for pose in true_poses])
points = true_points + 0.05 * random.normal(size=true_points.shape)

# [cameras]
from boxplus import Graph, Reprojection, optimize

graph = Graph()
pose_ids = graph.add_vertices(SE3, None, poses)  # T_world_camera
point_ids = graph.add_vertices(Vector3, None, points)
camera = graph.add_vertex(PinholeCamera(fx=480, fy=480, cx=320, cy=240))  # one camera for all images
graph.add_edges(Reprojection, pose_ids[pose_of], point_ids[point_of], camera, measurements=pixels)
for point in point_ids:
    graph.set_eliminated(point, True)
report = optimize(graph)
print(graph.estimate(camera))  # PinholeCamera(496.7…, 501.9…, 322.2…, 241.4…)
# [/cameras]

assert report.converged()
degrees = 2 * len(pixels) - 6 * 12 - 3 * 300 - 4 + 7  # the gauge: position, rotation and scale
assert abs(report.chi2_final - degrees) < 5 * np.sqrt(2 * degrees), report.chi2_final
assert np.abs(graph.estimate(camera).ominus(true_camera)).max() < 10, graph.estimate(camera)
