#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""If a file is bad, boxplus prints one message, exits with code 2, and changes no output file.

tests/io/g2o/graph_reader_malformed_lines_test.cpp tests the messages about bad lines.
"""

import json
import os
import resource
import signal
import subprocess
import sys
import time
import unittest

from command_case import BOXPLUS, CommandCase, main, run

GRAPH = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
BAD_LINE = "VERTEX_SE2 7 0 zero 0\n"

class BadInputTest(CommandCase):
    def setUp(self):
        super().setUp()
        self.output = self.written("out.g2o", "precious\n")
        self.picture = self.written("out.svg", "precious\n")

    def assert_untouched(self):
        for path in (self.output, self.picture):
            self.assertEqual(path.read_text(encoding="utf-8"), "precious\n")
        self.assertEqual([name for name in os.listdir(self.path) if name.startswith("out.g2o.")], [], "temporary files")

    def assert_bad(self, path, *texts):
        for words in (["optimize", path, "-o", self.output], ["convert", path, self.output], ["info", path],
                      ["plot", path, "-o", self.picture], ["view", path]):
            self.assert_refused(run(*words), *texts)
        self.assert_untouched()

    def test_files_that_cannot_be_read_are_refused(self):
        self.assert_bad(self.path / "none.g2o", "none.g2o: cannot be opened: No such file or directory")
        self.assert_bad(self.path, "got a folder without the files of a graph")
        secret = self.written("secret.g2o", GRAPH)
        secret.chmod(0)
        if os.geteuid() != 0:  # root may read everything
            self.assert_bad(secret, "secret.g2o: cannot be opened: Permission denied")

    def test_files_without_a_graph_are_refused(self):
        self.assert_bad(self.written("empty.g2o", ""), "empty.g2o:1:1: expected a vertex or an edge, got the end of the file")
        self.assert_bad(self.written("blank.g2o", "\n  \n# nothing\n"), "blank.g2o:4:1: expected a vertex or an edge")
        self.assert_bad(self.written("prose.g2o", "Dear all,\n"), "its first line is 'Dear all,'")

    def test_a_file_without_edges_cannot_be_optimized(self):
        path = self.written("lonely.g2o", "VERTEX_SE2 0 0 0 0\n")
        self.assert_refused(run("optimize", path, "-o", self.output), "lonely.g2o:2:1: expected an edge")
        self.assert_untouched()

    def test_messages_about_bad_lines_name_the_line_and_the_column(self):
        self.assert_bad(self.written("bad.g2o", GRAPH + BAD_LINE), "bad.g2o:4:16: expected y (a finite number), got 'zero'")

    def test_indefinite_information_is_refused_or_projected(self):
        path = self.written("indefinite.g2o", GRAPH + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1\n")
        for words in (["optimize", path, "-o", self.output], ["convert", path, self.output]):
            self.assert_refused(run(*words), "indefinite.g2o:4:20: information", "--information project")
            self.assert_untouched()
        done = run("convert", path, "-", "--information", "project")
        self.assertIn("EDGE_SE2 0 1 1 0 0 1.5 1.5 0 1.5 0 1", [
            " ".join(f"{float(field):.12g}" if field[0].isdigit() else field for field in line.split())
            for line in done.stdout.splitlines()])
        self.assertIn("1 of 2 edges with an indefinite information matrix", done.stderr)
        done = run("optimize", path, "-o", self.path / "out.g2o", "--information", "project", "--json", "-")
        self.assertEqual(json.loads(done.stdout)["indefinite_edges"], 1)
        self.assertIn("indefinite    1 of 2 information matrices", run("info", path).stdout)
        self.assertEqual(json.loads(run("info", path, "--json", "-").stdout)["indefinite_edges"], 1)

    def test_indefinite_information_is_used_as_given_if_wanted(self):
        path = self.written("indefinite.g2o", GRAPH + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1\n")
        done = run("convert", path, "-", "--information", "as-given")
        self.assertIn("EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1", [
            " ".join(f"{float(field):.12g}" if field[0].isdigit() else field for field in line.split())
            for line in done.stdout.splitlines()])
        self.assertIn("1 of 2 edges with an indefinite information matrix: it was kept as given", done.stderr)
        self.assertIn("chi2 is computed with them", run("info", path, "--information", "as-given").stdout)
        done = run("optimize", path, "-o", self.path / "out.g2o", "--information", "as-given", "--json", "-")
        self.assertEqual(json.loads(done.stdout)["indefinite_edges"], 1)

    def test_a_run_is_not_converged_if_an_indefinite_information_leaves_no_minimum(self):
        path = self.written("unbounded.g2o", "VERTEX_SE2 0 0 0 0\nFIX 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1.1 0 0 -1 0 0 1 0 1\n")
        done = run("optimize", path, "--information", "as-given", "--algorithm", "levenberg-marquardt")
        self.assertNotEqual(done.returncode, 0)
        self.assertNotIn("converged:", done.stdout.replace("not converged:", ""))

    def test_lenient_reading_skips_and_counts_bad_lines(self):
        path = self.written("bad.g2o", BAD_LINE + GRAPH + BAD_LINE)
        done = run("convert", path, self.path / "good.g2o", "--lenient")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 lines skipped", done.stdout)
        self.assertEqual(done.stderr.count("skipped"), 2)
        self.assertEqual((self.path / "good.g2o").read_text(encoding="utf-8"), GRAPH)

    def test_the_message_about_a_skipped_line_names_its_place_once(self):
        path = self.written("bad.g2o", GRAPH + BAD_LINE)
        complaint = f"boxplus: {path}:4:16: skipped: expected y (a finite number), got 'zero'\n"
        self.assertEqual(run("info", path, "--lenient").stderr, complaint)

    def test_a_file_with_only_bad_lines_is_refused_and_the_message_names_the_first_error(self):
        path = self.written("bad.g2o", "STRANGE 1\n" + 2 * BAD_LINE)
        done = run("info", path, "--lenient")
        self.assert_refused(done, "; 2 lines were skipped, the first at 2:16: expected y (a finite number), got 'zero'\n")
        self.assertEqual((done.stderr.count("skipped"), done.stderr.count(str(path))), (1, 1))

    def test_outputs_that_cannot_be_written_are_refused(self):
        graph = self.written("graph.g2o", GRAPH)
        self.assert_refused(run("optimize", graph, "-o", self.path), "cannot write a COLMAP model")
        self.assert_refused(run("optimize", graph, "-o", self.path / "none" / "out.g2o"), "No such file or directory")
        self.assert_refused(run("convert", graph, "/dev/full"), "No space left on device")

    def test_a_symbolic_link_to_itself_is_refused_as_output(self):
        loop = self.path / "loop.g2o"
        loop.symlink_to(loop)
        done = run("optimize", self.written("graph.g2o", GRAPH), "-o", loop)
        self.assert_refused(done, "loop.g2o: cannot be written: Too many levels of symbolic links")
        self.assertTrue(loop.is_symlink())

    def test_a_hard_link_to_the_input_is_refused_as_output(self):
        graph = self.written("graph.g2o", GRAPH)
        link = self.path / "link.json"
        os.link(graph, link)
        self.assert_refused(run("info", graph, "--json", link), "expected a file other than the input")
        self.assertEqual(link.read_text(encoding="utf-8"), GRAPH)

    def is_half_written(self):
        try:
            return any(path.stat().st_size > 0 for path in self.path.glob("out.g2o.*"))
        except FileNotFoundError:  # the file was only a test for write permission, and is already removed
            return False

    @unittest.skipIf(len(sys.argv) < 4, "needs the path of old_file_system")
    def test_a_signal_during_writing_leaves_no_temporary_file(self):
        graph = self.written("graph.g2o", GRAPH)
        for words in (["convert", graph, self.output], ["optimize", graph, "-o", self.output]):
            for each in (signal.SIGINT, signal.SIGTERM):
                process = subprocess.Popen([BOXPLUS, *words], env={"LD_PRELOAD": sys.argv[3]}, stdout=subprocess.DEVNULL)
                self.addCleanup(process.kill)
                while not self.is_half_written():
                    self.assertIsNone(process.poll())
                while process.poll() is None:
                    process.send_signal(each)
                    time.sleep(0.05)
                self.assertEqual(process.returncode, -each)
                self.assert_untouched()

    def test_a_killed_process_leaves_the_old_file_or_the_new_one(self):
        graph, out = self.path / "graph.g2o", self.path / "killed.g2o"
        run("simulate", "manhattan", "--poses", 20000, "-o", graph)
        begin = time.monotonic()
        run("convert", graph, out)
        duration = time.monotonic() - begin
        old, new = b"precious\n", out.read_bytes()
        killed = 0
        for k in range(40):
            out.write_bytes(old)
            with subprocess.Popen([BOXPLUS, "convert", graph, out], stdout=subprocess.DEVNULL) as process:
                time.sleep(1.2 * duration * k / 40)
                process.kill()
            killed += process.returncode == -signal.SIGKILL
            self.assertTrue(out.read_bytes() in (old, new), f"a part of the new file is there after {k / 40:.0%} of the time")
        self.assertGreater(killed, 3)

    def test_if_the_disk_is_full_the_old_file_is_kept(self):
        # A limit on the size of files acts like a full disk, because the graph exceeds the limit.
        graph = self.written("graph.g2o", "".join(f"VERTEX_SE2 {i} 0.123456789 0 0\n" for i in range(5000)))
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (65536, 65536))  # noqa: E731
        done = subprocess.run([BOXPLUS, "convert", graph, self.output], capture_output=True, encoding="utf-8", check=False,
                              preexec_fn=limit, timeout=300)
        self.assert_refused(done, "out.g2o: cannot be written: File too large")
        self.assert_untouched()

    def test_reading_a_line_of_one_gigabyte_needs_at_most_five_gigabytes_of_memory(self):
        path = self.path / "long.g2o"
        size = 1 << 30
        with path.open("wb") as file:
            file.write(GRAPH.encode() + b"VERTEX_SE2 7 ")
            file.truncate(size)  # the rest of the file is a hole, which reads as NUL bytes
        script = f'ulimit -v {5 * size // 1024}; exec "$0" info "$1"'
        done = subprocess.run(["bash", "-c", script, BOXPLUS, path], capture_output=True, encoding="utf-8", check=False, timeout=600)
        if "AddressSanitizer" in done.stderr or "ThreadSanitizer" in done.stderr:
            self.skipTest("a sanitizer needs more address space than the limit allows")
        self.assert_refused(done, "long.g2o:4:14: expected x (a finite number), got '\\x00\\x00")

if __name__ == "__main__":
    main()
