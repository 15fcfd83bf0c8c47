# SPDX-License-Identifier: BSD-3-Clause
"""Pickles of graphs."""

import concurrent.futures
import multiprocessing
import os
import pathlib
import pickle
import tempfile
import unittest

import boxplus
import numpy as np
from boxplus import SE2, SE3, BatchedEdge, Between, Graph, OffsetPointObservation2, Prior, Vector7, optimize
from graph_test import square
from outliers_test import rounds


def optimal_chi2(graph):
    return optimize(graph).chi2_final


class OwnEdge(BatchedEdge):
    def error(self, x):
        return x[:, 0]


class Pickles(unittest.TestCase):
    def again(self, graph):
        return pickle.loads(pickle.dumps(graph))

    def test_a_pickle_keeps_every_bit_of_the_numbers(self):
        random = np.random.default_rng(3)
        for kind, width in ((SE2, 3), (SE3, 7)):
            graph = Graph()
            rows = random.normal(size=(20, width))
            if kind is SE3:
                rows[:, 3:] /= np.linalg.norm(rows[:, 3:], axis=1, keepdims=True)
            graph.add_vertices(kind, np.arange(20) * 3, rows)
            for i in range(19):
                half = random.normal(size=(graph.tangent_dim(0), graph.tangent_dim(0)))
                graph.add_edge(Between(kind.from_vector(rows[i])), 3 * i, 3 * i + 3, information=half @ half.T)
            other = self.again(graph)
            np.testing.assert_array_equal(other.estimates(kind)[0], graph.estimates(kind)[0])
            np.testing.assert_array_equal(other.estimates(kind)[1], graph.estimates(kind)[1])
            for a, b in zip(graph.all_edges(), other.all_edges()):
                np.testing.assert_array_equal(other.information(b), graph.information(a))
                self.assertEqual(other.measurement(b), graph.measurement(a))
            self.assertEqual(other.chi2(), graph.chi2())

    def test_a_pickle_keeps_flags_kernels_and_levels(self):
        graph, (first, second) = square()
        graph.add_vertex([1, 2], id=10)
        graph.add_parameter(SE2(0.1, 0.2, 0.3), id=10)
        offset = graph.add_edge(OffsetPointObservation2([1, 1]), 1, 10, graph.find_parameter(10), information=np.diag([2, 3]))
        prior = graph.add_edge(Prior(SE2(1, 0, 1)), 1)
        again = graph.add_edge(Between(SE2(0, 1, 0)), 2, 0)
        graph.set_kernel([first, prior], "Cauchy", 0.3)
        graph.set_kernel(offset, "Barron:1.5", 2)
        graph.set_enabled(second, False)
        graph.set_level(again, 4)
        graph.set_eliminated(10, True)
        graph.fix_directions(2, [0, 2])
        graph.set_bounds(10, 1, -0.5, 2.5)
        other = self.again(graph)
        edges = {(other.edge_type(edge), *(other.id(vertex) for vertex in other.vertices(edge))): edge
                 for edge in other.all_edges()}
        kernel_of = {key: (other.kernel(edge).name(), other.kernel(edge).delta()) for key, edge in edges.items()
                     if other.kernel(edge)}
        self.assertEqual(kernel_of, {("Between<SE2>", 0, 1): ("Cauchy", 0.3), ("Prior<SE2>", 1): ("Cauchy", 0.3),
                                     ("OffsetPointObservation2", 1, 10, 10): ("Barron", 2)})
        self.assertEqual([key for key, edge in edges.items() if not other.is_enabled(edge)], [("Between<SE2>", 1, 2)])
        self.assertEqual({key: other.level(edge) for key, edge in edges.items() if other.level(edge)},
                         {("Between<SE2>", 2, 0): 4})
        for vertex in (0, 1, 2, 10):
            for flag in ("is_fixed", "is_eliminated", "fixed_directions", "bounds"):
                self.assertEqual(getattr(other, flag)(vertex), getattr(graph, flag)(vertex), (vertex, flag))
        self.assertEqual(other.estimate(other.find_parameter(10)), SE2(0.1, 0.2, 0.3))
        self.assertEqual(other.chi2(), graph.chi2())
        self.assertEqual(optimize(other).chi2_final, optimize(graph).chi2_final)

    def test_a_graph_with_removed_elements_has_its_kernels_on_the_right_edges(self):
        graph, closures, is_false = rounds(150)
        for edge in closures[::3]:
            graph.set_kernel(edge, "Tukey", 3)
        for edge in closures[1::3]:
            graph.remove(edge)
        graph.remove(149)
        graph.add_edge(Between(SE2(0, 0, 0)), 5, 90)  # into the place of a removed edge
        other = self.again(graph)

        def with_kernel(graph):
            return sorted(tuple(graph.id(vertex) for vertex in graph.vertices(edge)) for edge in graph.all_edges()
                          if graph.kernel(edge))
        self.assertEqual(with_kernel(other), with_kernel(graph))
        self.assertEqual(len(with_kernel(other)), 17)

    def test_a_graph_goes_to_another_process(self):
        graph = rounds(120)[0]
        context = multiprocessing.get_context("spawn")
        with concurrent.futures.ProcessPoolExecutor(1, mp_context=context) as pool:
            self.assertEqual(pool.submit(optimal_chi2, graph).result(timeout=120), optimal_chi2(graph))

    def test_the_graph_of_a_file_keeps_its_unknown_lines(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "graph.g2o"
            path.write_text("# town\nVERTEX_SE2 0 0 0 0\nVERTEX_LINE2D 1 0.5 2 -1 -1\nMY_TAG 1 2\n", encoding="utf-8")
            graph = boxplus.load(path)
        self.assertEqual(self.again(graph).to_text(format="g2o"), graph.to_text())

    def test_an_empty_graph_can_be_pickled(self):
        self.assertEqual(self.again(Graph()).vertex_count(), 0)

    def test_what_a_pickle_would_lose_is_refused(self):
        own, pushed, wide = (square()[0] for _ in range(3))
        own.add_edges(OwnEdge(), [0, 1])
        pushed.push()
        wide.add_vertex(Vector7(1, 2, 3, 4, 5, 6, 7))
        for graph, text in ((own, "cannot be pickled: cannot write edges"), (wide, "cannot write vertices of type Vector7"),
                            (pushed, "pushed")):
            with self.subTest(text), self.assertRaisesRegex(TypeError, text):
                pickle.dumps(graph)

    def test_public_graphs_can_be_pickled(self):
        for name in ("posegraph2d/intel_1728.g2o", "posegraph3d/parking-garage.g2o", "posegraph2d/w10000.graph",
                     "bal/problem-16-22106-pre.txt"):
            path = pathlib.Path(os.environ.get("BOXPLUS_DATA", "")) / name
            if path.is_file():
                graph = boxplus.load(path)
                self.assertEqual(self.again(graph).chi2(), graph.chi2(), name)


if __name__ == "__main__":
    unittest.main()
