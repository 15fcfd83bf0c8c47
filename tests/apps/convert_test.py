#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus convert`, which turns TORO files and unsorted files into sorted .g2o files."""

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
        self.assert_refused(run("convert", TOWN, self.path / "out.graph"), "expected a .g2o, BAL's .bal, ",
                            " or .ply as output, because boxplus can only read TORO's .graph")
        self.assert_refused(run("convert", TOWN), "expected OUT, got none")
        self.assert_refused(run("convert", TOWN, ""), "OUT: expected the name of a file, got ''")
        self.assertEqual(out.read_text(encoding="utf-8"), "precious")

if __name__ == "__main__":
    main()
