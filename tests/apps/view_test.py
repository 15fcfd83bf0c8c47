#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the server of `boxplus view` as pages and attackers meet it: by its HTTP requests."""

import contextlib
import hashlib
import http.client
import json
import re
import signal
import socket
import struct
import subprocess
import time

from command_case import BOXPLUS, TOWN, CommandCase, main, run

STATE, STRUCTURE, FRAME, FORM, TRUTH = 1, 2, 3, 4, 6
MANY_ITERATIONS = {"iterations": "10000", "cost-tolerance": "0", "step-tolerance": "0"}
NUMBER_TYPES = {"f32": "f", "u32": "I", "u8": "B"}

def arrays(payload):
    """The header and the arrays of a structure or a frame."""
    (size,) = struct.unpack_from("<I", payload)
    header = json.loads(payload[4:4 + size])
    return header, {name: struct.unpack_from(f"<{array['count']}{NUMBER_TYPES[array['type']]}", payload, 4 + size + array["offset"])
                    for name, array in header["arrays"].items()}

class Stream:
    """The stream that a page reads."""

    def __init__(self, viewer):
        self.connection = http.client.HTTPConnection("127.0.0.1", viewer.port, timeout=20)
        self.connection.request("GET", "/stream")
        self.response = self.connection.getresponse()
        self.rows, self.token, self.run = [], None, None
        self.state = self.structure = self.frame = self.form = self.truth = None

    def read(self):
        size, kind = struct.unpack("<II", self.response.read(8))
        payload = self.response.read(size)
        if kind == STATE:
            self.state = json.loads(payload)
            self.token = self.state.get("token", self.token)
            self.run = self.state["run"]
            if self.run:
                self.rows[self.run["first_row"]:] = self.run["rows"]
        elif kind == STRUCTURE:
            self.structure = arrays(payload)
        elif kind == FORM:
            self.form = json.loads(payload)
        elif kind == FRAME:
            self.frame = arrays(payload)
        elif kind == TRUTH:
            self.truth = arrays(payload)
        return kind

    def read_until(self, is_reached):
        deadline = time.monotonic() + 60
        while not is_reached(self):
            assert time.monotonic() < deadline, self.state
            self.read()
        return self

    def close(self):
        self.connection.close()
        self.response.close()

class Viewer:
    """A running `boxplus view`."""

    def __init__(self, path, *options):
        self.process = subprocess.Popen([BOXPLUS, "view", str(path), *options], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.url = self.process.stdout.readline().strip()
        self.port = int(re.search(r":(\d+)/", self.url).group(1))
        self.streams = []

    def stream(self):
        self.streams.append(Stream(self))
        return self.streams[-1].read_until(lambda s: s.frame)

    def request(self, method, path, body=None, headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        with contextlib.closing(connection):
            connection.request(method, path, body, headers or {})
            response = connection.getresponse()
            return response.status, response.read()

    def command(self, token, **members):
        headers = {"Content-Type": "application/json", "X-Boxplus-Token": token}
        status, body = self.request("POST", "/command", json.dumps(members), headers)
        return status, json.loads(body)

    def open(self, token, name, content, query=""):
        headers = {"Content-Type": "application/octet-stream", "X-Boxplus-Token": token}
        status, body = self.request("POST", f"/open?name={name}{query}", content, headers)
        return status, json.loads(body)

    def save(self, token, name):
        return self.request("GET", f"/graph?format={name}", headers={"X-Boxplus-Token": token})

    def element(self, token, query):
        status, body = self.request("GET", f"/element?{query}", headers={"X-Boxplus-Token": token})
        return status, json.loads(body)

    def end(self, how=signal.SIGINT):
        """Ends the viewer, and returns its exit code."""
        for stream in self.streams:
            stream.close()
        self.process.send_signal(how)
        self.process.communicate(timeout=60)
        return self.process.returncode

class ViewCase(CommandCase):
    def viewer(self, path=TOWN, *options):
        viewer = Viewer(path, *options)
        self.addCleanup(lambda: viewer.process.poll() is None and viewer.end())
        return viewer

    def long_run(self):
        """A viewer whose graph takes many iterations."""
        graph = self.path / "long.g2o"
        self.assertEqual(run("simulate", "manhattan", "--poses", 20000, "-o", graph).returncode, 0)
        return self.viewer(graph)

class CommandView(CommandCase):
    """A command with the option --view."""
    command = None

    def start(self, *options, source=str(TOWN)):
        process = subprocess.Popen([BOXPLUS, self.command, source, "--view", *options], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: process.poll() is None and process.kill())
        viewer = Viewer.__new__(Viewer)
        viewer.process, viewer.streams = process, []
        viewer.url = re.search(r"http://\S+", process.stderr.readline()).group()
        viewer.port = int(re.search(r":(\d+)/", viewer.url).group(1))
        return viewer

class ReplayView(CommandView):
    command = "replay"

    def test_waits_for_a_page_and_shows_how_the_graph_grows(self):
        output = self.path / "out.g2o"
        viewer = self.start("-o", output, "--seconds", "2")
        lines = lambda stream: len(stream.structure[1]["edges"])
        stream = viewer.stream()
        self.assertFalse(output.exists())
        first = lines(stream)
        stream.read_until(lambda s: lines(s) > first)
        last = lines(stream)
        stream.read_until(lambda s: lines(s) > last and not s.state["busy"])
        self.assertEqual(viewer.end(), 0)
        self.assertTrue(output.exists())

    def test_shows_the_graph_that_a_robot_sends(self):
        viewer = self.start(source="--online")
        stream = viewer.stream()
        commands = viewer.process.stdin
        for k in range(1, 4):
            commands.write(f"ADD EDGE_XYT {k - 1} {k} 1 0 0 1 0 0 1 0 1;\nSOLVE_STATE;\n")
            commands.flush()
            stream.read_until(lambda s, k=k: s.state["file"]["edges"] == k)
        commands.close()
        viewer.process.stdin = None
        stream.read_until(lambda s: not s.state["busy"])
        self.assertEqual(viewer.end(), 0)

    def test_ends_early_on_request(self):
        viewer = self.start("--seconds", "1000")
        viewer.stream()
        self.assertEqual(viewer.end(), 1)

    def test_options_of_the_page_need_it(self):
        for option in "--port", "--seconds":
            self.assertEqual(run("replay", TOWN, option, "1").returncode, 2)

class OptimizeView(CommandView):
    command = "optimize"

    def test_shows_the_run_and_writes_the_file_before_it_serves(self):
        output = self.path / "out.g2o"
        viewer = self.start("-o", output)
        stream = viewer.stream().read_until(lambda s: not s.state["busy"])
        self.assertEqual(stream.run["status"], "converged")
        self.assertIn("opens no files", stream.state["opens_no_files"])
        self.assertEqual(len(stream.rows), stream.rows[-1]["iteration"])
        self.assertTrue(output.exists())
        self.assertEqual(viewer.end(), 0)

    def test_lets_the_page_go_on_with_the_graph(self):
        viewer = self.start("--iterations", "1")
        stream = viewer.stream().read_until(lambda s: not s.state["busy"])
        self.assertEqual(viewer.command(stream.token, type="optimize")[0], 200)
        stream.read_until(lambda s: s.run and s.run["status"] == "converged")
        self.assertEqual(viewer.save(stream.token, "g2o")[0], 200)
        self.assertEqual(viewer.end(), 1)  # the run of the command was stopped by its limit

    def test_options_of_the_server_need_it(self):
        self.assertEqual(run("optimize", TOWN, "--port", "0").returncode, 2)

class Page(ViewCase):
    def test_is_served_at_the_url_that_is_printed(self):
        viewer = self.viewer()
        self.assertRegex(viewer.url, r"\Ahttp://127\.0\.0\.1:\d+/\Z")
        status, body = viewer.request("GET", "/")
        self.assertEqual((status, body[:2]), (200, b"\x1f\x8b"))
        self.assertEqual(viewer.request("GET", "/favicon.ico")[0], 200)
        self.assertEqual(viewer.request("GET", "/anything")[0], 404)

    def test_gets_the_whole_graph_at_once(self):
        stream = self.viewer().stream()
        header, numbers = stream.structure
        count = stream.state["file"]["vertices"]
        self.assertEqual(sum(group["count"] for group in header["vertices"]), count)
        self.assertEqual(sum(group["count"] for group in header["edges"]), len(numbers["edges"]) // 2)
        self.assertTrue(all(vertex < count for vertex in numbers["edges"]))
        self.assertEqual(len(stream.frame[1]["positions"]), 3 * count)

class Commands(ViewCase):
    def test_optimize_reaches_the_optimum_and_moves_the_vertices(self):
        viewer = self.viewer()
        stream = viewer.stream()
        before = stream.frame[1]["positions"]
        self.assertEqual(viewer.command(stream.token, type="optimize"), (200, {"ok": True}))
        stream.read_until(lambda s: s.run and s.run["status"] == "converged" and s.frame[0]["iteration"] > 0)
        report = json.loads(run("optimize", TOWN, "--quiet", "--json", "-").stdout)
        self.assertEqual(stream.state["chi2"], report["chi2_final"])
        self.assertEqual([row["chi2"] for row in stream.rows], [record["chi2"] for record in report["records"]])
        self.assertNotEqual(stream.frame[1]["positions"], before)

    def test_reset_restores_the_estimates_of_the_file(self):
        viewer = self.viewer()
        stream = viewer.stream()
        before = stream.frame[1]["positions"]
        for command in ("step", "step", "optimize", "reset"):
            frame = stream.frame[0]["sequence"]
            self.assertEqual(viewer.command(stream.token, type=command)[0], 200, command)
            stream.read_until(lambda s, f=frame: s.frame[0]["sequence"] > f and not s.state["busy"])
        stream.read_until(lambda s: s.frame[0]["iteration"] == 0)
        self.assertEqual(stream.frame[1]["positions"], before)
        self.assertEqual(stream.state["chi2"], stream.state["chi2_initial"])

    def test_step_takes_one_iteration(self):
        viewer = self.viewer()
        stream = viewer.stream()
        viewer.command(stream.token, type="step")
        stream.read_until(lambda s: s.run and s.run["status"] != "running")
        self.assertEqual(len(stream.rows), 1)
        self.assertLess(stream.state["chi2"], stream.state["chi2_initial"])

    def test_are_refused_with_a_reason_if_they_are_malformed(self):
        viewer = self.viewer()
        token = viewer.stream().token
        for members, text in (({"type": "explode"}, "type: expected one of"), ({}, "type"), ({"type": 3}, "type"),
                              ({"type": "optimize", "settings": 3}, "settings: expected an object"),
                              ({"type": "optimize", "settings": {"speed": "high"}}, "'speed' is unknown"),
                              ({"type": "optimize", "settings": {"iterations": 3}}, "iterations: expected a text"),
                              ({"type": "optimize", "settings": {"iterations": "-1"}}, "iterations: expected a whole number"),
                              ({"type": "optimize", "settings": {"iterations": "10001"}}, "iterations: expected at most"),
                              ({"type": "step", "settings": {"algorithm": "magic"}}, "algorithm: expected one of"),
                              ({"type": "step", "settings": {"lambda": "5"}}, "lambda: needs"),
                              ({"type": "step", "settings": {"kernel-width": "1"}}, "kernel-width: needs"),
                              ({"type": "guess"}, "initial guess"), ({"type": "guess", "start": "current"}, "initial guess")):
            status, answer = viewer.command(token, **members)
            self.assertEqual(status, 400, members)
            self.assertIn(text, answer["error"])
        headers = {"Content-Type": "application/json", "X-Boxplus-Token": token}
        for body in (b"", b"{", b"[]", b"[" * 60000, b"\xff\xfe", b'{"type": "step"'):
            self.assertEqual(viewer.request("POST", "/command", body, headers)[0], 400, body[:10])

    def test_show_all_pages_the_same(self):
        viewer = self.viewer()
        first, second = viewer.stream(), viewer.stream()
        viewer.command(first.token, type="optimize")
        for stream in (first, second):
            stream.read_until(lambda s: s.run and s.run["status"] == "converged" and s.frame[0]["iteration"] > 0)
        third = viewer.stream()  # as after a reload; it begins with the kept frames of the run
        third.read_until(lambda s: s.run and s.frame[0]["sequence"] == first.frame[0]["sequence"])
        for stream in (second, third):
            self.assertEqual((stream.rows, stream.state["chi2"], stream.frame), (first.rows, first.state["chi2"], first.frame))

    def test_use_the_settings(self):
        viewer = self.viewer()
        stream = viewer.stream()
        viewer.command(stream.token, type="optimize", settings={"algorithm": "levenberg-marquardt", "kernel": "huber", "iterations": "3"})
        stream.read_until(lambda s: s.run and s.run["status"] != "running")
        self.assertLessEqual(len(stream.rows), 3)
        self.assertGreater(stream.rows[0]["lambda"], 0)
        self.assertIn("rejected", stream.run["summary"])  # the line about kernels
        number = stream.run["number"]
        viewer.command(stream.token, type="reset")
        stream.read_until(lambda s: s.run is None and not s.state["busy"])
        self.assertEqual(viewer.command(stream.token, type="optimize")[0], 200)
        stream.read_until(lambda s: s.run and s.run["number"] > number and s.run["status"] != "running")
        self.assertNotIn("rejected", stream.run["summary"])

    def test_guess_replaces_the_estimates(self):
        viewer = self.viewer()
        stream = viewer.stream()
        frame = stream.frame
        self.assertEqual(viewer.command(stream.token, type="guess", start="chordal")[0], 200)
        stream.read_until(lambda s: s.frame[0]["sequence"] > frame[0]["sequence"])
        self.assertLess(stream.state["chi2"], stream.state["chi2_initial"])
        self.assertNotEqual(stream.frame[1]["positions"], frame[1]["positions"])

class Form(ViewCase):
    def test_has_the_options_of_the_command(self):
        form = self.viewer().stream().form
        names = [setting["name"] for setting in form["settings"]]
        text = run("optimize", "--help").stdout
        for name in names:
            self.assertIn(f"--{name}", text)
        for name in ("start", "algorithm", "solver", "kernel", "gauge", "iterations"):
            self.assertIn(name, names)
        self.assertIn({"name": "g2o", "extension": ".g2o"}, form["formats"])

    def test_gives_the_reason_why_a_choice_is_unsuitable(self):
        def reason(form, name, value):
            setting = next(setting for setting in form["settings"] if setting["name"] == name)
            return next(choice["unsuitable"] for choice in setting["choices"] if choice["value"] == value)
        town = self.viewer().stream().form
        self.assertIsNone(reason(town, "start", "odometry"))
        scene = self.path / "scene.bal"
        run("simulate", "ba", "--cameras", 8, "--points", 40, "-o", scene)
        bundle = self.viewer(scene).stream().form
        self.assertIn("relative pose", reason(bundle, "start", "odometry"))
        self.assertIn("loop closures", reason(bundle, "kernel-on", "loop-closures"))

class Truth(ViewCase):
    def setUp(self):
        super().setUp()
        self.graph, self.truth = self.path / "graph.g2o", self.path / "truth.g2o"
        run("simulate", "manhattan", "--poses", 300, "-o", self.graph, "--truth", self.truth)

    def errors(self, path):
        facts = json.loads(run("compare", path, self.truth, "--json", "-").stdout)
        return [facts["ate_m"]["rmse"], facts["rpe"]["translation_m"]["rmse"], facts["rpe"]["rotation_rad"]["rmse"]]

    def assert_errors(self, stream, path):
        found = stream.frame[0]["truth"]
        for name, expected in zip(("ate_m", "rpe_m", "rpe_rad"), self.errors(path)):
            self.assertAlmostEqual(found[name] / expected, 1, 10, name)

    def test_is_compared_as_the_command_compares_it(self):
        viewer = self.viewer(self.graph, "--truth", self.truth)
        stream = viewer.stream().read_until(lambda s: s.truth and s.frame[0]["truth"])
        self.assertEqual((stream.truth[0]["name"], stream.truth[0]["matched"]), ("truth.g2o", 300))
        self.assertEqual(len(stream.truth[1]["positions"]), 900)
        self.assert_errors(stream, self.graph)
        viewer.command(stream.token, type="optimize")
        stream.read_until(lambda s: not s.state["busy"] and s.frame[0]["iteration"] > 0 and s.frame[0]["chi2"] == s.state["chi2"])
        optimum = self.path / "optimum.g2o"
        optimum.write_bytes(viewer.save(stream.token, "g2o")[1])
        self.assert_errors(stream, optimum)
        self.assertLess(self.errors(optimum)[0], self.errors(self.graph)[0])

    def test_is_opened_by_pages(self):
        viewer = self.viewer(self.graph)
        stream = viewer.stream()
        self.assertIsNone(stream.frame[0]["truth"])
        self.assertEqual(viewer.open(stream.token, "t.g2o", self.truth.read_text(), "&as=truth"), (200, {"ok": True}))
        stream.read_until(lambda s: s.truth and s.frame[0]["truth"])
        self.assert_errors(stream, self.graph)
        self.assertEqual(stream.state["file"]["name"], "graph.g2o")
        status, answer = viewer.open(stream.token, "t.g2o", "", "&as=picture")
        self.assertEqual(status, 400)
        self.assertIn("as: expected one of graph, truth", answer["error"])

    def test_that_does_not_fit_is_refused(self):
        strange = self.path / "strange.g2o"
        strange.write_text("VERTEX_SE2 9000 0 0 0\n")
        self.assert_refused(run("view", self.graph, "--truth", strange), "strange.g2o: expected poses that match graph.g2o by id")
        self.assert_refused(run("view", "-", "--truth", "-", stdin=""), "'-' twice")
        self.assert_refused(run("view", "--truth", self.truth), "FILE")

class Files(ViewCase):
    def test_are_opened_instead_of_the_first(self):
        viewer = self.viewer()
        stream = viewer.stream()
        first = stream.structure[0]["structure"]
        text = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
        self.assertEqual(viewer.open(stream.token, "small.g2o", text), (200, {"ok": True}))
        stream.read_until(lambda s: s.structure[0]["structure"] > first and s.frame[0]["structure"] > first)
        self.assertEqual((stream.state["file"]["name"], stream.state["file"]["vertices"]), ("small.g2o", 2))
        viewer.command(stream.token, type="optimize")
        stream.read_until(lambda s: s.run and s.run["status"] == "converged")
        self.assertEqual(stream.state["chi2"], 0)

    def test_that_are_malformed_leave_the_graph_and_show_the_message(self):
        viewer = self.viewer()
        stream = viewer.stream()
        for content, text in (("VERTEX_SE2 0 1 2\n", "bad.g2o:1:17: expected"), ("", "bad.g2o:1:1: expected")):
            self.assertEqual(viewer.open(stream.token, "bad.g2o", content)[0], 200)
            stream.read_until(lambda s, t=text: s.state["error"] and t in s.state["error"] and not s.state["busy"])
        self.assertEqual(stream.state["file"]["name"], "01_town.g2o")
        self.assertEqual(viewer.command(stream.token, type="step")[0], 200)

    def test_that_arrive_in_part_leave_the_graph(self):
        viewer = self.viewer()
        stream = viewer.stream()
        text = "VERTEX_SE2 0 0 0 0\n"
        with socket.create_connection(("127.0.0.1", viewer.port), timeout=20) as connection:
            connection.sendall((f"POST /open?name=cut.g2o HTTP/1.1\r\nHost: 127.0.0.1:{viewer.port}\r\n"
                                f"Content-Type: application/octet-stream\r\nX-Boxplus-Token: {stream.token}\r\n"
                                f"Content-Length: {10 * len(text)}\r\n\r\n{text}").encode())
            connection.shutdown(socket.SHUT_WR)
            self.assertNotIn(b"200", connection.recv(4096).split(b"\r\n")[0])
        self.assertEqual(viewer.command(stream.token, type="step")[0], 200)
        stream.read_until(lambda s: s.run and s.run["status"] != "running")
        self.assertEqual(stream.state["file"]["name"], "01_town.g2o")

    def test_are_saved_with_the_estimates_that_are_shown(self):
        viewer = self.viewer()
        stream = viewer.stream()
        viewer.command(stream.token, type="optimize")
        stream.read_until(lambda s: s.run and s.run["status"] == "converged" and not s.state["busy"])
        status, saved = viewer.save(stream.token, "g2o")
        self.assertEqual(status, 200)
        out = self.path / "out.g2o"
        run("optimize", TOWN, "-o", out, "--quiet")
        self.assertEqual(saved, out.read_bytes())
        self.assertEqual(viewer.save(stream.token, "unheard")[0], 400)
        self.assertEqual(viewer.save("", "g2o")[0], 403)

    def test_say_what_is_wrong(self):
        viewer = self.viewer()
        stream = viewer.stream()
        status, text = viewer.request("GET", "/diagnosis", headers={"X-Boxplus-Token": stream.token})
        diagnosis = json.loads(text)
        self.assertEqual((status, diagnosis["structure"]), (200, stream.structure[0]["structure"]))
        self.assertEqual(len(diagnosis["findings"]), diagnosis["count"])
        self.assertFalse([f for f in diagnosis["findings"] if f["severity"] == "error"])
        stream.read_until(lambda s: s.state["diagnosis"])
        self.assertEqual(stream.state["diagnosis"], "current")
        self.assertEqual(viewer.request("GET", "/diagnosis")[0], 403)

    def test_show_the_pattern_of_H(self):
        viewer = self.viewer()
        stream = viewer.stream()
        status, message = viewer.request("GET", "/pattern", headers={"X-Boxplus-Token": stream.token})
        self.assertEqual((status, struct.unpack_from("<II", message)), (200, (len(message) - 8, 5)))
        (size,) = struct.unpack_from("<I", message, 8)
        pattern = json.loads(message[12:12 + size])
        self.assertLess(pattern["size"], stream.state["file"]["vertices"] + 1)
        H, _, _, L = (picture["blocks"] for picture in pattern["pictures"])
        self.assertLessEqual(H, L)
        self.assertEqual(viewer.request("GET", "/pattern")[0], 403)

class Elements(ViewCase):
    def test_are_described_with_their_errors(self):
        viewer = self.viewer()
        stream = viewer.stream()
        header, numbers = stream.structure
        chi2 = stream.frame[1]["chi2"]
        self.assertEqual(len(chi2), len(numbers["edges"]) // 2)
        worst = chi2.index(max(chi2))
        status, edge = viewer.element(stream.token, f"structure={header['structure']}&line={worst}")
        self.assertEqual((status, edge["line"]), (200, worst))
        self.assertAlmostEqual(edge["chi2"] / edge["rows"] / chi2[worst], 1, places=5)
        self.assertEqual([end["vertex"] for end in edge["vertices"]], list(numbers["edges"][2 * worst:2 * worst + 2]))
        end = edge["vertices"][0]
        _, vertex = viewer.element(stream.token, f"structure={header['structure']}&id={end['id']}")
        self.assertEqual(vertex["vertex"], end["vertex"])
        self.assertIn(edge["edge"], [each["edge"] for each in vertex["edges"]])

    def test_are_refused_without_token_and_with_wrong_numbers(self):
        viewer = self.viewer()
        token = viewer.stream().token
        self.assertEqual(viewer.element("", "structure=1&vertex=0")[0], 403)
        self.assertEqual(viewer.element(token, "structure=1&vertex=0")[0], 200)
        for query in ("", "vertex=0", "structure=2&vertex=0", "structure=1", "structure=1&vertex=1000000", "structure=1&vertex=-1",
                      "structure=1&line=4294967296", "structure=1&edge=18446744073709551616", "structure=1&id=x", "structure=&id=1"):
            status, answer = viewer.element(token, query)
            self.assertEqual(status, 400, query)
            self.assertIn("error", answer)

    def test_are_edited(self):
        viewer = self.viewer()
        stream = viewer.stream()
        vertices, edges = stream.state["file"]["vertices"], stream.state["file"]["edges"]
        header = stream.structure[0]
        edit = {"type": "edit", "structure": "1", "edit": "remove"}
        self.assertEqual(viewer.command(stream.token, **edit, line="0"), (200, {"ok": True}))
        stream.read_until(lambda s: s.structure[0]["structure"] == 2 and s.frame[0]["structure"] == 2 and not s.state["busy"])
        self.assertEqual(stream.structure[0]["graph"], header["graph"])
        self.assertEqual((stream.state["file"]["vertices"], stream.state["file"]["edges"]), (vertices, edges - 1))
        self.assertEqual(len(stream.structure[1]["edges"]), 2 * (edges - 1))
        self.assertIn("is removed", stream.state["log"]["lines"][-1]["text"])
        self.assertIn("changed", viewer.command(stream.token, **edit, line="0")[1]["error"])  # of structure 1
        for members, text in (({}, "expected one of"), ({"line": "1000000"}, "line: expected"), ({"id": "-1"}, "id: expected"),
                              ({"edit": "explode", "line": "0"}, "edit: expected"), ({"edit": "fix", "line": "0"}, "only a vertex"),
                              ({"edit": "scale", "line": "0"}, "factor: expected"), ({"line": 0}, "expected one of"),
                              ({"edit": "scale", "line": "0", "factor": "nan"}, "factor: expected"),
                              ({"edit": "scale", "line": "0", "factor": "-1"}, "factor: expected")):
            status, answer = viewer.command(stream.token, **{**edit, "structure": "2", **members})
            self.assertEqual(status, 400, members)
            self.assertIn(text, answer["error"])
        self.assertEqual(viewer.command(stream.token, type="step")[0], 200)

class LongRuns(ViewCase):
    def test_stop_on_request(self):
        viewer = self.long_run()
        stream = viewer.stream()
        viewer.command(stream.token, type="optimize", settings=MANY_ITERATIONS)
        for command in ("optimize", "step", "reset"):
            self.assertEqual(viewer.command(stream.token, type=command)[0], 409, command)
        self.assertEqual(viewer.open(stream.token, "other.g2o", TOWN.read_bytes())[0], 409)
        self.assertEqual(viewer.save(stream.token, "g2o")[0], 409)
        self.assertEqual(viewer.element(stream.token, "structure=1&vertex=0")[0], 409)
        self.assertEqual(viewer.command(stream.token, type="edit", edit="fix", structure="1", vertex="1")[0], 409)
        viewer.command(stream.token, type="stop")
        stream.read_until(lambda s: s.run and s.run["status"] != "running" and not s.state["busy"])
        self.assertEqual(viewer.command(stream.token, type="step")[0], 200)

    def test_end_with_the_viewer_and_leave_the_file_alone(self):
        viewer = self.long_run()
        file = self.path / "long.g2o"
        before = hashlib.sha256(file.read_bytes()).digest()
        stream = viewer.stream()
        viewer.command(stream.token, type="optimize", settings=MANY_ITERATIONS)
        self.assertEqual(viewer.end(), 0)
        self.assertEqual(hashlib.sha256(file.read_bytes()).digest(), before)

    def test_do_not_wait_for_pages_that_vanish_or_do_not_read(self):
        viewer = self.long_run()
        stream = viewer.stream()
        for _ in range(5):
            viewer.stream().close()
        with socket.create_connection(("127.0.0.1", viewer.port)) as deaf:
            deaf.sendall(f"GET /stream HTTP/1.1\r\nHost: 127.0.0.1:{viewer.port}\r\n\r\n".encode())
            viewer.command(stream.token, type="optimize", settings={"iterations": "20"})
            stream.read_until(lambda s: s.run and s.run["status"] != "running")
            self.assertGreater(len(stream.rows), 0)

class Attackers(ViewCase):
    def test_are_refused_by_host_origin_token_and_type(self):
        viewer = self.viewer()
        token, own = viewer.stream().token, f"127.0.0.1:{viewer.port}"
        body, right = b'{"type": "step"}', {"Content-Type": "application/json", "X-Boxplus-Token": token}
        for method, path in (("GET", "/"), ("GET", "/stream"), ("POST", "/command")):
            for headers in ({"Host": "evil.example"}, {"Host": f"evil.example:{viewer.port}"}, {"Host": "127.0.0.1"},
                            {"Host": own, "Origin": "http://evil.example"}, {"Host": own, "Origin": "null"},
                            {"Host": own, "Origin": f"https://{own}"}):
                self.assertEqual(viewer.request(method, path, body, {**right, **headers})[0], 403, (path, headers))
        for wrong in ({**right, "X-Boxplus-Token": ""}, {**right, "X-Boxplus-Token": token[:-1]},
                      {"Content-Type": "application/json"}):
            self.assertEqual(viewer.request("POST", "/command", body, wrong)[0], 403, wrong)
        self.assertEqual(viewer.request("POST", "/command", body, {**right, "Content-Type": "text/plain"})[0], 415)
        for method in ("PUT", "DELETE", "PATCH", "OPTIONS"):
            self.assertIn(viewer.request(method, "/command", body, right)[0], (403, 404, 405))
        self.assertEqual(viewer.request("POST", "/command", body, {**right, "Origin": f"http://{own}"})[0], 200)

    def test_cannot_reach_files(self):
        viewer = self.viewer()
        for path in ("/../", "/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", f"/{TOWN}"):
            self.assertEqual(viewer.request("GET", path)[0], 404, path)

    def test_cannot_read_beyond_the_page(self):
        viewer = self.viewer()
        for wanted in ("bytes=0-400000", "bytes=200000-300000", "bytes=99999999999-99999999999", "bytes=-5"):
            self.assertEqual(viewer.request("GET", "/", headers={"Range": wanted})[0], 416, wanted)

    def test_cannot_hide_a_request_in_the_body_of_another(self):
        viewer = self.viewer()
        hidden = f"GET /stream HTTP/1.1\r\nHost: 127.0.0.1:{viewer.port}\r\n\r\n"
        with socket.create_connection(("127.0.0.1", viewer.port), timeout=10) as connection:
            connection.sendall(f"POST /x HTTP/1.1\r\nHost: evil.example\r\nContent-Length: {len(hidden)}\r\n\r\n".encode())
            answer = b""
            with contextlib.suppress(OSError):
                answer = connection.recv(4096)
                connection.sendall(hidden.encode())
                while more := connection.recv(4096):
                    answer += more
        self.assertIn(b"403", answer.split(b"\r\n")[0])
        self.assertNotIn(b'"token"', answer)

    def test_cannot_open_streams_from_other_sites(self):
        viewer = self.viewer()
        for path, status in (("/stream", 403), ("/graph?format=g2o", 403), ("/element?structure=1&vertex=0", 403),
                             ("/", 200)):
            self.assertEqual(viewer.request("GET", path, headers={"Sec-Fetch-Site": "cross-site"})[0], status, path)

    def test_cannot_send_giant_or_broken_requests(self):
        viewer = self.viewer()
        token = viewer.stream().token
        headers = {"Content-Type": "application/json", "X-Boxplus-Token": token}
        with contextlib.suppress(OSError, http.client.HTTPException):  # the server may close the connection early
            self.assertEqual(viewer.request("POST", "/command", b" " * 10_000_000, headers)[0], 413)
        for text in (b"\0" * 1000, b"GET / HTTP/9.9\r\n\r\n", b"POST /command HTTP/1.1\r\nContent-Length: -5\r\n\r\n",
                     b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n\r\n"):
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", viewer.port), timeout=5) as connection:
                connection.sendall(text)
        self.assertEqual(viewer.request("GET", "/")[0], 200)

    def test_cannot_hold_the_server_with_connections(self):
        viewer = self.viewer()
        stream = viewer.stream()
        with contextlib.ExitStack() as stack:
            for _ in range(200):
                stack.enter_context(socket.create_connection(("127.0.0.1", viewer.port), timeout=10))
            stream.read_until(lambda s: s.read() == 0)  # a heartbeat: the stream lives
            self.assertEqual(viewer.request("GET", "/")[0], 200)
        viewer.command(stream.token, type="step")
        stream.read_until(lambda s: s.run and s.run["status"] != "running")
        with contextlib.ExitStack() as stack:
            streams = [stack.enter_context(contextlib.closing(Stream(viewer))) for _ in range(17)]
            self.assertEqual(streams[-1].response.status, 503)

class Arguments(CommandCase):
    def test_name_a_file_that_can_be_read(self):
        self.assert_refused(run("view", self.path / "none.g2o"), "none.g2o")
        broken = self.written("broken.g2o", "VERTEX_SE2 0 1 2\n")
        self.assert_refused(run("view", broken), f"{broken}:1:")

    def test_name_a_port_that_is_free(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            self.assert_refused(run("view", TOWN, "--port", taken.getsockname()[1]), "taken")

class OtherAddresses(ViewCase):
    def test_need_the_token_for_everything(self):
        viewer = self.viewer(TOWN, "--host", "0.0.0.0")
        token = re.fullmatch(r"http://[^/:]+:\d+/\?token=([0-9a-f]{32})", viewer.url).group(1)
        self.assertEqual(viewer.request("GET", "/")[0], 403)
        self.assertEqual(viewer.request("GET", "/stream")[0], 403)
        self.assertEqual(viewer.request("GET", f"/?token={token}")[0], 200)
        self.assertEqual(viewer.request("GET", "/", headers={"X-Boxplus-Token": token})[0], 200)

if __name__ == "__main__":
    main()
