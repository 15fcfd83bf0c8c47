# SPDX-License-Identifier: BSD-3-Clause
"""The interpreter exits while daemon threads optimize graphs."""

import subprocess
import sys
import unittest

PROGRAM = """
import threading, time
import numpy as np
import boxplus

graph = boxplus.Graph()
count = {count}
ids = np.arange(count)
graph.add_vertices(boxplus.SE2, ids, np.random.default_rng(1).normal(size=(count, 3)))
graph.add_edges(boxplus.Between, ids[:-1], ids[1:], measurements=np.tile([1.0, 0, 0.1], (count - 1, 1)))
optimizer = boxplus.Optimizer(graph)
options = boxplus.Options(stop=boxplus.StopFlag())
runs = []


def work():
    while True:
        {call}
        runs.append(1)


class Slow:  # Python finalizes slowly, so that the thread takes the lock meanwhile
    def __del__(self, sleep=time.sleep):
        sleep(0.3)


slow = Slow()
threading.Thread(target=work, daemon=True).start()
while {wait}:
    time.sleep(0.001)
print("over")
"""
CALLS = ("boxplus.optimize(graph)", "boxplus.optimize(graph, options)", "boxplus.optimize(graph, callback=lambda record: None)",
         "optimizer.run()", "boxplus.diagnose(graph)", "boxplus.covariance(graph, [1])",
         "boxplus.optimize(graph, stop=boxplus.StopFlag())", "boxplus.find_outliers(graph)", "boxplus.certify(graph)",
         "optimizer.covariance([1])", "boxplus.Smoother(graph).finish()", "boxplus.marginalize(graph, [graph.add_vertex([0.0])])")


class Exits(unittest.TestCase):
    def assert_exits(self, call, count, wait):
        done = subprocess.run([sys.executable, "-c", PROGRAM.format(call=call, count=count, wait=wait)], capture_output=True,
                              text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "over\n", ""))

    def test_short_runs_of_a_daemon_thread_do_not_abort_the_process(self):
        for call in CALLS:
            with self.subTest(call):
                self.assert_exits(call, 100, "len(runs) < 2")

    def test_a_long_run_of_a_daemon_thread_is_stopped(self):
        for call in (CALLS[0], CALLS[1], CALLS[3]):
            with self.subTest(call):
                self.assert_exits(call, 300000, "time.process_time() < 0.5")

    def test_a_thread_that_is_no_daemon_ends_its_run(self):
        program = PROGRAM.replace("daemon=True", "daemon=False").replace("while True:", "for _ in range(3):").replace(
            'print("over")', "").replace("        runs.append(1)", "        runs.append(1)\n    print('over')")
        done = subprocess.run([sys.executable, "-c", program.format(call=CALLS[0], count=2000, wait="len(runs) < 1")],
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "over\n", ""))


if __name__ == "__main__":
    unittest.main()
