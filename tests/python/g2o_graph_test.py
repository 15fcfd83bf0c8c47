# SPDX-License-Identifier: BSD-3-Clause
"""Graphs of the package g2o: vertices, edges, parameters, kernels and errors."""

import unittest

import boxplus
import g2o
import numpy as np
from g2o_worlds import WORLDS, optimizer_for, pose2, square


class Graphs(unittest.TestCase):
    def test_wrong_elements_are_refused(self):
        optimizer, other = square(), square()
        vertex = g2o.VertexSE2()
        with self.assertWarnsRegex(RuntimeWarning, "new id"):
            self.assertFalse(optimizer.add_vertex(vertex))  # it has no id
        vertex.set_id(2)
        with self.assertWarnsRegex(RuntimeWarning, "new id"):
            self.assertFalse(optimizer.add_vertex(vertex))  # the id is taken
        edge = g2o.EdgeSE2()
        edge.set_vertex(0, optimizer.vertex(0))
        edge.set_vertex(1, other.vertex(1))
        with self.assertWarnsRegex(RuntimeWarning, "between different vertices of this graph"):
            self.assertFalse(optimizer.add_edge(edge))
        for error, text, function in (
                (TypeError, "expected a VertexSE2 as vertex 0", lambda: edge.set_vertex(0, g2o.VertexSE3())),
                (IndexError, "expected a place from 0 to 1, got 2", lambda: edge.set_vertex(2, vertex)),
                (ValueError, r"matrix of the shape \(3, 3\)", lambda: edge.set_information(np.eye(2))),
                (ValueError, "expected 3 finite numbers, got 'x'", lambda: edge.set_measurement("x")),
                (ValueError, "expected a finite matrix", lambda: edge.set_information([[1, 2], [3]])),
                (ValueError, "symmetric", lambda: edge.set_information(np.triu(np.ones((3, 3))))),
                (TypeError, "expected a linear solver", lambda: g2o.BlockSolverX(None)),
                (TypeError, "expected a BlockSolver", lambda: g2o.OptimizationAlgorithmLevenberg(None)),
                (ValueError, "vertex 0 is not set", lambda: g2o.EdgeSE2().error()),
                (ValueError, "hessian indices", lambda: optimizer.compute_marginals([(0, 9)])),
                (ValueError, "3 finite numbers", lambda: vertex.set_estimate([1, np.nan, 2]))):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                function()

    def test_a_loop_over_the_edges_may_remove_them(self):
        optimizer = square()
        for edge in optimizer.edges():
            optimizer.remove_edge(edge)
        self.assertEqual((len(optimizer.edges()), len(optimizer.vertex(0).edges())), (0, 0))

    def test_estimates_and_measurements_can_be_set_from_their_numbers(self):
        for world in WORLDS:
            optimizer = optimizer_for(world)
            before = [edge.chi2() for edge in optimizer.edges()]
            for vertex in optimizer.vertices().values():
                self.assertTrue(vertex.set_estimate_data(vertex.get_estimate_data()))
            for edge in optimizer.edges():
                self.assertTrue(edge.set_measurement_data(edge.get_measurement_data()))
            np.testing.assert_allclose([edge.chi2() for edge in optimizer.edges()], before, rtol=1e-9)

    def test_ids_can_be_changed(self):
        optimizer = square()
        optimizer.initialize_optimization()
        optimizer.optimize(2)
        self.assertFalse(optimizer.vertex(1).set_id(2))
        vertex = optimizer.vertex(1)
        self.assertTrue(vertex.set_id(7))
        self.assertIs(optimizer.vertex(7), vertex)
        optimizer.initialize_optimization()
        self.assertGreater(optimizer.optimize(10), 0)

    def test_an_error_is_that_of_the_current_estimates(self):
        optimizer = optimizer_for("plane")
        edges = list(optimizer.edges())
        for edge in edges:
            edge.compute_error()
            single = edge._evaluate()
            np.testing.assert_allclose(edge.error(), single, atol=1e-12)
        optimizer.vertex(1).set_estimate(pose2(np.random.default_rng(5)))
        for edge in edges:
            np.testing.assert_allclose(edge.error(), edge._evaluate(), atol=1e-12)

    def test_a_missing_parameter_is_named(self):
        optimizer = optimizer_for("space")
        edge = g2o.EdgeSE3PointXYZ()
        edge.set_vertex(0, optimizer.vertex(101))
        edge.set_vertex(1, optimizer.vertex(110))
        edge.set_parameter_id(0, 77)
        optimizer.add_edge(edge)
        optimizer.initialize_optimization()
        with self.assertRaisesRegex(ValueError, "expected a ParameterSE3Offset as parameter 0, but the parameter with the id 77"):
            optimizer.optimize(1)

    def test_a_changed_parameter_takes_part(self):
        for world, id, change in (("space", 11, lambda p: p.set_offset(g2o.Isometry3d(np.eye(3), [1, 2, 3]))),
                                  ("cameras", 20, lambda p: setattr(p, "focal_length", 7.0))):
            optimizer = optimizer_for(world)
            optimizer.initialize_optimization()
            optimizer.optimize(1)
            change(optimizer.parameter(id))
            optimizer._sync()
            for edge in optimizer.edges():
                self.assertAlmostEqual(optimizer._engine.graph.chi2(optimizer._engine.refs[edge]), edge.chi2(),
                                       delta=1e-9 * (1 + edge.chi2()), msg=repr(edge))

    def test_kernels_are_those_of_boxplus(self):
        for name in ("Huber", "PseudoHuber", "Cauchy", "GemanMcClure", "Welsch", "Fair", "Tukey", "Saturated", "DCS"):
            kernel = getattr(g2o, f"RobustKernel{name}")(1.5)
            native = boxplus.make_robust_kernel(name, 1.5)
            self.assertEqual(kernel.robustify(4.0).tolist(), list(native(4.0)))
            scaled = g2o.RobustKernelScaleDelta(kernel, 2.0)
            np.testing.assert_allclose(scaled.robustify(9.0)[0], 4 * native(9.0 / 4)[0], rtol=1e-12)
        with self.assertRaisesRegex(TypeError, "written in Python are not supported"):
            type("Own", (g2o.RobustKernel,), {})()

    def test_a_kernel_with_another_width_takes_part_in_the_next_run(self):
        optimizer = square()
        kernel = g2o.RobustKernelHuber(0.1)
        for edge in optimizer.edges():
            edge.set_robust_kernel(kernel)
        optimizer.initialize_optimization()
        optimizer.optimize(50)
        narrow = optimizer.active_chi2()
        kernel.set_delta(1e3)
        optimizer.optimize(50)
        self.assertLess(optimizer.active_chi2(), narrow * (1 - 1e-6))


if __name__ == "__main__":
    unittest.main()
