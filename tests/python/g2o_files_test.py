# SPDX-License-Identifier: BSD-3-Clause
"""The files of the package g2o are those of boxplus: the same tags, and the same errors of every type."""

import pathlib
import tempfile
import unittest
import warnings

import boxplus
import g2o
import numpy as np
from g2o import _files
from g2o_worlds import WORLDS, optimizer_for


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = str(pathlib.Path(self.folder.name) / "graph.g2o")

    def tearDown(self):
        self.folder.cleanup()

    def written(self, text):
        pathlib.Path(self.path).write_text(text, encoding="utf-8")
        return self.path

    def load(self, text):
        optimizer = g2o.SparseOptimizer()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            ok = optimizer.load(self.written(text))
        return optimizer, ok, [str(warning.message) for warning in caught]

    def test_boxplus_reads_the_same_errors_from_a_saved_file(self):
        for world in WORLDS:
            with self.subTest(world):
                optimizer = optimizer_for(world)
                self.assertTrue(optimizer.save(self.path))
                graph = boxplus.load(self.path)
                self.assertEqual(graph.edge_count(), len(optimizer.edges()))
                self.assertAlmostEqual(graph.chi2() / optimizer.chi2(), 1, delta=1e-9)

    def test_a_saved_file_is_loaded_with_the_same_numbers(self):
        for world in WORLDS:
            with self.subTest(world):
                optimizer = optimizer_for(world)
                optimizer.save(self.path)
                other = g2o.SparseOptimizer()
                self.assertTrue(other.load(self.path))
                self.assertEqual(list(other.vertices()), sorted(optimizer.vertices()))
                for a, b in zip(optimizer.edges(), other.edges()):
                    self.assertIs(type(a), type(b))
                    self.assertAlmostEqual(a.chi2(), b.chi2(), delta=1e-9 * (1 + a.chi2()), msg=repr(a))
                for id, vertex in optimizer.vertices().items():
                    np.testing.assert_allclose(vertex.get_estimate_data(), other.vertex(id).get_estimate_data(), atol=1e-14)
                    self.assertEqual(vertex.fixed(), other.vertex(id).fixed())

    def test_every_type_with_a_tag_is_in_one_of_the_worlds(self):
        elements = [element for world in WORLDS for optimizer in [optimizer_for(world)]
                    for element in (*optimizer.vertices().values(), *optimizer.edges(), *optimizer._parameters.values())]
        self.assertEqual({*_files.VERTICES, *_files.EDGES, *_files.PARAMETERS} - {element._TAG for element in elements}, set())

    def test_the_vertices_may_follow_their_edges(self):
        optimizer, ok, _ = self.load("FIX 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nVERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 3 0 0\n")
        self.assertTrue(ok and optimizer.vertex(0).fixed())
        self.assertEqual(optimizer.chi2(), 4)

    def test_bad_lines_are_named_and_the_others_are_read(self):
        for line, expected in (("VERTEX_SE2 1 1 x 0", "expected a finite number, got 'x'"),
                               ("VERTEX_SE2 1 1 nan 0", "expected a finite number, got 'nan'"),
                               ("VERTEX_SE2 1 1 1_0 0", "expected a finite number, got '1_0'"),
                               ("VERTEX_SE2 1 1 2", "expected a number, got the end of the line"),
                               ("VERTEX_SE2 1 1 2 3 4", "expected the end of the line, got '4'"),
                               ("VERTEX_SE2 0 1 2 3", "expected a new id from 0, got 0"),
                               ("VERTEX_SE3:QUAT 1 0 0 0 0 0 0 2", "expected a quaternion of length 1"),
                               ("EDGE_SE2 0 7 1 0 0 1 0 0 1 0 1", "expected the id of a VertexSE2, got 7"),
                               ("EDGE_PRIOR_SE2_XY 9 1 0 1 0 1", "expected the id of a VertexSE2, got 9"),
                               ("EDGE_SE2_POINTXY_OFFSET 0 5 3 1 0 1 0 1", "expected the id of a ParameterSE2Offset, got 3"),
                               ("EDGE_SE2_LOTSOFXY 0 5 || 2 1 2 1 0 1", "expected || and the number of the 1 points"),
                               ("EDGE_SE2_LOTSOFXY 0 5 1 2 1 0 1", "expected the id of a VertexPointXY, got 1"),
                               ("FIX 8", "there is no vertex with the id 8")):
            with self.subTest(line):
                optimizer, ok, messages = self.load(
                    f"VERTEX_SE2 0 0 0 0\nVERTEX_XY 5 1 1\n{line}\nEDGE_PRIOR_SE2 0 1 0 0 1 0 0 1 0 1\n")
                self.assertFalse(ok)
                self.assertEqual((len(messages), len(optimizer.edges())), (1, 1))
                self.assertIn(f"{self.path}:3: {expected}", messages[0])

    def test_an_unknown_tag_and_a_missing_file_are_named(self):
        optimizer, ok, messages = self.load("VERTEX_SE2 0 0 0 0\nVERTEX_NEW 1 2\nVERTEX_NEW 2 2\n")
        self.assertTrue(ok)
        self.assertIn("skipped 2 lines with the unknown tag VERTEX_NEW", messages[0])
        with self.assertWarnsRegex(RuntimeWarning, "nowhere.g2o"):
            self.assertFalse(optimizer.load("nowhere.g2o"))

    def test_only_edges_of_the_level_are_saved(self):
        optimizer = optimizer_for("plane")
        next(iter(optimizer.edges())).set_level(1)
        optimizer.save(self.path, 1)
        self.assertEqual(boxplus.load(self.path).edge_count(), 1)


if __name__ == "__main__":
    unittest.main()
