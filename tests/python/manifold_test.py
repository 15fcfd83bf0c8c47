# SPDX-License-Identifier: BSD-3-Clause
"""Rotations, poses, directions and similarities."""

import copy
import pickle
import unittest

import boxplus
import numpy as np
from boxplus import S2, SE2, SE3, SO2, SO3, Sim3

TURN = SO3.from_rotation_vector([0.3, -0.2, 0.5])
GROUPS = (SO2(0.5), SE2(1, 2, 3), TURN, SE3([1, 2, 3], TURN), Sim3(TURN, [1, 2, 3], 2))
EXAMPLES = (*GROUPS, S2([1, 2, 3]))


class Manifold(unittest.TestCase):
    def test_x_times_its_inverse_is_the_identity(self):
        for x in GROUPS:
            np.testing.assert_allclose((x * x.inverse()).ominus(type(x)()), 0, atol=1e-15)

    def test_oplus_is_the_inverse_of_ominus(self):
        for x in EXAMPLES:
            delta = np.linspace(0.1, 0.2, len(x.ominus(x)))
            np.testing.assert_allclose(x.oplus(delta).ominus(x), delta, atol=1e-14)

    def test_copies_and_pickles_keep_every_bit(self):
        for x in EXAMPLES:
            self.assertEqual(copy.copy(x), x)
            self.assertEqual(copy.deepcopy(x), x)
            self.assertEqual(pickle.loads(pickle.dumps(x)), x)
            self.assertNotEqual(x, type(x)())

    def test_the_text_of_a_value_makes_the_value(self):
        for x in (SO2(0.5), SE2(1, 2, 3), SO3(), SE3([1, 2, 3], [0, 0, 0.6, 0.8]), S2([0.6, 0, -0.8]),
                  Sim3([0, 0, 0.6, 0.8], [1, 2, 3], 0.5)):
            self.assertEqual(eval(repr(x), vars(boxplus)), x)

    def test_poses_transform_points(self):
        np.testing.assert_allclose(SE2(1, 2, np.pi / 2) * [1, 0], [1, 3], atol=1e-15)
        np.testing.assert_allclose(SE2(1, 2, np.pi / 2).inverse_times([1, 3]), [1, 0], atol=1e-15)
        np.testing.assert_allclose(SO2(np.pi / 2) * np.array([1, 0]), [0, 1], atol=1e-15)
        np.testing.assert_allclose(EXAMPLES[3] * [1, 0, 0], TURN.rotation()[:, 0] + [1, 2, 3], atol=1e-15)
        np.testing.assert_allclose(TURN * [1, 0, 0], TURN.rotation()[:, 0], atol=1e-15)

    def test_a_rotation_has_four_forms(self):
        for other in (SO3(TURN.quaternion()), SO3(TURN.rotation()), SO3.from_rotation_vector(TURN.rotation_vector()),
                      SE3([0, 0, 0], TURN.rotation()).so3()):
            np.testing.assert_allclose(other.ominus(TURN), 0, atol=1e-15)

    def test_a_pose_has_a_vector(self):
        self.assertEqual(SE2.from_vector([1, 2, 3]), SE2(1, 2, 3))
        self.assertEqual(SE2([1, 2], 3), SE2(1, 2, 3))
        self.assertEqual(SE3.from_vector(EXAMPLES[3].vector()), EXAMPLES[3])
        np.testing.assert_allclose(SE3.from_minimal(EXAMPLES[3].minimal()).vector(), EXAMPLES[3].vector(), atol=1e-15)
        self.assertEqual(boxplus.Vector3(1, 2, 3).tolist(), [1, 2, 3])

    def test_a_similarity_turns_scales_and_moves_points(self):
        x, point = GROUPS[4], np.array([4, -5, 6])
        np.testing.assert_allclose(x * point, 2 * TURN.rotation() @ point + [1, 2, 3], atol=1e-14)
        np.testing.assert_allclose((x * x) * point, x * (x * point), atol=1e-14)
        np.testing.assert_allclose(x.vector(), [1, 2, 3, *TURN.quaternion(), 2], atol=1e-15)
        self.assertEqual(Sim3.from_vector(x.vector()), x)
        self.assertEqual((x.translation().tolist(), x.scale()), ([1, 2, 3], 2))
        np.testing.assert_allclose(Sim3.exp([0, 0, 0, 0, 0, 0, np.log(2)]).vector(), [0, 0, 0, 0, 0, 0, 1, 2], atol=1e-15)

    def test_a_direction_has_length_1_and_a_tangent_of_two_angles(self):
        np.testing.assert_allclose(S2([0, 3, 4]).vector(), [0, 0.6, 0.8], atol=1e-15)
        for length in (1e-200, 1e200):
            np.testing.assert_allclose(S2([0, 3 * length, 4 * length]).vector(), [0, 0.6, 0.8], atol=1e-15)
        moved = S2([0, 3, 4]).oplus([0.3, 0.4])
        self.assertAlmostEqual(np.linalg.norm(moved.vector()), 1)
        self.assertAlmostEqual(np.arccos(moved.vector() @ [0, 0.6, 0.8]), 0.5)

    def test_log_is_the_inverse_of_exp(self):
        for x in (EXAMPLES[1], EXAMPLES[3], EXAMPLES[4]):
            np.testing.assert_allclose(type(x).exp(x.log()).ominus(x), 0, atol=1e-14)
        np.testing.assert_allclose(SE2.exp([1, 0, np.pi / 2]).vector(), [2 / np.pi, 2 / np.pi, np.pi / 2], atol=1e-15)
        np.testing.assert_allclose(SE3.exp([1, 0, 0, 0, 0, np.pi / 2]).translation(), [2 / np.pi, 2 / np.pi, 0],
                                   atol=1e-15)

    def test_wrong_arguments_are_named(self):
        for error, text, function in (
                (ValueError, "x: expected a finite number, got nan", lambda: SE2(np.nan, 0, 0)),
                (ValueError, "vector: expected an array of shape (3,): x y theta", lambda: SE2.from_vector([1, 2])),
                (ValueError, "translation: expected an array of shape (3,): x y z", lambda: SE3([1, 2], TURN)),
                (ValueError, "rotation: expected a quaternion that is not zero", lambda: SO3([0, 0, 0, 0])),
                (ValueError, "rotation: expected a rotation matrix", lambda: SO3(np.diag([1, 1, -1]))),
                (ValueError, "rotation: expected an SO3, a quaternion", lambda: SO3(np.eye(2))),
                (ValueError, "delta: expected an array of shape (6,)", lambda: SE3().oplus([1])),
                (ValueError, "point: expected an array of shape (2,): x y", lambda: SE2() * [1, 2, 3]),
                (ValueError, "vector: expected a vector that is not zero", lambda: S2([0, 0, 0])),
                (ValueError, "scale: expected a positive number, got 0.0", lambda: Sim3(TURN, [1, 2, 3], 0)),
                (ValueError, "scale: expected a positive number, got nan", lambda: Sim3(TURN, [1, 2, 3], np.nan)),
                (ValueError, "vector: expected an array of shape (8,): x y z qx qy qz qw scale", lambda: Sim3.from_vector([1])),
                (ValueError, "a positive scale, got -1.0", lambda: Sim3.from_vector([1, 2, 3, 0, 0, 0, 1, -1])),
                (TypeError, "point: expected an array of real numbers", lambda: SE2() * "text"),
                (TypeError, "point: expected an array of real numbers, got SE3", lambda: SE2() * SE3())):
            with self.subTest(text), self.assertRaises(error) as raised:
                function()
            self.assertIn(text, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
