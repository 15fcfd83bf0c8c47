# SPDX-License-Identifier: BSD-3-Clause
"""Cameras, and the edges of images."""

import copy
import pathlib
import pickle
import tempfile
import unittest

import boxplus
import numpy as np
from boxplus import (SE3, SO3, BalCamera, Between, CalibratedReprojection, FovCamera, FullOpenCvCamera, Graph, OpenCvCamera, OpenCvFisheyeCamera,
                     PinholeCamera, RadialCamera, RadialFisheyeCamera, Reprojection, SimplePinholeCamera, SimpleRadialCamera,
                     SimpleRadialFisheyeCamera, ThinPrismFisheyeCamera, Vector3, RadTanThinPrismFisheyeCamera, SimpleDivisionCamera,
                     DivisionCamera, SimpleFisheyeCamera, FisheyeCamera, EucmCamera, optimize)

CAMERAS = (BalCamera(500, -0.1, 0.02), SimplePinholeCamera(500, 320, 240), PinholeCamera(500, 510, 320, 240),
           SimpleRadialCamera(500, 320, 240, 0.1), RadialCamera(500, 320, 240, 0.1, -0.02),
           OpenCvCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3), OpenCvFisheyeCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3),
           FullOpenCvCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3, 1e-3, 0.01, 0.02, 1e-3), FovCamera(500, 510, 320, 240, 0.5),
           SimpleRadialFisheyeCamera(500, 320, 240, 0.1), RadialFisheyeCamera(500, 320, 240, 0.1, -0.02),
           ThinPrismFisheyeCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3, 1e-3, 1e-4, 1e-3, 1e-3),
           RadTanThinPrismFisheyeCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3, 1e-3, 1e-4, 1e-3, 2e-3, 3e-3, 1e-3, 2e-3, 1e-3),
           SimpleDivisionCamera(500, 320, 240, -0.1), DivisionCamera(500, 510, 320, 240, -0.1), SimpleFisheyeCamera(500, 320, 240),
           FisheyeCamera(500, 510, 320, 240), EucmCamera(500, 510, 320, 240, 0.6, 1.1))
POSE = SE3([0.3, -0.2, 0.1], SO3.from_rotation_vector([0.02, -0.03, 0.1]))
BAL = """1 2 2
0 0 12.5 -20.25
0 1 -3 4
0.01 0.02 0.03 0.1 0.2 -5 500 -0.1 0.02
0.5 -0.25 1
-1 0.75 0.5
"""


def forward(camera):
    """The z of points that a camera sees."""
    return -1 if isinstance(camera, BalCamera) else 1


class Cameras(unittest.TestCase):
    def test_a_pinhole_camera_projects_one_point_or_many(self):
        camera = PinholeCamera(500, 510, 320, 240)
        np.testing.assert_allclose(camera.project([1, 2, 4]), [500 / 4 + 320, 510 / 2 + 240])
        points = np.array([[1, 2, 4], [0, 0, 1], [-1, 1, 2]])
        np.testing.assert_allclose(camera.project(points), [camera.project(point) for point in points])
        self.assertEqual(camera.project(np.zeros((0, 3))).shape, (0, 2))
        self.assertTrue(camera.sees([1, 2, 4]))
        self.assertFalse(camera.sees([1, 2, -4]))

    def test_radial_distortion_moves_pixels_away_from_the_center(self):
        u, v = 0.5, -0.25
        r2 = u * u + v * v
        factor = 1 + 0.1 * r2 - 0.02 * r2 * r2
        np.testing.assert_allclose(RadialCamera(500, 320, 240, 0.1, -0.02).project([2 * u, 2 * v, 2]),
                                   [500 * factor * u + 320, 500 * factor * v + 240])
        factor = 1 - 0.1 * r2 + 0.02 * r2 * r2
        np.testing.assert_allclose(BalCamera(500, -0.1, 0.02).project([2 * u, 2 * v, -2]), [500 * factor * u, 500 * factor * v])

    def test_every_camera_has_named_parameters_a_text_and_a_pickle(self):
        for camera in CAMERAS:
            with self.subTest(camera):
                names, numbers = type(camera).parameter_names, camera.parameters
                self.assertEqual(len(names), len(numbers))
                self.assertEqual(type(camera)(**dict(zip(names, numbers))), camera)
                self.assertEqual(type(camera)(*numbers[:2], **dict(zip(names[2:], numbers[2:]))), camera)
                self.assertEqual(type(camera).from_vector(numbers), camera)
                self.assertEqual(eval(repr(camera), vars(boxplus)), camera)
                self.assertEqual(pickle.loads(pickle.dumps(camera)), camera)
                self.assertEqual(copy.copy(camera), camera)
                delta = np.arange(1, len(numbers) + 1)
                np.testing.assert_allclose(camera.oplus(delta).parameters, numbers + delta)
                np.testing.assert_allclose(camera.oplus(delta).ominus(camera), delta)
                np.testing.assert_array_equal(type(camera)().parameters, np.zeros(len(numbers)))

    def test_wrong_parameters_are_named(self):
        for error, text, make in (
                (TypeError, "PinholeCamera: expected the parameters fx fy cx cy, got 3 numbers", lambda: PinholeCamera(1, 2, 3)),
                (TypeError, "got 5 numbers", lambda: PinholeCamera(1, 2, 3, 4, 5)),
                (TypeError, "got 3 numbers and ['f']", lambda: PinholeCamera(1, 2, 3, f=4)),
                (TypeError, "got 4 numbers and ['fx']", lambda: PinholeCamera(1, 2, 3, 4, fx=5)),
                (ValueError, "cy", lambda: PinholeCamera(1, 2, 3, np.nan)),
                (TypeError, "fy", lambda: PinholeCamera(1, "2", 3, 4)),
                (ValueError, "point: expected an array of shape (3,): x y z", lambda: CAMERAS[0].project([1, 2])),
                (ValueError, "points: expected an array of shape (n, 3) with the columns x y z", lambda: CAMERAS[0].project([[1, 2]]))):
            with self.subTest(text), self.assertRaises(error) as raised:
                make()
            self.assertIn(text, str(raised.exception))


class Edges(unittest.TestCase):
    def test_the_error_is_the_projected_point_minus_the_pixel(self):
        for camera in CAMERAS:
            with self.subTest(camera):
                graph = Graph()
                point = np.array([0.4, -0.3, 2 * forward(camera)])
                vertices = [graph.add_vertex(x) for x in (POSE, point, camera)]
                edge = graph.add_edge(Reprojection([100, 200]), *vertices)
                np.testing.assert_allclose(graph.error(edge), camera.project(POSE.inverse_times(point)) - [100, 200], rtol=1e-12)
                np.testing.assert_array_equal(graph.measurement(edge), [100, 200])
                self.assertEqual(graph.estimate(vertices[2]), camera)
                np.testing.assert_array_equal(graph.estimates(type(camera))[1], [camera.parameters])

    def test_bundle_adjustment_finds_points_poses_and_the_camera(self):
        random = np.random.default_rng(1)
        truth, points = PinholeCamera(500, 510, 320, 240), random.uniform(-1, 1, size=(40, 3)) + [0, 0, 5]
        poses = [SE3([0.5 * k - 1, 0.2 * (k % 2), 0], SO3.from_rotation_vector([0, -0.1 * (k - 2), 0.02])) for k in range(5)]
        graph = Graph()
        pose_ids = graph.add_vertices(SE3, None, [pose.oplus(0.01 * (k > 1) * random.normal(size=6)).vector()
                                                  for k, pose in enumerate(poses)])
        point_ids = graph.add_vertices(Vector3, None, points + 0.02 * random.normal(size=points.shape))
        camera = graph.add_vertex(PinholeCamera(480, 480, 330, 230))
        for pose_id, pose in zip(pose_ids, poses):
            pixels = truth.project([pose.inverse_times(point) for point in points])
            graph.add_edges(Reprojection, pose_id, point_ids, camera, measurements=pixels)
        graph.fix(pose_ids[0])
        graph.fix(pose_ids[1])
        for point in point_ids:
            graph.set_eliminated(point, True)
        report = optimize(graph, max_iterations=50)
        self.assertTrue(report.converged())
        self.assertLess(report.chi2_final, 1e-12)
        np.testing.assert_allclose(graph.estimate(camera).parameters, truth.parameters, rtol=1e-6)
        np.testing.assert_allclose(graph.estimates(Vector3)[1], points, atol=1e-6)
        self.assertIn("Reprojection<PINHOLE>", str(report))

    def test_an_edge_may_have_a_known_camera(self):
        for camera in CAMERAS:
            with self.subTest(camera):
                graph = Graph()
                pose, point = graph.add_vertex(POSE), graph.add_vertex(POSE * np.array([0.2, -0.1, 2 * forward(camera)]))
                known = graph.add_edge(CalibratedReprojection([3, 4], camera), pose, point)
                other = graph.add_edge(Reprojection([3, 4]), pose, point, graph.add_vertex(camera))
                self.assertEqual(graph.edge_type(known), f"CalibratedReprojection<{graph.edge_type(other)[13:-1]}>")
                np.testing.assert_array_equal(graph.error(known), graph.error(other))
                for found, expected in zip(graph.jacobian(known), graph.jacobian(other)):
                    np.testing.assert_allclose(found, expected, atol=1e-9)
                graph.set_measurement(known, [5, 6])
                self.assertEqual(graph.measurement(known).tolist(), [5, 6])
                np.testing.assert_allclose(graph.error(known), graph.error(other) - 2)
                array, = graph.add_edges(CalibratedReprojection, pose, [point.slot + 1], measurements=[[5, 6]], camera=camera)
                np.testing.assert_array_equal(graph.error(array), graph.error(known))

    def test_a_pose_is_found_from_known_points_and_a_known_camera(self):
        camera = OpenCvCamera(500, 510, 320, 240, 0.1, -0.02, 1e-3, 2e-3)
        points = np.random.default_rng(1).uniform([-1, -1, 3], [1, 1, 5], (20, 3))
        graph = Graph()
        pose = graph.add_vertex(SE3())
        ids = graph.add_vertices(Vector3, None, [POSE * p for p in points])
        for point in ids:
            graph.fix(point)
        graph.add_edges(CalibratedReprojection, pose, ids, measurements=camera.project(points), camera=camera)
        self.assertTrue(optimize(graph).converged())
        np.testing.assert_allclose(graph.estimate(pose).ominus(POSE), 0, atol=1e-8)

    def test_a_missing_or_wrong_camera_is_named(self):
        graph = Graph()
        pose, point, camera = graph.add_vertex(POSE), graph.add_vertex([1, 2, 3]), CAMERAS[2]
        edge = CalibratedReprojection([1, 2], camera)
        self.assertEqual((edge.camera, repr(edge)), (camera, f"CalibratedReprojection([1, 2], {camera!r})"))
        for text, function in (
                ("camera: expected one of BalCamera, SimplePinholeCamera", lambda: graph.add_edge(CalibratedReprojection([1, 2], POSE), pose, point)),
                ("camera: expected one of BalCamera", lambda: graph.add_edges(CalibratedReprojection, pose, point, measurements=[[1, 2]])),
                ("CalibratedReprojection: expected vertices of the types (SE3, Vector3), got (Vector3, SE3)", lambda: graph.add_edge(edge, point, pose)),
                ("camera: expected None, because Range takes no camera",
                 lambda: graph.add_edges(boxplus.Range, pose, point, measurements=[1], camera=camera)),
                ("camera: expected None", lambda: graph.add_edges(lambda x: x, point, camera=camera)),
                ("camera", lambda: CalibratedReprojection([1, 2]))):
            with self.subTest(text), self.assertRaises(TypeError) as raised:
                function()
            self.assertIn(text, str(raised.exception))

    def test_a_pose_and_a_camera_may_be_one_vertex(self):
        camera = CAMERAS[0]
        graph = Graph()
        vertex = graph.add_vertex((POSE, camera))
        row = [*POSE.vector(), *camera.parameters]
        ids = graph.add_vertices((SE3, BalCamera), None, [row])
        self.assertEqual([graph.estimate(vertex), graph.estimate(ids[0])], [(POSE, camera)] * 2)
        np.testing.assert_array_equal(graph.estimates((SE3, BalCamera))[1], [row, row])
        self.assertEqual(graph.tangent_dim(vertex), 9)
        point = np.array([0.4, -0.3, -2])
        edges = graph.add_edges(Reprojection, ids, graph.add_vertex(point), measurements=[[1, 2]])
        numeric = graph.add_edge(lambda x, p: x[1].project(x[0].inverse_times(p)) - [1, 2], *graph.vertices(edges[0]))
        np.testing.assert_allclose(graph.error(numeric), graph.error(edges[0]), rtol=1e-9)
        for found, expected in zip(graph.jacobian(numeric), graph.jacobian(edges[0])):
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * np.abs(expected).max())
        graph.set_estimate(vertex, (SE3(), BalCamera(1, 2, 3)))
        self.assertEqual(graph.estimate(vertex), (SE3(), BalCamera(1, 2, 3)))

    def test_the_cameras_of_a_file_are_read_and_changed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "problem.txt"
            path.write_text(BAL, encoding="utf-8")
            graph = boxplus.load(path)
        ids, rows = graph.estimates((SE3, BalCamera))
        np.testing.assert_allclose(rows[:, 7:], [[500, -0.1, 0.02]])
        pose, camera = graph.estimate(ids[0])
        edge = graph.all_edges()[0]
        point = graph.estimate(graph.vertices(edge)[1])
        np.testing.assert_allclose(graph.error(edge), camera.project(pose.inverse_times(point)) - [12.5, -20.25], rtol=1e-12)
        rows[:, 7] = 400
        graph.set_estimates((SE3, BalCamera), ids, rows)
        self.assertEqual(graph.estimate(ids[0])[1], BalCamera(400, -0.1, 0.02))

    def test_wrong_vertices_and_classes_are_named(self):
        graph = Graph()
        pose = graph.add_vertex(POSE)
        with self.assertRaisesRegex(TypeError, r"\(SE3, Vector3, PinholeCamera\) or .*\(\(SE3, BalCamera\), Vector3\), got \(SE3, SE3\)"):
            graph.add_edge(Reprojection([1, 2]), pose, pose)
        with self.assertRaisesRegex(TypeError, "type: expected one of the classes .*, PinholeCamera, .*, got"):
            graph.estimates((SE3, PinholeCamera, SE3))
        with self.assertRaisesRegex(TypeError, "estimate: expected a PinholeCamera, got SE3"):
            graph.set_estimate(graph.add_vertex(CAMERAS[2]), POSE)
        with self.assertRaisesRegex(TypeError, "estimate: expected an SE3, got "):
            graph.set_estimate(pose, CAMERAS[2])
        with self.assertRaisesRegex(TypeError, "measurement: expected|Between: expected"):
            graph.add_edge(Between(CAMERAS[2]), graph.add_vertex(CAMERAS[2]), graph.add_vertex(CAMERAS[2]))


if __name__ == "__main__":
    unittest.main()
