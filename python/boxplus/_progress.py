# SPDX-License-Identifier: BSD-3-Clause
"""The line that shows how far a long call has come, on a terminal."""

import math
import shutil
import sys
import time

PATIENCE_S, PAUSE_S = 0.5, 0.1


def is_shown():
    """Whether stderr is a terminal."""
    try:
        return sys.stderr.isatty()
    except (AttributeError, ValueError):  # None, or closed
        return False


class Line:
    """One line on stderr, which is overwritten, and erased at the end. Nothing is shown in the first half second."""

    def __init__(self, what):
        self._what, self._begin, self._shown = what, time.monotonic(), False

    def show(self, stage, share):
        seconds = time.monotonic() - self._begin
        known = share > 0  # not NaN
        rest = f"{100 * share:.0f} %, {math.ceil(seconds * (1 / share - 1))} s left" if known else f"{seconds:.0f} s"
        text = "  ".join(part for part in (f"{self._what} …", stage, rest) if part)
        self._write("\r\x1b[K" + text[:shutil.get_terminal_size().columns - 1])
        self._shown = True

    def erase(self):
        if self._shown:
            self._write("\r\x1b[K")

    @staticmethod
    def _write(text):
        sys.stderr.write(text)
        sys.stderr.flush()
