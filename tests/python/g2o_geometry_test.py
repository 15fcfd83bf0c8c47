# SPDX-License-Identifier: BSD-3-Clause
"""Rotations and poses of the package g2o."""

import unittest

import boxplus
import g2o
import numpy as np
from g2o import _rows
from g2o_worlds import pose2, pose3


class Rotations(unittest.TestCase):
    def test_a_quaternion_can_be_made_from_numbers_a_matrix_and_an_angle(self):
        half = np.sqrt(0.5)
        for q in (g2o.Quaternion(half, 0, 0, half), g2o.Quaternion([0, 0, half, half]),
                  g2o.Quaternion(np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])),
                  g2o.Quaternion(g2o.AngleAxis(np.pi / 2, [0, 0, 1])), g2o.Quaternion.from_two_vectors([1, 0, 0], [0, 3, 0])):
            np.testing.assert_allclose(q.coeffs(), [0, 0, half, half], atol=1e-15)
            np.testing.assert_allclose(q * [1, 0, 0], [0, 1, 0], atol=1e-15)
        self.assertEqual((q.w(), q.x(), q.y(), q.z()), (q.coeffs()[3], *q.vec()))

    def test_quaternions_and_matrices_are_converted_without_loss(self):
        random = np.random.default_rng(1)
        for _ in range(100):
            q = g2o.Quaternion(random.normal(size=4)).normalized()
            R = q.to_rotation_matrix()
            np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-14)
            self.assertLess(g2o.Quaternion(R).angular_distance(q), 1e-7)
            np.testing.assert_allclose(g2o.Quaternion(R).R, R, atol=1e-14)
        for axis in np.eye(3):  # half turns
            R = 2 * np.outer(axis, axis) - np.eye(3)
            np.testing.assert_allclose(g2o.Quaternion(R).R, R, atol=1e-14)

    def test_slerp_turns_at_a_constant_rate(self):
        a, b = g2o.Quaternion(), g2o.Quaternion(g2o.AngleAxis(1.0, [0, 1, 0]))
        self.assertAlmostEqual(a.slerp(0.3, b).angular_distance(a), 0.3, delta=1e-12)
        self.assertTrue(a.slerp(1, b).is_approx(b))

    def test_opposite_directions_are_half_a_turn_apart(self):
        for axis in np.eye(3):
            np.testing.assert_allclose(g2o.Quaternion.from_two_vectors(axis, -axis) * axis, -axis, atol=1e-12)

    def test_wrong_rotations_are_refused(self):
        for values in ([1, 2, 3], [[1, 0], [0, 1]], np.diag([1, 1, -1]), [np.nan] * 4):
            with self.subTest(values), self.assertRaises(ValueError):
                g2o.Quaternion(values)
        with self.assertRaises(TypeError):
            g2o.Quaternion(1, 2)


class Poses(unittest.TestCase):
    def test_isometries_are_those_of_boxplus(self):
        random = np.random.default_rng(2)
        for _ in range(20):
            a, b, p = pose3(random), pose3(random), random.normal(size=3)
            A, B = (boxplus.SE3.from_vector(x._row) for x in (a, b))
            np.testing.assert_allclose((a * b).matrix()[:3, 3], (A * B).translation(), atol=1e-12)
            np.testing.assert_allclose((a.inverse() * b).R, A.inverse_times(B).rotation(), atol=1e-12)
            np.testing.assert_allclose(a * p, A * p, atol=1e-12)
            self.assertTrue(g2o.Isometry3d(a.matrix()).is_approx(a) and g2o.Isometry3d(a.R, a.t).is_approx(a))
            self.assertTrue(g2o.Isometry3d(A) == a)

    def test_poses_in_the_plane_are_those_of_boxplus(self):
        random = np.random.default_rng(3)
        for _ in range(20):
            a, b, p = pose2(random), pose2(random), random.normal(size=2)
            A, B = (boxplus.SE2(*x.to_vector()) for x in (a, b))
            np.testing.assert_allclose((a * b).to_vector(), (A * B).vector(), atol=1e-12)
            np.testing.assert_allclose(a.inverse().to_vector(), A.inverse().vector(), atol=1e-12)
            np.testing.assert_allclose(a * p, A * p, atol=1e-12)
            np.testing.assert_allclose(a.to_isometry().inverse() * (a * p), p, atol=1e-12)

    def test_the_exponential_inverts_the_logarithm(self):
        random = np.random.default_rng(4)
        for scale in (0, 1e-9, 1e-5, 1e-3, 0.1, 1, 2.5):
            tangent = random.normal(size=6)
            tangent[:3] *= scale / np.linalg.norm(tangent[:3])
            pose = g2o.SE3Quat.exp(tangent)
            np.testing.assert_allclose(pose.log(), tangent, atol=1e-9)
            other = pose3(random)
            adjoint = g2o.SE3Quat(other).adj()
            np.testing.assert_allclose(g2o.SE3Quat.exp(adjoint @ tangent).matrix(),
                                       (other * pose * other.inverse()).matrix(), atol=1e-9)
            for sigma in (0, 1e-6, 0.5, -1):
                full = np.append(tangent, sigma)
                np.testing.assert_allclose(g2o.Sim3(full).log(), full, atol=1e-9)

    def test_the_exponential_is_the_solution_of_its_differential_equation(self):
        tangent = np.array([0.3, -0.8, 0.5, 1, 2, 3, 0.4])
        step = g2o.Sim3(tangent / 2**20)  # Euler's method by repeated squares
        for _ in range(20):
            step = step * step
        np.testing.assert_allclose(step._row, g2o.Sim3(tangent)._row, atol=1e-8)

    def test_similarities_map_points(self):
        s = g2o.Sim3(g2o.Quaternion(g2o.AngleAxis(np.pi / 2, [0, 0, 1])), [1, 2, 3], 2)
        np.testing.assert_allclose(s.map([1, 0, 0]), [1, 4, 3], atol=1e-12)
        np.testing.assert_allclose((s.inverse() * s).map([5, 6, 7]), [5, 6, 7], atol=1e-12)
        with self.assertRaisesRegex(ValueError, "scale above 0"):
            g2o.Sim3(np.eye(3), [0, 0, 0], 0)

    def test_a_step_of_a_similarity_is_on_the_side_of_the_camera(self):
        random = np.random.default_rng(5)
        estimate, step = g2o.Sim3(pose3(random).R, [1, 2, 3], 1.5), 0.1 * random.normal(size=7)
        vertex = g2o.VertexSim3Expmap()
        vertex.set_estimate(estimate)
        np.testing.assert_allclose(vertex.get_estimate_data(), estimate._row, atol=1e-14)
        vertex.oplus(step)
        np.testing.assert_allclose(vertex.estimate() * [4, 5, 6], (g2o.Sim3(step) * estimate) * [4, 5, 6], atol=1e-12)
        vertex.set_fix_scale(True)
        vertex.set_estimate(estimate)
        vertex.oplus(step)
        step[6] = 0
        np.testing.assert_allclose(vertex.estimate() * [4, 5, 6], (g2o.Sim3(step) * estimate) * [4, 5, 6], atol=1e-12)

    def test_the_changes_of_tangents_are_derivatives(self):
        random = np.random.default_rng(6)
        for make, estimate in ((g2o.VertexSE3Expmap, g2o.SE3Quat(pose3(random))), (g2o.VertexCam, g2o.SBACam(pose3(random))),
                               (g2o.VertexSim3Expmap, g2o.Sim3(pose3(random).R, [1, 2, 3], 1.5))):
            vertex = make()
            vertex.set_estimate(estimate)
            row = vertex._row
            start = vertex._KIND.type.from_vector(row)
            for k in range(vertex.dimension()):
                vertex._row = row
                vertex.oplus(1e-7 * np.eye(vertex.dimension())[k])
                moved = vertex._KIND.type.from_vector(vertex._row).ominus(start) / 1e-7
                vertex._row = row
                np.testing.assert_allclose(vertex._tangent()[:, k], moved, atol=1e-5)


class Derivatives(unittest.TestCase):
    def test_the_chain_rule_holds_for_the_functions_of_rows(self):
        from boxplus._dual import Dual

        random = np.random.default_rng(7)
        a, b = (np.array([pose3(random)._row for _ in range(5)]) for _ in range(2))
        seeds = random.normal(size=(1, *a.shape))
        for function in (lambda x: _rows.logarithm(_rows.compose(x, b)), lambda x: _rows.relative(b, x, a),
                         lambda x: _rows.into(x, b[:, :3]), lambda x: _rows.relative2(b[:, :3], x[:, :3], a[:, :3])):
            exact = function(Dual(a, seeds)).derivative[0]
            numeric = (function(a + 1e-6 * seeds[0]) - function(a - 1e-6 * seeds[0])) / 2e-6
            np.testing.assert_allclose(exact, numeric, atol=1e-6)


if __name__ == "__main__":
    unittest.main()
