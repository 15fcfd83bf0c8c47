#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus optimize --outliers`."""

import json

from command_case import CommandCase, main, run

class OutliersTest(CommandCase):
    def setUp(self):
        super().setUp()
        self.graph = self.path / "graph.g2o"
        done = run("simulate", "manhattan", "--poses", 500, "--outliers", 0.3, "--noise", 0.3, "-o", self.graph)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.wrong = int(done.stdout.split("(")[1].split(" wrong")[0])

    def edges(self, path):
        return sum(line.startswith("EDGE") for line in path.read_text(encoding="utf-8").splitlines())

    def test_counts_and_lists_the_false_closures(self):
        found, listed = self.path / "report.json", self.path / "list.txt"
        done = run("optimize", self.graph, "--outliers", "loop-closures", "--json", found, "--write-outliers", listed)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn(f"{self.wrong} of 144 loop closures are false", done.stdout)
        report = json.loads(found.read_text(encoding="utf-8"))
        self.assertEqual(report["status"], "converged")
        outliers = report["outliers"]
        time = report["time_s"]
        self.assertGreater(time["outliers"], time["optimize"])
        self.assertIn(f"The search and this run took {time['outliers']:.4f} s.", done.stdout)
        self.assertEqual((outliers["inliers"], outliers["outliers"], outliers["undecided"]),
                         (144 - self.wrong, self.wrong, 0))
        self.assertEqual(len(outliers["closures"]), 144)
        self.assertEqual(report["edges"], self.edges(self.graph) - self.wrong)
        lines = listed.read_text(encoding="utf-8").splitlines()
        self.assertEqual(lines[0], "# verdict from to chi2")
        rejected = [(edge["from"], edge["to"]) for edge in outliers["closures"] if edge["verdict"] == "outlier"]
        self.assertEqual([tuple(map(int, line.split()[1:3])) for line in lines[1:]], rejected)

    def test_judges_all_edges_of_bundle_adjustment(self):
        scene, found = self.path / "scene.bal", self.path / "found.json"
        done = run("simulate", "ba", "--cameras", 15, "--points", 400, "--outliers", 0.1, "-o", scene)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run("optimize", scene, "--outliers", "all", "--json", found, "-o", self.path / "clean.bal", "--remove-outliers")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(found.read_text(encoding="utf-8"))
        outliers = report["outliers"]
        self.assertIn(f"{outliers['outliers']} of {len(outliers['edges'])} edges are false", done.stdout)
        self.assertGreater(outliers["outliers"], 0.06 * len(outliers["edges"]))
        self.assertLess(report["chi2_final"] / report["degrees_of_freedom"], 1.2)
        info = json.loads(run("info", self.path / "clean.bal", "--json", "-").stdout)
        self.assertEqual(info["edges"], sum(edge["weight"] for edge in outliers["edges"]))
        self.assertAlmostEqual(info["chi2"] / report["chi2_final"], 1, 6)

    def test_keeps_all_edges_unless_told_to_remove_the_outliers(self):
        every, some = self.path / "every.g2o", self.path / "some.g2o"
        search = ("optimize", self.graph, "--outliers", "loop-closures")
        self.assertEqual(run(*search, "-o", every).returncode, 0)
        self.assertEqual(run(*search, "-o", some, "--remove-outliers").returncode, 0)
        self.assertEqual(self.edges(every), self.edges(self.graph))
        self.assertEqual(self.edges(some), self.edges(self.graph) - self.wrong)
        again = run("optimize", some)
        self.assertEqual((again.returncode, again.stderr), (0, ""))

    def test_refuses_options_that_do_not_fit_together(self):
        search = ("optimize", self.graph, "--outliers", "loop-closures")
        self.assert_refused(run(*search, "--kernel", "Huber"), "--kernel")
        self.assert_refused(run(*search, "--only-vertices", "1-5"), "--only-vertices")
        self.assert_refused(run(*search, "--remove-outliers"), "--output")
        self.assert_refused(run("optimize", self.graph, "--write-outliers", self.path / "list"), "--outliers")
        self.assert_refused(run(*search, "--write-outliers", self.graph), "--write-outliers")

    def test_refuses_a_graph_with_closures_but_without_odometry(self):
        graph = self.written("far.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\n"
                             "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n")
        self.assert_refused(run("optimize", graph, "--outliers", "loop-closures"), "odometry")

    def test_info_counts_and_lists_the_false_closures_as_optimize_does(self):
        before, report = self.graph.read_bytes(), self.path / "report.json"
        search = ("--outliers", "loop-closures", "--json")
        self.assertEqual(run("optimize", self.graph, *search, report).returncode, 0)
        outliers = json.loads(report.read_text(encoding="utf-8"))["outliers"]
        facts = json.loads(run("info", self.graph, *search, "-").stdout)
        self.assertEqual(facts.pop("outliers"), outliers)
        plain = json.loads(run("info", self.graph, "--json", "-").stdout)
        self.assertIsNone(plain.pop("outliers"))
        self.assertEqual(facts, plain)  # the search changes no other fact
        self.assertEqual(self.graph.read_bytes(), before)

        text = run("info", self.graph, *search[:2]).stdout
        self.assertIn(f"\n  outliers: {self.wrong} of 144 loop closures are false; {144 - self.wrong} fit\n", text)
        rejected = [edge for edge in outliers["closures"] if edge["verdict"] == "outlier"]
        rejected.sort(key=lambda edge: -edge["chi2"])
        table = text.split("worst outliers")[1].splitlines()[1:]
        rows = [line.replace(",", "").split() for line in table[:10]]
        self.assertEqual([(row[0], {*map(int, row[3:])}) for row in rows],
                         [("EDGE_SE2", {edge["from"], edge["to"]}) for edge in rejected[:10]])
        self.assertEqual(table[10:], [])
        lines = self.graph.read_text(encoding="utf-8").splitlines()
        for row in rows:
            self.assertEqual(lines[int(row[2]) - 1].split()[:3], [row[0], *row[3:]])

    def test_info_judges_all_edges_beside_a_kernel(self):
        search = ("info", self.graph, "--outliers", "all", "--json", "-")
        alone, both = (json.loads(run(*search, *more).stdout) for more in ((), ("--kernel", "Cauchy")))
        self.assertEqual(len(alone["outliers"]["edges"]), alone["edges"])
        self.assertGreater(alone["outliers"]["outliers"], 0.9 * self.wrong)
        self.assertEqual(both["outliers"], alone["outliers"])

    def test_info_says_why_there_are_no_verdicts_and_prints_the_rest(self):
        graph = self.written("far.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\n"
                             "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n")
        search = ("info", graph, "--outliers", "loop-closures")
        plain, done = run("info", graph), run(*search)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith(plain.stdout), done.stdout)
        self.assertRegex(done.stdout[len(plain.stdout):], r"\A\n  outliers: no verdicts: [^\n]*expected odometry[^\n]*\n\Z")
        facts = json.loads(run(*search, "--json", "-").stdout)
        self.assertIsNone(facts["outliers"])
        self.assertIn("expected odometry", facts["outliers_obstacle"])

if __name__ == "__main__":
    main()
