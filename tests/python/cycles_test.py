# SPDX-License-Identifier: BSD-3-Clause
"""Cycles of references through graphs, options and edges end when Python's garbage collector runs."""

import copy
import functools
import gc
import threading
import unittest
import weakref

import boxplus
import g2o
import numpy as np
from boxplus import SE2, BatchedEdge, Constraint, Graph, Optimizer, Options, Prior


class Node:
    """Something that a garbage collector should find."""


def graph_with(function):
    graph = Graph()
    graph.add_vertex(SE2(1, 2, 3))
    graph.add_edge(function, 0)
    return graph


def graph_in_lambda(node):
    graph = Graph()
    graph.add_vertex(SE2(1, 2, 3))
    graph.add_edge(lambda x, kept=(graph, node): x.x(), 0)


def graph_in_its_own_method(node):
    graph = Graph()
    graph.add_vertex(SE2(1, 2, 3))
    graph.add_edge(functools.partial(lambda chi2, kept, x: x.x(), graph.chi2, node), 0)


def graph_in_batched_edge(node):
    class Edge(BatchedEdge):
        def error(self, x):
            return x[:, 0]

    graph, edge = Graph(), Edge()
    edge.graph, edge.node = graph, node
    graph.add_vertex(SE2(1, 2, 3))
    graph.add_edges(Constraint(edge), [0])


def graph_copy_and_optimizer(node):
    """The object of a program that has everything as its members."""
    node.graph = graph_with(lambda x: 0 * len(vars(node)) + x.x())
    node.copy = copy.copy(node.graph)
    node.optimizer = Optimizer(node.graph, callback=lambda record: node)
    node.optimizer.run()
    node.covariance = boxplus.covariance(node.graph, [0], gauge="damp")


def derived_graph(node):
    class Own(Graph):
        pass

    graph = Own()
    graph.node = node
    graph.add_vertex(SE2())
    graph.add_edge(lambda x: 0 * graph.vertex_count() + x.x(), 0)


def graph_in_options(node):
    node.options = Options(callback=lambda record: node)


def graph_in_edges(node):
    node.prior = Prior([node])
    node.constraint = Constraint(lambda x: node)


def g2o_optimizer(node):
    class Own(g2o.EdgeSE2):
        def compute_error(self):
            return np.zeros(3)

    optimizer = g2o.SparseOptimizer()
    optimizer.set_algorithm(g2o.OptimizationAlgorithmGaussNewton(g2o.BlockSolverSE2(g2o.LinearSolverDenseSE2())))
    for i in range(2):
        vertex = g2o.VertexSE2()
        vertex.set_id(i)
        vertex.set_estimate(g2o.SE2(i, 0, 0))
        vertex.set_fixed(i == 0)
        optimizer.add_vertex(vertex)
    edge = Own()
    edge.node = node
    for i in range(2):
        edge.set_vertex(i, optimizer.vertex(i))
    edge.set_measurement(g2o.SE2(1, 1, 0))
    edge.set_information(np.eye(3))
    optimizer.add_edge(edge)
    optimizer.initialize_optimization()
    optimizer.optimize(2)


CYCLES = (graph_in_lambda, graph_in_its_own_method, graph_in_batched_edge, graph_copy_and_optimizer, derived_graph,
          graph_in_options, graph_in_edges, g2o_optimizer)


class Cycles(unittest.TestCase):
    def test_the_collector_finds_every_cycle(self):
        for make in CYCLES:
            with self.subTest(make.__name__):
                node = Node()
                seen = weakref.ref(node)
                make(node)
                del node
                gc.collect()
                self.assertIsNone(seen())

    def test_the_number_of_objects_does_not_grow(self):
        def count():
            for _ in range(20):
                for make in CYCLES[:-2]:
                    make(Node())
            gc.collect()
            return len(gc.get_objects())

        count()
        first = count()
        self.assertLess(count() - first, 20)

    def test_an_error_function_stays_while_an_optimizer_or_a_copy_uses_it(self):
        for keep in (Optimizer, copy.copy):
            node = Node()
            node.x = 5
            graph = graph_with(lambda x, node=node: [x.x() - node.x, x.y(), x.theta()])
            graph.add_edge(lambda x, kept=graph: 0.0, 0)
            kept = keep(graph)
            del node, graph
            gc.collect()
            report = kept.run() if isinstance(kept, Optimizer) else boxplus.optimize(kept)
            self.assertAlmostEqual(report.chi2_final, 0)

    def test_a_collection_during_a_run_takes_nothing_away(self):
        graph = graph_with(lambda x: (gc.collect(), [x.x() - 5, x.y(), x.theta()])[1])
        graph.add_edge(lambda x, kept=graph: 0.0, 0)
        is_over = threading.Event()

        def collect():
            while not is_over.is_set():
                gc.collect()

        thread = threading.Thread(target=collect)
        thread.start()
        try:
            for start in ("current", "automatic"):
                self.assertTrue(boxplus.optimize(graph, start=start, callback=lambda record: gc.collect() >= 0).converged())
        finally:
            is_over.set()
            thread.join()
        self.assertAlmostEqual(graph.estimate(0).x(), 5)


if __name__ == "__main__":
    unittest.main()
