# SPDX-License-Identifier: BSD-3-Clause
"""boxplus.view(): a page that shows a graph and its runs."""

import gzip
import json
import socket
import struct
import subprocess
import sys
import threading
import time
import unittest
import urllib.error
import urllib.request
from unittest import mock

import boxplus
import numpy as np
from boxplus import SE2, Between, Graph, InvalidArgument, Optimizer, Prior, optimize, view

try:
    view(Graph()).close()
except ImportError as missing:
    print(f"SKIPPED: {missing}")
    sys.exit(77)

STATE, FRAME = 1, 3


def ring(count=20):
    graph = Graph()
    ids = graph.add_vertices(SE2, None, np.random.default_rng(1).normal(size=(count, 3)))
    graph.fix(0)
    turn = [1.0, 0, 2 * np.pi / count]
    graph.add_edges(Between, ids, np.roll(ids, -1), measurements=np.tile(turn, (count, 1)))
    return graph


def free_port():
    """A port that other programs, unlike the usual one, hardly take after it is closed."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def fetch(url):
    with urllib.request.urlopen(url, timeout=20) as answer:
        return answer.status, gzip.decompress(answer.read()).decode()


def arrays_of_frame(viewer):
    """The names of the arrays of the newest frame. A stream begins with the kept frames of the run, one after the other."""
    arrays = None
    with urllib.request.urlopen(viewer.url + "stream", timeout=20) as stream:
        while True:
            size, kind = struct.unpack("<II", stream.read(8))
            payload = stream.read(size)
            if kind == FRAME:
                arrays = set(json.loads(payload[4:4 + int.from_bytes(payload[:4], "little")])["arrays"])
            elif arrays is not None:
                return arrays


class Page:
    """A page: it reads the stream, and sends commands."""

    def __init__(self, viewer):
        self.url = viewer.url.rstrip("/")
        self.stream = urllib.request.urlopen(self.url + "/stream", timeout=20)
        self.states = []
        self.wait_for(lambda state: True)
        self.token = self.states[0]["token"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stream.close()

    def wait_for(self, wanted):
        while True:
            size, kind = struct.unpack("<II", self.stream.read(8))
            payload = self.stream.read(size)
            if kind == STATE:
                self.states.append(json.loads(payload))
                if wanted(self.states[-1]):
                    return self.states[-1]

    def send(self, **command):
        request = urllib.request.Request(self.url + "/command", json.dumps(command).encode(),
                                         {"Content-Type": "application/json", "X-Boxplus-Token": self.token})
        try:
            with urllib.request.urlopen(request, timeout=20) as answer:
                return json.load(answer)
        except urllib.error.HTTPError as error:
            raise AssertionError(error.read().decode()) from error

    def optimize(self):
        self.send(type="optimize", settings={})
        return self.wait_for(lambda state: not state["busy"] and state["run"] and state["run"]["status"] != "running")


class Viewers(unittest.TestCase):
    def test_a_page_is_served_until_the_viewer_is_closed(self):
        viewer = view(ring(), name="ring", port=free_port())
        self.assertEqual(repr(viewer), f"Viewer({viewer.url})")
        self.assertTrue(viewer.url.startswith("http://127.0.0.1:"))
        status, page = fetch(viewer.url)
        self.assertEqual(status, 200)
        self.assertIn("<html", page)
        with Page(viewer) as page:
            self.assertEqual((page.states[0]["file"]["name"], page.states[0]["file"]["vertices"]), ("ring", 20))
        viewer.close()
        with self.assertRaises(urllib.error.URLError) as raised:
            fetch(viewer.url)
        self.assertIsInstance(raised.exception.reason, ConnectionRefusedError)
        viewer.close()
        self.assertEqual((viewer.closed, repr(viewer)), (True, f"Viewer({viewer.url}, closed)"))
        for method in (viewer.update, viewer.hand_over, viewer.take_back):
            with self.assertRaisesRegex(InvalidArgument, "this viewer is closed"):
                method()

    def test_a_with_statement_closes_it(self):
        with view(ring()) as viewer:
            self.assertFalse(viewer.closed)
        self.assertTrue(viewer.closed)

    def test_a_viewer_without_a_reference_stays_open(self):
        graph = ring()
        url = view(graph, port=free_port()).url
        self.assertEqual(fetch(url)[0], 200)
        boxplus._view._close_all()
        with self.assertRaises(urllib.error.URLError):
            fetch(url)

    def test_a_viewer_changes_no_result(self):
        graph, other = ring(), ring()
        with view(graph):
            self.assertEqual(optimize(graph).chi2_final, optimize(other).chi2_final)
        np.testing.assert_array_equal(graph.estimates(SE2)[1], other.estimates(SE2)[1])
        self.assertEqual(graph.stack_size(), 0)

    def test_every_run_is_on_the_page(self):
        graph = ring()
        start = graph.estimates(SE2)
        with view(graph) as viewer, Page(viewer) as page:
            for run in (lambda: optimize(graph), lambda: Optimizer(graph).run(), lambda: boxplus.find_outliers(graph).report):
                graph.set_estimates(SE2, *start)
                report = run()
                state = page.wait_for(lambda state: state["run"] and state["run"]["status"] == "converged")
                self.assertEqual(state["chi2"], report.chi2_final)
                self.assertEqual([row["chi2"] for row in state["run"]["rows"]], [record.chi2 for record in report.records])

    def test_frames_have_the_verdicts_of_the_last_run(self):
        graph = ring()
        with view(graph) as viewer:
            self.assertNotIn("verdicts", arrays_of_frame(viewer))
            for run, has_verdicts in ((lambda: boxplus.find_outliers(graph), True), (lambda: optimize(graph), False)):
                run()
                self.assertEqual("verdicts" in arrays_of_frame(viewer), has_verdicts)

    def test_update_shows_what_the_program_has_changed(self):
        graph = ring()
        with view(graph) as viewer, Page(viewer) as page:
            vertex = graph.add_vertex(SE2(5, 5, 0))
            graph.add_edge(Prior(SE2(6, 5, 0)), vertex, information=8)
            viewer.update()
            state = page.wait_for(lambda state: state["file"]["vertices"] == 21)
            self.assertEqual(state["chi2"], graph.chi2())

    def test_a_page_stops_a_run(self):
        graph = ring()
        with view(graph) as viewer, Page(viewer) as page:
            report = optimize(graph, callback=lambda record: page.send(type="stop")["ok"])
            self.assertEqual((report.reason, report.iterations), (boxplus.Report.Reason.kCallback, 2))

    def test_a_viewer_that_is_closed_in_a_run_ends_with_it(self):
        graph = ring()
        viewer = view(graph, port=free_port())
        report = optimize(graph, callback=lambda record: viewer.close())
        self.assertTrue(report.converged() and viewer.closed)
        with self.assertRaises(urllib.error.URLError):
            fetch(viewer.url)

    def test_during_a_run_the_viewer_cannot_show_other_estimates(self):
        graph = ring()
        with view(graph) as viewer, self.assertRaisesRegex(InvalidArgument, "this graph is being optimized"):
            optimize(graph, callback=lambda record: viewer.update())

    def test_wrong_arguments_are_refused(self):
        with view(ring()) as viewer:
            port = int(viewer.url.rsplit(":", 1)[1].strip("/"))
            with self.assertRaisesRegex(boxplus.Error, str(port)):
                view(ring(), port=port)
            with self.assertRaisesRegex(ValueError, "port: expected a port from 0 to 65535, got 65536"):
                view(ring(), port=65536)
            for host in ("", "127.0.0.1\0x"):
                with self.assertRaisesRegex(ValueError, "host: expected an address"):
                    view(ring(), host=host)
            with self.assertRaises(TypeError):
                view(None)

    def test_without_the_viewer_an_error_says_why(self):
        with mock.patch.dict(sys.modules, {"boxplus._viewer": None}), mock.patch.object(boxplus, "_viewer"):
            del boxplus._viewer
            with self.assertRaisesRegex(ImportError, "this module has no viewer"):
                view(ring())


class HandedOver(unittest.TestCase):
    def test_a_page_may_optimize_and_the_program_must_wait(self):
        graph = ring()
        before = graph.chi2()
        with view(graph) as viewer, Page(viewer) as page:
            viewer.hand_over()
            viewer.hand_over()
            for method in (graph.chi2, graph.all_vertices, lambda: graph.fix(1), lambda: optimize(graph)):
                with self.assertRaisesRegex(InvalidArgument, "the pages of a viewer may change this graph; call its take_back"):
                    method()
            state = page.optimize()
            viewer.take_back()
            viewer.take_back()
            self.assertLess(graph.chi2(), before)
            self.assertAlmostEqual(graph.chi2(), state["chi2"])
            self.assertEqual(graph.stack_size(), 0)
            self.assertTrue(optimize(graph).converged())

    def test_close_gives_the_graph_back(self):
        graph = ring()
        with view(graph) as viewer:
            viewer.hand_over()
        self.assertTrue(optimize(graph).converged())

    def test_a_run_of_a_page_may_call_functions_of_python(self):
        graph = ring()
        threads = set()
        graph.add_edge(lambda x: threads.add(threading.get_ident()) or x.theta() - 1, 5)
        with view(graph) as viewer, Page(viewer) as page:
            viewer.hand_over()
            page.optimize()
            viewer.take_back()
        self.assertGreater(len(threads), 1)

    def test_an_error_function_cannot_end_the_run_that_calls_it(self):
        graph = Graph()
        graph.add_vertex([0.0])
        refused, is_lent = [], False

        def ends(x):
            for method in (viewer.close, viewer.take_back) if is_lent else ():
                try:
                    method()
                except InvalidArgument as error:
                    refused.append(str(error))
            return x - 1

        graph.add_edge(ends, 0)
        with view(graph) as viewer, Page(viewer) as page:
            is_lent = True
            viewer.hand_over()
            page.optimize()
            is_lent = False
            viewer.take_back()
        self.assertIn("Viewer: an error function cannot call take_back() while pages may optimize the graph", refused)
        self.assertIn("Viewer: an error function cannot call close() while pages may optimize the graph", refused)

    def test_close_stops_a_run_of_a_page(self):
        graph = Graph()
        graph.add_vertex([0.0])
        calls = []

        def slow(x):
            calls.append(1)
            time.sleep(0.02)
            return np.exp(-x)  # no minimum

        graph.add_edge(slow, 0)
        viewer = view(graph)
        with Page(viewer) as page:
            viewer.hand_over()
            calls.clear()
            page.send(type="optimize", settings={"iterations": "10000"})
            while not calls:
                time.sleep(0.001)
            viewer.close()
        count = len(calls)
        time.sleep(0.1)
        self.assertEqual(len(calls), count)
        self.assertLess(graph.estimate(0)[0], 10)


class Exits(unittest.TestCase):
    PROGRAM = """
import json, math, threading, time, urllib.request
import boxplus

graph = boxplus.Graph()
graph.add_vertex([1.0])
graph.add_edge(lambda x: time.sleep(0.02) or math.exp(-x[0]), 0)  # takes seconds, and has no minimum
viewer = boxplus.view(graph)
{work}
print("over")
"""
    WORKS = ("", "viewer.hand_over()", "page = urllib.request.urlopen(viewer.url + 'stream')",
             "threading.Thread(target=lambda: boxplus.optimize(graph, max_iterations=10**6), daemon=True).start(); time.sleep(0.1)",
             """viewer.hand_over()
stream = urllib.request.urlopen(viewer.url + "stream")
head = stream.read(8)
token = json.loads(stream.read(int.from_bytes(head[:4], "little")))["token"]
urllib.request.urlopen(urllib.request.Request(viewer.url + "command", b'{"type": "optimize", "settings": {"iterations": "10000"}}',
                       {"Content-Type": "application/json", "X-Boxplus-Token": token})).read()
time.sleep(0.05)""")

    def test_a_program_ends_while_the_viewer_is_open(self):
        for work in self.WORKS:
            with self.subTest(work):
                done = subprocess.run([sys.executable, "-c", self.PROGRAM.format(work=work)], capture_output=True, text=True,
                                      timeout=60, check=False)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "over\n", ""))

    def test_the_child_of_a_fork_has_no_viewer(self):
        program = """
import os, sys, urllib.request, boxplus
graph = boxplus.Graph()
graph.add_vertex([1.0])
viewer = boxplus.view(graph)
child = os.fork()
if child == 0:
    assert viewer.closed
    viewer.close()
    sys.exit(0)
assert os.waitpid(child, 0)[1] == 0
assert urllib.request.urlopen(viewer.url).status == 200
viewer.close()
print("over")
"""
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "over\n", ""))

    def test_boxplus_does_not_load_the_libraries_of_the_server(self):
        program = "import boxplus, sys; print('boxplus._viewer' in sys.modules)"
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "False\n")


if __name__ == "__main__":
    unittest.main()
