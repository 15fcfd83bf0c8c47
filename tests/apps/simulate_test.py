#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus simulate`, which makes graphs whose true estimates are known."""

import json
import re

from command_case import CommandCase, choices, main, run

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
        worlds = choices("simulate", "WORLD")
        self.assertIn("sphere", worlds)
        worlds.remove("ba")
        for world in worlds:
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

    def test_writes_to_standard_output(self):
        done = run("simulate", "sphere", "--poses", 25, "-o", "-")
        run("simulate", "sphere", "--poses", 25, "-o", self.path / "s.g2o")
        self.assertEqual(done.stdout, (self.path / "s.g2o").read_text(encoding="utf-8"))
        self.assertIn("25 vertices", done.stderr)

    def simulate_ba(self, name, *options):
        return run("simulate", "ba", "--cameras", 30, "--points", 800, "-o", self.path / name, *options)

    def test_each_shape_of_bundle_adjustment_is_in_the_help_and_optimized_to_the_noise(self):
        text = run("simulate", "--help").stdout
        shapes = choices("simulate", "--shape")
        self.assertIn("ring", shapes)
        for shape in shapes:
            self.assertIn(f"--shape {shape}: ", text)
            done = self.simulate_ba("before.bal", "--shape", shape, "--truth", self.path / "truth.bal")
            found = re.fullmatch(r".*before\.bal: 30 cameras, 800 points, (\d+) observations, (\S+) per point; "
                                 r"chi2 is \S+, and (\S+) at the truth\n", done.stdout)
            self.assertIsNotNone(found, done.stdout)
            observations = int(found.group(1))
            self.assertAlmostEqual(float(found.group(2)), observations / 800, 2)
            self.assertAlmostEqual(float(found.group(3)) / (2 * observations), 1, delta=0.08)
            lines = (self.path / "before.bal").read_text(encoding="utf-8").splitlines()
            self.assertEqual((lines[0], len(lines)), (f"30 800 {observations}", 1 + observations + 9 * 30 + 3 * 800))
            done = run("optimize", self.path / "before.bal", "-o", self.path / "after.bal", "--json", "-")
            freedom = 2 * observations - (9 * 30 + 3 * 800 - 7)
            self.assertAlmostEqual(json.loads(done.stdout)["chi2_final"] / freedom, 1, delta=0.11)
            done = run("compare", self.path / "after.bal", self.path / "truth.bal", "--scale", "--json", "-")
            facts = json.loads(done.stdout)
            self.assertEqual(facts["matched"], 30)
            self.assertLess(facts["rpe"]["rotation_rad"]["max"], 0.02)

    def test_the_same_arguments_give_the_same_bytes_of_bundle_adjustment(self):
        for name, seed in (("a.bal", 4), ("b.txt", 4), ("c.bal", 5)):
            self.assertEqual(self.simulate_ba(name, "--seed", seed).returncode, 0)
        a, b, c = ((self.path / name).read_bytes() for name in ("a.bal", "b.txt", "c.bal"))
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)

    def test_the_truth_of_bundle_adjustment_has_the_same_observations(self):
        self.simulate_ba("a.bal", "--truth", self.path / "truth.bal", "--outliers", 0.1, "--noise", 0.5)
        a, truth = ((self.path / name).read_text(encoding="utf-8").splitlines() for name in ("a.bal", "truth.bal"))
        observations = int(a[0].split()[2])
        self.assertEqual(a[:1 + observations], truth[:1 + observations])
        self.assertFalse(set(a[1 + observations:]) & set(truth[1 + observations:]))

    def test_without_noise_bundle_adjustment_starts_at_the_truth(self):
        done = self.simulate_ba("a.bal", "--noise", 0, "--pose-noise", 0, "--point-noise", 0, "--intrinsics-noise", 0)
        found = re.search(r"chi2 is (\S+), and (\S+) at the truth", done.stdout)
        self.assertLess(max(map(float, found.groups())), 1e-12)

    def test_bundle_adjustment_refuses_formats_that_cannot_represent_it(self):
        for outputs in (["-o", self.path / "x.g2o"], ["-o", self.path / "x.bal", "--truth", self.path / "t.g2o"]):
            done = run("simulate", "ba", "--cameras", 3, "--points", 10, *outputs)
            self.assert_refused(done, "Product<SE3, BAL>")
            self.assertEqual(list(self.path.iterdir()), [])

    def test_bundle_adjustment_can_be_written_as_a_model_of_colmap(self):
        self.assertEqual(self.simulate_ba("a.bal").returncode, 0)
        done = run("simulate", "ba", "--cameras", 30, "--points", 800, "-o", f"{self.path}/model/")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        facts = [json.loads(run("info", self.path / name, "--json", "-").stdout) for name in ("a.bal", "model")]
        for fact in ("edges", "chi2"):
            self.assertAlmostEqual(facts[0][fact] / facts[1][fact], 1, places=9)

    def test_options_of_other_worlds_are_refused(self):
        out = self.path / "x"
        self.assert_refused(run("simulate", "ba", "--poses", 30, "-o", out),
                            "--poses: expected this option only with worlds other than ba, which has --cameras")
        for option in ("--cameras", "--points", "--track-length", "--pose-noise", "--point-noise", "--intrinsics-noise"):
            self.assert_refused(run("simulate", "sphere", option, 3, "-o", out), f"{option}: expected this option only with the world ba")
        self.assert_refused(run("simulate", "city", "--shape", "city", "-o", out), "--shape: expected")
        self.assertFalse(out.exists())

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
                            (["ba", "--shape", "moon"], "moon"),
                            (["ba", "--cameras", "0"], "a whole number from 2 to 10000000, got '0'"),
                            (["ba", "--points", "0"], "a whole number from 1 to 100000000, got '0'"),
                            (["ba", "--track-length", "1"], "a number from 2 to 1000, got '1'"),
                            (["ba", "--outliers", "1.5"], "a number from 0 to 1, got '1.5'"),
                            (["ba", "--point-noise", "-1"], "a number from 0 to 1000, got '-1'"),
                            (["sphere", "--truth", out], "two different files")):
            done = run("simulate", *words, "-o", out)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(text, done.stderr)
            self.assertFalse(out.exists())
        done = run("simulate", "grid", "-o", self.path / "no" / "x.g2o")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("cannot be written", done.stderr)

class RobotTest(CommandCase):
    SENSORS = {"robot2d": ("points", "bearings", "poses", "compass", "gps", "segments"),
               "robot3d": ("points", "depth", "disparity", "poses", "compass", "gps")}

    def simulated(self, world, *options):
        done = run("simulate", world, "--poses", 150, "--world-size", 15, "-o", self.path / "g.g2o", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return words_of(self.path / "g.g2o")

    def test_each_sensor_adds_measurements(self):
        for world, sensors in self.SENSORS.items():
            help_text = " ".join(run("simulate", "--help").stdout.split())
            alone = sum(self.simulated(world, "--sensors", "gps", "--landmarks", 0).values())
            for sensor in sensors:
                self.assertIn(sensor, help_text)
                if sensor != "gps":
                    self.assertGreater(sum(self.simulated(world, "--sensors", f"gps,{sensor}").values()), alone + 10)
            counts = self.simulated(world, "--sensors", ",".join(sensors))
            self.assertEqual(run("optimize", self.path / "g.g2o", "-q").returncode, 0)
            self.assertGreater(len(counts), 8)

    def test_options_are_refused_where_they_do_not_apply(self):
        out = self.path / "x.g2o"
        self.assert_refused(run("simulate", "sphere", "--sensors", "gps", "-o", out),
                            "--sensors: expected this option only with the worlds robot2d and robot3d")
        self.assert_refused(run("simulate", "ba", "--landmarks", 3, "-o", out), "--landmarks: expected this option only")
        self.assert_refused(run("simulate", "robot2d", "--cameras", 3, "-o", out), "--cameras: expected this option only")
        self.assert_refused(run("simulate", "robot2d", "--sensors", "gps,depth", "-o", out),
                            "--sensors: expected sensors of this robot (points, bearings, poses, compass, gps, segments), got 'depth'")
        self.assertFalse(out.exists())

if __name__ == "__main__":
    main()
