# SPDX-License-Identifier: BSD-3-Clause
"""The text of a report with functions of Python."""

import unittest

from boxplus import SE2, Between, Graph, optimize


class Reports(unittest.TestCase):
    def test_functions_of_the_same_name_are_counted(self):
        graph = Graph()
        for k in range(30):
            graph.add_vertex(SE2(k, 0, 0))
            graph.add_edge(lambda x, k=k: x.vector() - [k + 0.1, 0, 0], k)
            if k > 0:
                graph.add_edge(Between(SE2(1, 0, 0)), k - 1, k)
        lines = repr(optimize(graph)).split("\n")
        self.assertIn("  Jacobians       analytic: Between<SE2>; numeric: <lambda> (30 functions)", lines)
        self.assertLess(max(map(len, lines)), 200)
        costs = [line for line in lines if line.startswith("  function ")]
        self.assertEqual(len(costs), 1)
        self.assertRegex(costs[0], r"<lambda> \(30 functions\): (\d+) calls for \1 errors, [\d.]+ s, numeric Jacobians")

    def test_other_lines_are_those_of_cpp(self):
        graph = Graph()
        graph.add_vertex(SE2(0, 0, 0))
        graph.add_edge(lambda x: x.vector() - [0.1, 0, 0], 0)
        text = repr(optimize(graph))
        self.assertIn("\n  Jacobians       numeric: <lambda>\n", text)
        self.assertTrue(text.startswith("converged: chi2 "))


if __name__ == "__main__":
    unittest.main()
