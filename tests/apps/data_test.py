#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests what the sub-commands do with lines of data: laser scans, names and ellipses that belong to a vertex."""

import math
import re
import xml.etree.ElementTree

from command_case import CommandCase, main, run

SVG = "{http://www.w3.org/2000/svg}"
SCAN_COLOR, MATCH_COLOR = "#8b9dae", "#6b7280"
# Three beams: to the right, ahead (nothing within 20 m), and to the left. The laser is 1 m in front of the robot.
SCAN = "ROBOTLASER1 0 -1.5707963267948966 3.14 1.5707963267948966 20 0 0 3 2 20 4 0 1 0 0 0 0 0 0 0 0 0 0 5 robot 5\n"
TAG = "VERTEX_TAG kitchen 3 0 0 0 0 0 5 robot 5\n"
ELLIPSE = "VERTEX_ELLIPSE 0.25 0 0 0.04 0 0.1 1 2 2\n"
# The second pose is 10 m to the right of the first pose, and looks up.
GRAPH = """VERTEX_SE2 0 0 0 0
VERTEX_SE2 1 10 0 1.5707963267948966
{}EDGE_SE2 0 1 10 0 1.5707963267948966 1 0 0 1 0 1
"""

class Picture:
    LEGEND = 74  # pixels

    def __init__(self, text):
        root = xml.etree.ElementTree.fromstring(text)
        self.texts = list(root.iter(f"{SVG}text"))
        self.words = [text.text for text in self.texts]
        bottom = float(root.get("height")) - self.LEGEND
        self.shapes = []
        for path in root.findall(f"{SVG}path"):
            for line in path.get("d").split("M")[1:]:
                numbers = [float(x) for x in re.findall(r"-?[\d.]+", line.replace("h0", "").replace("l0 0", ""))]
                shape = list(zip(numbers[::2], numbers[1::2]))
                if max(y for _, y in shape) < bottom:
                    self.shapes.append((path.get("stroke"), shape))
        self.trajectory = next(shape for color, shape in self.shapes
                               if len(shape) == 2 and color not in (SCAN_COLOR, MATCH_COLOR))
        (x0, y0), (x1, _) = self.trajectory
        self.origin, self.scale = (x0, y0), (x1 - x0) / 10

    def to_world(self, point):
        return ((point[0] - self.origin[0]) / self.scale, (self.origin[1] - point[1]) / self.scale)

    def of_color(self, color):
        return [[self.to_world(point) for point in shape] for stroke, shape in self.shapes if stroke == color]

    def ellipses(self):
        return [[self.to_world(point) for point in shape] for _, shape in self.shapes if len(shape) == 49]

class DataTest(CommandCase):
    def assert_points(self, points, expected):
        self.assertEqual(len(points), len(expected))
        for point, place in zip(sorted(points), sorted(expected)):
            for x, y in zip(point, place):
                self.assertAlmostEqual(x, y, delta=0.03)

    def drawn(self, data, *words):
        done = run("plot", "-", *words, "-o", "-", stdin=GRAPH.format(data))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Picture(done.stdout)

    def test_plot_draws_what_the_laser_has_hit_at_the_pose(self):
        picture = self.drawn(SCAN)
        # The frame of the robot: (1, −2) and (1, 4). The pose turns it by 90° and moves it to (10, 0).
        self.assert_points([shape[0] for shape in picture.of_color(SCAN_COLOR)], [(12, 1), (6, 1)])
        self.assertIn("laser scans", picture.words)
        self.assertTrue(any(words.endswith("1 edge, 1 scan") for words in picture.words), picture.words)
        self.assertNotIn("laser scans", self.drawn("").words)

    def test_plot_writes_names_at_their_places(self):
        picture = self.drawn(TAG)
        text = next(text for text in picture.texts if text.text == "kitchen")
        x, y = picture.to_world((float(text.get("x")), float(text.get("y"))))
        self.assertLess(math.hypot(x - 10, y - 3) * picture.scale, 10, "the text is near its place")

    def test_plot_draws_ellipses_and_matches_in_the_frame_of_the_pose(self):
        picture = self.drawn(ELLIPSE)
        (ellipse,) = picture.ellipses()
        xs, ys = [x for x, _ in ellipse], [y for _, y in ellipse]
        # Standard deviations of 0.5 m along y and 0.2 m along x of the world; 95 % are within 2.4477 of them.
        self.assertAlmostEqual((max(ys) - min(ys)) / 2, 0.5 * 2.4477, delta=0.05)
        self.assertAlmostEqual((max(xs) - min(xs)) / 2, 0.2 * 2.4477, delta=0.05)
        self.assert_points([shape[1] for shape in picture.of_color(MATCH_COLOR) if len(shape) == 2], [(8, 2)])

    def test_plot_places_data_of_poses_in_space(self):
        half = math.sqrt(0.5)
        text = (f"VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 10 0 0 0 0 {half} {half}\n{SCAN}"
                f"EDGE_SE3:QUAT 0 1 10 0 0 0 0 {half} {half} " + "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n")
        done = run("plot", "-", "--view", "top", "-o", "-", stdin=text)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        picture = Picture(done.stdout)
        self.assert_points([shape[0] for shape in picture.of_color(SCAN_COLOR)], [(12, 1), (6, 1)])

    def test_plot_reports_the_place_of_a_malformed_line(self):
        broken = GRAPH.format("VERTEX_TAG kitchen 3 zero 0 0 0 0 5 robot 5\n")
        self.assert_refused(run("plot", "-", "-o", "-", stdin=broken), "<stdin>:3:22: expected the position of a name")
        done = run("plot", "-", "--lenient", "-o", "-", stdin=broken)
        self.assertEqual(done.returncode, 0)
        self.assertIn("skipped: <stdin>:3:22: expected", done.stderr)

    def test_optimize_keeps_data_byte_for_byte_without_a_note(self):
        odd = SCAN.replace("ROBOTLASER1 0", "  ROBOTLASER1\t00 ") + TAG
        text = GRAPH.format(odd).replace("VERTEX_SE2 1 10", "VERTEX_SE2 1 9")
        done = run("optimize", "-", "-o", "-", stdin=text)
        self.assertEqual((done.returncode, done.stderr.count("unknown tag")), (0, 0), done.stderr)
        lines = done.stdout.splitlines(keepends=True)
        self.assertTrue(lines[1].startswith("VERTEX_SE2 1 10 "), lines)
        self.assertEqual("".join(lines[2:4]), odd)

if __name__ == "__main__":
    main()
