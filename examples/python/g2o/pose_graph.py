# SPDX-License-Identifier: BSD-3-Clause
# A pose graph in space. The class wraps SparseOptimizer, as many programs for g2o's Python bindings do.

import g2o
import numpy as np


class PoseGraph(g2o.SparseOptimizer):
    def __init__(self):
        super().__init__()
        solver = g2o.BlockSolverSE3(g2o.LinearSolverCholmodSE3())
        super().set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))

    def optimize(self, max_iterations=20):
        super().initialize_optimization()
        return super().optimize(max_iterations)

    def add_vertex(self, id, pose, fixed=False):
        vertex = g2o.VertexSE3()
        vertex.set_id(id)
        vertex.set_estimate(pose)
        vertex.set_fixed(fixed)
        super().add_vertex(vertex)

    def add_edge(self, vertices, measurement, information=np.identity(6), robust_kernel=None):
        edge = g2o.EdgeSE3()
        for i, vertex in enumerate(vertices):
            edge.set_vertex(i, self.vertex(vertex) if isinstance(vertex, int) else vertex)
        edge.set_measurement(measurement)
        edge.set_information(information)
        if robust_kernel is not None:
            edge.set_robust_kernel(robust_kernel)
        super().add_edge(edge)

    def get_pose(self, id):
        return self.vertex(id).estimate()


# Two rounds of a helix, with noisy odometry, closures between the rounds, and a false closure.
random = np.random.default_rng(1)


def noise(translation, rotation):
    turn = g2o.Quaternion(g2o.AngleAxis(rotation * random.normal(), random.normal(size=3) / np.sqrt(3))).normalized()
    return g2o.Isometry3d(turn, translation * random.normal(size=3))


count = 80
truth = [g2o.Isometry3d(g2o.Quaternion(g2o.AngleAxis(t, np.array([0, 0, 1]))), np.array([5 * np.sin(t), -5 * np.cos(t), 0.1 * t]))
         for t in np.linspace(0, 4 * np.pi, count, endpoint=False)]

graph = PoseGraph()
information = np.diag([1 / 0.02**2] * 3 + [4 / 0.01**2] * 3)  # of a translation and half a rotation
pose = truth[0]
graph.add_vertex(0, pose, fixed=True)
for i in range(1, count):
    odometry = truth[i - 1].inverse() * truth[i] * noise(0.02, 0.01)
    pose = pose * odometry
    graph.add_vertex(i, pose)
    graph.add_edge([i - 1, i], odometry, information)
for i in range(0, count // 2, 4):
    closure = truth[i].inverse() * truth[i + count // 2] * noise(0.02, 0.01)
    graph.add_edge([i, i + count // 2], closure, information, g2o.RobustKernelCauchy(1.0))
graph.add_edge([3, 60], g2o.Isometry3d(np.identity(3), [1, 2, 3]), information, g2o.RobustKernelCauchy(1.0))


def largest_error():
    return max(np.linalg.norm(graph.get_pose(i).translation() - truth[i].translation()) for i in range(count))


before = largest_error()
graph.optimize(50)
print(f"largest error of a position: {before:.3f} m, after the optimization {largest_error():.3f} m")
assert largest_error() < before / 2
assert [edge for edge in graph.edges() if edge.chi2() > 1000] == [list(graph.edges())[-1]]  # the false closure
