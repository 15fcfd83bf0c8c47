#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus optimize --certify`."""

import json
import math

from command_case import TOWN, CommandCase, main, run

POSES = 30

def circle(extra_turns):
    """A circle of exact measurements but one. On the way around it, the estimates turn `extra_turns` times too often."""
    lines = []
    turn = 2 * math.pi / POSES
    for k in range(POSES):
        heading = math.remainder(turn * k * (1 + extra_turns), 2 * math.pi)
        radius = 0.5 / math.sin(turn / 2)
        x, y = radius * math.sin(turn * k), radius * (1 - math.cos(turn * k))
        lines.append(f"VERTEX_SE2 {k} {x} {y} {heading}")
    for k in range(POSES):
        x = math.cos(turn / 2) + (0.1 if k == 0 else 0)
        lines.append(f"EDGE_SE2 {k} {(k + 1) % POSES} {x} {math.sin(turn / 2)} {turn} 400 0 0 400 0 900")
    return "\n".join(lines) + "\n"

class CertifyTest(CommandCase):
    def optimize(self, graph, *arguments):
        report = self.path / "report.json"
        done = run("optimize", "-", "--certify", "--json", report, *arguments, stdin=graph)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout, json.loads(report.read_text(encoding="utf-8"))

    def test_proves_the_optimum_of_a_sphere(self):
        graph = self.path / "sphere.g2o"
        self.assertEqual(run("simulate", "sphere", "--poses", 400, "-o", graph).returncode, 0)
        text, report = self.optimize(graph.read_text(encoding="utf-8"))
        self.assertIn("The minimum is global: no estimates have a chi2 below", text)
        certificate = report["certificate"]
        self.assertEqual((certificate["verdict"], certificate["relation"]), ("global-minimum", "equal"))
        self.assertLess(certificate["relative_gap"], 1e-6)
        self.assertIsNone(report["certificate_of_better"])
        self.assertEqual(report["chi2_final"], report["chi2_final_of_run"])

    def test_replaces_a_local_minimum_by_a_better_one(self):
        output = self.path / "out.g2o"
        text, report = self.optimize(circle(extra_turns=1), "--start", "current", "-o", output)
        self.assertIn("The minimum is a local one: there is a better one with chi2", text)
        certificate = report["certificate"]
        self.assertEqual(certificate["verdict"], "local-minimum")
        self.assertAlmostEqual(certificate["chi2"] / report["chi2_final_of_run"], 1, 6)
        self.assertEqual(report["chi2_final"], certificate["better_chi2"])
        self.assertAlmostEqual(report["chi2_per_degree"] * report["degrees_of_freedom"] / report["chi2_final"], 1, 9)
        self.assertLess(certificate["better_chi2"], 0.1 * certificate["chi2"])
        self.assertEqual(report["certificate_of_better"]["verdict"], "global-minimum")
        chi2 = json.loads(run("info", output, "--json", "-").stdout)["chi2"]
        self.assertAlmostEqual(chi2 / certificate["better_chi2"], 1, 4)

    def test_a_graph_with_landmarks_is_refused_by_name(self):
        graph = self.path / "city.g2o"
        self.assertEqual(run("simulate", "city", "--poses", 100, "-o", graph).returncode, 0)
        done = run("optimize", graph, "--certify")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "an edge does not measure the pose of a vertex relative to another one: "
                                      r"PointObservation2 \(vertices [0-9]+ [0-9]+\)")

    def test_there_is_no_certificate_without_the_option(self):
        report = self.path / "report.json"
        self.assertEqual(run("optimize", TOWN, "--json", report).returncode, 0)
        self.assertIsNone(json.loads(report.read_text(encoding="utf-8"))["certificate"])

    def test_a_robust_kernel_excludes_a_certificate(self):
        done = run("optimize", TOWN, "--certify", "--kernel", "Cauchy")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--kernel excludes --certify", done.stderr)

    def test_says_that_no_certificate_was_tried_if_the_run_is_not_converged(self):
        report = self.path / "report.json"
        done = run("optimize", TOWN, "--certify", "--iterations", 1, "--json", report)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout, r"\nNo certificate was tried, because the run is not converged: the iteration limit is reached\.\n")
        self.assertIsNone(json.loads(report.read_text(encoding="utf-8"))["certificate"])
        self.assertNotIn("certificate", run("optimize", TOWN, "--iterations", 1).stdout)

if __name__ == "__main__":
    main()
