# SPDX-License-Identifier: BSD-3-Clause
"""load() and save()."""

import pathlib
import tempfile
import unittest
import warnings

import numpy as np

import boxplus
from arrays_test import FILE_2D, FILE_3D


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "graph.g2o"

    def load(self, text, **options):
        self.path.write_text(text, encoding="utf-8")
        return boxplus.load(self.path, **options)

    def test_a_saved_graph_equals_the_loaded_graph(self):
        for text in (FILE_2D, FILE_3D):
            graph = self.load("# a comment\n" + text)
            graph.save(self.path)
            self.assertTrue(self.path.read_text(encoding="utf-8").startswith("# a comment\n"))
            self.assertEqual(boxplus.load(str(self.path)).to_text(), graph.to_text())
            self.assertEqual(graph.format, "g2o")

    def test_saving_warns_of_bounds_that_the_format_does_not_keep(self):
        graph = boxplus.Graph()
        vertex = graph.add_vertex(np.array([0.0, 0.0]))
        graph.set_bounds(vertex, 0, lower=0)
        with self.assertWarnsRegex(RuntimeWarning, "does not keep the bounds of 1 vertex"):
            graph.save(self.path)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            graph.save(self.path.with_suffix(".json"))

    def test_edges_with_functions_are_never_left_out_without_a_word(self):
        graph = boxplus.Graph()
        pose, point = graph.add_vertex(boxplus.SE3()), graph.add_vertex([0.0, 0, 5])
        camera = graph.add_parameter(boxplus.PinholeCamera(500, 500, 320, 240))
        graph.add_edge(boxplus.Reprojection([320, 240]), pose, point, camera)
        graph.add_edge(lambda x: x[0], point)
        for name in ("COLMAP", "COLMAP-text"):
            with self.assertWarnsRegex(RuntimeWarning, "the format does not keep 1 edge <lambda>"):
                graph.save(self.path.with_name(name), format=name)
            self.assertEqual(graph.losses(self.path.with_name(name), format=name), ["1 edge <lambda>"])
        graph.remove(graph.find_parameter(0))
        for name in ("g2o", "json"):
            with self.assertRaisesRegex(boxplus.InvalidArgument, "cannot write edges of type <lambda>"):
                graph.save(self.path.with_suffix("." + name))

    def test_bad_input_is_an_error_with_file_line_and_column(self):
        with self.assertRaises(boxplus.InputError) as raised:
            self.load(FILE_2D + "VERTEX_SE2 5 0 zero 0\n")
        self.assertTrue(str(raised.exception).startswith(f"{self.path}:8:16: "), raised.exception)
        self.assertEqual((raised.exception.line, raised.exception.column), (8, 16))

    def test_indefinite_information_is_refused_or_projected(self):
        text = FILE_2D + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1\n"
        with self.assertRaisesRegex(boxplus.InputError, "positive semi-definite"):
            self.load(text)
        graph = self.load(text, information="project")
        self.assertTrue(any("nearest positive semi-definite" in note.text for note in graph.notes))
        graph = self.load(text, information="as-given")
        self.assertTrue(any("as given" in note.text for note in graph.notes))
        with self.assertRaisesRegex(ValueError, '"refuse", "project" or "as-given"'):
            self.load(text, information="any")

    def test_lenient_reading_notes_the_lines_that_it_skips(self):
        graph = self.load(FILE_2D + "VERTEX_SE2 5 0 zero 0\n", lenient=True)
        self.assertEqual([(note.line, note.skipped) for note in graph.notes], [(8, True)])

    def test_unknown_tags_are_noted_and_kept(self):
        graph = self.load(FILE_2D + "MY_TAG 1 2\n")
        self.assertEqual(len(graph.notes), 1)
        self.assertIn("MY_TAG 1 2\n", graph.to_text())

    def test_a_file_with_edges_only_has_created_vertices(self):
        edges = "".join(line + "\n" for line in FILE_2D.splitlines() if line.startswith("EDGE"))
        graph = self.load(edges)
        self.assertTrue(graph.vertices_created)
        self.assertTrue(boxplus.optimize(graph, start="chordal").converged())

    def test_a_type_without_a_class_can_be_loaded_optimized_and_saved(self):
        graph = self.load("VERTEX_SE2 0 0 0 0\nFIX 0\nVERTEX_LINE2D 1 0.5 2 -1 -1\nEDGE_SE2_LINE2D 0 1 0.4 2.5 1 0 1\n")
        self.assertTrue(boxplus.optimize(graph).converged())
        self.assertIn("VERTEX_LINE2D 1 0.4", graph.to_text())
        with self.assertRaisesRegex(TypeError, "vertex 1: expected one of the types .*, got a Line2"):
            graph.estimate(1)
        with self.assertRaisesRegex(TypeError, "got a LineObservation2, which has no Python class"):
            graph.measurement(graph.all_edges()[0])

    def test_a_file_that_cannot_be_written_or_read_is_an_os_error(self):
        with self.assertRaises(OSError):
            boxplus.load(self.path)
        with self.assertRaises(boxplus.FileError):
            boxplus.Graph().save(self.path / "no" / "folder.g2o")


if __name__ == "__main__":
    unittest.main()
