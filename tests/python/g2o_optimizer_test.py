# SPDX-License-Identifier: BSD-3-Clause
"""SparseOptimizer of the package g2o: it ends at the minimum of boxplus, and its methods do what those of g2o do."""

import contextlib
import io
import pathlib
import tempfile
import threading
import unittest

import boxplus
import g2o
import numpy as np
from g2o._groups import GroupWithJacobians
from g2o_worlds import WORLDS, add, join, optimizer_for, square


class OwnPose(g2o.VertexSE2):
    """A pose whose steps are computed in Python, so that its runs are of one iteration each."""

    def oplus_impl(self, step):
        self.set_estimate(self.estimate() * g2o.SE2(*step))


class Optimize(unittest.TestCase):
    def native(self, optimizer):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "graph.g2o"
            optimizer.save(str(path))
            return boxplus.load(path)

    def test_every_type_ends_at_the_minimum_of_boxplus(self):
        for world in WORLDS:
            with self.subTest(world):
                optimizer = optimizer_for(world)
                graph = self.native(optimizer)
                report = boxplus.optimize(graph, cost_tolerance=1e-14, max_iterations=500)
                optimizer.initialize_optimization()
                before = optimizer.active_chi2()
                self.assertGreater(optimizer.optimize(300), 0)
                self.assertLess(optimizer.active_chi2(), before)
                self.assertAlmostEqual(optimizer.active_chi2() / report.chi2_final, 1, delta=1e-5, msg=report.message)

    def test_the_errors_of_the_engine_are_those_of_the_edges(self):
        for world in WORLDS:
            optimizer = optimizer_for(world)
            optimizer.initialize_optimization()
            optimizer._sync()
            graph = optimizer._engine.graph
            for edge in optimizer.edges():
                self.assertAlmostEqual(graph.chi2(optimizer._engine.refs[edge]), edge.chi2(), delta=1e-9 * (1 + edge.chi2()),
                                       msg=repr(edge))

    def test_given_jacobians_are_derivatives(self):
        optimizer = optimizer_for("cameras")
        optimizer.initialize_optimization()
        optimizer._sync()
        graph, groups = optimizer._engine.graph, optimizer._engine._groups.values()
        given = [group for group in groups if isinstance(group, GroupWithJacobians)]
        self.assertEqual(len(given), 6)
        for group in given:
            edge = group.edge(0)
            for block, vertex in zip(graph.jacobian(optimizer._engine.refs[edge]), edge.vertices()):
                tangent = np.eye(vertex.dimension()) if vertex._tangent() is None else vertex._tangent()
                for k in range(vertex.dimension()):
                    ends = []
                    for sign in (1, -1):
                        vertex.push()
                        vertex.oplus(sign * 1e-6 * np.eye(vertex.dimension())[k])
                        ends.append(edge.error())
                        vertex.pop()
                    np.testing.assert_allclose((block @ tangent)[:, k], (ends[0] - ends[1]) / 2e-6, atol=1e-7)

    def test_a_fixed_scale_stays_as_it_is(self):
        optimizer = optimizer_for("similarities")
        free = optimizer.vertex(301)
        for is_fixed in (True, False):
            free.set_fix_scale(is_fixed)
            optimizer.initialize_optimization()
            before = optimizer.active_chi2(), free.estimate().scale()
            optimizer.optimize(20)
            self.assertLess(optimizer.active_chi2(), before[0])
            self.assertEqual(free.estimate().scale() == before[1], is_fixed)

    def test_algorithms_and_linear_solvers_end_at_the_same_minimum(self):
        ends = []
        for algorithm in (g2o.OptimizationAlgorithmGaussNewton, g2o.OptimizationAlgorithmLevenberg,
                          g2o.OptimizationAlgorithmDogleg):
            for solver in (g2o.LinearSolverDenseSE2, g2o.LinearSolverEigenSE2, g2o.LinearSolverCSparseSE2,
                           g2o.LinearSolverPCGSE2):
                optimizer = square()
                optimizer.set_algorithm(algorithm(g2o.BlockSolverSE2(solver())))
                optimizer.initialize_optimization()
                optimizer.optimize(30)
                ends.append(optimizer.chi2())
        np.testing.assert_allclose(ends, ends[0], rtol=1e-6)

    def test_optimize_returns_the_number_of_iterations(self):
        optimizer = square()
        with self.assertWarnsRegex(RuntimeWarning, "initialize_optimization"):
            self.assertEqual(optimizer.optimize(5), -1)
        optimizer.initialize_optimization()
        self.assertEqual(optimizer.optimize(2), 2)
        self.assertEqual(optimizer.optimize(0), 0)
        optimizer.set_algorithm(None)
        with self.assertWarnsRegex(RuntimeWarning, "set_algorithm"):
            self.assertEqual(optimizer.optimize(5), -1)

    def test_optimize_of_an_optimal_graph_returns_what_g2o_returns(self):
        for in_steps in (False, True):
            for algorithm, expected in ((g2o.OptimizationAlgorithmGaussNewton, 10), (g2o.OptimizationAlgorithmLevenberg, 1),
                                        (g2o.OptimizationAlgorithmDogleg, 1)):
                optimizer = g2o.SparseOptimizer()
                optimizer.set_algorithm(algorithm(g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())))
                seen = []
                optimizer.add_post_iteration_action(lambda _, iteration: seen.append(iteration))
                for i in range(3):
                    vertex = (OwnPose if in_steps else g2o.VertexSE2)()
                    vertex.set_id(i)
                    vertex.set_estimate(g2o.SE2(0.5 * i, 0, 0))
                    vertex.set_fixed(i == 0)
                    optimizer.add_vertex(vertex)
                for i in range(2):
                    edge = g2o.EdgeSE2()
                    edge.set_vertex(0, optimizer.vertex(i))
                    edge.set_vertex(1, optimizer.vertex(i + 1))
                    edge.set_measurement(g2o.SE2(0.5, 0, 0))
                    edge.set_information(np.eye(3))
                    optimizer.add_edge(edge)
                optimizer.initialize_optimization()
                with self.subTest(algorithm.__name__, in_steps=in_steps):
                    self.assertEqual(optimizer.optimize(10), expected)
                    self.assertEqual(seen, list(range(expected)))
                    self.assertEqual(optimizer.optimize(0), 0)
                    self.assertEqual(optimizer.vertex(2).estimate().to_vector().tolist(), [1, 0, 0])

    def test_an_action_ends_the_iterations_that_find_no_step(self):
        optimizer = square()
        optimizer.set_algorithm(g2o.OptimizationAlgorithmGaussNewton(g2o.BlockSolverSE2(g2o.LinearSolverEigenSE2())))
        optimizer.initialize_optimization()
        self.assertEqual(optimizer.optimize(30), 30)
        optimizer.add_post_iteration_action(lambda _, iteration: iteration < 3)
        self.assertEqual(optimizer.optimize(30), 4)

    def test_changes_between_runs_take_part(self):
        optimizer = square()
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        free = optimizer.chi2()
        optimizer.vertex(2).set_estimate(g2o.SE2(1, 1, 3))
        optimizer.vertex(2).set_fixed(True)
        edge = next(iter(optimizer.edges()))
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        self.assertEqual(optimizer.vertex(2).estimate().to_vector().tolist(), [1, 1, 3])
        self.assertGreater(optimizer.chi2(), free)
        optimizer.vertex(2).set_fixed(False)
        edge.set_measurement(edge.vertex(0).estimate().inverse() * edge.vertex(1).estimate())
        edge.set_information(1e6 * np.eye(3))
        edge.set_robust_kernel(g2o.RobustKernelHuber(1))
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        self.assertLess(edge.chi2(), 1)
        native = self.native(optimizer)  # a fresh start at these estimates is at the same minimum
        native.set_kernel(native.all_edges()[0], "Huber", 1)
        self.assertAlmostEqual(native.chi2(), optimizer.active_robust_chi2(), delta=1e-9)
        boxplus.optimize(native)
        self.assertAlmostEqual(native.chi2(), optimizer.active_robust_chi2(), delta=1e-6)

    def test_vertices_and_edges_can_be_added_after_a_run(self):
        optimizer = square()
        optimizer.initialize_optimization()
        optimizer.optimize(10)
        late = add(optimizer, g2o.VertexSE2, 9, g2o.SE2(5, 5, 1))
        edge = join(optimizer, g2o.EdgeSE2, [optimizer.vertex(1), late], g2o.SE2(1, 0, 0), np.random.default_rng(1))
        optimizer.optimize(10)
        self.assertGreater(edge.chi2(), 1)  # it takes part after the next initialize_optimization()
        optimizer.update_initialization([late], [edge])
        optimizer.optimize(10)
        self.assertLess(edge.chi2(), 1e-9)

    def test_only_the_chosen_level_vertices_or_edges_take_part(self):
        for choose in ("level", "vertices", "edges"):
            optimizer = square()
            edges = list(optimizer.edges())
            edges[1].set_level(1)
            elements = {"level": 0, "vertices": [optimizer.vertex(i) for i in (0, 1)], "edges": edges[:1]}[choose]
            self.assertTrue(optimizer.initialize_optimization(elements))
            expected = {"level": [0, 2, 3], "vertices": [0], "edges": [0]}[choose]
            self.assertEqual(optimizer.active_edges(), [edges[i] for i in expected])
            before = optimizer.vertex(2).estimate().to_vector()
            optimizer.optimize(20)
            self.assertLess(edges[0].chi2(), 1e-9)
            if choose != "level":
                self.assertEqual(optimizer.vertex(2).estimate().to_vector().tolist(), before.tolist())
        self.assertFalse(optimizer.initialize_optimization(7))

    def test_a_removed_edge_or_vertex_takes_no_part(self):
        optimizer = square()
        optimizer.initialize_optimization()
        optimizer.optimize(10)
        edges = list(optimizer.edges())
        self.assertTrue(optimizer.remove_edge(edges[3]))
        self.assertFalse(optimizer.remove_edge(edges[3]))
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        self.assertLess(optimizer.chi2(), 1e-12)  # without the loop closure
        self.assertTrue(optimizer.remove_vertex(optimizer.vertex(2)))
        self.assertEqual((list(optimizer.vertices()), list(optimizer.edges())), ([0, 1, 3], edges[:1]))
        optimizer.clear()
        self.assertEqual((len(optimizer.vertices()), len(optimizer.edges()), edges[0].graph()), (0, 0, None))

    def test_marginals_are_the_covariances_of_the_steps_of_g2o(self):
        optimizer = optimizer_for("cameras")
        join(optimizer, g2o.EdgeXYZPrior, [optimizer.vertex(220)], [0.1, -0.2, 0.25], np.random.default_rng(2))
        optimizer.initialize_optimization()
        optimizer.optimize(50)
        order = optimizer.index_mapping()
        H = np.zeros((sum(vertex.dimension() for vertex in order),) * 2)
        first = np.cumsum([0] + [vertex.dimension() for vertex in order])
        for edge in optimizer.active_edges():  # numeric Jacobians by oplus()
            J = np.zeros((edge.dimension(), len(H)))
            for vertex in edge.vertices():
                for k in range(vertex.dimension() if not vertex.fixed() else 0):
                    step = 1e-6 * np.eye(vertex.dimension())[k]
                    ends = []
                    for sign in (1, -1):
                        vertex.push()
                        vertex.oplus(sign * step)
                        ends.append(edge.error())
                        vertex.pop()
                    J[:, first[vertex.hessian_index()] + k] = (ends[0] - ends[1]) / 2e-6
            H += J.T @ edge.information() @ J
        expected = np.linalg.inv(H)
        pairs = [(i, j) for i in range(len(order)) for j in range(i, len(order))]
        ok, found = optimizer.compute_marginals(pairs)
        self.assertTrue(ok)
        for i, j in pairs:
            block = expected[first[i]:first[i + 1], first[j]:first[j + 1]]
            tolerance = 1e-4 * np.sqrt(np.abs(expected).max() * np.abs(block).max())
            np.testing.assert_allclose(found.block(i, j), block, atol=tolerance)
            np.testing.assert_array_equal(found.block(j, i), found.block(i, j).T if i != j else found.block(i, j))

    def test_marginals_of_a_free_graph_fail_with_a_warning(self):
        optimizer = square()
        optimizer.vertex(0).set_fixed(False)
        optimizer.initialize_optimization()
        with self.assertWarnsRegex(RuntimeWarning, "compute_marginals"):
            self.assertFalse(optimizer.compute_marginals(optimizer.vertex(1))[0])

    def test_without_a_fixed_vertex_every_vertex_moves(self):
        optimizer = square()
        optimizer.vertex(0).set_fixed(False)
        self.assertTrue(optimizer.gauge_freedom())
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        self.assertNotEqual(optimizer.vertex(0).estimate().to_vector().tolist(), [0, 0, 0])
        fixed = square()
        fixed.initialize_optimization()
        fixed.optimize(20)
        self.assertAlmostEqual(optimizer.chi2(), fixed.chi2(), delta=1e-6 * fixed.chi2())

    def test_the_initial_guess_follows_the_edges(self):
        optimizer = square()
        optimizer.initialize_optimization()
        optimizer.compute_initial_guess()
        self.assertLess(list(optimizer.edges())[0].chi2(), 1e-12)

    def test_estimates_can_be_pushed(self):
        optimizer = square()
        before = {id: vertex.estimate().to_vector().tolist() for id, vertex in optimizer.vertices().items()}
        optimizer.push()
        optimizer.initialize_optimization()
        optimizer.optimize(5)
        optimizer.pop()
        self.assertEqual({id: vertex.estimate().to_vector().tolist() for id, vertex in optimizer.vertices().items()}, before)


class Actions(unittest.TestCase):
    def test_verbose_writes_a_line_per_iteration(self):
        optimizer = square()
        optimizer.set_verbose(True)
        optimizer.initialize_optimization()
        out = io.StringIO()
        with contextlib.redirect_stderr(out):
            count = optimizer.optimize(3)
        lines = out.getvalue().splitlines()
        self.assertEqual(len(lines), count)
        self.assertRegex(lines[1], r"^iteration= 1\t chi2= [\d.]+\t time= .*\t cumTime= .*\t edges= 4\t schur= 0\t lambda= ")

    def test_actions_see_the_estimates_and_may_stop_the_run(self):
        optimizer = square()
        optimizer.initialize_optimization()
        seen = []

        def action(optimizer, iteration):
            seen.append(optimizer.active_chi2())
            return iteration < 1

        optimizer.add_post_iteration_action(action)
        self.assertEqual(optimizer.optimize(20), 2)
        self.assertEqual(seen[-1], optimizer.active_chi2())
        self.assertTrue(optimizer.remove_post_iteration_action(action))
        self.assertFalse(optimizer.remove_post_iteration_action(action))

    def test_an_exception_of_an_action_ends_the_run_with_the_best_estimates(self):
        optimizer = square()
        optimizer.initialize_optimization()
        before = optimizer.active_chi2()

        def action(optimizer, iteration):
            raise KeyError("lost")

        optimizer.add_post_iteration_action(action)
        with self.assertRaisesRegex(KeyError, "lost"):
            optimizer.optimize(20)
        self.assertLess(optimizer.active_chi2(), before)

    def test_the_terminate_action_stops_at_small_gains(self):
        optimizer = square()
        optimizer.initialize_optimization()
        action = g2o.SparseOptimizerTerminateAction()
        action.set_gain_threshold(0.5)
        optimizer.add_post_iteration_action(action)
        self.assertLess(optimizer.optimize(20), 6)

    def test_a_flag_that_is_set_stops_the_run_before_its_first_iteration(self):
        for flag in (g2o.Flag(True), threading.Event()):
            optimizer = square()
            if not isinstance(flag, g2o.Flag):
                flag.set()
            optimizer.set_force_stop_flag(flag)
            optimizer.initialize_optimization()
            self.assertEqual(optimizer.optimize(20), 0)


if __name__ == "__main__":
    unittest.main()
