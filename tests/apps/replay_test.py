#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus replay`, which optimizes a graph step by step."""

import json
import signal
import subprocess

from command_case import BOXPLUS, CommandCase, main, run

class ReplayTest(CommandCase):
    def simulated(self, world, *options):
        path = self.path / (world + ".g2o")
        done = run("simulate", world, "-o", path, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def replayed(self, path, *options):
        done = run("replay", path, "--json", "-", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def optimized(self, path, *options):
        return json.loads(run("optimize", path, "--json", "-", *options).stdout)

    def test_the_last_step_ends_at_the_optimum(self):
        for world in "manhattan", "sphere", "city":
            path = self.simulated(world, "--poses", "200")
            facts = self.replayed(path)
            self.assertTrue(facts["converged"])
            expected = self.optimized(path)["chi2_final"]
            self.assertLess(abs(facts["chi2_final"] - expected), 1e-6 * expected, world)
            times = facts["time_s"]
            self.assertGreaterEqual(times["total"], times["worst"])
            self.assertGreaterEqual(times["worst"], times["median"])

    def test_each_step_is_near_the_optimum_of_the_graph_so_far(self):
        facts = self.replayed(self.simulated("manhattan", "--poses", "300"), "--compare-every", "50")
        self.assertEqual([step["step"] for step in facts["compared"]], [50, 100, 150, 200, 250, 300])
        for step in facts["compared"]:
            self.assertLess(step["chi2"], 1.01 * step["chi2_optimum"] + 1e-9)

    def test_the_estimates_of_the_file_do_not_matter(self):
        path = self.simulated("manhattan", "--poses", "100")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines(keepends=True)
        moved = [f"VERTEX_SE2 {line.split()[1]} 0 0 0\n" if line.startswith("VERTEX_SE2") and line.split()[1] != "0" else line
                 for line in lines]
        other = self.written("moved.g2o", "".join(moved))
        a, b = self.replayed(path)["chi2_final"], self.replayed(other)["chi2_final"]
        self.assertLess(abs(a - b), 1e-6 * a)

    def test_false_closures_are_set_aside(self):
        path = self.simulated("manhattan", "--poses", "300", "--outliers", "0.3", "--seed", "2")
        facts = self.replayed(path, "--outliers")
        expected = self.optimized(path, "--outliers", "loop-closures")["chi2_final"]
        self.assertGreater(facts["set_aside"], 3)
        self.assertLess(abs(facts["chi2_final"] - expected), 1e-3 * expected)

    def test_files_get_the_result_and_the_time_of_each_step(self):
        path = self.simulated("manhattan", "--poses", "100")
        out, times = (self.path / name for name in ("out.g2o", "times.csv"))
        done = run("replay", path, "-o", out, "--times", times, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        with open(times, encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[0], "step,seconds")
        self.assertEqual(len(lines), 101)
        self.assertLess(self.optimized(out)["iterations"], 4)

    def test_a_picture_shows_the_time_of_each_step(self):
        path = self.simulated("manhattan", "--poses", "100")
        for name, begin in ("chart.svg", b"<svg"), ("chart.png", b"\x89PNG"):
            chart = self.path / name
            self.assertEqual(run("replay", path, "--plot", chart).returncode, 0)
            with open(chart, "rb") as file:
                self.assertIn(begin, file.read(200))

    def test_two_replays_have_the_same_bits(self):
        path = self.simulated("sphere", "--poses", "150")
        outs = [self.path / name for name in ("a.g2o", "b.g2o")]
        for out in outs:
            self.assertEqual(run("replay", path, "-o", out).returncode, 0)
        texts = []
        for out in outs:
            with open(out, "rb") as file:
                texts.append(file.read())
        self.assertEqual(texts[0], texts[1])

    def commands_of(self, path):
        """The commands with which a robot would send the edges of a file, pose by pose."""
        with open(path, encoding="utf-8") as file:
            edges = [line.split()[1:] for line in file if line.startswith("EDGE_SE2")]
        edges.sort(key=lambda fields: max(map(int, fields[:2])))
        last, commands = 0, []
        for fields in edges:
            newest = max(map(int, fields[:2]))
            if newest != last:
                commands.append("SOLVE_STATE;")
            last = newest
            commands.append(f"ADD EDGE_XYT {' '.join(fields)};")
        return [*commands, "SOLVE_STATE;", "QUERY_STATE 0 99;"]

    def test_a_robot_can_send_its_graph_online(self):
        path = self.simulated("manhattan", "--poses", "100")
        out, report = self.path / "out.g2o", self.path / "report.json"
        done = run("replay", "--online", "-o", out, "--json", report, stdin="\n".join(self.commands_of(path)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\ABEGIN\nVERTEX_XYT 0 0 0 0\nVERTEX_XYT 99 \S+ \S+ \S+\nEND\n\Z")
        with open(report, encoding="utf-8") as file:
            facts = json.load(file)
        expected = self.replayed(path)
        self.assertEqual((facts["steps"], facts["edges"]), (100, expected["edges"]))
        self.assertLess(abs(facts["chi2_final"] - expected["chi2_final"]), 1e-6 * expected["chi2_final"])
        self.assertLess(self.optimized(out)["iterations"], 4)

    def test_a_wrong_command_is_named_and_the_map_so_far_is_written(self):
        out = self.path / "out.g2o"
        done = run("replay", "--online", "-o", out, stdin="ADD EDGE_XYT 1 2 1 0 0 1 0 0 1 0 1;\nADD EDGE_XYT 1 1 x;")
        self.assertEqual(done.returncode, 2)
        self.assertIn("<stdin>:2:", done.stderr)
        self.assertEqual(out.read_text().count("VERTEX_SE2"), 2)

    def test_an_interrupted_robot_leaves_its_map(self):
        out, report = self.path / "out.g2o", self.path / "report.json"
        process = subprocess.Popen([BOXPLUS, "replay", "--online", "-o", out, "--json", report], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        process.stdin.write("ADD EDGE_XYT 1 2 1 0 0 1 0 0 1 0 1; SOLVE_STATE; QUERY_STATE 1; ADD VERTEX_XYT")
        process.stdin.flush()
        self.assertEqual(process.stdout.readline(), "BEGIN\n")
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 1)
        process.stdin.close()
        process.stdout.close()
        process.stderr.close()
        facts = json.loads(report.read_text())
        self.assertEqual((facts["converged"], facts["reason"]), (False, "interrupted"))
        self.assertTrue(out.exists())

    def test_the_format_of_an_online_map_is_checked_before_the_drive(self):
        self.assertEqual(run("replay", "--online", "-o", self.path / "map.ply", stdin="").returncode, 2)
        done = run("replay", "--online", "-o", self.path / "map.ply", stdin="ADD EDGE_XYT 1 2 1 0 0 1 0 0 1 0 1;")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run("replay", "--online", "-o", self.path / "map.bal", stdin="").returncode, 2)
        self.assertEqual(run("replay", "--online", "--lenient", stdin="").returncode, 2)

    def test_answers_and_the_report_cannot_share_standard_output(self):
        self.assertEqual(run("replay", "--online", "--json", "-").returncode, 2)
        self.assertEqual(run("replay", "--online", self.simulated("manhattan", "--poses", "20")).returncode, 2)
        self.assertEqual(run("replay").returncode, 2)

    def test_bad_input_is_refused(self):
        self.assertEqual(run("replay", self.path / "missing.g2o").returncode, 2)
        path = self.simulated("manhattan", "--poses", "20")
        self.assertEqual(run("replay", path, "--max-iterations", "0").returncode, 2)
        self.assertEqual(run("replay", path, "--times", path).returncode, 2)

if __name__ == "__main__":
    main()
