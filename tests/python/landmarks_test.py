# SPDX-License-Identifier: BSD-3-Clause
"""Planes and lines in space as vertices, with their edges."""

import copy
import pathlib
import pickle
import tempfile
import unittest

import boxplus
import numpy as np
from boxplus import SE3, SO3, BatchedEdge, Graph, Line3, LineObservation3, Plane3, PlaneDifference3, PlaneObservation3, Prior, optimize

POSE = SE3([1, -2, 0.5], SO3.from_rotation_vector([0.3, -0.2, 0.5]))
PLANES = [Plane3(c) for c in ([1, 0.2, 0, -2], [0, 1, 0.1, 3], [0.1, 0, 1, 1], [1, 1, 0, -4])]
LINES = [Line3.through(p, d) for p, d in (([2, 1, 0], [0, 0.1, 1]), ([0, 3, 1], [1, 0, 0.2]), ([-1, 0, 2], [0, 1, 0]))]
EXAMPLES = (Plane3([0, 0, 2, -6], [1, 0.5, 0]), *LINES[:1])


class Classes(unittest.TestCase):
    def test_a_plane_has_coefficients_in_the_scale_in_which_they_were_given(self):
        plane = Plane3([0, 0, 2, -6])
        self.assertEqual((plane.coefficients.tolist(), plane.normal().tolist()), ([0, 0, 2, -6], [0, 0, 2]))
        self.assertEqual(plane.unit(), Plane3([0, 0, 1, -3]))
        self.assertEqual(Plane3.from_vector(plane.vector()), plane)
        self.assertEqual(plane.color.tolist(), [0.2, 0.2, 0.2])
        plane.color = 1, 0, 0.5
        self.assertEqual(plane.unit().color.tolist(), [1, 0, 0.5])
        np.testing.assert_allclose(plane.oplus([0, 0, 0.5]).vector(), [0, 0, 1, -3.5])
        np.testing.assert_allclose(plane.seen_from(SE3([0, 0, 1], SO3())).unit().vector(), [0, 0, 1, -2])

    def test_a_line_has_a_moment_and_a_direction(self):
        line = Line3.through([0, 3, 5], [0, 0, 2])
        self.assertEqual((line.moment.tolist(), line.direction.tolist()), ([6, 0, 0], [0, 0, 2]))
        self.assertEqual((line, Line3.from_vector(line.vector())), (Line3([6, 0, 0], [0, 0, 2]),) * 2)
        self.assertEqual(line.nearest_point().tolist(), [0, 3, 0])
        seen = line.seen_from(POSE)
        np.testing.assert_allclose(np.cross(POSE.inverse_times([0, 3, 7]), seen.direction), seen.moment, atol=1e-14)
        np.testing.assert_allclose(line.oplus([0, 0, 0, 0]).vector(), line.vector() / 2, atol=1e-15)

    def test_a_copy_and_the_text_are_the_same_value(self):
        for x in EXAMPLES:
            for y in (pickle.loads(pickle.dumps(x)), copy.copy(x), copy.deepcopy(x), eval(repr(x), vars(boxplus).copy())):
                self.assertEqual(y, x)
        self.assertEqual(pickle.loads(pickle.dumps(EXAMPLES[0])).color.tolist(), [1, 0.5, 0])

    def test_what_has_no_direction_is_refused(self):
        for text, function in (("a normal (nx ny nz) whose length is neither zero nor huge", lambda: Plane3([0, 0, 0, 1])),
                               ("direction: expected a vector whose length is neither zero", lambda: Line3([0, 0, 0], [0, 0, 0])),
                               ("direction: expected a vector whose length is neither zero nor huge", lambda: Line3.through([1, 2, 3], [0, 0, 1e200])),
                               ("a moment (wx wy wz) that is orthogonal to the direction", lambda: Line3([0, 0, 1], [0, 0, 1])),
                               ("coefficients: expected an array of shape (4,): nx ny nz d", lambda: Plane3([1, 2, 3])),
                               ("vector: expected a moment", lambda: Line3.from_vector([0, 0, 1, 0, 0, 1])), ("color", lambda: Plane3([1, 0, 0, 0], [1, 2]))):
            with self.subTest(text), self.assertRaises(ValueError) as raised:
                function()
            self.assertIn(text, str(raised.exception))


class Vertices(unittest.TestCase):
    def test_estimates_come_back_as_objects_and_as_rows(self):
        for x in EXAMPLES:
            graph = Graph()
            vertex = graph.add_vertex(x)
            self.assertEqual(graph.estimate(vertex), x)
            ids = graph.add_vertices(type(x), None, [x.vector(), type(x)().vector()])
            np.testing.assert_array_equal(graph.estimates(type(x))[1], [x.vector(), x.vector(), type(x)().vector()])
            graph.set_estimates(type(x), [0], [type(x)().vector()])
            graph.set_estimate(ids[1], x)
            self.assertEqual([graph.estimate(i) for i in range(3)], [type(x)(), x, x])
            self.assertEqual(graph.tangent_dim(vertex), len(x.ominus(x)))

    def test_a_plane_keeps_its_color_if_an_array_sets_its_coefficients(self):
        graph = Graph()
        graph.add_vertex(EXAMPLES[0])
        graph.set_estimates(Plane3, [0], [[1, 0, 0, 2]])
        self.assertEqual(graph.estimate(0).color.tolist(), [1, 0.5, 0])

    def test_rows_that_are_no_values_are_refused(self):
        for kind, row, text in ((Plane3, [0, 0, 0, 2], "estimates[0]: expected a normal"),
                                (Line3, [0, 0, 1, 0, 0, 1], "estimates[0]: expected a moment"),
                                (Line3, [1, 2], "estimates: expected an array of shape (n, 6) with the columns wx wy wz dx dy dz")):
            graph = Graph()
            with self.subTest(text), self.assertRaises(ValueError) as raised:
                graph.add_vertices(kind, None, [row])
            self.assertIn(text, str(raised.exception))
            self.assertEqual(graph.vertex_count(), 0)

    def test_a_file_and_a_pickle_contain_them(self):
        graph = Graph()
        graph.add_vertex(SE3())
        plane, line = (graph.add_vertex(x) for x in EXAMPLES)
        graph.add_edge(PlaneObservation3(EXAMPLES[0].seen_from(POSE)), 0, plane, graph.add_vertex(POSE))
        graph.add_edge(LineObservation3(EXAMPLES[1].seen_from(POSE)), 0, line, graph.add_parameter(POSE))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "graph.g2o"
            graph.save(path)
            self.assertIn("VERTEX_PLANE 1 0 0 2 -6 1 0.5 0\n", path.read_text(encoding="utf-8"))
            for other in (boxplus.load(path), pickle.loads(pickle.dumps(graph))):
                self.assertEqual([other.estimate(i) for i in (1, 2)], list(EXAMPLES))
                self.assertEqual(other.estimate(1).color.tolist(), [1, 0.5, 0])
                self.assertEqual(sorted(other.edge_type(edge) for edge in other.all_edges()),
                                 ["LineObservation3", "PlaneObservation3"])
                self.assertLess(other.chi2(), 1e-20)


class Edges(unittest.TestCase):
    def test_a_prior_has_its_minimum_at_the_measurement(self):
        for x, start in zip(EXAMPLES, (Plane3(), LINES[1])):
            graph = Graph()
            vertex = graph.add_vertex(start)
            edge = graph.add_edge(Prior(x), vertex, information=4)
            self.assertEqual((graph.edge_type(edge), graph.measurement(edge)), (f"Prior<{type(x).__name__}>", x))
            np.testing.assert_allclose(graph.error(edge), start.ominus(x), atol=1e-15)
            self.assertTrue(optimize(graph, max_iterations=50).converged())
            np.testing.assert_allclose(graph.estimate(vertex).ominus(x), 0, atol=1e-6)

    def test_an_observation_measures_from_the_pose_or_from_a_sensor_on_it(self):
        sensor = SE3([0.1, 0.2, 0], SO3.from_rotation_vector([0, 0, 0.4]))
        for edge_type, x in ((PlaneObservation3, PLANES[0]), (LineObservation3, LINES[0])):
            graph = Graph()
            pose, vertex, offset = graph.add_vertex(POSE), graph.add_vertex(x), graph.add_parameter(sensor)
            edges = (graph.add_edge(edge_type(x.seen_from(POSE)), pose, vertex),
                     graph.add_edge(edge_type(x.seen_from(POSE * sensor)), pose, vertex, offset))
            for edge in edges:
                np.testing.assert_allclose(graph.error(edge), 0, atol=1e-12)
            array = graph.add_edges(edge_type, pose, [1], measurements=[x.seen_from(POSE).vector()])
            self.assertEqual(graph.measurement(array[0]), graph.measurement(edges[0]))
            with self.assertRaisesRegex(TypeError, r"expected vertices of the types \(SE3, \w+3\) or \(SE3, \w+3, SE3\)"):
                graph.add_edge(edge_type(x), vertex, pose)

    def test_a_difference_of_planes_is_that_of_their_coefficients(self):
        graph = Graph()
        a, b = graph.add_vertex(Plane3([0, 0, 2, -2])), graph.add_vertex(Plane3([0, 1, 0, -3]))
        edge = graph.add_edge(PlaneDifference3([0, 1, 0, 0]), a, b)
        np.testing.assert_allclose(graph.error(edge), [0, 0, -1, -2])

    def test_poses_and_landmarks_are_found_from_observations(self):
        truth = [SE3(), POSE, POSE * POSE]
        graph = Graph()
        poses = [graph.add_vertex(x.oplus([0.05] * 6) if i else x) for i, x in enumerate(truth)]
        graph.fix(poses[0])
        landmarks = [(graph.add_vertex(x.oplus([0.05] * len(x.ominus(x)))), x) for x in PLANES + LINES]
        for vertex, x in landmarks:
            edge = PlaneObservation3 if isinstance(x, Plane3) else LineObservation3
            for pose, X in zip(poses, truth):
                graph.add_edge(edge(x.seen_from(X)), pose, vertex)
        report = optimize(graph)
        self.assertTrue(report.converged())
        for vertex, x in [*zip(poses, truth), *landmarks]:
            np.testing.assert_allclose(graph.estimate(vertex).ominus(x), 0, atol=1e-7)
        self.assertIn("PlaneObservation3", str(report))


class Functions(unittest.TestCase):
    def test_numeric_derivatives_are_those_of_the_edges(self):
        signs = {Plane3: [1, 1, -1], Line3: [1] * 4}
        for edge_type, x in ((PlaneObservation3, EXAMPLES[0]), (LineObservation3, LINES[1])):
            graph, sign, z = Graph(), signs[type(x)], x.seen_from(POSE.oplus([0.1] * 6))
            pose, vertex = graph.add_vertex(POSE), graph.add_vertex(x)
            exact = graph.add_edge(edge_type(z), pose, vertex)
            numeric = graph.add_edge(lambda X, x: z.ominus(x.seen_from(X)) * sign, pose, vertex)  # noqa: B023
            np.testing.assert_allclose(graph.error(numeric), graph.error(exact), atol=1e-12)
            for found, expected in zip(graph.jacobian(numeric), graph.jacobian(exact)):
                np.testing.assert_allclose(found, expected, atol=1e-6)

    def test_a_batched_function_gets_rows_in_the_scale_1_and_has_exact_derivatives(self):
        class DistanceToPlane(BatchedEdge):
            def error(self, point, plane):
                return (point * plane[:, :3]).sum(axis=1) + plane[:, 3]

        class Moment(BatchedEdge):
            def error(self, line):
                return line[:, :3]

        graph = Graph()
        point, plane = graph.add_vertex([1, 2, 5]), graph.add_vertex(EXAMPLES[0])
        line = graph.add_vertex(Line3.through([0, 3, 5], [0, 0.1, 2]))
        distance, = graph.add_edges(DistanceToPlane(), point, [1])
        moment, = graph.add_edges(Moment(), [2])
        same = graph.add_edge(lambda x: x.vector()[:3], line)
        np.testing.assert_allclose(graph.error(distance), 2)
        np.testing.assert_allclose(graph.jacobian(distance)[0], [[0, 0, 1]])
        numeric = graph.add_edge(lambda p, x: x.vector() @ [*p, 1], point, plane)
        for one, other in ((distance, numeric), (moment, same)):
            for found, expected in zip(graph.jacobian(one), graph.jacobian(other)):
                np.testing.assert_allclose(found, expected, atol=1e-8)


if __name__ == "__main__":
    unittest.main()
