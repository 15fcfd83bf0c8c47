# SPDX-License-Identifier: BSD-3-Clause
"""Edges whose error function is written in Python, for one edge or for many."""

import copy
import gc
import threading
import unittest
import warnings
import weakref

import numpy as np

import boxplus
from boxplus import SE2, SE3, BatchedEdge, Between, Graph, Vector2, Vector9, optimize


def rotation_of(angle):
    return np.stack([np.stack([np.cos(angle), -np.sin(angle)], axis=1), np.stack([np.sin(angle), np.cos(angle)], axis=1)],
                    axis=1)


class PlanarBetween(BatchedEdge):
    """The error of Between(SE2): the measured pose inverse times a inverse times b."""

    def error(self, a, b, z):
        relative = np.einsum("nji,nj->ni", rotation_of(a[:, 2]), b[:, :2] - a[:, :2]) - z[:, :2]
        position = np.einsum("nji,nj->ni", rotation_of(z[:, 2]), relative)
        angle = b[:, 2] - a[:, 2] - z[:, 2]
        angle = angle - 2 * np.pi * np.rint(angle / (2 * np.pi))
        return np.concatenate([position, angle[:, None]], axis=1)


class Numeric(PlanarBetween):
    def error(self, a, b, z):
        return super().error(np.array(a), np.array(b), z)


class Distance(BatchedEdge):
    """The distance from a point, with Jacobians."""

    def error(self, x, z):
        return np.linalg.norm(x, axis=1) - z[:, 0]

    def jacobians(self, x, z):
        return [x / np.linalg.norm(x, axis=1, keepdims=True)]


def chain(edge, count=30, seed=1):
    """A loop of poses with noisy measurements."""
    random = np.random.default_rng(seed)
    graph = Graph()
    ids = np.arange(count)
    truth = np.stack([np.cos(ids / 3.0), np.sin(ids / 3.0), ids / 3.0], axis=1)
    graph.add_vertices(SE2, ids, truth + 0.05 * random.normal(size=truth.shape))
    graph.fix(0)
    first, second = np.concatenate([ids[:-1], ids[:-5]]), np.concatenate([ids[1:], ids[5:]])
    between = [(SE2(*truth[i]).inverse() * SE2(*truth[j])).vector() for i, j in zip(first, second)]
    z = np.array(between) + 0.02 * random.normal(size=(len(first), 3))
    omega = np.diag([100.0, 50.0, 400.0])
    graph.add_edges(edge, first, second, measurements=z, informations=omega)
    return graph


class BatchedEdges(unittest.TestCase):
    def test_they_have_the_errors_and_jacobians_of_the_native_edge(self):
        native, own = chain(Between), chain(PlanarBetween())
        for a, b in zip(native.all_edges(), own.all_edges()):
            np.testing.assert_allclose(own.error(b), native.error(a), atol=1e-13)
            for block, expected in zip(own.jacobian(b), native.jacobian(a)):
                np.testing.assert_allclose(block, expected, atol=1e-13)

    def test_they_end_at_the_optimum_of_the_native_edge(self):
        native, own = chain(Between), chain(PlanarBetween())
        expected, report = optimize(native), optimize(own)
        self.assertTrue(report.converged())
        self.assertAlmostEqual(report.chi2_final, expected.chi2_final, delta=1e-9 * expected.chi2_final)
        np.testing.assert_allclose(own.estimates(SE2)[1], native.estimates(SE2)[1], atol=1e-7)

    def test_functions_are_called_once_per_linearization_and_once_per_tried_step(self):
        for threads in (1, 2):
            graph = chain(PlanarBetween(), count=400)
            report = optimize(graph, threads=threads, start="current")
            (cost,) = report.edge_functions
            tries = sum(record.tries for record in report.records)
            self.assertEqual((cost.name, cost.jacobians), ("PlanarBetween", "exact"))
            self.assertLessEqual(cost.calls, 2 * (len(report.records) + tries) + 6)
            self.assertIn("PlanarBetween: ", repr(report))

    def test_the_number_of_threads_does_not_change_the_result(self):
        # The rounding of some functions of NumPy depends on the addresses of arrays, so a few last bits may differ.
        graphs = [chain(PlanarBetween(), count=400) for _ in range(3)]
        for threads, graph in enumerate(graphs, 1):
            optimize(graph, threads=threads)
        for graph in graphs[1:]:
            np.testing.assert_allclose(graph.estimates(SE2)[1], graphs[0].estimates(SE2)[1], rtol=1e-9, atol=1e-12)

    def test_jacobians_of_the_function_are_used(self):
        random = np.random.default_rng(2)
        graph = Graph()
        graph.add_vertices(Vector2, np.arange(50), random.normal(size=(50, 2)) + 3)
        graph.add_edges(Distance(), np.arange(50), measurements=np.linspace(4, 5, 50))
        edge = graph.all_edges()[7]
        x = graph.estimate(7)
        np.testing.assert_allclose(graph.jacobian(edge)[0], [x / np.linalg.norm(x)])
        report = optimize(graph, algorithm="levenberg-marquardt", max_iterations=100)
        self.assertLess(report.chi2_final, 1e-10)
        self.assertEqual(report.edge_functions[0].jacobians, "analytic")

    def test_a_function_without_derivatives_is_differentiated_numerically_with_a_warning(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            graph = chain(Numeric())
            report = optimize(graph)
        self.assertEqual(report.edge_functions[0].jacobians, "numeric")
        self.assertEqual(len([w for w in caught if "Numeric: numeric derivatives" in str(w.message)]), 1)
        native = optimize(chain(Between))
        self.assertAlmostEqual(report.chi2_final, native.chi2_final, delta=1e-6 * native.chi2_final)

    def test_they_work_for_poses_in_space(self):
        class Pose(BatchedEdge):
            def error(self, x, z):
                return x - z

        graph = Graph()
        target = SE3.exp([1, 2, 3, 0.1, -0.2, 0.3])
        vertex = graph.add_vertex(SE3())
        graph.add_edges(Pose(), np.array([graph.id(vertex)]), measurements=[target.vector()])
        numeric = []
        for d in range(6):
            ends = [graph.estimate(vertex).oplus(h * np.eye(6)[d]).vector() for h in (1e-6, -1e-6)]
            numeric.append((ends[0] - ends[1]) / 2e-6)
        np.testing.assert_allclose(graph.jacobian(graph.all_edges()[0])[0], np.transpose(numeric), atol=1e-9)
        self.assertLess(optimize(graph).chi2_final, 1e-20)

    def test_vectors_of_many_sizes_are_vertices(self):
        class Line(BatchedEdge):
            def error(self, x, t):
                return (x * t ** np.arange(9.0)).sum(axis=1) - np.cos(t[:, 0])

        graph = Graph()
        vertex = graph.add_vertex(np.zeros(9))
        graph.add_edges(Line(), graph.id(vertex), measurements=np.linspace(-1, 1, 100))
        self.assertTrue(optimize(graph).converged())
        self.assertAlmostEqual(graph.estimate(vertex)[2], -0.5, delta=1e-4)
        self.assertEqual(graph.estimates(Vector9)[1].shape, (1, 9))

    def test_kernels_disabled_edges_and_removed_edges(self):
        graph, native = chain(PlanarBetween()), chain(Between)
        for each in (graph, native):
            edges = each.all_edges()
            each.set_kernel(edges[:10], "Huber", 0.1)
            each.set_enabled(edges[12], False)
            each.remove(edges[3])
        self.assertAlmostEqual(optimize(graph).chi2_final, optimize(native).chi2_final, delta=1e-8)
        before = graph.edge_count()
        graph.add_edges(PlanarBetween(), [0], [1], measurements=[[0, 0, 0]])
        self.assertEqual(graph.edge_count(), before + 1)

    def test_slots_of_removed_edges_are_used_again(self):
        edge = PlanarBetween()
        graph = chain(edge)
        removed = graph.all_edges()[4]
        graph.remove(removed)
        (new,) = graph.add_edges(edge, [0], [2], measurements=[[1, 2, 0.5]])
        self.assertEqual(graph.edge_type(new), "PlanarBetween")
        np.testing.assert_allclose(graph.error(new), edge.error(*(graph.estimates(SE2)[1][k:k + 1] for k in (0, 2)),
                                                                np.array([[1, 2, 0.5]]))[0])

    def test_a_copy_of_a_graph_has_its_own_edges(self):
        graph = chain(PlanarBetween())
        other = copy.copy(graph)
        optimize(other)
        self.assertNotEqual(graph.chi2(), other.chi2())
        del graph
        gc.collect()
        self.assertTrue(optimize(other).converged())

    def test_estimates_that_change_change_the_error(self):
        graph = chain(PlanarBetween())
        edge = graph.all_edges()[0]
        before = graph.error(edge)
        graph.set_estimate(1, SE2(5, 5, 5))
        self.assertGreater(np.abs(graph.error(edge) - before).max(), 1)

    def test_covariances_and_diagnosis_work(self):
        graph, native = chain(PlanarBetween()), chain(Between)
        for each in (graph, native):
            optimize(each)
        of_own, of_native = (boxplus.covariance(each, [5]) for each in (graph, native))
        np.testing.assert_allclose(of_own.of(5), of_native.of(5), rtol=1e-6)
        self.assertIsNotNone(boxplus.diagnose(graph))


    def test_parameters_of_a_function_may_change_between_runs(self):
        class Target(BatchedEdge):
            target = 0.0

            def error(self, x):
                return x - self.target

        graph, edge = Graph(), Target()
        vertex = graph.add_vertex(np.zeros(2))
        graph.add_edges(edge, [graph.id(vertex)])
        optimizer = boxplus.Optimizer(graph)
        for target in (0.0, 1.0, 2.0):
            edge.target = target
            self.assertEqual(graph.chi2(), 2 * (1.0 if target > 0 else 0.0))
            np.testing.assert_allclose(graph.error(graph.all_edges()[0]), [-1, -1] if target > 0 else [0, 0])
            optimizer.run()
            np.testing.assert_allclose(graph.estimate(vertex), [target, target])

    def assert_exact_or_numeric(self, function, source):
        """The Jacobian is right, and comes from this source."""
        class Edge(BatchedEdge):
            error = staticmethod(function)

        graph = Graph()
        x = np.array([[0.3, 0.7, 1.1], [2.0, 0.1, 0.4]])
        graph.add_vertices(boxplus.Vector3, np.arange(2), x)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            edges = graph.add_edges(Edge(), np.arange(2))
            for k, edge in enumerate(edges):
                h = 1e-6
                numeric = np.stack([(function(x[k:k + 1] + d) - function(x[k:k + 1] - d))[0] / (2 * h)
                                    for d in h * np.eye(3)], axis=1)
                np.testing.assert_allclose(graph.jacobian(edge)[0], numeric, atol=1e-7)
            self.assertEqual(optimize(graph, algorithm="levenberg-marquardt").edge_functions[0].jacobians, source)

    def test_functions_with_in_place_operations_are_differentiated_exactly(self):
        def error(x):
            e = np.sin(x)
            e *= x[:, :1]
            e[:, 1] += x[:, 2]
            view = e[:, :2]
            view -= x[:, 1:]
            return e

        self.assert_exact_or_numeric(error, "exact")

    def test_functions_that_dual_numbers_cannot_follow_are_differentiated_numerically(self):
        def through_a_list(x):
            return np.array([[a * b, np.exp(c)] for a, b, c in x])

        def through_out(x):
            e = np.empty(x.shape)
            np.multiply(x, x, out=e)
            return e

        def through_a_reshaped_array(x):
            e = x * x
            e.ravel()[::3] *= 2
            return e

        def through_a_transposed_array(x):
            e = x * x
            t = e.T
            t[0] = 3 * x[:, 1]
            return e

        for function in (through_a_list, through_out, through_a_reshaped_array, through_a_transposed_array):
            with self.subTest(function.__name__):
                self.assert_exact_or_numeric(function, "numeric")

    def test_lists_as_errors_are_not_taken_for_constants(self):
        class Line(BatchedEdge):
            def error(self, x, data):
                return [a * t + b - y for (a, b), (t, y) in zip(x, data)]

        graph = Graph()
        vertex = graph.add_vertex(np.zeros(2))
        t = np.linspace(0, 1, 10)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            graph.add_edges(Line(), graph.id(vertex), measurements=np.c_[t, 2 * t + 1])
            self.assertLess(optimize(graph).chi2_final, 1e-12)
        np.testing.assert_allclose(graph.estimate(vertex), [2, 1], atol=1e-5)

    def test_a_function_may_return_the_same_array_each_time(self):
        buffer = np.empty(1)

        def error(p):
            buffer[:] = p[0]
            return buffer

        graph = Graph()
        graph.add_vertices(Vector2, np.arange(3), [[1, 0], [2, 0], [3, 0]])
        edges = [graph.add_edge(error, k) for k in range(3)]
        self.assertEqual([graph.error(edge)[0] for edge in edges], [1, 2, 3])
        self.assertEqual(graph.chi2(), 14)

    def test_derivatives_that_are_not_finite_become_numeric(self):
        class Length(BatchedEdge):
            def error(self, x):
                return np.linalg.norm(x, axis=1)

        graph = Graph()
        graph.add_vertices(Vector2, np.arange(2), [[0, 0], [3, 4]])
        first, second = graph.add_edges(Length(), np.arange(2))
        np.testing.assert_allclose(graph.jacobian(first)[0], [[0, 0]], atol=1e-6)
        np.testing.assert_allclose(graph.jacobian(second)[0], [[0.6, 0.8]], atol=1e-12)


class FunctionsOfOneEdge(unittest.TestCase):
    def test_any_callable_is_an_edge(self):
        graph = Graph()
        pose = graph.add_vertex(SE2(0, 0, 0))
        point = graph.add_vertex(np.array([1.0, 1.0]))
        graph.add_edge(lambda p: p.vector() - [1, 2, 0.5], pose, information=4)
        graph.add_edge(lambda p, q: p.inverse() * q - [1, 0], pose, point)
        report = optimize(graph)
        self.assertTrue(report.converged())
        self.assertLess(report.chi2_final, 1e-10)
        np.testing.assert_allclose(graph.estimate(point), SE2(1, 2, 0.5) * np.array([1.0, 0.0]), atol=1e-6)
        self.assertEqual([cost.jacobians for cost in report.edge_functions], ["numeric", "numeric"])

    def test_a_function_gets_its_measurement_after_its_estimates(self):
        graph = Graph()
        graph.add_vertices(Vector2, np.arange(3), np.zeros((3, 2)))
        graph.add_edges(lambda p, z: p - z, np.arange(3), measurements=[[1, 2], [3, 4], [5, 6]])
        self.assertLess(optimize(graph).chi2_final, 1e-12)
        np.testing.assert_allclose(graph.estimates(Vector2)[1], [[1, 2], [3, 4], [5, 6]], atol=1e-6)

    def test_steps_of_numeric_derivatives_fit_the_size_of_the_numbers(self):
        for size in (1.0, 5e6, 1e11):
            graph = Graph()
            vertex = graph.add_vertex(np.array([1.5 * size, 0.0]))
            edge = graph.add_edge(lambda p, size=size: (p[0] / size) ** 2 - 2, vertex)
            np.testing.assert_allclose(graph.jacobian(edge)[0] * size, [[3, 0]], rtol=1e-7, atol=1e-6)

    def test_a_jump_of_an_angle_is_not_taken_for_a_derivative(self):
        graph = Graph()
        vertex = graph.add_vertex(SE2(0, 0, np.pi))
        edge = graph.add_edge(lambda p: p.theta() - 3, vertex)
        np.testing.assert_allclose(graph.jacobian(edge)[0], [[0, 0, 1]], atol=1e-6)

    def test_a_number_is_an_error_of_one_row(self):
        graph = Graph()
        point = graph.add_vertex(np.array([1.0, 1.0]))
        edge = graph.add_edge(lambda p: p[0] - 3, point)
        graph.add_edge(lambda p: p[1] - 4, point)
        np.testing.assert_allclose(graph.error(edge), [-2])
        optimize(graph)
        np.testing.assert_allclose(graph.estimate(point), [3, 4], atol=1e-8)


class Mistakes(unittest.TestCase):
    def graph_with(self, function, **options):
        graph = Graph()
        graph.add_vertices(Vector2, np.arange(3), np.ones((3, 2)))

        class Edge(BatchedEdge):
            error = staticmethod(function)

        graph.add_edges(Edge(), np.arange(3), measurements=np.ones((3, 2)), **options)
        return graph

    def test_a_wrong_shape_is_a_value_error_that_names_the_function(self):
        with self.assertRaisesRegex(ValueError, r"Edge: expected errors of the shape \(1, rows\)"):
            self.graph_with(lambda x, z: np.zeros(7))
        graph = self.graph_with(lambda x, z: np.zeros((len(x), 2)) if len(x) == 1 else np.zeros((len(x), 3)))
        with self.assertRaisesRegex(ValueError, r"expected errors of the shape \(3, 2\), got \(3, 3\)"):
            optimize(graph)

    def test_an_exception_ends_the_run_and_comes_out(self):
        class Broken(Exception):
            pass

        def error(x, z):
            if len(x) > 1:
                raise Broken("no")
            return x - z

        graph = self.graph_with(error)
        for threads in (1, 2):
            with self.assertRaises(Broken):
                optimize(graph, threads=threads)
        with self.assertRaises(Broken):
            graph.chi2()
        self.assertEqual(graph.vertex_count(), 3)  # the graph is usable

    def test_nan_is_a_status(self):
        graph = self.graph_with(lambda x, z: x - z if len(x) == 1 else x * np.nan)
        self.assertFalse(optimize(graph).converged())

    def test_wrong_arguments_are_refused(self):
        graph = chain(PlanarBetween())
        graph.add_vertices(Vector2, [100], [[0, 0]])
        with self.assertRaises(TypeError):
            graph.add_edges(PlanarBetween(), [0, 100], [1, 2], measurements=np.zeros((2, 3)))
        with self.assertRaisesRegex(ValueError, "expected as many rows"):
            graph.add_edges(PlanarBetween(), [0, 1], [1], measurements=np.zeros((2, 3)))
        with self.assertRaises(TypeError):
            graph.add_edges(PlanarBetween(), measurements=np.zeros((2, 3)))
        with self.assertRaises(ValueError):
            graph.add_edges(PlanarBetween(), [0], [0], measurements=np.zeros((1, 3)))
        with self.assertRaises(NotImplementedError):
            graph.add_edges(BatchedEdge(), [0], [1], measurements=np.zeros((1, 3)))

    def test_a_function_cannot_change_its_arguments(self):
        def error(x, z):
            x -= z
            return x

        with self.assertRaisesRegex(ValueError, "read-only"):
            self.graph_with(error)

    def test_a_function_that_reads_its_graph_is_refused(self):
        graph = Graph()
        vertex = graph.add_vertex(np.zeros(2))
        graph.add_edge(lambda p: p - graph.chi2(), vertex)
        with self.assertRaises((ValueError, RuntimeError)):
            graph.chi2()

    def test_a_function_that_changes_its_graph_is_refused(self):
        graph = Graph()
        vertex = graph.add_vertex(np.zeros(2))
        is_armed = []
        graph.add_edge(lambda p: (graph.clear() if is_armed else None, p)[1], vertex)
        is_armed.append(True)
        for call in (graph.chi2, lambda: graph.jacobian(graph.all_edges()[0]), lambda: optimize(graph)):
            with self.assertRaises(ValueError):
                call()
        self.assertEqual(graph.vertex_count(), 1)

    def test_functions_and_graphs_are_released(self):
        edge = PlanarBetween()
        gone = weakref.ref(edge)
        graph = chain(edge)
        optimize(graph)
        del graph, edge
        gc.collect()
        self.assertIsNone(gone())

    def test_two_threads_of_python_may_optimize_two_graphs(self):
        graphs = [chain(PlanarBetween(), seed=seed) for seed in range(4)]
        threads = [threading.Thread(target=optimize, args=(graph,), kwargs={"threads": 2}) for graph in graphs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for seed, graph in enumerate(graphs):
            native = chain(Between, seed=seed)
            optimize(native)
            self.assertAlmostEqual(graph.chi2(), native.chi2(), delta=1e-8 * native.chi2())


if __name__ == "__main__":
    unittest.main()
