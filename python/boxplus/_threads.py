# SPDX-License-Identifier: BSD-3-Clause
"""Runs in daemon threads, while the interpreter exits.

A run releases Python's lock (GIL). If the interpreter has begun to finalize when the run ends, Python ends the thread when it
takes the lock, which aborts the process, because the thread is in C++. So runs of other threads are stopped before.
"""

import atexit
import functools
import threading
import time

from . import _boxplus

#: How long the exit waits for runs to end, in seconds. An error function of Python may take any time.
PATIENCE_S = 10.0

_runs = {}  # number of a run: (thread, StopFlag or None)
_lock = threading.Lock()
_is_exiting = False


class _Run:
    def __init__(self, flag):
        self.flag = flag

    def __enter__(self):
        with _lock:
            if _is_exiting and threading.current_thread() is not threading.main_thread():
                raise SystemExit  # ends the thread
            _runs[id(self)] = threading.current_thread(), self.flag

    def __exit__(self, *_):
        with _lock:
            del _runs[id(self)]


def _others():
    with _lock:
        return [flag for thread, flag in _runs.values() if thread is not threading.current_thread()]


def _stop_runs():
    global _is_exiting
    with _lock:
        _is_exiting = True
    end = time.monotonic() + PATIENCE_S
    while (flags := _others()) and time.monotonic() < end:
        for flag in flags:
            if flag is not None:
                flag.set()
        time.sleep(0.002)


atexit.register(_stop_runs)


def stoppable(function):
    """A function of a graph with the options of optimize()."""
    @functools.wraps(function)
    def run(graph, *arguments, **changes):
        if threading.current_thread() is threading.main_thread():  # it cannot exit during the run
            return function(graph, *arguments, **changes)
        options = [a for a in (*arguments, changes.get("options")) if isinstance(a, _boxplus.Options)]
        flag = changes.get("stop")
        if flag is None and options:
            flag = options[0].stop
        if flag is None:
            flag = changes["stop"] = _boxplus.StopFlag()
        with _Run(flag if isinstance(flag, _boxplus.StopFlag) else None):
            return function(graph, *arguments, **changes)

    return run


def stoppable_run(method):
    """The runs of an Optimizer, with its covariances, and of a Smoother."""
    @functools.wraps(method)
    def run(self, *arguments, **named):
        if threading.current_thread() is threading.main_thread():
            return method(self, *arguments, **named)
        options = self.options
        flag = options.stop or _boxplus.StopFlag()
        if options.stop is None:
            self.set_options(options, stop=flag)
        try:
            with _Run(flag):
                return method(self, *arguments, **named)
        finally:
            if options.stop is None:
                self.set_options(options)

    return run


def awaited(function):
    """A function that releases the lock for a short time."""
    @functools.wraps(function)
    def run(*arguments, **options):
        with _Run(None):
            return function(*arguments, **options)

    return run
