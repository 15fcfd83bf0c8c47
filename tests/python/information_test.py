# SPDX-License-Identifier: BSD-3-Clause
"""se3_sigmas()."""

import unittest

import boxplus
import numpy as np
from boxplus import SE3, SO3, Between, Graph, InvalidArgument, Prior, se3_sigmas


class Se3Sigmas(unittest.TestCase):
    def test_rotations_have_four_times_the_information_because_the_error_has_half_the_angle(self):
        omega = se3_sigmas(0.1, 0.5)
        np.testing.assert_allclose(omega, np.diag([100, 100, 100, 16, 16, 16]))
        self.assertEqual((omega.shape, omega.dtype), ((6, 6), np.float64))

    def test_an_error_of_one_sigma_has_chi2_of_one(self):
        graph = Graph()
        graph.add_vertex(SE3([0, 0, 0], SO3.from_rotation_vector([1e-3, 0, 0])), 0)
        prior = graph.add_edge(Prior(SE3()), 0, information=se3_sigmas(0.1, 1e-3))
        self.assertAlmostEqual(graph.chi2(prior), 1, places=6)

    def test_it_suits_one_edge_and_arrays_of_edges(self):
        graph = Graph()
        graph.add_vertices(SE3, None, np.tile(SE3().vector(), (3, 1)))
        edges = graph.add_edges(Between, [0, 1], [1, 2], measurements=np.tile(SE3().vector(), (2, 1)),
                                informations=se3_sigmas(1, 2))
        np.testing.assert_array_equal(graph.information(edges[1]), np.eye(6))

    def test_wrong_sigmas_are_refused(self):
        for sigma in (0, -1):
            with self.assertRaisesRegex(InvalidArgument, "expected finite standard deviations > 0"):
                se3_sigmas(sigma, 1)
        with self.assertRaisesRegex(ValueError, "rotation: expected finite"):
            se3_sigmas(1, float("nan"))
        with self.assertRaisesRegex(TypeError, "translation: expected"):
            se3_sigmas("1", 1)
        with self.assertRaises(TypeError):
            boxplus.se3_sigmas(1)


if __name__ == "__main__":
    unittest.main()
