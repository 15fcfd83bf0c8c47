#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the boxplus command as users do, and tests the behavior that all sub-commands share."""

import json
import pathlib
import re
import subprocess

from command_case import BOXPLUS, TOWN, CommandCase, main, run

DOCUMENT = pathlib.Path(__file__).parents[2] / "docs/cli.md"
COMMANDS = re.findall(r"^## boxplus (\w+)$", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE)

class CommandTest(CommandCase):
    def test_version_and_help_go_to_stdout(self):
        self.assertRegex(run("--version").stdout, r"^boxplus \d+\.\d+\.\d+")
        for words in (["--help"], *([command, "--help"] for command in COMMANDS)):
            done = run(*words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("Usage: boxplus", done.stdout)
            self.assertEqual([line for line in done.stdout.splitlines() if len(line) > 100], [])
        self.assertIn("Exit codes", run("--help").stdout)
        self.assertIn("BOXPLUS_ISA", run("--help").stdout)
        self.assertEqual(run("help", "optimize").stdout, run("optimize", "--help").stdout)

    def test_docs_cli_md_equals_the_output_of_help(self):
        self.assertEqual(DOCUMENT.read_text(encoding="utf-8"), run("help", "--markdown").stdout,
                         "regenerate it: boxplus help --markdown > docs/cli.md")

    def test_an_unknown_instruction_set_is_refused_and_the_message_names_the_known_ones(self):
        for name in ("avx1024", "AVX2"):
            done = run("help", environment={"BOXPLUS_ISA": name})
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, rf"BOXPLUS_ISA: expected an instruction set of this processor \(baseline.*\), got '{name}'")
        for name in ("baseline", ""):
            self.assertEqual(run("help", environment={"BOXPLUS_ISA": name}).returncode, 0)
        done = run("optimize", TOWN, "--json", "-", environment={"BOXPLUS_ISA": "baseline"})
        self.assertIn('"instructions": "baseline"', done.stdout)

    def test_each_instruction_set_gives_the_same_bits_for_any_number_of_threads(self):
        complaint = run("help", environment={"BOXPLUS_ISA": "none"}).stderr
        names = re.search(r"\((.*?)\)", complaint).group(1).split(", ")
        self.assertIn("baseline", names)
        graph = self.path / "graph.g2o"
        run("simulate", "sphere", "--poses", 900, "-o", graph)
        for name in names:
            texts = set()
            for threads in (1, 2, 3):
                done = run("optimize", graph, "-o", "-", "--threads", threads, "--json", self.path / "report.json",
                           environment={"BOXPLUS_ISA": name})
                texts.add(done.stdout)
                report = json.loads((self.path / "report.json").read_text(encoding="utf-8"))
                self.assertEqual((report["status"], report["instructions"]), ("converged", name))
            self.assertEqual(len(texts), 1, name)

    def test_wrong_usage_exits_with_2_and_one_message(self):
        for words, text in (
                ([], "expected a command, got none"),
                (["dance"], "unknown command 'dance'"),
                (["optimise"], "did you mean optimize?"),
                (["diagnose", "f"], "unknown command 'diagnose'; did you mean boxplus info --diagnose? (see boxplus --help)"),
                (["certify", "f"], "did you mean boxplus optimize --certify?"),
                (["optimize"], "expected FILE, got none"),
                (["optimize", "f", "g"], "unexpected argument 'g'"),
                (["optimize", "--", "f", "-q"], "unexpected argument '-q'"),
                (["optimize", "f", "--itterations", "3"], "did you mean --iterations?"),
                (["optimize", "f", "--threads", "-1"], "--threads: expected a whole number ≥ 0, got '-1'"),
                (["optimize", "f", "--threads"], "--threads: expected a value, got none"),
                (["optimize", "f", "--threads", "1", "--threads", "2"], "--threads: expected one value"),
                (["simulate", "moon", "-o", "x"], "moon")):
            self.assert_refused(run(*words), text)

    def test_messages_contain_no_control_characters(self):
        done = run("optimize", "no\x1b[31m\nfile\x9b")
        self.assert_refused(done, r"no\x1b[31m\nfile\xc2\x9b: cannot be opened")
        done = run("dance\x07")
        self.assert_refused(done, r"dance\x07")

    def run_with(self, redirections, *arguments):
        """Runs boxplus with these shell redirections, and returns its exit code."""
        script = f'"$0" "$@" {redirections}'
        words = ["bash", "-c", script, BOXPLUS, *map(str, arguments)]
        return subprocess.run(words, capture_output=True, check=False, timeout=300).returncode

    def test_a_stderr_that_cannot_be_written_does_not_abort_the_command(self):
        for closed in ("2>&-", "2>/dev/full", "<&- >&- 2>&-"):
            with self.subTest(closed):
                self.assertEqual(self.run_with(closed, "convert", self.path / "nope", "-"), 2)
                self.assertEqual(self.run_with(closed, "dance"), 2)
        for closed in ("2>&-", "2>/dev/full"):
            self.assertEqual(self.run_with(closed, "optimize", TOWN, "-v"), 0)
            self.assertEqual(self.run_with(closed, "convert", TOWN, "-"), 0)

    def test_messages_to_a_closed_stream_do_not_end_up_in_an_output_file(self):
        # The graph has an unknown tag, so boxplus prints a message. The message must not end up in the
        # output.
        graph = self.written("graph.g2o", TOWN.read_text(encoding="utf-8") + "STRANGE 1\n")
        expected, output = self.path / "expected.g2o", self.path / "output.g2o"
        self.assertEqual(run("optimize", graph, "-q", "-o", expected).returncode, 0)
        self.assertEqual(self.run_with("<&- >&- 2>&-", "optimize", graph, "-q", "-o", output), 0)
        self.assertEqual(output.read_bytes(), expected.read_bytes())
        self.assertEqual(self.run_with("<&-", "info", "-"), 2)
        self.assertEqual(self.run_with(">&-", "info", graph), 2)

    def test_results_do_not_depend_on_the_number_of_threads(self):
        run("simulate", "sphere", "--poses", 225, "-o", self.path / "s.g2o")
        for threads in (1, 2, 4):
            run("optimize", self.path / "s.g2o", "-o", self.path / f"{threads}.g2o", "--threads", threads)
        texts = {(self.path / f"{threads}.g2o").read_bytes() for threads in (1, 2, 4)}
        self.assertEqual(len(texts), 1)

if __name__ == "__main__":
    main()
