#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus optimize`: options, outputs, exit codes, progress and Ctrl-C."""

import json
import os
import pty
import signal
import subprocess
import time

from command_case import BOXPLUS, TOWN, CommandCase, choices, main, run

def estimates(text):
    """The estimates in the vertex lines of a graph, by id."""
    lines = (line.split() for line in text.splitlines())
    return {int(words[1]): words[2:] for words in lines if words[0].startswith("VERTEX")}

class OptimizeTest(CommandCase):
    def report_of(self, *arguments, code=0):
        done = run("optimize", *arguments, "--quiet", "--json", self.path / "report.json")
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        return json.loads((self.path / "report.json").read_text(encoding="utf-8"))

    def simulated(self, world, poses):
        graph = self.path / f"{world}.g2o"
        self.assertEqual(run("simulate", world, "--poses", poses, "-o", graph).returncode, 0)
        return graph

    def test_needs_no_option(self):
        done = run("optimize", TOWN)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("converged: chi2", done.stdout)
        self.assertIn("not written (use -o FILE)", done.stdout)

    def test_writes_the_graph_and_the_report(self):
        report = self.report_of(TOWN, "-o", self.path / "out.g2o")
        self.assertEqual(report["status"], "converged")
        self.assertLess(report["chi2_final"], report["chi2_initial"])
        self.assertEqual(report["start"]["requested"], "automatic")
        for key in ("reason", "iterations", "gauge", "kernel", "threads", "vertices", "edges"):
            self.assertIn(key, report)
        for key in ("load", "plan", "optimize", "total"):
            self.assertGreaterEqual(report["time_s"][key], 0)
        again = self.report_of(self.path / "out.g2o")
        self.assertAlmostEqual(again["chi2_initial"] / report["chi2_final"], 1, places=12)

    def test_the_report_counts_rows_and_degrees_of_freedom(self):
        report = self.report_of(TOWN)
        self.assertEqual([report[key] for key in ("rows", "scalars", "degrees_of_freedom")], [375, 357, 18])
        self.assertAlmostEqual(report["chi2_per_degree"], report["chi2_final"] / 18)
        self.assertIsNone(report["chi2_remark"])
        text = run("optimize", TOWN).stdout
        self.assertIn("125 edges (375 rows)", text)
        self.assertIn("chi2 per degree of freedom is 1.429 (18 degrees)", text)

    def test_remarks_if_the_information_cannot_be_right(self):
        graph = self.simulated("manhattan", 200)
        self.assertIsNone(self.report_of(graph)["chi2_remark"])
        lines = [line.split() for line in graph.read_text(encoding="utf-8").splitlines()]
        for factor, words in ((1e6, "Ω is too large"), (1e-6, "Ω is too small")):
            scaled = [" ".join([*words[:6], *(str(factor * float(w)) for w in words[6:])])
                      if words[0] == "EDGE_SE2" else " ".join(words) for words in lines]
            wrong = self.written("wrong.g2o", "\n".join(scaled) + "\n")
            self.assertIn(words, self.report_of(wrong)["chi2_remark"])
            self.assertIn(words, run("optimize", wrong).stdout)

    def test_reads_the_graph_from_stdin_and_writes_only_the_graph_to_stdout(self):
        text = TOWN.read_text(encoding="utf-8")
        done = run("optimize", "-", "-o", "-", stdin=text)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(set(estimates(done.stdout)), set(estimates(text)))
        self.assertTrue(all(line.startswith(("VERTEX", "EDGE", "FIX")) for line in done.stdout.splitlines()))
        self.assertIn("converged: chi2", done.stderr)
        run("optimize", TOWN, "-o", self.path / "out.g2o")
        self.assertEqual(done.stdout, (self.path / "out.g2o").read_text(encoding="utf-8"))

    def test_bounds_of_a_json_file_hold_and_are_reported(self):
        graph = self.path / "bounds.json"
        graph.write_text('{"format": "boxplus graph", "version": 1, "parameters": [], "vertices": [{"tag": "VERTEX_XY", "id": 3, "fields": [0, 0], '
                         '"bounds": [{"entry": 0, "upper": 1.5}]}], "edges": [{"tag": "EDGE_PRIOR_XY", "ids": [3], '
                         '"fields": [4, 2], "information": [2, 0, 2]}]}', encoding="utf-8")
        out = self.path / "out.json"
        report = self.report_of(graph, "-o", out)
        self.assertEqual(report["active_bounds"], [{"vertex": 3, "entry": 0, "limit": "upper", "value": 1.5, "multiplier": 10}])
        written = json.loads(out.read_text(encoding="utf-8"))["vertices"][0]
        self.assertEqual((written["fields"][0], written["bounds"]), (1.5, [{"entry": 0, "upper": 1.5}]))
        lines = run("optimize", graph, "-o", self.path / "out.g2o")
        self.assertIn("vertex 3, entry 0, is at its upper limit 1.5", lines.stdout)
        self.assertIn("the format does not keep the bounds of 1 vertex", lines.stderr)

    def test_writes_only_the_json_report_to_stdout(self):
        done = run("optimize", TOWN, "--json", "-")
        self.assertEqual(json.loads(done.stdout)["status"], "converged")
        self.assertIn("converged: chi2", done.stderr)

    def test_messages_about_bad_input_on_stdin_name_stdin(self):
        self.assert_refused(run("optimize", "-", stdin="VERTEX_SE2 0 0 0\n"), "<stdin>:1:17: expected")

    def test_refuses_to_write_two_outputs_to_one_file(self):
        for first, second in (("-", "-"), (self.path / "x", self.path / "." / "x")):
            self.assert_refused(run("optimize", TOWN, "-o", first, "--json", second), "two different files")
        self.assertEqual(list(self.path.iterdir()), [])

    def test_refuses_an_unwritable_output_before_it_reads_the_input(self):
        missing = self.path / "none" / "out.g2o"
        self.assert_refused(run("optimize", self.path / "none.g2o", "-o", missing), "none/out.g2o: cannot be written")
        self.assert_refused(run("optimize", TOWN, "--json", self.path), "cannot be written")
        self.assert_refused(run("optimize", TOWN, "-o", ""), "--output: expected the name of a file, got ''")

    def test_bad_input_changes_no_output(self):
        bad = self.written("bad.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 zero 0\n")
        out = self.written("out.g2o", "precious")
        self.assert_refused(run("optimize", bad, "-o", out, "--json", self.path / "out.json"),
                            "bad.g2o:2:16: expected y (a finite number), got 'zero'")
        self.assertEqual(out.read_text(encoding="utf-8"), "precious")
        self.assertFalse((self.path / "out.json").exists())
        self.assertIn("skipped", run("optimize", bad, "--lenient").stderr)
        self.assert_refused(run("optimize", self.path / "missing.g2o"), "missing.g2o: cannot be opened")
        self.assert_refused(run("optimize", self.written("empty.g2o", "")), "empty.g2o:1:1: expected a vertex or an edge")

    def test_unknown_tags_are_escaped_in_messages(self):
        graph = self.written("odd.g2o", "VERTEX_SE2 0 0 0 0\nBAD\x1b[31m 1\n")
        done = run("optimize", graph)
        self.assertIn(r"BAD\x1b[31m", done.stderr)
        self.assertNotIn("\x1b", done.stderr + done.stdout)

    def test_a_run_that_does_not_converge_exits_with_1(self):
        done = run("optimize", TOWN, "--iterations", 1, "--start", "current")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\Aboxplus: .*iteration limit.*\n\Z")
        self.assertEqual(self.report_of(TOWN, "--time-limit", 0, code=1)["reason"], "the time limit is reached")

    def test_a_gauge_freedom_exits_with_3_if_the_option_gauge_is_error(self):
        loose = self.written("loose.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 2 0 0 1 0 0 1 0 1\n")
        self.assertEqual(self.report_of(loose)["gauge"]["held"], [0])
        self.assertEqual(self.report_of(loose, "--gauge", "damp")["gauge"]["held"], [])
        done = run("optimize", loose, "--gauge", "error")
        self.assertEqual(done.returncode, 3)
        self.assertNotEqual(done.stderr, "")

    def test_optimized_graphs_do_not_depend_on_the_number_of_threads(self):
        graph = self.simulated("sphere", 225)
        texts = set()
        for threads in (1, 2, 4):
            run("optimize", graph, "-o", self.path / "out.g2o", "--threads", threads)
            texts.add((self.path / "out.g2o").read_bytes())
        self.assertEqual(len(texts), 1)

    def test_every_algorithm_and_solver_reaches_the_optimum(self):
        best = self.report_of(TOWN)
        for option, key in (("--algorithm", "algorithm"), ("--solver", "linear_solver")):
            names = [name for name in choices("optimize", option) if name != "automatic"]
            used = set()
            for name in names:
                report = self.report_of(TOWN, option, name)
                self.assertAlmostEqual(report["chi2_final"] / best["chi2_final"], 1, places=8, msg=name)
                used.add(report[key])
            self.assertEqual(len(used), len(names), used)
        self.assertEqual(self.report_of(TOWN, "--solver", "eigen")["linear_solver"], "eigen_sparse")

    def test_only_gauss_newton_may_end_above_its_start(self):
        for world in ("sphere", "torus", "grid", "manhattan", "city"):
            for seed in (1, 2):
                graph = self.path / f"{world}{seed}.g2o"
                run("simulate", world, "--poses", 150, "--noise", 3, "--outliers", 0.3, "--seed", seed, "-o", graph)
                for algorithm in ("dogleg", "levenberg-marquardt"):
                    for limit in (1, 2, 5, 100):
                        done = run("optimize", graph, "--algorithm", algorithm, "--start", "current", "--iterations", limit,
                                   "--quiet", "--json", self.path / "report.json", "-o", self.path / "out.g2o")
                        self.assertIn(done.returncode, (0, 1), done.stderr)
                        report = json.loads((self.path / "report.json").read_text(encoding="utf-8"))
                        self.assertLessEqual(report["chi2_final"], report["chi2_initial"], (world, seed, algorithm, limit))
                        written = json.loads(run("info", self.path / "out.g2o", "--json", "-").stdout)
                        self.assertAlmostEqual(written["chi2"] / report["chi2_final"], 1, places=9)

    def test_only_levenberg_marquardt_accepts_the_options_for_damping(self):
        marquardt = ("--algorithm", "levenberg-marquardt")
        records = self.report_of(TOWN, *marquardt, "--lambda", 7.5)["records"]
        self.assertEqual(records[0]["lambda"], 7.5)
        scaled, plain = (self.report_of(TOWN, *marquardt, "--damping", name, "--lambda", 10)["records"]
                         for name in ("diagonal", "identity"))
        self.assertNotEqual(scaled[0]["step_max"], plain[0]["step_max"])
        for option in (("--lambda", 1), ("--damping", "identity")):
            self.assert_refused(run("optimize", TOWN, *option), "requires --algorithm levenberg-marquardt")

    def test_starts_from_the_chosen_initial_estimates(self):
        names = choices("optimize", "--start")
        self.assertIn("chordal", names)
        for name in names:
            if name != "automatic":
                self.assertEqual(self.report_of(TOWN, "--start", name)["start"]["used"], name)

    def test_the_default_width_of_a_kernel_depends_on_the_rows_of_each_edge(self):
        widths = self.report_of(TOWN, "--kernel", "Cauchy")["kernel"]["width_by_rows"]
        self.assertEqual(list(widths), ["3"])
        self.assertAlmostEqual(widths["3"], 2.795483, places=6)
        widths = self.report_of(self.simulated("city", 50), "--kernel", "DCS")["kernel"]["width_by_rows"]
        self.assertEqual(list(widths), ["2", "3"])
        self.assertAlmostEqual(widths["2"], 5.991465, places=6)
        self.assertIn("Cauchy kernel of width 2.795 (3 rows) on 125 of 125 edges",
                      run("optimize", TOWN, "--kernel", "Cauchy").stdout)

    def test_a_kernel_that_rejects_most_of_its_edges_is_no_success(self):
        graph = self.path / "streets.g2o"
        run("simulate", "streets", "--poses", 2000, "--outliers", "0.2", "-o", graph)
        kernel = ("--kernel", "Tukey", "--kernel-on", "loop-closures")
        report = self.report_of(graph, *kernel, code=1)
        self.assertEqual((report["rejection"]["rejected"], report["rejection"]["redescending"]), (7576, 7576))
        done = run("optimize", graph, *kernel)
        self.assertEqual(done.returncode, 1)
        self.assertIn("rejected 7576 of 9575 edges", done.stdout)
        self.assertIn("robust kernels reject edges that the result needs: 7576 of the 7576 edges", done.stderr)
        self.assertIn("try another start, a larger width", done.stderr)
        info = run("info", graph, *kernel)
        self.assertEqual((info.returncode, info.stderr), (0, ""))
        self.assertIn("it rejects 7576 of 9575 edges (weight below 0.001)", info.stdout)
        report = self.report_of(TOWN, "--kernel", "Cauchy")
        self.assertEqual(report["rejection"], {"robust_edges": 125, "rejected": 0, "redescending": 125,
                                               "rejected_by_redescending": 0, "cut_off": []})
        self.assertIsNone(self.report_of(TOWN)["rejection"])

    def test_kernels_can_be_limited_to_loop_closures(self):
        self.assertIsNone(self.report_of(TOWN)["kernel"])
        report = self.report_of(TOWN, "--kernel", "Huber", "--kernel-width", 2)
        self.assertEqual(report["kernel"], {"name": "Huber", "width": 2, "edges": 125})
        report = self.report_of(TOWN, "--kernel", "Barron:-2", "--kernel-on", "loop-closures", "--kernel-width", 1,
                                code=1)  # because the kernel rejects 5 of the 6 loop closures
        self.assertEqual(report["kernel"], {"name": "Barron:-2", "width": 1, "edges": 6})
        self.assertEqual(self.report_of(TOWN, "--kernel", "barron:1")["kernel"]["name"], "Barron:1")
        self.assert_refused(run("optimize", TOWN, "--kernel", "Hubert"), "unknown robust kernel 'Hubert'")
        self.assert_refused(run("optimize", TOWN, "--kernel-width", 2), "--kernel-width requires --kernel")
        chain = self.written("chain.g2o",
                             "VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 5 5\nVERTEX_SE2 2 1 0 0\nEDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n")
        done = run("optimize", chain, "--kernel", "Huber", "--kernel-on", "loop-closures")
        self.assertIn("no loop closures", done.stderr)  # poses 0 and 2 are consecutive, because vertex 1 is a landmark

    def test_the_option_fix_holds_vertices_in_place_and_does_not_mark_them_as_fixed_in_the_file(self):
        before = estimates(TOWN.read_text(encoding="utf-8"))
        done = run("optimize", TOWN, "--fix", "5,17-19", "-o", "-")
        after = estimates(done.stdout)
        self.assertEqual({id for id in before if before[id] == after[id]}, {0, 5, 17, 18, 19})
        self.assertEqual([line for line in done.stdout.splitlines() if line.startswith("FIX")], ["FIX 0"])
        self.assert_refused(run("optimize", TOWN, "--fix", 900), "--fix: there is no vertex with id 900")
        self.assert_refused(run("optimize", TOWN, "--fix", "9-4"), "got '9-4'")

    def test_the_option_only_vertices_moves_no_other_vertex(self):
        before = estimates(TOWN.read_text(encoding="utf-8"))
        after = estimates(run("optimize", TOWN, "--only-vertices", "30-39,8", "-o", "-").stdout)
        self.assertEqual({id for id in before if before[id] != after[id]}, {8, *range(30, 40)})
        self.assert_refused(run("optimize", TOWN, "--only-vertices", "900-999"), "no vertex with an id from 900 to 999")

    def test_tags_can_be_renamed(self):
        text = TOWN.read_text(encoding="utf-8").replace("VERTEX_SE2", "VERTEX_ROBOT").replace("EDGE_SE2", "MY_EDGE")
        done = run("optimize", "-", "--rename", "VERTEX_ROBOT=VERTEX_SE2,MY_EDGE=EDGE_SE2", "-o", "-", stdin=text)
        self.assertEqual((done.returncode, done.stdout), (0, run("optimize", TOWN, "-o", "-").stdout))
        self.assert_refused(run("optimize", "-", "--rename", "A=NONSENSE"), "got 'NONSENSE'")

    def test_verbose_writes_one_line_per_iteration_to_stderr(self):
        lines = run("optimize", TOWN, "--start", "current", "--verbose").stderr.splitlines()
        self.assertGreater(len(lines), 2)
        self.assertEqual([line.split()[:3] for line in lines],
                         [["iteration", str(k + 1), "chi2"] for k in range(len(lines))])

    def on_a_terminal(self, *arguments):
        """The output of boxplus to stderr if stderr is a terminal."""
        try:
            leader, follower = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal is available: {error}")
        with os.fdopen(leader, "rb", buffering=0) as terminal:
            done = subprocess.run([BOXPLUS, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=follower, check=False)
            os.close(follower)
            self.assertEqual(done.returncode, 0)
            shown = b""
            try:
                while chunk := terminal.read(65536):
                    shown += chunk
            except OSError:  # on Linux, reading fails if the other end is closed
                pass
        return shown.decode()

    def test_on_a_terminal_the_progress_is_one_line_that_is_erased_at_the_end(self):
        shown = self.on_a_terminal("optimize", TOWN)
        self.assertIn("iteration", shown)
        self.assertNotIn("\n", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"))
        self.assertEqual(self.on_a_terminal("optimize", TOWN, "--quiet"), "")

    def test_on_a_terminal_long_work_shows_how_far_it_has_come(self):
        words = "simulate", "ba", "--cameras", 2000, "--points", 500000, "-o", "/dev/null"
        begin = time.monotonic()
        shown = self.on_a_terminal(*words)
        if time.monotonic() - begin < 2:
            self.skipTest("the machine is too fast for this test")
        self.assertRegex(shown, r"simulating …  \d+ %, \d+ s left")
        self.assertTrue(shown.endswith("\r\x1b[K"))
        self.assertNotIn("simulating", run(*words).stderr)

    def start_endless(self, output):
        """Starts a long optimization, and waits for its first iteration."""
        words = [BOXPLUS, "optimize", self.simulated("sphere", 2500), "-o", output, "--json", self.path / "out.json",
                 "--verbose", "--algorithm", "levenberg-marquardt", "--lambda", "1e9", "--start", "current",
                 "--iterations", "1000000000", "--cost-tolerance", "0", "--step-tolerance", "0"]
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertIn("iteration", process.stderr.readline())
        return process

    def test_an_interrupt_writes_and_reports_the_best_estimate(self):
        for each in (signal.SIGINT, signal.SIGTERM):
            process = self.start_endless(self.path / "out.g2o")
            process.send_signal(each)
            out, err = process.communicate(timeout=300)
            self.assertEqual(process.returncode, 1)
            self.assertRegex(err, r"boxplus: .*interrupted after \d+ iterations?; the best estimate is written to .*out\.g2o")
            self.assertIn("the run was interrupted", out)
            report = json.loads((self.path / "out.json").read_text(encoding="utf-8"))
            self.assertLess(report["chi2_final"], report["chi2_initial"])
            written = json.loads(run("info", self.path / "out.g2o", "--json", "-").stdout)
            self.assertAlmostEqual(written["chi2"] / report["chi2_final"], 1, places=10)

    def test_a_second_interrupt_ends_the_process_at_once(self):
        os.mkfifo(self.path / "pipe")  # nobody reads the pipe, so boxplus waits to write after the first interrupt
        process = self.start_endless(self.path / "pipe")
        while process.poll() is None:
            process.send_signal(signal.SIGINT)
            time.sleep(0.1)
        self.assertEqual(process.returncode, -signal.SIGINT)

if __name__ == "__main__":
    main()
