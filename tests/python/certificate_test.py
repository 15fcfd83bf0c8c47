# SPDX-License-Identifier: BSD-3-Clause
"""certify()."""

import os
import signal
import threading
import unittest

import boxplus
import numpy as np
from boxplus import SE2, SE3, SO3, Between, Certificate, Graph, InvalidArgument, Prior, StopFlag, certify, optimize

POSES = 30
TURN = 2 * np.pi / POSES


def ring():
    """Poses in the plane around a circle, at the minimum."""
    random = np.random.default_rng(1)
    graph, pose = Graph(), SE2(1, 2, 0.5)
    steps = [SE2(*([1, 0, TURN] + 0.02 * random.normal(size=3))) for _ in range(POSES)]
    for step in steps:
        graph.add_vertex(pose)
        pose = pose * step
    for k, step in enumerate(steps):
        graph.add_edge(Between(step), k, (k + 1) % POSES, information=np.diag([400, 400, 900]))
    optimize(graph)
    return graph


def wound_ring():
    """The same, at a local minimum: on the way around it, the robot turns once more than measured."""
    graph = ring()
    ids, poses = graph.estimates(SE2)
    poses[:, 2] += ids * TURN
    graph.set_estimates(SE2, ids, poses)
    optimize(graph)
    return graph


def ring_in_space():
    random = np.random.default_rng(2)
    graph, pose = Graph(), SE3()
    steps = [SE3([1, 0, 0], SO3.from_rotation_vector([0, 0, TURN])).oplus(0.02 * random.normal(size=6)) for _ in range(POSES)]
    for step in steps:
        graph.add_vertex(pose)
        pose = pose * step
    for k, step in enumerate(steps):
        graph.add_edge(Between(step), k, (k + 1) % POSES, information=2500)
    optimize(graph)
    return graph


class Verdicts(unittest.TestCase):
    def test_the_minimum_of_a_ring_in_space_is_proved_to_be_global(self):
        graph = ring_in_space()
        before = graph.estimates(SE3)[1]
        certificate = certify(graph)
        self.assertEqual(certificate.verdict, Certificate.Verdict.kGlobalMinimum)
        self.assertEqual(certificate.relation, Certificate.Relation.kEqual)
        self.assertAlmostEqual(certificate.chi2 / graph.chi2(), 1, delta=1e-9)
        self.assertGreater(certificate.bound, 0)
        self.assertLessEqual(certificate.bound, certificate.chi2)
        self.assertEqual(certificate.chi2_bound(), certificate.bound)
        self.assertEqual(certificate.relative_gap(),
                         (certificate.chordal_cost - certificate.bound) / certificate.chordal_cost)
        self.assertLess(certificate.relative_gap(), 1e-6)
        self.assertRegex(repr(certificate), r"^The minimum is global: no estimates have a chi2 below [\d.]+ with normalized "
                                            r"rotations \(relative gap .*\)\.$")
        np.testing.assert_array_equal(graph.estimates(SE3)[1], before)

    def test_a_ring_in_the_plane_has_a_lower_bound_for_chi2(self):
        graph = ring()
        certificate = certify(graph)
        self.assertEqual((certificate.verdict, certificate.relation),
                         (Certificate.Verdict.kGlobalMinimum, Certificate.Relation.kBelow))
        self.assertEqual(certificate.chi2, graph.chi2())
        self.assertTrue(0.99 * certificate.chi2 < certificate.chi2_bound() < certificate.chi2)
        self.assertIn("No estimates have a chi2 below", str(certificate))

    def test_different_weights_of_directions_give_no_bound_for_chi2(self):
        graph = ring()
        graph.set_information(graph.all_edges()[0], np.diag([400, 300, 900]))
        optimize(graph)
        certificate = certify(graph)
        self.assertEqual(certificate.relation, Certificate.Relation.kSimilar)
        self.assertEqual(certificate.chi2_bound(), 0)

    def test_a_wound_ring_is_at_a_local_minimum_and_gets_the_better_estimates(self):
        best, graph = ring().chi2(), wound_ring()
        local = graph.chi2()
        self.assertGreater(local, 10 * best)
        certificate = certify(graph)
        self.assertEqual(certificate.verdict, Certificate.Verdict.kLocalMinimum)
        self.assertEqual(certificate.chi2, local)
        self.assertEqual(certificate.better_chi2, graph.chi2())
        self.assertAlmostEqual(graph.chi2() / best, 1, delta=1e-6)
        self.assertIn("there is a better one with chi2", repr(certificate))
        self.assertEqual(certify(graph).verdict, Certificate.Verdict.kGlobalMinimum)

    def test_a_local_minimum_that_may_not_be_left_is_undecided(self):
        graph = wound_ring()
        local = graph.chi2()
        certificate = certify(graph, max_escapes=0)
        self.assertEqual(certificate.verdict, Certificate.Verdict.kUndecided)
        self.assertIn("no better minimum was found", certificate.note)
        self.assertEqual(repr(certificate), f"It is undecided whether the minimum is global: {certificate.note}.")
        self.assertEqual(graph.chi2(), local)

    def test_verdicts_and_relations_have_the_texts_of_the_command(self):
        self.assertEqual([boxplus.to_string(verdict) for verdict in Certificate.Verdict.__members__.values()],
                         ["global-minimum", "local-minimum", "undecided"])
        self.assertEqual([boxplus.to_string(relation) for relation in Certificate.Relation.__members__.values()],
                         ["equal", "below", "similar"])


class Refusals(unittest.TestCase):
    def test_a_graph_that_is_no_pose_graph_is_refused(self):
        graph = ring()
        self.assertEqual(boxplus.why_not_certifiable(graph), "")
        graph.set_level(graph.add_edge(Prior(SE2()), 5), 1)
        self.assertEqual(boxplus.why_not_certifiable(graph), "")
        self.assertIn("Prior<SE2> (vertex 5)", boxplus.why_not_certifiable(graph, level=-1))
        with self.assertRaisesRegex(InvalidArgument, r"certify: expected a graph of relative poses, but .*Prior<SE2> \(vertex 5"):
            certify(graph, level=-1)
        self.assertEqual(certify(graph).verdict, Certificate.Verdict.kGlobalMinimum)
        graph.add_edge(lambda pose: pose.x(), 3)
        with self.assertRaisesRegex(InvalidArgument, r"\(vertex 3\)"):
            certify(graph)

    def test_wrong_options_are_refused(self):
        graph = ring()
        for error, text, options in (
                (InvalidArgument, "certify: expected a tolerance in (0, 1), got 0", {"tolerance": 0}),
                (InvalidArgument, "certify: expected max_escapes ≥ 0, got -1", {"max_escapes": -1}),
                (TypeError, "max_escapes: expected an int, got 1.5", {"max_escapes": 1.5}),
                (ValueError, "max_escapes: expected an int of 32 bits", {"max_escapes": 2**40}),
                (TypeError, "tolerance: expected", {"tolerance": "small"}),
                (TypeError, "Options: expected one of start", {"escapes": 3})):
            with self.subTest(text), self.assertRaises(error) as raised:
                certify(graph, **options)
            self.assertIn(text, str(raised.exception))
        with self.assertRaises(TypeError):
            certify(None)


class Stops(unittest.TestCase):
    def test_a_stop_flag_and_a_time_limit_leave_it_undecided(self):
        graph = wound_ring()
        _, before = graph.estimates(SE2)
        flag = StopFlag()
        flag.set()
        for options, note in (({"stop": flag}, "the search was stopped"), ({"time_limit_s": 0}, "the time limit was reached")):
            certificate = certify(graph, **options)
            self.assertEqual((certificate.verdict, certificate.note), (Certificate.Verdict.kUndecided, note))
            np.testing.assert_array_equal(graph.estimates(SE2)[1], before)

    def test_other_threads_run_meanwhile_and_ctrl_c_stops_the_search(self):
        count = 20000
        graph, steps = Graph(), np.arange(count)
        graph.add_vertices(SE2, None, np.c_[np.cos(TURN * steps), np.sin(TURN * steps), TURN * steps])
        random = np.random.default_rng(3)
        for step in (1, 7):
            graph.add_edges(Between, steps[:-step], steps[step:], measurements=random.normal(size=(count - step, 3)))
        _, before = graph.estimates(SE2)
        seen, is_over = [], threading.Event()

        def interrupt_when_running():
            try:
                while not is_over.is_set():
                    graph.vertex_count()
            except InvalidArgument as error:  # certify() uses the graph
                seen.append(str(error))
                os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt_when_running)
        certificate = None
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            certificate = certify(graph, threads=1)
            is_over.set()
        self.assertIsNone(certificate, "the search was not interrupted")
        thread.join()
        self.assertIn("this graph is being optimized", seen[0])
        np.testing.assert_array_equal(graph.estimates(SE2)[1], before)


if __name__ == "__main__":
    unittest.main()
