# SPDX-License-Identifier: BSD-3-Clause
"""Smoother and marginalize()."""

import copy
import gc
import threading
import unittest
import weakref

import boxplus
import numpy as np
from boxplus import (SE2, BatchedEdge, Between, Graph, InvalidArgument, Prior, Smoother, SmootherOptions, SmootherReport,
                     StopFlag, TangentDistance, Vector2, covariance, marginalize, optimize)

SIGMAS = np.array([0.02, 0.02, 0.01])  # meters, meters, radians
OMEGA = np.diag(1 / SIGMAS**2)


class Drive:
    """A robot on rounds of 20 poses, which recognizes the pose of the last round now and then. The first pose is fixed."""

    def __init__(self):
        self.random = np.random.default_rng(1)
        self.graph, self.truth, self.count = Graph(), [SE2()], 1
        self.graph.fix(self.graph.add_vertex(SE2()))

    def measured(self, a, b):
        return self.truth[a].inverse_times(self.truth[b]).oplus(SIGMAS * self.random.normal(size=3))

    def connect(self, a, b, measured=None):
        return self.graph.add_edge(Between(measured or self.measured(a, b)), a, b, information=OMEGA)

    def step(self, closes=True):
        k = self.count
        self.truth.append(self.truth[-1] * SE2(1, 0, 2 * np.pi / 20))
        measured = self.measured(k - 1, k)
        self.graph.add_vertex(self.graph.estimate(k - 1) * measured, id=k)
        self.connect(k - 1, k, measured)
        if closes and k >= 20 and k % 3 == 0:
            self.connect(k - 20, k)
        self.count += 1


def points(count=3):
    """Points on a line, with a prior on the first one."""
    graph = Graph()
    for x in range(count):
        graph.add_vertex([x, 0])
    graph.add_edge(Prior([0, 0]), 0)
    for i in range(1, count):
        graph.add_edge(Between([1, 0]), i - 1, i)
    return graph


def optimum(graph):
    """The estimates (n, 3) of a copy after optimize()."""
    other = copy.copy(graph)
    assert optimize(other, noise_tolerance=0).converged()
    return other.estimates(SE2)[1]


class Steps(BatchedEdge):
    """Between of points. It raises an exception if `fails`, and counts the edges for which it is called."""

    fails, edges = False, 0

    def error(self, a, b, z):
        self.edges += len(z)
        if self.fails:
            raise KeyError("mine")
        return b - a - z


class Updates(unittest.TestCase):
    def test_the_estimates_are_at_the_optimum_after_each_step(self):
        drive = Drive()
        smoother = Smoother(drive.graph)
        for _ in range(60):
            drive.step()
            self.assertTrue(smoother.update().converged())
            if drive.count % 10 == 0:
                np.testing.assert_allclose(drive.graph.estimates(SE2)[1], optimum(drive.graph), atol=0.01)
        self.assertTrue(smoother.finish().converged())
        np.testing.assert_allclose(drive.graph.estimates(SE2)[1], optimum(drive.graph), atol=1e-6)

    def test_any_edits_are_followed(self):
        drive = Drive()
        for _ in range(30):
            drive.step()
        graph, smoother = drive.graph, Smoother(drive.graph)
        smoother.update()
        closures = graph.edges(27)
        graph.remove(next(edge for edge in closures if graph.vertices(edge) == [graph.vertex(7), graph.vertex(27)]))
        graph.set_estimate(12, SE2(3, 3, 3))
        graph.set_kernel(graph.edges(24), "Huber", 1.0)
        graph.set_information(graph.edges(5)[0], 10.0)
        self.assertTrue(smoother.finish().converged())
        np.testing.assert_allclose(graph.estimates(SE2)[1], optimum(graph), atol=1e-6)

    def test_the_report_has_the_members_of_cpp(self):
        drive = Drive()
        smoother = Smoother(drive.graph)
        for _ in range(40):
            drive.step()
        report = smoother.update()
        self.assertEqual((report.reason, report.message), (SmootherReport.Reason.kConverged, ""))
        self.assertEqual((report.vertices, report.edges), (40, drive.graph.edge_count()))
        self.assertEqual((report.set_aside, report.taken_back, report.marginalized), ([], [], 0))
        self.assertEqual((report.held, report.started_over), ([], False))
        self.assertGreaterEqual(report.relinearized, report.edges)
        for name in ("iterations", "ordered", "refactored", "refactored_share", "moved", "flops", "time_s"):
            self.assertGreater(getattr(report, name), 0, name)
        self.assertIn("SmootherReport(reason=<Reason.kConverged: 0>, message='', iterations=", repr(report))
        drive.step(closes=False)
        self.assertLess(smoother.update().ordered, 20)
        self.assertEqual(boxplus.to_string(SmootherReport.Reason.kTimeLimit), "time limit")

    def test_a_report_names_the_held_vertex(self):
        graph = Graph()
        a, b = graph.add_vertex(SE2()), graph.add_vertex(SE2(1, 0, 0))
        graph.add_edge(Between(SE2(1, 0, 0)), a, b)
        (held,) = Smoother(graph).update().held
        self.assertEqual((held.vertex, held.id), (a, 0))

    def test_an_error_that_is_not_finite_is_named_and_changes_nothing(self):
        graph, factors = points(), [1.0]
        graph.add_edge(lambda p: factors[0] * (p - 3), 1)
        smoother = Smoother(graph)
        self.assertTrue(smoother.finish().converged())
        before = graph.estimates(Vector2)[1]
        factors[0] = np.nan
        graph.set_estimate(1, [7, 7])
        report = smoother.update()
        self.assertEqual((report.reason, report.converged()), (SmootherReport.Reason.kNonFinite, False))
        self.assertIn("not finite: edge of vertex", report.message)
        np.testing.assert_array_equal(graph.estimates(Vector2)[1][[0, 2]], before[[0, 2]])
        factors[0] = 1.0
        self.assertTrue(smoother.finish().converged())
        np.testing.assert_allclose(graph.estimates(Vector2)[1], before, atol=1e-9)

    def test_a_stop_flag_and_a_time_limit_stop_an_update(self):
        drive = Drive()
        for _ in range(30):
            drive.step()
        flag = StopFlag()
        smoother = Smoother(drive.graph, stop=flag)
        flag.set()
        self.assertEqual(smoother.update().reason, SmootherReport.Reason.kStopFlag)
        flag.clear()
        self.assertTrue(smoother.update().converged())

    def test_false_closures_are_set_aside(self):
        drive = Drive()
        smoother = Smoother(drive.graph, sets_outliers_aside=True)
        for _ in range(60):
            drive.step()
            smoother.update()
        self.assertEqual(smoother.set_aside(), [])
        false = drive.connect(3, 60, SE2(5, 5, 1))
        self.assertEqual(smoother.update().set_aside, [false])
        self.assertEqual(smoother.set_aside(), [false])


class Lag(unittest.TestCase):
    def test_a_fixed_lag_keeps_the_number_of_vertices(self):
        drive = Drive()
        drive.graph.unfix(0)
        drive.graph.add_edge(Prior(SE2()), 0, information=OMEGA)
        smoother = Smoother(drive.graph, lag=10)
        marginalized = 0
        for _ in range(50):
            drive.step(closes=False)
            report = smoother.update()
            self.assertTrue(report.converged())
            marginalized += report.marginalized
            self.assertLessEqual(drive.graph.vertex_count(), 10)
        self.assertEqual(marginalized, 41)
        self.assertEqual(sorted(drive.graph.id(v) for v in drive.graph.all_vertices()), list(range(41, 51)))

    def test_times_say_which_vertices_leave(self):
        graph = points(6)
        smoother = Smoother(graph, lag_s=2.5)
        for i in range(6):
            smoother.set_time(i, float(i))
        self.assertEqual(smoother.update().marginalized, 3)
        self.assertEqual(sorted(graph.id(vertex) for vertex in graph.all_vertices()), [3, 4, 5])

    def test_marginalize_keeps_the_optimum_and_the_covariance(self):
        drive = Drive()
        for _ in range(30):
            drive.step()
        graph = drive.graph
        optimize(graph, noise_tolerance=0)
        before, sigma = graph.estimate(30), covariance(graph, [30]).of(30)
        prior = marginalize(graph, [5, graph.vertex(6)])
        self.assertTrue(graph.contains(prior))
        self.assertIsNone(graph.find_vertex(5))
        self.assertEqual(graph.vertices(prior), [graph.vertex(i) for i in sorted(graph.id(v) for v in graph.vertices(prior))])
        optimize(graph, noise_tolerance=0)
        np.testing.assert_allclose(graph.estimate(30).ominus(before), 0, atol=1e-6)
        np.testing.assert_allclose(covariance(graph, [30]).of(30), sigma, rtol=1e-5, atol=1e-12)

    def test_marginalize_without_neighbors_returns_none(self):
        graph = Graph()
        graph.add_vertex([0, 0])
        graph.add_edge(Prior([0, 0]), 0)
        self.assertIsNone(marginalize(graph, [0]))
        self.assertEqual((graph.vertex_count(), graph.edge_count()), (0, 0))

    def test_a_vertex_with_an_error_function_can_be_marginalized(self):
        native, own = points(4), Graph()
        own.add_vertices(Vector2, None, native.estimates(Vector2)[1])
        own.add_edge(Prior([0, 0]), 0)
        own.add_edges(Steps(), [0, 1, 2], [1, 2, 3], measurements=[[1, 0]] * 3)
        for graph in (native, own):
            self.assertIsNotNone(marginalize(graph, [1]))
        np.testing.assert_allclose(covariance(own, [3]).of(3), covariance(native, [3]).of(3), atol=1e-12)

    def test_wrong_vertices_are_refused(self):
        graph = points()
        graph.fix(0)
        for error, text, vertices in ((InvalidArgument, "fixed", [0]), (InvalidArgument, "there is no vertex", [9]),
                                      (TypeError, "vertices: expected a list", 1)):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                marginalize(graph, vertices)
        self.assertEqual(graph.vertex_count(), 3)


class Queries(unittest.TestCase):
    def test_the_covariance_is_that_of_a_batch(self):
        drive = Drive()
        smoother = Smoother(drive.graph)
        for _ in range(50):
            drive.step()
            smoother.update()
        smoother.finish()
        expected = covariance(drive.graph, [50, 3]).joint()
        np.testing.assert_allclose(smoother.covariance([50, drive.graph.vertex(3)]), expected, atol=1e-7)
        fixed = smoother.covariance([0, 50])
        np.testing.assert_array_equal(fixed[:3], 0)
        np.testing.assert_allclose(fixed[3:, 3:], expected[:3, :3], atol=1e-7)

    def test_a_preview_says_what_an_edge_would_change(self):
        graph = points()
        smoother = Smoother(graph)
        smoother.update()
        edge = graph.add_edge(Between([2.5, 0]), 0, 2)
        graph.set_enabled(edge, False)
        preview = smoother.preview(edge)
        self.assertAlmostEqual(preview.chi2, 0.25)
        self.assertAlmostEqual(preview.chi2_increase, 0.25 / 3)
        self.assertEqual(preview.rows, 2)
        np.testing.assert_allclose(preview.steps, [[0, 0], [1 / 3, 0]], atol=1e-9)
        self.assertIn("EdgePreview(chi2=0.25, chi2_increase=0.083", repr(preview))
        graph.set_enabled(edge, True)
        smoother.finish()
        np.testing.assert_allclose(graph.estimate(2), [2 + 1 / 3, 0], atol=1e-9)
        self.assertAlmostEqual(graph.chi2(), preview.chi2_increase)

    def test_queries_before_an_update_and_of_wrong_elements_are_refused(self):
        graph = points()
        smoother = Smoother(graph)
        with self.assertRaisesRegex(InvalidArgument, "expected a successful update before"):
            smoother.covariance([0])
        smoother.update()
        removed = graph.edges(2)[0]
        graph.remove(removed)
        for error, function in ((InvalidArgument, lambda: smoother.covariance([7])),
                                (TypeError, lambda: smoother.covariance(0)),
                                (InvalidArgument, lambda: smoother.preview(removed)),
                                (TypeError, lambda: smoother.preview(None)),
                                (TypeError, lambda: smoother.set_time(0, "now")),
                                (ValueError, lambda: smoother.set_time(0, float("nan"))),
                                (InvalidArgument, lambda: smoother.set_time(7, 0))):
            with self.assertRaises(error):
                function()


class Options(unittest.TestCase):
    def test_options_are_keyword_arguments_or_an_object(self):
        options = SmootherOptions(max_iterations=3, relinearize=TangentDistance(0.2, 0.1, 0.1))
        smoother = Smoother(points(), options, false_alarm=1e-3)
        self.assertEqual((smoother.options.max_iterations, smoother.options.false_alarm), (3, 1e-3))
        self.assertEqual(smoother.options.relinearize, TangentDistance(length=0.2, angle=0.1, other=0.1))
        self.assertEqual(options.false_alarm, SmootherOptions().false_alarm)
        smoother.set_options(smoother.options, lag=5)
        self.assertEqual((smoother.options.lag, smoother.options.max_iterations), (5, 3))
        smoother.set_options(lag=None)
        self.assertEqual((smoother.options.lag, smoother.options.max_iterations), (None, 20))
        self.assertEqual(smoother.options.lag_s, float("inf"))
        self.assertEqual(repr(SmootherOptions()), "SmootherOptions()")
        self.assertEqual(repr(copy.copy(options)), "SmootherOptions(relinearize=TangentDistance(length=0.2, angle=0.1, "
                                                   "other=0.1), max_iterations=3)")

    def test_wrong_options_are_refused(self):
        for error, text, options in (
                (TypeError, "SmootherOptions: expected one of relinearize, noticeable, .*, lag, stop, got 'lags'", {"lags": 3}),
                (TypeError, "SmootherOptions.lag: expected an int", {"lag": 2.5}),
                (ValueError, "SmootherOptions.lag: expected an int in the range", {"lag": -1}),
                (TypeError, "SmootherOptions.relinearize: expected a TangentDistance, got 0.1", {"relinearize": 0.1}),
                (TypeError, "SmootherOptions.numeric_jacobians: expected a bool", {"numeric_jacobians": 1}),
                (TypeError, "options: expected a SmootherOptions or None", {"options": boxplus.Options()})):
            with self.subTest(text), self.assertRaisesRegex(error, text):
                Smoother(points(), **options)
        with self.assertRaises(TypeError):
            Smoother(None)


class ErrorFunctions(unittest.TestCase):
    def line(self, count=100):
        graph, function = Graph(), Steps()
        graph.add_vertices(Vector2, None, np.zeros((count, 2)))
        graph.add_edge(Prior([0, 0]), 0)
        graph.add_edges(function, np.arange(count - 1), np.arange(1, count), measurements=[[1, 0]] * (count - 1))
        return graph, function

    def test_an_exception_leaves_the_estimates_and_the_next_update_works(self):
        graph, function = self.line()
        smoother = Smoother(graph)
        smoother.finish()
        before = graph.estimates(Vector2)[1]
        np.testing.assert_allclose(before[:, 0], np.arange(100), atol=1e-9)
        function.fails = True
        graph.add_edge(Prior([5, 0]), 0)
        graph.add_edges(function, [0], [50], measurements=[[49, 0]])
        for run in (smoother.update, smoother.finish):
            with self.assertRaisesRegex(KeyError, "mine"):
                run()
            np.testing.assert_array_equal(graph.estimates(Vector2)[1], before)
            with self.assertRaisesRegex(InvalidArgument, "expected a successful update before"):
                smoother.covariance([0])
        function.fails = False
        self.assertTrue(smoother.finish().converged())
        np.testing.assert_allclose(graph.estimate(0), [2.5, 0], atol=1e-9)

    def test_they_are_called_only_for_the_edges_that_an_update_needs(self):
        graph, function = self.line()
        smoother = Smoother(graph)
        smoother.update()
        function.edges = 0
        graph.add_vertex([100, 0], id=100)
        graph.add_edges(function, [99], [100], measurements=[[1, 0]])
        function.edges = 0
        report = smoother.update()
        self.assertLess(report.relinearized, 10)
        self.assertLessEqual(function.edges, 4 * report.relinearized)  # more than once, for the derivatives

    def test_other_threads_cannot_use_the_graph_during_an_update(self):
        begun, go_on = threading.Event(), threading.Event()

        def wait(p):
            if threading.current_thread() is not threading.main_thread():
                begun.set()
                go_on.wait(30)
            return p - 1

        graph = points()
        graph.add_edge(wait, 0)
        smoother, reports = Smoother(graph), []
        thread = threading.Thread(target=lambda: reports.append(smoother.update()))
        thread.start()
        begun.wait(30)
        for function in (graph.vertex_count, smoother.set_aside, smoother.update, lambda: smoother.covariance([0])):
            with self.assertRaisesRegex(InvalidArgument, "this graph is being optimized"):
                function()
        go_on.set()
        thread.join()
        self.assertTrue(reports[0].converged())
        self.assertIsNone(smoother.options.stop)


class Lifetimes(unittest.TestCase):
    def test_a_graph_has_one_smoother_which_keeps_it_alive(self):
        graph = points()
        smoother = Smoother(graph)
        with self.assertRaisesRegex(InvalidArgument, "the graph has a Smoother already"):
            Smoother(graph)
        reference = weakref.ref(graph)
        del graph
        gc.collect()
        self.assertTrue(smoother.update().converged())
        self.assertIsNotNone(reference())
        again = reference()
        del smoother
        self.assertTrue(Smoother(again).update().converged())
        del again
        gc.collect()
        self.assertIsNone(reference())

    def test_a_smoother_may_go_while_its_graph_is_optimized(self):
        graph = points()
        graph.set_estimate(2, [7, 7])
        smoothers = [Smoother(graph)]
        smoothers[0].update()
        graph.set_estimate(2, [7, 7])

        def forget(_):
            smoothers.clear()

        self.assertTrue(optimize(graph, callback=forget).converged())
        self.assertEqual(smoothers, [])
        self.assertTrue(Smoother(graph).update().converged())

    def test_a_cycle_through_an_error_function_is_collected(self):
        class Function:
            def __call__(self, p):
                return p

        graph, function = points(), Function()
        graph.add_edge(function, 0)
        function.smoother = Smoother(graph)
        function.smoother.update()
        reference = weakref.ref(function)
        del graph, function
        gc.collect()
        self.assertIsNone(reference())

    def test_a_smoother_continues_after_optimize(self):
        drive = Drive()
        smoother = Smoother(drive.graph)
        for _ in range(25):
            drive.step()
            smoother.update()
        optimize(drive.graph)
        drive.step()
        self.assertTrue(smoother.finish().converged())
        np.testing.assert_allclose(drive.graph.estimates(SE2)[1], optimum(drive.graph), atol=1e-6)


if __name__ == "__main__":
    unittest.main()
