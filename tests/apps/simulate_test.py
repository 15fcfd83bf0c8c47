#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus simulate`, which makes graphs whose true poses are known."""

import re

from command_case import CommandCase, main, run

WORLDS = ("sphere", "torus", "grid", "manhattan", "streets", "city")

def words_of(path):
    """The number of lines that begin with each word."""
    counts = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        word = line.split(" ", 1)[0]
        counts[word] = counts.get(word, 0) + 1
    return counts

class SimulateTest(CommandCase):
    def test_each_world_is_in_the_help_and_its_graph_can_be_optimized(self):
        text = run("simulate", "--help").stdout
        for world in WORLDS:
            self.assertRegex(text, rf"\n  {world} +\w+")
            graph = self.path / f"{world}.g2o"
            done = run("simulate", world, "--poses", 600, "-o", graph)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(run("optimize", graph, "-q").returncode, 0, world)

    def test_the_same_arguments_give_the_same_bytes(self):
        for name, seed in (("a", 4), ("b", 4), ("c", 5)):
            run("simulate", "city", "--poses", 60, "--seed", seed, "-o", self.path / name, "--truth", self.path / f"{name}_truth")
        a, b, c, truth = ((self.path / name).read_bytes() for name in ("a", "b", "c", "a_truth"))
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)
        self.assertNotEqual(a, truth)

    def test_the_summary_describes_the_written_graph(self):
        done = run("simulate", "manhattan", "--poses", 2500, "--outliers", 0.1, "-o", self.path / "m.g2o")
        found = re.fullmatch(r".*m\.g2o: (\d+) vertices, (\d+) edges, (\d+) of them loop closures \((\d+) wrong\); "
                             r"chi2 is \S+, and \S+ at the truth\n", done.stdout)
        self.assertIsNotNone(found, done.stdout)
        vertices, edges, closures, wrong = map(int, found.groups())
        self.assertEqual(words_of(self.path / "m.g2o"), {"VERTEX_SE2": vertices, "FIX": 1, "EDGE_SE2": edges})
        self.assertEqual((vertices, closures), (2500, edges - 2499))
        self.assertAlmostEqual(wrong / closures, 0.1, delta=0.05)

    def test_without_noise_the_estimates_equal_the_truth(self):
        run("simulate", "streets", "--poses", 500, "--noise", 0, "-o", self.path / "g.g2o", "--truth", self.path / "t.g2o")
        done = run("optimize", self.path / "t.g2o", "--iterations", 0, "--start", "current")
        self.assertIn("chi2", done.stdout)
        places = [[list(map(float, line.split()[1:])) for line in (self.path / name).read_text(encoding="utf-8").splitlines()
                   if line.startswith("VERTEX")] for name in ("g.g2o", "t.g2o")]
        self.assertEqual(len(places[0]), 500)
        for estimate, truth in zip(*places):
            for a, b in zip(estimate, truth):
                self.assertAlmostEqual(a, b, places=9)

    def test_each_world_of_bundle_adjustment_is_in_the_help_and_can_be_optimized(self):
        text = run("simulate", "--help").stdout
        for world in ("ba-ring", "ba-street", "ba-city"):
            self.assertRegex(text, rf"\n  {world} +\w+")
            graph, truth = self.path / f"{world}.txt", self.path / f"{world}_truth.txt"
            done = run("simulate", world, "--poses", 60, "--points", 1500, "-o", graph, "--truth", truth)
            found = re.fullmatch(r".*txt: 60 cameras, 1500 points, (\d+) observations; chi2 is (\S+), and (\S+) at the truth\n", done.stdout)
            self.assertIsNotNone(found, done.stdout + done.stderr)
            observations, chi2, of_truth = int(found[1]), float(found[2]), float(found[3])
            self.assertEqual(graph.read_text(encoding="utf-8").split()[:3], ["60", "1500", str(observations)])
            self.assertAlmostEqual(of_truth / (2 * observations), 1, delta=0.1)
            self.assertGreater(chi2, of_truth)
            self.assertIn(run("optimize", truth, "-q", "--iterations", 3).returncode, (0, 1))

    def test_writes_to_standard_output(self):
        done = run("simulate", "sphere", "--poses", 25, "-o", "-")
        run("simulate", "sphere", "--poses", 25, "-o", self.path / "s.g2o")
        self.assertEqual(done.stdout, (self.path / "s.g2o").read_text(encoding="utf-8"))
        self.assertIn("25 vertices", done.stderr)

    def test_wrong_values_are_refused(self):
        out = self.path / "x.g2o"
        for words, text in ((["moon"], "moon"),
                            (["sphere", "--poses", "1"], "a whole number from 2 to 10000000, got '1'"),
                            (["sphere", "--poses", "many"], "got 'many'"),
                            (["sphere", "--seed", "-1"], "a whole number ≥ 0, got '-1'"),
                            (["sphere", "--noise", "-1"], "a number from 0 to 1000, got '-1'"),
                            (["sphere", "--noise", "nan"], "got 'nan'"),
                            (["sphere", "--outliers", "1.5"], "a number from 0 to 1, got '1.5'"),
                            (["sphere", "--outliers", "nan"], "got 'nan'"),
                            (["sphere", "--truth", out], "two different files")):
            done = run("simulate", *words, "-o", out)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(text, done.stderr)
            self.assertFalse(out.exists())
        done = run("simulate", "grid", "-o", self.path / "no" / "x.g2o")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("cannot be written", done.stderr)

if __name__ == "__main__":
    main()
