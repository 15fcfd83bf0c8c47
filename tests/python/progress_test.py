#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The line on a terminal that shows how far a long call has come."""

import contextlib
import io
import os
import pty
import subprocess
import sys
import unittest

from boxplus import _progress

class FakeTerminal(io.StringIO):
    def isatty(self):
        return True

class Line(unittest.TestCase):
    def shown(self, *calls):
        terminal = FakeTerminal()
        with contextlib.redirect_stderr(terminal):
            line = _progress.Line("reading")
            for stage, share in calls:
                line.show(stage, share)
            line.erase()
        return terminal.getvalue()

    def test_is_overwritten_and_erased(self):
        self.assertEqual(self.shown(), "")
        shown = self.shown(("", 0.5), ("", 0.75))
        self.assertNotIn("\n", shown)
        self.assertIn("reading …  50 %", shown)
        self.assertIn("75 %, 1 s left", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"))

    def test_says_the_stage_if_nobody_knows_how_long_it_takes(self):
        self.assertIn("reading …  step 3  0 s", self.shown(("step 3", float("nan"))))

    def test_needs_a_terminal(self):
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertFalse(_progress.is_shown())
        with contextlib.redirect_stderr(None):
            self.assertFalse(_progress.is_shown())
        with contextlib.redirect_stderr(FakeTerminal()):
            self.assertTrue(_progress.is_shown())

class Calls(unittest.TestCase):
    PROGRAM = ("import boxplus, tempfile\n"
               "from boxplus import _progress\n"
               "_progress.PATIENCE_S = _progress.PAUSE_S = 0\n"
               "graph = boxplus.Graph()\n"
               "for _ in range(20000): graph.add_vertex(boxplus.SE2(0, 0, 0))\n"
               "with tempfile.TemporaryDirectory() as folder:\n"
               "    graph.save(folder + '/a.g2o')\n"
               "    boxplus.load(folder + '/a.g2o')\n")

    def test_show_their_progress_on_a_terminal_only(self):
        leader, follower = pty.openpty()
        with os.fdopen(leader, "rb", buffering=0) as terminal:
            subprocess.run([sys.executable, "-c", self.PROGRAM], stderr=follower, check=True)
            os.close(follower)
            shown = b""
            with contextlib.suppress(OSError):  # on Linux, reading fails if the other end is closed
                while chunk := terminal.read(65536):
                    shown += chunk
        self.assertIn("reading …", shown.decode())
        self.assertIn("writing …", shown.decode())
        done = subprocess.run([sys.executable, "-c", self.PROGRAM], stderr=subprocess.PIPE, check=True)
        self.assertEqual(done.stderr, b"")

if __name__ == "__main__":
    unittest.main()
