#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""viewer_test.py G2O_VIEWER: tests the program g2o_viewer by its HTTP requests."""

import contextlib
import http.client
import json
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
STATE, STRUCTURE, FORM = 1, 2, 4
GRAPH = """VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 2 0 1.2
VERTEX_XY 10 1 1
EDGE_SE2 0 1 2 0 1 1 0 0 1 0 1
EDGE_SE2_XY 0 10 1 1.5 1 0 1
"""

class Viewer:
    def __init__(self, *arguments):
        self.process = subprocess.Popen([PROGRAM, "-port", "0", *map(str, arguments)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.port = int(re.search(r"127\.0\.0\.1:(\d+)/", self.process.stdout.readline()).group(1))
        self.connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        self.connection.request("GET", "/stream")
        self.response = self.connection.getresponse()
        self.token = self.state = self.structure = self.form = None
        self.read_until(lambda: self.state)

    def read_until(self, is_reached):
        while not is_reached():
            size, kind = struct.unpack("<II", self.response.read(8))
            payload = self.response.read(size)
            if kind == STATE:
                self.state = json.loads(payload)
                self.token = self.state.get("token", self.token)
            elif kind == STRUCTURE:
                (header,) = struct.unpack_from("<I", payload)
                self.structure = json.loads(payload[4:4 + header])
            elif kind == FORM:
                self.form = json.loads(payload)

    def post(self, path, content, content_type):
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)) as connection:
            connection.request("POST", path, content, {"Content-Type": content_type, "X-Boxplus-Token": self.token})
            return connection.getresponse().status

    def command(self, **members):
        return self.post("/command", json.dumps(members), "application/json")

    def end(self):
        self.connection.close()
        self.response.close()
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=60)
        return self.process.returncode

class ViewerTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "graph.g2o"
        self.path.write_text(GRAPH)

    def viewer(self, *arguments):
        viewer = Viewer(*arguments)
        self.addCleanup(lambda: viewer.process.poll() is None and viewer.process.kill())
        return viewer

    def test_shows_what_the_actions_draw_and_optimizes_it(self):
        viewer = self.viewer(self.path)
        viewer.read_until(lambda: viewer.structure)
        self.assertEqual([(v["name"], v["count"]) for v in viewer.structure["vertices"]], [("VERTEX_SE2", 2), ("VERTEX_XY", 1)])
        self.assertIsNone(viewer.state["opens_no_files"])
        self.assertIn("truth", viewer.state["opens_no_truth"])
        algorithm = next(s for s in viewer.form["settings"] if s["name"] == "algorithm")
        choices = {choice["value"]: choice["unsuitable"] for choice in algorithm["choices"]}
        self.assertIsNone(choices["gn_var_cholmod"])
        self.assertIsNotNone(choices["gn_fix6_3"])
        self.assertEqual(viewer.command(type="optimize", settings={"algorithm": "gn_var_cholmod"}), 200)
        viewer.read_until(lambda: viewer.state["run"] and viewer.state["run"]["status"] == "ended")
        self.assertLess(viewer.state["chi2"], 1e-12)
        self.assertEqual(viewer.end(), 0)

    def test_opens_files_with_renamed_types(self):
        viewer = self.viewer("-renameTypes", "POSE=VERTEX_SE2")
        self.assertIsNone(viewer.state["file"])
        text = GRAPH.replace("VERTEX_SE2", "POSE")
        self.assertEqual(viewer.post("/open?name=a.g2o", text, "application/octet-stream"), 200)
        viewer.read_until(lambda: viewer.state["file"] and not viewer.state["busy"])
        self.assertEqual(viewer.state["file"]["vertices"], 3)
        self.assertEqual(viewer.post("/open?name=b.g2o", "VERTEX_SE2 0 1", "application/octet-stream"), 200)
        viewer.read_until(lambda: viewer.state["error"] and not viewer.state["busy"])
        self.assertIn("b.g2o", viewer.state["error"])
        self.assertEqual(viewer.state["file"]["name"], "a.g2o")

    def test_refuses_a_file_that_cannot_be_opened(self):
        done = subprocess.run([PROGRAM, self.path.with_name("none.g2o")], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("none.g2o cannot be opened", done.stderr)

if __name__ == "__main__":
    unittest.main()
