# SPDX-License-Identifier: BSD-3-Clause
"""covariance() and marginal_covariances()."""

import threading
import unittest

import boxplus
import numpy as np
from boxplus import SE2, Between, Graph, InvalidArgument, Optimizer, Prior, StopFlag


def walk():
    """Three points on a line, with a prior on the first one; the variances add up."""
    graph = Graph()
    for x in range(3):
        graph.add_vertex([x, 0])
    graph.add_edge(Prior([0, 0]), 0, information=1)
    graph.add_edge(Between([1, 0]), 0, 1, information=0.5)
    graph.add_edge(Between([1, 0]), 1, 2, information=0.25)
    return graph


class Covariances(unittest.TestCase):
    def test_the_variances_of_a_walk_add_up(self):
        graph = walk()
        covariance = boxplus.covariance(graph, [graph.vertex(2), 0])
        self.assertTrue(covariance.ok())
        np.testing.assert_allclose(covariance.of(2), 7 * np.eye(2), atol=1e-12)
        np.testing.assert_allclose(covariance.of(0, 2), np.eye(2), atol=1e-12)
        np.testing.assert_allclose(covariance.joint(), np.kron([[7, 1], [1, 1]], np.eye(2)), atol=1e-12)
        marginals = boxplus.marginal_covariances(graph, graph.all_vertices(), threads=1)
        np.testing.assert_allclose([marginals.of(i)[0, 0] for i in range(3)], [1, 3, 7], atol=1e-12)

    def test_a_vertex_that_nothing_determines_has_no_covariance(self):
        graph = walk()
        graph.add_edge(Between([1, 1]), graph.add_vertex([5, 5]), graph.add_vertex([6, 6]))
        covariance = boxplus.covariance(graph, [3], gauge="error")
        self.assertEqual(covariance.status(), boxplus.Covariance.Status.kSingular)
        self.assertIn("vertex 3 (Vector2) is not determined", covariance.message())
        self.assertEqual(covariance.failed_vertex(), graph.vertex(3))
        with self.assertRaisesRegex(boxplus.Error, "not determined"):
            covariance.of(3)
        self.assertEqual(boxplus.covariance(graph, [3]).held(), [graph.vertex(3)])

    def test_wrong_vertices_are_refused(self):
        graph = walk()
        with self.assertRaisesRegex(InvalidArgument, r"vertices\[1\]: there is no vertex with the id 9"):
            boxplus.covariance(graph, [0, 9])
        with self.assertRaisesRegex(TypeError, "vertices: expected a list of VertexRefs or ids, got 0"):
            boxplus.covariance(graph, 0)
        with self.assertRaises(InvalidArgument):
            boxplus.covariance(graph, [0]).of(1)


def ring(count=40):
    """Poses around a circle with noisy measurements, the first one with a prior."""
    random = np.random.default_rng(1)
    graph, turn = Graph(), 2 * np.pi / count
    k = np.arange(count)
    radius = 0.5 / np.sin(turn / 2)
    graph.add_vertices(SE2, None, np.c_[radius * np.sin(k * turn), radius * (1 - np.cos(k * turn)), k * turn])
    steps = [np.cos(turn / 2), np.sin(turn / 2), turn] + 0.02 * random.normal(size=(count, 3))
    graph.add_edges(Between, k, (k + 1) % count, measurements=steps, informations=np.diag([400, 300, 900]))
    graph.add_edge(Prior(SE2()), 0, information=100)
    return graph


class CovariancesOfAnOptimizer(unittest.TestCase):
    def assert_same(self, optimizer, graph, **options):
        """The optimizer's covariances are those of the functions. Returns one of them."""
        some, every = [3, graph.vertex(17), 30], graph.all_vertices()
        of_optimizer, expected = optimizer.covariance(some), boxplus.covariance(graph, some, **options)
        self.assertTrue(of_optimizer.ok() and expected.ok())
        scale = np.abs(expected.joint()).max()
        np.testing.assert_allclose(of_optimizer.joint(), expected.joint(), rtol=0, atol=1e-9 * scale)
        marginals, expected = optimizer.marginal_covariances(every), boxplus.marginal_covariances(graph, every, **options)
        for vertex in every:
            np.testing.assert_allclose(marginals.of(vertex), expected.of(vertex), rtol=0, atol=1e-9 * scale)
        return of_optimizer.joint()

    def test_they_equal_those_of_the_functions_before_and_after_a_run(self):
        graph = ring()
        optimizer = Optimizer(graph)
        before = self.assert_same(optimizer, graph)
        self.assertTrue(optimizer.run().converged())
        after = self.assert_same(optimizer, graph)
        self.assertGreater(np.abs(before - after).max(), 1e-6)

    def test_they_follow_every_change(self):
        graph = ring()
        optimizer = Optimizer(graph)
        optimizer.run()
        joint = self.assert_same(optimizer, graph)
        ids, poses = graph.estimates(SE2)
        for change in (lambda: graph.set_estimates(SE2, ids, poses + [0.3, -0.2, 0.1] * np.sin(ids)[:, None]),
                       lambda: graph.set_information(graph.all_edges()[5], 7),
                       lambda: graph.add_edge(Prior(SE2(1, 2, 3)), 17),
                       lambda: graph.add_edge(lambda pose: pose.y() ** 2 - 1, 30, information=20),
                       lambda: graph.fix(3)):
            change()
            changed = self.assert_same(optimizer, graph)
            self.assertGreater(np.abs(changed - joint).max(), 1e-9)
            joint = changed

    def test_they_have_the_options_of_the_optimizer(self):
        graph = ring()
        graph.set_level(graph.add_edge(Prior(SE2(1, 2, 3)), 17), 1)
        optimizer = Optimizer(graph, level=0)
        without = self.assert_same(optimizer, graph)
        optimizer.set_options(level=-1)
        self.assertGreater(np.abs(self.assert_same(optimizer, graph, level=-1) - without).max(), 1e-6)
        flag = StopFlag()
        flag.set()
        optimizer.set_options(stop=flag, level=-1)
        graph.set_estimate(3, SE2())
        self.assertEqual(optimizer.covariance([3]).status(), boxplus.Covariance.Status.kStopped)
        optimizer.set_options(level=-1)
        self.assert_same(optimizer, graph, level=-1)

    def test_wrong_vertices_are_refused(self):
        optimizer = Optimizer(walk())
        with self.assertRaisesRegex(InvalidArgument, r"vertices\[1\]: there is no vertex with the id 9"):
            optimizer.covariance([0, 9])
        with self.assertRaisesRegex(TypeError, "vertices: expected a list of VertexRefs or ids, got 0"):
            optimizer.marginal_covariances(0)
        np.testing.assert_allclose(optimizer.covariance([0, 2]).of(2), 7 * np.eye(2), atol=1e-12)

    def test_another_thread_may_ask_and_the_graph_is_busy_meanwhile(self):
        graph = ring()
        optimizer, found, refused = Optimizer(graph), [], []

        def error(pose):  # a function of the graph that tries to change it
            if threading.current_thread() is thread:
                try:
                    graph.fix(5)
                except InvalidArgument as busy:
                    refused.append(str(busy))
            return pose.x()

        thread = threading.Thread(target=lambda: found.append(optimizer.covariance(vertices=[3])))
        graph.add_edge(error, 30)
        thread.start()
        thread.join()
        self.assertTrue(found[0].ok())
        self.assertIn("this graph is being optimized", refused[0])
        self.assertFalse(graph.is_fixed(5))
        self.assertIsNone(optimizer.options.stop)


if __name__ == "__main__":
    unittest.main()
