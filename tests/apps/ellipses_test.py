#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus plot --ellipses`, which draws the regions that contain poses and points with 95 % probability."""

import re
import xml.etree.ElementTree

from command_case import CommandCase, main, run

SVG = "{http://www.w3.org/2000/svg}"
RADIUS_95 = 2.4477  # in standard deviations: √ of the 95 % quantile of chi2 with two degrees of freedom
# A fixed pose, and a pose 10 m ahead of it with a standard deviation of 0.2 m along and 0.4 m across.
TWO_POSES = """VERTEX_SE2 0 0 0 0
FIX 0
VERTEX_SE2 1 10 0 0
EDGE_SE2 0 1 10 0 0 25 0 0 6.25 0 10000
"""
# A point that the fixed pose sees 10 m to its left, with a standard deviation of 0.5 m in each direction.
POINT = """VERTEX_XY 2 0 10
EDGE_SE2_XY 0 2 0 10 4 0 4
"""

class Picture:
    CORNERS = 48

    def __init__(self, text):
        root = xml.etree.ElementTree.fromstring(text)
        self.words = [text.text for text in root.iter(f"{SVG}text")]
        self.height = float(root.get("height"))
        lines = [[float(x) for x in re.findall(r"-?[\d.]+", path.get("d"))] for path in root.findall(f"{SVG}path")]
        shapes = [list(zip(line[::2], line[1::2])) for line in lines if len(line) >= 4]
        ellipses = [shape for shape in shapes if len(shape) == self.CORNERS + 1 and shape[0] == shape[-1]]
        self.ellipses = [shape for shape in ellipses if self.in_panel(shape)]
        self.in_legend = len(ellipses) - len(self.ellipses)
        self.trajectory = next((shape for shape in shapes if len(shape) == 2 and self.in_panel(shape)), None)

    def in_panel(self, shape):
        return max(y for _, y in shape) < self.height - 74

    def pixels_per_meter(self, meters):
        (x0, y0), (x1, y1) = self.trajectory[0], self.trajectory[-1]
        return ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5 / meters

def extent(shape):
    """Width, height and center of the box around a shape."""
    xs, ys = [x for x, _ in shape], [y for _, y in shape]
    return max(xs) - min(xs), max(ys) - min(ys), (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2

class EllipsesTest(CommandCase):
    def drawn(self, *words, stdin):
        done = run("plot", "-", "--ellipses", *words, "-o", "-", stdin=stdin)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Picture(done.stdout)

    def test_ellipses_have_the_semi_axes_of_the_covariance(self):
        picture = self.drawn(stdin=TWO_POSES)
        self.assertEqual(len(picture.ellipses), 1, "the fixed pose has no ellipse")
        width, height, x, y = extent(picture.ellipses[0])
        scale = picture.pixels_per_meter(10)
        self.assertAlmostEqual(width, 2 * RADIUS_95 * 0.2 * scale, delta=0.5)
        self.assertAlmostEqual(height, 2 * RADIUS_95 * 0.4 * scale, delta=0.5)
        self.assertAlmostEqual(x, picture.trajectory[-1][0], delta=0.2)
        self.assertAlmostEqual(y, picture.trajectory[-1][1], delta=0.2)
        self.assertIn("95 % ellipses", picture.words)
        self.assertEqual(picture.in_legend, 1)

    def test_ellipses_turn_with_the_pose(self):
        turned = "VERTEX_SE2 0 0 0 1.5707963267948966\nFIX 0\nVERTEX_SE2 1 0 10 1.5707963267948966\n"
        width, height, *_ = extent(self.drawn(stdin=turned + TWO_POSES.splitlines()[-1] + "\n").ellipses[0])
        self.assertAlmostEqual(width / height, 2, delta=0.05)

    def test_ellipses_are_drawn_for_points(self):
        picture = self.drawn(stdin=TWO_POSES + POINT)
        self.assertEqual(len(picture.ellipses), 2)
        scale = picture.pixels_per_meter(10)
        sizes = sorted(extent(ellipse)[0] for ellipse in picture.ellipses)
        self.assertAlmostEqual(sizes[1], 2 * RADIUS_95 * 0.5 * scale, delta=0.5)

    def test_ellipses_of_graphs_in_space_are_projected(self):
        space = """VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1
FIX 0
VERTEX_SE3:QUAT 1 10 0 0 0 0 0 1
EDGE_SE3:QUAT 0 1 10 0 0 0 0 0 1 25 0 0 0 0 0 6.25 0 0 0 0 1 0 0 0 10000 0 0 10000 0 10000
"""
        for view, height in (("top", 0.4), ("side", 1.0)):  # in the picture, y points up in the first view, and z in the second
            picture = self.drawn("--view", view, stdin=space)
            size = extent(picture.ellipses[0])
            scale = picture.pixels_per_meter(10)
            self.assertAlmostEqual(size[0], 2 * RADIUS_95 * 0.2 * scale, delta=0.5)
            self.assertAlmostEqual(size[1], 2 * RADIUS_95 * height * scale, delta=0.5)

    def test_ellipses_of_large_graphs_are_few_enough_to_be_distinguished(self):
        graph = self.path / "s.g2o"
        run("simulate", "manhattan", "--poses", 3000, "-o", graph)
        run("optimize", graph, "-q", "-o", graph)
        done = run("plot", graph, "--ellipses", "-o", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        picture = Picture(done.stdout)
        self.assertLessEqual(len(picture.ellipses), 300)
        self.assertGreater(len(picture.ellipses), 3)
        boxes = [extent(ellipse) for ellipse in picture.ellipses]
        for i, a in enumerate(boxes):
            for b in boxes[:i]:
                self.assertGreater(abs(a[2] - b[2]) + abs(a[3] - b[3]), 9, "two ellipses are at one place")

    def test_ellipses_that_are_too_small_are_left_out_and_the_legend_says_so(self):
        certain = TWO_POSES.replace("25 0 0 6.25", "1e8 0 0 1e8")
        picture = self.drawn(stdin=certain)
        self.assertEqual(picture.ellipses, [])
        self.assertIn("95 % ellipses: too small to see", picture.words)

    def test_ellipses_stay_within_their_panel(self):
        vague = TWO_POSES.replace("25 0 0 6.25", "0.01 0 0 0.01")
        picture = self.drawn(stdin=vague)
        self.assertTrue(all(0 <= x <= 620 and 0 <= y <= 592 for shape in picture.ellipses for x, y in shape))

    def test_ellipses_are_refused_if_a_vertex_is_undetermined_and_the_message_names_it(self):
        lonely = TWO_POSES + "VERTEX_XY 7 1 1\nEDGE_BEARING_SE2_XY 0 7 0.7 1\n"
        done = run("plot", "-", "--ellipses", "-o", "-", stdin=lonely)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("vertex 7", done.stderr)
        self.assertIn("<stdin>", done.stderr)

if __name__ == "__main__":
    main()
