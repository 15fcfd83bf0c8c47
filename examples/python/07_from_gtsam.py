# SPDX-License-Identifier: BSD-3-Clause
# A pose graph with a loop closure and a custom factor, as in programs for GTSAM's Python module.

# [graph]
import numpy as np
from boxplus import SE2, Between, Graph, Prior, covariance, optimize


def sigmas(*values):
    return np.diag(1 / np.square(values))  # Ω is the inverse of the covariance


graph = Graph()
for i in range(1, 6):
    graph.add_vertex(SE2(1.8 * i, 0.3, 0), id=i)
graph.add_edge(Prior(SE2(0, 0, 0)), 1, information=sigmas(0.3, 0.3, 0.1))
odometry = sigmas(0.2, 0.2, 0.1)
graph.add_edge(Between(SE2(2, 0, 0)), 1, 2, information=odometry)
for i in (2, 3, 4):
    graph.add_edge(Between(SE2(2, 0, np.pi / 2)), i, i + 1, information=odometry)
closure = graph.add_edge(Between(SE2(2, 0, np.pi / 2)), 5, 2, information=odometry)
graph.set_kernel(closure, "Huber", 1.345)

report = optimize(graph, start="automatic")  # because the initial estimates are poor
print(graph.estimate(5), covariance(graph, [2]).of(2))
# [/graph]

assert report.converged() and report.chi2_final < 1e-12
np.testing.assert_allclose(graph.estimate(5).vector(), [2, 2, -np.pi / 2], atol=1e-6)
plain = covariance(graph, [2]).of(2)

# [factor]
beacon = np.array([4.0, 5.0])
graph.add_edge(lambda pose: np.linalg.norm(pose.translation() - beacon) - 5.4, 2, information=1 / 0.1**2)
graph.add_edge(lambda pose: np.linalg.norm(pose.translation() - beacon) - 3.6, 5, information=1 / 0.1**2)
report = optimize(graph)
# [/factor]

distance = np.linalg.norm(graph.estimate(2).translation() - beacon)
print(report, distance)
assert report.converged() and np.linalg.det(covariance(graph, [2]).of(2)) < np.linalg.det(plain)

# [factors]
from boxplus import BatchedEdge


class BeaconRange(BatchedEdge):
    def error(self, pose, data):  # pose (n, 3): x, y, theta; data (n, 3): x and y of the beacon, measured distance
        return np.hypot(pose[:, 0] - data[:, 0], pose[:, 1] - data[:, 1]) - data[:, 2]


same = graph.add_edges(BeaconRange(), [2, 5], measurements=[[4, 5, 5.4], [4, 5, 3.6]], informations=1 / 0.1**2)
# [/factors]

one, two = graph.all_edges()[-4:-2]
np.testing.assert_allclose([graph.error(edge) for edge in same], [graph.error(one), graph.error(two)])
np.testing.assert_allclose(graph.jacobian(same[0])[0], graph.jacobian(one)[0], atol=1e-8)

# [noise]
def omega_of_se3(covariance_of_pose3):
    """Converts a covariance of a Pose3, whose tangent is (rotation, translation), to Ω of an SE3."""
    D = np.zeros((6, 6))  # the tangent of Pose3 = D times the tangent of SE3: (translation, half rotation)
    D[:3, 3:] = 2 * np.eye(3)
    D[3:, :3] = np.eye(3)
    return D.T @ np.linalg.inv(covariance_of_pose3) @ D
# [/noise]


from boxplus import SE3, SO3, se3_sigmas

np.testing.assert_allclose(omega_of_se3(np.diag([0.01] * 3 + [0.1] * 3)**2), se3_sigmas(0.1, 0.01))
# A step of 1 mrad about z and 1 mm along x: the weighted squares of its tangents are equal.
covariance_of_pose3 = np.cov(np.random.default_rng(7).normal(size=(6, 100)))
step = np.array([0, 0, 1e-3, 1e-3, 0, 0])
own = SE3([1e-3, 0, 0], SO3.from_rotation_vector([0, 0, 1e-3])).ominus(SE3())
np.testing.assert_allclose(own @ omega_of_se3(covariance_of_pose3) @ own,
                           step @ np.linalg.inv(covariance_of_pose3) @ step, rtol=1e-6)
