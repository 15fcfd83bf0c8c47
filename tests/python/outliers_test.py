# SPDX-License-Identifier: BSD-3-Clause
"""find_outliers()."""

import os
import signal
import sys
import threading
import unittest

import boxplus
import numpy as np
from boxplus import SE2, Between, Graph, InvalidArgument, Prior, Report, StopFlag, Verdict, find_outliers

SIGMAS = np.array([0.02, 0.02, 0.002])  # meters, meters, radians


def relative(a, b):
    """The poses b (n, 3) relative to the poses a."""
    d, c, s = b - a, np.cos(a[:, 2]), np.sin(a[:, 2])
    return np.c_[c * d[:, 0] + s * d[:, 1], c * d[:, 1] - s * d[:, 0], d[:, 2]]


def rounds(count):
    """Poses on rounds of 100 poses of a circle, with a closure from every pose to the next round. Returns the graph,
    the closures, and which of them are false."""
    random = np.random.default_rng(1)
    angles = np.arange(count) * (2 * np.pi / 100)
    truth = np.c_[10 * np.sin(angles), 10 - 10 * np.cos(angles), angles]
    early = np.arange(count - 100)
    is_false = early % 9 == 4
    graph = Graph()
    graph.add_vertices(SE2, None, truth)
    graph.fix(0)
    omega = np.diag(1 / SIGMAS**2)
    for i, j, false in ((np.arange(count - 1), np.arange(1, count), False), (early, early + 100, is_false)):
        z = relative(truth[i], truth[j]) + SIGMAS * random.normal(size=(len(i), 3))
        z[false] += random.normal(size=z[false].shape) * [5, 5, 1]
        edges = graph.add_edges(Between, i, j, measurements=z, informations=omega)
    return graph, edges, is_false


class FindOutliers(unittest.TestCase):
    def test_any_edge_may_be_a_suspect(self):
        graph = Graph()
        graph.add_vertex([0.0, 0.0])
        edges = [graph.add_edge(Prior([0.01 * k, 0]), 0, information=1e4) for k in range(8)]
        false = graph.add_edge(Prior([7, 7]), 0, information=1e4)
        found = find_outliers(graph, suspects="all")
        self.assertEqual(found.edges("outlier"), [false])
        self.assertEqual(found.edges(Verdict.kInlier), edges)
        self.assertEqual(found.suspects, boxplus.Suspects.kAll)
        with self.assertRaisesRegex(ValueError, "loop-closures"):
            find_outliers(graph, suspects="some")

    def test_false_closures_are_outliers(self):
        graph, closures, is_false = rounds(250)
        found = find_outliers(graph)
        self.assertTrue(found.report.converged())
        self.assertEqual(found.edges("outlier"), [edge for edge, false in zip(closures, is_false) if false])
        self.assertEqual(found.count("outlier"), is_false.sum())
        self.assertEqual(found.count(Verdict.kInlier), (~is_false).sum())
        self.assertEqual([verdict.edge for verdict in found.verdicts], closures)
        self.assertAlmostEqual(found.noise_scale, 1, delta=0.5)
        self.assertEqual(found.note, "")
        self.assertIn(f"OutlierReport(inlier={(~is_false).sum()}, outlier={is_false.sum()}, undecided=0, ", repr(found))
        self.assertEqual(boxplus.to_string(Verdict.kOutlier), "outlier")

    def test_the_verdicts_are_arrays(self):
        graph, closures, is_false = rounds(250)
        found = find_outliers(graph)
        arrays = found.arrays()
        self.assertEqual(list(arrays), ["from", "to", "verdict", "weight", "chi2", "supported"])
        np.testing.assert_array_equal(arrays["from"], np.arange(150))
        np.testing.assert_array_equal(arrays["to"], np.arange(100, 250))
        np.testing.assert_array_equal(arrays["verdict"] == "outlier", is_false)
        np.testing.assert_array_equal(arrays["verdict"] == "inlier", ~is_false)
        np.testing.assert_array_equal(arrays["weight"], np.where(is_false, 0, 1))
        np.testing.assert_allclose(arrays["chi2"], [graph.chi2(edge) for edge in closures])
        self.assertEqual(arrays["supported"].dtype, bool)
        one = found.verdicts[7]
        self.assertEqual((one.from_, one.to, one.weight, one.chi2, one.supported),
                         tuple(arrays[name][7] for name in ("from", "to", "weight", "chi2", "supported")))

    def test_a_graph_without_closures_has_empty_arrays(self):
        graph = Graph()
        graph.add_vertices(SE2, None, np.zeros((2, 3)))
        graph.fix(0)
        graph.add_edge(Between(SE2(1, 0, 0)), 0, 1)
        found = find_outliers(graph)
        self.assertEqual([len(array) for array in found.arrays().values()], [0] * 6)
        self.assertEqual(found.edges("outlier"), [])

    def test_wrong_options_are_refused(self):
        graph, _, _ = rounds(120)
        for error, text, options in (
                (InvalidArgument, "false_alarm", {"false_alarm": 2}),
                (InvalidArgument, "evidence", {"evidence": 0}),
                (InvalidArgument, "window: expected at least 1, got 0", {"window": 0}),
                (InvalidArgument, "expected no `vertices`", {"vertices": [graph.vertex(1)]}),
                (TypeError, "window: expected an int, got 1.5", {"window": 1.5}),
                (ValueError, "window: expected an int of 32 bits", {"window": 2**40}),
                (TypeError, "evidence: expected", {"evidence": "9"}),
                (TypeError, "Options: expected one of start", {"windows": 3})):
            with self.subTest(text), self.assertRaises(error) as raised:
                find_outliers(graph, **options)
            self.assertIn(text, str(raised.exception))
        with self.assertRaises(TypeError):
            find_outliers(None)
        with self.assertRaisesRegex(ValueError, "verdict: expected one of 'inlier', 'outlier', 'undecided', got 'bad'"):
            find_outliers(graph).count("bad")


def slow(graph):
    """The graph with a landmark that converges so slowly that iterations remain for the final run."""
    landmark = graph.add_vertex([0, 0])
    priors = [graph.add_edge(Prior([x, 0]), landmark) for x in (0, 1.9)]
    graph.set_kernel(priors, "Cauchy", 1.0)
    return graph


class Callbacks(unittest.TestCase):
    def test_the_calling_thread_calls_the_callback_in_the_final_run(self):
        graph = slow(rounds(250)[0])
        seen = []

        def watch(record):
            seen.append((record.iteration, threading.get_ident(), graph.edge_count()))

        found = find_outliers(graph, callback=watch)
        self.assertGreater(len(seen), 0)
        self.assertEqual(seen, [(record.iteration, threading.get_ident(), graph.edge_count())
                                for record in found.report.records])

    def test_an_exception_of_a_callback_stops_the_run(self):
        graph = slow(rounds(250)[0])

        def fail(_):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            find_outliers(graph, callback=fail)
        self.assertTrue(find_outliers(graph).report.converged())

    def test_a_callback_that_returns_false_stops_the_final_run(self):
        found = find_outliers(slow(rounds(250)[0]), callback=lambda _: False)
        self.assertEqual((found.report.iterations, found.report.reason), (1, Report.Reason.kCallback))

    def test_a_run_keeps_no_references(self):
        graph, callback, flag = slow(rounds(120)[0]), (lambda _: None), StopFlag()
        before = sys.getrefcount(callback), sys.getrefcount(flag), sys.getrefcount(graph)
        for _ in range(3):
            find_outliers(graph, callback=callback, stop=flag)
        self.assertEqual((sys.getrefcount(callback), sys.getrefcount(flag), sys.getrefcount(graph)), before)


class Stops(unittest.TestCase):
    def test_a_stop_flag_stops_the_search(self):
        graph, closures, _ = rounds(250)
        flag = StopFlag()
        flag.set()
        found = find_outliers(graph, stop=flag)
        self.assertEqual(found.count("undecided"), len(closures))
        self.assertEqual(found.report.reason, Report.Reason.kStopFlag)
        self.assertIn("the search was stopped", found.note)

    def test_other_threads_run_meanwhile_and_ctrl_c_stops_the_search(self):
        graph, _, _ = rounds(20000)
        seen, is_over, records = [], threading.Event(), []

        def interrupt_when_running():
            try:
                while not is_over.is_set():
                    graph.vertex_count()
            except InvalidArgument as error:  # the graph is being optimized
                seen.append(str(error))
                os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt_when_running)
        found = None
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            found = find_outliers(graph, threads=1, callback=records.append)
            is_over.set()
        self.assertIsNone(found, "the search was not interrupted")
        self.assertEqual(records, [])  # the final run has not begun
        thread.join()
        self.assertIn("this graph is being optimized", seen[0])
        self.assertEqual(graph.vertex_count(), 20000)


if __name__ == "__main__":
    unittest.main()
