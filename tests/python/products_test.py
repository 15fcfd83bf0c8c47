# SPDX-License-Identifier: BSD-3-Clause
"""Vertices with several values: tuples."""

import unittest

import numpy as np
from boxplus import SE2, SE3, SO3, BatchedEdge, Graph, Options, Vector2, Vector3, Vector6, optimize

TURN = SO3.from_rotation_vector([0.02, -0.03, 0.1])
POSE = SE3([0.3, -0.2, 0.1], TURN)
TYPES = {
    (SE2, Vector2): (SE2(1, 2, 0.5), Vector2(3, 4)),
    (SE2, Vector3): (SE2(1, 2, 0.5), Vector3(3, 4, 5)),
    (SE2, SE2): (SE2(1, 2, 0.5), SE2(3, 4, -0.5)),
    (SO3, Vector3): (TURN, Vector3(1, 2, 3)),
    (SE3, Vector3): (POSE, Vector3(1, 2, 3)),
    (SE3, Vector6): (POSE, Vector6(1, 2, 3, 4, 5, 6)),
    (SE3, Vector3, Vector6): (POSE, Vector3(1, 2, 3), Vector6(1, 2, 3, 4, 5, 6)),
    (SE3, SE3): (POSE, POSE.inverse()),
}


def numbers(estimate):
    return np.concatenate([x.quaternion() if isinstance(x, SO3) else x if isinstance(x, np.ndarray) else x.vector() for x in estimate])


class ConstantVelocity(BatchedEdge):
    """The position moves by the velocity, and the velocity stays."""

    def error(self, a, b, dt):
        return np.hstack([b[:, :3] - a[:, :3] - dt * a[:, 7:], b[:, 7:] - a[:, 7:]])


class Products(unittest.TestCase):
    def test_estimates_are_tuples_and_rows(self):
        for kind, estimate in TYPES.items():
            graph = Graph()
            vertex = graph.add_vertex(estimate)
            row = numbers(estimate)
            ids = graph.add_vertices(kind, None, [row])
            for added in (vertex, ids[0]):
                found = graph.estimate(added)
                self.assertIsInstance(found, tuple)
                np.testing.assert_array_equal(numbers(found), row)
            np.testing.assert_array_equal(graph.estimates(kind)[1], [row, row])
            graph.set_estimates(kind, ids, [row])
            graph.set_estimate(vertex, estimate)
            np.testing.assert_array_equal(graph.estimates(kind)[1], [row, row])

    def test_the_dimension_is_the_sum_of_those_of_the_parts(self):
        graph = Graph()
        dims = [graph.tangent_dim(graph.add_vertex(estimate)) for estimate in TYPES.values()]
        self.assertEqual(dims, [5, 6, 6, 6, 9, 12, 15, 12])

    def test_a_function_gets_the_tuple(self):
        for estimate in TYPES.values():
            graph = Graph()
            vertex = graph.add_vertex(estimate)
            target = numbers(estimate) + 0.01 * np.arange(len(numbers(estimate)))
            edge = graph.add_edge(lambda x, target=target: numbers(x) - target, vertex)
            np.testing.assert_allclose(graph.error(edge), numbers(estimate) - target, rtol=0, atol=1e-15)
            before = graph.chi2()
            self.assertTrue(optimize(graph).converged())
            self.assertLess(graph.chi2(), before)

    def test_velocities_are_estimated_from_positions(self):
        count, dt, velocity = 20, 0.5, np.array([2, -1, 0.5])
        graph = Graph()
        rows = np.zeros((count, 10))
        rows[:, 6] = 1  # qw
        ids = graph.add_vertices((SE3, Vector3), None, rows)
        graph.add_edges(ConstantVelocity(), ids[:-1], ids[1:], measurements=np.full((count - 1, 1), dt))
        for k in (0, count // 2, count - 1):
            graph.add_edge(lambda x, place=k * dt * velocity: x[0].translation() - place, ids[k])
        for vertex in ids:
            graph.add_edge(lambda x: x[0].vector()[3:6], vertex)
        report = optimize(graph, Options(max_iterations=20))
        self.assertTrue(report.converged())
        found = graph.estimates((SE3, Vector3))[1]
        np.testing.assert_allclose(found[:, 7:], np.tile(velocity, (count, 1)), rtol=0, atol=1e-8)
        np.testing.assert_allclose(found[:, :3], np.outer(dt * np.arange(count), velocity), rtol=0, atol=1e-7)

    def test_other_tuples_are_refused_with_a_reason(self):
        graph = Graph()
        for wrong in ((POSE, [1, 2, 3, 4]), ([1, 2, 3], POSE), (POSE,), (POSE, SE2())):
            with self.assertRaisesRegex(TypeError, r"estimate: expected one of .*\(SE3, Vector3\)"):
                graph.add_vertex(wrong)
        with self.assertRaisesRegex(TypeError, r"type: expected one of the classes .*\(SE3, Vector3\).*, got"):
            graph.estimates((SE3, SE2))
        vertex = graph.add_vertex((POSE, Vector3(1, 2, 3)))
        with self.assertRaisesRegex(TypeError, r"estimate: expected a tuple \(SE3, Vector3\), got"):
            graph.set_estimate(vertex, POSE)
        with self.assertRaisesRegex(ValueError, r"estimates\[0\]: expected a quaternion"):
            graph.add_vertices((SE3, Vector3), None, np.zeros((1, 10)))


if __name__ == "__main__":
    unittest.main()
