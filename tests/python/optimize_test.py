# SPDX-License-Identifier: BSD-3-Clause
"""optimize(), Optimizer, options, reports, callbacks, threads and Ctrl-C."""

import os
import signal
import sys
import threading
import unittest
import unittest.mock

import boxplus
import numpy as np
from boxplus import SE2, Between, Graph, InvalidArgument, Optimizer, Options, Report, optimize
from graph_test import square


def ring(count):
    """Poses on a circle, connected to their four next neighbors by noisy edges; the estimates are at the start."""
    random = np.random.default_rng(1)
    graph = Graph()
    graph.add_vertices(SE2, np.arange(count), random.normal(size=(count, 3)) * 0.1)
    graph.fix(0)
    angle = 2 * np.pi / count
    for step in range(1, 5):
        i = np.arange(count)
        z = np.tile([step, 0, step * angle], (count, 1)) + 0.05 * random.normal(size=(count, 3))
        graph.add_edges(Between, i, (i + step) % count, measurements=z)
    return graph


class Runs(unittest.TestCase):
    def test_a_run_changes_the_estimates_and_reports(self):
        graph, _ = square()
        report = optimize(graph)
        self.assertTrue(report.converged())
        self.assertEqual(report.status, Report.Status.kConverged)
        self.assertLess(graph.chi2(), 1e-20)
        np.testing.assert_allclose(graph.estimate(2).vector(), [1, 1, np.pi], atol=1e-9)
        self.assertEqual(report.iterations, len(report.records))
        self.assertEqual((report.vertices, report.edges, report.start.used), (2, 2, boxplus.Start.kCurrent))
        self.assertEqual(report.jacobians[0].edge_type, "Between<SE2>")

    def test_a_report_is_a_table(self):
        report = optimize(square()[0])
        self.assertTrue(repr(report).startswith("converged: chi2 6.71444941"))
        self.assertEqual(str(report), repr(report))
        self.assertEqual(report._repr_html_().count("<tr>"), report.iterations + 2)

    def test_a_report_without_pandas_says_what_is_missing(self):
        report = optimize(square()[0])
        with unittest.mock.patch.dict(sys.modules, pandas=None):  # import pandas fails
            with self.assertRaisesRegex(ImportError, r"Report.to_pandas\(\) needs pandas, which cannot be imported"):
                report.to_pandas()

    def test_options_are_attributes_and_keyword_arguments(self):
        graph, _ = square()
        options = Options(algorithm="gauss-newton", max_iterations=1)
        options.threads = 1
        self.assertEqual(repr(options),
                         "Options(algorithm=<AlgorithmKind.kGaussNewton: 1>, threads=1, max_iterations=1)")
        report = optimize(graph, options, linear_solver=boxplus.LinearSolverKind.kDense, damping="identity")
        self.assertEqual((report.iterations, report.algorithm, report.linear_solver), (1, "Gauss-Newton", "dense"))
        self.assertEqual(options.linear_solver, boxplus.LinearSolverKind.kAutomatic)

    def test_wrong_options_are_refused(self):
        graph, _ = square()
        for error, text, options in (
                (TypeError, "Options: expected one of start, ", {"max_iteration": 3}),
                (TypeError, "Options.max_iterations: expected an int, got 1.5 (float)", {"max_iterations": 1.5}),
                (ValueError, "Options.threads: expected an int in the range", {"threads": 2**40}),
                (ValueError, "Options.max_factor_bytes: expected an int in the range", {"max_factor_bytes": -1}),
                (ValueError, "Options.algorithm: expected one of 'automatic', 'gauss-newton'", {"algorithm": "newton"}),
                (TypeError, "Options.start: expected one of 'current'", {"start": boxplus.AlgorithmKind.kDogleg}),
                (TypeError, "Options.cost_tolerance: expected a float, got '1' (str)", {"cost_tolerance": "1"}),
                (TypeError, "Options.numeric_jacobians: expected a bool, got 1 (int)", {"numeric_jacobians": 1}),
                (TypeError, "Options.vertices: expected a list of VertexRefs or ids, got [0.5] (list)", {"vertices": [0.5]}),
                (TypeError, "Options.vertices: expected a list of VertexRefs or ids, got 0 (int)", {"vertices": 0}),
                (InvalidArgument, "vertices: there is no vertex with the id 9", {"vertices": [9]}),
                (TypeError, "Options.callback: expected a function or None, got 3 (int)", {"callback": 3}),
                (InvalidArgument, "", {"cost_tolerance": float("nan")})):
            with self.subTest(text), self.assertRaises(error) as raised:
                optimize(graph, **options)
            self.assertIn(text, str(raised.exception))
        with self.assertRaisesRegex(TypeError, "options: expected an Options or None, got 3"):
            optimize(graph, 3)

    def test_no_graph_is_refused(self):
        for function in (optimize, Optimizer, lambda graph: boxplus.covariance(graph, [])):
            for graph in (None, 3):
                with self.assertRaises(TypeError):
                    function(graph)

    def test_only_listed_vertices_move(self):
        for listed in (lambda graph: [graph.vertex(2)], lambda graph: [2], lambda graph: np.array([2])):
            for run in (optimize, lambda graph, **options: Optimizer(graph, **options).run()):
                graph, _ = square()
                run(graph, vertices=listed(graph))
                self.assertEqual(graph.estimate(1), SE2(0.9, 0.1, 1.4))
                self.assertNotEqual(graph.estimate(2), SE2(1.2, 1.1, 3))

    def test_options_keep_vertices_as_they_were_given(self):
        graph, _ = square()
        options = boxplus.Options(vertices=[2, graph.vertex(1)])
        self.assertEqual(options.vertices, [2, graph.vertex(1)])
        self.assertEqual(boxplus.diagnose(graph, options).count("error"), 0)

    def test_an_optimizer_reuses_its_plan(self):
        graph, _ = square()
        optimizer = Optimizer(graph, max_iterations=1)
        self.assertFalse(optimizer.run().plan_reused)
        optimizer.set_options(optimizer.options, max_iterations=50)
        self.assertTrue(optimizer.run().plan_reused)
        graph.add_edge(Between(SE2(1, 0, np.pi / 2)), 2, graph.add_vertex(SE2(0, 1, -1.5)))
        self.assertFalse(optimizer.run().plan_reused)

    def test_the_number_of_threads_does_not_change_a_bit(self):
        graphs = ring(400), ring(400)
        reports = optimize(graphs[0], threads=1), optimize(graphs[1], threads=2)
        self.assertEqual(reports[0].chi2_final, reports[1].chi2_final)
        np.testing.assert_array_equal(graphs[0].estimates(SE2)[1], graphs[1].estimates(SE2)[1])


class Callbacks(unittest.TestCase):
    def test_a_callback_sees_every_iteration(self):
        graph, _ = square()
        seen = []
        report = optimize(graph, callback=lambda record: seen.append((record.iteration, record.chi2, graph.chi2())))
        self.assertEqual([chi2 for _, chi2, _ in seen], [record.chi2 for record in report.records])
        for _, chi2, of_graph in seen:
            self.assertAlmostEqual(chi2, of_graph)

    def test_a_callback_that_returns_false_stops_the_run(self):
        report = optimize(square()[0], callback=lambda record: record.iteration < 1)
        self.assertEqual((report.iterations, report.reason), (1, Report.Reason.kCallback))

    def test_an_exception_of_a_callback_stops_the_run_and_keeps_the_estimates(self):
        graph, _ = square()
        before = graph.chi2()

        def fail(_):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            optimize(graph, callback=fail)
        self.assertLess(graph.chi2(), before)
        self.assertTrue(optimize(graph).converged())

    def test_a_callback_may_set_kernels_but_not_change_the_graph(self):
        graph, edges = square()
        graph.push()
        optimize(graph, callback=lambda _: graph.set_kernel(edges, "Huber"))
        self.assertEqual(graph.kernel(edges[0]).name(), "Huber")
        graph.pop()
        for change in (lambda _: graph.set_estimate(1, SE2()), lambda _: graph.remove(1), lambda _: optimize(graph),
                       lambda _: graph.fix(1), lambda _: graph.add_vertices(SE2, None, np.zeros((1, 3)))):
            graph.push()
            with self.assertRaisesRegex(InvalidArgument, "this graph is being optimized"):
                optimize(graph, callback=change)
            graph.pop()

    def test_a_run_keeps_no_references(self):
        graph, _ = square()
        callback, flag = (lambda _: None), boxplus.StopFlag()
        before = sys.getrefcount(callback), sys.getrefcount(flag), sys.getrefcount(graph)
        for _ in range(3):
            optimize(graph, callback=callback, stop=flag)
            Optimizer(graph, callback=callback, stop=flag).run()
        self.assertEqual((sys.getrefcount(callback), sys.getrefcount(flag), sys.getrefcount(graph)), before)


class Stops(unittest.TestCase):
    def test_a_stop_flag_stops_the_run(self):
        flag = boxplus.StopFlag()
        flag.set()
        report = optimize(square()[0], stop=flag)
        self.assertEqual(report.reason, Report.Reason.kStopFlag)
        flag.clear()
        self.assertTrue(optimize(square()[0], stop=flag).converged())

    def test_ctrl_c_in_a_callback_stops_the_run_and_keeps_the_estimates(self):
        graph, _ = square()
        before = graph.chi2()
        with self.assertRaises(KeyboardInterrupt):
            optimize(graph, callback=lambda _: signal.raise_signal(signal.SIGINT))
        self.assertLess(graph.chi2(), before)

    def test_other_threads_run_meanwhile_and_ctrl_c_stops_the_run(self):
        graph = ring(20000)
        before = graph.chi2()
        seen, is_over = [], threading.Event()

        def interrupt_when_running():
            try:
                while not is_over.is_set():
                    graph.vertex_count()
            except InvalidArgument as error:  # the graph is being optimized
                seen.append(str(error))
                os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt_when_running)
        report = None
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            report = optimize(graph, threads=1, cost_tolerance=0, noise_tolerance=0, step_tolerance=0)
            is_over.set()
        self.assertIsNone(report, "the run was not interrupted")
        thread.join()
        self.assertIn("this graph is being optimized", seen[0])
        self.assertLessEqual(graph.chi2(), before)
        self.assertTrue(optimize(graph, max_iterations=1).iterations == 1)

    def test_two_threads_may_optimize_two_graphs(self):
        graphs = [ring(500), ring(500)]
        threads = [threading.Thread(target=optimize, args=(graph,)) for graph in graphs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        alone = ring(500)
        optimize(alone)
        for graph in graphs:
            np.testing.assert_array_equal(graph.estimates(SE2)[1], alone.estimates(SE2)[1])


if __name__ == "__main__":
    unittest.main()
