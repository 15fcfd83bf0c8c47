# SPDX-License-Identifier: BSD-3-Clause
"""Vertices, edges, copies, and the lifetimes of objects."""

import copy
import gc
import unittest

import boxplus
import numpy as np
from boxplus import SE2, SE3, Between, Graph, InvalidArgument, Optimizer, Prior


def square():
    """Three poses and two edges; the first pose is fixed."""
    graph = Graph()
    for pose in (SE2(0, 0, 0), SE2(0.9, 0.1, 1.4), SE2(1.2, 1.1, 3)):
        graph.add_vertex(pose)
    graph.fix(0)
    turn = Between(SE2(1, 0, np.pi / 2))
    return graph, [graph.add_edge(turn, 0, 1, information=100), graph.add_edge(turn, 1, 2, information=100)]


def numbers(measurement):
    return np.ravel(measurement.vector() if hasattr(measurement, "vector") else measurement).tolist()


class Vertices(unittest.TestCase):
    def test_a_vertex_is_named_by_its_reference_or_its_id(self):
        graph = Graph()
        pose = graph.add_vertex(SE2(1, 2, 0.5), id=7)
        point = graph.add_vertex([3, 4])
        self.assertEqual(graph.estimate(pose), SE2(1, 2, 0.5))
        self.assertEqual(graph.estimate(np.int32(7)), SE2(1, 2, 0.5))
        self.assertEqual(graph.estimate(point).tolist(), [3, 4])
        self.assertEqual([graph.id(vertex) for vertex in graph.all_vertices()], [0, 7])
        self.assertEqual((graph.vertex(7), graph.find_vertex(8)), (pose, None))
        graph.set_estimate(7, SE2())
        self.assertEqual(graph.estimate(pose), SE2())
        self.assertEqual((graph.tangent_dim(pose), graph.tangent_dim(point)), (3, 2))
        self.assertEqual(len({pose, point, graph.vertex(7)}), 2)

    def test_flags_are_those_of_cpp(self):
        graph, _ = square()
        graph.set_eliminated(1, True)
        graph.fix_directions(2, [0, 2])
        self.assertEqual([graph.is_fixed(i) for i in range(3)], [True, False, False])
        self.assertEqual(([graph.is_eliminated(i) for i in range(3)], graph.fixed_directions(2)),
                         ([False, True, False], [0, 2]))
        graph.unfix(0)
        graph.change_id(0, 10)
        self.assertFalse(graph.is_fixed(10))

    def test_bounds_hold_and_the_report_has_their_multipliers(self):
        graph = Graph()
        point = graph.add_vertex([0, 0])
        graph.add_edge(Prior([3, -4]), point)
        graph.set_bounds(point, 0, upper=1)
        graph.set_bounds(point, 1, -2, 2)
        self.assertEqual(graph.bounds(point), [(0, -np.inf, 1), (1, -2, 2)])
        report = boxplus.optimize(graph)
        self.assertTrue(report.converged())
        self.assertEqual(graph.estimate(point).tolist(), [1, -2])
        self.assertEqual([(bound.id, bound.entry, bound.is_upper, bound.limit) for bound in report.active_bounds],
                         [(0, 0, True, 1), (0, 1, False, -2)])
        np.testing.assert_allclose([bound.multiplier for bound in report.active_bounds], [4, 4])
        graph.set_bounds(point, 0)
        self.assertEqual(graph.bounds(point), [(1, -2, 2)])
        with self.assertRaisesRegex(InvalidArgument, "entry from 0 to 1, got 2"):
            graph.set_bounds(point, 2, 0, 1)

    def test_an_estimate_is_a_copy(self):
        graph = Graph()
        graph.add_vertex([1, 2])
        graph.estimate(0)[0] = 5
        self.assertEqual(graph.estimate(0).tolist(), [1, 2])

    def test_wrong_vertices_are_refused(self):
        graph, _ = square()
        other, _ = square()
        for error, text, function in (
                (InvalidArgument, "vertex: there is no vertex with the id 9", lambda: graph.estimate(9)),
                (TypeError, "vertex: expected a VertexRef or the id of a vertex, got 1.5", lambda: graph.estimate(1.5)),
                (TypeError, "vertex: expected a VertexRef or the id of a vertex, got True", lambda: graph.fix(True)),
                (ValueError, "vertex: expected an int of at most 64 bits", lambda: graph.estimate(2**70)),
                (InvalidArgument, "", lambda: graph.estimate(other.vertex(0))),
                (InvalidArgument, "", lambda: graph.add_vertex(SE2(), 0)),
                (TypeError, "estimate: expected one of SE2, SE3, SO2, SO3, S2, Sim3, Plane3, Line3, BalCamera", lambda: graph.add_vertex(range(13))),
                (TypeError, "estimate: expected an SE2, got SE3", lambda: graph.set_estimate(0, SE3()))):
            with self.subTest(text), self.assertRaises(error) as raised:
                function()
            self.assertIn(text, str(raised.exception))

    def test_exceptions_are_also_those_of_python(self):
        self.assertTrue(issubclass(InvalidArgument, (ValueError)) and issubclass(boxplus.FileError, OSError))
        self.assertTrue(issubclass(boxplus.InputError, boxplus.Error) and issubclass(boxplus.Error, RuntimeError))


class Edges(unittest.TestCase):
    def test_an_edge_has_a_measurement_an_information_and_vertices(self):
        graph, edges = square()
        self.assertEqual(graph.measurement(edges[0]), SE2(1, 0, np.pi / 2))
        self.assertEqual(graph.information(edges[0]).tolist(), (100 * np.eye(3)).tolist())
        self.assertEqual(graph.vertices(edges[1]), [graph.vertex(1), graph.vertex(2)])
        self.assertEqual((graph.edges(1), graph.all_edges()), (edges, edges))
        self.assertEqual(graph.edge_type(edges[0]), "Between<SE2>")
        self.assertEqual([block.shape for block in graph.jacobian(edges[0])], [(3, 3), (3, 3)])
        self.assertAlmostEqual(graph.chi2(edges[0]), 100 * graph.error(edges[0]) @ graph.error(edges[0]))
        graph.set_measurement(edges[0], SE2())
        graph.set_information(edges[0], np.diag([1, 2, 3]))
        self.assertEqual(graph.measurement(edges[0]), SE2())
        self.assertAlmostEqual(graph.chi2(edges[0]), graph.error(edges[0]) ** 2 @ [1, 2, 3])

    def test_every_ready_made_edge_of_python_can_be_added(self):
        graph = Graph()
        pose, point, pose3, point3 = (graph.add_vertex(x) for x in (SE2(), [1, 2], SE3(), [1, 2, 3]))
        sensor, sensor3 = graph.add_parameter(SE2(0.1, 0, 0)), graph.add_parameter(SE3())
        x_plane, x_line = boxplus.Plane3(), boxplus.Line3([1, 0, 0], [0, 0, 1])
        plane, line = graph.add_vertex(x_plane), graph.add_vertex(x_line)
        for edge, vertices in (
                (Prior(SE2()), (pose,)), (Prior(SE3()), (pose3,)), (Prior([1, 2]), (point,)),
                (Prior([1, 2, 3]), (point3,)), (boxplus.PositionPrior([1, 2]), (pose,)),
                (boxplus.PositionPrior([1, 2, 3]), (pose3,)), (boxplus.OffsetPositionPrior([1, 2]), (pose, point)),
                (boxplus.OffsetPositionPrior([1, 2, 3]), (pose3, point3)), (boxplus.PointObservation2([1, 2]), (pose, point)),
                (boxplus.PointObservation3([1, 2, 3]), (pose3, point3)),
                (boxplus.OffsetPointObservation2([1, 2]), (pose, point, sensor)),
                (boxplus.OffsetPointObservation3([1, 2, 3]), (pose3, point3, sensor3)),
                (boxplus.BearingObservation2(0.5), (pose, point)),
                (boxplus.BearingObservation3([1, 0, 0]), (pose3, point3)), (boxplus.Range(2), (pose, point)),
                (boxplus.Range(2.5), (pose3, point3)), (boxplus.Range(3), (point, pose)), (boxplus.Range(3), (point3, pose3)),
                (boxplus.Range(1), (point, graph.add_vertex([4, 6]))), (boxplus.Range(1), (pose, graph.add_vertex(SE2(1, 0, 0)))),
                (boxplus.Range(1), (point3, graph.add_vertex([0, 0, 1]))),
                (boxplus.Range(1), (pose3, graph.add_vertex(SE3([1, 0, 0], [0, 0, 0, 1])))), (Prior(x_plane), (plane,)), (Prior(x_line), (line,)),
                (boxplus.PlaneObservation3(x_plane), (pose3, plane)),
                (boxplus.PlaneObservation3(x_plane), (pose3, plane, sensor3)),
                (boxplus.PlaneDifference3([0, 0, 0, 1]), (plane, graph.add_vertex(x_plane))),
                (boxplus.LineObservation3(x_line), (pose3, line)),
                (boxplus.LineObservation3(x_line), (pose3, line, sensor3))):
            added = graph.add_edge(edge, *vertices)
            self.assertEqual(numbers(graph.measurement(added)), numbers(edge.measurement))
            self.assertTrue(np.isfinite(graph.chi2(added)))

    def test_a_range_measures_the_distance_of_two_points(self):
        graph = Graph()
        graph.add_vertices(boxplus.Vector3, [0, 1], [[1, 2, 3], [1, 5, 7]])
        edge, = graph.add_edges(boxplus.Range, [0], [1], measurements=[4])
        self.assertEqual(graph.error(edge).tolist(), [1])
        graph.fix(0)
        self.assertAlmostEqual(boxplus.optimize(graph).chi2_final, 0)
        with self.assertRaisesRegex(TypeError, "Range: expected vertices of the types"):
            graph.add_edge(boxplus.Range(1), 0, graph.add_vertex([1, 2]))

    def test_an_offset_position_prior_measures_the_position_of_a_sensor(self):
        graph = Graph()
        pose, arm = graph.add_vertex(SE2(1, 2, np.pi / 2)), graph.add_parameter([3.0, 0])
        edge = graph.add_edge(boxplus.OffsetPositionPrior([1, 4.5]), pose, arm)
        np.testing.assert_allclose(graph.error(edge), [0, 0.5], atol=1e-15)

    def test_kernels_are_chosen_by_name(self):
        graph, edges = square()
        graph.set_kernel(edges, "Huber", 0.5)
        self.assertEqual((graph.kernel(edges[1]).name(), graph.kernel(edges[1]).delta()), ("Huber", 0.5))
        graph.set_kernel(edges[0], "Cauchy")
        self.assertEqual(graph.kernel(edges[0]).delta(), boxplus.default_width(3))
        graph.set_kernel(edges[0], boxplus.make_robust_kernel("Tukey", 2))
        self.assertEqual(graph.kernel(edges[0])(1e9)[1], 0)
        self.assertLess(graph.weight(edges[1]), 1)
        graph.set_kernel(edges, None)
        self.assertIsNone(graph.kernel(edges[0]))
        with self.assertRaisesRegex(InvalidArgument, "Huber"):
            graph.set_kernel(edges, "Hubert")

    def test_levels_and_disabled_edges_are_those_of_cpp(self):
        graph, edges = square()
        graph.set_enabled(edges[0], False)
        graph.set_level(edges[1], 2)
        self.assertEqual((graph.is_enabled(edges[0]), graph.level(edges[1])), (False, 2))
        self.assertEqual(graph.chi2(), graph.chi2(edges[1]))

    def test_a_removed_element_is_no_longer_contained(self):
        graph, edges = square()
        vertex = graph.vertex(2)
        graph.remove(2)
        self.assertFalse(graph.contains(vertex) or graph.contains(edges[1]) or graph.contains(2))
        with self.assertRaises(InvalidArgument):
            graph.measurement(edges[1])
        graph.remove(edges[0])
        self.assertEqual(graph.edge_count(), 0)

    def test_wrong_edges_are_refused(self):
        graph, edges = square()
        for error, text, function in (
                (TypeError, "measurement: expected an SE2, got SE3", lambda: graph.add_edge(Between(SE3()), 0, 1)),
                (TypeError, "edge: expected one of Between, Prior", lambda: graph.add_edge(SE2(), 0, 1)),
                (TypeError, "Between: expected vertices of the types (SE2, SE2)", lambda: graph.add_edge(Between(SE2()), 0)),
                (ValueError, "information: expected finite numbers, got nan",
                 lambda: graph.add_edge(Between(SE2()), 0, 1, information=np.nan)),
                (InvalidArgument, "", lambda: graph.add_edge(Between(SE2()), 0, 0)),
                (TypeError, "edges: expected an EdgeRef", lambda: graph.set_kernel(1, "Huber"))):
            with self.subTest(text), self.assertRaises(error) as raised:
                function()
            self.assertIn(text, str(raised.exception))


class Lifetimes(unittest.TestCase):
    def test_a_copy_has_its_own_estimates_and_the_same_references(self):
        graph, edges = square()
        graph.set_kernel(edges, "Huber")
        for make in (copy.copy, copy.deepcopy):
            other = make(graph)
            self.assertEqual(other.chi2(), graph.chi2())
            self.assertTrue(boxplus.optimize(other).converged())
            self.assertNotEqual(other.estimate(graph.vertex(1)), graph.estimate(1))
            self.assertEqual(other.kernel(edges[0]).name(), "Huber")

    def test_push_and_pop_restore_estimates(self):
        graph, _ = square()
        before = graph.to_text()
        graph.push()
        boxplus.optimize(graph)
        graph.pop()
        self.assertEqual((graph.to_text(), graph.stack_size()), (before, 0))

    def test_objects_may_be_deleted_in_any_order(self):
        graph, edges = square()
        vertex, optimizer = graph.vertex(1), Optimizer(graph)
        kernel = boxplus.make_robust_kernel("Huber", 1)
        graph.set_kernel(edges, kernel)
        del kernel
        gc.collect()
        other = copy.copy(graph)
        del graph
        gc.collect()
        self.assertTrue(optimizer.run().converged())
        del optimizer
        gc.collect()
        self.assertEqual(other.estimate(vertex), SE2(0.9, 0.1, 1.4))
        self.assertEqual(other.kernel(edges[0]).name(), "Huber")
        records = boxplus.optimize(other).records
        del other
        gc.collect()
        self.assertGreater(records[0].chi2_decrease, 0)
        with self.assertRaises(InvalidArgument):
            Graph().estimate(vertex)


if __name__ == "__main__":
    unittest.main()
