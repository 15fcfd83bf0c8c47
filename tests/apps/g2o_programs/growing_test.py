#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""growing_test.py FOLDER: tests g2o_incremental and g2o_online."""

import os
import stat
import subprocess

from program_case import FOLDER, ProgramCase, final_chi2, main, run

INFORMATION = "10 0 0 10 0 40"
POSES = ["0 0 0", "1.1 0.1 1.57", "0.9 1.2 3.1", "-0.1 0.9 -1.6"]
EDGES = [(0, 1, "1 0 1.57"), (1, 2, "1.02 0 1.57"), (2, 3, "1.01 0 1.57"), (3, 0, "1 0 1.57")]
SQUARE = "".join(f"VERTEX_SE2 {k} {pose}\n" for k, pose in enumerate(POSES)) + \
    "".join(f"EDGE_SE2 {a} {b} {z} {INFORMATION}\n" for a, b, z in EDGES)
COMMANDS = "ADD VERTEX_XYT 0 0 0 0;\nFIX 0;\n" + "".join(
    f"ADD EDGE_XYT {k} {a} {b} {z} {INFORMATION};\n" for k, (a, b, z) in enumerate(EDGES))
BEST = 0.001277098  # chi2 of the square without its landmark

class SwitchesTest(ProgramCase):
    def test_the_help_lists_all_switches(self):
        self.assert_switches("g2o_incremental", ["batch", "update", "v", "g", "o", "i"])
        self.assert_switches("g2o_online", ["update", "pcg", "v", "g"])

    def test_wrong_arguments_are_refused(self):
        self.assert_refused(run("g2o_incremental", "-update", 0), 1, "parameter -update: expected an integer from 1")
        self.assert_refused(run("g2o_online", "-update", "x"), 1, "parameter -update: expected an integer, got 'x'")
        self.assert_refused(run("g2o_online", "-nonsense"), 1, "unknown parameter: -nonsense")
        self.assert_refused(run("g2o_online", "file"), 1, "too many arguments: file")
        self.assert_refused(run("g2o_incremental", "-i", self.path / "none.g2o"), 1, "none.g2o")
        self.assert_refused(run("g2o_incremental", "-o", self.path / "no_folder" / "x.g2o"), 1, "no_folder")

class ProtocolTest(ProgramCase):
    def test_a_conversation_is_answered_while_it_lasts(self):
        for program in ("g2o_incremental", "g2o_online"):
            with subprocess.Popen([FOLDER / program, "-update", "1"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as process:
                process.stdin.write("ADD VERTEX_XYT 4 1 2 0.5; QUERY_STATE;")
                process.stdin.flush()
                answer = [process.stdout.readline() for _ in range(3)]
                self.assertEqual(answer, ["BEGIN\n", "VERTEX_XYT 4 1 2 0.5\n", "END\n"])
                process.stdin.write("ADD EDGE_XYT 4 5 1 0 0 1 0 0 1 0 1; SOLVE_STATE; QUERY_STATE 5;")
                process.stdin.flush()
                answer = [process.stdout.readline() for _ in range(3)]
                x, y, angle = map(float, answer[1].split()[2:])
                self.assertAlmostEqual(x, 1 + 0.8775825618903728)
                self.assertAlmostEqual(y, 2 + 0.479425538604203)
                self.assertAlmostEqual(angle, 0.5)
                process.stdin.close()
                self.assertEqual(process.wait(timeout=60), 0)

    def test_the_end_of_the_input_gives_the_optimum(self):
        for program, arguments in (("g2o_incremental", []), ("g2o_online", []), ("g2o_online", ["-pcg"])):
            done = run(program, *arguments, stdin=COMMANDS)
            self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
            self.assertIn("# 4 vertices, 4 edges\n", done.stderr)
            self.assertAlmostEqual(final_chi2(done), BEST, delta=1e-6)

    def test_an_input_without_commands_is_an_empty_graph(self):
        done = run("g2o_online", stdin=" # nothing\n;")
        self.assertEqual(done.returncode, 0)
        self.assertIn("# 0 vertices, 0 edges\n", done.stderr)

    def test_errors_name_line_and_column(self):
        for program in ("g2o_incremental", "g2o_online"):
            done = run(program, stdin=COMMANDS + "ADD VERTEX_XYT 0;")
            self.assert_refused(done, 2, f"{program}: <stdin>:7:16: expected a new id, but vertex 0 is already there\n")
        self.assert_refused(run("g2o_online", stdin="\x1b[2J 1;"), 2, r"<stdin>:1:1: expected ADD", r"got '\x1b[2J'")
        self.assert_refused(run("g2o_online", stdin="SOLVE_STATE"), 2, "<stdin>:1:12: expected a ; after the command")

    def test_a_full_standard_error_does_not_end_it(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            process = subprocess.run([FOLDER / "g2o_online"], input=COMMANDS, stdout=subprocess.PIPE, stderr=full, text=True,
                                     check=False)
        self.assertEqual(process.returncode, 0)

    def test_after_an_error_nothing_is_written(self):
        output = self.path / "out.g2o"
        self.assert_refused(run("g2o_incremental", "-o", output, stdin=COMMANDS + "FIX 9;"), 2, "there is no vertex 9")
        self.assertFalse(output.exists())

    def test_the_graph_of_the_protocol_is_written(self):
        output = self.path / "out.g2o"
        self.assertEqual(run("g2o_incremental", "-o", output, stdin=COMMANDS).returncode, 0)
        lines = output.read_text(encoding="utf-8").splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["VERTEX_SE2", "FIX"] + 3 * ["VERTEX_SE2"] + 4 * ["EDGE_SE2"])
        self.assertEqual(lines[0], "VERTEX_SE2 0 0 0 0")

class FileTest(ProgramCase):
    def test_a_file_is_fed_step_by_step(self):
        graph = self.written("square.g2o", SQUARE)
        done = run("g2o_incremental", "-i", graph, "-update", 1, "-v")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertAlmostEqual(final_chi2(done), BEST, delta=1e-6)
        updates = [line for line in done.stderr.splitlines() if line.startswith("update")]
        self.assertEqual([line.split("vertices= ")[1].split()[0] for line in updates], ["2", "3", "4"])
        done = run("g2o_incremental", "-i", graph, "-batch", 2, "-v")
        self.assertEqual(sum(line.startswith("batch") for line in done.stderr.splitlines()), 3)

    def test_the_result_keeps_what_the_file_has(self):
        text = "# a comment\n" + SQUARE + "UNKNOWN 1 2 3\n"
        done = run("g2o_incremental", "-i", self.written("square.g2o", text), "-o", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["#"] + 4 * ["VERTEX_SE2"] + 4 * ["EDGE_SE2"] + ["UNKNOWN"])
        self.assertEqual(lines[5:], text.splitlines()[5:])
        again = run("g2o_incremental", "-i", self.written("again.g2o", done.stdout))
        self.assertAlmostEqual(final_chi2(again), BEST, delta=1e-6)

    def test_a_malformed_file_is_refused(self):
        graph = self.written("bad.g2o", SQUARE + "EDGE_SE2 0 1 x\n")
        self.assert_refused(run("g2o_incremental", "-i", graph, "-o", "-"), 2, "bad.g2o:9:14: expected")
        self.assert_refused(run("g2o_incremental", "-i", self.written("empty.g2o", "\n")), 2, "empty.g2o:")

class GnuplotTest(ProgramCase):
    def test_gnuplot_gets_a_picture_per_optimization(self):
        program = self.written("gnuplot", f"#!/bin/sh\ncat > {self.path}/drawn\n")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        path = {**os.environ, "PATH": f"{self.path}:{os.environ['PATH']}"}
        done = run("g2o_incremental", "-i", self.written("square.g2o", SQUARE), "-update", 2, "-g", environment=path)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawn = (self.path / "drawn").read_text(encoding="utf-8")
        self.assertEqual(drawn.count("plot \"-\""), 3)  # two updates, and the end
        self.assertIn("4 edges", drawn)

    def test_without_gnuplot_the_program_only_says_so(self):
        (self.path / "bin").mkdir()
        os.symlink("/bin/sh", self.path / "bin" / "sh")
        done = run("g2o_incremental", "-i", self.written("square.g2o", SQUARE), "-update", 1, "-g",
                   environment={**os.environ, "PATH": str(self.path / "bin")})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(final_chi2(done), BEST, delta=1e-6)

if __name__ == "__main__":
    main()
