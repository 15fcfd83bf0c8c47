# SPDX-License-Identifier: BSD-3-Clause
"""covariance() and marginal_covariances()."""

import unittest

import boxplus
import numpy as np
from boxplus import Between, Graph, InvalidArgument, Prior


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


if __name__ == "__main__":
    unittest.main()
