# SPDX-License-Identifier: BSD-3-Clause
"""Vertices and edges as arrays."""

import pathlib
import tempfile
import unittest

import boxplus
import numpy as np
from boxplus import SE2, SE3, Between, PointObservation2, Prior, Range, Vector2
from g2o_arrays import graph_from_arrays, parse_g2o

FILE_2D = """VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 1.1 0.1 0.3
VERTEX_SE2 2 1.9 -0.2 -3.1
FIX 0
EDGE_SE2 0 1 1 0 0.1 100 1 0.5 90 0 400
EDGE_SE2 1 2 0.9 0.3 -2.5 100 0 0 100 0 100
EDGE_SE2 0 2 2 0 3.1 10 0 0 20 0 30
"""
FILE_3D = """VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1
VERTEX_SE3:QUAT 1 1 0.1 0 0.1 0.2 0.3 0.9273618
EDGE_SE3:QUAT 0 1 1 0 0 0.10000001 0.2 0.3 0.9273618 100 1 0 0 0 0 100 0 0 0 0 100 0 0 0 400 2 0 400 0 400
"""


def line(count):
    """A graph of poses on a line, one meter apart."""
    graph = boxplus.Graph()
    graph.add_vertices(SE2, np.arange(count), np.c_[np.arange(count), np.zeros((count, 2))])
    return graph


class Arrays(unittest.TestCase):
    def test_a_graph_from_arrays_equals_the_graph_of_the_file_bit_by_bit(self):
        for text in (FILE_2D, FILE_3D):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "graph.g2o"
                path.write_text(text, encoding="utf-8")
                from_file = boxplus.load(path)
            graph = graph_from_arrays(parse_g2o(text))
            self.assertEqual(graph.to_text(), from_file.to_text())
            self.assertEqual(graph.chi2(), from_file.chi2())
            reports = boxplus.optimize(graph), boxplus.optimize(from_file)
            self.assertEqual(reports[0].chi2_final, reports[1].chi2_final)
            self.assertEqual(graph.to_text(), from_file.to_text())

    def test_estimates_are_sorted_by_id_and_keep_their_bits(self):
        graph = boxplus.Graph()
        rows = np.array([[0.1, 0.2, 0.3, 0.1, 0.2, 0.3, 0.9273618], [1, 2, 3, 0, 0, 0.6, 0.8]])
        graph.add_vertices(SE3, [7, 3], rows)
        graph.add_vertex(Vector2(5, 6), 1)
        ids, estimates = graph.estimates(SE3)
        np.testing.assert_array_equal(ids, [3, 7])
        np.testing.assert_array_equal(estimates, rows[::-1])
        np.testing.assert_array_equal(graph.estimates(Vector2)[1], [[5, 6]])
        self.assertEqual(graph.estimates(SE2)[1].shape, (0, 3))

    def test_vertices_without_ids_get_the_next_free_ids(self):
        graph = boxplus.Graph()
        graph.add_vertex(SE2(), 1)
        np.testing.assert_array_equal(graph.add_vertices(SE2, None, np.zeros((3, 3))), [0, 2, 3])

    def test_arrays_may_have_any_type_of_real_numbers_and_any_strides(self):
        rows = np.arange(24).reshape(4, 6)
        expected = rows[::2, ::2].astype(float)
        expected[:, 2] = np.arctan2(np.sin(expected[:, 2]), np.cos(expected[:, 2]))
        for estimates in (rows[::2, ::2], rows[::2, ::2].astype(np.float32), np.asfortranarray(rows[::2, ::2]),
                          rows[::2, ::2].tolist(), rows.astype(">i4")[::2, ::2]):
            graph = boxplus.Graph()
            graph.add_vertices(SE2, np.array([0, 1], dtype=np.uint8), estimates)
            np.testing.assert_allclose(graph.estimates(SE2)[1], expected, atol=1e-12)

    def test_set_estimates_writes_what_estimates_reads(self):
        graph = line(3)
        ids, rows = graph.estimates(SE2)
        graph.set_estimates(SE2, ids[::-1], rows[::-1] + [0, 5, 0])
        np.testing.assert_array_equal(graph.estimates(SE2)[1], rows + [0, 5, 0])

    def test_one_vertex_and_one_information_may_stand_for_all_edges(self):
        graph = line(4)
        beacon = graph.add_vertex(Vector2(0, 3))
        edges = graph.add_edges(PointObservation2, np.arange(4), beacon, measurements=np.ones((4, 2)), informations=4)
        self.assertEqual([graph.vertices(edge)[1] for edge in edges], [beacon] * 4)
        self.assertEqual(graph.information(edges[3]).tolist(), [[4, 0], [0, 4]])
        ranges = graph.add_edges(Range, np.arange(4), beacon, measurements=[1, 2, 3, 4.5], informations=[1, 2, 3, 4])
        self.assertEqual(graph.measurement(ranges[3]), 4.5)
        self.assertEqual(graph.information(ranges[3]).tolist(), [[4]])
        priors = graph.add_edges(Prior, [0, 1], measurements=np.zeros((2, 3)), informations=np.diag([1, 2, 3]))
        self.assertEqual(graph.information(priors[1]).tolist(), [[1, 0, 0], [0, 2, 0], [0, 0, 3]])
        self.assertEqual(graph.add_edges(Between, [], [], measurements=[]), [])

    def assert_refused(self, error, text, function):
        """The function must raise the error, and its message must contain the text."""
        with self.assertRaises(error) as raised:
            function()
        self.assertIn(text, str(raised.exception))

    def test_wrong_estimates_are_refused_and_change_nothing(self):
        graph = line(2)
        before = graph.to_text()
        for error, text, ids, rows in (
                (ValueError, "estimates: expected an array of shape (n, 3) with the columns x y theta, got a float64 "
                 "array of shape (1, 2)", [5], [[1, 2]]),
                (ValueError, "estimates: expected an array of shape (n, 3)", [5], [1, 2, 3]),
                (ValueError, "estimates: expected as many rows as ids (2), got 1", [5, 6], [[1, 2, 3]]),
                (ValueError, "estimates: expected finite numbers, got nan at [1, 2]", [5, 6], [[1, 2, 3], [1, 2, np.nan]]),
                (TypeError, "estimates: expected an array of real numbers, got a complex128 array of shape (1, 3)", [5],
                 np.ones((1, 3)) * 1j),
                (TypeError, "estimates: expected an array of real numbers", [5], [["1", "2", "3"]]),
                (TypeError, "estimates: expected an array of real numbers", [5], [[1, 2], [3]]),
                (TypeError, "ids: expected an array of integers of shape (n,), got a float64 array", [5.5], [[1, 2, 3]]),
                (ValueError, "ids: expected an array of integers of shape (n,)", [[5]], [[1, 2, 3]]),
                (ValueError, "ids: expected ids from 0 to 2**63 - 1, got -1 at [1]", [5, -1], np.ones((2, 3))),
                (ValueError, "got 18446744073709551615 at [0]", np.array([2**64 - 1], dtype=np.uint64), [[1, 2, 3]]),
                (boxplus.InvalidArgument, "ids[1]: expected a new id, got 1, which is taken", [5, 1], np.ones((2, 3))),
                (boxplus.InvalidArgument, "ids[1]: expected a new id, got 5", [5, 5], np.ones((2, 3)))):
            with self.subTest(text):
                self.assert_refused(error, text, lambda: graph.add_vertices(SE2, ids, rows))
                self.assertEqual(graph.to_text(), before)
        self.assert_refused(TypeError, "type: expected one of the classes", lambda: graph.add_vertices("SE2", [5], [[1]]))
        self.assert_refused(TypeError, "type: expected one of the classes", lambda: graph.estimates(Between))
        self.assert_refused(ValueError, "estimates[0]: expected a quaternion (qx qy qz qw) of length 1, got [0.0, 0.0, 0.0, 2.0]",
                            lambda: graph.add_vertices(SE3, [5], [[0, 0, 0, 0, 0, 0, 2]]))
        self.assert_refused(TypeError, "ids[1]: expected a vertex of the type SE2",
                            lambda: graph.set_estimates(SE2, [0, graph.id(graph.add_vertex(Vector2(0, 0)))], np.ones((2, 3))))

    def test_vertices_of_arrays_may_be_vertex_refs(self):
        graph = line(3)
        refs = graph.all_vertices()
        for first, second in ((refs[:2], refs[1:]), ([0, refs[1]], np.array(refs[1:])), (tuple(refs[:2]), [1, 2])):
            edges = graph.add_edges(Between, first, second, measurements=np.ones((2, 3)))
            self.assertEqual([graph.vertices(edge) for edge in edges], [refs[:2], refs[1:]])
        graph.set_estimates(SE2, refs[1:], [[7, 8, 0], [9, 10, 0]])
        self.assertEqual(graph.estimate(2), SE2(9, 10, 0))
        removed = graph.add_vertex(SE2())
        graph.remove(removed)
        before = graph.to_text()
        other = boxplus.Graph()
        other.add_vertex(Vector2(1, 2))
        for wrong in (removed, line(2).vertex(1), other.add_vertex(SE2())):
            self.assert_refused(boxplus.InvalidArgument, "vertices[1][1]: expected a vertex of this graph",
                                lambda: graph.add_edges(Between, refs[:2], [refs[1], wrong], measurements=np.ones((2, 3))))
            self.assert_refused(boxplus.InvalidArgument, "ids[1]: expected a vertex of this graph",
                                lambda: graph.set_estimates(SE2, [refs[1], wrong], np.ones((2, 3))))
            self.assertEqual(graph.to_text(), before)
        self.assert_refused(TypeError, "vertices[1][1]: expected a VertexRef or the id of a vertex, got 'c' (str)",
                            lambda: graph.add_edges(Between, refs[:2], [refs[1], "c"], measurements=np.ones((2, 3))))
        self.assertEqual(len(graph.add_edges(lambda a, b: b.x() - a.x() - 1, refs[:2], refs[1:])), 2)

    def test_wrong_edges_are_refused_and_change_nothing(self):
        graph = line(3)
        graph.add_vertex(Vector2(0, 0), 9)
        before = graph.to_text()
        i, j, z = [0, 1], [1, 2], np.ones((2, 3))
        indefinite = np.array([np.eye(3), np.diag([1.0, -1, 1])])
        for error, text, vertices, measurements, omega in (
                (ValueError, "vertices[1]: expected as many rows as measurements (2), got 1", ([0, 1], [1]), z, 1),
                (boxplus.InvalidArgument, "vertices[0][1]: there is no vertex with the id 5", ([0, 5], j), z, 1),
                (TypeError, "Between: expected vertices of the types (SE2, SE2)", ([9, 9], j), z, 1),
                (TypeError, "vertices[0]: expected vertices of one type, got SE2 at [0] and Vector2 at [1]", ([0, 9], j), z, 1),
                (ValueError, "measurements: expected an array with a row per edge, got 3 (int)", (i, j), 3, 1),
                (TypeError, "Between: expected vertices of the types", (i,), z, 1),
                (ValueError, "measurements: expected an array of shape (n, 3)", (i, j), np.ones((2, 7)), 1),
                (ValueError, "measurements: expected finite numbers, got inf at [0, 0]", (i, j), z * np.inf, 1),
                (ValueError, "informations: expected a number, or an array of shape (3, 3), (n,) or (n, 3, 3)", (i, j), z,
                 np.ones((2, 6))),
                (ValueError, "informations: expected one information for all edges or one for each of 2", (i, j), z,
                 [1, 2, 3]),
                (boxplus.InvalidArgument, "edge 1 of the arrays: information: expected a positive semi-definite matrix",
                 (i, j), z, indefinite),
                (boxplus.InvalidArgument, "expected a symmetric matrix", (i, j), z, np.triu(np.ones((3, 3)))),
                (boxplus.InvalidArgument, "edge 1 of the arrays", ([0, 1], [1, 1]), z, 1)):
            with self.subTest(text):
                self.assert_refused(error, text, lambda: graph.add_edges(Between, *vertices, measurements=measurements,
                                                                         informations=omega))
                self.assertEqual(graph.to_text(), before)
        self.assert_refused(TypeError, "edge: expected one of Between, Prior",
                            lambda: graph.add_edges(SE2, i, j, measurements=z))

    def test_a_masked_array_is_refused_if_numbers_are_masked(self):
        graph = line(3)
        edge = graph.add_edge(Between(boxplus.SE2()), 0, 1)
        masked = np.ma.array([[1.0, 2, 3], [4, 5, 6]], mask=[[False] * 3, [False, True, False]])
        row, omega = masked[1], np.ma.masked_equal(np.eye(3), 0)
        i = np.ma.array([0, 1], mask=[True, False])
        quaternion = np.ma.array([0, 0, 0, 1.0], mask=[False, False, False, True])
        camera = boxplus.SimplePinholeCamera(500, 320, 240)
        pose, point = graph.add_vertex(SE3()), graph.add_vertex([0.0, 0, 5])
        before = graph.to_text()
        for name, call in (
                ("estimates", lambda: graph.add_vertices(SE2, [5, 6], masked)),
                ("estimates", lambda: graph.add_vertices(SE2, [5, 6], list(masked))),
                ("estimates", lambda: graph.set_estimates(SE2, [0, 1], masked)),
                ("ids", lambda: graph.set_estimates(SE2, i, np.ones((2, 3)))),
                ("measurements", lambda: graph.add_edges(Between, [0, 1], [1, 2], measurements=masked)),
                (r"vertices\[0\]", lambda: graph.add_edges(Between, i, [1, 2], measurements=np.ones((2, 3)))),
                ("informations", lambda: graph.add_edges(Between, [0, 1], [1, 2], measurements=np.ones((2, 3)),
                                                         informations=omega)),
                ("estimate", lambda: graph.add_vertex(row[:2])), ("estimate", lambda: graph.add_vertex((SE3(), row))),
                ("estimate", lambda: graph.add_parameter(row)),
                ("information", lambda: graph.set_information(edge, omega)),
                ("information", lambda: graph.add_edge(Between(SE2()), 0, 2, information=omega)),
                ("measurement", lambda: graph.add_edge(Prior(row), point)),
                ("measurement", lambda: graph.add_edge(boxplus.PositionPrior(row), pose)),
                ("measurement", lambda: graph.add_edge(boxplus.PointObservation3(row), pose, point)),
                ("measurement", lambda: graph.add_edge(boxplus.Constraint(Prior(row)), point)),
                ("measurement", lambda: graph.add_edge(boxplus.CalibratedReprojection(row[:2], camera), pose, point)),
                ("measurements", lambda: graph.add_edges(boxplus.CalibratedReprojection, pose, point, camera=camera,
                                                         measurements=[row[:2]])),
                ("directions", lambda: graph.fix_directions(0, i)), ("rotation", lambda: SE3([0, 0, 0], quaternion)),
                ("vector", lambda: SE2.from_vector(row)), ("delta", lambda: SE2().oplus(row)),
                ("coefficients", lambda: boxplus.Plane3(quaternion)), ("moment", lambda: boxplus.Line3(row, [0, 0, 1])),
                ("parameters|vector", lambda: boxplus.SimplePinholeCamera.from_vector(row)),
                ("point", lambda: camera.project(row)), ("rows", lambda: boxplus.rows.times(masked, masked))):
            with self.subTest(name), self.assertRaisesRegex(
                    ValueError, f"^({name}): expected an array without masked numbers, got a masked array"):
                call()
            self.assertEqual(graph.to_text(), before)
        graph.add_vertices(SE2, [5], np.ma.array([[1.0, 2, 3]], mask=False))
        self.assertEqual(graph.estimate(5).vector().tolist(), [1, 2, 3])

    def test_a_masked_error_is_refused(self):
        class Masked(boxplus.BatchedEdge):
            def error(self, x):
                return np.ma.masked_less(x[:, 0], 10)

        graph = line(3)
        self.assert_refused(ValueError, "Masked: expected an array without masked numbers",
                            lambda: graph.add_edges(Masked(), [0, 1]))
        self.assert_refused(ValueError, "expected an array without masked numbers",
                            lambda: graph.add_edge(lambda x: np.ma.masked_less(x.vector(), 10), 0))


if __name__ == "__main__":
    unittest.main()
