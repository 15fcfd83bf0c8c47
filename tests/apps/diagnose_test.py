#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus info --diagnose`: its text and its JSON, for healthy graphs and for graphs with faults."""

import json
import re

from command_case import TOWN, CommandCase, main, run

UNIT = "1 0 0 1 0 1"  # the information matrix of an EDGE_SE2

# A square of poses at the minimum of chi2.
SQUARE = f"""\
VERTEX_SE2 0 0 0 0
FIX 0
VERTEX_SE2 1 1 0 0
VERTEX_SE2 2 1 1 0
VERTEX_SE2 3 0 1 0
EDGE_SE2 0 1 1 0 0 {UNIT}
EDGE_SE2 1 2 0 1 0 {UNIT}
EDGE_SE2 2 3 -1 0 0 {UNIT}
EDGE_SE2 3 0 0 -1 0 {UNIT}
"""

def diagnosis_of(text):
    done = run("info", "-", "--diagnose", "--json", "-", stdin=text)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return json.loads(done.stdout)["diagnosis"]

def findings_of(text):
    return {finding["kind"]: finding for finding in diagnosis_of(text)["findings"]}

class DiagnoseTest(CommandCase):
    def test_a_healthy_graph_has_no_findings(self):
        self.assertEqual(diagnosis_of(SQUARE), {"at_minimum": True, "findings": []})
        self.assertIn("\n  diagnosis: nothing unusual\n", run("info", "-", "--diagnose", stdin=SQUARE).stdout)

    def test_without_the_option_there_is_no_diagnosis(self):
        self.assertIsNone(json.loads(run("info", "-", "--json", "-", stdin=SQUARE).stdout)["diagnosis"])
        self.assertNotIn("diagnosis", run("info", "-", stdin=SQUARE).stdout)

    def test_a_graph_before_and_after_a_run_has_only_notes(self):
        optimized = self.path / "optimized.g2o"
        self.assertEqual(run("optimize", TOWN, "-o", optimized).returncode, 0)
        for graph in (TOWN, optimized):
            done = run("info", graph, "--diagnose")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("diagnosis", done.stdout)
            lines = done.stdout.partition("\n  diagnosis\n")[2].splitlines()
            for line in lines:
                self.assertRegex(line, r"^  note: .* \[[a-z-]+\]$")

    def test_the_text_has_one_line_per_finding_with_the_worst_first(self):
        done = run("info", "-", "--diagnose", stdin=SQUARE + "VERTEX_SE2 9 0 0 0\nFIX 1\n")
        lines = done.stdout.partition("\n  diagnosis\n")[2].splitlines()
        self.assertEqual([re.match(r"  (\w+): .* (\[[a-z-]+\])$", line).groups() for line in lines],
                         [("warning", "[isolated-vertex]"), ("note", "[fixed-edge]")])

    def test_json_names_the_vertices_of_a_finding(self):
        finding = findings_of(SQUARE + "VERTEX_SE2 9 0 0 0\n")["isolated-vertex"]
        self.assertEqual((finding["severity"], finding["vertices"], finding["edges"]), ("warning", [9], []))
        self.assertIn("pose 9 has no edge", finding["text"])

    def test_json_names_the_edges_of_a_finding_with_their_lines(self):
        finding = findings_of(SQUARE + f"EDGE_SE2 1 2 0 1 0 {UNIT}\n")["duplicate-edge"]
        self.assertEqual([(edge["tag"], edge["vertices"], edge["line"]) for edge in finding["edges"]],
                         [("EDGE_SE2", [1, 2], 10)])

    def test_json_names_the_directions_of_a_finding(self):
        free = findings_of(SQUARE.replace("FIX 0\n", ""))["free-component"]
        self.assertEqual(free["severity"], "note")
        self.assertEqual(free["directions"], [{"kind": "along", "axis": [1, 0, 0]}, {"kind": "along", "axis": [0, 1, 0]},
                                              {"kind": "about", "axis": [0, 0, 1]}])
        bearing = SQUARE + "VERTEX_XY 7 3 0\nEDGE_BEARING_SE2_XY 0 7 0 1\n"
        seen_once = findings_of(bearing)["seen-once"]
        self.assertEqual((seen_once["vertices"], [d["vertex"] for d in seen_once["directions"]]), ([7], [7]))
        self.assertAlmostEqual(abs(seen_once["directions"][0]["tangent"][0]), 1)

    def test_a_component_without_an_edge_to_the_rest_is_named(self):
        other = f"VERTEX_SE2 20 0 0 0\nVERTEX_SE2 21 1 0 0\nEDGE_SE2 20 21 1 0 0 {UNIT}\n"
        finding = findings_of(SQUARE + other)["free-component"]
        self.assertEqual((finding["severity"], finding["vertices"]), ("warning", [20, 21]))
        self.assertIn("poses 20, 21 are free in x, y and yaw", finding["text"])

    def test_errors_that_overflow_are_named(self):
        finding = findings_of(SQUARE.replace("VERTEX_SE2 2 1 1 0", "VERTEX_SE2 2 1e300 1 0"))["non-finite-error"]
        self.assertEqual((finding["severity"], [edge["vertices"] for edge in finding["edges"]]),
                         ("error", [[1, 2], [2, 3]]))

if __name__ == "__main__":
    main()
