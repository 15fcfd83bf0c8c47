#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the output of `boxplus info` for tiny graphs and for unusual graphs."""

import json

from command_case import TOWN, CommandCase, main, run

UNIT = "1 0 0 1 0 1"  # the information matrix of an EDGE_SE2

# Two components. The first component has no fixed vertex, and its loop closure is wrong by 3 meters. The
# second component has a fixed vertex.
GRAPH = f"""\
VERTEX_SE2 0 0 0 0
VERTEX_SE2 2 1 0 0
VERTEX_SE2 4 2 0 0
VERTEX_XY 3 1 1
VERTEX_SE2 10 5 5 0
FIX 10
VERTEX_SE2 11 6 5 0
VERTEX_XY 20 0 -1
EDGE_SE2 0 2 1 0 0 {UNIT}
EDGE_SE2 2 4 1 0 0 {UNIT}
EDGE_SE2 0 4 5 0 0 {UNIT}
EDGE_SE2_XY 0 3 1 2 1 0 1
EDGE_SE2 10 11 1 0 0 {UNIT}
"""

def facts_of(text, *arguments):
    done = run("info", "-", "--json", "-", *arguments, stdin=text)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)

class InfoTest(CommandCase):
    def test_counts_vertices_and_edges_by_type(self):
        facts = facts_of(GRAPH)
        self.assertEqual([facts[key] for key in ("vertices", "parameters", "edges", "unknowns", "rows")], [7, 0, 5, 11, 14])
        self.assertEqual(facts["edge_roles"],
                         {"odometry": 3, "loop_closures": 1, "observations": 1, "priors": 0, "others": 0})
        self.assertEqual(facts["extent"], [6, 6])
        poses, points = facts["vertex_types"]
        self.assertEqual((poses["tag"], poses["count"], poses["fixed"], poses["unknowns"]), ("VERTEX_SE2", 5, 1, 9))
        self.assertEqual((poses["degree_min"], poses["degree_mean"], poses["degree_max"]), (1, 1.8, 3))
        self.assertEqual((points["role"], points["degree_min"]), ("landmark", 0))

    def test_prints_chi2_by_type_and_the_worst_edges(self):
        facts = facts_of(GRAPH, "--worst", 2)
        self.assertEqual(facts["chi2"], 10)
        poses, points = facts["edge_types"]
        self.assertEqual((poses["tag"], poses["count"], poses["chi2"]), ("EDGE_SE2", 4, 9))
        self.assertEqual((points["tag"], points["count"], points["chi2"]), ("EDGE_SE2_XY", 1, 1))
        self.assertEqual([(edge["vertices"], edge["chi2"], edge["line"]) for edge in facts["worst_edges"]],
                         [([0, 4], 9, 11), ([0, 3], 1, 12)])
        self.assertEqual(poses["worst"], facts["worst_edges"][0])

    def test_counts_lines_of_data(self):
        scans = "VERTEX_TAG door 1 0 0 0 0 0 1 robot 2\nROBOTLASER1 0\nVERTEX_TAG hall 1 0 0 0 0 0 1 robot 2\n"
        graph = GRAPH.replace("VERTEX_SE2 2 1 0 0\n", "VERTEX_SE2 2 1 0 0\n" + scans)
        self.assertEqual(facts_of(graph)["data"], {"ROBOTLASER1": 1, "VERTEX_TAG": 2})
        self.assertEqual(facts_of(graph)["notes"], [])
        self.assertRegex(run("info", "-", stdin=graph).stdout, r"\n  data +1 ROBOTLASER1, 2 VERTEX_TAG\n")
        self.assertNotIn("data", run("info", "-", stdin=GRAPH).stdout)

    def test_line_numbers_are_correct_if_other_lines_are_skipped(self):
        broken = GRAPH.replace("EDGE_SE2 0 2 1", "EDGE_SE2 0 2 x")
        facts = facts_of(broken, "--lenient")
        self.assertEqual(facts["skipped_lines"], 1)
        self.assertEqual(facts["worst_edges"][0]["line"], 11)

    def test_line_numbers_are_omitted_if_they_are_uncertain(self):
        facts = facts_of(GRAPH + f"EDGE_SE2_XY 0 -1 1 2 1 0 1\n")
        self.assertEqual({edge["line"] for edge in facts["worst_edges"]}, {None})

    def test_prints_components_and_what_holds_them_in_place(self):
        first, second = (facts := facts_of(GRAPH))["components"]
        self.assertEqual(first, {"first": 0, "vertices": 4, "edges": 4, "fixed": [], "priors": 0, "held": [0], "free": ""})
        self.assertEqual(second, {"first": 10, "vertices": 2, "edges": 1, "fixed": [10], "priors": 0, "held": [], "free": ""})
        self.assertEqual(facts["isolated"], [20])
        text = run("info", "-", stdin=GRAPH).stdout
        for words in ("nothing; optimize will hold vertex 0", "fixed vertex 10", "without edges: vertex 20"):
            self.assertIn(words, text)

    def test_optimize_holds_the_vertex_that_info_names(self):
        graph = self.written("graph.g2o", GRAPH)
        report = json.loads(run("optimize", graph, "--json", "-").stdout)
        self.assertEqual(report["gauge"]["held"], [0])

    def test_counts_the_same_unknowns_and_rows_as_optimize(self):
        graph = self.written("graph.g2o", GRAPH)
        report = json.loads(run("optimize", graph, "--json", "-").stdout)
        facts = facts_of(GRAPH)
        self.assertEqual((facts["unknowns"], facts["rows"]), (report["scalars"], report["rows"]))
        self.assertEqual(sum(kind["unknowns"] for kind in facts["vertex_types"]), facts["unknowns"])

    def test_no_vertex_is_held_in_a_component_with_a_prior(self):
        prior = f"EDGE_PRIOR_SE2 0 0 0 0 {UNIT}\n"
        first = facts_of(GRAPH + prior)["components"][0]
        self.assertEqual((first["priors"], first["held"]), (1, []))
        self.assertIn("1 prior", run("info", "-", stdin=GRAPH + prior).stdout)

    def test_the_text_has_no_trailing_blanks(self):
        done = run("info", TOWN)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("119 odometry, 6 loop closures", done.stdout)
        self.assertEqual([line for line in done.stdout.splitlines() if line != line.rstrip()], [])

    def test_accepts_unusual_graphs(self):
        lone = facts_of("VERTEX_SE2 7 0 0 0\n")
        self.assertEqual((lone["edges"], lone["chi2"], lone["components"], lone["isolated"]), (0, 0, [], [7]))
        huge = f"VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1e300 0 0\nEDGE_SE2 0 1 0 0 0 {UNIT}\n"
        self.assertIsNone(facts_of(huge)["chi2"])  # chi2 overflows
        for text in ("VERTEX_SE2 7 0 0 0\n", huge, "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 3 0 0 0 0 0 0 1\n"):
            done = run("info", "-", stdin=text)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_notes_about_the_file_are_printed_up_to_a_limit(self):
        words = "".join(f"WORD{k} 1\n" for k in range(50))
        done = run("info", "-", stdin=GRAPH + words)
        self.assertIn("and 40 more notes", done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 11)
        self.assertEqual(len(facts_of(GRAPH + words)["notes"]), 50)

    def test_bad_input_is_refused(self):
        self.assert_refused(run("info", "-", stdin="VERTEX_SE2 0 0 0\n"), "<stdin>:1:17: expected")
        self.assert_refused(run("info", "-", stdin="\x7fELF\x02\n\x00\n"), r"expected a vertex or an edge", r"its first line is '\x7fELF\x02'")
        self.assert_refused(run("info", self.path), "got a folder without the files of a graph")
        self.assert_refused(run("info", TOWN, "--worst", -1), "--worst: expected a whole number ≥ 0, got '-1'")
    def test_writes_the_matrix_of_the_normal_equations_for_other_programs(self):
        # Both errors are linear at θ = 0: e_01 = (x1 - x0, y1 - y0 - ..., θ1 - θ0), and a prior for vertex 7.
        graph = ("VERTEX_SE2 0 0 0 0\nFIX 0\nVERTEX_SE2 1 1 0 0\nVERTEX_XY 7 3 0\nEDGE_SE2 0 1 1 0 0 4 0 0 5 0 6\n"
                 "EDGE_SE2_XY 1 7 2 0 2 1 3\n")
        path = self.written("graph.g2o", graph)
        # J of EDGE_SE2 for pose 1 is I. J of EDGE_SE2_XY is [-1 0 0; 0 -1 -2] for pose 1, and I for the point.
        lower = {(1, 1): 6, (2, 1): 1, (3, 1): 2, (4, 1): -2, (5, 1): -1, (2, 2): 8, (3, 2): 6, (4, 2): -1, (5, 2): -3,
                 (3, 3): 18, (4, 3): -2, (5, 3): -6, (4, 4): 2, (5, 4): 1, (5, 5): 3}
        done = run("info", path, "--matrix", self.path / "H.mtx")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = (self.path / "H.mtx").read_text(encoding="utf-8").splitlines()
        self.assertEqual(lines[:5], ["%%MatrixMarket matrix coordinate real symmetric", "% H of the normal equations",
                                     "% rows 1 to 3: vertex 1 (VERTEX_SE2)", "% rows 4 to 5: vertex 7 (VERTEX_XY)", "5 5 15"])
        entries = [tuple(map(float, line.split())) for line in lines[5:]]
        self.assertEqual({(row, column): value for row, column, value in entries}, lower)

        text = run("info", path, "--matrix", "-").stdout
        begin, blocks = text.split("\n\n\n")
        header, values = begin.split("# name: H\n# type: sparse matrix\n# nnz: 25\n# rows: 5\n# columns: 5\n")
        self.assertIn("# rows 4 to 5: vertex 7 (VERTEX_XY)\n", header)
        entries = [tuple(map(float, line.split())) for line in values.splitlines()]
        self.assertEqual([entry[:2] for entry in entries], [(row, column) for column in range(1, 6) for row in range(1, 6)])
        self.assertEqual({(row, column): value for row, column, value in entries},
                         {**lower, **{(column, row): value for (row, column), value in lower.items()}})
        self.assertEqual(blocks, "# name: blocks\n# type: matrix\n# rows: 2\n# columns: 4\n 1 1 3 0\n 7 4 2 0\n")

    def test_the_matrix_has_eliminated_vertices_first_and_the_weights_of_the_kernel(self):
        bal = "1 1 1\n0 0 1 2\n0 0 0 0 0 0 500 0 0\n1 2 -10\n"
        text = run("info", "-", "--matrix", "-", stdin=bal).stdout
        self.assertIn("# rows 1 to 3: vertex 1 (VERTEX_TRACKXYZ)\n# rows 4 to 12: vertex 0 (Product<SE3, BAL>)\n", text)
        graph = "VERTEX_XY 0 0 0\nEDGE_PRIOR_XY 0 10 0 1 0 1\n"
        text = run("info", "-", "--matrix", "-", "--kernel", "Huber", "--kernel-width", "1", stdin=graph).stdout
        self.assertIn("\n1 1 0.1\n2 2 0.1\n", text)

    def test_refuses_a_matrix_that_is_not_finite_or_that_replaces_the_input(self):
        path = self.written("graph.g2o", "VERTEX_XY 0 0 0\nEDGE_PRIOR_XY 0 10 0 1 0 1\n")
        self.assert_refused(run("info", path, "--matrix", path), "--matrix: expected a file other than the input")
        self.assert_refused(run("info", path, "--matrix", "-", "--json", "-"), "expected two different files")


if __name__ == "__main__":
    main()
