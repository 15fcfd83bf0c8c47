#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests boxplus-mpi: command_test.py BOXPLUS DATA_FOLDER BOXPLUS_MPI MPIRUN ..."""

import json
import os
import pathlib
import signal
import subprocess
import sys

from command_case import CommandCase, main, run

BOXPLUS_MPI, MPIRUN = sys.argv[3], sys.argv[4:]

def messages(text):
    """The lines of the command; mpirun adds lines of its own if the exit code is not 0."""
    return [line for line in text.splitlines() if line.startswith("boxplus: ")]

class MpiCommandTest(CommandCase):
    def run_mpi(self, processes, *arguments):
        words = [*MPIRUN, "-n", str(processes), BOXPLUS_MPI, *map(str, arguments)]
        return subprocess.run(words, capture_output=True, encoding="utf-8", check=False, timeout=100)

    def simulated(self, name, *arguments):
        path = self.path / name
        self.assertEqual(run("simulate", *arguments, "-o", path).returncode, 0)
        return path

    def report_of(self, processes, graph, *arguments):
        done = self.run_mpi(processes, "optimize", graph, "--quiet", "--json", self.path / "report.json", *arguments)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        return json.loads((self.path / "report.json").read_text(encoding="utf-8"))

    def assert_same_optimum(self, graph, *arguments, numbers=(1, 2, 3, 4), in_all=(), repeats=True):
        """Compares with one process. `in_all` are arguments for several processes only. If `repeats`, two runs have the
        same chi2 to the last digit."""
        run("optimize", graph, "--quiet", "--json", self.path / "one.json", *arguments)
        expected = json.loads((self.path / "one.json").read_text(encoding="utf-8"))
        for processes in numbers:
            report = self.report_of(processes, graph, *arguments, *in_all)
            self.assertAlmostEqual(report["chi2_final"] / expected["chi2_final"], 1, delta=1e-9)
            for same in ("edges", "rows", "scalars", "degrees_of_freedom", "gauge", "kernel"):
                self.assertEqual(report[same], expected[same])
            self.assertEqual(report["distribution"]["processes"], processes)
            self.assertEqual(sum(report["distribution"]["edges_per_process"]), expected["edges"])
        if repeats:
            again = self.report_of(numbers[-1], graph, *arguments, *in_all)
            self.assertEqual(again["chi2_final"], report["chi2_final"])

    def test_reaches_the_optimum_of_one_process_on_a_street(self):
        street = self.simulated("street.bal", "ba", "--shape", "street", "--cameras", 40, "--points", 1000)
        self.assert_same_optimum(street)
        self.assert_same_optimum(street, "--kernel", "Huber")
        for arguments in (("--hold", "intrinsics"), ("--hold", "points"), ("--fix", "0,3"), ("--pixel-sigma", 2)):
            self.assert_same_optimum(street, *arguments, numbers=(3,))

    def test_counts_points_that_one_camera_sees_as_one_process_does(self):
        street = self.simulated("street.bal", "ba", "--shape", "street", "--cameras", 20, "--points", 300)
        header, *lines = street.read_text(encoding="utf-8").splitlines()
        cameras, points, count = map(int, header.split())
        seen, kept = set(), []
        for line in lines[:count]:
            point = int(line.split()[1])
            if point % 3 != 0 or point not in seen:  # every third point only once
                kept.append(line)
            seen.add(point)
        once = self.path / "once.bal"
        once.write_text("\n".join([f"{cameras} {points} {len(kept)}", *kept, *lines[count:]]) + "\n", encoding="utf-8")
        determined = 9 * cameras - 7 + 3 * points - len({point for point in seen if point % 3 == 0})
        self.assert_same_optimum(once)
        report = json.loads((self.path / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(report["degrees_of_freedom"], report["rows"] - determined)

    def test_reaches_the_optimum_of_one_process_on_a_model_of_colmap(self):
        (self.path / "model").mkdir()
        model = self.simulated("model", "ba", "--shape", "street", "--cameras", 40, "--points", 1000)
        self.assert_same_optimum(model)
        self.assert_same_optimum(model, "--kernel", "Huber", "--hold", "intrinsics", numbers=(3,))
        text = self.path / "text"
        self.assertEqual(run("convert", model, text, "--format", "colmap-text").returncode, 0)
        self.assert_same_optimum(text, numbers=(2,))
        output = self.path / "optimized"
        report = self.report_of(3, model, "-o", f"{output}/")
        again = run("optimize", output, "--iterations", 0, "--quiet", "--json", "-")
        self.assertAlmostEqual(json.loads(again.stdout)["chi2_final"] / report["chi2_final"], 1, delta=1e-9)

    def test_reaches_the_optimum_of_one_process_on_a_sphere(self):
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 400)
        self.assert_same_optimum(sphere)
        self.assert_same_optimum(sphere, "--start", "odometry", "--kernel", "Huber")

    def require_petsc(self):
        done = self.run_mpi(1, "optimize", self.simulated("tiny.g2o", "sphere", "--poses", 20), "--quiet", "--petsc", "")
        if "built without PETSc" in done.stderr:
            self.skipTest("PETSc is not installed")

    def test_reaches_the_optimum_of_one_process_if_petsc_divides_the_system(self):
        self.require_petsc()
        street = self.simulated("street.bal", "ba", "--shape", "street", "--cameras", 40, "--points", 1000)
        for arguments in ((), ("--kernel", "Huber"), ("--hold", "intrinsics"), ("--fix", "0,3")):
            self.assert_same_optimum(street, *arguments, numbers=(1, 3), in_all=("--petsc", ""), repeats=False)
        self.assert_same_optimum(street, numbers=(2, 4), in_all=("--petsc", "-ksp_type cg"))
        landmarks = self.simulated("landmarks.g2o", "robot2d", "--poses", 200)  # blocks of different sizes
        for options in ("", "-ksp_type cg"):
            self.assert_same_optimum(landmarks, numbers=(3,), in_all=("--petsc", options), repeats=False)

    def test_has_no_limit_of_kept_vertices_if_petsc_divides_the_system(self):
        self.require_petsc()
        town = self.simulated("town.g2o", "manhattan", "--poses", 21000)
        refused = self.run_mpi(2, "optimize", town)
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("expected at most 20000 vertices that are not eliminated", messages(refused.stderr)[0])
        self.assert_same_optimum(town, numbers=(2,), in_all=("--petsc", ""), repeats=False)

    def test_does_not_start_petsc_if_only_one_process_fails_before(self):
        self.require_petsc()
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 100)
        done = self.run_mpi(2, "optimize", sphere, "--petsc", "", "-o", self.path / "missing" / "x.g2o")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(messages(done.stderr)), 1, done.stderr)

    def test_ends_if_petsc_refuses_an_option_or_a_system(self):
        self.require_petsc()
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 100)
        loose = self.written("loose.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\nFIX 0\n"
                             "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 2 1 0 0 1 0 0 0 0 0\n")
        for graph, options, code, text in ((sphere, "-ksp_type nonsense", 2, "nonsense"), (sphere, "-foo 1", 2, "-foo"),
                                           (sphere, "-mat_block_size 2", 2, "-mat_block_size"),
                                           (sphere, "-mat_mumps_icntl_23 1", 2, "INFOG(1)"), (loose, "", 0, None)):
            done = self.run_mpi(2, "optimize", graph, "--quiet", "--petsc", options)
            self.assertEqual(done.returncode, code, done.stderr)
            if text is not None:
                self.assertIn(text, messages(done.stderr)[0])

    def test_writes_the_graph_of_all_processes(self):
        for graph in (self.simulated("street.bal", "ba", "--cameras", 20, "--points", 300),
                      self.simulated("torus.g2o", "torus", "--poses", 300)):
            output = self.path / ("optimized" + graph.suffix)
            report = self.report_of(3, graph, "-o", output)
            again = run("optimize", output, "--iterations", 0, "--quiet", "--json", "-")
            self.assertAlmostEqual(json.loads(again.stdout)["chi2_final"] / report["chi2_final"], 1, delta=1e-9)

    def test_finds_the_gauge_freedom_of_each_component(self):
        street = self.simulated("street.bal", "ba", "--cameras", 10, "--points", 200)
        twice = self.twice(street)
        self.assert_same_optimum(twice, numbers=(2, 4))
        self.assert_same_optimum(twice, "--hold", "intrinsics", numbers=(2, 3))
        model = self.path / "model"
        self.assertEqual(run("convert", twice, model, "--format", "colmap").returncode, 0)
        self.assert_same_optimum(model, "--hold", "intrinsics", numbers=(2, 3))

    def twice(self, path):
        """A BAL problem of two copies of a problem that share nothing."""
        cameras, points, edges, *rest = path.read_text(encoding="utf-8").split()
        cameras, points, edges = int(cameras), int(points), int(edges)
        observations, values = rest[:4 * edges], rest[4 * edges:]
        lines = [f"{2 * cameras} {2 * points} {2 * edges}"]
        for copy in (0, 1):
            for k in range(0, len(observations), 4):
                camera, point, *pixel = observations[k:k + 4]
                lines.append(f"{int(camera) + copy * cameras} {int(point) + copy * points} {' '.join(pixel)}")
        lines += 2 * values[:9 * cameras] + 2 * values[9 * cameras:]
        return self.written("twice.bal", "\n".join(lines) + "\n")

    def test_holds_a_part_of_a_bal_problem_or_a_model_of_colmap_in_each_process(self):
        tiny = self.simulated("tiny.bal", "ba", "--cameras", 8, "--points", 100)
        street = self.simulated("street.bal", "ba", "--cameras", 100, "--points", 60000)
        (self.path / "model").mkdir()
        model = self.simulated("model", "ba", "--cameras", 100, "--points", 60000)
        def memory(processes, graph, *arguments):
            return max(self.report_of(processes, graph, *arguments)["distribution"]["peak_bytes_per_process"])
        for graph in (street, model):
            of_one, of_four = (memory(n, graph) - memory(n, tiny) for n in (1, 4))
            self.assertLess(of_four, 0.35 * of_one)
        of_writer = memory(4, street, "-o", self.path / "optimized.bal") - memory(4, tiny)
        self.assertLess(of_writer, 0.35 * (memory(1, street) - memory(1, tiny)))

    def test_goes_on_from_a_checkpoint(self):
        checkpoint = self.path / "checkpoint"
        for graph, start in ((self.simulated("street.bal", "ba", "--cameras", 40, "--points", 1000), ()),
                             (self.simulated("sphere.g2o", "sphere", "--poses", 400), ("--start", "odometry"))):
            expected = self.report_of(3, graph, *start)
            stopped = self.run_mpi(3, "optimize", graph, "--quiet", "--json", self.path / "stopped.json", *start,
                                   "--iterations", 3, "--checkpoint", checkpoint, "--checkpoint-every", 2)
            self.assertEqual(stopped.returncode, 1, stopped.stderr)
            reached = json.loads((self.path / "stopped.json").read_text(encoding="utf-8"))["chi2_final"]
            output = self.path / ("optimized" + graph.suffix)
            for processes in (1, 3):
                report = self.report_of(processes, graph, "--restart", checkpoint, "-o", output)
                self.assertAlmostEqual(report["chi2_initial"] / reached, 1, delta=1e-9)
                self.assertAlmostEqual(report["chi2_final"] / expected["chi2_final"], 1, delta=1e-9)
                again = run("optimize", output, "--iterations", 0, "--quiet", "--json", "-")
                self.assertAlmostEqual(json.loads(again.stdout)["chi2_final"] / report["chi2_final"], 1, delta=1e-9)

    def test_leaves_the_last_checkpoint_if_a_process_is_killed(self):
        street = self.simulated("street.bal", "ba", "--cameras", 100, "--points", 60000)
        checkpoint = self.path / "checkpoint"
        words = [*MPIRUN, "-n", "3", BOXPLUS_MPI, "optimize", str(street), "--verbose",
                 "--checkpoint", str(checkpoint), "--checkpoint-every", "1"]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8") as start:
            lines = [start.stderr.readline() for _ in range(2)]
            self.assertIn("iteration   2", lines[-1])
            os.kill(self.children(start.pid)[-1], signal.SIGKILL)
            _, messages = start.communicate(timeout=20)
        self.assertNotEqual(start.returncode, 0)
        self.assertIn("signal 9", messages)
        self.assertLessEqual(self.report_of(2, street, "--restart", checkpoint)["chi2_initial"], 1.001 * float(lines[0].split()[3]))

    def children(self, parent):
        """The processes that a process has started, and that still run."""
        def parent_of(process):
            try:
                return int(process.joinpath("stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
            except OSError:  # it has ended
                return None
        return sorted(int(process.name) for process in pathlib.Path("/proc").glob("[0-9]*") if parent_of(process) == parent)

    def test_prints_the_report_once(self):
        done = self.run_mpi(2, "optimize", self.simulated("sphere.g2o", "sphere", "--poses", 100))
        self.assertEqual((done.returncode, done.stdout.count("converged: chi2"), done.stderr), (0, 1, ""))
        self.assertIn("2 processes shared the problem", done.stdout)

    def test_ends_with_one_message_and_the_same_exit_code_as_one_process(self):
        broken = self.written("broken.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0\n")
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 100)
        for arguments, text in ((("optimize", broken), "broken.g2o:2"),
                                (("optimize", sphere, "--checkpoint", "/dev/full"), "/dev/full"),
                                (("optimize", sphere, "--restart", sphere), "expected a checkpoint of this problem"),
                                (("optimize", self.path / "missing.g2o"), "missing.g2o"),
                                (("optimize", broken, "--certify"), "--certify"),
                                (("optimize",), "FILE")):
            done = self.run_mpi(2, *arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(len(messages(done.stderr)), 1, done.stderr)
            self.assertIn(text, messages(done.stderr)[0])

    def test_ends_with_code_1_if_the_run_has_not_converged(self):
        done = self.run_mpi(2, "optimize", self.simulated("sphere.g2o", "sphere", "--poses", 100), "--iterations", 1, "-q")
        self.assertEqual((done.returncode, len(messages(done.stderr))), (1, 1), done.stderr)

    def test_refuses_arguments_that_differ_between_processes(self):
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 100)
        command = [BOXPLUS_MPI, "optimize", str(sphere), "--quiet", "--iterations"]
        words = [*MPIRUN, "-n", "1", *command, "10", ":", "-n", "1", *command, "20"]
        done = subprocess.run(words, capture_output=True, encoding="utf-8", check=False, timeout=100)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(messages(done.stderr)), 1, done.stderr)
        self.assertIn("the arguments differ between processes", done.stderr)

    def test_does_not_hang_if_only_one_process_finds_the_file(self):
        sphere = self.simulated("sphere.g2o", "sphere", "--poses", 100)
        (self.path / "a").mkdir()
        (self.path / "b").mkdir()
        (self.path / "a" / "graph.g2o").write_bytes(sphere.read_bytes())
        command = [BOXPLUS_MPI, "optimize", "graph.g2o", "--quiet"]
        words = [*MPIRUN, "-n", "1", "-wdir", str(self.path / "a"), *command, ":", "-n", "1", "-wdir", str(self.path / "b"), *command]
        done = subprocess.run(words, capture_output=True, encoding="utf-8", check=False, timeout=100)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(messages(done.stderr)), 1, done.stderr)
        self.assertIn("graph.g2o", messages(done.stderr)[0])

if __name__ == "__main__":
    main()
