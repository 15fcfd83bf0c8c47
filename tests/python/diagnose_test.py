# SPDX-License-Identifier: BSD-3-Clause
"""diagnose()."""

import unittest

import boxplus
import numpy as np
from boxplus import SE2, Between, Diagnosis, Finding, Graph, InvalidArgument, diagnose
from graph_test import square


class Diagnoses(unittest.TestCase):
    def test_a_vertex_without_edges_is_a_finding(self):
        graph, _ = square()
        lonely = graph.add_vertex(SE2(), 20)
        diagnosis = diagnose(graph)
        found = [finding for finding in diagnosis.findings if finding.kind == Finding.Kind.kIsolatedVertex]
        self.assertEqual([(finding.vertices, finding.ids, finding.edges) for finding in found], [([lonely], [20], [])])
        self.assertEqual(found[0].severity, Finding.Severity.kWarning)
        self.assertIn("pose 20 has no edge", found[0].text)
        self.assertEqual(repr(found[0]), f"warning: {found[0].text} [isolated-vertex]")
        self.assertIn(repr(found[0]), str(diagnosis).split("\n"))
        self.assertEqual(str(diagnosis).count("\n") + 1, len(diagnosis.findings))
        self.assertFalse(diagnosis.ok())
        self.assertTrue(diagnosis.is_complete)
        self.assertEqual(diagnosis.count("warning"), diagnosis.count(Finding.Severity.kWarning))
        self.assertGreaterEqual(diagnosis.count("warning"), 1)

    def test_a_graph_without_faults_has_no_findings(self):
        graph = Graph()
        graph.add_vertices(SE2, None, [[0, 0, 0], [1, 0, 0]])
        graph.fix(0)
        graph.add_edge(Between(SE2(1, 0, 0)), 0, 1)
        diagnosis = diagnose(graph)
        self.assertTrue(diagnosis.ok())
        self.assertTrue(diagnosis.at_minimum)
        self.assertEqual((diagnosis.findings, repr(diagnosis)), ([], "no findings"))

    def test_directions_have_arrays(self):
        graph = Graph()
        graph.add_vertices(SE2, None, [[0, 0, 0], [1, 0, 0]])
        graph.add_edge(Between(SE2(1, 0, 0)), 0, 1)
        free = next(f for f in diagnose(graph).findings if f.kind == Finding.Kind.kFreeComponent)
        self.assertEqual(free.ids, [0, 1])
        about = [d for d in free.directions if d.kind == Finding.Direction.Kind.kAbout]
        self.assertEqual(len(about), 1)
        np.testing.assert_allclose(about[0].axis, [0, 0, 1])
        self.assertIsInstance(about[0].tangent, np.ndarray)
        self.assertIn("kind=<Kind.kAbout: 1>, axis=array([0., 0., 1.])", repr(about[0]))

        graph.fix(0)
        graph.set_information(graph.all_edges()[0], np.diag([1, 0, 1]))
        free = next(f for f in diagnose(graph).findings if f.kind == Finding.Kind.kUndeterminedDirection)
        self.assertEqual((free.ids, free.directions[0].vertex), ([1], graph.vertex(1)))
        np.testing.assert_allclose(np.abs(free.directions[0].tangent), [0, 1, 0], atol=1e-9)

    def test_options_choose_edges_and_stop_the_diagnosis(self):
        graph, edges = square()
        flag = boxplus.StopFlag()
        flag.set()
        diagnosis = diagnose(graph, stop=flag)
        self.assertFalse(diagnosis.is_complete)
        self.assertIn("the diagnosis was stopped", str(diagnosis))
        graph.set_level(edges[0], 7)
        self.assertTrue(all(edges[0] not in finding.edges for finding in diagnose(graph).findings))
        graph.remove(edges[0])
        with self.assertRaises(InvalidArgument):
            diagnose(graph, edges=[edges[0]])
        with self.assertRaisesRegex(TypeError, "Options: expected one of start"):
            diagnose(graph, false_alarm=1)
        with self.assertRaises(TypeError):
            diagnose(None)

    def test_wrong_severities_are_refused(self):
        diagnosis = diagnose(square()[0])
        with self.assertRaisesRegex(ValueError, "severity: expected one of 'note', 'warning', 'error', got 'fatal'"):
            diagnosis.count("fatal")
        with self.assertRaisesRegex(TypeError, "severity: expected"):
            diagnosis.count(Finding.Kind.kOutlier)

    def test_the_texts_of_enumerations_are_those_of_the_lines(self):
        self.assertEqual(boxplus.to_string(Finding.Kind.kChi2Ratio), "chi2-ratio")
        self.assertEqual(boxplus.to_string(Finding.Severity.kError), "error")
        self.assertIsInstance(diagnose(Graph()), Diagnosis)


if __name__ == "__main__":
    unittest.main()
