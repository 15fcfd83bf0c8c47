#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus completion`: every shell loads its script, and bash and fish complete command lines with it."""

import os
import shutil
import subprocess

from command_case import CommandCase, choices, main, run

def completions(*words):
    """The completions that bash offers for the last word."""
    script = f"""
{run("completion", "bash").stdout}
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_boxplus
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
    done = subprocess.run(["bash", "-euc", script, "bash", *words], capture_output=True, text=True, check=True)
    assert done.stderr == "", done.stderr
    return done.stdout.split()

class CompletionTest(CommandCase):
    def test_bash_completes_commands(self):
        self.assertEqual(completions("boxplus", "op"), ["optimize"])
        self.assertIn("completion", completions("boxplus", ""))
        self.assertIn("--version", completions("boxplus", "--"))

    def test_bash_completes_options(self):
        self.assertEqual(completions("boxplus", "optimize", "--iter"), ["--iterations"])
        self.assertEqual(completions("boxplus", "optimize", "graph.g2o", "--kernel-"), ["--kernel-width", "--kernel-on"])
        self.assertIn("--worst", completions("boxplus", "info", "-"))
        self.assertNotIn("--worst", completions("boxplus", "optimize", "-"))

    def test_bash_completes_values_of_options_and_arguments(self):
        solvers = choices("optimize", "--solver")
        self.assertIn("pcg", solvers)
        self.assertEqual(completions("boxplus", "optimize", "--solver", ""), solvers)
        self.assertEqual(completions("boxplus", "optimize", "--solver", "=", "p"), ["pcg"])
        self.assertEqual(completions("boxplus", "optimize", "--solver", "="), solvers)
        self.assertIn("Cauchy", completions("boxplus", "optimize", "--kernel", "C"))
        self.assertEqual(completions("boxplus", "optimize", "--threads", ""), [])
        self.assertEqual(completions("boxplus", "completion", ""), ["bash", "zsh", "fish"])
        self.assertEqual(completions("boxplus", "simulate", "sph"), ["sphere"])
        self.assertEqual(completions("boxplus", "simulate", "ba", "--shape", ""), choices("simulate", "--shape"))

    def test_the_script_leaves_the_completion_of_file_names_to_bash(self):
        self.assertEqual(completions("boxplus", "optimize", ""), [])
        self.assertEqual(completions("boxplus", "optimize", "graph.g2o", "-o", ""), [])

    def output_of(self, shell, script):
        if not shutil.which(shell):
            self.skipTest(f"{shell} is not installed")
        path = self.written(f"completion.{shell}", run("completion", shell).stdout)
        done = subprocess.run([shell, "-c", script, path], capture_output=True, text=True, check=True,
                              env={"HOME": str(self.path), "PATH": os.environ["PATH"], "SCRIPT": str(path)})
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_zsh_loads_its_script(self):
        script = 'autoload -U compinit && compinit -u && source $SCRIPT && echo $_comps[boxplus]'
        self.assertEqual(self.output_of("zsh", script), ["_boxplus"])

    def test_fish_completes_commands_options_and_values(self):
        for words, offered in (("op", ["optimize"]), ("optimize --iter", ["--iterations"]),
                               ("optimize --solver p", ["pcg"]), ("completion f", ["fish"])):
            found = self.output_of("fish", f"source $SCRIPT; complete -C 'boxplus {words}' | string replace -r '\\t.*' ''; true")
            self.assertEqual(found, offered)

    def test_other_shells_are_refused(self):
        self.assert_refused(run("completion", "tcsh"), "expected one of bash, zsh, fish, got 'tcsh'")

if __name__ == "__main__":
    main()
