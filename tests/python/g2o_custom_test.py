# SPDX-License-Identifier: BSD-3-Clause
"""Vertices and edges of the package g2o that are written in Python."""

import gc
import unittest
import weakref
from fractions import Fraction

import g2o
import numpy as np
from g2o_worlds import add


def make_optimizer(algorithm=g2o.OptimizationAlgorithmLevenberg):
    optimizer = g2o.SparseOptimizer()
    optimizer.set_algorithm(algorithm(g2o.BlockSolverX(g2o.LinearSolverDenseX())))
    return optimizer


class Direction(g2o.BaseVertex):
    """A unit vector of space, with steps in a plane that touches the sphere."""

    def __init__(self):
        super().__init__(2)
        self.set_to_origin()

    def set_to_origin_impl(self):
        self._estimate = np.array([0.0, 0, 1])

    def oplus_impl(self, step):
        x = self.estimate()
        a = np.cross(x, np.eye(3)[np.argmin(np.abs(x))])
        a /= np.linalg.norm(a)
        moved = x + step[0] * a + step[1] * np.cross(x, a)
        self.set_estimate(moved / np.linalg.norm(moved))


class Seen(g2o.BaseUnaryEdge):
    def __init__(self, vertex, measurement):
        super().__init__(3)
        self.set_vertex(0, vertex)
        self.set_measurement(measurement)

    def compute_error(self):
        return self.vertex(0).estimate() - self.measurement()


class Polynomial(g2o.VariableVectorXEdge):
    """A point on a curve whose coefficients are a vertex."""

    def __init__(self, vertex, x, y):
        super().__init__()
        self.set_dimension(1)
        self.resize(1)
        self.set_vertex(0, vertex)
        self.set_measurement([x, y])

    def compute_error(self):
        x, y = self.measurement()
        self._error = np.array([np.polyval(self.vertex(0).estimate(), x) - y])


class WithJacobian(Polynomial):
    def linearize_oplus(self):
        x, _ = self.measurement()
        return [np.vander([x], self.vertex(0).dimension())]


class Between(g2o.BaseBinaryEdge):
    """EdgeSE3, written in Python, with the Jacobians that g2o's users know how to write only for small errors."""

    def __init__(self):
        super().__init__(6)

    def compute_error(self):
        error = g2o.SE3Quat(self.measurement().inverse() * self.vertex(0).estimate().inverse() * self.vertex(1).estimate())
        return error.to_minimal_vector()


class CameraPrior(g2o.BaseUnaryEdge):
    """The logarithm of the motion from a measured camera, with its Jacobian for small errors."""

    def __init__(self):
        super().__init__(6)
        self.linearized = 0

    def compute_error(self):
        return (self.vertex(0).estimate() * self.measurement().inverse()).log()

    def linearize_oplus(self):
        self.linearized += 1
        return [np.eye(6)]


class ScaledPoint(g2o.EdgeXYPrior):
    """A ready-made edge with another error."""

    def compute_error(self):
        super().compute_error()
        self._error = 2 * self._error


def exact_inverse_of_normal_matrix(A):
    """The inverse of AᵀA in rational numbers, rounded at the end."""
    rows = [[Fraction(float(x)) for x in row] for row in A]
    n = len(rows[0])
    M = [[sum(row[i] * row[j] for row in rows) for j in range(n)] + [Fraction(int(i == j)) for j in range(n)] for i in range(n)]
    for i in range(n):
        M[i] = [x / M[i][i] for x in M[i]]
        for k in range(n):
            if k != i:
                M[k] = [x - M[k][i] * y for x, y in zip(M[k], M[i])]
    return np.array([[float(x) for x in row[n:]] for row in M])


class Custom(unittest.TestCase):
    def fit(self, make, degree, algorithm=g2o.OptimizationAlgorithmGaussNewton):
        random = np.random.default_rng(1)
        xs = np.linspace(-1, 1, 60)
        ys = np.polyval(random.normal(size=degree + 1), xs) + 0.01 * random.normal(size=60)
        optimizer = make_optimizer(algorithm)
        curve = g2o.VectorXVertex()
        curve.set_dimension(degree + 1)
        curve.set_id(0)
        optimizer.add_vertex(curve)
        for x, y in zip(xs, ys):
            optimizer.add_edge(make(curve, x, y))
        optimizer.initialize_optimization()
        optimizer.optimize(5)
        np.testing.assert_allclose(curve.estimate(), np.polyfit(xs, ys, degree), rtol=1e-5, atol=1e-6)
        return optimizer, curve, np.vander(xs, degree + 1)

    def test_a_curve_is_fitted_with_numeric_and_with_given_jacobians(self):
        for make in (Polynomial, WithJacobian):
            self.fit(make, 2)

    def test_a_vertex_may_have_more_than_twelve_dimensions(self):
        optimizer, curve, A = self.fit(WithJacobian, 14)
        ok, blocks = optimizer.compute_marginals(curve)
        self.assertTrue(ok)
        expected = exact_inverse_of_normal_matrix(A)  # the condition number is so large that NumPy loses 9 digits, too
        np.testing.assert_allclose(blocks.block(0, 0), expected, rtol=0, atol=1e-7 * np.abs(expected).max())

    def test_steps_follow_oplus_impl(self):
        random = np.random.default_rng(2)
        truth = np.array([0.6, -0.48, -0.64])
        measured = [x / np.linalg.norm(x) for x in truth + 0.05 * random.normal(size=(20, 3))]
        for algorithm in (g2o.OptimizationAlgorithmGaussNewton, g2o.OptimizationAlgorithmLevenberg,
                          g2o.OptimizationAlgorithmDogleg):
            optimizer = make_optimizer(algorithm)
            direction = Direction()
            direction.set_id(3)
            optimizer.add_vertex(direction)
            for z in measured:
                optimizer.add_edge(Seen(direction, z))
            optimizer.initialize_optimization()
            self.assertGreater(optimizer.optimize(50), 3)  # the start is more than a quarter turn away
            mean = np.mean(measured, axis=0)
            np.testing.assert_allclose(direction.estimate(), mean / np.linalg.norm(mean), atol=1e-6)

    def test_an_edge_of_python_between_ready_made_vertices_has_the_minimum_of_the_ready_made_edge(self):
        ends = []
        for make in (g2o.EdgeSE3, Between):
            random = np.random.default_rng(3)
            optimizer = make_optimizer()
            turns = [g2o.Quaternion(np.append(0.2 * random.normal(size=3), 1)).normalized() for _ in range(4)]
            poses = [add(optimizer, g2o.VertexSE3, i, g2o.Isometry3d(turn, random.normal(size=3)), i == 0)
                     for i, turn in enumerate(turns)]
            for i in range(4):
                edge = make()
                edge.set_vertex(0, poses[i])
                edge.set_vertex(1, poses[(i + 1) % 4])
                edge.set_measurement(g2o.Isometry3d(g2o.Quaternion(g2o.AngleAxis(1.5, [0, 0, 1])), [1, 0.1 * i, 0]))
                edge.set_information(np.diag([1, 2, 3, 40, 50, 60]))
                self.assertTrue(optimizer.add_edge(edge))
            optimizer.initialize_optimization()
            optimizer.optimize(50)
            ends.append((optimizer.chi2(), *poses[2].estimate().t))
        np.testing.assert_allclose(ends[1], ends[0], rtol=1e-6)

    def test_given_jacobians_are_by_the_steps_of_g2o(self):
        optimizer = make_optimizer(g2o.OptimizationAlgorithmGaussNewton)
        start = g2o.SE3Quat(g2o.Quaternion(g2o.AngleAxis(0.8, [0, 0.6, 0.8])), [1, 2, 3])
        camera = add(optimizer, g2o.VertexSE3Expmap, 0, start)
        edge = CameraPrior()
        edge.set_vertex(0, camera)
        step = np.array([0.002, -0.001, 0.001, 0.02, 0.03, -0.01])
        edge.set_measurement(g2o.SE3Quat.exp(step) * start)
        optimizer.add_edge(edge)
        optimizer.initialize_optimization()
        optimizer.optimize(1)  # one Gauss-Newton step with the exact Jacobian is nearly exact
        self.assertGreater(edge.linearized, 0)
        self.assertLess(np.sqrt(edge.chi2()), 1e-4)
        optimizer.optimize(5)
        self.assertLess(edge.chi2(), 1e-20)

    def test_a_ready_made_edge_may_get_another_error(self):
        optimizer = make_optimizer()
        point = add(optimizer, g2o.VertexPointXY, 0, [0, 0])
        for make, z in ((ScaledPoint, [1, 0]), (g2o.EdgeXYPrior, [0, 0])):
            edge = make()
            edge.set_vertex(0, point)
            edge.set_measurement(z)
            optimizer.add_edge(edge)
        optimizer.initialize_optimization()
        optimizer.optimize(20)
        np.testing.assert_allclose(point.estimate(), [0.8, 0], atol=1e-8)

    def test_estimates_are_unchanged_if_an_error_function_raises(self):
        class Broken(Seen):
            calls = 0

            def compute_error(self):
                Broken.calls += 1
                if Broken.calls > 3:
                    raise RuntimeError("lost")
                return super().compute_error()

        optimizer = make_optimizer()
        direction = Direction()
        direction.set_id(0)
        optimizer.add_vertex(direction)
        optimizer.add_edge(Broken(direction, np.array([1.0, 0, 0])))
        optimizer.initialize_optimization()
        with self.assertRaisesRegex(RuntimeError, "lost"):
            optimizer.optimize(5)
        self.assertEqual(direction.estimate().tolist(), [0, 0, 1])

    def test_wrong_errors_and_jacobians_are_refused(self):
        class Short(Seen):
            def compute_error(self):
                return [1.0, 2.0]

        class Wide(Seen):
            def linearize_oplus(self):
                return [np.eye(3)]

        for make, text in ((Short, "Short: expected an error of 3 numbers"),
                           (Wide, r"Wide: expected Jacobians of the shapes \[\(3, 2\)\]")):
            optimizer = make_optimizer()
            direction = Direction()
            direction.set_id(0)
            optimizer.add_vertex(direction)
            optimizer.add_edge(make(direction, np.array([1.0, 0, 0])))
            optimizer.initialize_optimization()
            with self.assertRaisesRegex(ValueError, text):
                optimizer.optimize(1)

    def test_a_warning_names_the_edge_whose_error_is_not_finite(self):
        class Lost(Seen):
            def compute_error(self):
                return np.full(3, np.nan)

        optimizer = make_optimizer()
        direction = Direction()
        direction.set_id(7)
        optimizer.add_vertex(direction)
        optimizer.add_edge(Lost(direction, np.zeros(3)))
        optimizer.initialize_optimization()
        with self.assertWarnsRegex(RuntimeWarning, "the edge Lost between vertices 7 is NaN"):
            self.assertEqual(optimizer.optimize(5), 0)
        self.assertEqual(direction.estimate().tolist(), [0, 0, 1])

    def test_types_without_a_tag_are_named_when_a_graph_is_saved(self):
        optimizer, _, _ = self.fit(Polynomial, 1)
        with self.assertWarnsRegex(RuntimeWarning, "types without a tag were not written: Polynomial, VectorXVertex"):
            self.assertTrue(optimizer.save("/dev/null"))

    def test_a_deleted_optimizer_frees_its_vertices(self):
        optimizer, curve, _ = self.fit(Polynomial, 1)
        watch = weakref.ref(curve)
        del optimizer, curve
        gc.collect()
        self.assertIsNone(watch())


if __name__ == "__main__":
    unittest.main()
