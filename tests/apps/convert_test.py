#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus convert`, which turns TORO files and unsorted files into sorted .g2o files."""

import json

from command_case import TOWN, CommandCase, main, run

TORO = "VERTEX2 1 1 0 0\nVERTEX2 0 0 0 0\nEDGE2 0 1 1 0 0 11 12 22 33 13 23\n"

class ConvertTest(CommandCase):
    def test_toro_becomes_g2o_sorted_by_id(self):
        toro = TORO.replace("11 12 22 33 13 23", "51 2 52 53 3 4")
        out = self.path / "out.g2o"
        done = run("convert", self.written("in.graph", toro), out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("2 vertices, 1 edge\n", done.stdout)
        self.assertEqual(out.read_text(encoding="utf-8"),
                         "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 51 2 3 52 4 53\n")

    def test_graphs_become_toro_and_gm2dl_files(self):
        lines = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 51 2 3 52 4 53\n"
        g2o = self.written("in.g2o", "PARAMS_SE2OFFSET 0 0 0 0\n" + lines)
        for name, vertex, edge in (("out.graph", "VERTEX2", "EDGE2"), ("out.gm2dl", "VERTEX", "EDGE")):
            done = run("convert", g2o, self.path / name)
            self.assertEqual(done.returncode, 0)
            self.assertIn("1 parameter", done.stderr)
            self.assertEqual((self.path / name).read_text(encoding="utf-8"),
                             f"{vertex} 0 0 0 0\n{vertex} 1 1 0 0\n{edge} 0 1 1 0 0 51 2 52 53 3 4\n")
            self.assertEqual(run("convert", self.path / name, "-").stdout, lines)

    def test_converting_a_converted_file_does_not_change_it(self):
        once = run("convert", TOWN, "-").stdout
        again = run("convert", "-", "-", stdin=once)
        self.assertEqual(again.stdout, once)
        self.assertIn("<stdin> → <stdout>: 120 vertices, 125 edges", again.stderr)
        self.assertEqual(run("convert", "-", "-", "--quiet", stdin=once).stderr, "")

    def test_tags_can_be_renamed_and_lines_skipped(self):
        text = "OLD 0 0 0 0\nOLD 1 x 0 0\nMYSTERY 1 2 3\n"
        done = run("convert", "-", "-", "--lenient", "--rename", "OLD=VERTEX_SE2", stdin=text)
        self.assertEqual((done.returncode, done.stdout), (0, "VERTEX_SE2 0 0 0 0\nMYSTERY 1 2 3\n"))
        self.assertIn("1 vertex, 0 edges, 1 other line kept, 1 line skipped", done.stderr)

    def test_refuses_bad_input_and_changes_no_file(self):
        out = self.written("out.g2o", "precious")
        self.assert_refused(run("convert", self.written("bad.g2o", "VERTEX_SE2 0\n"), out), "bad.g2o:1:13: expected")
        self.assert_refused(run("convert", TOWN, self.path / "out.isam"), "expected a .g2o, TORO's .graph, ",
                            " or .ply as output, because boxplus can only read iSAM's .isam")
        self.assert_refused(run("convert", TOWN), "expected OUT, got none")
        self.assert_refused(run("convert", TOWN, ""), "OUT: expected the name of a file, got ''")
        self.assertEqual(out.read_text(encoding="utf-8"), "precious")

    def test_stereo_cameras_become_poses_with_a_camera_and_chi2_stays(self):
        # bf = 500 · 0.1 = 50. Vertex 5 is 5 m in front of both cameras, at u = 320.
        text = ("VERTEX_CAM 3 0 0 0 0 0 0 1 500 510 320 240 0.1\nFIX 3\nVERTEX_CAM 4 1 0 0 0 0 0 1 500 510 320 240 0.1\n"
                "VERTEX_TRACKXYZ 5 0 0 5\nEDGE_PROJECT_P2SC 5 3 321 242 310 2 0.1 0.2 3 0.3 4\n# a comment\n"
                "EDGE_PROJECT_P2MC 5 4 220 240 2 0.5 3\nEDGE_CAM 3 4 1.1 0 0 0 0 0 1 1 0 0 0 0 0 2 0 0 0 0 3 0 0 0 4 0 0 5 0 6\n")
        path = self.written("in.g2o", text)
        out = self.path / "out.g2o"
        done = run("convert", path, out, "--to", "slam3d")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        # J = [1 0 0; 0 1 0; 1 0 -50]
        self.assertEqual(out.read_text(encoding="utf-8"),
                         "PARAMS_CAMERACALIB 0 0 0 0 0 0 0 1 500 510 320 240\nVERTEX_SE3:QUAT 3 0 0 0 0 0 0 1\nFIX 3\n"
                         "VERTEX_SE3:QUAT 4 1 0 0 0 0 0 1\nVERTEX_TRACKXYZ 5 0 0 5\n"
                         "EDGE_PROJECT_DISPARITY 3 5 0 321 242 0.22 6.4 0.4 -210 3 -15 10000\n# a comment\n"
                         "EDGE_PROJECT_DISPARITY 4 5 0 220 240 0 2 0.5 0 3 0 0\n"
                         "EDGE_SE3:QUAT 3 4 1.1 0 0 0 0 0 1 1 0 0 0 0 0 2 0 0 0 0 3 0 0 0 4 0 0 5 0 6\n")
        before, after = (json.loads(run("info", each, "--json", "-").stdout)["chi2"] for each in (path, out))
        self.assertGreater(before, 1)
        self.assertAlmostEqual(before, after, delta=1e-9 * before)

    def test_cameras_are_refused_if_an_edge_has_no_counterpart(self):
        camera = "VERTEX_CAM 3 0 0 0 0 0 0 1 500 510 320 240 0\nVERTEX_CAM 4 1 0 0 0 0 0 1 500 510 320 240 0\n"
        for edge, complaint in (("EDGE_SCALE 3 4 2 1\n", "got an edge of type Range of the vertices 3, 4"),
                                ("VERTEX_TRACKXYZ 5 0 0 5\nEDGE_PROJECT_P2SC 5 3 321 242 310 2 0 0 3 0 4\n", "baseline ≠ 0")):
            self.assert_refused(run("convert", "-", "-", "--to", "slam3d", stdin=camera + edge), complaint)
        self.assert_refused(run("convert", TOWN, "-", "--to", "slam3d"), "expected stereo cameras (VERTEX_CAM), got none")

    def test_segments_become_lines(self):
        # The segment from (-1, 2) to (1, 2) is on the line with the normal (0, -1) and ρ = -2.
        text = ("VERTEX_SE2 0 0 0 0\nVERTEX_SEGMENT2D 1 -1 2 1 2\nFIX 1\nEDGE_SE2_SEGMENT2D 0 1 -1 2 1 2 1 0 0 0 1 0 0 1 0 1\n"
                "EDGE_SE2_SEGMENT2D_LINE 0 1 -1.5 -2 3 1 4\nEDGE_SE2_SEGMENT2D_POINTLINE 0 1 1 1 2 -1.5707963267948966 4 0 0 5 0 6\n")
        done = run("convert", "-", "-", "--to", "lines", stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line.split() for line in done.stdout.splitlines()]
        self.assertEqual([line[0] for line in lines],
                         ["VERTEX_SE2", "VERTEX_LINE2D", "FIX", "EDGE_SE2_LINE2D", "EDGE_SE2_LINE2D", "EDGE_SE2_LINE2D"])
        # The ends at a distance of 1 from the center: Ω = diag(2, 2). The end (1, 2) is at t = 1: the error of y is
        # that of ρ and of t θ, so Ω = [6 + 5, -5; ., 5] with n = (0, -1).
        expected = [[0, 0, 0, 0], [1, -1.5707963267948966, -2, -1, -1], [1], [0, 1, -1.5707963267948966, -2, 2, 0, 2],
                    [0, 1, -1.5, -2, 3, 1, 4], [0, 1, -1.5707963267948966, -2, 11, -5, 5]]
        for line, numbers in zip(lines, expected):
            self.assertEqual(len(line) - 1, len(numbers))
            for field, number in zip(line[1:], numbers):
                self.assertAlmostEqual(float(field), number, places=12)
        self.assert_refused(run("convert", TOWN, "-", "--to", "lines"), "expected segments (VERTEX_SEGMENT2D), got none")
        self.assert_refused(run("convert", "-", "-", "--to", "lines", stdin="VERTEX_SEGMENT2D 1 1 2 1 2\n"), "(1, 2) twice")

    def test_measured_vertices_are_anonymized_and_all_else_stays(self):
        unit = "1 0 0 1 0 1"
        text = ("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nVERTEX_SE2 2 2 0 0\nVERTEX_XY 7 1 1\nVERTEX_XY 8 1 2\n"
                f"EDGE_SE2 0 1 1 0 0 {unit}\nEDGE_SE2_XY 1 7 0 1 1 0 1\n# after the observation\nEDGE_SE2 2 0 -2 0 0 {unit}\n"
                f"EDGE_SE2_LOTSOFXY 0 7 8 || 2 1 1 1 2 1 0 0 0 1 0 0 1 0 1\nEDGE_POINTXY 7 8 0 1 1 0 1\nEDGE_PRIOR_SE2 0 0 0 0 {unit}\n")
        done = run("convert", "-", "-", "--anonymize", stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = text.replace("XY 1 7 ", "XY 1 -1 ").replace("SE2 2 0 ", "SE2 2 -1 ")
        expected = expected.replace("XY 0 7 8 ", "XY 0 -1 -1 ").replace("XY 7 8 ", "XY 7 -1 ")
        self.assertEqual(done.stdout, expected)
        self.assertIn("5 vertices, 2 edges, 5 other lines kept, 4 edges anonymized", done.stderr)
        again = run("convert", "-", "-", stdin=done.stdout)
        self.assertEqual(again.stdout, expected)
        self.assertIn("4 edges with the unassigned vertex -1", again.stderr)

    def test_pictures_and_data_for_other_programs_are_written(self):
        for name, begin in (("out.wrl", "#VRML V2.0 utf8\n"), ("out.gnuplot", "# gnuplot data of a graph")):
            done = run("convert", TOWN, self.path / name)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue((self.path / name).read_text(encoding="utf-8").startswith(begin))
            self.assert_refused(run("info", self.path / name), "which boxplus can only write")

if __name__ == "__main__":
    main()
