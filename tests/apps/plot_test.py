#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""`boxplus plot`: pictures of graphs."""

import re
import xml.etree.ElementTree

from command_case import CommandCase, main, run

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
GREY = "#a6b2c2"


class Picture:
    def __init__(self, text):
        self.root = xml.etree.ElementTree.fromstring(text)
        self.paths = self.root.findall(f"{SVG}path")
        self.words = [text.text for text in self.root.iter(f"{SVG}text")]

    def closures(self):
        """The colours of loop closures, one for each path: grey ones are thinner."""
        return [path.get("stroke") for path in self.paths
                if path.get("stroke-opacity") and path.get("stroke-width") in ("0.7", "1")]

    def numbers(self):
        return [float(number) for path in self.paths for number in re.findall(r"-?[\d.]+", path.get("d"))]


class PlotTest(CommandCase):
    def drawn(self, *inputs, stdin=""):
        done = run("plot", *inputs, "-o", "-", stdin=stdin)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Picture(done.stdout)

    def test_shows_the_graph_before_and_after(self):
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

    def test_colours_loop_closures_by_their_chi2(self):
        good, bad, worse = (f"EDGE_SE2 0 {to} {to} {error} 0 {INFORMATION}\n" for to, error in ((3, 1), (2, 9), (2, 99)))
        self.assertEqual(self.drawn("-", stdin=CHAIN).closures(), [])
        picture = self.drawn("-", stdin=CHAIN + good)
        self.assertEqual(picture.closures(), [GREY])
        self.assertIn("chi2 per row of loop closures", picture.words)
        for bads in (bad, worse):
            colours = self.drawn("-", stdin=CHAIN + good + bads).closures()
            self.assertEqual((len(colours), colours[0]), (2, GREY))
            self.assertNotEqual(colours[1], GREY)

    def test_both_panels_have_one_scale_of_colours(self):
        closure = f"EDGE_SE2 0 3 3 {{}} 0 {INFORMATION}\n"
        before, after = (self.written(name, CHAIN + closure.format(y)) for name, y in (("b", 500), ("a", 8)))
        same, different = self.drawn(after, after), self.drawn(before, after)
        self.assertEqual((len(same.closures()), len(set(same.closures()))), (2, 1))
        self.assertEqual(len(set(different.closures())), 2)
        self.assertNotIn(same.closures()[0], different.closures(), "a darker scale makes the same error lighter")
        self.assertIn("100", same.words)
        self.assertIn("10⁴", different.words)

    def test_stays_sensible_for_tiny_graphs(self):
        one = "VERTEX_SE2 0 3 4 0\n"
        point = "VERTEX_XY 1 3 4\n"
        same = "".join(f"VERTEX_SE2 {i} 7 7 0\n" for i in range(5)) + f"EDGE_SE2 0 1 0 0 0 {INFORMATION}\n"
        for text in (one, point, one + point, same):
            picture = self.drawn("-", stdin=text)
            self.assertGreaterEqual(len(picture.paths), 1)
            self.assertTrue(all(0 <= number <= 700 for number in picture.numbers()), picture.numbers())
            self.assertFalse(any(re.fullmatch(r"\S+ m", words) for words in picture.words), "a scale of what?")

    def test_stays_small_for_large_graphs(self):
        run("simulate", "streets", "--poses", 100_000, "-o", self.path / "s.g2o")
        done = run("plot", self.path / "s.g2o", self.path / "s.g2o", "-o", self.path / "p.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess((self.path / "p.svg").stat().st_size, 8_000_000)

    def test_keeps_the_worst_of_what_lies_on_one_another(self):
        copies = "".join(f"EDGE_SE2 0 3 3 1 0 {INFORMATION}\n" for _ in range(50))
        colours = self.drawn("-", stdin=CHAIN + copies + f"EDGE_SE2 0 3 3 400 0 {INFORMATION}\n").closures()
        self.assertEqual(len(colours), 1)
        self.assertNotEqual(colours[0], GREY)

    def test_titles_are_text(self):
        path = self.written("a<b>&c.g2o", CHAIN)
        self.assertIn("a<b>&c", self.drawn(path).words)

    def test_what_cannot_be_drawn_is_refused(self):
        for words, stdin, text in ((["-"], "", "<stdin>:1:1: expected a vertex or an edge"), (["-", "-"], CHAIN, "'-' twice"),
                                   (["-"], "VERTEX_SE2 0 1e308 0 0\n", "finite place"), ([self.path / "none.g2o"], "", "none.g2o"), (["-"], "VERTEX_SE2 0 a 0 0\n", "<stdin>:1:14")):
            done = run("plot", *words, "-o", self.path / "p.svg", stdin=stdin)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(text, done.stderr)
            self.assertFalse((self.path / "p.svg").exists())


if __name__ == "__main__":
    main()
