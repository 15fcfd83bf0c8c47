# SPDX-License-Identifier: BSD-3-Clause
"""boxplus.rows: the products, inverses and logarithms of many poses are those of the classes."""

import unittest

import numpy as np

from boxplus import SE2, SE3, BatchedEdge, Between, Graph, optimize, rows
from boxplus._dual import Dual


def poses(size, count=20, seed=1):
    random = np.random.default_rng(seed)
    a = random.normal(size=(count, size))
    if size == 7:
        a[:, 3:] /= np.linalg.norm(a[:, 3:], axis=1, keepdims=True)
        a[0, 3:] = [0, 0, 0, 1]
        a[1, 3:] = [1e-5, 2e-5, 0, np.sqrt(1 - 5e-10)]
    else:
        a[:, 2] *= 0.9
        a[0, 2], a[1, 2] = 0, 1e-4
    return a


def number(x):
    return x.vector() if hasattr(x, "vector") else x


class Rows(unittest.TestCase):
    def assert_same(self, found, expected):
        found, expected = np.array(found), np.array([number(x) for x in expected])
        if expected.shape[1] == 7:  # both signs of a quaternion are the same rotation
            signs = np.sign((found[:, 3:] * expected[:, 3:]).sum(axis=1, keepdims=True))
            expected = np.concatenate([expected[:, :3], signs * expected[:, 3:]], axis=1)
        np.testing.assert_allclose(found, expected, atol=1e-9)

    def test_they_are_the_functions_of_the_classes(self):
        for cls, size, dim in ((SE2, 3, 2), (SE3, 7, 3)):
            a, b, p = poses(size), poses(size, seed=2), np.random.default_rng(3).normal(size=(20, dim))
            A, B = ([cls.from_vector(row) for row in x] for x in (a, b))
            self.assert_same(rows.times(a, b), [x * y for x, y in zip(A, B)])
            self.assert_same(rows.times(a, p), [x * y for x, y in zip(A, p)])
            self.assert_same(rows.inverse(a), [x.inverse() for x in A])
            self.assert_same(rows.inverse_times(a, b), [x.inverse_times(y) for x, y in zip(A, B)])
            self.assert_same(rows.inverse_times(a, p), [x.inverse_times(y) for x, y in zip(A, p)])
            self.assert_same(rows.ominus(a, b), [x.ominus(y) for x, y in zip(A, B)])
            self.assert_same(rows.log(a), [x.log() for x in A])
            np.testing.assert_allclose(rows.rotation(a), [x.rotation() for x in A], atol=1e-12)

    def test_their_derivatives_are_exact(self):
        for size, dim in ((3, 2), (7, 3)):
            a, b = poses(size)[2:], poses(size, seed=2)[2:]
            seeds = np.random.default_rng(4).normal(size=(1, *a.shape))
            for function in (lambda x: rows.times(x, b), lambda x: rows.times(b, x), lambda x: rows.inverse(x),
                             lambda x: rows.inverse_times(x, b[:, :dim]), lambda x: rows.ominus(x, b), lambda x: rows.ominus(b, x),
                             lambda x: rows.log(x), lambda x: rows.rotation(x)):
                exact = function(Dual(a, seeds)).derivative[0]
                numeric = (function(a + 1e-6 * seeds[0]) - function(a - 1e-6 * seeds[0])) / 2e-6
                np.testing.assert_allclose(exact, numeric, atol=1e-6)

    def test_an_edge_of_rows_is_the_native_edge(self):
        class Own(BatchedEdge):
            def error(self, a, b, z):
                return rows.ominus(rows.inverse_times(a, b), z)

        for cls, size in ((SE2, 3), (SE3, 7)):
            ends = []
            for edge in (Between, Own()):
                graph = Graph()
                graph.add_vertices(cls, None, poses(size, 4))
                graph.fix(0)
                graph.add_edges(edge, [0, 1, 2, 0], [1, 2, 3, 3], measurements=poses(size, 4, seed=5))
                report = optimize(graph, algorithm="levenberg-marquardt")
                ends.append((report.chi2_final, [graph.error(e) for e in graph.all_edges()]))
                if edge is not Between:
                    self.assertEqual(report.edge_functions[0].jacobians, "exact")
            self.assertAlmostEqual(ends[0][0], ends[1][0], delta=1e-6 * ends[0][0])

    def test_wrong_shapes_are_refused(self):
        for a, b, text in ((np.zeros((2, 4)), None, r"\(n, 3\) or \(n, 7\), got \(2, 4\)"),
                           (np.zeros(7), None, r"got \(7,\)"),
                           (np.zeros((2, 3)), np.zeros((2, 7)), r"\(n, 2\) or \(n, 3\), got \(2, 7\)"),
                           (np.zeros((2, 7)), np.zeros((2, 2)), r"\(n, 3\) or \(n, 7\), got \(2, 2\)")):
            with self.assertRaisesRegex(ValueError, text):
                rows.inverse(a) if b is None else rows.times(a, b)


if __name__ == "__main__":
    unittest.main()
