# SPDX-License-Identifier: BSD-3-Clause
"""Constraint: edges whose error must be zero exactly."""

import copy
import gc
import unittest
import weakref

import boxplus
import numpy as np
from boxplus import SE2, SE3, SO3, BatchedEdge, Between, Constraint, Graph, InvalidArgument, PointObservation2, Prior, optimize


class SumIsOne(BatchedEdge):
    def error(self, x):
        return x.sum(axis=1) - 1


class Distance(BatchedEdge):
    def error(self, a, b, z):
        return np.linalg.norm(a[:, :2] - b[:, :2], axis=1) - z[:, 0]


def shares():
    graph = Graph()
    graph.add_vertex([0.5, 0.3, 0.1])
    graph.add_edge(Prior([0.6, 0.5, 0.2]), 0)
    return graph


class Functions(unittest.TestCase):
    def assert_sum_is_one(self, graph, report):
        self.assertTrue(report.converged(), report)
        self.assertLessEqual(report.constraint_violation, 1e-9)
        np.testing.assert_allclose(graph.estimate(0), np.array([0.6, 0.5, 0.2]) - 0.1, atol=1e-8)
        result, = report.constraints  # F = 3 · 0.01, and ∂F/∂x = −0.2 in each entry
        np.testing.assert_allclose(result.multipliers, [0.2], atol=1e-6)

    def test_an_error_function_vanishes_exactly(self):
        graph = shares()
        edge = graph.add_edge(Constraint(lambda x: x.sum() - 1), 0, information=4)
        self.assertEqual(graph.edge_type(edge), "Constraint")
        np.testing.assert_allclose(graph.error(edge), [-0.1])
        report = optimize(graph)
        self.assert_sum_is_one(graph, report)
        self.assertEqual(report.constraints[0].edge, edge)
        self.assertEqual(graph.information(edge).tolist(), [[4]])
        self.assertLess(abs(graph.error(edge)[0]), 1e-9)
        self.assertIn("constraints", str(report))

    def test_a_batched_function_vanishes_exactly(self):
        graph = shares()
        edges = graph.add_edges(Constraint(SumIsOne()), [0])
        report = optimize(graph)
        self.assert_sum_is_one(graph, report)
        self.assertEqual([edge for edge in edges], [report.constraints[0].edge])
        self.assertEqual(report.edge_functions[0].jacobians, "exact")

    def test_a_function_may_be_a_constraint_and_a_measurement(self):
        graph, function = shares(), SumIsOne()
        graph.add_edges(function, [0], informations=5)
        graph.add_edges(Constraint(function), [0])
        report = optimize(graph)
        self.assertEqual(len(report.constraints), 1)
        self.assertAlmostEqual(graph.estimate(0).sum(), 1, delta=1e-9)

    def test_many_constraints_hold_at_once(self):
        random = np.random.default_rng(1)
        graph = Graph()
        ids = graph.add_vertices(SE2, None, np.c_[np.arange(30), random.normal(size=(30, 2)) / 10])
        graph.add_edges(Prior, ids, measurements=graph.estimates(SE2)[1])
        edges = graph.add_edges(Constraint(Distance()), ids[:-1], ids[1:], measurements=np.full(29, 1.01))
        report = optimize(graph)
        self.assertTrue(report.converged(), report)
        self.assertLessEqual(max(abs(graph.error(edge)[0]) for edge in edges), 1e-9)
        positions = graph.estimates(SE2)[1][:, :2]
        np.testing.assert_allclose(np.linalg.norm(np.diff(positions, axis=0), axis=1), 1.01, atol=1e-9)

    def test_removed_edges_copies_and_wrong_arguments(self):
        graph = shares()
        edge, = graph.add_edges(Constraint(SumIsOne()), [0])
        other = copy.copy(graph)
        graph.remove(edge)
        self.assertEqual(optimize(graph).constraint_rounds, 0)
        self.assert_sum_is_one(other, optimize(other))
        with self.assertRaisesRegex(TypeError, "edge: expected one of Between"):
            graph.add_edge(Constraint(3), 0)
        with self.assertRaisesRegex(TypeError, "edge: expected one of Between"):
            graph.add_edge(Constraint(Constraint(Prior([1, 2, 3]))), 0)
        other.set_kernel(edge, "Huber", 1)
        with self.assertRaisesRegex(InvalidArgument, "without robust kernels"):
            optimize(other)

    def test_constraints_that_contradict_each_other_are_reported(self):
        graph = shares()
        graph.add_edge(Constraint(lambda x: x[0] - 1), 0)
        graph.add_edge(Constraint(lambda x: x[0] - 2), 0)
        report = optimize(graph)
        self.assertEqual(report.reason, boxplus.Report.Reason.kConstraints)


class ReadyMadeEdges(unittest.TestCase):
    def test_a_relative_pose_holds_exactly(self):
        for step, guess in ((SE2(1, 2, 0.5), SE2(1.2, 1.7, 0.3)), (SE3([1, 2, 3], SO3.from_rotation_vector([0.1, 0.2, 0.3])), SE3())):
            graph = Graph()
            a, b = graph.add_vertex(type(step)()), graph.add_vertex(guess)
            graph.add_edge(Prior(type(step)()), a)
            graph.add_edge(Prior(guess), b)
            edge = graph.add_edge(Constraint(Between(step)), a, b)
            self.assertEqual((graph.edge_type(edge), graph.measurement(edge)), ("Constraint", step))
            plain = graph.add_edge(Between(step), a, b)
            graph.set_enabled(plain, False)
            np.testing.assert_array_equal(graph.error(edge), graph.error(plain))
            for found, expected in zip(graph.jacobian(edge), graph.jacobian(plain)):
                np.testing.assert_allclose(found, expected, atol=1e-12)
            report = optimize(graph)
            self.assertTrue(report.converged(), report)
            np.testing.assert_allclose(graph.estimate(a).inverse_times(graph.estimate(b)).ominus(step), 0, atol=2e-9)
            self.assertEqual(len(report.constraints[0].multipliers), graph.tangent_dim(a))
            graph.set_measurement(edge, type(step)())
            self.assertEqual(graph.measurement(edge), type(step)())
            self.assertTrue(optimize(graph).converged())
            np.testing.assert_allclose(graph.estimate(a).ominus(graph.estimate(b)), 0, atol=2e-9)

    def test_they_may_be_added_as_arrays_removed_and_copied(self):
        graph = Graph()
        steps = np.tile([1.0, 0, 0.1], (9, 1))
        ids = graph.add_vertices(SE2, None, np.random.default_rng(1).normal(size=(10, 3)) / 3 + np.c_[np.arange(10), np.zeros((10, 2))])
        graph.add_edges(Prior, ids, measurements=graph.estimates(SE2)[1])
        edges = graph.add_edges(Constraint(Between), ids[:-1], ids[1:], measurements=steps)
        graph.remove(edges[4])
        added = graph.add_edge(Constraint(Between(SE2(2, 0, 0))), ids[4], ids[5])
        graph.set_level(graph.add_edge(Constraint(Prior([0, 0])), graph.add_vertex([1, 1])), 3)
        for other in (graph, copy.copy(graph)):
            report = optimize(other)
            self.assertTrue(report.converged(), report)
            self.assertEqual(len(report.constraints), 9)
            self.assertEqual(other.measurement(added), SE2(2, 0, 0))
            for k, (a, b) in enumerate(zip(ids[:-1], ids[1:])):
                step = SE2(2, 0, 0) if k == 4 else SE2.from_vector(steps[k])
                np.testing.assert_allclose(other.estimate(a).inverse_times(other.estimate(b)).ominus(step), 0, atol=1e-8)

    def test_a_landmark_is_where_it_must_be_seen(self):
        graph = Graph()
        pose, point = graph.add_vertex(SE2(0, 0, 0.3)), graph.add_vertex([2, 1])
        graph.add_edge(Prior(SE2(0, 0, 0.3)), pose)
        graph.add_edge(Prior([2, 1]), point)
        graph.add_edge(Constraint(PointObservation2([2, 0])), pose, point)
        self.assertTrue(optimize(graph).converged())
        np.testing.assert_allclose(graph.estimate(pose).inverse_times(graph.estimate(point)), [2, 0], atol=1e-9)

    def test_a_constraint_keeps_its_edge(self):
        edge = Between(SE2(1, 0, 0))
        constraint = Constraint(edge)
        self.assertIs(constraint.edge, edge)
        self.assertEqual(repr(constraint), f"Constraint({edge!r})")

    def test_a_graph_releases_the_functions_of_its_constraints(self):
        graph, function = shares(), SumIsOne()
        graph.add_edges(Constraint(function), [0])
        alive = weakref.ref(function)
        del function, graph
        gc.collect()
        self.assertIsNone(alive())


if __name__ == "__main__":
    unittest.main()
