# SPDX-License-Identifier: BSD-3-Clause
"""Rotations, directions and similarities as vertices, with their edges."""

import pickle
import unittest

import boxplus
import numpy as np
from boxplus import S2, SO2, SO3, BatchedEdge, Between, Graph, Prior, Sim3, optimize

TURN = SO3.from_rotation_vector([0.3, -0.2, 0.5])
EXAMPLES = (SO2(0.5), TURN, S2([1, 2, 3]), Sim3(TURN, [1, 2, 3], 2))
GROUPS = (SO2(0.5), TURN, Sim3(TURN, [1, 2, 3], 2))


def row_of(x):
    """The numbers of x, as in Graph.estimates()."""
    if isinstance(x, SO2):
        return np.array([x.angle()])
    return x.quaternion() if isinstance(x, SO3) else x.vector()


class Vertices(unittest.TestCase):
    def test_estimates_come_back_as_objects_and_as_rows(self):
        for x in EXAMPLES:
            with self.subTest(type(x)):
                graph = Graph()
                vertex = graph.add_vertex(x)
                self.assertEqual(graph.estimate(vertex), x)
                ids = graph.add_vertices(type(x), None, [row_of(x), row_of(type(x)())])
                self.assertEqual(graph.estimate(ids[0]), x)
                np.testing.assert_array_equal(graph.estimates(type(x))[1], [row_of(x), row_of(x), row_of(type(x)())])
                graph.set_estimates(type(x), [0], [row_of(type(x)())])
                graph.set_estimate(ids[1], x)
                self.assertEqual([graph.estimate(0), graph.estimate(ids[1])], [type(x)(), x])
                self.assertEqual(graph.tangent_dim(vertex), len(x.ominus(x)))

    def test_rows_that_are_no_values_are_refused(self):
        for kind, row, text in ((SO3, [0, 0, 0, 2], "a quaternion (qx qy qz qw) of length 1, got [0.0, 0.0, 0.0, 2.0]"),
                                (S2, [1, 1, 0], "a vector of length 1"),
                                (Sim3, [1, 2, 3, 0, 0, 0, 0, 1], "a quaternion (qx qy qz qw) of length 1"),
                                (Sim3, [1, 2, 3, 0, 0, 0, 1, 0], "a positive scale, got 0.0"),
                                (Sim3, [1, 2, 3], "estimates: expected an array of shape (n, 8) with the columns x y z qx qy qz qw scale")):
            graph = Graph()
            with self.subTest(text), self.assertRaises(ValueError) as raised:
                graph.add_vertices(kind, None, [row])
            self.assertIn(text, str(raised.exception))
            self.assertEqual(graph.vertex_count(), 0)

    def test_a_pickle_says_that_a_file_cannot_contain_them(self):
        graph = Graph()
        graph.add_vertex(EXAMPLES[3])
        with self.assertRaisesRegex(TypeError, "Graph: cannot be pickled: .*Sim3"):
            pickle.dumps(graph)


class Edges(unittest.TestCase):
    def test_a_prior_has_its_minimum_at_the_measurement(self):
        for x in EXAMPLES:
            with self.subTest(type(x)):
                graph = Graph()
                vertex = graph.add_vertex(type(x)())
                edge = graph.add_edge(Prior(x), vertex, information=4)
                self.assertEqual((graph.edge_type(edge), graph.measurement(edge)), (f"Prior<{type(x).__name__}>", x))
                np.testing.assert_allclose(graph.error(edge), type(x)().ominus(x), atol=1e-15)
                self.assertTrue(optimize(graph).converged())
                np.testing.assert_allclose(graph.estimate(vertex).ominus(x), 0, atol=1e-6)
                dim = graph.tangent_dim(vertex)
                graph.set_estimate(vertex, x)
                np.testing.assert_allclose(boxplus.covariance(graph, [vertex]).of(vertex), np.eye(dim) / 4, atol=1e-9)

    def test_between_measures_b_relative_to_a(self):
        for x in GROUPS:
            with self.subTest(type(x)):
                graph = Graph()
                a = graph.add_vertex(x)
                b = graph.add_vertex(x)
                edge = graph.add_edge(Between(x), a, b)
                graph.fix(a)
                self.assertEqual(graph.edge_type(edge), f"Between<{type(x).__name__}>")
                np.testing.assert_allclose(graph.error(edge), type(x)().ominus(x), atol=1e-14)
                self.assertTrue(optimize(graph).converged())
                np.testing.assert_allclose(graph.estimate(b).ominus(x * x), 0, atol=1e-6)

    def test_edges_of_arrays_equal_single_edges(self):
        for x in GROUPS:
            with self.subTest(type(x)):
                graph = Graph()
                ids = graph.add_vertices(type(x), None, [row_of(x)] * 3)
                edges = graph.add_edges(Between, ids[:-1], ids[1:], measurements=[row_of(x), row_of(x.inverse())])
                single = graph.add_edge(Between(x.inverse()), ids[1], ids[2])
                self.assertEqual(graph.measurement(edges[1]), graph.measurement(single))
                np.testing.assert_array_equal(graph.error(edges[1]), graph.error(single))

    def test_directions_have_no_between(self):
        graph = Graph()
        with self.assertRaisesRegex(TypeError, r"Between: expected vertices of the types .* got \(S2, S2\)"):
            graph.add_edge(Between(S2()), graph.add_vertex(S2()), graph.add_vertex(S2()))

    def test_a_loop_closure_takes_the_drift_of_the_scale_away(self):
        measured = Sim3(SO3.from_rotation_vector([0, 0, np.pi / 2]), [1, 0, 0], 1.05)
        graph = Graph()
        keyframes = [graph.add_vertex(Sim3())]
        graph.fix(keyframes[0])
        for _ in range(3):
            keyframes.append(graph.add_vertex(graph.estimate(keyframes[-1]) * measured))
            graph.add_edge(Between(measured), *keyframes[-2:], information=100)
        self.assertAlmostEqual(graph.estimate(keyframes[-1]).scale(), 1.05**3)
        graph.add_edge(Between(Sim3(measured.quaternion(), [1, 0, 0], 1)), keyframes[-1], keyframes[0], information=1e6)
        report = optimize(graph)
        self.assertTrue(report.converged())
        self.assertAlmostEqual(graph.estimate(keyframes[-1]).scale(), 1, delta=1e-3)
        self.assertIn("Between<Sim3>", str(report))


class Functions(unittest.TestCase):
    def test_numeric_derivatives_fit_each_type_far_away_from_the_origin(self):
        for x in (*GROUPS, Sim3(TURN, [3000, -2000, 1000], 0.01), Sim3(TURN, [3000, -2000, 1000], 100)):
            with self.subTest(x):
                graph, z = Graph(), type(x).from_vector(row_of(x)) if not isinstance(x, SO2) else x
                a, b = graph.add_vertex(x), graph.add_vertex(x.oplus(np.full(len(x.ominus(x)), 0.1)))
                exact = graph.add_edge(Between(z), a, b)
                numeric = graph.add_edge(lambda a, b: (a.inverse() * b).ominus(z), a, b)  # noqa: B023
                np.testing.assert_allclose(graph.error(numeric), graph.error(exact), rtol=1e-9, atol=1e-12)
                for found, expected in zip(graph.jacobian(numeric), graph.jacobian(exact)):
                    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * np.abs(expected).max())

    def test_a_batched_function_gets_rows_and_has_exact_derivatives(self):
        class Scale(BatchedEdge):
            def error(self, x, z):
                return np.log(x[:, 7]) - z[:, 0]

        graph = Graph()
        vertex = graph.add_vertex(EXAMPLES[3])
        edge, = graph.add_edges(Scale(), [vertex.slot], measurements=[[0.1]])
        np.testing.assert_allclose(graph.error(edge), np.log(2) - 0.1)
        np.testing.assert_allclose(graph.jacobian(edge)[0], [[0, 0, 0, 0, 0, 0, 1]], atol=1e-15)
        graph.add_edge(Prior(EXAMPLES[3]), vertex, information=1e-3)
        report = optimize(graph)
        self.assertEqual(report.edge_functions[0].jacobians, "exact")
        self.assertAlmostEqual(graph.estimate(vertex).scale(), np.exp(0.1), delta=1e-3)


if __name__ == "__main__":
    unittest.main()
