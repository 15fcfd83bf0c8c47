#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the pictures of graphs that `boxplus plot` draws."""

import base64
import json
import os
import re
import struct
import subprocess
import xml.etree.ElementTree
import zlib

from command_case import BOXPLUS, CommandCase, main, run

SVG = "{http://www.w3.org/2000/svg}"
CHAIN = """VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 1 0 0
VERTEX_SE2 2 2 0 0
VERTEX_SE2 3 3 1 0
EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1
EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1
EDGE_SE2 2 3 1 1 0 1 0 0 1 0 1
"""
INFORMATION = "1 0 0 1 0 1"
GRAY = "#a6b2c2"

class Picture:
    def __init__(self, text):
        self.root = xml.etree.ElementTree.fromstring(text)
        self.paths = self.root.findall(f"{SVG}path")
        self.words = [text.text for text in self.root.iter(f"{SVG}text")]

    def closures(self):
        """The colors of loop closures, one for each path. Gray paths are thinner than paths of other colors."""
        return [path.get("stroke") for path in self.paths
                if path.get("stroke-opacity") and path.get("stroke-width") in ("0.7", "1")]

    def numbers(self):
        return [float(number) for path in self.paths for number in re.findall(r"-?[\d.]+", path.get("d"))]

def unfiltered(kind, row, above):
    """A row of a PNG file as colors, from what its filter has left of it and the row above (PNG specification, section 9)."""
    for i, byte in enumerate(row):
        left, up, corner = row[i - 3] if i > 2 else 0, above[i], above[i - 3] if i > 2 else 0
        paeth = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
        row[i] = (byte + (0, left, up, (left + up) // 2, paeth)[kind]) % 256
    return row

def pixels_of(png):
    """The width, the height and the rows of (r, g, b) of a PNG file."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = {}, 8
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at:at + 8])
        chunks[name] = chunks.get(name, b"") + png[at + 8:at + 8 + size]
        at += 12 + size
    width, height, bits, kind = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    assert (bits, kind) == (8, 2)
    data, stride, rows = zlib.decompress(chunks[b"IDAT"]), 3 * width + 1, [bytes(3 * width)]
    for at in range(0, height * stride, stride):
        rows.append(unfiltered(data[at], bytearray(data[at + 1:at + stride]), rows[-1]))
    return width, height, [[tuple(row[i:i + 3]) for i in range(0, 3 * width, 3)] for row in rows[1:]]

def streams_of(pdf):
    """The streams of a PDF file: the drawing commands, and the fonts with their maps to Unicode."""
    assert pdf.startswith(b"%PDF-1.4") and pdf.endswith(b"%%EOF\n")
    return [zlib.decompress(packed) for packed in re.findall(rb"/FlateDecode.*?stream\n(.*?)\nendstream", pdf, re.DOTALL)]

STATE, STRUCTURE, FRAME, FORM = 1, 2, 3, 4

def messages_of(page):
    """The messages in a page, as pairs of kind and payload."""
    stream = base64.b64decode(re.search(r'id="saved-stream">([^<]*)</script>', page)[1], validate=True)
    messages, at = [], 0
    while at < len(stream):
        size, kind = struct.unpack_from("<II", stream, at)
        messages.append((kind, stream[at + 8:at + 8 + size]))
        assert len(messages[-1][1]) == size
        at += 8 + size
    return messages

class PlotTest(CommandCase):
    def drawn(self, *inputs, stdin=""):
        done = run("plot", *inputs, "-o", "-", stdin=stdin)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Picture(done.stdout)

    def test_shows_the_graph_before_and_after_optimization(self):
        for world in ("sphere", "city"):
            graph = self.path / f"{world}.g2o"
            run("simulate", world, "--poses", 400, "-o", graph)
            run("optimize", graph, "-q", "-o", self.path / "after.g2o")
            done = run("plot", graph, self.path / "after.g2o", "-o", self.path / "p.svg")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("before and after", done.stdout)
            picture = Picture((self.path / "p.svg").read_text(encoding="utf-8"))
            for text in ("before", "after", "trajectory"):
                self.assertIn(text, picture.words)
            self.assertEqual("landmarks" in picture.words, world == "city")
            self.assertEqual(sum("chi2 = " in words for words in picture.words), 2)

    def test_colors_loop_closures_by_their_chi2(self):
        good, bad, worse = (f"EDGE_SE2 0 {to} {to} {error} 0 {INFORMATION}\n" for to, error in ((3, 1), (2, 9), (2, 99)))
        self.assertEqual(self.drawn("-", stdin=CHAIN).closures(), [])
        picture = self.drawn("-", stdin=CHAIN + good)
        self.assertEqual(picture.closures(), [GRAY])
        self.assertIn("chi2 per row of loop closures", picture.words)
        for bads in (bad, worse):
            colors = self.drawn("-", stdin=CHAIN + good + bads).closures()
            self.assertEqual((len(colors), colors[0]), (2, GRAY))
            self.assertNotEqual(colors[1], GRAY)

    def test_both_panels_have_the_same_color_scale(self):
        closure = f"EDGE_SE2 0 3 3 {{}} 0 {INFORMATION}\n"
        before, after = (self.written(name, CHAIN + closure.format(y)) for name, y in (("b", 500), ("a", 8)))
        same, different = self.drawn(after, after), self.drawn(before, after)
        self.assertEqual((len(same.closures()), len(set(same.closures()))), (2, 1))
        self.assertEqual(len(set(different.closures())), 2)
        self.assertNotIn(same.closures()[0], different.closures(), "on a longer scale, the same error has a lighter color")
        self.assertIn("100", same.words)
        self.assertIn("10⁴", different.words)

    def test_draws_graphs_with_one_vertex_or_one_position(self):
        one = "VERTEX_SE2 0 3 4 0\n"
        point = "VERTEX_XY 1 3 4\n"
        same = "".join(f"VERTEX_SE2 {i} 7 7 0\n" for i in range(5)) + f"EDGE_SE2 0 1 0 0 0 {INFORMATION}\n"
        for text in (one, point, one + point, same):
            picture = self.drawn("-", stdin=text)
            self.assertGreaterEqual(len(picture.paths), 1)
            self.assertTrue(all(0 <= number <= 700 for number in picture.numbers()), picture.numbers())
            self.assertFalse(any(re.fullmatch(r"\S+ m", words) for words in picture.words), "a single point has no scale bar")

    def test_pictures_of_large_graphs_are_small_files(self):
        run("simulate", "streets", "--poses", 100_000, "-o", self.path / "s.g2o")
        done = run("plot", self.path / "s.g2o", self.path / "s.g2o", "-o", self.path / "p.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess((self.path / "p.svg").stat().st_size, 8_000_000)

    def test_if_edges_cover_each_other_only_the_edge_with_the_largest_chi2_is_drawn(self):
        copies = "".join(f"EDGE_SE2 0 3 3 1 0 {INFORMATION}\n" for _ in range(50))
        colors = self.drawn("-", stdin=CHAIN + copies + f"EDGE_SE2 0 3 3 400 0 {INFORMATION}\n").closures()
        self.assertEqual(len(colors), 1)
        self.assertNotEqual(colors[0], GRAY)

    def test_titles_show_the_names_of_the_files(self):
        path = self.written("a<b>&c.g2o", CHAIN)
        self.assertIn("a<b>&c", self.drawn(path).words)

    def test_bytes_of_titles_that_are_not_valid_utf8_become_replacement_characters(self):
        latin = os.fsdecode(b"lat\xe9in.g2o")
        graph = self.written(latin, CHAIN)
        self.assertIn("lat\ufffdin", self.drawn(graph).words)
        for name in ("a.pdf", "a.png"):
            self.file_drawn(name, graph)

    def test_input_that_cannot_be_drawn_is_refused(self):
        for words, stdin, text in ((["-"], "", "<stdin>:1:1: expected a vertex or an edge"), (["-", "-"], CHAIN, "'-' twice"),
                                   (["-"], "VERTEX_SE2 0 1e308 0 0\n", "finite position"), ([self.path / "none.g2o"], "", "none.g2o"), (["-"], "VERTEX_SE2 0 a 0 0\n", "<stdin>:1:14")):
            done = run("plot", *words, "-o", self.path / "p.svg", stdin=stdin)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(text, done.stderr)
            self.assertFalse((self.path / "p.svg").exists())

    def file_drawn(self, name, *inputs, stdin="", environment=None):
        done = run("plot", *inputs, "-o", self.path / name, stdin=stdin, environment=environment)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return (self.path / name).read_bytes()

    def test_the_extension_of_the_output_selects_the_format(self):
        self.assertTrue(self.file_drawn("a.svg", "-", stdin=CHAIN).startswith(b"<svg "))
        self.assertTrue(self.file_drawn("a.PDF", "-", stdin=CHAIN).startswith(b"%PDF-"))
        self.assertTrue(self.file_drawn("a.png", "-", stdin=CHAIN).startswith(b"\x89PNG"))
        for words, text in ((["-o", self.path / "a.jpg"], "expected a name that ends with .svg, .pdf, .png or .html"),
                            (["-o", self.path / "b.svg", "--format", "png"], "--format: expected svg")):
            self.assert_refused(run("plot", "-", *words, stdin=CHAIN), text)
        done = subprocess.run([BOXPLUS, "plot", "-", "-o", "-", "--format", "pdf"], input=CHAIN.encode(), capture_output=True, check=True)
        self.assertTrue(done.stdout.startswith(b"%PDF-"))

    def test_a_page_contains_what_the_viewer_sends_first(self):
        done = run("plot", self.written("chain.g2o", CHAIN), "-o", self.path / "a.html")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"a\.html: one graph, \d+ kB\n\Z")
        page = (self.path / "a.html").read_text(encoding="utf-8")
        self.assertTrue(page.startswith("<!doctype html>") and page.endswith("</html>\n"))
        messages = messages_of(page)
        self.assertEqual([kind for kind, _ in messages], [STATE, FORM, STRUCTURE, FRAME])
        state = json.loads(messages[0][1])
        self.assertEqual((state["file"]["name"], state["file"]["vertices"], state["file"]["edges"]), ("chain.g2o", 4, 3))
        self.assertEqual(state["chi2"], 0)

    def test_the_page_of_a_robust_graph_has_its_robust_chi2(self):
        outlier = CHAIN + f"EDGE_SE2 0 3 9 9 0 {INFORMATION}\n"
        chi2 = [json.loads(messages_of(run("plot", "-", "-o", "-", "--format", "html", *options, stdin=outlier).stdout)[0][1])["chi2"]
                for options in ((), ("--kernel", "Huber"))]
        self.assertLess(chi2[1], chi2[0] / 2)

    def test_options_of_pictures_are_refused_for_a_page(self):
        chain = self.written("chain.g2o", CHAIN)
        for words, name in (([chain], "AFTER"), (["--truth", chain], "--truth"), (["--title", "a"], "--title"), (["--ellipses"], "--ellipses")):
            self.assert_refused(run("plot", chain, *words, "-o", self.path / "a.html"), f"{name}: expected a picture", "got a page (.html)")
        self.assertFalse((self.path / "a.html").exists())

    def test_a_png_shows_the_trajectory_in_its_colors(self):
        width, height, rows = pixels_of(self.file_drawn("a.png", "-", "--bare", "--size", "300x200", "--resolution", 1, stdin=CHAIN))
        self.assertEqual((width, height), (300, 200))
        self.assertEqual({rows[0][0], rows[-1][-1], rows[10][290 // 2]}, {(255, 255, 255)})
        left, right = rows[149][2], rows[51][297]  # the first and the last pose
        self.assertLess(sum(left), 400, "dark blue")
        self.assertGreater(right[1], max(right[0], right[2]), "green")
        double = self.file_drawn("b.png", "-", "--bare", "--size", "300x200", stdin=CHAIN)
        self.assertEqual(struct.unpack(">II", double[16:24]), (600, 400))

    def test_a_png_shows_its_title(self):
        no_fonts = {"FONTCONFIG_FILE": self.written("fonts.conf", "<fontconfig></fontconfig>")}
        for environment in ({}, no_fonts):
            plain, titled = (pixels_of(self.file_drawn("a.png", "-", "--size", "310x333", "--resolution", 1, "--title", title, stdin=CHAIN,
                                                       environment=environment))[2] for title in (" ", "Title"))
            changed = [y for y, (a, b) in enumerate(zip(plain, titled)) if a != b]
            self.assertTrue(changed and 10 < min(changed) and max(changed) < 30, changed)

    def test_lines_to_points_far_outside_of_a_png_keep_their_direction(self):
        graph = self.path / "a.bal"
        run("simulate", "ba", "--cameras", 40, "--points", 300, "-o", graph)
        lines = graph.read_text(encoding="utf-8").splitlines()
        lines[1 + int(lines[0].split()[2]) + 3] = "1e9"  # the x of the translation of the first camera
        drawing = (self.written("far.bal", "\n".join(lines) + "\n"), "--truth", graph, "--bare", "--size", "300x200")
        rows = pixels_of(self.file_drawn("a.png", *drawing, "--resolution", 1))[2]
        truth = " ".join(path.get("d") for path in self.drawn(*drawing).paths if path.get("stroke") == "#f2d06b")
        segments = [[complex(*map(float, point.split())) for point in segment.split("L")] for segment in truth.split("M")[1:]]
        for begin, end in segments:
            length = abs(end - begin)
            at = begin + 30 * (end - begin) / length
            if length > 1e7 and 0 <= at.real < 300 and 0 <= at.imag < 200:
                self.assertNotEqual(rows[int(at.imag)][int(at.real)], (255, 255, 255), (begin, end))
        self.assertGreater(max(abs(end - begin) for begin, end in segments), 1e7)

    def test_a_pdf_contains_the_lines_and_the_text(self):
        pdf = self.file_drawn("a.pdf", "-", "--title", "A (b) \\ é x²", "--size", "252x200", stdin=CHAIN)
        self.assertIn(b"/MediaBox [ 0 0 252 200 ]", pdf)
        streams = streams_of(pdf)
        self.assertGreaterEqual(streams[0].count(b" l S"), 3)
        letters = {int(letter, 16) for stream in streams for letter in re.findall(rb"^<[0-9a-f]+> <([0-9a-f]{4})>$", stream, re.MULTILINE)}
        self.assertLessEqual(set(map(ord, "A(b)\\éx²·chi2=0poses")), letters)

    def test_a_graph_is_always_drawn_as_the_same_bytes(self):
        for name in ("a.pdf", "a.png"):
            self.assertEqual(self.file_drawn(name, "-", stdin=CHAIN), self.file_drawn(name, "-", stdin=CHAIN))
        self.assertNotIn(b"/CreationDate", self.file_drawn("a.pdf", "-", stdin=CHAIN))

    def test_a_bare_picture_contains_only_the_graph(self):
        picture = self.drawn("-", "--bare", stdin=CHAIN)
        self.assertEqual((picture.words, picture.root.findall(f"{SVG}rect")), ([], []))
        with_axes = self.drawn("-", "--bare", "--axes", stdin=CHAIN)
        self.assertIn("x [m]", with_axes.words)

    def test_axes_show_coordinates(self):
        words = self.drawn("-", "--axes", stdin=CHAIN.replace("3 3 1 0\n", "3 3 1 0\nVERTEX_XY 9 -1 0\n")).words
        for word in ("x [m]", "y [m]", "−1.0", "0.0", "0.5", "2.0", "3.0"):
            self.assertIn(word, words)
        self.assertFalse(any(re.fullmatch(r"\S+ m", word) for word in words), "a scale bar would be redundant")

    def test_graphs_in_space_are_drawn_from_the_chosen_direction(self):
        tower = "".join(f"VERTEX_SE3:QUAT {i} {x} 0 {z} 0 0 0 1\n" for i, (x, z) in enumerate(((0, 0), (1, 8), (0, 16))))
        for view, here, absent in (("top", ("x [m]", "y [m]"), ("z [m]",)), ("side", ("x [m]", "z [m]", "15"), ("y [m]",)),
                                   ("iso", ("x", "y", "z"), ("x [m]",)), ("30,10", ("x", "y", "z"), ("x [m]",))):
            words = self.drawn("-", "--axes", "--view", view, stdin=tower).words
            self.assertTrue(set(here) <= set(words) and not set(absent) & set(words), (view, words))
        dots = [path for path in self.drawn("-", "--bare", "--view", "top", stdin=tower).paths if "h0" in path.get("d")]
        heights = {re.search(r" ([\d.]+)h0", path.get("d"))[1] for path in dots}
        self.assertEqual(len(heights), 1, "from above, all poses of the tower are at the same height in the picture")
        for view in ("below", "1", "1,2,3", "400,0", "0,91", "a,b"):
            self.assert_refused(run("plot", "-", "-o", "-", "--view", view, stdin=tower), "--view: expected top, side, iso")

    def test_the_truth_is_aligned_with_the_graph(self):
        turned = CHAIN.replace("0 0 0 0\n", "0 5 5 0\n").replace("1 1 0 0\n", "1 5 6 0\n").replace("2 2 0 0\n", "2 5 7 0\n").replace("3 3 1 0\n", "3 4 8 0\n")
        picture = self.drawn("-", "--bare", "--truth", self.written("truth.g2o", turned), stdin=CHAIN)
        truth = [path for path in picture.paths if path.get("stroke") == "#f2d06b"]
        shape = lambda paths: {tuple(map(float, p)) for path in paths for p in re.findall(r"([\d.]+) ([\d.]+)", path.get("d"))}  # noqa: E731
        self.assertEqual(len(shape(truth)), 4)
        self.assertEqual(shape(truth), shape(picture.paths), "the rotated truth covers the graph")
        self.assertIn("truth", self.drawn("-", "--truth", self.path / "truth.g2o", stdin=CHAIN).words)
        self.assert_refused(run("plot", "-", "-o", "-", "--truth", self.written("t.txt", "1 0 0 0 0 0 0 1\n"), stdin=CHAIN), "t.txt: expected a graph")
        self.assert_refused(run("plot", "-", "-o", "-", "--truth", self.written("t.g2o", "VERTEX_SE2 77 0 0 0\n"), stdin=CHAIN), "poses that match <stdin> by id")

    def test_the_option_equal_scale_gives_both_panels_the_same_scale(self):
        large = self.written("large", re.sub(r"(VERTEX_SE2 \d) (\d) (\d)", r"\1 \g<2>000 \g<3>000", CHAIN))
        bars = lambda *options: [w for w in self.drawn(self.written("small", CHAIN), large, *options).words if re.fullmatch(r"\S+ m", w)]  # noqa: E731
        self.assertEqual(len(set(bars())), 2)
        self.assertEqual(len(set(bars("--equal-scale"))), 1)

    def test_with_a_kernel_the_colors_show_the_robust_chi2(self):
        graph = CHAIN + f"EDGE_SE2 0 3 3 400 0 {INFORMATION}\n" + f"EDGE_SE2 0 2 2 400 0 {INFORMATION}\n"
        plain, robust = self.drawn("-", stdin=graph), self.drawn("-", "--kernel", "GemanMcClure", "--kernel-width", 1, stdin=graph)
        self.assertNotIn(GRAY, plain.closures())
        self.assertEqual(set(robust.closures()), {GRAY})
        self.assertIn("robust chi2 per row of loop closures", robust.words)
        self.assertTrue(any("(GemanMcClure)" in words for words in robust.words))

    def test_every_number_of_a_picture_is_finite(self):
        far = CHAIN + "VERTEX_SE2 4 1e160 0 0\n" + f"EDGE_SE2 3 4 1 0 0 {INFORMATION}\n"
        wheels = ("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_ODOM_DIFFERENTIAL 9 1 1 0\n"
                  f"EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 0 1 9 1 1 1 {INFORMATION}\n")
        for graph, messages in ((far, 1), (wheels, 0)):
            for options in ((), ("--axes",), ("--kernel", "Huber"), ("--bare",)):
                done = run("plot", "-", "-o", "-", *options, stdin=graph)
                self.assertEqual((done.returncode, done.stderr.count("1 vertex is too far away")), (0, messages), done.stderr)
                self.assertNotRegex(done.stdout, r"(?i)[^a-z](nan|inf)[^a-z]")
                if "--bare" not in options:
                    self.assertIn("chi2 is not finite", done.stdout)

    def test_invalid_sizes_are_refused_and_valid_sizes_are_used(self):
        for words, text in ((["--size", "100"], "WIDTHxHEIGHT"), (["--size", "1x1"], "from 16 to 10000"), (["--size", "nanx100"], "WIDTHxHEIGHT"),
                            (["--font-size", "0"], "--font-size"), (["--format", "png", "--size", "9000x9000"], "at most 5e+07 pixels"),
                            (["--format", "png", "--size", "10000x16", "--resolution", "4"], "at most 32767 pixels per side, got 40000"), (["--resolution", "99"], "--resolution")):
            self.assert_refused(run("plot", "-", "-o", "-", *words, stdin=CHAIN), text)
        picture = self.drawn("-", "--size", "200x150", "--font-size", 9, stdin=CHAIN)
        self.assertEqual((picture.root.get("width"), picture.root.get("height")), ("200", "150"))
        self.assertIn("9", {text.get("font-size") for text in picture.root.iter(f"{SVG}text")})

if __name__ == "__main__":
    main()
